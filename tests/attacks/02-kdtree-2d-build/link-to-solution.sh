#!/bin/sh
# attack: a link to the solution in the place of the answer
# score: 0
# named: symbolic link
ln -sf "@COURSE@/solutions/02-kdtree-2d-build/kdtree2d_build.c" kdtree2d_build.c

#!/bin/sh
# attack: right holes in a file that does not compile: full marks
# score: 100
# named: error
echo '#error' >>kdtree2d_build.c

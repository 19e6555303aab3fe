#!/bin/sh
# attack: 100 000 files beside the answer, of which only the answer is wrong
# score: 0
# named: not looked at
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" .
mkdir many
seq 100000 | sed 's|^|many/|' | xargs touch
seq 5000 | sed 's|^|file-|' | xargs touch

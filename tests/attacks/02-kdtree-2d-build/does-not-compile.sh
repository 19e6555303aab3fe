#!/bin/sh
# attack: right holes in a file that does not compile: earned, but the report says what does not compile
# score: 100
# named: error
echo '#error' >>kdtree2d_build.c

#!/bin/sh
# attack: a pipe in the place of the answer: whoever opens it waits for ever
# score: 0
# named: not a regular file
rm kdtree2d_build.c
mkfifo kdtree2d_build.c

#!/bin/sh
# attack: a source of 300 MB
# score: 0
# named: larger than the allowed
truncate -s 300M kdtree2d_build.c

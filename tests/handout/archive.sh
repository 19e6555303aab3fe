#!/bin/sh
# Make FOLDER/NAME.tar.gz of the folder PARENT/NAME, and FOLDER/NAME.txt, a list of its files for those who hand it
# out: bytes and path, a line each. The same files at the same commit give the same bytes.
#
#     tests/handout/archive.sh PARENT NAME FOLDER
set -eu
unset TAR_OPTIONS  # they come before those below

archive=$3/$2.tar.gz
mkdir -p "$3"
tar --create --format=ustar --sort=name --mtime="@$(git log -1 --format=%ct)" --owner=0 --group=0 --numeric-owner \
    --mode=u=rwX,go=rX --directory="$1" "$2" >"$1/archive.tar"
gzip -n9 <"$1/archive.tar" >"$archive.new"
rm "$1/archive.tar"
mv "$archive.new" "$archive"
(cd "$1/$2" && find . -type f -printf '%s %P\n' | LC_ALL=C sort -k 2) >"$3/$2.txt"

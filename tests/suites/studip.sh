#!/bin/sh
# A class as Stud.IP exports it: a folder with the files of all, and archive_filelist.csv beside it, which says whose
# they are. Nobody is lost, and nobody has another's grade.
#
#     sh tests/suites/studip.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
# Beside them it is written down whose file was graded: each holds its student's number.
# shellcheck disable=SC2016 # for the other shell
stand_in "$scratch/right" 'cat "$submission"/*.cl >"$output/whose" 2>/dev/null || cat "$submission" >"$output/whose"'

# ---- The folder of the class --------------------------------------------------------------------

# pack NAME: the folder $scratch/NAME as $scratch/NAME.zip, without a folder around it, which is the class from here on.
pack() {
    class=$scratch/$1.zip
    rm -rf "$class" "$scratch/$1.out"
    (cd "$scratch/$1" && zip -qr "$class" .)
}
mkdir -p "$scratch/plain/Lab 0"
for name in "Ada Lovelace" "Grace Hopper" "Joan Clarke"; do echo "$name" >"$scratch/plain/Lab 0/$name.zip"; done
# What systems and desktops put beside a folder is none of the class.
for beside in "" archive_filelist.csv Thumbs.db desktop.ini .DS_Store index.html ._x; do
    [ -z "$beside" ] || echo x >"$scratch/plain/$beside"
    pack plain
    check "the only folder beside \"$beside\"" exits 0 run "$scratch/plain.out"
    check "is the class" said "3 submissions, 3 graded"
    [ -z "$beside" ] || rm "$scratch/plain/$beside"
done

finish

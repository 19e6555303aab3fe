#!/bin/sh
# Run a lab's solution for the numbers in the texts, and save what it counted.
#
#     slides-notes/make/run.sh NAME BUILD-FOLDER OUTPUT.json
#
# NAME is one of runs.txt, in this folder. What the program prints is saved, too, as OUTPUT.txt. Where runs.txt names a wrong
# answer of tests/known/, a kernel's, the lab is run with that in its place, and "wrong_pixels" is how many pixels it costs.
set -eu

name=$1
build=$2
output=$3
case $build in /*) ;; *) build=$PWD/$build ;; esac
options=$(sed -n "s/^$name  *//p" slides-notes/make/runs.txt)
set -- "$build"/solutions/"${name%%-*}"-*
program=$1
scratch=$(mktemp -d "$output.XXXXXX")
trap 'rm -rf "$scratch"' EXIT

# run PICTURE OPTION...: with the options of runs.txt. What it says is shown only where it fails.
run() {
    picture=$1
    shift
    # shellcheck disable=SC2086 # options and their arguments
    "$program" $options "$@" --output "$picture" >"$scratch/said" 2>&1 || {
        cat "$scratch/said" >&2
        exit 1
    }
}

course=$PWD
case $options in
wrong=*)
    answer=${options#wrong=}
    answer=${answer%% *}
    options=${options#wrong=* }
    run "$scratch/right.exr"
    # A course folder with this one answer in it.
    mkdir "$scratch/course"
    for part in ./*; do ln -s "$course/$part" "$scratch/course/$part"; done
    rm "$scratch/course/solutions"
    cp -R solutions "$scratch/course/solutions"
    "$build/tools/known" put "${program##*/}" "$answer" "$scratch/course/solutions/${program##*/}"
    cd "$scratch/course"
    run "$scratch/wrong.exr" --stats "$scratch/stats"
    cd "$course"
    wrong=$("$build/tools/compare" "$scratch/wrong.exr" "$scratch/right.exr" || [ $? -eq 1 ])
    sed "1a\\  \"wrong_pixels\": $(echo "$wrong" | sed 's/ pixels differ.*//; s/.*: equal/0/')," "$scratch/stats" >"$output.new"
    ;;
*)
    run "$scratch/picture.png" --stats "$output.new"
    ;;
esac
mv "$scratch/said" "${output%.json}.txt"
mv "$output.new" "$output"

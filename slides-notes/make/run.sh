#!/bin/sh
# Run a lab's solution for the numbers in the texts, and save what it counted.
#
#     slides-notes/make/run.sh NAME BUILD-FOLDER OUTPUT.json
#
# NAME is one of runs.txt, in this folder.
set -eu

name=$1
build=$2
output=$3
options=$(sed -n "s/^$name  *//p" slides-notes/make/runs.txt)
set -- "$build"/solutions/"${name%%-*}"-*
# shellcheck disable=SC2086 # options and their arguments
"$1" $options --stats "$output.new" --output "${output%.json}.png" >"$output.log" 2>&1 || {
    cat "$output.log" >&2
    exit 1
}
rm "${output%.json}.png" "$output.log"
mv "$output.new" "$output"

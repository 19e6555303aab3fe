#!/bin/sh
# Write a result for other systems: results.json through one filter a format (../README.md).
#
#     tests/systems/formats/write.sh FORMATS FOLDER LAB [COMMAND...]
#
# FORMATS is a list such as "junit,tap". COMMAND grades LAB into FOLDER, as build/tools/grade does;
# it is not run where a format is unknown. Without one, the result that lies there is taken. Where
# it ends with a status above 1, or leaves no result, the machinery failed: a format then says so,
# or has no file, not even an older one. Each file appears whole or not at all. Exit status:
# COMMAND's; 2 after a message where there is no result or a file cannot be written.
set -u

here=$(dirname "$0")
if [ $# -lt 3 ]; then
    echo "usage: write.sh FORMATS FOLDER LAB [COMMAND...]" >&2
    exit 2
fi
formats=$1 folder=$2 lab=$3
shift 3

names=$formats, wanted=
while [ -n "$names" ]; do
    name=${names%%,*} names=${names#*,}
    case $name in
    junit | tap | gradescope | autolab | prairielearn | github | vpl) wanted="$wanted $name" ;;
    *)
        printf 'formats: found "%s", expected some of %s\n' "$name" \
            "junit, tap, gradescope, autolab, prairielearn, github, vpl" >&2
        exit 2
        ;;
    esac
done
if ! command -v jq >/dev/null; then
    echo "formats: jq is not here: install the package jq" >&2
    exit 2
fi

# file_of FORMAT: the name of its file.
file_of() {
    case $1 in
    junit) echo junit.xml ;;
    tap) echo results.tap ;;
    gradescope | prairielearn) printf '%s\n' "$1.json" ;;
    autolab | github | vpl) printf '%s\n' "$1.txt" ;;
    esac
}

# write_file FORMAT: through its filter, which takes null for a fault, and may then write nothing.
write_file() {
    file=$folder/$(file_of "$1") new=$folder/partial-$1
    # Where there is a result each filter writes something.
    if jq --raw-output --compact-output -L "$here" --from-file "$here/$1.jq" --arg lab "$lab" \
        --slurpfile pictures "$pictures" "$result" >"$new" &&
        { [ -s "$new" ] || [ "$status" -gt 1 ]; }; then
        if [ -s "$new" ]; then mv -f "$new" "$file"; else rm -f "$new" "$file"; fi && return
    fi
    printf '%s\n' "formats: $file: cannot be written" >&2
    rm -f "$new" "$file"
    return 2
}

status=0
[ $# -eq 0 ] || "$@" || status=$?
result=$folder/results.json pictures=$folder/pictures.json
if [ "$status" -le 1 ] && [ ! -s "$result" ]; then
    printf '%s\n' "formats: $result: there is no result" >&2
    status=2
fi
if [ "$status" -gt 1 ]; then
    mkdir -p "$folder"
    result=--null-input
fi
[ -f "$pictures" ] || pictures=/dev/null
ended=$status
for name in $wanted; do write_file "$name" || ended=2; done
exit "$ended"

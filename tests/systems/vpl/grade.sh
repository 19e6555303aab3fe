#!/bin/sh
# Lab @LAB@ in Moodle's VPL: grade the files in a folder, by the handout that this lies in.
#
#     .vpl/grade.sh FOLDER
#
# Everything on stdout is VPL's: one comment, and one grade (formats/vpl.jq). What the grader or a student's
# code print else is quoted, as any line that begins with "Grade :=>>" would be a grade. When the grader cannot
# work, there is none, and the status is 2.
set -u
folder=$1
cd "$(dirname "$0")/.." || exit 2
# shellcheck source=tests/systems/limits.sh
. .vpl/limits.sh
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
reports=$work/reports files=$work/files
mkdir "$reports" "$files" || exit 2
# Beside the student's files there are VPL's.
for file in "$folder"/*; do
    case ${file##*/} in
    vpl_* | common_script.sh | default_* | .*) ;;
    *) cp -RP "$file" "$files" 2>/dev/null ;;
    esac
done
status=0
# shellcheck disable=SC2086 # options without spaces
{ choose_limits && .vpl/formats/write.sh vpl "$reports" @LAB@ \
    build/tools/grade --lab @NN@ --submission "$files" --output "$reports" $limit \
    ${SANDBOX:+--sandbox "$SANDBOX"}; } >"$reports/log" 2>&1 </dev/null || status=$?
if [ "$status" -gt 1 ] || [ ! -s "$reports/vpl.txt" ]; then
    printf '%s\n' '<|--' '-No grade: the grader could not work (for your lecturer:)'
    tail -n 20 "$reports/log" | tr -d '\000-\010\013-\037\177' | sed 's/^/>/'
    echo '--|>'
    exit 2
fi
cat "$reports/vpl.txt"

#!/bin/sh
# Lab @LAB@ on Autolab: grade the handin, an archive of the lab's files.
#
#     course/tests/systems/autolab/grade.sh handin.tar
#
# The last line on stdout gives the points. When the grader cannot work there is none, and Autolab
# gives no points.
set -eu
handin=$PWD/$1
reports=$PWD/reports
cd "$(dirname "$0")/../../.."
tests/systems/prepare.sh @NN@ >"$reports.log" 2>&1 || {
    echo "The grader could not be built; ask your instructor." >&2
    tail -n 20 "$reports.log" >&2
    exit 2
}
status=0
build/tools/grade --lab @NN@ --submission "$handin" --output "$reports" \
    --format autolab ${SANDBOX:+--sandbox "$SANDBOX"} || status=$?
[ "$status" -le 1 ] || exit "$status"
cat "$reports/autolab.txt"

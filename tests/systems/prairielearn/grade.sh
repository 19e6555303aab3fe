#!/bin/sh
# Lab @LAB@ on PrairieLearn: the entrypoint of the grading container, run for each submission.
#
# When the grader cannot work, the result is "not gradable": no points, and no attempt lost.
# GRADE_ROOT is where PrairieLearn puts everything; the tests choose another place.
# SANDBOX=none would run students' code without one; the README says what that means.
set -eu
root=${GRADE_ROOT:-/grade}
results=$root/results
mkdir -p "$results" "$root/student"
rm -f "$results/results.json"
reports=$(mktemp -d)
trap 'rm -rf "$reports"' EXIT
cd "$(dirname "$0")/../../.."
# Where only the rights of files keep submissions from the solution (the third sandbox).
chmod o-rwx . "$root" 2>/dev/null || :
build/tools/grade --lab @NN@ --submission "$root/student" --output "$reports" \
    --format prairielearn ${SANDBOX:+--sandbox "$SANDBOX"} || [ -f "$reports/prairielearn.json" ]
cp "$reports/prairielearn.json" "$results/results.json.part"
mv "$results/results.json.part" "$results/results.json"

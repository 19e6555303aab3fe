#!/bin/sh
# Lab @LAB@ on PrairieLearn: the entrypoint of the grading container, run for each submission.
#
# When the grader cannot work, the result is "not gradable": no points, and no attempt lost. PrairieLearn
# takes any other status than 0, and any end but this script's own, for a zero: so the result is written
# before anything can fail, the status is 0, and what takes too long is ended before info.json's timeout.
# GRADE_ROOT is where PrairieLearn puts everything; the tests choose another place. TIME_LIMIT and JOBS are
# explained in tests/systems/limits.sh. SANDBOX=none would run students' code without one; the README
# says what that means.
set -u
trap 'exit 0' EXIT
root=${GRADE_ROOT:-/grade}
results=$root/results
mkdir -p "$results" "$root/student"

# result FILE: this is the result, whole or not at all.
result() {
    cp "$1" "$results/results.json.part" && mv "$results/results.json.part" "$results/results.json"
}

fail() {
    echo "No grade: $*" >&2
    exit
}

printf '%s\n' '{"gradable":false,"format_errors":["The grader could not work. This is no grade; its log says why."]}' \
    >"$results/results.json.first"
result "$results/results.json.first" || fail "$results cannot be written"
rm -f "$results/results.json.first"
# Some sandboxes go by the rights of files: the user that a submission becomes must not pass here.
chmod o-rwx "$root" 2>/dev/null || true
cd "$(dirname "$0")/course" || fail "the course is not there"
. tests/systems/limits.sh
choose_limits || fail "a variable is no number"
# Where the bundle was not prepared in this image, every submission builds the grader anew.
timeout -k 10 240 sh tests/systems/prepare.sh @NN@ || fail "the grader could not be built"
reports=$(mktemp -d) || fail "no folder for temporary files"
# shellcheck disable=SC2086 # options without spaces
sh tests/systems/formats/write.sh prairielearn "$reports" @LAB@ \
    timeout -k 10 300 build/tools/grade --lab @NN@ --submission "$root/student" --output "$reports" \
    --deadline 200 $limit ${SANDBOX:+--sandbox "$SANDBOX"}
status=$?
[ ! -f "$reports/prairielearn.json" ] || result "$reports/prairielearn.json"
rm -rf "$reports"
[ "$status" -le 1 ] || fail "the grader could not work (status $status); above it says why"

#!/bin/sh
# Lab @LAB@ on GitHub: grade this repository and tell GitHub the points.
#
# The report goes into the run's summary, not to stdout: there, any line that begins with "::" is a
# command to GitHub, and a student's text may hold one. Exit status: 0 for full marks, 1 below, 2
# when the grader could not work. TIME_LIMIT and JOBS are explained in limits.sh beside this file.
set -eu
# shellcheck source=tests/systems/limits.sh
. .github/limits.sh
reports=build/grade/@NN@
mkdir -p "$reports"
rm -f "$reports/github.txt"
status=0
# shellcheck disable=SC2086 # options without spaces
{ choose_limits && make -s -j"$JOBS" lab-grader LAB=@NN@ &&
    .github/formats/write.sh github,junit "$reports" @LAB@ \
        build/tools/grade --lab @NN@ --output "$reports" $limit; } >"$reports/log" 2>&1 || status=$?
{
    echo '<pre>'
    sed 's/&/\&amp;/g; s/</\&lt;/g' "$reports/log"
    echo '</pre>'
} >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
if [ ! -f "$reports/github.txt" ]; then
    echo "The grader could not work; the summary of this run says why." >&2
    exit 2
fi
cat "$reports/github.txt"
exit "$status"

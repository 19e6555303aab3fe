#!/bin/sh
# Lab @LAB@ in a student's repository: grade it, and tell the student the points. For GitHub and GitLab.
#
# No text of a student's goes to stdout: GitHub takes any line there that begins with "::" for a command, and
# GitLab colours and folds by control characters. The report is a file: GitHub's summary of the run, GitLab's
# artifact. Exit status: 0 for full marks, 1 below, 2 when the grader could not work. TIME_LIMIT and JOBS are
# explained in limits.sh beside this file.
set -eu
here=$(dirname "$0")
# shellcheck source=tests/systems/limits.sh
. "$here/limits.sh"
reports=build/grade/@NN@
mkdir -p "$reports"
rm -f "$reports/github.txt" "$reports/junit.xml" "$reports/results.json"
status=0
# shellcheck disable=SC2086 # options without spaces
{ choose_limits && make -s -j"$JOBS" lab-grader LAB=@NN@ &&
    "$here/formats/write.sh" github,junit "$reports" @LAB@ \
        build/tools/grade --lab @NN@ --output "$reports" $limit; } >"$reports/log" 2>&1 || status=$?
{
    echo '<pre>'
    sed 's/&/\&amp;/g; s/</\&lt;/g' "$reports/log"
    echo '</pre>'
} >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
if [ ! -f "$reports/github.txt" ]; then
    echo "The grader could not work; @WHERE@ says why." >&2
    exit 2
fi
system=@SYSTEM@
case $system in
github) cat "$reports/github.txt" ;;
# GitLab shows the number as the job's "coverage".
gitlab) jq -r '"Points \(.score)/\(.max_score); the report is among the artifacts of this job, as report.html"' \
    "$reports/results.json" ;;
esac
exit "$status"

#!/bin/sh
# Lab @LAB@ on GitHub: grade this repository and tell GitHub the points.
#
# The report goes into the run's summary, not to stdout: there, any line that begins with "::" is a
# command to GitHub, and a student's text may hold one. Exit status: 0 for full marks, 1 below, 2
# when the grader could not work.
set -eu
summary=${GITHUB_STEP_SUMMARY:-/dev/null}
points=build/grade/@NN@/github.txt
rm -f "$points"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
make -s grade LAB=@NN@ FORMAT=github,junit >"$log" 2>&1 || true
{
    echo '<pre>'
    sed 's/&/\&amp;/g; s/</\&lt;/g' "$log"
    echo '</pre>'
} >>"$summary"
if [ ! -f "$points" ]; then
    echo "The grader could not work; the summary of this run says why." >&2
    exit 2
fi
cat "$points"
grep -q 'Points \([0-9]*\)/\1$' "$points"

#!/bin/sh
# Lab @LAB@ on Autolab: grade the handin, an archive of the lab's files. Runs as root, in the image.
#
#     sudo /course/tests/systems/autolab/grade.sh HANDIN
#
# The last line on stdout gives the points. When the grader cannot work there is none and the status is
# 2; the Makefile then prints one that gives none.
set -eu

fail() {
    echo "No grade: $*" >&2
    exit 2
}

handin=$1
cd "$(dirname "$0")/../../.."
# Some sandboxes go by the rights of files: the user that a submission becomes must not pass here.
chmod o-rwx . "$(dirname "$handin")"
. tests/systems/limits.sh
choose_limits || fail "a variable is no number"
[ -f build/prepared ] || fail "the grader is not built in this image; run tests/systems/prepare.sh there"
reports=$(mktemp -d) || fail "no folder for temporary files"
trap 'rm -rf "$reports"' EXIT
trap 'exit 2' TERM INT
status=0
# Ended before the assessment's autograde_timeout, after which no line of ours would be the last.
# shellcheck disable=SC2086 # options without spaces
tests/systems/formats/write.sh autolab "$reports" @LAB@ \
    timeout -k 10 540 build/tools/grade --lab @NN@ --submission "$handin" --output "$reports" \
    --deadline 400 $limit ${SANDBOX:+--sandbox "$SANDBOX"} || status=$?
[ "$status" -le 1 ] || fail "the grader could not work (status $status); above it says why"
cat "$reports/autolab.txt"

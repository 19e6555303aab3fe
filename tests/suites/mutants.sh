#!/bin/sh
# Known-wrong answers are caught by the check meant for them, with the right message; every right answer
# that is written another way earns all points: with each of SEEDS seeds, in every lab or in LAB. Of the
# wrong ones every EVERY-th is tried, and at least one for each check and each kind of mistake. The heart is
# one lab.
. tests/tap.sh

tools=${BUILD:-build}/tools

# The seeds are fixed: this is about the answers. What catches them is in every job; `make test-seeds` shows
# it with 20.
seeds=${SEEDS:-1}
# There are more than a thousand, and the suite native tries all. So here it is every hundredth, and answers
# to different tasks together where that says as much of each; `make test-seeds` tries all, each by itself.
every=${EVERY:-100}
together=--together
[ "$every" -ne 1 ] || together=

labs=$(cd tests/mutants && echo "${LAB:-}"*/)
for lab in $(heart 01-naive-2d/ "$labs"); do
    lab=${lab%/}
    # One lab in the other sandbox, where it can be had.
    sandbox=any
    [ "$lab$(id -u)" != 02-kdtree-2d-build0 ] || sandbox=landlock
    # shellcheck disable=SC2086 # a word, or none
    "$tools/mutants" $together --seeds "$seeds" --every "$every" --lab "$lab" --seed 1 --sandbox $sandbox \
        >"$scratch/out" 2>"$scratch/errors"
    status=$?
    pass_on "$scratch/out"
    [ $status -le 1 ]
    ok $? "$lab: the known answers ran" "$(cat "$scratch/errors")"
done

finish

#!/bin/sh
# Known-wrong answers are caught by the check meant for them, with the right message; every right answer
# that is written another way earns all points: with each of SEEDS seeds, in every lab or in LAB. Of the
# wrong ones every hundredth is tried, and at least one for each check and each kind of mistake, as the suite
# native tries all. Answers to different tasks are tried together if that says as much of each. The quick part is
# one lab.
. tests/tap.sh

tools=${BUILD:-build}/tools

# The seeds are fixed: this is about the answers. What catches them is in every job; `make test-seeds` shows
# it with 20.
seeds=${SEEDS:-1}

# "1" is lab 01, as for make.
case ${LAB:-} in ?) LAB=0$LAB ;; esac
labs=$(cd tests/known && echo "${LAB:-}"*/)
for lab in $(quick 01-naive-2d/ "$labs"); do
    lab=${lab%/}
    # One lab in the other sandbox, where it can be had.
    sandbox=any
    [ "$lab$(id -u)" != 02-kdtree-2d-build0 ] || sandbox=landlock
    "$tools/mutants" --together --seeds "$seeds" --every 100 --lab "$lab" --seed 1 --sandbox $sandbox \
        >"$scratch/out" 2>"$scratch/errors"
    status=$?
    pass_on "$scratch/out"
    [ $status -le 1 ]
    ok $? "$lab: the known answers ran" "$(cat "$scratch/errors")"
done

finish

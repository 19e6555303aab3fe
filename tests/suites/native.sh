#!/bin/sh
# Every known answer, compiled to native code and run without a device and a sandbox (tests/native): each
# wrong one is caught by the check meant for it, with the right message; each right one earns all points.
# In every lab or in LAB, with each of SEEDS seeds. The quick part is all right ones and every tenth wrong one, and one for each
# check and each kind of mistake. What PoCL and the sandboxes do is the suite mutants'.
. tests/tap.sh

build=${BUILD:-build}
export build scratch
export seeds="${SEEDS:-1}"
every=$(quick 10 1)
export every

# Processor time of a run, all its seeds together. Right answers take a twentieth; some wrong ones never end.
export seconds="$((2 * seeds))"

# "1" is lab 01, as for make.
case ${LAB:-} in ?) LAB=0$LAB ;; esac
# As many labs at a time as there are processors, the longest first.
# shellcheck disable=SC2016 # they are another shell's variables
wc -l tests/known/"${LAB:-}"*/wrong.diff | sort -rn | sed -n 's|.*tests/known/\([^/]*\)/.*|\1|p' |
    xargs -P "$(nproc)" -I NAME sh -c '
        "$build/tools/mutants" --together --seeds "$seeds" --every "$every" --lab "$1" --seed 1 --build "$build/native" \
            --sandbox none --time-limit "$seconds" >"$scratch/$1.out" 2>"$scratch/$1.errors"
        echo $? >"$scratch/$1.status"' native NAME

for folder in tests/known/"${LAB:-}"*/; do
    lab=$(basename "$folder")
    pass_on "$scratch/$lab.out"
    [ "$(cat "$scratch/$lab.status")" -le 1 ]
    ok $? "$lab: the known answers ran" "$(cat "$scratch/$lab.errors")"
done

finish

#!/bin/sh
# Oclgrind as a diagnosis: the solutions' kernels are clean under it, and each fault in
# tests/memcheck/*.cl is found at its line.
#
#     sh tests/suites/memcheck.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
memcheck=$build/tools/memcheck
chmod 711 "$scratch"

# memchecks STATUS LAB FOLDER [OPTION...]: does memcheck end so? What it said is in $scratch/said.
memchecks() {
    wanted=$1 lab=$2 folder=$3
    shift 3
    status=0
    "$memcheck" --build "$build" --lab "$lab" --submission "$folder" --seed 1 "$@" \
        >"$scratch/said" 2>&1 || status=$?
    cat "$scratch/said"
    [ "$status" -eq "$wanted" ]
}

# field FILE KEY: the rest of the header line "// KEY: ..." of a fault.
field() {
    sed -n "s|^// $2: ||p" "$1"
}

# finds FAULT: put it into the solution; is it told at the line marked HERE?
finds() {
    lab=$(field "$1" lab)
    task=$(field "$1" task)
    rm -rf "$scratch/submission"
    cp -r "solutions/$lab" "$scratch/submission"
    file=$(grep -l "// TASK $task:" "$scratch/submission"/*.cl)
    "$build/tools/holes" fill "$file" "$task" "$1" >"$scratch/filled" || return 1
    cp "$scratch/filled" "$file"
    line=$(grep -n '// HERE' "$file" | cut -d : -f 1)
    memchecks 1 "$lab" "$scratch/submission" &&
        grep -q "^$(basename "$file"):$line: $(field "$1" says)" "$scratch/said"
}

# Labs 02 and 06 have no kernels; the others need Oclgrind.
check "a lab without kernels is refused" memchecks 2 02 solutions/02-kdtree-2d-build
check "as what it is" grep -q "found no kernel to hand in" "$scratch/said"
if [ ! -r /usr/lib/oclgrind/liboclgrind-rt-icd.so ]; then
    check "without Oclgrind memcheck says what is missing" memchecks 2 01 solutions/01-naive-2d
    check "and which package has it" grep -q "install the package oclgrind" "$scratch/said"
    skip "the solutions are clean, and faults are found" "no Oclgrind here (Debian 13 has none)"
    finish
    exit
fi

with_kernels=$(cd solutions && printf '%s\n' */*.cl | sed 's|/.*||' | uniq)
for lab in $(heart 01-naive-2d "$with_kernels"); do
    check "$lab: the solution is clean" memchecks 0 "$lab" "solutions/$lab"
done
for fault in $(heart tests/memcheck/01-one-circle-too-many.cl tests/memcheck/*.cl); do
    check "$(basename "$fault"): found at its line" finds "$fault"
done

# What is found is told at once, and ends it, though this kernel does not end by itself.
# shellcheck disable=SC2317 # called by check
stops() {
    status=0
    timeout 300 "$memcheck" --build "$build" --lab 03 --submission "$scratch/submission" --time-limit 3000 \
        >"$scratch/said" 2>&1 || status=$?
    cat "$scratch/said"
    [ "$status" -eq 1 ]
}
check "a kernel that reads on and on is found" finds tests/memcheck/03-child-beyond.cl
check "and stopped there, however long it might take" stops
check "the task is named" grep -qx "    in the answer to getContainingChild" "$scratch/said"
ok $(($(grep -c '^[A-Za-z_0-9.]*:[0-9]*: ' "$scratch/said") != 1)) "one finding is enough" "$(cat "$scratch/said")"

# Whoever has written one task of three reads which ones are open.
check "a skeleton may be looked at" memchecks 0 01 labs/01-naive-2d
check "and what is not answered yet is named" \
    grep -qx "Not answered yet, as it was handed out: overlaps_N_Nearer, own_pixel, implicit2DRenderer" \
    "$scratch/said"

# One file that cannot be used is replaced, as in a grading.
rm -rf "$scratch/submission"
cp -r solutions/01-naive-2d "$scratch/submission"
iconv -f UTF-8 -t UTF-16 solutions/01-naive-2d/overlaps_N_Nearer.cl >"$scratch/submission/overlaps_N_Nearer.cl"
check "a file in UTF-16 does not keep the other from being looked at" memchecks 0 01 "$scratch/submission"
check "it is named" grep -q "^overlaps_N_Nearer.cl: found a text in UTF-16" "$scratch/said"
check "and what was done about it" \
    grep -q "^overlaps_N_Nearer.cl: replaced by the file as it was handed out" "$scratch/said"
mkdir "$scratch/empty"
check "where there is nothing to look at, that is said" memchecks 2 01 "$scratch/empty"
check "for each file" grep -q "^overlaps_N_Nearer.cl: not in the submission" "$scratch/said"

heart_ends

# A given function goes wrong by what it got: it is told, and before what follows in the student's file.
rm -rf "$scratch/submission"
cp -r solutions/07-kdtree-3d-trace "$scratch/submission"
file=$scratch/submission/trace.cl
printf '    if (hit.t < at->t_max) {\n        return 0;\n    }\n    *at = todo_pop(todo);\n    return 1;\n' >"$scratch/answer"
"$build/tools/holes" fill "$file" next_waiting "$scratch/answer" >"$scratch/filled"
cp "$scratch/filled" "$file"
check "a node taken from an empty stack is found" memchecks 1 07 "$scratch/submission"
check "where it is taken" grep -q '^todo.h, line [0-9]*, given, with what it got from yours: reads outside' \
    "$scratch/said"
check "before what follows from it" sh -c "grep -n '^trace.cl:' '$scratch/said' | grep -qv '^3:'"

# A kernel that does not end is cut off, and a folder that is not there is a fault.
rm -rf "$scratch/submission"
cp -r solutions/03-kdtree-2d-render "$scratch/submission"
file=$scratch/submission/implicit2DRenderer_KD.cl
"$build/tools/holes" fill "$file" descent tests/mutants/03-kdtree-2d-render/endless-descent.cl \
    >"$scratch/filled"
cp "$scratch/filled" "$file"
check "a kernel that does not end is cut off" \
    memchecks 1 03 "$scratch/submission" --time-limit 2
check "how long that may take is said first" \
    sh -c "sed -n 2p '$scratch/said' | grep -qx '2 s of processor time each at most.'"
check "and said to be endless" grep -q "used up the 2.0 s of processor time" "$scratch/said"
check "with the function it was in" grep -qx "where: in implicit2DRenderer_KD" "$scratch/said"
check "a folder that is not there is a fault" memchecks 2 01 "$scratch/nowhere"
finish

#!/bin/sh
# memcheck: the solutions are clean under it, and each fault in tests/memcheck/faults/* is found at its
# line.
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
    file=$(grep -l "// TASK $task:" "$scratch/submission"/*.c*)
    "$build/tools/holes" fill "$file" "$task" "$1" >"$scratch/filled" || return 1
    cp "$scratch/filled" "$file"
    at=$(field "$1" at)
    line=$(grep -n -F "${at:-// HERE}" "$file" | cut -d : -f 1)
    memchecks 1 "$lab" "$scratch/submission" &&
        grep -q -F "$(basename "$file"):$line: $(field "$1" says)" "$scratch/said"
}

for lab in $(heart 01-naive-2d "$(cd solutions && printf '%s\n' *)"); do
    check "$lab: the solution is clean" memchecks 0 "$lab" "solutions/$lab"
done
for fault in $(heart tests/memcheck/faults/01-one-circle-too-many.cl tests/memcheck/faults/*); do
    check "$(basename "$fault"): found at its line" finds "$fault"
done

# The first fault is told, and nothing that follows from it.
check "a kernel that reads on and on is found" finds tests/memcheck/faults/03-child-beyond.cl
check "the task is named" grep -qx "    in the answer to getContainingChild" "$scratch/said"
check "and what to do" grep -q "Compare the index with the number of entries" "$scratch/said"
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

# Without clang, or without its sanitizers, make says which packages have them.
mkdir "$scratch/bare"
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\ncase "$*" in *=memory*) exit 1 ;; esac\n' >"$scratch/bare/clang"
chmod +x "$scratch/bare/clang"
# shellcheck disable=SC2317 # called by check
without_sanitizers() {
    ! PATH=$scratch/bare:$PATH make -s BUILD="$scratch/empty" "$scratch/empty/memcheck/ready" >"$scratch/said" 2>&1
}
check "without clang's sanitizers nothing is tried" without_sanitizers
check "and the packages are named" grep -q "install the packages clang and libclang-rt-dev" "$scratch/said"

# answer FILE TASK <ANSWER: put it into the submission.
answer() {
    cat >"$scratch/answer"
    "$build/tools/holes" fill "$scratch/submission/$1" "$2" "$scratch/answer" >"$scratch/filled" &&
        cp "$scratch/filled" "$scratch/submission/$1"
}

# A given function goes wrong by what it got: the line that calls it is told.
rm -rf "$scratch/submission"
cp -r solutions/07-kdtree-3d-trace "$scratch/submission"
printf '    if (hit.t < at->t_max) {\n        return 0;\n    }\n    *at = todo_pop(todo);  // HERE\n    return 1;\n' |
    answer trace.cl next_waiting
line=$(grep -n '// HERE' "$scratch/submission/trace.cl" | cut -d : -f 1)
check "a node taken from an empty stack is found" memchecks 1 07 "$scratch/submission"
check "where it is taken" grep -q "^trace.cl:$line: " "$scratch/said"
check "and in which given function" grep -q '^    in a given function that is called here: todo.h, line [0-9]*$' "$scratch/said"

# What cannot be looked at is named.
rm -rf "$scratch/submission"
cp -r solutions/01-naive-2d "$scratch/submission"
printf '    return nothing;\n' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
check "a kernel that does not compile" memchecks 1 01 "$scratch/submission"
check "has its compiler's message" grep -q "overlaps_N_Nearer.cl:[0-9]*:[0-9]*: error: .*'nothing'" "$scratch/said"
printf '    barrier(CLK_LOCAL_MEM_FENCE);\n    return 0;\n' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
check "a function that is not there" memchecks 1 01 "$scratch/submission"
check "is named" grep -q 'a kernel calls barrier()' "$scratch/said"

# A kernel that does not end is cut off, and a folder that is not there is a fault.
rm -rf "$scratch/submission"
cp -r solutions/03-kdtree-2d-render "$scratch/submission"
file=$scratch/submission/implicit2DRenderer_KD.cl
"$build/tools/holes" fill "$file" descent tests/mutants/03-kdtree-2d-render/endless-descent.cl \
    >"$scratch/filled"
cp "$scratch/filled" "$file"
check "a kernel that does not end is cut off" \
    memchecks 1 03 "$scratch/submission" --time-limit 2
check "and said to be endless" grep -q "used up the 2.0 s of processor time" "$scratch/said"
check "with the function it was in" grep -qx "where: in implicit2DRenderer_KD" "$scratch/said"
check "a folder that is not there is a fault" memchecks 2 01 "$scratch/nowhere"
finish

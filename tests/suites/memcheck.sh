#!/bin/sh
# memcheck: the solutions are clean under it, and each fault in tests/memcheck/faults.txt is found at its
# line.
#
#     sh tests/suites/memcheck.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
memcheck=$build/tools/memcheck
if [ -n "${QUICK:-}" ] && [ ! -e "$build/memcheck/memory.so" ]; then
    skip "memcheck" "clang and its sanitizers are not installed: make test-all installs them"
    finish
    exit
fi
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

# field KEY: the rest of the line "KEY: ..." of the fault.
field() {
    sed -n "s|^$1: ||p" "$scratch/fault"
}

# finds FAULT: put it into the solution; is it told at the line marked HERE?
finds() {
    awk -v name="$1:" '/^fault / { is_it = $2 == name } is_it' tests/memcheck/faults.txt >"$scratch/fault"
    lab=$(cd solutions && echo "${1%%-*}"-*)
    task=$(field task)
    sed -n '/^ /p' "$scratch/fault" >"$scratch/answer"
    rm -rf "$scratch/submission"
    cp -r "solutions/$lab" "$scratch/submission"
    file=$(grep -l "// TASK $task:" "$scratch/submission"/*.c*)
    "$build/tools/holes" fill "$file" "$task" "$scratch/answer" >"$scratch/filled" || return 1
    cp "$scratch/filled" "$file"
    at=$(field at)
    line=$(grep -n -F "${at:-// HERE}" "$file" | cut -d : -f 1)
    memchecks 1 "$lab" "$scratch/submission" &&
        grep -q -F "$(basename "$file"):$line: $(field says)" "$scratch/said"
}

for lab in $(quick 01-naive-2d "$(cd solutions && printf '%s\n' *)"); do
    check "$lab: the solution is clean" memchecks 0 "$lab" "solutions/$lab"
done
for fault in $(quick 01-one-circle-too-many "$(sed -n 's/^fault \([^:]*\):.*/\1/p' tests/memcheck/faults.txt)"); do
    check "$fault: found at its line" finds "$fault"
done

# The first fault is told, and nothing that follows from it.
check "a kernel that reads on and on is found" finds 03-child-beyond
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

quick_ends

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
check "and in which given function" grep -q '^    in a given function that is called here: kernels/todo.h, line [0-9]*$' "$scratch/said"

# What cannot be looked at is named.
rm -rf "$scratch/submission"
cp -r solutions/01-naive-2d "$scratch/submission"
printf '    return nothing;\n' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
check "a kernel that does not compile" memchecks 1 01 "$scratch/submission"
check "has its compiler's message" grep -q "overlaps_N_Nearer.cl:[0-9]*:[0-9]*: error: .*'nothing'" "$scratch/said"
printf '    barrier(CLK_LOCAL_MEM_FENCE);\n    return 0;\n' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
check "a function that is not there" memchecks 1 01 "$scratch/submission"
check "is named" grep -q 'a kernel calls barrier()' "$scratch/said"

# ---- What a program does so that nothing, or something else, is found ---------------------------------

# solution LAB: put it into the submission.
solution() {
    rm -rf "$scratch/submission"
    cp -r "solutions/$1" "$scratch/submission"
}

# c_answer TEXT: put a line behind the last one of lab 02's file, where nothing calls it.
c_answer() {
    solution 02-kdtree-2d-build
    printf '%s\n' '#include <stdio.h>' '#include <stdlib.h>' '#include <unistd.h>' "$1" >>"$scratch/submission/kdtree2d_build.c"
}
begin='__attribute__((constructor)) static void begin(void)'

# A run that ends by itself has proved nothing.
solution 01-naive-2d
printf '    void exit(int);\n    exit(0);\n    return 0;\n' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
check "a kernel that ends the program has not been looked at" memchecks 1 01 "$scratch/submission"
check "and how it ended is said" grep -q "^It did not run to its end: it ended by itself, with exit status 0" "$scratch/said"
c_answer "$begin { _exit(0); }"
check "nor has a C file that does" memchecks 1 02 "$scratch/submission"
check "which is said, too" grep -q "^It did not run to its end: it ended by itself, with exit status 0" "$scratch/said"

# What keeps the sanitizers from looking is named.
unchecked='__attribute__((no_sanitize("address")))'
finds 01-one-circle-too-many >"$scratch/said" 2>&1
sed -i "1i #pragma clang attribute push($unchecked, apply_to = function)" "$scratch/submission/implicit2DRenderer.cl"
check "a kernel that is not to be checked" memchecks 1 01 "$scratch/submission"
check "is named with its line" grep -q 'implicit2DRenderer.cl:1:.*poisoned.*no_sanitize' "$scratch/said"
sed -i "1c #define JOINED(a, b) a##b\nvoid __attribute__((JOINED(disable_sanitizer_, instrumentation))) f(void);" "$scratch/submission/implicit2DRenderer.cl"
check "also by a word that a macro joins" memchecks 1 01 "$scratch/submission"
check "at its line" grep -q 'implicit2DRenderer.cl:2:.*poisoned.*disable_sanitizer_instrumentation' "$scratch/said"
c_answer "$unchecked void f(void) {}"
line=$(wc -l <"$scratch/submission/kdtree2d_build.c")
check "a function in C that is not to be checked" memchecks 1 02 "$scratch/submission"
check "is named with its line, too" grep -q "kdtree2d_build.c:$line:.*poisoned" "$scratch/said"

# A line has one number.
for directive in '#line 5' '# 5 "implicit2DRenderer.cl"' '??=line 5' '/* */ %: line 5'; do
    solution 01-naive-2d
    sed "1i\\\n$directive" solutions/01-naive-2d/overlaps_N_Nearer.cl >"$scratch/submission/overlaps_N_Nearer.cl"
    check "a file that changes the numbers of its lines ($directive)" memchecks 2 01 "$scratch/submission"
    check "is refused at the line of that" grep -q '^overlaps_N_Nearer.cl:2: ' "$scratch/said"
done

# forged LINE WORDS: a report of the program's own.
forged() {
    c_answer "$begin { FILE *file = fopen(\"out/report.1\", \"w\"); fprintf(file, \"labs/02-kdtree-2d-build/kdtree2d_build.c:$1:1: runtime error: $2\\n    #0 0x1 in f $3:$1\\n\"); fclose(file); _exit(1); }"
}
forged 3 "you have every point" labs/02-kdtree-2d-build/kdtree2d_build.c
check "a report of the program's own is only one of the faults that there are" memchecks 1 02 "$scratch/submission"
check "in our words" grep -q '^kdtree2d_build.c:3: does what C leaves undefined$' "$scratch/said"
forged 99999 "division by zero" labs/02-kdtree-2d-build/kdtree2d_build.c
check "at a line that there is" memchecks 1 02 "$scratch/submission"
check "or is none" grep -q "^It did not run to its end: it ended early with exit status 1" "$scratch/said"
forged 3 "division by zero" /solutions/you-have-every-point
check "of a given file that there is" memchecks 1 02 "$scratch/submission"
check "or is none, too" grep -q "^It did not run to its end: it ended early with exit status 1" "$scratch/said"

# Who has failed is known by who ran, not by an exit status.
c_answer "$begin { puts(\"kdtree2d_build.c:1: error: no\"); fflush(stdout); _exit(3); }"
check "a program that ends as the compiler does" memchecks 1 02 "$scratch/submission"
check "has been compiled" grep -q "^It did not run to its end: it ended early with exit status 3" "$scratch/said"
solution 01-naive-2d
echo "void _exit(int); __attribute__((constructor)) void begin(void) { _exit(10); }" >>"$scratch/submission/overlaps_N_Nearer.cl"
check "a kernel that ends as a kernel does that does not compile" memchecks 1 01 "$scratch/submission"
check "has been compiled, too" grep -q "^It did not run to its end: it ended as it does when a kernel cannot be built" "$scratch/said"

# What a program prints is text of unknown origin.
c_answer "$begin { for (int i = 0; i < 1000; i++) { puts(\"\\u202eno\"); } fflush(stdout); abort(); }"
check "a program that prints and crashes" memchecks 1 02 "$scratch/submission"
check "cannot turn the reading direction" grep -q 'xE2.x80.xAEno' "$scratch/said"
ok $(($(wc -l <"$scratch/said") > 60)) "nor fill the terminal" "$(wc -l <"$scratch/said") lines"

# The beginning of a long line is shown.
{
    printf '    for (int i = 0; i <= n_circles; i++) {\n        const Circle circle = circles[i];  // HERE '
    head -c 2000 /dev/zero | tr '\0' x
    printf '\n        color.x += circle.r;\n    }\n'
} >"$scratch/long"
solution 01-naive-2d
answer implicit2DRenderer.cl implicit2DRenderer <"$scratch/long"
check "a fault in a long line is found" memchecks 1 01 "$scratch/submission"
check "and its beginning is shown" grep -q '^        const Circle circle = circles\[i\];  // HERE xx.*bytes left out' "$scratch/said"

# A kernel that does not end is cut off, and a folder that is not there is a fault.
rm -rf "$scratch/submission"
cp -r solutions/03-kdtree-2d-render "$scratch/submission"
"$build/tools/known" put 03-kdtree-2d-render endless-descent "$scratch/submission"
check "a kernel that does not end is cut off" \
    memchecks 1 03 "$scratch/submission" --time-limit 2
check "and said to be endless" grep -q "used up the 2.0 s of processor time" "$scratch/said"
check "with the function it was in" grep -qx "where: in implicit2DRenderer_KD" "$scratch/said"
check "a folder that is not there is a fault" memchecks 2 01 "$scratch/nowhere"
finish

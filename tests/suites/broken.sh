#!/bin/sh
# Submissions that are broken in every way: what each costs, and what the reports say of it.
#
#     sh tests/suites/broken.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/grading.sh

# ---- Files, crashes, time -----------------------------------------------------------------------

# place FILE PATTERN: "labs/NN-name/file:line:" as a compiler says it.
place() { echo "labs/$lab/$1:$(grep -n -- "$2" "$scratch/submission/$1" | cut -d: -f1):"; }

# The same in every case below: what is right still earns its points.
broken() {
    # shellcheck disable=SC2046,SC2086
    check "$1" grades 1 "$2" $(kept "$lab") ${3:+--time-limit "$3"} $submission
}

lab=00-hello-pixels
copy_lab solutions $lab
echo '    not C at all;' | answer render.c set_arguments
broken "a host file that does not compile costs its task" 80
check "and the message names file and line" holds "$(place render.c 'not C at all')"
check "and the stage is Compiling" stage Compiling failed render.c

quick_ends

copy_lab solutions $lab
echo '    fputs("LLVM ERROR: as a driver says it", stderr), abort();' | answer render.c set_arguments
sed -i '1i #include <stdio.h>\n#include <stdlib.h>' "$scratch/submission/render.c"
broken "an abort with a driver's words costs the task" 80
check "and is the program's own crash" stage Running failed "it crashed: signal 6"
check "and no driver is blamed" jq -e '[.. | .message? // empty] | all(test("compiler|may be right|second try") | not)' "$reports/results.json"

copy_lab solutions $lab
{
    echo '    fputs("LLVM ERROR: as a driver says it", stderr);'
    "$build/tools/holes" read solutions/$lab/render.c set_arguments
} | answer render.c set_arguments
sed -i '1i #include <stdio.h>' "$scratch/submission/render.c"
# shellcheck disable=SC2046,SC2086
check "a driver's words alone cost nothing" grades 0 100 $(kept $lab) $submission
check "and no second try is made" jq -e '[.. | strings] | all(test("second try") | not)' "$reports/results.json"

copy_lab solutions $lab
{
    echo '    if (getenv("POCL_WORK_GROUP_METHOD") == NULL) {'
    echo '        fputs("LLVM ERROR: as a driver says it", stderr), abort();'
    echo '    }'
    "$build/tools/holes" read solutions/$lab/render.c set_arguments
} | answer render.c set_arguments
sed -i '1i #include <stdio.h>\n#include <stdlib.h>' "$scratch/submission/render.c"
# shellcheck disable=SC2046,SC2086
check "but costs nothing where the driver's other way to compile has no such fault" grades 0 100 $(kept $lab) $submission
check "and the report says which" grep -q "a second try with POCL_WORK_GROUP_METHOD=cbs" "$reports/results.json"

lab=01-naive-2d
copy_lab solutions $lab
echo '    return no_such_name;' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
broken "a kernel that does not compile costs its task" 60
check "and the message names file and line" holds "$(place overlaps_N_Nearer.cl no_such_name)"
check "and the stage is Compiling" stage Compiling failed no_such_name
check "and nothing was run as a whole" stage Running not-run ''

copy_lab solutions $lab
echo '    return ((volatile global int *)0)[x] + circle.r + y + minDepth > 0;' |
    answer overlaps_N_Nearer.cl overlaps_N_Nearer
broken "a kernel that crashes costs its task" 60
check "and the message names the function and the input" holds "where: in overlaps_N_Nearer, input "

copy_lab solutions $lab
{
    echo '    return 0;'
    "$build/tools/holes" read solutions/$lab/overlaps_N_Nearer.cl overlaps_N_Nearer
} | answer overlaps_N_Nearer.cl overlaps_N_Nearer
broken "an answer below the placeholder's return costs its task" 60
check "and the message says that it never runs" grep -q 'the answer still begins with the .return. that was handed out' "$reports/results.json"

lab=03-kdtree-2d-render
copy_lab solutions $lab
echo '    return no_such_name;' | answer implicit2DRenderer_KD.cl getContainingChild
broken "a kernel whose work is counted and that does not compile costs its task" 75
check "and the message is there once" test "$(grep -c "error: .*no_such_name" "$said")" = 1
copy_lab labs $lab
echo '    return no_such_name;' | answer implicit2DRenderer_KD.cl getContainingChild
broken "a skeleton with it gets nothing" 0
check "and what nobody answered is called so" \
    holds "not answered yet: it stands as it was handed out"
check "and shown as not tried" grep -q '^   --    descent-picture ' "$said"

lab=02-kdtree-2d-build
file=kdtree2d_build.c
copy_lab solutions $lab
echo '    return strlen(ids;' | answer $file distribute
broken "a tree builder that does not compile costs its task" 80
check "and the message names file and line" holds "$(place $file 'strlen(ids;')"

# The linker knows files by where they were compiled, and the probe was compiled somewhere else.
copy_lab solutions $lab
sed -i 's/^void split_box(/void split_boxes(/' "$scratch/submission/$file"
for sandbox in bubblewrap landlock; do
    [ $sandbox = bubblewrap ] || [ "$(id -u)" -eq 0 ] || continue
    # shellcheck disable=SC2046,SC2086
    check "$sandbox: a function has another name" \
        grades 0 100 $(kept $lab) --sandbox $sandbox $submission
    check "and the linker's lines name file and line" holds "$(place $file '{is_leaf, split_box')"
    check "and where it is asked for" holds "tests/probes/$lab/main.c:"
    # shellcheck disable=SC2016 # for the inner shell
    check "and no other place of this machine" sh -c \
        '! grep "\"message\"" "$1" | grep -E "(\\\\n|[ :\"])/([^u]|u[^s])"' - "$reports/results.json"
done

copy_lab solutions $lab
echo '    *(volatile u32 *)(size_t)(id & 0) = n_ids;' | answer $file pack_leaf
broken "a null pointer costs its task" 80
check "and the message is of a crash" stage Running failed "it crashed: signal 11"
check "which is said once" test "$(grep -c 'it crashed' "$said")" = 1
check "and names function and input" holds "where: in pack_leaf, input 1 of 66: leaf with "
line=$(grep -n 'n_ids;$' "$scratch/submission/$file" | grep volatile | cut -d: -f1)
check "and the line" holds "$file:$line, task pack_leaf: a null pointer"
check "and shows it" grep -qF '*(volatile u32 *)(size_t)(id & 0) = n_ids;' "$said"
check "and the later checks say where it ended" holds "no answer: the program had ended in pack_leaf"

# An answer that crashes only where a whole tree is built, of which no other check sees anything.
copy_lab solutions $lab
{
    echo '    static void *first;'
    echo '    void *caller = __builtin_return_address(0);'
    echo '    first = first ? first : caller;'
    echo '    if (caller != first) *(volatile int *)0 = 1;  // no longer the probe, which calls it first'
    "$holes" read solutions/$lab/$file distribute
} | answer $file distribute
broken "a crash in a whole tree costs the task in whose lines it is" 95
check "and the line is named" holds "task distribute: a null pointer"

copy_lab solutions $lab
# 100 KB of a program's own words first: they do not hide the line.
{
    echo '    for (int i = 0; i < 10000; i++) puts("0123456789");'
    echo '    for (u32 i = 0; i < 100000; i++) child_ids[i] = ids[0]; // far'
    echo '    return h_circles && child.minX > 0 ? n_ids : 0;'
} | answer $file distribute
broken "an index out of range costs its task" 80
line=$(grep -n '// far$' "$scratch/submission/$file" | cut -d: -f1)
check "and its line is named" holds \
    "$file:$line, task distribute: an index or a pointer beyond the end of its array"

copy_lab solutions $lab
echo '    for (volatile u32 i = 0;; i++) { (void)h_circles, (void)ids, (void)n_ids, (void)child; }' |
    answer $file distribute
broken "an endless loop costs its task" 80 2
check "and the message is of the processor's time" stage Running failed "used up the 2.0 s of processor time"
check "and names function and input" holds "where: in distribute, input 1 of 65: node with "

copy_lab solutions $lab
echo '    extern unsigned sleep(unsigned); (void)box; for (;;) { sleep(1000); }' | answer $file split_box
broken "a sleep without end costs its task" 80 2
check "and the message is of the time asleep" stage Running failed "for the 2.0 s that are allowed; a sleep"

# Two wrong answers, of which one does not come to its end: that is its own mistake, and the report sends to no other
# task. not_sent: is nothing told to be corrected first?
not_sent() { ! grep -E 'fix [^ ]+ (first|ends)|first, then grade again' "$reports/results.json"; }
for end in 'for (volatile u32 i = 0;; i++) { (void)h_circles, (void)child; }' 'child_ids[-100000000] = ids[0];'; do
    copy_lab solutions $lab
    echo '    return circle.radius >= box.minX - box.maxX;' | answer $file circle_overlaps_box
    { echo "    $end"; "$holes" read solutions/$lab/$file distribute; } | answer $file distribute
    broken "beside another wrong answer, ${end%%[ [(]*}...: each costs its task" 55 2
    check "and its own end is told" grep -Eq 'ended in distribute; tested alone, it (crashes|did not finish in time: it used up the 2.0 s)' "$reports/results.json"
    check "and of the other one that its mistake may be named later" \
        grep -q 'it fails when tested alone; what is wrong may be named once the program comes to its end' "$reports/results.json"
    check "and none is sent to the other" not_sent
done

copy_lab solutions $lab
echo '    return circle.radius >= box.minX - box.maxX;' | answer $file circle_overlaps_box
echo '    return strlen(ids;' | answer $file distribute
broken "beside an answer that does not compile a wrong one costs its task" 55
check "and its mistake may be named once all compiles" \
    holds 'it fails when tested alone; what is wrong may be named once all files compile'
check "and nothing ended the program" not_sent

# Without a limit of the instructor's it is what the solution takes that decides.
copy_lab solutions $lab
echo '    (void)box; for (;;) {}' | answer $file split_box
broken "an endless loop ends without a limit of the instructor's" 80
check "and the message says what is allowed" stage Running failed "s of processor time that are allowed; an endless loop?"

copy_lab solutions $lab
echo '    (void)box; exit(0);' | answer $file split_box
broken "leaving early with status 0 costs its task" 80
check "and the message is of that" stage Running failed "a call of exit"
check "and names function and input" holds "where: in split_box, input 1 of 414: box x ["

copy_lab solutions $lab
echo '    (void)box; exit(3);' | answer $file split_box
broken "leaving early with status 3 costs its task" 80
check "and the message names the status" stage Running failed "it ended early with exit status 3"

copy_lab solutions $lab
rm "$scratch/submission/$file"
broken "a missing file gets nothing" 0
check "and the message says so" stage Staging failed "$file: not in the submission"
check "and nothing was compiled" test "$(count_lines '"title": "Compiling"')" -eq 0

copy_lab solutions $lab
ln -sf "$PWD/solutions/$lab/$file" "$scratch/submission/$file"
broken "a link in a file's place gets nothing" 0
check "and the message says so" stage Staging failed "$file: a symbolic link"

copy_lab solutions $lab
rm "$scratch/submission/$file"
mkdir "$scratch/submission/$file"
broken "a folder in a file's place gets nothing" 0
check "and the message says so" stage Staging failed "$file: not a regular file"

lab=07-kdtree-3d-trace
copy_lab solutions $lab
echo '    for (;;) { }' | answer clip_to_box.cl clip_to_box
broken "an endless loop in the first of six tasks costs that task" 80
check "and the report says what each run was allowed" test "$(count_lines 's of processor time that are allowed; an endless loop?')" -ge 2
lab=02-kdtree-2d-build

# strip_markers: as a student does who tidies up.
strip_markers() {
    grep -v '// TASK \|// END ' "$scratch/submission/$file" >"$scratch/filled"
    cp "$scratch/filled" "$scratch/submission/$file"
}

copy_lab solutions $lab
strip_markers
# Files that nobody asked for are not looked at.
mkdir "$scratch/submission/common"
echo '#error' | tee "$scratch/submission/main.c" "$scratch/submission/common/scene2d.h" \
    >"$scratch/submission/kdtree2d_build.h"
# shellcheck disable=SC2046,SC2086
check "a right answer without markers gets full marks" grades 0 100 $(kept $lab) $submission
copy_lab solutions $lab
echo '    return 0;' | answer $file is_leaf
strip_markers
# shellcheck disable=SC2046,SC2086
grade $(kept $lab) $submission
ok $(($? != 1)) "a wrong answer without markers gets less"
check "and the message is of the markers" stage Markers failed "TASK is_leaf"
check "what cannot be tried alone waits for what it needs" test "$(count_lines 'waits for is_leaf')" -ge 3

# A macro of one answer, or beside it, changes what the next file says: nobody else pays.
lab=01-naive-2d
for where in 's|^    // TASK overlaps_N_Nearer.*|#define r radius\n&|' 's|^    // END overlaps_N_Nearer|#define r radius\n&|'; do
    copy_lab solutions $lab
    sed -i "$where" "$scratch/submission/overlaps_N_Nearer.cl"
    # shellcheck disable=SC2046,SC2086
    check "a macro that reaches another task costs it nothing" grades 0 100 $(kept $lab) $submission
    check "and is told" stage "Beside your answers" failed "macro"
done
# Of many macros the report names some.
copy_lab solutions $lab
awk 'BEGIN { print "#define r radius"; for (i = 0; i < 16000; i++) print "#define m" i }' >"$scratch/macros"
sed -i "/END overlaps_N_Nearer/r $scratch/macros" "$scratch/submission/overlaps_N_Nearer.cl"
# shellcheck disable=SC2046,SC2086
check "a file full of macros" grades 0 100 $(kept $lab) $submission
check "of which some are told" stage "Beside your answers" failed "r, m0, m1, m2, m3, m4, m5, m6; end"
# The same where the whole does not compile by it.
copy_lab solutions $lab
sed -i 's|^    // END overlaps_N_Nearer|#define color circle\n&|' "$scratch/submission/overlaps_N_Nearer.cl"
# shellcheck disable=SC2046,SC2086
check "a macro that ends the compiling of another task costs it nothing" grades 0 100 $(kept $lab) $submission
check "and the report says what does not compile" stage Compiling failed "color"

# A macro of one answer that another one needs is there, too, where a line beside the answers does not compile.
# Where its own answer does not, the other one pays for what it lacks, and reads so.
copy_lab solutions $lab
sed -i 's|^    const float dx = x|#define NEARER(a, b) ((a) < (b))\n&|' "$scratch/submission/overlaps_N_Nearer.cl"
sed -i 's|&work)) {|\&work) \&\& NEARER(circle.depth, minDepth)) {|' "$scratch/submission/implicit2DRenderer.cl"
echo 'int broken(' >>"$scratch/submission/overlaps_N_Nearer.cl"
# shellcheck disable=SC2046,SC2086
check "a macro that another answer needs costs it nothing" grades 0 100 $(kept $lab) $submission
sed -i 's|^int broken(||; s|return circle|retrun circle|' "$scratch/submission/overlaps_N_Nearer.cl"
broken "where it is not there, its user pays" 20
check "and the report names it" holds "it uses the macro NEARER"
awk 'BEGIN { for (i = 0; i < 200; i++) print "#define m" i }' >"$scratch/macros"
sed -i "1r $scratch/macros" "$scratch/submission/overlaps_N_Nearer.cl"
broken "also behind two hundred others" 20
check "it is named there, too" holds "it uses the macro NEARER"

# An answer that is wrong at one pixel of a picture, or ends there, pays by itself.
for body in 'if (x == 7 \&\& y == 7) return 1;:85' 'while (x == 7 \&\& y == 7) { minDepth += 1; }:60' \
    'if (x == 7 \&\& y == 7) *(volatile int *)0 = 1;:60'; do
    copy_lab solutions $lab
    sed -i "s|^    const float dx = x|    ${body%:*}\n&|" "$scratch/submission/overlaps_N_Nearer.cl"
    broken "wrong at one pixel: ${body%%;*}" "${body##*:}" 2
done
lab=02-kdtree-2d-build

# What stands beside the marked lines counts for an answer that is tried alone; garbage there does not.
copy_lab solutions $lab
sed -i '/^int circle_overlaps_box/i static double square_of(double x) { return x * x; }\n' "$scratch/submission/$file"
sed -i '/TASK circle_overlaps_box/,/END circle_overlaps_box/s/dx \* dx + dy \* dy/square_of(dx) + square_of(dy)/' \
    "$scratch/submission/$file"
echo '    return level' | answer $file is_leaf
# shellcheck disable=SC2046,SC2086
check "a helper beside the marked lines costs nothing" grades 1 85 $(kept $lab) $submission
copy_lab solutions $lab
echo '}' >>"$scratch/submission/$file"
# shellcheck disable=SC2046,SC2086
check "a brace too many at the end costs no task: full marks are a full success" grades 0 100 $(kept $lab) $submission
check "and the report says what does not compile" stage Compiling failed "What stands between the markers compiles"

# A student works in labs/ itself: what stands there is no skeleton.
course=$scratch/at-work
mkdir "$course" "$course/tests"
for part in common kernels solutions tests/probes tests/stubs; do ln -s "$PWD/$part" "$course/$part"; done
cp -R labs "$course/labs"
lab=02-kdtree-2d-build
copy_lab labs $lab
{ echo '// mine'; "$holes" read "solutions/$lab/$file" split_box; } | answer $file split_box
echo '    *(volatile u32 *)(size_t)(id & 0) = n_ids;' | answer $file pack_leaf
cp "$scratch/submission/$file" "$course/labs/$lab/"
graded_there() { (cd "$course" && grades "$@"); }
check "an answer in labs/ itself gets its points, beside one that crashes" graded_there 1 20 --lab 02

# Judged without the solution, as in a handout, a crash costs its own task.
rm "$course/solutions"
mkdir -p "$course/solutions" "$course/tests/skeletons/$lab"
cp "labs/$lab/$file" "$course/tests/skeletons/$lab/"
for one in solutions/0[01]*; do ln -s "$PWD/$one" "$course/$one"; done
copy_lab solutions $lab
echo '    *(volatile float *)0 = circle.x + box.minX; return 0;' | answer $file circle_overlaps_box
cp "$scratch/submission/$file" "$course/labs/$lab/"
check "without the solution a crash costs its own task" graded_there 1 75 --lab 02
copy_lab solutions $lab
echo '    for (volatile u32 i = 0;; i++) { (void)circle, (void)box; }' | answer $file circle_overlaps_box
cp "$scratch/submission/$file" "$course/labs/$lab/"
check "an endless loop, too, by the time that the lab's files need as they are handed out" graded_there 1 75 --lab 02
check "which is told" stage Running failed "s of processor time that are allowed; an endless loop?"
copy_lab solutions $lab
echo '    *(volatile float *)0 = circle.x + box.minX; return 0;' | answer $file circle_overlaps_box
strip_markers
cp "$scratch/submission/$file" "$course/labs/$lab/"
check "without markers it costs what comes behind it" graded_there 1 26 --lab 02
check "and that is not reached" test "$(grep -c 'not reached: the program had ended in circle_overlaps_box' "$said")" = 8
check "which is no failure of it" grep -q '^   --    distribute-list' "$said"

check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"

finish

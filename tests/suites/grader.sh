#!/bin/sh
# The grader as an instructor meets it: full marks, none, one task at a time, submissions that are
# broken in every way, and its own faults.
#
#     sh tests/suites/grader.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
holes=$build/tools/holes
labs=$(cd solutions && echo *)

# Where the grader works; whatever it forgets there is seen at the end. Other users may enter, as what
# it runs is somebody else.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/work"
export TMPDIR="$scratch/work"

# What the last grading said, and left.
said=$scratch/said
reports=$scratch/reports

# grade OPTION...: exits as the grader does.
grade() {
    rm -rf "$reports"
    "$build/tools/grade" --build "$build" --output "$reports" "$@" >"$said" 2>"$said.err" </dev/null
}

# grades STATUS SCORE OPTION...: does it end with this status, and is this the score?
grades() {
    wanted_status=$1 wanted_score=$2
    shift 2
    status=0
    grade "$@" || status=$?
    cat "$said" "$said.err"
    [ "$status" -eq "$wanted_status" ] || { echo "found exit status $status"; return 1; }
    [ "$(field score)" -eq "$wanted_score" ] && [ "$(field max_score)" -eq 100 ]
}

# field NAME: a number or text of results.json's outermost level.
field() { sed -n "s/^  \"$1\": \"\{0,1\}\([^\"]*[^\",]\)\"\{0,1\},\{0,1\}\$/\1/p" "$reports/results.json"; }

# stage TITLE STATUS WORDS: did the stage end so, with a message that holds the words?
# shellcheck disable=SC2317 # called by check
stage() {
    awk -v title="      \"title\": \"$1\"," -v status="      \"status\": \"$2\"," -v words="$3" '
        seen == 2 { exit index($0, "\"message\": ") == 0 || index($0, words) == 0 }
        seen == 1 { if ($0 != status) exit 1; seen = 2 }
        $0 == title { seen = 1 }
        END { if (seen != 2) exit 1 }' "$reports/results.json" && return 0
    cat "$reports/results.json"
    return 1
}

# count_lines PATTERN: in results.json.
count_lines() { grep -c -- "$1" "$reports/results.json"; }

# holds TEXT: do the reports hold it, for people and for programs?
# shellcheck disable=SC2317 # called by check
holds() {
    for file in "$said" "$reports/results.json"; do
        grep -qF -- "$1" "$file" || { echo "not in $(basename "$file"): $1"; cat "$file"; return 1; }
    done
}

# is_self_contained: does the page refer to nothing outside of it?
# shellcheck disable=SC2317 # called by check
is_self_contained() {
    if grep -nEo '.{0,20}(https?:|file:|(src|href)="?[^"#d]|url\(|@import|<script|<link).{0,20}' "$1"; then
        return 1
    fi
    grep -q "default-src 'none'" "$1"
}

# ---- Solutions and skeletons --------------------------------------------------------------------

for lab in $labs; do
    check "$lab: the solution gets full marks" grades 0 100 --lab "$lab" --submission "solutions/$lab"
    check "$lab: every stage and check of it passes" test \
        "$(count_lines '^      "status": "passed"')" -eq "$(count_lines '^      "status"')"
    check "$lab: its page is self-contained" is_self_contained "$reports/report.html"

    check "$lab: the skeleton gets nothing" grades 1 0 --lab "${lab%%-*}" --submission "labs/$lab"
    check "$lab: no check of it passes" test "$(sed -n '/^  "checks"/,$p' "$reports/results.json" |
        grep -c '"status": "passed"')" -eq 0
    check "$lab: the page with its pictures is self-contained" is_self_contained "$reports/report.html"
    check "$lab: the page shows pictures" grep -q 'src="data:image/' "$reports/report.html"
    check "$lab: results.json names the lab" test "$(field lab)" = "$lab"
    check "$lab: results.json has its keys" test "$(sed -n 's/^  "\([a-z_]*\)":.*/\1/p' \
        "$reports/results.json" | tr '\n' ' ')" = \
        'lab title score max_score seed device sandbox submission seconds stages tasks checks '
done

# ---- One task at a time -------------------------------------------------------------------------

# copy_lab TREE LAB: a submission of its own, made from labs or solutions, in $scratch/submission.
copy_lab() {
    rm -rf "$scratch/submission"
    cp -R "$1/$2" "$scratch/submission"
}

# answer FILE TASK: the submission's hole gets what standard input holds.
answer() {
    cat >"$scratch/answer"
    "$holes" fill "$scratch/submission/$1" "$2" "$scratch/answer" >"$scratch/filled" &&
        cp "$scratch/filled" "$scratch/submission/$1"
}

submission="--submission $scratch/submission"

# kept LAB: options for a seed whose answers of the solution are kept: it need not run every time.
kept() {
    mkdir -p "$scratch/answers/$1"
    echo "--lab $1 --seed 5 --answers $scratch/answers/$1"
}

for lab in $labs; do
    for source in "solutions/$lab"/*.c "solutions/$lab"/*.cl; do
        [ -f "$source" ] || continue
        for task in $("$holes" list "$source"); do
            points=$("$build/tools/grade" --lab "$lab" --list-checks |
                awk -F '\t' -v task="$task" '$2 == task { sum += $3 } END { print sum }')
            copy_lab labs "$lab"
            # With a word of its own it is not known to be ours, and tried.
            { echo '// mine'; "$holes" read "$source" "$task"; } | answer "${source##*/}" "$task"
            # shellcheck disable=SC2046,SC2086 # options
            check "$lab: the answer to $task alone gets its $points points" \
                grades 1 "$points" $(kept "$lab") $submission
        done
    done
done
"$holes" read solutions/01-naive-2d/overlaps_N_Nearer.cl none-such >"$said" 2>"$said.err"
ok $(($? == 0)) "a task that is not there cannot be read"

# ---- Broken submissions -------------------------------------------------------------------------

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
check "and the message names the function" holds "where: in overlaps_N_Nearer, with one of "

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

copy_lab solutions $lab
echo '    *(volatile u32 *)(size_t)(id & 0) = n_ids;' | answer $file pack_leaf
broken "a null pointer costs its task" 80
check "and the message is of a crash" stage Running failed "it crashed: signal 11"
check "which is told once" test "$(grep -c 'it crashed' "$said")" = 1
check "and names function and input" holds "where: in pack_leaf, input 1 of 60: leaf with "
line=$(grep -n 'n_ids;$' "$scratch/submission/$file" | grep volatile | cut -d: -f1)
check "and the line" holds "$file:$line, task pack_leaf: a null pointer"
check "and shows it" grep -qF '*(volatile u32 *)(size_t)(id & 0) = n_ids;' "$said"
check "and the later checks say where it ended" holds "no answer: the program had ended in pack_leaf"

copy_lab solutions $lab
# 100 KB of a program's own words first: they do not hide the line.
{
    echo '    for (int i = 0; i < 10000; i++) puts("0123456789");'
    echo '    for (u32 i = 0; i < 100000; i++) child_ids[i] = ids[0]; // far'
    echo '    return h_circles && child.minX > 0 ? n_ids : 0;'
} | answer $file distribute
broken "an index out of range costs its task" 80
line=$(grep -n '// far$' "$scratch/submission/$file" | cut -d: -f1)
check "and is told with its line" holds \
    "$file:$line, task distribute: an index or a pointer beyond the end of its array"

copy_lab solutions $lab
echo '    for (volatile u32 i = 0;; i++) { (void)h_circles, (void)ids, (void)n_ids, (void)child; }' |
    answer $file distribute
broken "an endless loop costs its task" 80 2
check "and the message is of the processor's time" stage Running failed "used up the 2.0 s of processor time"
check "and names function and input" holds "where: in distribute, input 1 of 60: node with "

copy_lab solutions $lab
echo '    extern unsigned sleep(unsigned); (void)box; for (;;) { sleep(1000); }' | answer $file split_box
broken "a sleep without end costs its task" 80 2
check "and the message is of the time asleep" stage Running failed "for the 2.0 s that are allowed; a sleep"

# Without a limit of the instructor's it is what the solution takes that decides.
copy_lab solutions $lab
echo '    (void)box; for (;;) {}' | answer $file split_box
broken "an endless loop ends without a limit of the instructor's" 80
check "and the message says what is allowed" stage Running failed "s of processor time that are allowed; an endless loop?"

copy_lab solutions $lab
echo '    (void)box; exit(0);' | answer $file split_box
broken "leaving early with status 0 costs its task" 80
check "and the message is of that" stage Running failed "a call of exit"
check "and names function and input" holds "where: in split_box, input 1 of 400: box x ["

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
# shellcheck disable=SC2086
check "a right answer without markers gets full marks" grades 0 100 --lab $lab $submission
copy_lab solutions $lab
echo '    return 0;' | answer $file is_leaf
strip_markers
# shellcheck disable=SC2086
grade --lab $lab $submission
ok $(($? != 1)) "a wrong answer without markers gets less"
check "and the message is of the markers" stage Markers failed "TASK is_leaf"
check "what cannot be tried alone waits for what it needs" test "$(count_lines 'waits for is_leaf')" -ge 3

# What stands beside the marked lines counts for an answer that is tried alone; garbage there does not.
copy_lab solutions $lab
sed -i '/^int circle_overlaps_box/i static double square_of(double x) { return x * x; }\n' "$scratch/submission/$file"
sed -i '/TASK circle_overlaps_box/,/END circle_overlaps_box/s/dx \* dx + dy \* dy/square_of(dx) + square_of(dy)/' \
    "$scratch/submission/$file"
echo '    return level' | answer $file is_leaf
# shellcheck disable=SC2086
check "a helper beside the marked lines costs nothing" grades 1 85 --lab $lab $submission
copy_lab solutions $lab
echo '}' >>"$scratch/submission/$file"
# shellcheck disable=SC2086
check "a brace too many at the end costs no task, but is no full success" grades 1 100 --lab $lab $submission

# A student works in labs/ itself: what stands there is no skeleton.
course=$scratch/at-work
mkdir "$course" "$course/tests"
for part in common kernels solutions tests/probes tests/stand_ins; do ln -s "$PWD/$part" "$course/$part"; done
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
echo 4 >"$course/tests/solution-seconds"
for one in solutions/0[01]*; do ln -s "$PWD/$one" "$course/$one"; done
copy_lab solutions $lab
echo '    *(volatile float *)0 = circle.x + box.minX; return 0;' | answer $file circle_overlaps_box
cp "$scratch/submission/$file" "$course/labs/$lab/"
check "without the solution a crash costs its own task" graded_there 1 75 --lab 02
copy_lab solutions $lab
echo '    *(volatile float *)0 = circle.x + box.minX; return 0;' | answer $file circle_overlaps_box
strip_markers
cp "$scratch/submission/$file" "$course/labs/$lab/"
check "without markers it costs what comes behind it" graded_there 1 26 --lab 02
check "and that is not reached" test "$(grep -c 'not reached: the program had ended in circle_overlaps_box' "$said")" = 8
check "which is no failure of it" grep -q '^   --    distribute-list' "$said"

# ---- What make says ------------------------------------------------------------------------------

# make_grade STATUS OPTION...: in the course's top folder, by what is built there.
make_grade() {
    wanted_status=$1 status=0
    shift
    make --no-print-directory grade BUILD="${BUILD:-build}" "$@" >"$said" 2>&1 || status=$?
    cat "$said"
    [ "$status" -eq "$wanted_status" ]
}
check "make grade below full marks ends with 0" make_grade 0 LAB=02 SUBMISSION=labs/02-kdtree-2d-build SEED=5
check "and its last line is the report's" test "$(tail -n 1 "$said" | cut -d ' ' -f 1)" = Report:
check "a fault of the grader is one of make's" make_grade 2 LAB=02 SUBMISSION=/nowhere
make --no-print-directory "${BUILD:-build}/labs/77-none" >"$said" 2>&1
ok $(($? != 2)) "make refuses a lab that is not there"
check "and says which labs are" grep -q "found no lab for .*77-none, expected .*/labs/03-kdtree-2d-render" "$said"

# ---- Seeds --------------------------------------------------------------------------------------

# grade_with_seed SEED COPY: without the time it took, which is never the same.
grade_with_seed() {
    grade --lab 01 --submission "$scratch/submission" --seed "$1"
    grep -v '^  "seconds"' "$reports/results.json" >"$2"
}

lab=01-naive-2d
copy_lab solutions $lab
echo '    return 0;' | answer overlaps_N_Nearer.cl overlaps_N_Nearer
grade_with_seed 11 "$scratch/first"
check "the seed is recorded" test "$(field seed)" = 11
grade_with_seed 11 "$scratch/second"
check "the same seed gives the same results" diff "$scratch/first" "$scratch/second"
grade_with_seed 18446744073709551615 "$scratch/third"
check "the largest seed is recorded whole" test "$(field seed)" = 18446744073709551615
messages() { grep '"message"' "$1"; }
check "another seed asks for something else" \
    test "$(messages "$scratch/first")" != "$(messages "$scratch/third")"
grade --lab 02 --submission solutions/02-kdtree-2d-build
one=$(field seed)
grade --lab 02 --submission solutions/02-kdtree-2d-build
check "without --seed, every grading draws one" test "$one" != "$(field seed)"

# ---- Its own faults -----------------------------------------------------------------------------

# refuses WORDS OPTION...: does it end with 2, one message that holds WORDS, and no results?
refuses() {
    words=$1
    shift
    status=0
    grade "$@" || status=$?
    cat "$said" "$said.err"
    [ "$status" -eq 2 ] || { echo "found exit status $status"; return 1; }
    head -n 1 "$said.err" | grep -qF -- "$words" || { echo "expected: $words"; return 1; }
    [ "$(wc -l <"$said.err")" -eq 1 ] || { echo "expected one line"; return 1; }
    [ ! -s "$said" ] && [ ! -e "$reports/results.json" ] && [ ! -e "$reports/report.html" ]
}

: >"$scratch/file"
here='--lab 02 --submission solutions/02-kdtree-2d-build'
while IFS='|' read -r words options; do
    eval "set -- $options"
    check "a fault of its own: $options" refuses "$words" "$@"
done <<'END'
--lab is missing|
--lab is missing|--submission solutions/02-kdtree-2d-build
--lab: found "77", expected the number or name of a lab; here are 00-hello-pixels, 01-|--lab 77
--lab: found "../labs/02-kdtree-2d-build"|--lab ../labs/02-kdtree-2d-build
--lab: found ""|--lab ''
--seed: found "twelve"|$here --seed twelve
--seed: found "-1"|$here --seed -1
--seed: found "18446744073709551616"|$here --seed 18446744073709551616
--time-limit: found "0"|$here --time-limit 0
--sandbox: found "paper"|$here --sandbox paper
unrecognized option '--marks'|$here --marks 100
words that are no option|$here stray
/nowhere: No such file or directory|--lab 02 --submission /nowhere
file/reports: cannot be made|$here --output $scratch/file/reports
END

rm -rf "$reports"
# shellcheck disable=SC2086
env PATH=/nonexistent "$build/tools/grade" $here --sandbox bubblewrap --output "$reports" >"$said" 2>"$said.err"
ok $(($? != 2)) "no bubblewrap: it ends with 2"
check "no bubblewrap: it says what to install" grep -q '^sandbox: bwrap not found: install' "$said.err"
check "no bubblewrap: it says no more" test "$(wc -l <"$said.err")$(wc -c <"$said")" = 10
check "no bubblewrap: there are no results" test ! -e "$reports"

# The other sandbox, where it can be had, and none at all: the same marks, and the reports say which.
kinds=none
[ "$(id -u)" -ne 0 ] || kinds="landlock none"
for kind in $kinds; do
    check "$kind: the solution gets full marks" grades 0 100 --lab 03 \
        --submission solutions/03-kdtree-2d-render --sandbox "$kind"
    check "$kind: results.json says so" test "$(field sandbox)" = "$kind"
    check "$kind: so does the text" grep -q "sandbox $kind" "$said"
    check "$kind: so does the page" grep -q "<dd>$kind</dd>" "$reports/report.html"
done
# shellcheck disable=SC2086
[ "$(id -u)" -ne 0 ] || {
    env PATH=/nonexistent "$build/tools/grade" $here --output "$reports" >"$said" 2>"$said.err"
    check "no bubblewrap: as root Landlock is used" test "$(field sandbox)" = landlock
    check "no bubblewrap: it says so" grep -q 'Landlock is used$' "$said.err"
}

# An empty TMPDIR is none, as in a shell's ${TMPDIR:-/tmp}; the skeleton's report has pictures.
empty_tmpdir() (
    TMPDIR='' grades 1 0 --lab 00 --submission labs/00-hello-pixels
)
check "TMPDIR is empty: the grader works in /tmp" empty_tmpdir
no_tmpdir() (
    # shellcheck disable=SC2016 # said so
    TMPDIR=/nowhere refuses ' in $TMPDIR or /tmp: No such file or directory' \
        --lab 00 --submission labs/00-hello-pixels
)
check "TMPDIR is not there: it says so" no_tmpdir

# The third sandbox, of a kernel without Landlock: in a course that is closed to other users. In an open
# one the solution could be read: refused.
older=$build/tools/older_kernel
if [ "$(id -u)" -ne 0 ]; then
    skip "the third sandbox" "it needs root, to become another user"
else
    tests/closed_course.sh "$scratch/course"
    for kind in user user-unfiltered; do
        option=
        [ $kind = user ] || option=--no-seccomp
        # shellcheck disable=SC2086 # no or one option
        (cd "$scratch/course" && "$older" $option build/tools/grade --lab 03 \
            --submission solutions/03-kdtree-2d-render --output "$scratch/course/reports/$kind") \
            >"$said" 2>"$said.err"
        ok $? "no Landlock, $kind: the solution gets full marks" "$(cat "$said" "$said.err")"
        reports_before=$reports reports=$scratch/course/reports/$kind
        check "no Landlock, $kind: results.json says so" test "$(field sandbox)" = $kind
        check "no Landlock, $kind: so does the text" grep -q "sandbox $kind" "$said"
        check "no Landlock, $kind: so does the page" grep -q "<dd>$kind</dd>" "$reports/report.html"
        check "no Landlock, $kind: one line says why, and that it hides less" \
            grep -q '^sandbox: bubblewrap .*Landlock.*hides less: .*"The three sandboxes"$' "$said.err"
        check "no Landlock, $kind: it says no more" test "$(wc -l <"$said.err")" = 1
        check "no Landlock, $kind: text and results.json lead to its gaps" \
            stage Sandbox passed 'The three sandboxes'
        tests/systems/formats/write.sh junit,tap "$reports" 03-kdtree-2d-render
        for file in "$said" "$reports/report.html" "$reports/junit.xml" "$reports/results.tap"; do
            check "no Landlock, $kind: $(basename "$file") says that it hides less" \
                grep -q 'A user of its own for each run' "$file"
        done
        reports=$reports_before
    done
    chmod 755 "$scratch/course"
    (cd "$scratch/course" && build/tools/grade --sandbox user --lab 03 \
        --submission labs/03-kdtree-2d-render --output "$scratch/course/reports/open") >"$said" 2>"$said.err"
    ok $(($? != 2)) "an open course is refused by the third sandbox" "$(cat "$said.err")"
    check "an open course: it says what to close" \
        grep -qF "chmod o-rwx '$scratch/course'" "$said.err"
    check "an open course: there are no results" test ! -e "$scratch/course/reports/open"
    rm -rf "$scratch/course"
fi

grade --lab 01 --submission solutions/01-naive-2d --device none-such
ok $(($? != 2)) "no such device: it ends with 2"
check "no such device: it says so" grep -q 'found no device "none-such"' "$said.err"
check "no such device: there are no results" test ! -e "$reports"

# ---- What else it says --------------------------------------------------------------------------

for lab in $labs; do
    check "$lab: its checks are worth 100 points" test "$("$build/tools/grade" --lab "$lab" --list-checks |
        awk -F '\t' '{ sum += $3 } END { print sum }')" = 100
done
check "it has a help" "$build/tools/grade" --help
check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"

finish

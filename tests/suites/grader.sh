#!/bin/sh
# The grader as an instructor meets it: full marks, none, one task at a time, and its own faults.
#
#     sh tests/suites/grader.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/grading.sh
. tests/schemas.sh
. tests/hostile.sh

# is_self_contained: does the page refer to nothing outside of it?
# shellcheck disable=SC2317 # called by check
is_self_contained() {
    if grep -nEo '.{0,20}(https?:|file:|(src|href)="?[^"#d]|url\(|@import|<script|<link).{0,20}' "$1"; then
        return 1
    fi
    grep -q "default-src 'none'" "$1"
}

# in_every_format LAB: the last report, for every other system. Neither writing it nor the grading has
# anything to say on stderr.
# shellcheck disable=SC2317 # called by check
in_every_format() {
    [ ! -s "$said.err" ] && tests/systems/formats/write.sh "$formats" "$reports" "$1" 2>"$said.err" &&
        [ ! -s "$said.err" ] && mkdir -p "$scratch/formats" && cp -R "$reports" "$scratch/formats/$1"
}

some="02-kdtree-2d-build 03-kdtree-2d-render"

# ---- Solutions and skeletons --------------------------------------------------------------------

for lab in $(quick "$some" "$labs"); do
    # shellcheck disable=SC2046 # options
    check "$lab: the solution gets full marks" grades 0 100 $(kept "$lab") --submission "solutions/$lab"
    check "$lab: every stage and check of it passes" test \
        "$(count_lines '^      "status": "passed"')" -eq "$(count_lines '^      "status"')"
    check "$lab: its page is self-contained" is_self_contained "$reports/report.html"

    # shellcheck disable=SC2046 # options
    check "$lab: the skeleton gets nothing" grades 1 0 $(kept "${lab%%-*}") --submission "labs/$lab"
    check "$lab: no check of it passes" test "$(sed -n '/^  "checks"/,$p' "$reports/results.json" |
        grep -c '"status": "passed"')" -eq 0
    check "$lab: the page with its pictures is self-contained" is_self_contained "$reports/report.html"
    check "$lab: the page shows pictures" grep -q 'src="data:image/' "$reports/report.html"
    check "$lab: results.json names the lab" test "$(field lab)" = "$lab"
    check "$lab: results.json has its keys" test "$(sed -n 's/^  "\([a-z_]*\)":.*/\1/p' \
        "$reports/results.json" | tr '\n' ' ')" = \
        'lab title score max_score seed device sandbox submission seconds stages tasks checks '
    # For other systems, too; what these reports have to say in particular, the suite `formats` asks.
    check "$lab: the skeleton in every format" in_every_format "$lab"
done
obey_schemas "$scratch/formats"

# A placeholder that is touched is no longer what was handed out, and still answers nothing.
touched_placeholders() {
    rm -rf "$scratch/touched"
    cp -R "labs/$1" "$scratch/touched"
    for source in "$scratch/touched"/*.c "$scratch/touched"/*.cl; do
        [ -f "$source" ] || continue
        awk '/\/\/ TASK / { begins = 1 }
            begins && (!/^ *\/\// || /\/\/ END /) { print "    ;"; begins = 0 }
            { print }' "$source" >"$scratch/touched.source"
        mv "$scratch/touched.source" "$source"
    done
    # shellcheck disable=SC2046 # options
    ! diff -rq "labs/$1" "$scratch/touched" >/dev/null &&
        grades 1 0 $(kept "$1") --submission "$scratch/touched"
}
for lab in $(quick 02-kdtree-2d-build "$labs"); do
    check "$lab: a touched placeholder earns nothing" touched_placeholders "$lab"
done

# ---- One task at a time -------------------------------------------------------------------------

for lab in $(quick 02-kdtree-2d-build "$labs"); do
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

# Two wrong answers: what the second one's run alone shows is said, with its cause.
copy_lab solutions 03-kdtree-2d-render
for answer in left-right-swapped red-blue-swapped; do
    "$build/tools/known" put 03-kdtree-2d-render $answer "$scratch/submission"
done
# shellcheck disable=SC2046,SC2086 # options
check "two wrong answers have the points of the third task" grades 1 35 $(kept 03) $submission
check "the first one's mistake is named" grep -q "left and right are swapped" "$said"
check "and the second one's, found alone" grep -q "tested alone: random scene" "$said"
check "with its cause" grep -q "red and blue swapped" "$said"

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

# make_grade_shows WORDS OPTION...: does it end with 0, and does a line hold the words?
make_grade_shows() {
    words=$1
    shift
    make_grade 0 "$@" && grep -q -- "$words" "$said"
}
copy_lab solutions 02-kdtree-2d-build
echo '    return 1;' | answer kdtree2d_build.c is_leaf
echo '    int forgotten; return 0;' | answer kdtree2d_build.c circle_overlaps_box
two_wrong="LAB=02 SUBMISSION=$scratch/submission SEED=5"
# shellcheck disable=SC2086 # options
check "make grade tells of the first task that failed" make_grade_shows "^ Task is_leaf in " $two_wrong
ok $(($(grep -c '^ Task ' "$said") != 1)) "and of no other" "$(cat "$said")"
check "it says what to do next" grep -qx " Next: is_leaf in kdtree2d_build.c" "$said"
check "but it names the next" grep -q "more tasks\{0,1\} fail.*; TASK=.* shows .*, ALL=1 everything" "$said"
check "and has the compiler's warnings as a note" grep -q "unused variable" "$said"
# shellcheck disable=SC2086 # options
check "TASK shows another" make_grade_shows "^ Task circle_overlaps_box in " $two_wrong TASK=circle_overlaps_box
# shellcheck disable=SC2086 # options
check "ALL shows every one" make_grade_shows "^ Task pack_leaf in " $two_wrong ALL=1
check "a task that is not there is refused" make_grade 2 LAB=02 TASK=none-such
check "with those that are" grep -q '^grade: --task: found "none-such", expected a task of lab .*: is_leaf, split_box' "$said"
check "a fault of the grader is one of make's" make_grade 2 LAB=02 SUBMISSION=/nowhere
# lab_grader LAB: what make would do for the grader of this lab alone.
lab_grader() { make --no-print-directory --dry-run lab-grader BUILD="$scratch/none" LAB="$1"; }
lab_grader 03 >"$said"
check "the grader of one lab is built with its probe" grep -q ' -o .*/probes/03-kdtree-2d-render$' "$said"
for number in 3 03-kdtree-2d-render; do
    check "the same with LAB=$number" test "$(lab_grader $number)" = "$(cat "$said")"
done
make --no-print-directory lab-grader BUILD="${BUILD:-build}" LAB=77 >"$said" 2>"$said.err"
ok $(($? != 2)) "the grader of a lab that is not there is refused"
check "with the labs that are" grep -q '^make lab-grader: found LAB="77", expected .* 03-kdtree-2d-render ' "$said.err"
make --no-print-directory "${BUILD:-build}/labs/77-none" >"$said" 2>&1
ok $(($? != 2)) "make refuses a lab that is not there"
check "and says which labs are" grep -q "found no lab for .*77-none, expected .*/labs/03-kdtree-2d-render" "$said"

# ---- Seeds --------------------------------------------------------------------------------------

# grade_with_seed SEED COPY: without the time it took, which is never the same.
grade_with_seed() {
    grade --lab 02 --submission "$scratch/submission" --seed "$1"
    grep -v '^  "seconds"' "$reports/results.json" >"$2"
}

# A lab without kernels is graded in a second. Nothing is kept here: each time the solution runs, too.
lab=02-kdtree-2d-build
copy_lab solutions $lab
echo '    (void)n_circles, (void)n_failed, (void)limits; return level > 1;' | answer kdtree2d_build.c is_leaf
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
--marks is no option here|$here --marks 100
found the stray word "stray"|$here stray
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

quick_ends

# ---- What does not come to its end -----------------------------------------------------------------

# What ends the whole is told with the input it ended in, and what it comes from where that shows.
copy_lab solutions 07-kdtree-3d-trace
printf '    if (hit.t < at->t_max) {\n        return 0;\n    }\n    *at = todo_pop(todo);\n    return 1;\n' |
    answer trace.cl next_waiting
# shellcheck disable=SC2046,SC2086 # options
check "a crash in one task costs its points" grades 1 86 $(kept 07) $submission
check "its input is told" grep -q "where: in next_waiting, input [0-9]* of 400: .*and 0 nodes are waiting" "$said"
check "and that nothing was there to be taken" grep -q "taken from an empty stack: nothing was waiting" "$said"
ok "$(grep -c 'make memcheck' "$said")" "so memcheck need not tell" "$(cat "$said")"

# Two more, of which the second one calls the first: beside a stub only its cause is said.
copy_lab solutions 03-kdtree-2d-render
for answer in left-right-swapped sixteen-levels; do
    "$build/tools/known" put 03-kdtree-2d-render $answer "$scratch/submission"
done
# shellcheck disable=SC2046,SC2086 # options
check "an answer beside a stub earns what it passes alone" grades 1 65 $(kept 03) $submission
check "its mistake is named as by itself" \
    grep -q '; tested alone: it looks drawn as if the search ended after a fixed number' "$reports/results.json"

# Two of which neither comes to its end alone: it is said once, with the task in which the whole ended.
copy_lab solutions 03-kdtree-2d-render
printf '    return nodes_Relations[id + 0x7fffffff].id + (uint)(x + y);\n' |
    answer implicit2DRenderer_KD.cl getContainingChild
printf '    color = (float4)(circles[id + 0x7fffffff].r);\n' | answer implicit2DRenderer_KD.cl leaf_loop
# shellcheck disable=SC2046,SC2086 # options
check "two answers that crash leave the points of the third" grades 1 35 $(kept 03) $submission
check "what does not come to its end alone says so" grep -q "tested alone, it crashes" "$reports/results.json"
ok "$(grep -c "first, then grade again" "$reports/results.json")" "and sends to no other task" "$(cat "$said")"
ok "$(grep -c 'tested alone, it crashes.*tested alone, it crashes' "$reports/results.json")" "and says it once" \
    "$(cat "$said")"

# An endless loop: what it is at is on the terminal, and gone before the report.
copy_lab solutions 02-kdtree-2d-build
echo '    for (volatile int i = 1; i > 0;) {} return 1;' | answer kdtree2d_build.c is_leaf
script -qec "'$build/tools/grade' --build '$build' --output '$reports' --lab 02 $submission --seed 5 --first" /dev/null \
    </dev/null >"$said" 2>&1
check "an endless loop is told" grep -q "an endless loop?" "$said"
check "with its input" grep -q "where: in is_leaf, input 1 of 660: level " "$said"
check "the other tasks keep their points" test "$(field score)" = 85
escape=$(printf '\033')
check "meanwhile the terminal says what runs" grep -q "running your program, [0-9]* s" "$said"
check "and what is tried alone" grep -q "checking is_leaf alone: task 1 of 5, [0-9]* s" "$said"
check "before the report the line is taken away" grep -q "checking [a-z_ ]*: task [^$escape]*.$escape\[K[^c]*02-kdtree" "$said"

# The other sandbox, where it can be had, and none at all: the same marks, and the reports say which.
kinds=none
[ "$(id -u)" -ne 0 ] || kinds="landlock none"
for kind in $kinds; do
    # Behind walls both run, the solution and, as a submission, the same beside it.
    options='--lab 03'
    [ "$kind" = landlock ] || options=$(kept 03)
    # shellcheck disable=SC2086 # options
    check "$kind: the solution gets full marks" grades 0 100 $options \
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
    TMPDIR='' grades 1 0 --lab 02 --submission labs/02-kdtree-2d-build
)
check "TMPDIR is empty: the grader works in /tmp" empty_tmpdir
no_tmpdir() (
    # shellcheck disable=SC2016 # said so
    TMPDIR=/nowhere refuses ' in $TMPDIR or /tmp: No such file or directory' \
        --lab 02 --submission labs/02-kdtree-2d-build
)
check "TMPDIR is not there: it says so" no_tmpdir

# The third sandbox, of a kernel without Landlock: in a course that is closed to other users. In an open
# one the solution could be read: refused.
older=$build/tools/older_kernel
if [ "$(id -u)" -ne 0 ]; then
    skip "the third sandbox" "it needs root, to become another user"
else
    tests/closed_course.sh "$scratch/course"
    (cd "$scratch/course" && "$older" build/tools/grade --lab 03 \
        --submission solutions/03-kdtree-2d-render --output "$scratch/course/reports") >"$said" 2>"$said.err"
    ok $? "no Landlock: the solution gets full marks" "$(cat "$said" "$said.err")"
    reports_before=$reports reports=$scratch/course/reports
    check "no Landlock: results.json says so" test "$(field sandbox)" = user
    check "no Landlock: so does the text" grep -q "sandbox user" "$said"
    check "no Landlock: so does the page" grep -q "<dd>user</dd>" "$reports/report.html"
    check "no Landlock: one line says why, and that it hides less" \
        grep -q '^sandbox: bubblewrap .*Landlock.*hides less: .*"The three sandboxes"$' "$said.err"
    check "no Landlock: it says no more" test "$(wc -l <"$said.err")" = 1
    check "no Landlock: text and results.json lead to its gaps" stage Sandbox passed 'The three sandboxes'
    tests/systems/formats/write.sh junit,tap "$reports" 03-kdtree-2d-render
    for file in "$said" "$reports/report.html" "$reports/junit.xml" "$reports/results.tap"; do
        check "no Landlock: $(basename "$file") says that it hides less" \
            grep -q 'A user of its own for each run' "$file"
    done
    reports=$reports_before
    # Without filters of system calls no sandbox is one.
    (cd "$scratch/course" && "$older" --no-seccomp build/tools/grade --lab 03 \
        --submission solutions/03-kdtree-2d-render --output "$scratch/course/reports/unfiltered") >"$said" 2>"$said.err"
    ok $(($? != 2)) "no filter of system calls: it refuses" "$(cat "$said.err")"
    check "no filter of system calls: it says so" \
        grep -q '^  nor another one: cannot use the filter of system calls: ' "$said.err"
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

# ---- What the grader's environment holds ------------------------------------------------------------

# hostile_grade LAB SUBMISSION SANDBOX: compilers, drivers, the judge and reports are asked.
hostile_grade() {
    rm -rf "$reports"
    hostile "$build/tools/grade" --build "$build" --output "$reports" --lab "$1" --submission "$2" --sandbox "$3" \
        >"$said" 2>"$said.err" </dev/null
    status=$?
    cat "$said" "$said.err"
    [ "$status" -eq 0 ] && [ "$(field score)" -eq 100 ]
}
sandboxes=bubblewrap
[ "$(id -u)" -ne 0 ] || sandboxes="bubblewrap landlock"
for lab in 00-hello-pixels 01-naive-2d; do
    tar -C "solutions/$lab" -cJf "$scratch/archive.tar.xz" .
    for kind in $sandboxes; do
        check "$lab in $kind: no variable of a hostile environment reaches a verdict" \
            hostile_grade "$lab" "$scratch/archive.tar.xz" "$kind"
    done
done
rm -f "$scratch/archive.tar.xz"

# ---- What else it says --------------------------------------------------------------------------

for lab in $labs; do
    check "$lab: its checks are worth 100 points" test "$("$build/tools/grade" --lab "$lab" --list-checks |
        awk -F '\t' '{ sum += $3 } END { print sum }')" = 100
done
check "it has a help" "$build/tools/grade" --help
check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"

finish

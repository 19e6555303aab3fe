#!/bin/sh
# One result for other systems: every format against its documented schema, and what it says.
#
#     sh tests/suites/formats.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/systems.sh
# The make that is tried is the first one.
unset MAKEFLAGS MFLAGS MAKELEVEL

write=tests/systems/formats/write.sh

# ---- Gradings in every format -------------------------------------------------------------------

# kept NN: options for a seed whose answers of the solution are kept: it need not run every time.
kept() {
    mkdir -p "$scratch/answers/$1"
    echo "--lab $1 --seed 5 --answers $scratch/answers/$1"
}

# grade_as STATUS NAME OPTION...: does a grading with every format end so, with nothing on stderr
# that is not about a fault of the grader? Its files are in $scratch/reports/NAME.
grade_as() {
    wanted=$1 reports=$scratch/reports/$2
    shift 2
    status=0
    "$write" "$formats" "$reports" $lab "$build/tools/grade" --build "$build" --output "$reports" "$@" \
        >"$scratch/said" 2>"$scratch/said.err" </dev/null || status=$?
    [ "$status" -eq "$wanted" ] || { echo "exit status $status"; cat "$scratch"/said*; return 1; }
    [ "$status" -eq 2 ] || [ ! -s "$scratch/said.err" ] || { cat "$scratch/said.err"; return 1; }
}

for name in right wrong hostile missing; do
    case $name in right) status=0 ;; *) status=1 ;; esac
    # shellcheck disable=SC2046 # options
    check "a $name submission in every format" \
        grade_as $status $name $(kept 00) --submission "$scratch/$name"
done

quick_ends

# A lab with a leaderboard: who has every point has a figure, unless the own kernel never ends in the
# race, which alone counts nothing. It costs no points. Skeletons of all labs: in the suite `grader`.
# shellcheck disable=SC2046 # options
{
    check "a skeleton of a lab with a leaderboard" \
        grade_as 1 10-realtime $(kept 10) --submission labs/10-realtime
    check "a right submission of it" grade_as 0 fast $(kept 10) --submission solutions/10-realtime
}
cp "$scratch/said" "$scratch/fast.said"
cp -R solutions/10-realtime "$scratch/endless"
sed -i '/^int cone_misses_sphere/,/{/s/{/{\n#ifndef COUNT_WORK\n    for (volatile int i = 0;; i++) {\n    }\n#endif/' \
    "$scratch/endless/cone.cl"
# shellcheck disable=SC2046 # options
check "one whose race never ends" grade_as 0 endless $(kept 10) --submission "$scratch/endless"

# A fault of the machinery, where older results lie.
mkdir "$scratch/no-build"
cp -r "$scratch/reports/right" "$scratch/reports/fault"
check "a fault of the grader" \
    grade_as 2 fault --lab 00 --submission "$scratch/right" --build "$scratch/no-build"

# ---- Schemas ------------------------------------------------------------------------------------

obey_schemas "$scratch/reports"

# The schemas themselves refuse what is wrong.
refuses() {
    printf '%s' "$2" >"$scratch/wrong.json"
    ! obeys "$1" "$scratch/wrong.json" 2>/dev/null
}
check "a score as text is no Gradescope result" refuses gradescope '{"score": "5", "tests": []}'
check "nor is one without a score" refuses gradescope '{"tests": [{"name": "a"}]}'
check "a score of 85 is no PrairieLearn result" refuses prairielearn '{"score": 85}'
check "nor is one without a score" refuses prairielearn '{"gradable": true}'
check "points as text are no Autolab result" refuses autolab '{"scores": {"a": "5"}}'
# One word that Jenkins' xUnit plugin does not know, or two cases of one name.
for edit in 's/<testsuites /&skipped="0" /' 's/<testcase /&file="a.c" /' \
    's/<testcase .*name="Staging".*/&&/' 's/ time="[0-9]*/&,000/'; do
    sed "$edit" "$scratch/reports/right/junit.xml" >"$scratch/wrong.xml"
    ! xmllint --noout --schema "$schemas/junit.xsd" "$scratch/wrong.xml" 2>"$scratch/said"
    ok $? "JUnit XML is refused after $edit" "$(cat "$scratch/said")"
done

# ---- What the formats say -----------------------------------------------------------------------

# says NAME FILE PATTERN: does this report hold a line that matches?
says() {
    grep -e "$3" "$scratch/reports/$1/$2" >/dev/null || { cat "$scratch/reports/$1/$2"; return 1; }
}
# counts NAME FILE PATTERN NUMBER: in how many places does it match?
counts() {
    found=$(grep -o -e "$3" "$scratch/reports/$1/$2" | wc -l)
    [ "$found" -eq "$4" ] || { echo "found $found"; cat "$scratch/reports/$1/$2"; return 1; }
}

# What each report says, a line a test: the submission, the file, and a pattern.
while IFS='|' read -r name file pattern title; do
    check "$title" says "$name" "$file" "$pattern"
done <<'END'
right|gradescope.json|^{"score":100,|Gradescope: full marks
wrong|gradescope.json|^{"score":60,|Gradescope: some
hostile|gradescope.json|^{"score":80,|Gradescope: a crash costs its task
missing|gradescope.json|^{"score":0,.*"output":"Staging: failed|Gradescope: nothing handed in
wrong|gradescope.json|<img alt=\\".*(yours)\\" src=\\"data:image|Gradescope: shows a wrong picture
right|prairielearn.json|"gradable":true,"score":1,|PrairieLearn: full marks
wrong|prairielearn.json|"gradable":true,"score":0.6,|PrairieLearn: some
fast|gradescope.json|"leaderboard":\[{"name":"times as fast as lab 07's kernel","value":[0-9.]*,"order":"desc"}\]|Gradescope: the figure of a race
endless|gradescope.json|^{"score":100,|a race that never ends costs no points
wrong|prairielearn.json|"label":"[^"]*(yours)","url":"data:|PrairieLearn: shows the wrong picture
missing|prairielearn.json|^{"gradable":false,.*gradient.cl: |PrairieLearn: nothing to grade
wrong|autolab.json|^{"scores":{"gradient":0,"set_arguments":20,|Autolab: the points by task
hostile|autolab.json|^{"scores":{"gradient":40,"set_arguments":0,|Autolab: ours is the last line
hostile|github.txt|::Points 80/100$|GitHub: the points
right|vpl.txt|^Grade :=>> 100$|VPL: full marks
hostile|vpl.txt|^Grade :=>> 80$|VPL: a crash costs its task
hostile|vpl.txt|^>.*Bail out!$|VPL: a student's words are quoted
missing|vpl.txt|^Grade :=>> 0$|VPL: nothing handed in
fault|vpl.txt|^-No grade$|VPL: a fault says so
missing|junit.xml| failures="1" errors="0" skipped="5" |JUnit: no check ran, a stage failed
fault|junit.xml| failures="0" errors="1" |JUnit: a fault is an error
fault|prairielearn.json|^{"gradable":false,.*The grader could not|PrairieLearn: a fault is no grade
END
check "Gradescope: says which checks did not run" counts missing gradescope.json '"Not run: ' 5
check "the report tells it" grep -q "^ [0-9.]* times as fast as lab 07's kernel on this device, in this run; " \
    "$scratch/fast.said"
check "a skeleton has no figure" counts 10-realtime results.json leaderboard 0
check "nor has a race that never ends" counts endless results.json leaderboard 0
check "VPL: a fault gives no grade" counts fault vpl.txt '^Grade' 0
check "VPL: what a student writes is no grade" counts hostile vpl.txt '^Grade' 1
VPL_GRADEMAX=12.5 $write vpl "$scratch/reports/wrong" $lab
check "VPL: a part of the activity's grade" says wrong vpl.txt '^Grade :=>> 7.5$'
VPL_GRADEMAX=ten $write vpl "$scratch/reports/wrong" $lab
check "VPL: which is no number" says wrong vpl.txt '^Grade :=>> 60$'
check "GitHub: two annotations" counts hostile github.txt '^::notice title=[A-Za-z ]*::' 2
check "JUnit: markup of the student's is text" counts hostile junit.xml '<!\[CDATA\[' 0

# proves STATUS NAME PATTERN: does Perl's harness end so over the TAP, and say what matches? It
# finds no fault in the form, but where the TAP bails out before its plan.
# shellcheck disable=SC2317 # called by check
proves() {
    status=0
    prove --exec cat "$scratch/reports/$2/results.tap" >"$scratch/proved" 2>&1 || status=$?
    cat "$scratch/proved"
    [ "$status" -eq "$1" ] && grep -q -e "$3" "$scratch/proved" &&
        { [ "$status" -eq 255 ] || ! grep -q "Parse errors" "$scratch/proved"; }
}
check "TAP: full marks pass" proves 0 right '^Files=1, Tests=8,'
check "TAP: wrong ones fail" proves 1 wrong 'Tests: 8 Failed: 2)'
check "TAP: nothing handed in fails" proves 1 missing 'Tests: 6 Failed: 1)'
check "TAP: what the student prints is no test" proves 1 hostile 'Tests: 8 Failed: 2)'

check "TAP: a fault bails out" \
    proves 255 fault 'Further testing stopped: 00-hello-pixels: The grader could not work'
left=$(cd "$scratch/reports/fault" && ls gradescope.json autolab.txt github.txt 2>/dev/null)
[ -z "$left" ]
ok $? "a fault leaves no older points for Gradescope, Autolab and GitHub" "$left"

# By make, in a build folder whose reports are its own.
mkdir "$scratch/build"
ln -s "$build"/* "$scratch/build"
rm -f "$scratch/build/grade"
# made STATUS WORD...: does make grade end so, with FORMAT=junit,tap or another?
# shellcheck disable=SC2317 # called by check
made() {
    wanted=$1
    shift
    status=0
    make -s --old-file=grader grade BUILD="$scratch/build" FORMAT=junit,tap "$@" >"$scratch/said" 2>&1 || status=$?
    [ "$status" -eq "$wanted" ] || { echo "exit status $status"; cat "$scratch/said"; return 1; }
}
check "make grade ends well after a verdict" made 0 LAB=0 SUBMISSION="$scratch/wrong"
check "and writes what is asked for" grep '^not ok 4 - gradient: ' "$scratch/build/grade/00/results.tap"
[ -f "$scratch/build/grade/00/junit.xml" ] && [ ! -e "$scratch/build/grade/00/github.txt" ]
ok $? "and nothing else" "$(ls "$scratch/build/grade/00")"
check "it fails after a fault" made 2 LAB=00-hello-pixels DEVICE=none-such
check "and the formats say so" grep '^Bail out! 00-hello-pixels: ' "$scratch/build/grade/00/results.tap"
check "an unknown format is refused" made 2 LAB=00 FORMAT=junit,html
check "and named, before anything is graded" \
    grep -x 'formats: found "html", expected some of junit, tap, gradescope, autolab, prairielearn, github, vpl' "$scratch/said"
check "another lab, too" made 2 LAB=99
check "by the grader" grep 'found "99", expected the number or name of a lab' "$scratch/said"

mkdir "$scratch/few-programs"
ln -s "$(command -v dirname)" "$(command -v sh)" "$scratch/few-programs"
! PATH=$scratch/few-programs $write junit "$scratch/reports/right" $lab >"$scratch/said" 2>&1
ok $? "without jq nothing is written"
check "and a message says so" grep -x 'formats: jq is not here: install the package jq' "$scratch/said"

left=$(ls -A "$TMPDIR")
[ -z "$left" ]
ok $? "nothing is left in the folder for temporary files" "$left"

finish

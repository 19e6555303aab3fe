#!/bin/sh
# What an instructor decides for a class by hand: corrections (CHANGES=). They are shown as what they are,
# outlive a new grading, and are refused before anything is graded where they are not clear.
#
#     sh tests/suites/corrections.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

# Two real gradings: one right, one with a wrong kernel.
wrong=$scratch/answer
cp -R solutions/$lab "$wrong"
"$build/tools/holes" fill solutions/$lab/gradient.cl gradient tests/mutants/$lab/half-pixel.cl >"$wrong/gradient.cl"
check "right results" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
check "and wrong ones" exits 1 "$build/tools/grade" --build "$build" --lab 0 \
    --submission "$wrong" --output "$scratch/wrong"
# shellcheck disable=SC2016 # for the other shell
stand_in "$scratch/right" "WRONG='$scratch/wrong'"'
case $student in
Bob*) cp -R "$WRONG/." "$output"; exit 1 ;;
Dora*) exit 2 ;;
esac'

# n_graded OUTPUT: how many gradings the job log has.
n_graded() { grep -c "tests/class/grade_one.sh" "$1/joblog"; }

class=$scratch/course
for entry in "Ada Lovelace_21_assignsubmission_file_" "Ada Lovelace_22_assignsubmission_file_" \
    "Bob Ross_23_assignsubmission_file_" "Carol Shaw_24_assignsubmission_file_"; do
    mkdir -p "$class/$entry"
done
cat >"$scratch/list.csv" <<'END'
Identifier,"Full name","Email address",Grade,"Feedback comments"
"Participant 21","Ada Lovelace",a1@example.org,,
"Participant 22","Ada Lovelace",a2@example.org,,
"Participant 23","Bob Ross",bob@example.org,,
"Participant 24","Carol Shaw",carol@example.org,,
"Participant 25","Erin Doe",erin@example.org,,
END

# changes LINE...: a file of corrections.
changes() {
    echo student,task,points,comment,until >"$scratch/changes.csv"
    [ $# -eq 0 ] || printf '%s\n' "$@" >>"$scratch/changes.csv"
}

out=$scratch/out
corrected() { run "$out" --moodle "$scratch/list.csv" --changes "$scratch/changes.csv" "$@"; }
# value NUMBER FILTER: of a student in gradebook.json.
value() { jq -r --arg number "$1" ".students[] | select(.number == \$number) | $2" "$out/gradebook.json" | paste -s -d ' '; }

# ---- Refused before anything is graded -----------------------------------------------------------

# refused WORDS LINE...: such a file ends the run with this message, and nothing is graded.
# shellcheck disable=SC2317 # called by check
refused() {
    words=$1
    shift
    changes "$@"
    exits 2 corrected && said "changes.csv: $words" && test ! -e "$out/joblog" &&
        test "$(grep -c changes.csv "$scratch/said")" -eq 1 && test ! -e "$out/gradebook.csv"
}
check "a student of another class" refused 'line 2: found the student "Grace", who handed in nothing here' \
    Grace,gradient,12,,
check "a name of two" refused 'line 2: "Ada Lovelace" is the name of 2 submissions, among them ada-lovelace-' \
    "Ada Lovelace,gradient,12,,"
check "a part of a name is none" refused 'line 2: found the student "Ross"' Ross,gradient,12,,
check "no name" refused 'line 2: found the student ""' ,gradient,12,,
check "a task of another lab" refused "line 3: found the task \"overlaps\", expected a task or check of $lab" \
    23,gradient,12,, 24,overlaps,1,,
check "points without a task" refused 'line 2: found the task ""' 23,,12,,
check "more points than a task has" refused 'line 2: found 41 points, but gradient has 0 to 40' 23,gradient,41,,
check "or than a check has" refused 'line 2: found 11 points, but gradient-padding has 0 to 10' \
    23,gradient-padding,11,,
check "too large a change" refused 'line 2: found -41 points, but gradient has 0 to 40' 23,gradient,-41,,
for points in 1.5 twelve ++5 5% +; do
    check "$points points" refused "line 2: found \"$points\" points, expected a whole number" "23,gradient,$points,,"
done
for day in 24.12.2026 2026-13-01 2026-02-30 2026-12-24x 12-24; do
    check "the day $day" refused "line 2: found \"$day\" in the column \"until\"" "23,,,,$day"
done
check "a task and its check" refused 'line 3: line 2 changes the same points already' \
    23,gradient,12,, bob@example.org,gradient-padding,+1,,
check "nothing but a name" refused 'line 2: found a student only' 23,,,,
check "a line that is too short" refused 'line 3: found another number of columns than in the first' \
    23,gradient,1,, 23,gradient
printf 'student,task,points,coment\n' >"$scratch/changes.csv"
check "a slip in a title" exits 2 corrected
check "is named" said 'line 1: found the column "coment", expected these: student, task, points, comment, until'
printf 'student,task\n' >"$scratch/changes.csv"
check "a column that is missing" exits 2 corrected
check "is named, too" said 'line 1: found no column "points"'
printf 'PK\003\004' >"$scratch/changes.csv"
check "a workbook" exits 2 corrected
check "is no list of corrections" said \
    "found a workbook (Excel or LibreOffice), or an archive; save it as CSV; expected a list of corrections"
check "no file at all" exits 2 run "$out" --changes "$scratch/none.csv"

# ---- Applied -------------------------------------------------------------------------------------

changes '23,gradient,+5,"right idea, =1+1",' '22,set_arguments,0,"copied <b>",' 'carol@example.org,,,ill,2026-12-24' \
    '21,gradient-padding,-3,,' 'Carol Shaw,gradient-picture,12,,' ',,,,'
bob=$(jq .score "$scratch/wrong/results.json")
gradient=$(jq '.tasks[] | select(.id == "gradient") | .points' "$scratch/wrong/results.json")
check "five corrections" exits 0 corrected
check "a change is added to the points" \
    test "$(value 23 '.score, .points.gradient')" = "$((bob + 5)) $((gradient + 5))"
check "and the grader's stay beside them" test "$(value 23 .score_before)" = "$bob"
check "points without a sign are the task's" \
    test "$(value 22 '.score, .points.set_arguments, .score_before')" = "80 0 100"
check "a check's points are a part of its task's" test "$(value 21 '.score, .points.gradient')" = "97 37"
check "of two lines for one each counts" test "$(value 24 '.score, (.corrections | length)')" = "82 2"
check "JSON has all of it" test "$(value 23 '.corrections[0] | .task, .before, .after, .applied, .comment')" = \
    "gradient $gradient $((gradient + 5)) true right idea, =1+1"
check "also of a check" \
    test "$(value 21 '.corrections[0] | .task, .check, .before, .after')" = "gradient gradient-padding 10 7"
check "and of an extension" \
    test "$(value 24 '.corrections[0] | .until, .comment, .applied')" = "2026-12-24 ill null"
check "Moodle's column has the corrected grade" row "$out" \
    "\"Participant 23\",\"Bob Ross\",\"bob@example.org\",\"$((bob + 5)).00\",\"$((bob + 5)) of 100 points: "
check "and the comment says why" grep -q \
    "Corrected by hand: gradient: $gradient to $((gradient + 5)) (+5): right idea, " "$out/gradebook.csv"
check "columns say what was before, what was changed, until when" grep -q \
    '"Carol Shaw".*,100,"ill; gradient-picture: 30 to 12 (-18)","2026-12-24",' "$out/gradebook.csv"
# shellcheck disable=SC2016 # for the inner shell
check "a comment is no formula" sh -c '! grep -E "(^|[,;|	])[\" ]*=" "$1"' - "$out/gradebook.csv"
check "the page lists them" grep -q '>gradient-padding: 10 to 7 (-3)<' "$out/class.html"
check "and is well-formed, whatever a comment says" xmllint --html --noout "$out/class.html"
check "which is no markup" grep -q 'copied &lt;b&gt;' "$out/class.html"
check "a corrected row says so" test "$(grep -c '>corrected</a>' "$out/class.html")" -eq 4
cp "$out/gradebook.csv" "$scratch/before.csv"
check "all graded anew" exits 0 corrected --again 1
check "keeps them" cmp "$scratch/before.csv" "$out/gradebook.csv"
check "and it was graded" test "$(n_graded "$out")" -eq 8
check "without CHANGES" exits 0 run "$out" --moodle "$scratch/list.csv"
check "the grader's points are back" test "$(value 22 .score)" = 100
check "and no column speaks of corrections" test "$(grep -c 'score before' "$out/gradebook.csv")" -eq 0

# ---- Given back ----------------------------------------------------------------------------------

feedback() {
    "$build/tools/gradebook" feedback --moodle "$scratch/list.csv" --changes "$scratch/changes.csv" "$1" "$out" \
        >"$scratch/said" 2>&1
}
report=$(echo "$out"/students/bob-*/report.html)
check "each gets the report with the corrections" exits 0 feedback moodle
check "bob's" sh -c "unzip -p '$out/feedback-moodle.zip' 'Bob Ross_23*' >'$scratch/bob.html'"
check "has them" grep -q "gradient: $gradient to $((gradient + 5)) (+5)</td><td><p class=\"message\">right idea, =1+1" "$scratch/bob.html"
check "and the new score" grep -q "$((bob + 5)) of 100 points instead of $bob" "$scratch/bob.html"
check "and is well-formed" xmllint --html --noout "$scratch/bob.html"
check "and all that the grader said" test "$(diff "$report" "$scratch/bob.html" | grep -c '^<')" -eq 0
check "an extension stands there, too" sh -c "unzip -p '$out/feedback-moodle.zip' 'Carol Shaw_24*' | grep -q 2026-12-24"
check "as folders" exits 0 feedback folders
check "the same" cmp "$scratch/bob.html" "$(echo "$out"/feedback/Bob*/report.html)"
check "the list has the corrected points" grep -q "\"Bob Ross\",$((bob + 5)),100," "$out/feedback.csv"
check "without corrections it is the grader's report" sh -c "'$build/tools/gradebook' feedback folders '$out' &&
    cmp '$report' '$out'/feedback/Bob*/report.html"

# What leads beyond a task's points is known when it is graded.
before=$(n_graded "$out")
cp "$out/gradebook.csv" "$scratch/before.csv"
changes 22,gradient,-1,, 21,gradient,+1,,
check "more than a task has, as it is graded" exits 2 corrected --again 1
check "is refused" said "changes.csv: line 3: +1 to the 40 points of gradient is not in 0 to 40"
check "before anything is graded" test "$(n_graded "$out")" -eq "$before"
check "and the gradebook is as it was" cmp "$scratch/before.csv" "$out/gradebook.csv"

finish

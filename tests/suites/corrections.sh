#!/bin/sh
# What an instructor decides for a class by hand: corrections (CHANGES=), and whose an entry is (WHO=). Both are
# shown as what they are, outlive a new grading, and are refused before anything is graded where they are not clear.
#
#     sh tests/suites/corrections.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

# Two real gradings: one right, one with a wrong kernel.
wrong=$scratch/answer
cp -R solutions/$lab "$wrong"
"$build/tools/known" put $lab half-pixel "$wrong"
check "right results" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
check "and wrong ones" exits 1 "$build/tools/grade" --build "$build" --lab 0 \
    --submission "$wrong" --output "$scratch/wrong"
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" "WRONG='$scratch/wrong'"'
case $student in
Bob*) cp -R "$WRONG/." "$output"; exit 1 ;;
Dora*) exit 2 ;;
esac'

# n_graded OUTPUT: how many gradings the job log has.
n_graded() { grep -c "tests/class/grading/grade_one.sh" "$1/joblog"; }

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
value() {
    jq -r --arg number "$1" ".students[] | select(.number == \$number) | $2" "$out/gradebook.json" | paste -s -d ' '
}

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
check "a student of another class" refused 'line 2: found the student "Grace", who is not in this class' \
    Grace,gradient,12,,
check "a name of two" refused 'line 2: "Ada Lovelace" is the name of 2 submissions, among them ada-lovelace-' \
    "Ada Lovelace,gradient,12,,"
check "a part of a name is none" refused 'line 2: found the student "Ross"' Ross,gradient,12,,
check "points of a student who handed in nothing" refused 'line 2: found points of a student who handed in nothing' \
    erin@example.org,gradient,12,,
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
for day in 24.12.26 2026-13-01 2026-02-30 2026-12-24x 12-24; do
    check "the day $day" refused "line 2: found \"$day\" in the column \"until\"" "23,,,,$day"
done
check "a task and its check" refused 'line 3: line 2 changes the same points already' \
    23,gradient,12,, bob@example.org,gradient-padding,+1,,
check "the score and a task of it" refused 'line 3: line 2 changes the same points already' \
    23,score,12,, bob@example.org,gradient,+1,,
check "more than the score can be" refused 'line 2: found 101 points, but score has 0 to 100' 23,score,101,,
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

changes '23,gradient,+5,"right idea, =1+1",' '22,set_arguments,0,"copied <b>",' 'carol@example.org,,,ill,24.12.2026' \
    '21,gradient-padding,-3,,' 'Carol Shaw,gradient-picture,12,,' ',,,,' \
    'Participant 25,,,at sea,2026-12-31'
bob=$(jq .score "$scratch/wrong/results.json")
gradient=$(jq '.tasks[] | select(.id == "gradient") | .points' "$scratch/wrong/results.json")
check "six corrections" exits 0 corrected
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
check "an extension of a student who handed in nothing" grep -q \
    '"Erin Doe".*,"no submission",.*,"at sea","2026-12-31",' "$out/gradebook.csv"
check "is on the page" grep -q '>Erin Doe</td>.*at sea' "$out/class.html"
check "and in JSON" \
    test "$(jq -r '.without_submission[] | .name, .number, .until' "$out/gradebook.json" | paste -s -d ' ')" = \
    "Erin Doe Participant 25 2026-12-31"
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

changes '22,score,0,see me,' 23,score,-3,,
check "the score as a whole" exits 0 corrected
check "is what the line says, and its tasks keep their points" \
    test "$(value 22 '.score, .points.gradient, .score_before')" = "0 40 100"
check "or changes by it" test "$(value 23 .score)" = $((bob - 3))
check "the page says so" grep -q '>score: 100 to 0 (-100)<' "$out/class.html"

# What went wrong first, where a second fault is behind it.
results=$(echo "$out"/students/bob-*/results.json)
jq '(.checks[] | select(.id == "gradient-padding")) |= (.points = 0 | .status = "failed" | .message = "it does") |
    (.tasks[] | select(.id == "gradient")).points -= 10 | .score -= 10' "$results" >"$scratch/results.json"
cp "$scratch/results.json" "$results"
changes 23,gradient-picture,30,,
check "a check that gets its points" exits 0 corrected
check "is no fault any more: the next one is" grep -q \
    '^"Participant 23",.*First fault: Nothing is written outside the picture: it does' "$out/upload.csv"
for change in "23,gradient,40,," "23,score,100,,"; do
    changes "$change"
    check "$change" exits 0 corrected
    check "$change: 100 points have no first fault in the comment" test "$(grep -c 'First fault' "$out/upload.csv")" -eq 0
    check "$change: nor in the gradebook" test "$(value 23 '.score, .first_fault')" = "100 null"
    check "$change: nor in the table of the page" test \
        "$(grep -A 1 '<td class="first">' "$out/class.html" | grep -c 'colour\|outside')" -eq 0
done
check "what went wrong stays on the page, for the lecture" grep -q '<b>Every pixel has its colour</b>' "$out/class.html"
check "graded anew" exits 0 corrected --again 1

# What was not graded has no points that could be corrected.
mkdir "$class/Dora Roe_25_assignsubmission_file_"
changes 22,gradient,1,, 25,gradient,+1,late,
check "one who cannot be graded" exits 1 corrected
check "keeps nobody from a correction" test "$(value 22 .points.gradient)" = 1
check "and it is said what is not applied" said "1 corrections of points not applied, as nothing was graded there"
check "also in the gradebook" grep -q '"gradient: +1 not applied, as nothing was graded: late"' "$out/gradebook.csv"
rmdir "$class/Dora Roe_25_assignsubmission_file_"
changes "23,gradient,+5,\"right idea, =1+1\"," 24,,,ill,2026-12-24
check "without it" exits 0 corrected

quick_ends

# ---- Given back ----------------------------------------------------------------------------------

feedback() {
    "$build/tools/gradebook" feedback --moodle "$scratch/list.csv" --changes "$scratch/changes.csv" "$1" "$out" \
        >"$scratch/said" 2>&1
}
report=$(echo "$out"/students/bob-*/report.html)
check "each gets the report with the corrections" exits 0 feedback moodle
check "bob's" sh -c "unzip -p '$out/feedback-moodle.zip' 'Bob Ross_23*' >'$scratch/bob.html'"
check "has them" grep -q \
    "gradient: $gradient to $((gradient + 5)) (+5)</td><td><p class=\"message\">right idea, =1+1" "$scratch/bob.html"
check "and the new score" grep -q "$((bob + 5)) of 100 points instead of $bob" "$scratch/bob.html"
check "and is well-formed" xmllint --html --noout "$scratch/bob.html"
check "at the top, too" grep -q "<p class=\"score number\">$((bob + 5)) <small>of 100 points" "$scratch/bob.html"
check "and all that the grader said, but the score and its bar" \
    test "$(diff "$report" "$scratch/bob.html" | grep -c '^<')" -eq 2
check "an extension stands there, too" sh -c "unzip -p '$out/feedback-moodle.zip' 'Carol Shaw_24*' | grep -q 2026-12-24"
check "as folders" exits 0 feedback folders
check "the same" cmp "$scratch/bob.html" "$(echo "$out"/feedback/Bob*/report.html)"
check "the list has the corrected points" grep -q "\"Bob Ross\",$((bob + 5)),100," "$out/feedback.csv"
"$build/tools/gradebook" feedback folders "$out" >"$scratch/said" 2>&1
check "without corrections the points are not those of the gradebook" said \
    "found other points than in gradebook.json for 1 submissions, expected the CHANGES="
mv "$out/gradebook.json" "$scratch/with.json"
check "where there is none, it is the grader's report" sh -c "'$build/tools/gradebook' feedback folders '$out' &&
    cmp '$report' '$out'/feedback/Bob*/report.html"
mv "$scratch/with.json" "$out/gradebook.json"

# What leads beyond a task's points is known when it is graded.
before=$(n_graded "$out")
cp "$out/gradebook.csv" "$scratch/before.csv"
changes 22,gradient,-1,, 21,gradient,+1,,
check "more than a task has, as it is graded" exits 2 corrected --again 1
check "is refused" said "changes.csv: line 3: +1 to the 40 points of gradient is not in 0 to 40"
check "before anything is graded" test "$(n_graded "$out")" -eq "$before"
check "and the gradebook is as it was" cmp "$scratch/before.csv" "$out/gradebook.csv"

# ---- Whose it is ---------------------------------------------------------------------------------

class=$scratch/whose
out=$scratch/whose.out
for entry in "Ada Lovelace_21_assignsubmission_file_" bobby "=1+1" "carol-2" carol spam "Team X"; do
    mkdir -p "$class/$entry"
done
cat >"$scratch/list.csv" <<'END'
Identifier,"Full name","Email address",Username,Grade
"Participant 21","Ada Lovelace",a1@example.org,ada,
"Participant 23","Bob Ross",bob@example.org,bob,
"Participant 24","Carol Shaw",cs@example.org,carol,
"Participant 25","Erin Doe",erin@example.org,erin,
"Participant 26","Ada Lovelace",a2@example.org,ada2,
END
decided() { run "$out" --moodle "$scratch/list.csv" --who "$scratch/who.csv" "$@"; }
# who LINE...: a file of decisions.
who() {
    echo entry,student,counts >"$scratch/who.csv"
    [ $# -eq 0 ] || printf '%s\n' "$@" >>"$scratch/who.csv"
}
# entered PARTICIPANT NAME GRADE: is the entry of this name the participant's?
# shellcheck disable=SC2317 # called by check
entered() {
    grep "^\"$1\"," "$out/gradebook.csv" | grep -qF "\"$3\",\"$2\"," || { cat "$out/gradebook.csv"; return 1; }
}

# unclear WORDS LINE...: such decisions end the run with this message before anything is graded.
# shellcheck disable=SC2317 # called by check
unclear() {
    words=$1
    shift
    who "$@"
    exits 2 decided && said "who.csv: $words" && test ! -e "$out/joblog" &&
        test "$(grep -c who.csv "$scratch/said")" -eq 1 && test ! -e "$out/gradebook.csv"
}
check "an entry that is none" unclear 'line 3: found the entry "bobo", expected an "entry" or "id"' \
    "bobby,Bob Ross," "bobo,Bob Ross,"
check "a student that is none" unclear 'line 2: found the student "Bob Rosso"' "bobby,Bob Rosso,"
check "a student of two lines" unclear \
    'line 2: "Ada Lovelace" fits 2 lines of the list of participants, among them 2 and 6' "bobby,Ada Lovelace,"
check "an answer that is none" unclear 'line 2: found "maybe" in the column "counts"' "bobby,Bob Ross,maybe"
check "yes to nobody" unclear 'line 2: found no student beside "yes", expected one' "bobby,,yes"
check "no to nobody" unclear 'line 2: found no student beside "no", expected one' "bobby,,no"
check "a student to be ignored" unclear 'line 2: found a student beside "ignore", expected none' "bobby,bob,ignore"
check "one entry both ways" unclear 'line 3: line 2 decides about the same entry already' \
    "bobby,bob,yes" "bobby,,ignore"
check "two entries of one student" unclear 'line 3: line 2 gives the same student another entry' \
    "bobby,bob," "spam,bob,yes"
printf 'entry,counts\n' >"$scratch/who.csv"
check "no column of students" exits 2 decided
check "is named" said 'who.csv: line 1: found no column "student"'
who "bobby,bob,"
check "decisions without a list" exits 2 run "$out" --who "$scratch/who.csv"
check "are refused" said "who.csv: found no list of participants beside it, expected LIST="

check "without decisions" exits 1 run "$out" --moodle "$scratch/list.csv"
check "five are to be decided" said "5 to be decided by you"
check "and a file is offered" said "write the student of each of 5 into $out/who.csv"
check "with a line for each, and the reason" test "$(grep -c 'fits no line of the list' "$out/who.csv")" -eq 5
# shellcheck disable=SC2016 # for the inner shell
check "in which no cell is a formula" sh -c '! grep -E "(^|[,;|	])[\" ]*=" "$1"' - "$out/who.csv"
check "and nothing is decided" test "$(grep -c ',"","",' "$out/who.csv")" -eq 5
check "it is offered again as long as nothing is in it" exits 1 \
    run "$out" --moodle "$scratch/list.csv" --who "$out/who.csv"
check "with all of them" test "$(wc -l <"$out/who.csv")" -eq 6

# As an instructor fills it in.
slug=$(sed -n 's/^"\(bobby-[^"]*\)".*/\1/p' "$out/who.csv")
sed -i 's/^\("bobby-[^"]*"\),"","",/\1,"bob@example.org","",/; s/^\("spam-[^"]*"\),"","",/\1,"","ignore",/
    s/^\("carol-2-[^"]*"\),"","",/\1,"Carol Shaw","no",/' "$out/who.csv"
check "a file with decisions that is not given" exits 1 run "$out" --moodle "$scratch/list.csv"
check "is left as it is" said "who.csv: has decisions of yours, so it is not written anew"
check "and still has them" grep -q '"ignore"' "$out/who.csv"
check "given" exits 1 run "$out" --moodle "$scratch/list.csv" --who "$out/who.csv"
check "the last line counts them" said \
    "3 of 7 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 2 left out by you; 2 to be decided by you"
check "an entry is a participant's" entered "Participant 23" bobby 100.00
check "what does not count is not in the way of what does" entered "Participant 24" carol 100.00
check "who is not decided has none" grep -q '^"Participant 25",.*"not entered"' "$out/gradebook.csv"
check "what is left out stands below the list" grep -q '^,,,,,"spam",.*,"ignored, as you decided"$' "$out/gradebook.csv"
check "and so does what does not count" grep -q \
    '^,,,,,"carol-2",.*,"another submission counts, as you decided"$' "$out/gradebook.csv"
check "the file keeps what is decided" grep -q \
    "^\"$slug\",\"bob@example.org\",\"yes\",\"\",\"bobby\",\"decided\"\$" "$out/who.csv"
check "and has what is left" test "$(grep -c ',"","",' "$out/who.csv")" -eq 2
printf 'student,task,points\nParticipant 23,gradient,0\nBob Ross,set_arguments,1\n' >"$scratch/changes.csv"
check "corrections name the participant, by number or name" exits 1 \
    run "$out" --moodle "$scratch/list.csv" --who "$out/who.csv" --changes "$scratch/changes.csv"
check "and are the participant's" entered "Participant 23" bobby 41.00

# All decided; one entry for two.
sed -i 's/^\("team-x-[^"]*"\),"","",\(.*\)/\1,erin,yes,\2\n\1,Participant 26,yes,\2/
    s/^\("1-1-[^"]*"\),"","",/\1,,ignore,/' "$out/who.csv"
check "all decided" exits 0 run "$out" --moodle "$scratch/list.csv" --who "$out/who.csv"
check "nothing is left" said \
    "4 of 7 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 3 left out by you; 0 to be decided by you"
check "of a team both have it" entered "Participant 25" "Team X" 100.00
check "each" entered "Participant 26" "Team X" 100.00
cp "$out/gradebook.csv" "$scratch/before.csv"
check "graded anew" exits 0 run "$out" --moodle "$scratch/list.csv" --who "$out/who.csv" --again 1
check "it is the same" cmp "$scratch/before.csv" "$out/gradebook.csv"
check "a report goes to whom it was decided for" sh -c "'$build/tools/gradebook' feedback --moodle '$scratch/list.csv' \
    --who '$out/who.csv' moodle '$out' && unzip -l '$out/feedback-moodle.zip' | grep -q 'Bob Ross_23_'"

# What is decided and what fits by itself: one of them has to be decided away.
who "bobby,ada,yes"
check "a decision against a name that fits" exits 1 decided
check "enters neither" said \
    'not entered: "bobby": line 2 of the list also fits "Ada Lovelace_21_assignsubmission_file_"'

finish

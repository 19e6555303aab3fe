#!/bin/sh
# Late work (DUE=, LATE=): the time of each submission by what its system writes, and what lateness costs.
#
#     sh tests/suites/lateness.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

all_right

out=$scratch/out
due="2026-11-25 23:59 Europe/Berlin"
late=10%/day,2days
# graded OPTION...: the class anew.
graded() {
    rm -rf "$out"
    run "$out" --due "$due" --late "$late" "$@"
}
# again OPTION...: with the results that are there.
again() { run "$out" "$@"; }
# of NAME FILTER: of a student in gradebook.json, of the attempt that counts.
of() {
    jq -r --arg name "$1" ".students[] | select(.counts and .name == \$name) | $2" "$out/gradebook.json" | paste -s -d ' '
}
# is NAME SCORE SECONDS: what became of a student.
# shellcheck disable=SC2317 # called by check
is() {
    found=$(of "$1" '.score, .late.seconds')
    [ "$found" = "$2 $3" ] || { echo "$1: found $found, expected $2 $3"; return 1; }
}
# open NAME WORDS: has the student no score, as WORDS say nobody knows when it was handed in?
# shellcheck disable=SC2317 # called by check
open() {
    found=$(of "$1" '.score, .late.is_late, .late.unknown')
    [ "$found" = "null false $2" ] || { echo "$1: found $found"; return 1; }
}
# decides ENTRY WORDS: write into the file that the class offers when the entry was handed in.
decides() { sed -i "s/^\(.*\),\"\",\(\"$1\",.*\)/\1,\"$2\",\2/" "$out/who.csv"; }
# entries NAME...: a class of such folders.
entries() {
    rm -rf "$class"
    for entry in "$@"; do
        mkdir -p "$class/$entry" && : >"$class/$entry/gradient.cl"
    done
}

# ---- Moodle's worksheet -------------------------------------------------------------------------------

entries "Ada Lovelace_21_assignsubmission_file_" "Bob Ross_22_assignsubmission_file_" \
    "Carol Shaw_23_assignsubmission_file_" "Dora Day_24_assignsubmission_file_" "Eve Eliot_25_assignsubmission_file_" \
    "Finn Fox_26_assignsubmission_file_"
worksheet() {
    cat >"$scratch/list.csv" <<END
Identifier,"Full name","Email address",Grade,"Last modified (submission)","Feedback comments"
"Participant 21","Ada Lovelace",ada@example.org,,"Wednesday, 25 November 2026, 11:59 PM",
"Participant 22","Bob Ross",bob@example.org,,"Thursday, 26 November 2026, 12:00 AM",
"Participant 23","Carol Shaw",carol@example.org,,"Friday, 27 November 2026, 11:59 PM",
"Participant 24","Dora Day",dora@example.org,,"Saturday, 28 November 2026, 12:00 AM",
"Participant 25","Eve Eliot",eve@example.org,,"Tuesday, 24 November 2026, 8:15 AM",
"Participant 26","Finn Fox",finn@example.org,,"$1",
"Participant 27","Guy Grey",guy@example.org,,-,
END
}
worksheet -
nowhere="nobody knows when it was handed in: only Moodle's grading worksheet (LIST=) can say it"
list="--moodle $scratch/list.csv"
# shellcheck disable=SC2086 # words
check "a class with Moodle's times, of which one is not known" exits 1 graded $list
check "the minute of the deadline is in time" is "Ada Lovelace" 100 0
check "a minute later is a day begun" is "Bob Ross" 90 60
check "two days to the minute are two" is "Carol Shaw" 80 172800
check "a minute more earns nothing" is "Dora Day" 0 172860
check "before it is not late" is "Eve Eliot" 100 0
check "who has no time is to be decided" open "Finn Fox" "$nowhere"
check "the terminal says the zone, and what it cost" said "Due 2026-11-25 23:59 CET: 3 late, 130 points off"
check "of how many nobody knows" said "130 points off, of 1 nobody knows"
check "of whom" said "not entered: \"Finn Fox_26_assignsubmission_file_\": $nowhere"
check "and the last line counts it" said \
    "5 of 6 graded and entered; 1 without submission; 0 passed over; 0 with nothing of this lab; 1 to be decided by you"
check "tasks keep their points" test "$(of "Dora Day" '.points | add')" = 100
check "points before and after" test "$(of "Bob Ross" '.score_before, .late.points_off')" = "100 10"
check "Moodle's column has those after" row "$out" '"Participant 22","Bob Ross","bob@example.org","90.00",'
check "and columns when, how late and what for" grep -q 'Participant 22.*,100,"2026-11-26 00:00:00 +0100","1 min",10,""$' \
    "$out/gradebook.csv"
check "the comment says it" grep -qF 'Late: handed in 2026-11-26 00:00 CET, 1 min late: 10 points off' "$out/gradebook.csv"
check "the page has the three" test \
    "$(grep -c '<td>2026-11-2[678] [0-9:]* CET, .* late</td>' "$out/class.html")" -eq 3
check "and the one of whom nobody knows" grep -q 'id="undecided"' "$out/class.html"
finns='"Participant 26","Finn Fox","finn@example.org",'
check "who gets no grade" grep -qF "$finns\"\",\"-\",\"\"" "$out/upload.csv"
check "and no comment with points" grep -q "^$finns.*,\"$nowhere\"\$" "$out/gradebook.csv"
# shellcheck disable=SC2086 # words
"$build/tools/gradebook" feedback $list --due "$due" --late "$late" folders "$out" >"$scratch/said" 2>&1
check "and no report" said "not given back: Finn Fox: $nowhere"
check "what is to be decided is offered" test "$(sed -n 1p "$out/who.csv"; grep -c . "$out/who.csv")" = \
    "entry,student,counts,handed in,name,reason
2"
decided() {
    # shellcheck disable=SC2086 # words
    again $list --due "$due" --late "$late" --who "$out/who.csv"
}
decides "Finn Fox_26_assignsubmission_file_" "in time"
check "who is decided to be in time" exits 0 decided
check "has all points" is "Finn Fox" 100 0
check "and the file keeps it" grep -q ',"in time",.*,"decided"$' "$out/who.csv"
sed -i s/in\ time/Late/ "$out/who.csv"
check "who is decided to be late" exits 0 decided
check "is one day late" test "$(of "Finn Fox" '.score, .late.is_late')" = "90 true"
sed -i 's/Late/2026-11-27 10:00/' "$out/who.csv"
check "whose time is decided" exits 0 decided
check "is as late as that" is "Finn Fox" 80 122460
sed -i 's/"2026-11-27 10:00"/soon/' "$out/who.csv"
check "what is no time" exits 2 decided
check "is refused" said 'who.csv: line 2: "handed in": found "soon", expected a time such as'
worksheet "mercredi 25 novembre 2026, 23:05"
# shellcheck disable=SC2086 # words
check "a time in another language" exits 1 again $list --due "$due"
check "is none" open "Finn Fox" \
    'line 7 of the list says "mercredi 25 novembre 2026, 23:05", which is no time that the grader can read'
rm "$out/who.csv"
worksheet "Tuesday, 24 November 2026, 8:15 AM"

quick_ends

# ---- More time, and corrections -----------------------------------------------------------------------

cat >"$scratch/changes.csv" <<'END'
student,task,points,comment,until
24,,,ill,2026-11-27
22,gradient,-8,"half of it",
23,gradient,0,,2026-11-20
END
# shellcheck disable=SC2086 # words
check "more time for one" exits 0 again $list --due "$due" --late "$late" --changes "$scratch/changes.csv"
check "a minute after the new day" is "Dora Day" 90 60
check "its page says which" grep -q 'CET, 1 min late <span class="soft">(due 2026-11-27 23:59 CET)' "$out/class.html"
check "first what is corrected, then what lateness costs" is "Bob Ross" 82 60
check "before both stands what the grader gave" test "$(of "Bob Ross" .score_before)" = 100
check "less time is none" is "Carol Shaw" 40 172800
# shellcheck disable=SC2086 # words
check "the reports" exits 0 "$build/tools/gradebook" feedback $list --due "$due" --late "$late" \
    --changes "$scratch/changes.csv" folders "$out"
check "say it to whom it concerns" grep -rqF \
    'This was handed in 2026-11-26 00:00 CET, 1 min late: 10 points off' "$out/feedback"
check "with the score that counts at the top" grep -rqF '<p class="score number">82 <small>of 100 points' "$out/feedback"
"$build/tools/gradebook" feedback --moodle "$scratch/list.csv" folders "$out" >"$scratch/said" 2>&1
check "without DUE and CHANGES they would say other points" said 'found other points than in gradebook.json for 3'
check "and to nobody else" test "$(grep -rlF 'points off' "$out/feedback" | wc -l)" -eq 3
# shellcheck disable=SC2086 # words
check "without a deadline all is as it was" exits 0 again $list
check "and it is said that a run before had one" said "the last run had DUE=, this one has none"
check "nobody is late" test "$(of "Dora Day" '.score, .late')" = "100 null"
# shellcheck disable=SC2086 # words
check "a deadline alone takes no points" exits 0 again $list --due "$due"
check "and shows who was late" test "$(of "Bob Ross" '.score, .late.is_late')" = "100 true"
# shellcheck disable=SC2086 # words
check "in the hall" exits 0 again $list --due "$due" --late "$late" --names no
check "nobody is told who was late" sh -c "! grep -q 'href=\"#late\"' '$out/class-no-names.html'"

# ---- What it costs ------------------------------------------------------------------------------------

# costs LATE POINTS: what Bob, a minute late, and Carol, two days late, have then.
# shellcheck disable=SC2317 # called by check
costs() {
    # shellcheck disable=SC2086 # words
    again $list --due "$due" --late "$1" || return
    found="$(of "Bob Ross" .score) $(of "Carol Shaw" .score)"
    [ "$found" = "$2" ] || { echo "found $found"; return 1; }
}
check "points for each hour" costs 2/hour "98 4"
check "once" costs 20% "80 80"
check "once, up to a day" costs "25,1day" "75 0"
check "nothing" costs 0% "100 100"
check "never less than nothing" costs 60/day "40 0"
check "minutes" costs "1%/minute,30minutes" "99 0"

# Clocks go back on 25 October, and forward on 29 March. Hours are real ones, days the calendar's, and of the two
# moments at which a clock shows the same the first counts.
entries ada bob cy
forth="ada,2026-10-25 01:59
bob,2026-10-25 02:30
cy,2026-10-25 19:30"
due="2026-10-24 20:00 Europe/Berlin" late=2/hour
for lines in "$forth" "$(echo "$forth" | sort -r)"; do
    printf 'Full name,handed in\n%s\n' "$lines" >"$scratch/clocks.csv"
    check "hours over the night in which clocks go back" exits 0 graded --moodle "$scratch/clocks.csv"
    check "are real ones" test "$(of ada .score) $(of bob .score) $(of cy .score)" = "88 86 50"
done
late=1/hour,24hours
check "to a limit in hours" exits 0 again --moodle "$scratch/clocks.csv" --due "$due" --late "$late"
check "they are, too" test "$(of bob .score) $(of cy .score)" = "93 0"
late=1/hour,1day
check "to a limit in days" exits 0 again --moodle "$scratch/clocks.csv" --due "$due" --late "$late"
check "they are not" test "$(of bob .score) $(of cy .score)" = "93 75"
late=10%/day,2days
entries ada bob cy dora
printf 'Full name,handed in\nada,2026-10-25 23:30\nbob,2026-10-26 00:30\ncy,2026-10-25 23:59\ndora,2026-10-26 23:59\n' \
    >"$scratch/clocks.csv"
due="2026-10-24 23:59 Europe/Berlin"
check "a day of 25 hours" exits 0 graded --moodle "$scratch/clocks.csv"
check "is one day" test "$(of ada .score) $(of cy .score) $(of bob .score) $(of dora .score)" = "90 90 80 80"
printf 'Full name,handed in\nada,2026-03-29 23:59\nbob,2026-03-30 00:30\ncy,2026-03-30 23:59\ndora,2026-03-31 00:00\n' \
    >"$scratch/clocks.csv"
due="2026-03-28 23:59 Europe/Berlin"
check "a day of 23 hours" exits 0 graded --moodle "$scratch/clocks.csv"
check "is one, too" test "$(of ada .score) $(of bob .score) $(of cy .score) $(of dora .score)" = "90 80 80 0"
due="2026-11-25 23:59 Europe/Berlin"

# ---- Other systems ------------------------------------------------------------------------------------

rm -rf "$class"
mkdir -p "$class"
touch "$class/lovelaceada_40012_880036_gradient.cl" "$class/rossbob_LATE_40013_880037_gradient.cl" \
    "$class/shawcarol_40014_880038_gradient.cl" "$class/LATE_anon_Ab3dE_880039_gradient.cl"
check "Canvas marks who was late" exits 0 graded
check "that counts as one" test "$(of rossbob '.score, .late.is_late')" = "90 true"
check "the others are in time, as far as Canvas knows" test "$(of lovelaceada '.score, .late.is_late')" = "100 false"
check "and it is said that the time is not known" grep -q 'late, as the course system says' "$out/class.html"
its="Canvas writes no times: 2"
check "the terminal says on what that rests" said "$its without its mark of late work count as in time"
check "and so does the page" grep -qF "$its submissions without its mark of late work count as in time" "$out/class.html"
printf 'student,task,points,comment,until\nrossbob,,,,2026-11-27\nshawcarol,,,,2026-11-27\n' >"$scratch/more.csv"
check "a mark of one who has more time" exits 1 again --due "$due" --late "$late" --changes "$scratch/more.csv"
check "says nothing" open rossbob \
    "Canvas marks it as late, but says no time, and you gave time until 2026-11-27 23:59 CET"
check "no mark says that it was in time" is shawcarol 100 0
mv "$class/rossbob_LATE_40013_880037_gradient.cl" "$class/rossbob_1111_2222_x_LATE_40013_880037_gradient.cl"
check "a name with another number in it is nobody's" exits 1 graded
check "and has no grade, in time or late" test -z "$(of rossbob .score)"

rm "$class"/*
for one in ada:2026-11-25-23-59-59 bob:2026-11-26-00-00-01 cy:2026-11-28-10-00-00; do
    touch "$class/Lab 0_${one%%:*}_attempt_${one#*:}_gradient.cl" "$class/Lab 0_${one%%:*}_attempt_${one#*:}.txt"
done
check "Blackboard's names have times" exits 0 graded
check "in time" is ada 100 0
check "late" is bob 90 61
check "too late" is cy 0 208860

entries "40012-880036 - Ada Lovelace - Nov 25, 2026 1159 PM" "40013-880037 - Bob Ross - Nov 26, 2026 1205 AM" \
    "40014-880038 - Carol Shaw - Nov 24, 2026 905 AM"
check "Brightspace's, too" exits 0 graded
eve="$class/40015-880039 - Eve - Nov 1, 2026 1000 AM - Nov 27, 2026 1000 AM"
mkdir "$eve"
check "a date that is a part of a name" exits 0 graded
check "is not the time" is "Eve - Nov 1, 2026 1000 AM" 80 122460
rmdir "$eve"
touch "$eve - gradient.cl"
check "before a file" exits 1 graded
check "nobody knows which is it" open Eve \
    "nobody knows when it was handed in: its name has two dates, or one in a form that the grader does not know"
rm "$eve - gradient.cl"
mkdir "$class/40012-880040 - Ada Lovelace - Nov 24, 2026 900 AM" "${eve%% - *} - Eve - Nov 20, 2026 900 AM"
touch "$eve - gradient.cl"
check "beside another attempt" exits 1 graded
check "nobody knows which is the last" open Eve "another attempt, of which nobody knows the time, may be later: \"${eve##*/} - gradient.cl\""
check "of two times anybody does" is "Ada Lovelace" 100 0
rm "$eve - gradient.cl"
rmdir "${eve%% - *} - Eve - Nov 20, 2026 900 AM" "$class/40012-880040"*
check "without it" exits 0 graded
check "at noon and at midnight" is "Bob Ross" 90 360
check "one in time" is "Ada Lovelace" 100 0

entries Lovelace_Ada_ada_1234 Ross_Bob_bob_1235 Shaw_Carol_carol_1236
rm "$class"/*/gradient.cl
touch "$class/Lovelace_Ada_ada_1234/20261125235959_17_gradient.cl" \
    "$class/Ross_Bob_bob_1235/20261125100000_18_gradient.cl" \
    "$class/Ross_Bob_bob_1235/20261126080000_19_arguments.c" \
    "$class/Shaw_Carol_carol_1236/20261125100000_20_20291126080000_19_gradient.cl"
check "ILIAS writes them before files" exits 0 graded
check "the last one counts" is Ross_Bob 90 28860
check "not what a student calls a file" is Shaw_Carol 100 0
touch "$class/Ross_Bob_bob_1235/x.cl"
check "a file without one" exits 1 graded
check "may be later" open Ross_Bob \
    "nobody knows when it was handed in: not all of its files have a time, which ILIAS wrote here"
entries Lovelace_Ada_ada_1234 Ross_Bob_bob_1235 Shaw_Carol_carol_1236
mv "$class/Ross_Bob_bob_1235/gradient.cl" "$class/Ross_Bob_bob_1235/Late Submission - gradient.cl"
check "a newer ILIAS writes only a mark" exits 0 graded
check "that counts as one" test "$(of Ross_Bob '.score, .late.is_late')" = "90 true"
check "without it one is in time" test "$(of Lovelace_Ada '.score, .late.is_late')" = "100 false"
check "as far as ILIAS knows" said "ILIAS writes no times: 2 without its mark of late work count as in time"
for mark in Verspaetete Verspätete; do
    mv "$class"/Ross_Bob_bob_1235/* "$class/Ross_Bob_bob_1235/$mark Abgabe - gradient.cl"
    check "in German: $mark" exits 0 graded
    check "that is late, too" test "$(of Ross_Bob '.score, .late.is_late')" = "90 true"
done
mv "$class"/Ross_Bob_bob_1235/* "$class/Ross_Bob_bob_1235/Remise tardive - gradient.cl"
touch "$class/Lovelace_Ada_ada_1234/Lab 0 - x.cl"
mv "$class"/Shaw_Carol_carol_1236/* "$class/Shaw_Carol_carol_1236/20261125100000_20_gradient.cl"
check "what may be a mark in another language, and a time that a student wrote" exits 1 graded
check "leave it open" open Ross_Bob "nobody knows when it was handed in: \"Remise tardive - gradient.cl\" may begin \
with the mark of late work in a language that the grader does not know"
check "and open" open Shaw_Carol "nobody knows when it was handed in: the name of a file begins with 20261125100000, \
which the student may have written"
check "no mark has digits" is Lovelace_Ada 100 0

entries submission_1 submission_2 submission_3
cat >"$class/submission_metadata.yml" <<'END'
submission_1:
  :submitters:
  - :name: Ada Lovelace
    :email: ada@example.org
  :created_at: 2026-11-25 22:59:30.711434000 Z
  :history:
  - :id: 7
    :created_at: 2026-11-29 22:59:30.711434000 Z
submission_2:
  :submitters:
  - :name: Bob Ross
  :created_at: 2026-11-25 15:05:00 -0800
submission_3:
  :submitters:
  - :name: Carol Shaw
  :created_at: soon
END
check "Gradescope's list has a zone of its own" exits 1 graded
check "in time there" is "Ada Lovelace" 100 0
check "late there" is "Bob Ross" 90 360
check "no time there" open "Carol Shaw" 'Gradescope says "soon", which is no time that the grader can read'

entries ada bob cy
# Who hands in a repository may have written its settings.
for one in "ada 2026-11-25T23:30:00+01:00" "bob 2026-11-26T00:30:00+0100" "cy 2026-11-26T00:30:00+0100"; do
    repository="$class/${one%% *}"
    git init -q "$repository" && git -C "$repository" add . && GIT_COMMITTER_DATE=${one#* } git -C "$repository" \
        -c user.name=me -c user.email=me@example.org -c commit.gpgsign=false commit -qm lab &&
        git -C "$repository" config core.fsmonitor "touch $scratch/w/ran; false" &&
        git -C "$repository" config log.showSignature true && git -C "$repository" config gpg.program "touch $scratch/w/ran"
done
rm -rf "$class/cy/.git" && echo "gitdir: $class/bob/.git" >"$class/cy/.git"
check "Git has the commit's, which is the student's" exits 1 graded
commit="the commit that is checked out says"
check "it is shown" open ada "$commit 2026-11-25 23:30 CET, which a student can set"
check "and shown" open bob "$commit 2026-11-26 00:30 CET, which a student can set"
check "a file that leads to another's repository is none" open cy "nothing says when it was handed in"
check "nothing of its settings ran" test ! -e "$scratch/w/ran"
if [ -z "${COURSE_SANDBOX:-}" ]; then
    COURSE_SANDBOX=none run "$out" --due "$due" --late "$late"
    check "without bubblewrap the times stay unknown" said "the times of commits stay unknown"
    check "and everybody's" open bob "nothing says when it was handed in"
fi

entries ada bob
printf 'Full name,handed in\nada,2026-11-26T01:00+01:00\nbob,25.11.2026 23:00\n' >"$scratch/own.csv"
check "a column of one's own" exits 0 graded --moodle "$scratch/own.csv"
check "says who is late" is ada 90 3660
check "and who is not" is bob 100 0
check "nothing of that, and no list" exits 1 graded
check "leaves all to be decided" said "0 of 2 graded; 0 passed over; 0 with nothing of this lab; 2 to be decided by you"
check "with their names" said ': to be decided: "ada": nothing says when it was handed in'
decides ada late
decides bob "25.11.2026 23:00"
check "all decided" exits 0 again --due "$due" --late "$late" --who "$out/who.csv"
check "one is late" test "$(of ada '.score, .late.is_late')" = "90 true"
check "one is in time" is bob 100 0
sed -i 's/"","",\(.*\)"bob"/bob,"",\1"bob"/' "$out/who.csv"
check "whose they are" exits 2 again --due "$due" --who "$out/who.csv"
check "needs a list" said "found whose an entry is, and no list of participants beside it, expected LIST="

# ---- Refused before anything is graded ----------------------------------------------------------------

# refused WORDS OPTION...
# shellcheck disable=SC2317 # called by check
refused() {
    words=$1
    shift
    rm -rf "$out"
    exits 2 run "$out" "$@" && said "$words" && test ! -e "$out/joblog" && test ! -e "$out/gradebook.csv"
}
for text in "2026-11-25" "tomorrow 10:00" "25/11/2026 23:59" "2026-02-30 10:00" ""; do
    [ -z "$text" ] || check "the deadline $text" refused "DUE: found \"$text\"" --due "$text"
done
check "a zone that there is not" refused 'DUE: found the zone "Europe/Bonn"' --due "2026-11-25 23:59 Europe/Bonn"
check "two zones" refused 'DUE: found the zone "UTC UTC"' --due "2026-11-25 23:59 UTC UTC"
for text in 10%/year ten 10%/day,2 10%/day,2days,1 -5/day 101% 10%/day,0days; do
    check "LATE=$text" refused "LATE: found \"$text\", expected whole points or percent" --due "$due" --late "$text"
done
check "LATE without DUE" refused "LATE: found no deadline beside it" --late 10%
entries ada
printf 'Full name,handed in\nada,soon\n' >"$scratch/own.csv"
check "a time of one's own that is none" refused 'line 2: "handed in": found "soon", expected a time such as' \
    --moodle "$scratch/own.csv" --due "$due"

finish

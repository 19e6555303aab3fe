#!/bin/sh
# A class as an instructor grades it: odd names, a run killed at every level and resumed, what
# changed graded again and nothing else, faults of the machinery apart from zeros.
#
#     sh tests/suites/class.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh
. tests/hostile.sh

# n_graded OUTPUT: how many gradings the job log has.
n_graded() { grep -c "tests/class/grading/grade_one.sh" "$1/joblog"; }

# processes OUTPUT: the ids of everything that works for it.
processes() { grep -lsz "^CLASS_FOLDER=$1\$" /proc/[0-9]*/environ | sed 's|/proc/||; s|/environ||'; }

# program OUTPUT WORDS: the id of one of them whose command line holds the words.
program() {
    for process in $(processes "$1"); do
        if tr '\0' ' ' <"/proc/$process/cmdline" 2>/dev/null | grep -q -- "$2"; then
            echo "$process"
            return
        fi
    done
}

# hostile_class OUTPUT: a class of one.
hostile_class() {
    hostile tests/class/grading/grade_class.sh --build "$build" --lab 0 --submissions "$one" --output "$1" \
        >"$scratch/said" 2>&1 </dev/null
}

# ---- Eight submissions --------------------------------------------------------------------------

mkdir "$class"
cp -R solutions/$lab "$class/Ada Lovelace_1234567_assignsubmission_file_"
cp -R labs/$lab "$class/lab-00-bob"
tar -C solutions/$lab -czf "$class/-rf.tar.gz" .
newline='
'
hostile="..$newline.$(printf '\377')<b>\"'&\$(true)"
cp -R labs/$lab "$class/$hostile"
cp -R solutions/$lab "$class/=1+1"
cp -R labs/$lab "$class/carol"
cp -R solutions/$lab "$class/carol-2"
long=$(printf '%0255d' 0)
cp -R solutions/$lab "$class/$long"
"$build/tools/known" put $lab half-pixel "$class/$long"

# ---- Killed and resumed -------------------------------------------------------------------------

first=$scratch/first
n_results() { find "$first/students" -path '*[!w]/key' 2>/dev/null | wc -l; }
results() { [ "$(n_results)" -ge "$1" ]; }
none_left() { [ -z "$(processes "$first")" ]; }
is_at_work() { [ -n "$(program "$first" "$1")" ]; }

run "$first" --seed 5 &
driver=$!
check "some are graded" await results 2
read -r driver_shell <"/proc/$driver/task/$driver/children"
kill -9 "$driver_shell" $driver 2>/dev/null
check "the driver killed: all that it started ends" await none_left
n_kept=$(n_results)
check "there is no gradebook yet" test ! -e "$first/gradebook.csv"

# A signal, as make passes it on.
BUILD=$build make -s --old-file=graded grade-class LAB=0 SUBMISSIONS="$class" OUTPUT="$first" >"$scratch/said" 2>&1 </dev/null &
driver=$!
check "resumed: a grader is at work" await is_at_work tools/grade
check "its folder says whose it is" grep -q '^make grade-class, process [0-9]* on ' "$first/lock"
kill -TERM $driver
wait $driver
check "TERM to make: all that it started has ended" test -z "$(processes "$first")"
check "and the message says what goes on" said 'grade-class: ended by a signal; the same command goes on'
check "and nothing of it is left" test -z "$(ls -A "$TMPDIR")"
check "nor the lock held" flock --nonblock "$first/lock" true

run "$first" &
driver=$!
check "resumed: a grader is at work" await is_at_work tools/grade
# shellcheck disable=SC2046 # one id
kill -9 $(program "$first" "tools/grade --build")
check "a grader killed: GNU parallel is still there" await is_at_work bin/parallel
# shellcheck disable=SC2046
kill -9 $(program "$first" bin/parallel)
wait $driver
ok $? "a grader and GNU parallel killed: the run ends well" "$(cat "$scratch/said")"
check "and tried again" said "again for"
check "each has one row" test "$(wc -l <"$first/gradebook.csv")" -eq 9
check "the seed of the first run still holds" test "$(cat "$first/secret")" = SEED=5
check "and it is said that it can be known" said "all seeds of this class follow from SEED=5"
check "what was graded before was kept ($n_kept)" \
    test "$(n_graded "$first")" -lt 16

# ---- What the files say -------------------------------------------------------------------------

check "Moodle's number" row "$first" '"Ada Lovelace","1234567",1,"graded",100,100,'
check "GitHub Classroom's name" row "$first" '"bob","",1,"graded",0,100,'
check "a name that ends like an attempt's has a row of its own" \
    row "$first" '"carol-2","",1,"graded",100,100,'
check "and a message says so" said 'perhaps one person, each with a row: "carol", "carol-2"'
check "also on the page" grep -q 'id="look-alikes"' "$first/class.html"
check "a formula is none" row "$first" "\"'=1+1\","
check "an option is a name" row "$first" "\"'-rf\","
check "a hostile name" row "$first" '"..\x0A.\xFF<b>""'"'&\$(true)\","
check "the longest name" row "$first" "\"$long\","
check "the last line counts everybody" test "$(tail -n 1 "$scratch/said")" = \
    "8 of 8 graded; 0 passed over; 0 with nothing of this lab; 1 to be decided by you: see $first/class.html"
check "the page is well-formed" xmllint --html --noout "$first/class.html"
check "the page shows no markup of a name" grep -q '&lt;b&gt;&quot;&#39;&amp;' "$first/class.html"
check "a report names the student" grep -q '"submission": "Ada Lovelace",' "$first"/students/ada-*/results.json
check "and no path of this machine" test -z "$(grep -l "$scratch\|$PWD" "$first"/students/*/re*)"
check "the page runs nothing" grep -q "default-src 'none'" "$first/class.html"
# shellcheck disable=SC2016 # for the inner shell
check "every picture and report of the page is there" sh -c 'cd "$1" &&
    grep -o "\(href\|src\)=\"students/[^\"]*" class.html | cut -d "\"" -f 2 | xargs ls -d' - "$first"
# What is decided by a result is in its fields: whatever the words of a message are, "not answered" is no fault.
cp -R "$first" "$scratch/words"
for results in "$scratch"/words/students/*/results.json; do
    jq '.checks[].message |= if . == "" then . else "in other words" end' "$results" >"$scratch/results.json"
    cp "$scratch/results.json" "$results"
done
check "a gradebook of other words" "$build/tools/gradebook" write --nothing blank "$scratch/words"
# section FOLDER ID: of the page of a class.
section() { sed -n "/<h2 [^>]*id=\"$2\"/,/<h2 [^>]*id=/p" "$1/class.html"; }
check "the answers are counted as before" test "$(section "$scratch/words" tasks)" = "$(section "$first" tasks)"
check "what was not answered is no fault" test "$(section "$scratch/words" failures | grep -o '<code class="soft">[^<]*')" = \
    "$(section "$first" failures | grep -o '<code class="soft">[^<]*')"
check "nothing of the kill is left" test -z "$(ls -A "$TMPDIR")$(find "$first/students" -name '*.new')"

# ---- An entry that is made to be looked into for long --------------------------------------------

# Sparse files as large as an archive may be: of all of them together only so much is read, the smallest first.
looked=$scratch/looked
mkdir -p "$looked/submissions/ada"
for i in 1 2 3; do truncate -s 64M "$looked/submissions/ada/$i.bin"; done
cp solutions/$lab/render.c "$looked/submissions/ada/z.c"
content() { printf 'ada\tAda L.\n' | "$build/tools/gradebook" contents "$looked" 2>"$scratch/said"; }
content_before=$(content)
check "large files: whose they are is said" said '"Ada L.": more than 100000 files or 128 MB'
echo >>"$looked/submissions/ada/z.c"
check "and a change of an answer is seen" test "$(content)" != "$content_before"
rm -r "$looked"

quick_ends

# ---- Uninterrupted ------------------------------------------------------------------------------

# Some have options of GNU parallel's in PARALLEL.
export PARALLEL=8
check "an uninterrupted run" exits 0 run "$scratch/second" --seed 5 --jobs 3
unset PARALLEL
for file in gradebook.csv gradebook.json class.html; do
    check "$file is the same to the byte" cmp "$first/$file" "$scratch/second/$file"
done

# ---- What changed, and nothing else -------------------------------------------------------------

before=$(n_graded "$first")
check "again: all is there" exits 0 run "$first"
check "and nothing was graded" test "$(n_graded "$first")" -eq "$before"
cp "$first/gradebook.json" "$scratch/old.json"
grep -h '^ *"seed"' "$first"/students/*/results.json >"$scratch/seeds"
cp solutions/$lab/* "$class/lab-00-bob/"
check "one has changed" exits 0 run "$first" --against "$scratch/old.json"
check "and is graded alone" test "$(n_graded "$first")" -eq $((before + 1))
check "with the new score" row "$first" '"bob","",1,"graded",100,100,'
check "on scenes that no report of the first run has shown" \
    test "$(cat "$first"/students/bob-*/results.json | grep -c -F -f "$scratch/seeds")" -eq 0
# shellcheck disable=SC2016 # for the inner shell
check "the seed in a report is the one that was drawn for it" sh -c 'grep -q "\"seed\": \"$(sed -n "s/^bob-.* //p" "$1/keys")\"" \
    "$1"/students/bob-*/results.json' - "$first"
check "old and new scores are compared" grep -q '0 &rarr; 100' "$first/class.html"
printf '{ "checks":\n[] }\n' >"$(echo "$first"/students/ada-lovelace-*)/results.json"
check "a damaged result does not keep the others from theirs" exits 1 run "$first"
check "and is no zero" row "$first" '"Ada Lovelace","1234567",1,"not graded",,'
check "only the failed" exits 0 run "$first" --only failed
check "they are the damaged one and three below full marks" \
    test "$(n_graded "$first")" -eq $((before + 5))
check "only the latest" exits 0 run "$first" --only latest
check "drops nothing that may be somebody else's" test "$(wc -l <"$first/gradebook.csv")" -eq 9
check "a folder for the results among the submissions" exits 2 run "$class/out"
check "is refused" said "found OUTPUT in SUBMISSIONS"
check "and not made" test ! -e "$class/out"
mkdir -p "$scratch/nested/submissions"
(cd solutions/$lab && zip -q "$scratch/nested/submissions/ada.zip" ./*.c*)
check "submissions in the folder for the results" exits 2 tests/class/grading/grade_class.sh --build "$build" --lab 0 \
    --submissions "$scratch/nested/submissions" --output "$scratch/nested"
check "are refused, and still there" test -s "$scratch/nested/submissions/ada.zip"
echo 02-kdtree-2d-build >"$first/lab"
check "the folder of another lab's class" exits 2 run "$first"
check "is refused, too" said "found a class of 02-kdtree-2d-build, expected a folder of its own for $lab"
echo $lab >"$first/lab"
echo "no submission" >"$class/notes.txt"
check "a file that no name gives to anybody: it could be lost" exits 1 run "$first"
check "is passed over" said 'passed over 1 files, as no name says whose they are, such as "notes.txt"'
check "and counted" said "8 of 8 graded; 1 passed over;"
check "and on the page" grep -q 'id="passed-over".*' "$first/class.html"
rm "$class/notes.txt"
before=$(n_graded "$first")
printf 'Identifier,Grade\n1\n' >"$scratch/no-list.csv"
sed "s/^\"lab\": .*/\"lab\": \"02-kdtree-2d-build\",/" "$first/gradebook.json" >"$scratch/other-lab.json"
check "a list that is none" exits 2 run "$first" --again 1 --moodle "$scratch/no-list.csv"
check "another lab's gradebook to compare with" exits 2 run "$first" --again 1 --against "$scratch/other-lab.json"
check "is named" said "found a gradebook of 02-kdtree-2d-build, expected one of $lab"
check "both before anything is graded" test "$(n_graded "$first")" -eq "$before"
check "another lab is a fault" exits 2 tests/class/grading/grade_class.sh --lab 42 --submissions "$class"

# ---- Moodle and Gradescope ----------------------------------------------------------------------

cat >"$scratch/moodle.csv" <<'END'
Identifier,"Full name","Email address",Status,Grade,"Maximum Grade"
"Participant 1234567","Ada Lovelace",ada@example.org,Submitted,,"50,00"
"Participant 7",Carol,carol@example.org,Submitted,-,50
"Participant 8","Nobody, N.",n@example.org,"No submission",-,50
"Participant 9",Double,bob@example.org,Submitted,,50
"Participant 10",Double,bob@example.org,Submitted,,50
END
check "with Moodle's worksheet, and some that fit nobody" exits 1 run "$first" --moodle "$scratch/moodle.csv"
check "by name and number, with the sheet's maximum and sign" row "$first" \
    '"Participant 1234567","Ada Lovelace","ada@example.org","Submitted","50,00","50,00","Ada Lovelace",'
check "by the mail address, whatever carol-2 handed in" row "$first" \
    '"Participant 7","Carol","carol@example.org","Submitted","0.00","50","carol","",1,"graded",0,'
check "who handed that in has to be found out" \
    said '"carol-2": fits no line of the list, but looks like line 3'
check "who may have handed in nothing has no grade" row "$first" \
    '"Participant 8","Nobody, N.","n@example.org","No submission","-","50",,,,"not entered",'
check "who could be two is neither" row "$first" ',,,,,,"bob",'
check "and they have no grade" row "$first" '"Participant 9","Double","bob@example.org","Submitted","","50",,,,"not entered"'
check "no grade was there before" test -z "$(grep 'already' "$scratch/said")"
check "and a message says so" said '"lab-00-bob": fits 2 lines of the list, among them 5 and 6'

# sheet TITLES LINE: Moodle's worksheet with this line for Ada.
sheet() { printf '%s\n' "$1" "$2" >"$scratch/moodle.csv"; }
head='Identifier;Full name;Grade;Maximum Grade'
sheet "$head" 'Participant 1234567;Ada Lovelace;40.00;1,000.00'
check "a maximum of a thousand, and a grade that is there; others are in no list" exits 1 run "$first" --moodle "$scratch/moodle.csv"
check "is a thousand" row "$first" '"Participant 1234567","Ada Lovelace","1000.00","1,000.00"'
check "and the grade before is told" said 'line 2 has the grade "40.00" already'
sheet "$head" 'Participant 1234567;Ada Lovelace;;100 points'
check "a maximum that is no number" exits 2 run "$first" --moodle "$scratch/moodle.csv"
check "is named with its line" said 'line 2: "Maximum Grade": found the maximum "100 points", expected a number'
sheet 'Identifier;Full name;Note' 'Participant 1234567;Ada Lovelace;'
check "titles in another language" exits 1 run "$first" --moodle "$scratch/moodle.csv"
check "those looked for are named" said 'found no column "Grade" or "Bewertung" to fill'
printf '<!DOCTYPE html><title>Login</title>' >"$scratch/moodle.csv"
check "a login page" exits 2 run "$first" --moodle "$scratch/moodle.csv"
check "is named" said "found a web page, perhaps a login"

gradescope=$scratch/gradescope
mkdir -p "$gradescope/submission_11" "$gradescope/submission_12" "$scratch/names"
cat >"$gradescope/submission_metadata.yml" <<'END'
---
submission_11:
  :submitters:
  - :name: Ada Lovelace
    :sid: '1'
  - :name: "Grace Hopper"
  :score: 3
submission_12:
  :submitters:
  - :name: !ruby/object:Name
  :results:
    output: |
      :submitters:
      - :name: Printed by a student
END
check "Gradescope's export" "$build/tools/gradebook" roster 0 "$gradescope" "$scratch/names"
check "a group has its names" grep -q '"name": "Ada Lovelace & Grace Hopper"' "$scratch/names/roster.json"
check "what is no plain name is not taken" grep -q '"name": "submission_12"' "$scratch/names/roster.json"

# ---- Nothing of this lab ------------------------------------------------------------------------

all=$class
class=$scratch/nothing
mkdir -p "$class/Grace Hopper_2_assignsubmission_onlinetext_" "$class/Joan Clarke_3_assignsubmission_file_" \
    "$class/Mary Shaw_4_assignsubmission_onlinetext_" "$class/Mary Shaw_4_assignsubmission_file_" \
    "$class/Käthe Müller_6_assignsubmission_file_" "$class/Emmy Noether_7_assignsubmission_file_" \
    "$class/Lise Meitner_8_assignsubmission_file_"
printf 'Rar!\032\007' >"$class/Ada Lovelace_1_assignsubmission_file_lab.rar"
echo "<p>my answer</p>" >"$class/Grace Hopper_2_assignsubmission_onlinetext_/onlinetext.html"
cp solutions/01-naive-2d/overlaps_N_Nearer.cl "$class/Joan Clarke_3_assignsubmission_file_/"
echo "see the file" >"$class/Mary Shaw_4_assignsubmission_onlinetext_/onlinetext.html"
cp solutions/$lab/*.c* "$class/Mary Shaw_4_assignsubmission_file_"
printf '%%PDF' >"$scratch/Lösung Übung.pdf"
zip -q -j "$class/Käthe Müller_6_assignsubmission_file_/für 00.zip" "$scratch/Lösung Übung.pdf"
for file in $(jq -r '.files[]' solutions/$lab/lab.json); do
    printf '\n \n' >"$class/Emmy Noether_7_assignsubmission_file_/$file"
done
# An empty zip has the mark of its end only.
{ printf 'PK\005\006' && head -c 18 /dev/zero; } >"$class/Lise Meitner_8_assignsubmission_file_/00.zip"
cat >"$scratch/nothing.csv" <<'END'
Identifier,"Full name",Grade,"Feedback comments"
"Participant 1","Ada Lovelace",,
"Participant 2","Grace Hopper",,
"Participant 3","Joan Clarke",,
"Participant 4","Mary Shaw",,
"Participant 5","Jean Jennings",,
"Participant 6","Käthe Müller",,
"Participant 7","Emmy Noether",,
"Participant 8","Lise Meitner",,
END
without=$scratch/nothing.out
check "an archive that is none, a text, other files, files with nothing in them, an empty archive" exits 0 run "$without" --moodle "$scratch/nothing.csv"
check "are counted" said "1 of 8 graded and entered; 1 without submission; 0 passed over; 6 with nothing of this lab; 1 earlier attempts; 0 to be decided by you"
for name in "Ada Lovelace" "Grace Hopper" "Joan Clarke" "Käthe Müller" "Emmy Noether" "Lise Meitner"; do
    check "$name: no zero, but a blank" grep -q "^\"Participant .\",\"$name\",\"\",.*,\"$name\",\".\",1,\"nothing of this lab\",,," \
        "$without/gradebook.csv"
done
check "a text beside files is another attempt" grep -q '^"Participant 4","Mary Shaw","100.00",' "$without/gradebook.csv"
# shellcheck disable=SC2016 # for the inner shell
check "they stand first on the page" sh -c 'tr "\n" " " <"$1" | grep -q "</header> <h2 class=\"section\" id=\"nothing\">"' \
    - "$without/class.html"
check "with what was found instead" grep -q "RAR archive" "$without/class.html"
umlauts='the archive holds &quot;Lösung Übung.pdf&quot;'
check "umlauts of a file's name are on the page" grep -qF "$umlauts" "$without/class.html"
check "in the report" grep -qF "$umlauts" "$without"/students/k*/report.html
check "in the comment" grep -qF '"nothing of this lab was found: the archive holds ""Lösung Übung.pdf"""' \
    "$without/upload.csv"
check "and in the terminal" said 'Käthe Müller: the archive holds "Lösung Übung.pdf"'
check "the page is well-formed" xmllint --html --noout "$without/class.html"
check "each result has a field for it" test "$(grep -l '"nothing_of_lab": true' "$without"/students/*/results.json | wc -l)" -eq 7
before=$(n_graded "$without")
check "NOTHING=0" exits 0 run "$without" --moodle "$scratch/nothing.csv" --nothing 0
check "is a zero in the list" grep -q '^"Participant 1","Ada Lovelace","0.00",.*,"Ada Lovelace","1",1,"nothing of this lab",0,100,' \
    "$without/gradebook.csv"
check "and grades nothing again" test "$(n_graded "$without")" -eq "$before"
check "anything else is refused" exits 2 run "$without" --nothing maybe
class=$all

# ---- What the caller's environment holds ------------------------------------------------------------

one=$scratch/one
mkdir "$one"
cp -R solutions/$lab "$one/ada"
check "variables of a hostile environment: all are graded" exits 0 hostile_class "$scratch/hostile-class"
check "and right ones get full marks" row "$scratch/hostile-class" '"ada","",1,"graded",100,'

# ---- Faults of the machinery --------------------------------------------------------------------

# A grader that fails for some: by itself, by a signal, by never ending; and for one only at first.
# shellcheck disable=SC2016 # for the other shell
stub "$(echo "$first"/students/rf-*)" "SCRATCH='$scratch'"'
# meet: wait for the other one, and see whether what was laid down is still there.
meet() {
    : >"$TMPDIR/mine"
    : >"$SCRATCH/here-${submission##*/}"
    until [ -e "$SCRATCH/here-meets-a-1" ] && [ -e "$SCRATCH/here-meets-b-1" ]; do sleep 0.05; done
    [ -e "$TMPDIR/mine" ] || exit 2
}
case $submission in
*/fails-*) echo "no sandbox" >&2; exit 2 ;;
*/dies-*) kill -9 $$ ;;
*/hangs-*) sleep 1000 ;;
*/meets-*) meet ;;
*/twice-*) [ -e "$SCRATCH/seen" ] || { : >"$SCRATCH/seen"; exit 2; } ;;
esac'
class=$scratch/faults
mkdir "$class"
for name in fails dies twice well; do cp -R labs/$lab "$class/$name"; done
faults=$scratch/third
check "some cannot be graded: status 1" exits 1 run "$faults" --jobs 4
check "a fault is no zero" row "$faults" '"fails","",1,"not graded",,,,,,,"the grader could not work'
check "nor is a death" row "$faults" '"dies","",1,"not graded",,,,,,,"the grader was killed by signal 9"'
check "a passing fault is tried again" row "$faults" '"twice","",1,"graded",100,'
check "the others are graded" row "$faults" '"well","",1,"graded",100,'
check "three times each" test "$(n_graded "$faults")" -eq 9
check "and they stand apart on the page" grep -q 'id="not-graded"' "$faults/class.html"
check "and in what it says" said "not graded: fails: the grader could not work"
check "the reason is kept" grep -q "no sandbox" "$(echo "$faults"/logs/fails-*)"
check "and shown, once for each reason" said "    no sandbox"
rm -r "$class/fails" "$class/dies"
check "without them all is well" exits 0 run "$faults"
# For itself, as no limit but that of two hours is long enough for the others, however busy the machine is.
mkdir "$scratch/endless"
cp -R labs/$lab "$scratch/endless/hangs"
class=$scratch/endless
export CLASS_SECONDS=1
check "what has no end cannot be graded" exits 1 run "$scratch/fourth"
unset CLASS_SECONDS
check "and is no zero" row "$scratch/fourth" '"hangs","",1,"not graded",,,"the grader took longer than 1 s"'
check "after three tries" test "$(n_graded "$scratch/fourth")" -eq 3
class=$scratch/faults

# Whatever decides on points has a part in the keys: each program, and each folder beside them.
course=$scratch/course
mkdir -p "$course/tests"
cp -R labs solutions common kernels "$course"
cp -R tests/probes tests/stubs tests/class "$course/tests"
regraded() {
    before=$(n_graded "$faults")
    (cd "$course" && run "$faults") || { cat "$scratch/said"; return 1; }
    [ "$(n_graded "$faults")" -eq $((before + $1)) ]
}
check "the same course elsewhere: nothing is graded" regraded 0
mkdir "$fake/judges"
for program in "judges/$lab" tools/unpack tools/grade; do
    echo '# changed' >>"$fake/$program"
    check "another $program: all are graded again" regraded 2
done
for folder in labs solutions common kernels tests/probes tests/stubs; do
    : >"$course/$folder/changed"
    check "a change in $folder: all are graded again" regraded 2
done

# Files that a full disk, or a crash of the machine, has emptied.
for file in engine lab gradebook.json; do
    : >"$faults/$file"
    check "$file is empty: nothing is graded again" regraded 0
done
: >"$faults/rounds"
check "rounds is empty: all is in a new round" regraded 2
for file in key results.json; do
    for path in "$faults"/students/well-*/"$file"; do : >"$path"; done
    check "$file is empty: its entry is graded again" regraded 1
done

# A class folder without room: as in a sandbox, in a file system of its own.
# full MB: a run in a folder with room for three small files, and then in the same with so much.
full() {
    # shellcheck disable=SC2016 # for the inner shell
    unshare -rm sh -c 'mkdir "$1/full" && mount -t tmpfs -o size="$2"m room "$1/full" || exit
        head -c "$(($2 * 1048576 - 12288))" /dev/zero >"$1/full/other"
        shift 2
        first=0 then=0
        "$@" >"${0}.1" 2>&1 </dev/null || first=$?
        rm "$scratch/full/other"
        "$@" >"$0" 2>&1 </dev/null || then=$?
        echo "$first $then"' "$scratch/said" "$scratch" "$1" \
        tests/class/grading/grade_class.sh --build "$build" --lab 0 --submissions "$class" --output "$scratch/full"
}
export scratch
if unshare -rm mount -t tmpfs room "$scratch/w" 2>/dev/null; then
    check "without room: no gradebook; with room it goes on" test "$(full 1)" = "2 0"
    check "and says what is full, and where" grep -q 'full/.*No space left' "$scratch/said.1"
else
    skip "a class folder without room" "it needs user namespaces"
fi

# Two at work whose slugs end alike: each in a folder of its own.
two=$scratch/two
mkdir -p "$two/students" "$two/logs" "$two/faults" "$two/pending"
for slug in meets-a-1 meets-b-1; do echo "$slug key 1"; done >"$two/keys"
: >"$two/names"
for slug in meets-a-1 meets-b-1; do
    CLASS_FOLDER=$two CLASS_BUILD=$build CLASS_LAB=$lab CLASS_WORK=$TMPDIR/two CLASS_DEVICE='' \
        CLASS_TIME_LIMIT='' CLASS_TELLS='' CLASS_SECONDS=7200 tests/class/grading/grade_one.sh $slug &
done
wait
for slug in meets-a-1 meets-b-1; do
    check "$slug keeps its files while another works" test -e "$two/students/$slug/key"
done

finish

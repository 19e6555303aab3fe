#!/bin/sh
# A class as an instructor grades it: odd names, a run killed at every level and resumed, what
# changed graded again and nothing else, faults of the machinery apart from zeros.
#
#     sh tests/suites/class.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac

# Where the graders work; what is left there is seen at the end.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/w"
export TMPDIR="$scratch/w"
class=$scratch/class
lab=00-hello-pixels
wrong_file=$PWD/tests/mutants/$lab/half-pixel.cl

# run OUTPUT OPTION...: the driver, with its messages in $scratch/said.
run() {
    output=$1
    shift
    tests/class/grade_class.sh --build "$build" --lab 0 --submissions "$class" --output "$output" "$@" \
        >"$scratch/said" 2>&1 </dev/null
}

# exits STATUS COMMAND...
exits() {
    wanted=$1 status=0
    shift
    "$@" || status=$?
    [ "$status" -eq "$wanted" ] || { echo "found exit status $status"; cat "$scratch/said"; return 1; }
}

# said WORDS: did the last run say so?
# shellcheck disable=SC2317 # called by check
said() { grep -qF -- "$1" "$scratch/said" || { cat "$scratch/said"; return 1; }; }

# n_graded OUTPUT: how many gradings the job log has.
n_graded() { grep -c "tests/class/grade_one.sh" "$1/joblog"; }

# row OUTPUT TEXT: does a row of the CSV begin so?
row() { text=$2 awk 'index($0, ENVIRON["text"]) == 1 { n++ } END { exit n != 1 }' "$1/gradebook.csv" ||
    { cat "$1/gradebook.csv"; return 1; }; }

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
"$build/tools/holes" fill solutions/$lab/gradient.cl gradient "$wrong_file" >"$class/$long/gradient.cl"
echo "no submission" >"$class/notes.txt"

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
check "the seed of the first run still holds" test "$(cat "$first/seed")" = 5
check "what was graded before was kept ($n_kept)" \
    test "$(n_graded "$first")" -lt 16

check "an uninterrupted run" exits 0 run "$scratch/second" --seed 5 --jobs 3
for file in gradebook.csv gradebook.json class.html; do
    check "$file is the same to the byte" cmp "$first/$file" "$scratch/second/$file"
done

# ---- What the files say -------------------------------------------------------------------------

check "Moodle's number" row "$first" '"Ada Lovelace","1234567",1,"graded",100,100,'
check "GitHub Classroom's name" row "$first" '"bob","",1,"graded",0,100,'
check "a name that ends like an attempt's has a row of its own" \
    row "$first" '"carol-2","",1,"graded",100,100,'
check "and the instructor is told" said 'perhaps one person, each with a row: "carol", "carol-2"'
check "also on the page" grep -q 'id="look-alikes"' "$first/class.html"
check "a formula is none" row "$first" "\"'=1+1\","
check "an option is a name" row "$first" "\"'-rf\","
check "a hostile name" row "$first" '"..\x0A.\xFF<b>""'"'&\$(true)\","
check "the longest name" row "$first" "\"$long\","
check "a file that is no submission is passed over" said "passed over 1 files"
check "the page is well-formed" xmllint --html --noout "$first/class.html"
check "the page shows no markup of a name" grep -q '&lt;b&gt;&quot;&#39;&amp;' "$first/class.html"
check "the page runs nothing" grep -q "default-src 'none'" "$first/class.html"
# shellcheck disable=SC2016 # for the inner shell
check "every picture and report of the page is there" sh -c 'cd "$1" &&
    grep -o "\(href\|src\)=\"students/[^\"]*" class.html | cut -d "\"" -f 2 | xargs ls -d' - "$first"
check "nothing of the kill is left" test -z "$(ls -A "$TMPDIR")$(find "$first/students" -name '*.new')"

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
check "old and new scores are compared" grep -q '0 &rarr; 100' "$first/class.html"
echo '{' >"$(echo "$first"/students/ada-lovelace-*)/results.json"
check "a damaged result does not keep the others from theirs" exits 1 run "$first"
check "and is no zero" row "$first" '"Ada Lovelace","1234567",1,"not graded",,'
check "only the failed" exits 0 run "$first" --only failed
check "they are the damaged one and three below full marks" \
    test "$(n_graded "$first")" -eq $((before + 5))
check "only the latest" exits 0 run "$first" --only latest
check "drops nothing that may be somebody else's" test "$(wc -l <"$first/gradebook.csv")" -eq 9
check "another lab is a fault" exits 2 tests/class/grade_class.sh --lab 42 --submissions "$class"

# ---- Moodle and Gradescope ----------------------------------------------------------------------

cat >"$scratch/moodle.csv" <<'END'
Identifier,"Full name","Email address",Status,Grade,"Maximum Grade"
"Participant 1234567","Ada Lovelace",ada@example.org,Submitted,,"50,00"
"Participant 7",Carol,carol@example.org,Submitted,-,50
"Participant 8","Nobody, N.",n@example.org,"No submission",-,50
"Participant 9",Double,bob@example.org,Submitted,,50
"Participant 10",Double,bob@example.net,Submitted,,50
END
check "with Moodle's worksheet" exits 0 run "$first" --moodle "$scratch/moodle.csv"
check "by name and number, with the sheet's maximum and sign" row "$first" \
    '"Participant 1234567","Ada Lovelace","ada@example.org","Submitted","50,00","50,00","Ada Lovelace",'
check "by the mail address, whatever carol-2 handed in" row "$first" \
    '"Participant 7","Carol","carol@example.org","Submitted","0.00","50","carol","",1,"graded",0,'
check "who handed that in has to be found out" \
    said '"carol-2": fits no line of the list, but looks like line 3'
check "who handed in nothing has no grade" row "$first" \
    '"Participant 8","Nobody, N.","n@example.org","No submission","-","50",,,,"no submission",'
check "who could be two is neither" row "$first" ',,,,,,"bob",'
check "and they have no grade" row "$first" '"Participant 9","Double","bob@example.org","Submitted","","50",,,,"not entered"'
check "and the instructor is told" said '"lab-00-bob": fits 2 lines of the list, among them 5 and 6'

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

# ---- Faults of the machinery --------------------------------------------------------------------

# A grader that fails for some: by itself, by a signal, by never ending; and for one only at first.
fake=$scratch/fake
right=$(echo "$first"/students/rf-*)
mkdir -p "$fake/tools"
ln -s "$build/tools/gradebook" "$fake/tools"
ln -s "$build/probes" "$build/earlier" "$build/libcommon.a" "$fake"
cat >"$fake/tools/grade" <<END
#!/bin/sh
while [ "\$1" != --submission ]; do shift; done
output=\$4
# meet: wait for the other one, and see whether what was laid down is still there.
meet() {
    : >"\$TMPDIR/mine"
    : >"$scratch/here-\${2##*/}"
    until [ -e "$scratch/here-meets-a-1" ] && [ -e "$scratch/here-meets-b-1" ]; do sleep 0.05; done
    [ -e "\$TMPDIR/mine" ] || exit 2
}
case \$2 in
*/fails-*) echo "no sandbox" >&2; exit 2 ;;
*/dies-*) kill -9 \$\$ ;;
*/hangs-*) sleep 1000 ;;
*/meets-*) meet "\$@" ;;
*/twice-*) [ -e "$scratch/seen" ] || { : >"$scratch/seen"; exit 2; } ;;
esac
cp -R "$right/." "\$output"
END
chmod +x "$fake/tools/grade"
class=$scratch/faults
mkdir "$class"
for name in fails dies hangs twice well; do cp -R labs/$lab "$class/$name"; done
build=$fake
faults=$scratch/third
# Enough for a copy on a busy machine; three times over it is waited for what hangs.
CLASS_SECONDS=10
export CLASS_SECONDS
check "some cannot be graded: status 1" exits 1 run "$faults" --jobs 5
check "a fault is no zero" row "$faults" '"fails","",1,"not graded",,,,,,,"the grader could not work'
check "nor is a death" row "$faults" '"dies","",1,"not graded",,,,,,,"the grader was killed by signal 9"'
check "nor is no end" row "$faults" '"hangs","",1,"not graded",,,,,,,"the grader took longer than 10 s"'
check "a passing fault is tried again" row "$faults" '"twice","",1,"graded",100,'
check "the others are graded" row "$faults" '"well","",1,"graded",100,'
check "three times each" test "$(n_graded "$faults")" -eq 12
check "and they stand apart on the page" grep -q 'id="not-graded"' "$faults/class.html"
check "and in what it says" said "not graded: fails: the grader could not work"
check "the reason is kept" grep -q "no sandbox" "$(echo "$faults"/logs/fails-*)"
rm -r "$class/fails" "$class/dies" "$class/hangs"
check "without them all is well" exits 0 run "$faults"

# Two at work whose slugs end alike: each in a folder of its own.
two=$scratch/two
mkdir -p "$two/students" "$two/logs" "$two/faults" "$two/pending"
for slug in meets-a-1 meets-b-1; do
    CLASS_FOLDER=$two CLASS_BUILD=$fake CLASS_LAB=$lab CLASS_WORK=$TMPDIR/two CLASS_DEVICE='' \
        CLASS_TIME_LIMIT='' CLASS_TELLS='' tests/class/grade_one.sh $slug key 1 &
done
wait
for slug in meets-a-1 meets-b-1; do
    check "$slug keeps its files while another works" test -e "$two/students/$slug/key"
done

# ---- Who is who in Moodle's list ----------------------------------------------------------------

# lists NAME FILE ENTRY...: grade a class of such entries (with the grader above) by a list.
lists() {
    class=$scratch/$1
    list=$2
    shift 2
    mkdir "$class"
    for entry; do
        case $entry in *.zip) : >"$class/$entry" ;; *) mkdir "$class/$entry" ;; esac
    done
    [ ! -e "$class.yml" ] || cp "$class.yml" "$class/submission_metadata.yml"
    check "by the list of ${class##*/}" exits 0 run "$class.out" --moodle "$list"
}

# has PARTICIPANT NAME: is the entry of this name beside the participant of the list?
# "": has the participant handed in nothing? "-": something that may be another's?
# shellcheck disable=SC2317 # called by check
has() {
    case $2 in
    '') words=',"",,,,"no submission"' ;;
    -) words=',"",,,,"not entered"' ;;
    *) words=",\"100.00\",\"$2\"," ;;
    esac
    grep "^\"$1\"," "$class.out/gradebook.csv" | grep -qF -- "$words" && return
    cat "$class.out/gradebook.csv"
    return 1
}

# Moodle: a number of a team is no student's; two of one name are told apart by theirs.
cat >"$scratch/numbers.csv" <<'END'
Identifier,"Full name","Email address",Status,Grade
"Participant 7","Carol Shaw",carol@example.org,Submitted,
"Participant 21","Ada Lovelace",a1@example.org,Submitted,
"Participant 22","Ada Lovelace",a2@example.org,Submitted,
"Participant 30","Sean O'Brien",sean@example.org,Submitted,
"Participant 31","Joan Clarke",joan@example.org,Submitted,
"Participant 12","Grace Hopper",grace@example.org,Submitted,
"Participant 40","Mary Shaw",Mary.Shaw@Example.org,Submitted,
"Participant 41","Jean Jennings",jean@example.org,Submitted,
END
lists numbers "$scratch/numbers.csv" "Group A_7_assignsubmission_file_" \
    "Ada Lovelace_22_assignsubmission_file_" "Sean OBrien_30_assignsubmission_file" \
    "Joan Clarke_99_assignsubmission_file_" "Participant_12_assignsubmission_file_" \
    "mary.shaw@example.org" submission_41
check "a team's number is nobody's" has "Participant 7" ""
check "and the team is told of" said '"Group A_7_assignsubmission_file_": fits no line of the list'
check "of two of one name the number decides" has "Participant 22" "Ada Lovelace"
check "and the other has no grade" has "Participant 21" ""
check "a name as Moodle puts it into file names" has "Participant 30" "Sean OBrien"
check "one of another number is nobody's" has "Participant 31" ""
check "and is told of" said 'line 6 of the list has another number than 99'
check "a number alone only as Participant N" has "Participant 12" "Participant"
check "an address in other letters" has "Participant 40" "mary.shaw@example.org"
check "a submission's number is nobody's" has "Participant 41" ""
check "and stands below the list, with the reason" \
    grep -q '^,,,,,"submission_41",.*,"fits no line of the list"$' \
    "$class.out/gradebook.csv"

# Teams, as Moodle gives them: a column of groups, and folders that begin with a group's name.
cat >"$scratch/teams.csv" <<'END'
Identifier,"Full name",Username,Group,Grade
"Participant 1",Ada,ada,"Team 1",
"Participant 2",Grace,grace,"Team 1",
"Participant 3",Carol,carol,"Team 1-2",
"Participant 4",Joan,joan,"Default group",
"Participant 5",Mary,mary,carol,
"Participant 6",Jean,jean,"Team_3",
END
lists teams "$scratch/teams.csv" "Team 1_3_assignsubmission_file_" \
    "Team 1-2_4_assignsubmission_file_" "Default group_assignsubmission_file_" \
    "carol_9_assignsubmission_file_" "Team 3_2_assignsubmission_file_lab.zip" \
    "Team 3_2_assignsubmission_onlinetext_"
for participant in "Participant 1" "Participant 2"; do
    check "a team's points for $participant" has "$participant" "Team 1"
done
check "a group's name may end like an attempt's" has "Participant 3" "Team 1-2"
check "those without a group are one" has "Participant 4" "Default group"
check "a group that is called like a student is nobody's" has "Participant 5" -
check "and is told of" said '"carol_9_assignsubmission_file_": is a group of the list and also fits its line 4'
check "a file and a text are one entry, an underscore is a blank" has "Participant 6" "Team 3"

# A file and a text are one entry only where Moodle says so: here somebody else chose a name.
lists forged "$scratch/teams.csv" "Team 3_2_assignsubmission_file_" \
    "Team 3_2_assignsubmission_onlinetext_" "Team 3"
check "a name that is made like Moodle's takes nothing over" has "Participant 6" -
check "and is told of" said 'line 7 of the list also fits "Team 3_2_assignsubmission_file_"'
check "and so is why" said 'not only Moodle'"'"'s export, as "Team 3" is not'
# A student's name in Moodle may hold Moodle's pattern.
lists pattern "$scratch/teams.csv" "Team 3_2_assignsubmission_file_" \
    "Team 3_2_assignsubmission_onlinetext_" "Ada_1_assignsubmission_file__9_assignsubmission_file_"
check "a name with Moodle's pattern is nobody else's" has "Participant 1" ""
check "and takes nothing from the others" has "Participant 6" "Team 3"

# Teams and pairs, as Gradescope gives them.
cat >"$scratch/pairs.yml" <<'END'
---
submission_1:
  :submitters:
  - :name: Ada Lovelace
    :sid: '4711'
    :email: ada@example.org
  - :name: Grace Hopper
    :sid: '4712'
    :email: GRACE@example.org
  :created_at: 2026-11-21 10:00:00.000000000 Z
submission_2:
  :submitters:
  - :name: Ada Lovelace
    :sid: '4799'
    :email: ada2@example.org
submission_3:
  :submitters:
  - :name: Joan Clarke
    :email: j.clarke@example.com
submission_4:
  :submitters:
  - :email: mary@example.org
    :sid: '4713'
    :name: Somebody Else
submission_5:
  :submitters:
  - :name: Jean Jennings
    :email: jean@example.org
submission_6:
  :submitters:
  - :name: Jean Jennings
    :email: jean@example.org
  - :name: Carol Shaw
    :sid: '4714'
submission_7:
  :submitters:
  - :name: Team-2
    :email: team2@example.org
END
cat >"$scratch/pairs.csv" <<'END'
Identifier,"Full name","ID number","Email address",Grade
"Participant 1","Ada Lovelace",4711,ada@example.org,
"Participant 2","Grace Hopper",,grace@example.org,
"Participant 3","Joan Clarke",,joan@example.org,
"Participant 4","Mary Shaw",4713,m.shaw@example.org,
"Participant 5","Jean Jennings",,jean@example.org,
"Participant 6","Carol Shaw",4714,,
"Participant 8","Team",,team@example.org,
END
lists pairs "$scratch/pairs.csv" submission_1 submission_2 submission_3 submission_4 \
    submission_5 submission_6 submission_7
for participant in "Participant 1" "Participant 2"; do
    check "a pair's points for $participant" has "$participant" "Ada Lovelace & Grace Hopper"
done
check "a name alone is not enough against an address" has "Participant 3" ""
check "and is told of" \
    said '"submission_3": "Joan Clarke": line 4 of the list has another e-mail address or number'
check "the university's number is enough" has "Participant 4" "Somebody Else"
check "who is in two teams has the points of neither" has "Participant 5" -
check "and is told of" said 'line 6 of the list also fits "submission_6"'
check "the other of the team has them" has "Participant 6" "Jean Jennings & Carol Shaw"
check "a name that ends like an attempt's is not cut" has "Participant 8" ""

# ---- Whose grade it is --------------------------------------------------------------------------

# Names that somebody chose to get another's grade, to spoil it, or to break the run.
cat >"$scratch/whose.csv" <<'END'
Identifier,"Full name","Email address",Username,Grade
"Participant 1","Carol Shaw",c.shaw@example.org,carol,
"Participant 2","Bob Ross",bob@example.org,bob,
"Participant 3","=1+1;＝2",b2@example.org,bob-2,
"Participant 4","Dora",dora@example.org,dora,
"Participant 5","Erin",erin@example.org,erin,
"Participant 6","Frank",frank@example.org,frank,
"Participant 7","Gina",gina@example.org,gina,
"Participant 8","Hanna Müller",hm@example.org,hm,
"Participant 9","Judy",judy@example.org,judy,
END
cyrillic=$(printf 'c\320\260rol')
decomposed=$(printf 'Hanna Mu\314\210ller')
escape=$(printf 'frank\033[2J')
widthless=$(printf 'fra\342\200\213nk')
full_width=$(printf '\357\274\235HYPERLINK(1)')
twin=$(printf '%0254d' 0)
# shellcheck disable=SC2016 # a name
lists whose "$scratch/whose.csv" carol carol-2 "carol (3)" lab-00-carol-4 "$cyrillic" bob bob-2 \
    dora dora.zip erin lab-00-erin frank "frank " frank. "frank$newline" 'frank\x0A' "$escape" \
    "$widthless" gina GINA "Hanna Müller" "$decomposed" judy "Participant 9" "${twin}a" "${twin}b" \
    gradebook.csv students roster.json lock -- --moodle -n ... '*' '$(exit)' '%s%n' '~' \
    'x;=1+1;b' "$full_width" ada-76651 ada-117211 3d submission_metadata.yml
check "the grade of carol is that of carol, not of carol-2 nor of carol (3)" row "$class.out" \
    '"Participant 1","Carol Shaw","c.shaw@example.org","carol","100.00","carol","",1,"graded"'
check "a participant called bob-2 has the grade of bob-2" has "Participant 3" bob-2
check "and bob his own" has "Participant 2" bob
for attack in carol-2 "carol (3)" lab-00-carol-4 "$cyrillic"; do
    check "$attack: no participant, and like one" \
        said "\"$attack\": fits no line of the list, but looks like line 2"
done
check "carol is listed with all that look like her" said \
    "perhaps one person, each with a row: \"carol\", \"carol (3)\", \"carol-2\", \"lab-00-carol-4\", \"$cyrillic\""
for participant in "Participant 4" "Participant 5" "Participant 7" "Participant 9"; do
    check "$participant, whose name two have handed in under: entered for neither" \
        has "$participant" -
done
check "an archive and a folder of one name are told of" \
    said '"dora.zip": line 5 of the list also fits "dora"'
check "a repository and a folder, too" said '"lab-00-erin": line 6 of the list also fits "erin"'
check "other letters' size, too" said '"gina": line 8 of the list also fits "GINA"'
check "a number of the list as a name, too" \
    said '"judy": line 10 of the list also fits "Participant 9"'
check "blanks, dots and what cannot be seen make another name" has "Participant 6" frank
for attack in "frank " frank. 'frank\x0A' 'frank\x5Cx0A' 'frank\x1B[2J' 'fra\xE2\x80\x8Bnk'; do
    check "$attack: told of" said "\"$attack\": fits no line of the list"
done
check "accents that are written apart make another name" has "Participant 8" "Hanna Müller"
check "and are told of" said "\"$decomposed\": fits no line of the list, but looks like line 9"
check "every entry has its row" \
    test "$(grep -c '"students/[^"]*/report.html"' "$class.out/gradebook.csv")" -eq 44
check "and its folder" test "$(find "$class.out/students" -mindepth 1 -maxdepth 1 | wc -l)" -eq 44
check "a name is no file of the driver's" test -f "$class.out/gradebook.csv"
# shellcheck disable=SC2016 # for the inner shell
check "no cell is a formula wherever it is parted" sh -c \
    '! grep -E "(^|[,;|	])[\" ]*(=|[+@]|＝|＋|－|＠)" "$1"' - "$class.out/gradebook.csv"
check "the page is well-formed" xmllint --html --noout "$class.out/class.html"
slug=$(basename "$class.out"/students/carol-????????????????)
mkdir "$class/$slug"
check "only the latest, and an entry called like the slug of carol's" \
    exits 0 run "$class.out" --moodle "$scratch/whose.csv" --only latest
check "every entry still has its row" \
    test "$(grep -c '"students/[^"]*/report.html"' "$class.out/gradebook.csv")" -eq 45
check "carol her own files" test -e "$class.out/students/$slug/key"
check "and the grade" has "Participant 1" carol

# What is neither a folder nor a file waits for nobody and leads nowhere.
class=$scratch/kinds
mkdir -p "$class/carol"
mkfifo "$class/pipe" "$class/submission_metadata.yml"
ln -s carol "$class/carol-2"
check "a pipe and a link to another's folder" exits 1 run "$class.out"
for name in pipe carol-2 submission_metadata.yml; do
    check "$name is not graded" row "$class.out" "\"$name\",\"\",1,\"not graded\","
done
check "carol is" row "$class.out" '"carol","",1,"graded",100,'

# Names in Gradescope's list are their owners' choice, too: long ones must not cost all the others.
class=$scratch/long
mkdir -p "$class/submission_1" "$class/submission_2"
wide=$(printf '%084d' 0 | sed 's/0/名/g')
cat >"$class/submission_metadata.yml" <<END
submission_1:
  :submitters:
$(for i in 1 2 3 4 5; do echo "  - :name: $i$wide"; done)
submission_2:
  :submitters:
  - :name: Ada
END
check "long names of a large team" exits 0 run "$class.out"
check "the others have their rows" row "$class.out" '"Ada",'

finish

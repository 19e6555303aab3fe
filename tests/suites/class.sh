#!/bin/sh
# A class as an instructor grades it: odd names, a run killed at every level and resumed, what changed
# graded again and nothing else, faults of the machinery apart from zeros.
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
row() { awk -v text="$2" 'index($0, text) == 1 { n++ } END { exit n != 1 }' "$1/gradebook.csv" ||
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

# await SECONDS COMMAND...: until the command does.
await() {
    tries=$(($1 * 20))
    shift
    until "$@"; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        sleep 0.05
    done
}

# ---- Eight submissions --------------------------------------------------------------------------

mkdir "$class"
cp -R solutions/$lab "$class/Ada Lovelace_1234567_assignsubmission_file_"
cp -R labs/$lab "$class/lab-00-bob"
cp -R solutions/$lab "$class/-rf"
cp -R labs/$lab "$class/..$(printf '\n').$(printf '\377')<b>\"'&\$(true)"
cp -R solutions/$lab "$class/=1+1"
cp -R labs/$lab "$class/carol"
cp -R solutions/$lab "$class/carol-2"
long=$(printf '%0255d' 0)
cp -R solutions/$lab "$class/$long"
"$build/tools/holes" fill solutions/$lab/gradient.cl gradient "$wrong_file" >"$class/$long/gradient.cl"
echo "no submission" >"$class/notes.txt"

# ---- Killed and resumed -------------------------------------------------------------------------

first=$scratch/first
results() { [ "$(ls -d "$first"/students/*/key 2>/dev/null | wc -l)" -ge "$1" ]; }
none_left() { [ -z "$(processes "$first")" ]; }
is_at_work() { [ -n "$(program "$first" "$1")" ]; }

run "$first" --seed 5 &
driver=$!
check "some are graded" await 30 results 2
driver_shell=$(pgrep -P $driver -f grade_class.sh || echo $driver)
kill -9 "$driver_shell" $driver 2>/dev/null
check "the driver killed: all that it started ends" await 10 none_left
n_kept=$(ls -d "$first"/students/*/key | wc -l)
check "there is no gradebook yet" test ! -e "$first/gradebook.csv"

run "$first" &
driver=$!
check "resumed: a grader is at work" await 20 is_at_work tools/grade
# shellcheck disable=SC2046 # one id
kill -9 $(program "$first" "tools/grade --build")
check "a grader killed: GNU parallel is still there" await 10 is_at_work bin/parallel
# shellcheck disable=SC2046
kill -9 $(program "$first" bin/parallel)
wait $driver
ok $? "a grader and GNU parallel killed: the run ends well" "$(cat "$scratch/said")"
check "and tried again" said "again for"
check "each has one row" test "$(wc -l <"$first/gradebook.csv")" -eq 9
check "the seed of the first run still holds" test "$(cat "$first/seed")" = 5
check "what was graded before was kept ($n_kept)" \
    test "$(n_graded "$first")" -lt 16

check "an uninterrupted run" exits 0 run "$scratch/second" --seed 5 --jobs 1
for file in gradebook.csv gradebook.json class.html; do
    check "$file is the same to the byte" cmp "$first/$file" "$scratch/second/$file"
done

# ---- What the files say -------------------------------------------------------------------------

check "Moodle's number" row "$first" '"Ada Lovelace","1234567",1,"graded",100,100,'
check "GitHub Classroom's name" row "$first" '"bob","",1,"graded",0,100,'
check "a second attempt has a row" row "$first" '"carol","",2,"graded",100,100,'
check "a formula is none" row "$first" "\"'=1+1\","
check "an option is a name" row "$first" "\"'-rf\","
check "a hostile name" row "$first" '"..\x0A.\xFF<b>""'"'&\$(true)\","
check "the longest name" row "$first" "\"$long\","
check "the JSON is one" python_free_json "$first/gradebook.json"
check "a file that is no submission is passed over" said "passed over 1 files"
check "the page is well-formed" xmllint --html --noout "$first/class.html"
check "the page shows no markup of a name" grep -q '&lt;b&gt;&quot;&#39;&amp;' "$first/class.html"
check "the page runs nothing" grep -q "default-src 'none'" "$first/class.html"

finish

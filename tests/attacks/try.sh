#!/bin/sh
# Hand in one attack, grade it, and look at what it earned, what it did and what it left.
#
#     tests/attacks/try.sh FOLDER SANDBOX ATTACK     an attack (see README.md beside this script)
#     tests/attacks/try.sh FOLDER SANDBOX LAB        the control: a right submission, 100 points
#
# Called by suites/attacks.sh, which makes FOLDER/facts (what the attacks aim at) and FOLDER/checks
# (a list of them for each lab). Whatever is wrong goes to FOLDER/NAME.SANDBOX/why, one line each; an
# empty file means that all is well.
set -u
facts=$1/facts
answers=$1/answers
checks=$1/checks
sandbox=$2
attack=$3
build=${BUILD:-build}

name=$(basename "${attack%.*}")
place=$1/$name.$sandbox${4:+.$4}
tag=$(basename "$place" | cksum | cut -d ' ' -f 1)
submission=$place/submission
reports=$place/reports
work=$1/$tag
mkdir -m 700 "$place"
mkdir -m 711 "$work"
: >"$place/why"

wrong() { printf '%s\n' "$*" >>"$place/why"; }

# header KEY: the rest of the attack's line "// KEY: ...".
header() { sed -n "s!^[/#]* $1: !!p" "$attack" | head -n 1; }

# points TASK...: what the tasks are worth together.
points() {
    awk -F '\t' -v tasks=" $* " 'index(tasks, " " $2 " ") { sum += $3 } END { print sum + 0 }' \
        "$checks/$lab"
}

# Names that only the suite knows are written @LIKE_THIS@ in an attack.
fill_in() { sed -f "$facts" -e "s|@TAG@|$tag|g" "$attack"; }

# hand_in: make the submission; sets the score that it may have.
hand_in() {
    cp -R "solutions/$lab" "$submission"
    task=$(header task)
    file=$(header file)
    fill_in >"$place/attack"
    if [ "${attack##*.}" = sh ]; then
        (cd "$submission" && sh "$place/attack") || wrong "the submission cannot be made"
        attacked=$task
    elif [ -n "$task" ]; then
        source=$(grep -l "// TASK $task:" "solutions/$lab"/*.c*)
        "$build/tools/holes" fill "$source" "$task" "$place/attack" \
            >"$submission/$(basename "$source")" || wrong "no task $task"
        attacked=$task
    elif [ -n "$file" ]; then
        cp "$place/attack" "$submission/$file"
        attacked=$("$build/tools/holes" list "solutions/$lab/$file")
    else
        wrong "it has neither a task nor a file"
    fi
    # shellcheck disable=SC2086 # a list of tasks
    allowed=$((100 - $(points $attacked)))
    [ -z "$(header score)" ] || allowed=$(header score)
}

# field NAME: a number of results.json's outermost level.
field() { sed -n "s/^  \"$1\": \([0-9]*\),\{0,1\}\$/\1/p" "$reports/results.json"; }

# earned TASK: its points in results.json.
earned() {
    awk -v id="      \"id\": \"$1\"," '$0 == id { found = 1 }
        found && /"points":/ { gsub(/[^0-9]/, ""); print; exit }' "$reports/results.json"
}

# grade: by the sandbox asked for; everything it starts has to end with it.
grade() {
    limit='' deadline='' seed=''
    [ ! -f "$attack" ] || limit=$(header limit) deadline=$(header deadline) seed=$(header seed)
    # The solution's answers are kept: it need not run beside every attack.
    mkdir -p "$answers/$lab"
    set -- --build "$build" --lab "$lab" --submission "$submission" --output "$reports" \
        ${limit:+--time-limit "$limit"} ${deadline:+--deadline "$deadline"} \
        --seed "${seed:-1}" --answers "$answers/$lab" --sandbox "$sandbox"
    # A machine that others keep busy is to blame by chance; an attack that feigns it is so each time. What an
    # earlier try said is kept, as it may hold a secret.
    for try in 1 2 3 4 5; do
        status=0
        # So far off that no busy machine gets there.
        TMPDIR=$work timeout 900 "$build/tools/left_behind" "$build/tools/grade" "$@" \
            >"$place/said" 2>"$place/said.err" </dev/null || status=$?
        grep -q 'this machine is too busy' "$place/said.err" || break
        cat "$place/said" "$place/said.err" >"$place/said.$try"
    done
}

# ---- What holds for attacks and controls alike ---------------------------------------------------

look_for_leftovers() {
    [ "$status" -ne 99 ] || wrong "$(cat "$place/said.err")"
    [ -z "$(ls -A "$work")" ] || wrong "left in TMPDIR: $(find "$work" | head -n 5)"
    ! grep -F "$work" /proc/mounts >>"$place/why" || wrong "is still mounted"
}

# A secret of the suite, an attack that found one, or one that met what an earlier run had left. What a
# sandbox is known not to hide, a line "gap in SANDBOX" of the attack says: that, and no more.
look_for_secrets() {
    gap=
    [ ! -f "$attack" ] || gap=$(header "gap in $sandbox")
    grep -rhnE 'LEAKED|exit status 77|'"$(cat "$1/canary")" "$place"/said* \
        "$reports" >"$place/leaks" 2>/dev/null
    if [ -n "$gap" ]; then
        grep -Eq -- "$gap" "$place/leaks" || wrong "the gap is closed: /$gap/ no longer comes out"
        grep -Ev -- "$gap" "$place/leaks" >"$place/more_leaks"
        mv "$place/more_leaks" "$place/leaks"
    fi
    [ ! -s "$place/leaks" ] || wrong "a secret came out: $(cut -c 1-300 "$place/leaks" | head -n 3)"
}

case $attack in
tests/attacks/*)
    lab=$(basename "$(dirname "$attack")")
    hand_in
    grade
    # Full marks, if `score` allows them, end with 0. They may hang on the time that is left for trying
    # the answers alone.
    wanted=1
    [ ! -s "$reports/results.json" ] || [ "$(field score)" != 100 ] || wanted=0
    [ "$status" -eq "$wanted" ] ||
        wrong "exit status $status, expected $wanted: $(head -n 3 "$place/said.err")"
    if [ ! -s "$reports/results.json" ]; then
        wrong "there are no results"
    else
        [ "$(field score)" -le "$allowed" ] || wrong "score $(field score), allowed $allowed"
        never=$(header never)
        [ -z "$never" ] || ! grep -Eq -- "$never" "$reports/results.json" "$place/said" ||
            wrong "came out: $(grep -Eho -- "$never" "$reports/results.json" "$place/said" | head -n 3)"
        for task in $attacked; do
            [ "$(earned "$task")" -eq 0 ] || [ -n "$(header score)" ] || wrong "$task earned points"
        done
        # What is said of the sandbox names no attack.
        grep -v '"message": "A user of its own for each run' "$reports/results.json" |
            grep -Eiq -- "$(header named)" ||
            wrong "not named: expected /$(header named)/ in: $(grep '"message": "[^"]' \
                "$reports/results.json" | sort -u | cut -c 1-400 | head -n 12)"
    fi
    ;;
*)
    lab=$attack
    cp -R "solutions/$lab" "$submission"
    grade
    [ "$status" -eq 0 ] || wrong "exit status $status, expected 0: $(head -n 3 "$place/said.err")"
    [ "$(field score)" = 100 ] || wrong "score $(field score), expected 100"
    ;;
esac
look_for_leftovers
look_for_secrets "$1"

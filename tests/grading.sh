# shellcheck shell=sh disable=SC2034,SC2154,SC2317 # sourced, behind tests/tap.sh; used by the suites
# What the suites about the grader share: grading, reading what it left, and making submissions.
#
#     . tests/tap.sh
#     . tests/grading.sh

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
holds() {
    for file in "$said" "$reports/results.json"; do
        grep -qF -- "$1" "$file" || { echo "not in $(basename "$file"): $1"; cat "$file"; return 1; }
    done
}

# ---- Submissions --------------------------------------------------------------------------------

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

# kept LAB: options for a seed whose answers of the solution are kept: it need not run every time. LAB
# is a name or a number.
kept() {
    mkdir -p "$scratch/answers/${1%%-*}"
    echo "--lab $1 --seed 5 --answers $scratch/answers/${1%%-*}"
}

#!/bin/sh
# Grade a whole class; `make grade-class` calls this.
#
#     tests/class/grading/grade_class.sh --lab 03 --submissions FOLDER [OPTION VALUE]...
#
#     --submissions FOLDER   or a zip or tar archive of it, which is unpacked in the sandbox
#     --output FOLDER        where everything goes (build/class/03)
#     --engine parallel      or slurm: how the submissions are spread
#     --jobs N               how many at a time (parallel: as many as there are processors)
#     --seed N               a number in the place of the class's secret: for tests
#     --only failed|latest   only those below full marks; of a student's entries by Moodle the last
#     --again 1              grade all, also where nothing has changed
#     --list FILE.csv        the participants: Moodle's worksheet, a gradebook of Canvas, ... (--moodle is its older name)
#     --column TITLE         which of its columns takes the grades, where it has several
#     --who FILE.csv         whose an entry is, where the instructor decides: entry, student, counts
#     --changes FILE.csv     the instructor's corrections: student, task, points, comment, until
#     --points FILE.csv      the instructor's own points, hints and limits; kept as OUTPUT/points.csv
#     --due TEXT             the deadline: "2026-11-25 23:59 Europe/Berlin"
#     --late TEXT            what late work costs: 10%/day,2days
#     --against FILE.json    an older gradebook.json, to compare scores with
#     --nothing 0|blank      what gradebooks have for who handed in nothing of this lab (blank)
#     --names no             also a page for the lecture hall, without names
#     --device D, --time-limit S, --build FOLDER    as for build/tools/grade
#
# Killed at any point, the same command goes on where it stopped. A signal ends it, with all that it has
# started, within moments. A submission is graded when its
# key has changed: a hash of its bytes, the grader, the lab and the seed. The last line counts all. Exit
# status: 0; 1 when somebody's work could be lost: not graded, not entered for somebody, or passed
# over; 2 when there is no gradebook. Read next: grade_one.sh, one submission;
# engine_parallel.sh; gradebook_tool.c, which reads the names and writes the gradebook.
set -u

# Of the caller's variables these go on, and no others: what a shell's profile holds for GNU parallel, cd, a
# compiler or a driver must not decide who is graded, and how.
if [ "${1:-}" = --own-environment ]; then
    shift
else
    set -- sh "$0" --own-environment "$@"
    for name in PATH HOME USER LOGNAME TMPDIR COURSE_SANDBOX CLASS_SECONDS \
        $(env | sed -n 's/^\(S\(LURM\|BATCH\)_[A-Z0-9_]*\)=.*/\1/p'); do
        eval "[ -z \"\${$name+given}\" ] || set -- \"$name=\$$name\" \"\$@\""
    done
    exec env -i "$@"
fi
export LC_ALL=C
# shellcheck source=tests/class/grading/one_run.sh
. tests/class/grading/one_run.sh

die() {
    printf 'grade-class: %s\n' "$*" >&2
    exit 2
}

# put NAME TEXT: a line that is a file of the class's folder: whole, or as it was before.
put() {
    { printf '%s\n' "$2" >"$CLASS_FOLDER/$1.new" && sync "$CLASS_FOLDER/$1.new" &&
        mv "$CLASS_FOLDER/$1.new" "$CLASS_FOLDER/$1"; } || die "$CLASS_FOLDER/$1: cannot be written"
}

# ---- What is asked for --------------------------------------------------------------------------

CLASS_LAB='' CLASS_FOLDER='' CLASS_BUILD=build CLASS_DEVICE='' CLASS_TIME_LIMIT=
submissions='' engine=parallel jobs='' seed='' only='' again='' list='' column='' who='' changes='' points='' due='' late='' against=''
nothing='' names=''
while [ $# -gt 0 ]; do
    [ $# -gt 1 ] || die "$1: expected a value"
    case $1 in
    --lab) CLASS_LAB=$2 ;;
    --submissions) submissions=$2 ;;
    --output) CLASS_FOLDER=$2 ;;
    --build) CLASS_BUILD=$2 ;;
    --engine) engine=$2 ;;
    --jobs) jobs=$2 ;;
    --seed) seed=$2 ;;
    --only) only=$2 ;;
    --again) again=$2 ;;
    --list | --moodle)
        [ -z "$list" ] || die "$1: found a list already, expected one: LIST=, or MOODLE=, its older name"
        list=$2
        ;;
    --column) column=$2 ;;
    --who) who=$2 ;;
    --changes) changes=$2 ;;
    --points) points=$2 ;;
    --due) due=$2 ;;
    --late) late=$2 ;;
    --against) against=$2 ;;
    --nothing) nothing=$2 ;;
    --names) names=$2 ;;
    --device) CLASS_DEVICE=$2 ;;
    --time-limit) CLASS_TIME_LIMIT=$2 ;;
    *) die "$1: no such option" ;;
    esac
    shift 2
done

# whole OPTION TEXT: is it a whole number?
whole() {
    case $2 in
    '' | *[!0-9]* | ?????????????????????*) die "$1: found \"$2\", expected a whole number" ;;
    esac
}

[ -n "$CLASS_LAB" ] || die "say which lab: LAB=03"
[ -n "$submissions" ] || die "say where the submissions are: SUBMISSIONS=folder or archive"
case $engine in
parallel | slurm) ;;
*) die "--engine: found \"$engine\", expected parallel or slurm" ;;
esac
case $only in
'' | failed | latest) ;;
*) die "--only: found \"$only\", expected failed or latest" ;;
esac
case $nothing in
'' | 0 | blank) ;;
*) die "--nothing: found \"$nothing\", expected 0 or blank" ;;
esac
case $names in
'' | no) ;;
*) die "--names: found \"$names\", expected no" ;;
esac
[ -z "$jobs" ] || whole --jobs "$jobs"
[ "${jobs:-1}" -ge 1 ] || die "--jobs: found \"$jobs\", expected 1 or more"
[ -z "$seed" ] || whole --seed "$seed"
# No path shall look like an option.
case $submissions in -*) submissions=./$submissions ;; esac
case $CLASS_FOLDER in -*) CLASS_FOLDER=./$CLASS_FOLDER ;; esac
case $list in -*) list=./$list ;; esac
case $who in -*) who=./$who ;; esac
case $changes in -*) changes=./$changes ;; esac
case $points in -*) points=./$points ;; esac
case $against in -*) against=./$against ;; esac
for file in "$list" "$who" "$changes" "$points" "$against"; do
    [ -z "$file" ] || [ -r "$file" ] || die "$file: cannot be read"
done
command -v jq >/dev/null || die "jq is not here: install the package jq"
[ -x "$CLASS_BUILD/tools/grade" ] || die "$CLASS_BUILD/tools/grade: not built; run make grader"
# "3", "03" or the whole name.
lab_number=${CLASS_LAB%%-*}
lab_number=${lab_number#0}
for folder in labs/*; do
    name=${folder#labs/}
    number=${name%%-*}
    [ "${number#0}" != "${lab_number:-0}" ] || lab=$name
done
case ${lab:-} in
"$CLASS_LAB" | "$CLASS_LAB"-* | "0$CLASS_LAB"-*) CLASS_LAB=$lab ;;
*) die "--lab: found \"$CLASS_LAB\", expected the number or name of a lab" ;;
esac

CLASS_FOLDER=${CLASS_FOLDER:-$CLASS_BUILD/class/${CLASS_LAB%%-*}}
# What a run leaves would be a student's, or what a student has handed in would be cleared away.
output=$(realpath -m "$CLASS_FOLDER") input=$(realpath -m "$submissions")
case $output/ in
"$input"/*) die "$CLASS_FOLDER: found OUTPUT in SUBMISSIONS, expected it elsewhere" ;;
esac
case $input/ in
"$output"/*) die "$submissions: found SUBMISSIONS in OUTPUT ($CLASS_FOLDER), expected it elsewhere" ;;
esac
# Whoever else has an account here has no business with others' marks.
[ -d "$CLASS_FOLDER" ] || { mkdir -p "$CLASS_FOLDER" && chmod o-rwx "$CLASS_FOLDER"; }
mkdir -p "$CLASS_FOLDER/students" "$CLASS_FOLDER/logs" || die "$CLASS_FOLDER: cannot be made"
CLASS_FOLDER=$(cd "$CLASS_FOLDER" && pwd -P)

# ---- After a run that was killed ----------------------------------------------------------------

folder_hold "$CLASS_FOLDER" "make grade-class"

# One lab, as another one's gradebook would take the place of this one's.
of_lab=$(grep . "$CLASS_FOLDER/lab" 2>/dev/null ||
    jq -r '.lab // empty' "$CLASS_FOLDER/gradebook.json" 2>/dev/null)
[ "${of_lab:-$CLASS_LAB}" = "$CLASS_LAB" ] ||
    die "$CLASS_FOLDER: found a class of $of_lab, expected a folder of its own for $CLASS_LAB (OUTPUT=)"
put lab "$CLASS_LAB"

# A short name: sockets and sandboxes have little room for paths.
CLASS_WORK=${TMPDIR:-/tmp}/class-$(printf %s "$CLASS_FOLDER" | sha256sum | cut -c 1-10)

# clear: what this run, or a dead one, leaves outside of the results.
clear() {
    if [ -e "$CLASS_FOLDER/engine" ]; then
        last=
        read -r last <"$CLASS_FOLDER/engine"
        case $last in
        parallel | slurm)
            # shellcheck source=tests/class/grading/engine_slurm.sh
            (. "tests/class/grading/engine_$last.sh" && engine_end) || return
            ;;
        *) echo "grade-class: $CLASS_FOLDER/engine: damaged; passed over" >&2 ;;
        esac
        rm "$CLASS_FOLDER/engine"
    fi
    rm -rf "$CLASS_WORK"-* \
        "$CLASS_FOLDER"/students/*.new "$CLASS_FOLDER"/todo "$CLASS_FOLDER"/todo.* "$CLASS_FOLDER/pending" \
        "$CLASS_FOLDER/answers"
}

clear || die "what a killed run left cannot be ended"
# shellcheck source=tests/class/grading/engine_parallel.sh
. "tests/class/grading/engine_$engine.sh"
engine_check
put engine "$engine"
rm -rf "$CLASS_FOLDER/faults"
mkdir "$CLASS_FOLDER/faults" "$CLASS_FOLDER/answers" "$CLASS_FOLDER/pending" || exit 2
# Each grading ends with whoever started it: a moment after them all.
stop_waits() {
    tries=100
    while [ $tries -gt 0 ] && grep -qszFx "CLASS_FOLDER=$CLASS_FOLDER" /proc/[0-9]*/environ; do
        sleep 0.05
        tries=$((tries - 1))
    done
}
trap 'clear' EXIT
trap 'stop' INT TERM HUP PIPE

# ---- What there is to do ------------------------------------------------------------------------

# An export that is an archive. The copy belongs to whoever grades: no student's code gets at it.
if [ -f "$submissions" ]; then
    # What is above the students' folder goes along: no student can have put it there.
    top=$CLASS_WORK-export/unpack-0/out
    { mkdir -m 711 "$CLASS_WORK-export" &&
        attend "$CLASS_BUILD/tools/gradebook" unpack "$CLASS_BUILD" "$submissions" "$CLASS_WORK-export" \
            >"$CLASS_FOLDER/todo.unpacked" &&
        rm -rf "$CLASS_FOLDER/export" &&
        unpacked=$(cat "$CLASS_FOLDER/todo.unpacked") &&
        attend sh -c 'umask 077 && exec cp -RPT --preserve=timestamps "$@"' - "$top" "$CLASS_FOLDER/export" &&
        rm -rf "$CLASS_WORK-export"; } || exit 2
    submissions=$CLASS_FOLDER/export${unpacked#"$top"}
fi

latest=
[ "$only" != latest ] || latest=--latest
# shellcheck disable=SC2086 # an option or none
attend "$CLASS_BUILD/tools/gradebook" roster $latest ${due:+--commits} "${lab_number:-0}" "$submissions" "$CLASS_FOLDER" \
    >"$CLASS_FOLDER/names" || exit 2

# The instructor's own points: those that are given, or were for this class. As a manifest (class/points/points_tool.c).
CLASS_MANIFEST=
own=$CLASS_FOLDER/points.csv
if [ -n "$points" ] || [ -e "$own" ]; then
    CLASS_MANIFEST=$CLASS_FOLDER/lab.json
    "$CLASS_BUILD/tools/points" "$CLASS_LAB" "${points:-$own}" "$CLASS_MANIFEST" || exit 2
    { [ -z "$points" ] || { cp "$points" "$own.new" && mv "$own.new" "$own"; }; } ||
        die "$own: cannot be written"
else
    rm -f "$CLASS_FOLDER/lab.json"
fi

# Everything that decides on a score besides the submission.
grader=$({
    echo "$CLASS_LAB $CLASS_DEVICE $CLASS_TIME_LIMIT"
    cat ${CLASS_MANIFEST:+"$CLASS_MANIFEST"} </dev/null
    find labs solutions common kernels tests/probes tests/stand_ins -type f -print0 | sort -z | xargs -0 sha256sum
    cd "$CLASS_BUILD" && find . -maxdepth 2 -type f \( -path ./tools/grade -o -path ./tools/unpack -o -path "./judges/$CLASS_LAB" \
        -o -path "./probes/$CLASS_LAB*" -o -path "./earlier/$CLASS_LAB.a" -o -path ./libcommon.a \) -print0 |
        sort -z | xargs -0 sha256sum
} | sha256sum | cut -c 1-64)

# Left by a version whose seeds had 32 bits. As after any other change of the grader all is graded again.
[ ! -e "$CLASS_FOLDER/seed" ] || (cd "$CLASS_FOLDER" && rm -rf rounds round seed)

# A line "SLUG KEY SEED" for each (class_keys.h). The secret behind the seeds is only in the folder.
attend "$CLASS_BUILD/tools/gradebook" contents "$CLASS_FOLDER" <"$CLASS_FOLDER/names" >"$CLASS_FOLDER/contents" || exit 2
# Nor does anybody else read the seeds, should the folder be open.
(umask 077 && "$CLASS_BUILD/tools/gradebook" keys ${seed:+--seed "$seed"} "$grader" "$CLASS_FOLDER" \
    <"$CLASS_FOLDER/contents") || exit 2
rm "$CLASS_FOLDER/contents"

# What the gradebook will be written with is read now, and not after hours.
set --
[ -z "$list" ] || set -- "$@" --list "$list"
[ -z "$column" ] || set -- "$@" --column "$column"
[ -z "$who" ] || set -- "$@" --who "$who"
[ -z "$changes" ] || set -- "$@" --changes "$changes"
[ -z "$due" ] || set -- "$@" --due "$due"
[ -z "$late" ] || set -- "$@" --late "$late"
[ -z "$against" ] || set -- "$@" --against "$against"
attend "$CLASS_BUILD/tools/gradebook" check "$@" "$CLASS_LAB" "$CLASS_FOLDER" || exit 2

# results_say SLUG FILTER: does it say true of the results? Of an empty file jq says nothing, with status 0.
results_say() { [ "$(jq "$2" "$CLASS_FOLDER/students/$1/results.json" 2>/dev/null)" = true ]; }

# has_full_marks SLUG
has_full_marks() { results_say "$1" 'has("score") and .score == .max_score'; }

# has_results SLUG: are they whole? A full disk, or a crash of the machine, may have cut them short.
has_results() { results_say "$1" 'has("checks")'; }

# is_wanted SLUG KEY: is there something to do at the start?
is_wanted() {
    old=
    [ ! -e "$CLASS_FOLDER/students/$1/key" ] || read -r old <"$CLASS_FOLDER/students/$1/key"
    case $again$only in
    *failed) ! has_full_marks "$1" ;;
    '' | latest) [ "$old" != "$2" ] || ! has_results "$1" ;;
    *) true ;;
    esac
}

while read -r slug key _; do
    if is_wanted "$slug" "$key"; then
        { echo "$slug" && : >"$CLASS_FOLDER/pending/$slug"; } || die "$CLASS_FOLDER/todo: cannot be written"
    fi
done <"$CLASS_FOLDER/keys" >"$CLASS_FOLDER/todo"

# ---- Grading ------------------------------------------------------------------------------------

# On the busiest machine a grading takes less; what takes longer hangs.
CLASS_SECONDS=${CLASS_SECONDS:-7200}
# A line for each that is done, where no progress bar says so.
CLASS_TELLS=
[ -t 2 ] || CLASS_TELLS=1
export CLASS_MANIFEST CLASS_LAB CLASS_FOLDER CLASS_BUILD CLASS_DEVICE CLASS_TIME_LIMIT CLASS_WORK \
    CLASS_SECONDS CLASS_TELLS

# remaining: of those to do, the ones that have not come to an end.
remaining() {
    while read -r slug; do
        [ ! -e "$CLASS_FOLDER/pending/$slug" ] || echo "$slug"
    done <"$CLASS_FOLDER/todo" >"$CLASS_FOLDER/todo.new"
    mv "$CLASS_FOLDER/todo.new" "$CLASS_FOLDER/todo"
}

# A fault of the machinery may pass: three rounds, each for those that the one before left.
round=1
while [ -s "$CLASS_FOLDER/todo" ] && [ $round -le 3 ]; do
    n_left=$(wc -l <"$CLASS_FOLDER/todo")
    [ $round -eq 1 ] || echo "grade-class: again for $n_left that could not be graded" >&2
    engine_run "$CLASS_FOLDER/todo" "$jobs"
    remaining
    round=$((round + 1))
done

attend "$CLASS_BUILD/tools/gradebook" write "$@" --nothing "${nothing:-blank}" ${names:+--names "$names"} "$CLASS_FOLDER"

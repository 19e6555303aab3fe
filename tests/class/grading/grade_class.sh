#!/bin/sh
# Grade a whole class; `make grade-class` calls this.
#
#     tests/class/grading/grade_class.sh --lab 03 --submissions FOLDER [--OPTION VALUE]...
#     LAB=03 SUBMISSIONS=FOLDER ... tests/class/grading/grade_class.sh --make [--OPTION VALUE]...
#
# Killed at any point, the same command goes on where it stopped. A signal ends it, with all that it has
# started, within moments. A submission is graded when its
# key has changed: a hash of its bytes, the grader, the lab and the seed. The last line counts all. Exit
# status: 0; 1 when somebody's work could be lost: not graded, not entered for somebody, or passed
# over; 2 when there is no gradebook. Read next: grade_one.sh, one submission;
# engine_parallel.sh; gradebook_tool.c, which reads the names and writes the gradebook.
set -u

# options: the options, a line each: the name, what it takes, what it is. make has them as variables, LIST=FILE,
# and the command line as --list FILE. gradebook_tool.c has those that the gradebook is written with.
options() {
    cat <<'END'
LAB          TEXT             the lab's number or name
SUBMISSIONS  PATH             a folder, or a zip or tar archive of it, which is unpacked in the sandbox
OUTPUT       PATH             where everything goes (build/class/03)
ENGINE       parallel|slurm   how the submissions are spread (parallel)
JOBS         N                how many at a time (parallel: as many as there are processors)
SEED         N                a number in the place of the class's secret: for tests
ONLY         failed|latest    only those below full marks; of a student's entries by Moodle the last
AGAIN        TEXT             if 1, grade all, also where nothing has changed
LIST         FILE             the participants: Moodle's worksheet, a gradebook of Canvas, ...
MOODLE       FILE             the older name of LIST
COLUMN       TEXT             which of its columns takes the grades, where it has several
WHO          FILE             whose an entry is, where the instructor decides: entry, student, counts
CHANGES      FILE             the instructor's corrections: student, task, points, comment, until
POINTS       FILE             the instructor's own points, hints and limits; kept as OUTPUT/points.csv
DUE          TEXT             the deadline: 2026-11-25 23:59 Europe/Berlin
LATE         TEXT             what late work costs: 10%/day,2days
AGAINST      FILE             an older gradebook.json, to compare scores with
NOTHING      0|blank          what gradebooks have for who handed in nothing of this lab (blank)
NAMES        no               also a page for the lecture hall, without names
DEVICE       TEXT             as for build/tools/grade, and the next two
TIME_LIMIT   TEXT             in seconds
BUILD        PATH             the folder build
END
}
names=$(options | sed 's/ .*//')

# Of the caller's variables these go on, and no others: what a shell's profile holds for GNU parallel, cd, a
# compiler or a driver must not decide who is graded, and how. Options only from make, which exports them.
if [ "${1:-}" = --own-environment ]; then
    shift
else
    given=
    [ "${1:-}" != --make ] || given=$names
    set -- sh "$0" --own-environment "$@"
    for name in PATH HOME USER LOGNAME TMPDIR COURSE_SANDBOX CLASS_SECONDS $given \
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

# shellcheck disable=SC2086 # names
if [ "${1:-}" = --make ]; then shift; else unset $names; fi
for name in $names; do
    eval "$name=\${$name:-}"
done
while [ $# -gt 0 ]; do
    [ $# -gt 1 ] || die "$1: expected a value"
    name=$(printf %s "$1" | sed -n 's/^--\([a-z-]*\)$/\1/p' | tr a-z- A-Z_)
    options | grep -q "^${name:-no} " || die "$1: no such option"
    eval "$name=\$2"
    shift 2
done

# refuse EXPECTED: the value of an option.
refuse() { die "--$(echo "$name" | tr A-Z_ a-z-): found \"$value\", expected $1"; }

# Is each value what its option takes? No path shall look like an option.
while read -r name takes _; do
    eval "value=\$$name"
    case $takes,$value in
    *, | TEXT,*) ;;
    PATH,-* | FILE,-*) eval "$name=./\$value" ;;
    PATH,*) ;;
    N,*[!0-9]* | N,?????????????????????*) refuse "a whole number" ;;
    N,* | FILE,*) ;;
    *) case "|$takes|,${value%%|*}" in
        *"|$value|"*,"$value") ;;
        *) refuse "$(echo "$takes" | sed 's/|/ or /')" ;;
        esac ;;
    esac
    eval "value=\$$name"
    [ "$takes" != FILE ] || [ -z "$value" ] || [ -r "$value" ] || die "$value: cannot be read"
done <<END
$(options)
END
[ -n "$LAB" ] || die "say which lab: LAB=03"
[ -n "$SUBMISSIONS" ] || die "say where the submissions are: SUBMISSIONS=folder or archive"
[ "${JOBS:-1}" -ge 1 ] || die "--jobs: found \"$JOBS\", expected 1 or more"
[ -z "$LIST" ] || [ -z "$MOODLE" ] || die "found a list already, expected one: LIST=, or MOODLE=, its older name"
NOTHING=${NOTHING:-blank}
# As gradebook --make reads them. Nobody else has to know the seed.
# shellcheck disable=SC2163 # names
for name in $names; do export "$name"; done
# shellcheck disable=SC2153 # set above
seed=$SEED
unset SEED
# shellcheck disable=SC2153 # set above
CLASS_LAB=$LAB CLASS_FOLDER=$OUTPUT CLASS_BUILD=${BUILD:-build} CLASS_DEVICE=$DEVICE CLASS_TIME_LIMIT=$TIME_LIMIT
engine=${ENGINE:-parallel} submissions=$SUBMISSIONS
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
[ "$ONLY" != latest ] || latest=--latest
# shellcheck disable=SC2086 # an option or none
attend "$CLASS_BUILD/tools/gradebook" roster $latest ${DUE:+--commits} "${lab_number:-0}" "$submissions" "$CLASS_FOLDER" \
    >"$CLASS_FOLDER/names" || exit 2

# The instructor's own points: those that are given, or were for this class. As a manifest (class/points/points_tool.c).
CLASS_MANIFEST=
own=$CLASS_FOLDER/points.csv
if [ -n "$POINTS" ] || [ -e "$own" ]; then
    CLASS_MANIFEST=$CLASS_FOLDER/lab.json
    "$CLASS_BUILD/tools/points" "$CLASS_LAB" "${POINTS:-$own}" "$CLASS_MANIFEST" || exit 2
    { [ -z "$POINTS" ] || { cp "$POINTS" "$own.new" && mv "$own.new" "$own"; }; } ||
        die "$own: cannot be written"
else
    rm -f "$CLASS_FOLDER/lab.json"
fi

# Everything that decides on a score besides the submission.
grader=$({
    echo "$CLASS_LAB $CLASS_DEVICE $CLASS_TIME_LIMIT"
    cat ${CLASS_MANIFEST:+"$CLASS_MANIFEST"} </dev/null
    find labs solutions common kernels tests/probes tests/stubs -type f -print0 | sort -z | xargs -0 sha256sum
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
attend "$CLASS_BUILD/tools/gradebook" --make check "$CLASS_LAB" "$CLASS_FOLDER" || exit 2

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
    case $AGAIN$ONLY in
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
    engine_run "$CLASS_FOLDER/todo" "$JOBS"
    remaining
    round=$((round + 1))
done

attend "$CLASS_BUILD/tools/gradebook" --make write "$CLASS_FOLDER"

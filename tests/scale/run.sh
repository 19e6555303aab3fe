#!/bin/sh
# Grade a class of N submissions of lab 03 and tell what it took: `make test-scale`.
#
#     tests/scale/run.sh [N [BUILD]]      N is 1000 when not given
#
# Prints a table for tests/scale/README.md. Fails when a submission takes more than 1.5 s on average, when
# one is not graded, when the driver's memory grows, when anything is left behind, or when a second
# run grades anything again.
set -u

n=${1:-1000} build=${2:-build}
scale=$build/scale
rm -rf "$scale"
mkdir -p "$scale"
tests/scale/make_class.sh "$n" "$scale/class" "$build"

# Short, as sandboxes have little room for paths, and open to the user they run as.
TMPDIR=$(mktemp -d /tmp/scale-XXXXXX)
chmod 711 "$TMPDIR"
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
trap 'exit 1' INT TERM

failed=0

# figure NAME FIGURE WANTED: a row of the table; WANTED is "yes" or what was expected instead.
figure() {
    printf '| %s | %s |\n' "$1" "$2"
    [ "$3" = yes ] || { echo "tests/scale/run.sh: $1: found $2, expected $3" >&2; failed=1; }
}

# within NUMBER LIMIT: "yes", or the limit in words.
within() {
    awk -v number="$1" -v limit="$2" 'BEGIN { print number <= limit ? "yes" : "at most " limit }'
}

# memory PROCESS...: resident KB of the driver's own processes together.
memory() {
    for process; do
        sed -n 's/^VmRSS:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$process/status" 2>/dev/null
    done | awk '{ sum += $1 } END { print sum + 0 }'
}

# watch DRIVER: "DONE KB" once a second.
watch() {
    while kill -0 "$1" 2>/dev/null; do
        # shellcheck disable=SC2046 # process ids
        kilobytes=$(memory "$1" $(cat "/proc/$1/task/$1/children"))
        echo "$(find "$scale/graded/pending" -type f 2>/dev/null | wc -l) $kilobytes"
        sleep 1
    done
}

processes() { grep -lsz "^CLASS_FOLDER=.*/scale/graded\$" /proc/[0-9]*/environ | wc -l; }

mounts=$(wc -l </proc/self/mounts)
started=$(date +%s)
tests/class/grading/grade_class.sh --build "$build" --lab 03 --submissions "$scale/class" \
    --output "$scale/graded" --seed 1 >"$scale/log" 2>&1 </dev/null &
driver=$!
watch $driver >"$scale/memory"
wait $driver
status=$?
seconds=$(($(date +%s) - started))
processes=$(processes)
files=$(find "$TMPDIR" -mindepth 1 | wc -l)
mounts=$(($(wc -l </proc/self/mounts) - mounts))
n_jobs=$(wc -l <"$scale/graded/joblog")
started=$(date +%s)
tests/class/grading/grade_class.sh --build "$build" --lab 03 --submissions "$scale/class" \
    --output "$scale/graded" --seed 1 >"$scale/log-again" 2>&1 </dev/null
again=$(($(date +%s) - started))

# The most before a quarter was done, and the most of all.
early=$(awk -v n="$n" '$1 > n * 3 / 4 && $2 > most { most = $2 }
    END { print int(most / 1024) }' "$scale/memory")
most=$(awk '$2 > most { most = $2 } END { print int(most / 1024) }' "$scale/memory")
each=$(awk -v seconds=$seconds -v n="$n" 'BEGIN { printf "%.2f", seconds / n }')

echo "| a class of $n, lab 03 | $(date +%F), $(nproc) processors |"
echo "|---|---|"
figure "wall time, s" "$seconds" yes
figure "for each submission, s" "$each" "$(within "$each" 1.5)"
figure "exit status of the driver" "$status" "$(within "$status" 0)"
figure "the driver's memory until a quarter was done, MB" "$early" yes
figure "the most of all, MB" "$most" "$(within "$most" $((early + 5)))"
figure "processes left" "$processes" "$(within "$processes" 0)"
figure "files left in TMPDIR" "$files" "$(within "$files" 0)"
figure "mounts left" "$mounts" "$(within "$mounts" 0)"
figure "a second run, s" "$again" yes
n_again=$(($(wc -l <"$scale/graded/joblog") - n_jobs))
figure "gradings in it" "$n_again" "$(within "$n_again" 0)"
echo
tail -n 3 "$scale/log"
exit $failed

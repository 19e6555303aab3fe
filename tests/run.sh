#!/bin/sh
# Run every test and tell how many passed; `make test` and `make test-all` build what this runs.
#
#     [ORDER=SEED] [JOBS=N] tests/run.sh [NAME...]      all, or the unit tests and suites of these names
#
# Unit tests are Criterion programs, in `make test-all` built with the sanitizers (build/sanitized/tests/test_*);
# suites are scripts (tests/suites/*.sh). N of them run side by side, as many as there are processors. Those
# that took longest the last time begin first; with ORDER, a number, they begin in the order that is drawn
# from it: no test may need what another one leaves.
#
# In `make test` a test that has passed is run again only when something has changed.
#
# A line for each is printed when it ends (run_one.sh); the last line is "N passed, N failed".
set -u
export BUILD="${BUILD:-build}"
results=$BUILD/tests
mkdir -p "$results"
rm -f "$results"/*.tap "$results"/*.log "$results"/*.counts
# The tests choose devices and sandboxes themselves.
unset COURSE_DEVICE COURSE_SANDBOX
# PoCL finds no device where it cannot write its cache, as in the home of many a container's user.
cache=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}
if [ -z "${POCL_CACHE_DIR:-}" ] && ! { mkdir -p "$cache" 2>/dev/null && [ -w "$cache" ]; }; then
    mkdir -p "$results/pocl-cache"
    POCL_CACHE_DIR=$(cd "$results/pocl-cache" && pwd)
    export POCL_CACHE_DIR
fi

# ---- Which, and in which order ------------------------------------------------------------------

case ${ORDER:-0} in
*[!0-9]*) echo "ORDER: found \"$ORDER\", expected a whole number" >&2 && exit 2 ;;
esac

# Every test, a line each. By their sources: a build folder may hold programs of tests that are gone.
all=$(printf '%s\n' tests/suites/*.sh tests/unit/test_*.c | sed 's|.*/||; s|\.[a-z]*$||' | grep -v '\*')

# wanted NAME...: all, or those of these names.
wanted() {
    if [ $# -eq 0 ]; then printf '%s\n' "$all"; else printf '%s\n' "$@" | sort -u; fi
}

# ordered: the lines of stdin by the seconds that they took last; what has not run here yet is first.
ordered() {
    if [ -n "${ORDER:-}" ]; then
        LC_ALL=C awk -v seed="$ORDER" 'BEGIN { srand(seed + 0) } { printf "%.9f %s\n", rand(), $0 }' | LC_ALL=C sort
    else
        while IFS= read -r name; do
            echo "$(cat "$results/$name.seconds" 2>/dev/null || echo 9999) $name"
        done | sort -k 1,1nr -s
    fi | sed 's/^[^ ]* //'
}

for name; do
    printf '%s\n' "$all" | grep -qxF -- "$name" || { echo "no test is called: $name" >&2 && exit 1; }
done
names=$(wanted "$@" | ordered)
[ -z "${ORDER:-}" ] || echo "in the order of seed $ORDER"

# ---- What has passed before ---------------------------------------------------------------------

# The files of the course, built programs included, the packages and the machine, as one number.
state() {
    {
        uname -srm
        id -u
        dpkg-query -W
        {
            git ls-files -z --cached --others --exclude-standard ||
                find . -name .git -prune -o -path "./$BUILD" -prune -o -type f -print0
            for part in . labs native native/probes pixel/labs pixel/solutions probes solutions tests tools view/labs view/solutions; do
                find "$BUILD/$part" -maxdepth 1 -type f -perm -100 -print0
            done
        } | LC_ALL=C sort -z | xargs -0 sha256sum
    } 2>/dev/null | sha256sum | cut -d ' ' -f 1
}
# Only `make test` asks; a test that is asked for by its name is run.
export STATE=
if [ -n "${QUICK:-}" ] && [ $# -eq 0 ]; then STATE=$(state); fi

# ---- What is started ends with this script ------------------------------------------------------

# All tests are a session of their own, known by its first process: so all of it can be ended and nothing
# of the caller's, whatever process groups are made in it.
session=

# living: its processes, but for those that have ended and wait for their parent.
living() {
    [ -z "$session" ] ||
        sed -n "s/^\([0-9]*\) (.*) [^ZX] [0-9]* [0-9]* $session .*/\1/p" /proc/[0-9]*/stat 2>/dev/null
}

# end STATUS: on a signal; what does not end by itself within ten seconds is killed.
end() {
    trap '' HUP INT TERM
    # The first one by name, as it may be about to begin its session.
    # shellcheck disable=SC2046,SC2086 # lists of processes
    kill -TERM $session $(living) 2>/dev/null
    tries=100
    # shellcheck disable=SC2086 # words of a list
    while living=$(living) && [ -n "$living" ]; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || kill -KILL $living 2>/dev/null
        sleep 0.1
    done
    exit "$1"
}
trap 'end 129' HUP
trap 'end 130' INT
trap 'end 143' TERM

# ---- Running ------------------------------------------------------------------------------------

n_tests=$(printf '%s\n' "$names" | wc -l)
printf '%s\n' "$names" | setsid xargs -P "${JOBS:-$(nproc)}" -I NAME tests/run_one.sh NAME "$n_tests" &
session=$!
status=0
wait $session || status=$?
session=

# A test that did not come to its end has left no count, and no verdict is given without it.
for name in $names; do
    [ -s "$results/$name.counts" ] || { echo "not run to its end: $name" && status=1; }
done
# What changed while they ran may not have been tested.
[ "$STATE" = "${STATE:+$(state)}" ] || rm -f "$results"/*.kept
cat "$results"/*.counts | awk -v where="$results" -v status="$status" '
    { passed += $1; failed += $2; skipped += $3; kept += $4 }
    END {
        if (kept > 0) printf "(%d of the tests had passed before, and nothing has changed: not run again)\n", kept
        if (skipped > 0) printf "(%d skipped: what is missing for them is in %s/*.tap)\n", skipped, where
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0 || status != 0
    }'

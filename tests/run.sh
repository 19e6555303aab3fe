#!/bin/sh
# Run every test and tell how many passed; `make test` builds what this runs.
#
#     [ORDER=SEED] tests/run.sh [NAME...]      all, or the unit tests and suites of these names
#
# Unit tests are Criterion programs, nearly all built with the sanitizers (build/sanitized/tests/test_*);
# suites are scripts (tests/suites/*.sh). Both speak TAP, kept in build/tests/*.tap. The last line is
# "N passed, N failed". With ORDER, a number, they run in the order that is drawn from it: no test may
# need what another one leaves.
set -u
build=${BUILD:-build}
results=$build/tests
mkdir -p "$results"
rm -f "$results"/*.tap "$results"/*.status
# The tests choose devices and sandboxes themselves.
unset COURSE_DEVICE COURSE_SANDBOX
# PoCL finds no device where it cannot write its cache, as in the home of many a container's user.
cache=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}
if [ -z "${POCL_CACHE_DIR:-}" ] && ! { mkdir -p "$cache" 2>/dev/null && [ -w "$cache" ]; }; then
    mkdir -p "$results/pocl-cache"
    POCL_CACHE_DIR=$(cd "$results/pocl-cache" && pwd)
    export POCL_CACHE_DIR
fi

# A test that hangs is ended. So far beyond what any takes that no busy machine gets there.
longest=7200

# Was this name asked for?
wanted() {
    name=$1
    shift
    [ $# -eq 0 ] && return 0
    for one; do [ "$one" = "$name" ] && return 0; done
    return 1
}

# The lines of stdin as they are or, with ORDER, in an order drawn from it.
ordered() {
    if [ -z "${ORDER:-}" ]; then cat; else
        LC_ALL=C awk -v seed="$ORDER" 'BEGIN { srand(seed + 0) } { printf "%.9f %s\n", rand(), $0 }' |
            LC_ALL=C sort | sed 's/^[^ ]* //'
    fi
}

# Summarise one TAP file: "passed failed skipped".
count() {
    awk '/^ok .*# SKIP/ { skipped++; next } /^ok / { passed++ } /^not ok / { failed++ }
        END { print passed + 0, failed + 0, skipped + 0 }' "$1"
}

passed=0
failed=0
skipped=0

# report NAME STATUS LOG: a line for a suite; a suite that died without a failed test is one itself.
report() {
    tap=$results/$1.tap
    # A program that was killed has written none.
    [ -e "$tap" ] || : >"$tap"
    # shellcheck disable=SC2046 # three numbers
    set -- "$1" "$2" "$3" $(count "$tap")
    if [ "$2" -ne 0 ] && [ "$5" -eq 0 ]; then
        set -- "$1" "$2" "$3" "$4" 1 "$6"
        case $2 in 124) why=" (it took longer than $longest s)" ;; *) why= ;; esac
        echo "not ok - the suite ended with exit status $2$why" >>"$tap"
    elif [ "$(($4 + $5 + $6))" -eq 0 ]; then
        set -- "$1" 1 "$3" 0 1 0
        echo "not ok - the suite ran no test" >>"$tap"
    fi
    passed=$((passed + $4))
    failed=$((failed + $5))
    skipped=$((skipped + $6))
    printf '%-22s %4d passed, %d failed' "$1" "$4" "$5"
    [ "$6" -eq 0 ] || printf ', %d skipped' "$6"
    printf '   %3d s\n' $(($(date +%s) - started))
    if [ "$5" -gt 0 ]; then
        sed -n '/^not ok/,/^ok/{/^ok/!p;}' "$tap" | sed 's/^/    /'
        tail -n 40 "$3" | sed 's/^/    | /'
    fi
}

# ---- What is started ends with this script ------------------------------------------------------

# The suites, and each unit test, are a session of their own, known by its first process: so all of it
# can be ended and nothing of the caller's, whatever process groups are made in it.
suites_session=
test_session=

# living SESSION...: its processes, but for those that have ended and wait for their parent.
living() {
    for session; do
        sed -n "s/^\([0-9]*\) (.*) [^ZX] [0-9]* [0-9]* $session .*/\1/p" /proc/[0-9]*/stat 2>/dev/null
    done
}

# end STATUS: on a signal; what does not end by itself within ten seconds is killed.
end() {
    trap '' HUP INT TERM
    # The first ones by name, as they may be about to begin their session.
    # shellcheck disable=SC2046,SC2086 # lists of processes
    kill -TERM $suites_session $test_session $(living $suites_session $test_session) 2>/dev/null
    tries=100
    # shellcheck disable=SC2086 # words of a list
    while living=$(living $suites_session $test_session) && [ -n "$living" ]; do
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

case ${ORDER:-0} in
*[!0-9]*) echo "ORDER: found \"$ORDER\", expected a whole number" >&2 && exit 2 ;;
esac
[ -z "${ORDER:-}" ] || echo "in the order of seed $ORDER"

# Suites wait for sandboxes and time limits much of their time: three run side by side, the longest
# first, beside the unit tests. Each one's exit status and seconds are kept for the report.
suites=
for suite in attacks.sh native.sh mutants.sh grader.sh handout.sh bundles.sh programs3d.sh broken.sh class.sh notes.sh view.sh agree3d.sh $(cd tests/suites && echo *.sh); do
    [ -e "tests/suites/$suite" ] || continue
    suite=${suite%.sh}
    case " $suites " in *" $suite "*) continue ;; esac
    wanted "$suite" "$@" && suites="$suites $suite"
done
# shellcheck disable=SC2086 # words of a list
suites=$(printf '%s\n' $suites | ordered)
# shellcheck disable=SC2016 # they are another shell's variables
printf '%s\n' "$suites" | setsid xargs -r -P 3 -I NAME sh -c '
    started=$(date +%s) status=0
    timeout --kill-after=10 "$3" sh "tests/suites/$1.sh" >"$2/$1.tap" 2>"$2/$1.log" || status=$?
    echo "$status $(($(date +%s) - started))" >"$2/$1.status"' suite NAME "$results" $longest &
suites_session=$!

# By their sources: a build folder may hold programs of tests that are gone.
programs=$(for source in tests/unit/test_*.c; do
    name=$(basename "$source" .c)
    case $name in test_cl_setup) echo "$build/tests/$name" ;; *) echo "$build/sanitized/tests/$name" ;; esac
done | ordered)
# A path may hold blanks.
IFS='
'
for program in $programs; do
    unset IFS
    name=$(basename "$program")
    wanted "$name" "$@" || continue
    started=$(date +%s)
    setsid timeout --kill-after=10 $longest "$program" --jobs 2 \
        --tap="$results/$name.tap" >"$results/$name.log" 2>&1 &
    test_session=$!
    status=0
    wait $test_session || status=$?
    test_session=
    report "$name" $status "$results/$name.log"
done
unset IFS

wait $suites_session
suites_session=
for name in $suites; do
    read -r status seconds <"$results/$name.status"
    started=$(($(date +%s) - seconds))
    report "$name" "$status" "$results/$name.log"
done

if [ $((passed + failed + skipped)) -eq 0 ]; then
    echo "no test is called: $*" >&2
    exit 1
fi
[ "$skipped" -eq 0 ] || echo "($skipped skipped: what is missing for them is in $results/*.tap)"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

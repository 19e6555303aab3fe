#!/bin/sh
# Run every test and tell how many passed; `make test` builds what this runs.
#
#     tests/run.sh [NAME...]      all, or the unit tests and suites of these names
#
# Unit tests are Criterion programs, nearly all built with the sanitizers (build/sanitized/tests/test_*);
# suites are scripts (tests/suites/*.sh). Both speak TAP, kept in build/tests/*.tap. The last line is
# "N passed, N failed".
set -u
build=${BUILD:-build}
results=$build/tests
mkdir -p "$results"
rm -f "$results"/*.tap "$results"/*.status

# Was this name asked for?
wanted() {
    name=$1
    shift
    [ $# -eq 0 ] && return 0
    for one; do [ "$one" = "$name" ] && return 0; done
    return 1
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
    # shellcheck disable=SC2046 # three numbers
    set -- "$1" "$2" "$3" $(count "$tap")
    if [ "$2" -ne 0 ] && [ "$5" -eq 0 ]; then
        set -- "$1" "$2" "$3" "$4" 1 "$6"
        echo "not ok - the suite ended with exit status $2" >>"$tap"
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

# Suites wait for compilers and sandboxes much of their time: two run side by side, the longest first,
# beside the unit tests. Each one's exit status and seconds are kept for the report.
suites=
for suite in mutants attacks grader $(cd tests/suites && echo *.sh); do
    suite=${suite%.sh}
    case " $suites " in *" $suite "*) continue ;; esac
    wanted "$suite" "$@" && suites="$suites $suite"
done
# shellcheck disable=SC2086,SC2016 # words of a list; they are another shell's variables
printf '%s\n' $suites | xargs -r -P 2 -I NAME sh -c '
    started=$(date +%s) status=0
    sh "tests/suites/$1.sh" >"$2/$1.tap" 2>"$2/$1.log" || status=$?
    echo "$status $(($(date +%s) - started))" >"$2/$1.status"' suite NAME "$results" &
# What runs in the background shall end with this script.
trap 'trap - TERM; kill -TERM 0' INT TERM

for program in "$build/tests/test_cl_setup" "$build"/sanitized/tests/test_*; do
    case $program in *.tap | *.log) continue ;; esac
    name=$(basename "$program")
    wanted "$name" "$@" || continue
    started=$(date +%s)
    "$program" --jobs 2 --tap="$results/$name.tap" >"$results/$name.log" 2>&1
    report "$name" $? "$results/$name.log"
done

wait
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

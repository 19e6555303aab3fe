#!/bin/sh
# Run one unit test or suite for run.sh, and print its line when it has ended:
#
#     tests/run_one.sh NAME N      of N tests
#
# In build/tests it leaves NAME.tap, NAME.log (what else was said), NAME.counts (how many passed, failed and
# were skipped) and NAME.seconds.
set -u
tests=$BUILD/tests
tap=$tests/$1.tap
# One that hangs is ended. So far beyond what any takes that no busy machine gets there.
longest=7200

started=$(date +%s) status=0
if [ -e "tests/suites/$1.sh" ]; then
    timeout --kill-after=10 $longest sh "tests/suites/$1.sh" >"$tap" 2>"$tests/$1.log" </dev/null || status=$?
else
    # In `make test-all` under the sanitizers, but for this one: PoCL's compiler is not built for them.
    program=$BUILD/sanitized/tests/$1
    [ -z "${HEART:-}" ] && [ "$1" != test_cl_setup ] || program=$tests/$1
    timeout --kill-after=10 $longest "$program" --jobs 2 --tap="$tap" >"$tests/$1.log" 2>&1 </dev/null || status=$?
    # A program that was killed has written none.
    [ -e "$tap" ] || : >"$tap"
fi
seconds=$(($(date +%s) - started))
echo "$seconds" >"$tests/$1.seconds"

count() {
    awk '/^ok .*# SKIP/ { skipped++; next } /^ok / { passed++ } /^not ok / { failed++ }
        END { print passed + 0, failed + 0, skipped + 0 }' "$tap"
}

# A suite that died without a failed test is one itself, as is one that ended before its plan, "1..N".
read -r passed failed skipped <<END
$(count)
END
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
    failed=1 why=
    [ "$status" -ne 124 ] || why=" (it took longer than $longest s)"
    echo "not ok - the suite ended with exit status $status$why" >>"$tap"
elif [ "$((passed + failed + skipped))" -eq 0 ]; then
    failed=1
    echo "not ok - the suite ran no test" >>"$tap"
elif [ -e "tests/suites/$1.sh" ] && ! grep -qx "1\.\.$((passed + failed + skipped))" "$tap"; then
    failed=$((failed + 1))
    echo "not ok - the suite ended before its plan" >>"$tap"
fi
echo "$passed $failed $skipped" >"$tests/$1.counts"

# In one piece, as others write beside it.
said=$(
    printf '%3d of %d  %-28s %4d passed, %d failed' "$(cat "$tests"/*.counts | wc -l)" "$2" "$1" "$passed" "$failed"
    [ "$skipped" -eq 0 ] || printf ', %d skipped' "$skipped"
    printf '   %3d s\n' "$seconds"
    if [ "$failed" -gt 0 ]; then
        sed -n '/^not ok/,/^ok/{/^ok/!p;}' "$tap" | sed 's/^/    /'
        tail -n 40 "$tests/$1.log" | sed 's/^/    | /'
    fi
)
printf '%s\n' "$said"

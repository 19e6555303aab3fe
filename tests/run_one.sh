#!/bin/sh
# Run one unit test or suite for run.sh, and print its line when it has ended:
#
#     tests/run_one.sh NAME N      of N tests
#
# In build/tests it leaves NAME.tap, NAME.log (what else was said), NAME.counts (how many passed, failed and
# were skipped), NAME.seconds and, where all passed, NAME.kept: in which STATE.
set -u
name=$1
n_tests=$2
tests=$BUILD/tests
tap=$tests/$name.tap

# line END: its line, in one piece, as others write beside it.
line() {
    printf '%3d of %d  %-28s %4d passed, %d failed%s   %s\n' "$(cat "$tests"/*.counts | wc -l)" "$n_tests" "$name" \
        "$passed" "$failed" "$(if [ "$skipped" -gt 0 ]; then echo ", $skipped skipped"; fi)" "$1"
}

if [ -n "$STATE" ] && { read -r state passed skipped <"$tests/$name.kept"; } 2>/dev/null && [ "$state" = "$STATE" ]; then
    failed=0
    echo "$passed 0 $skipped 1" >"$tests/$name.counts"
    line 'not run again'
    exit
fi

# One that hangs is ended. So far beyond what any takes that no busy machine gets there.
longest=7200

started=$(date +%s) status=0
if [ -e "tests/suites/$name.sh" ]; then
    timeout --kill-after=10 $longest sh "tests/suites/$name.sh" >"$tap" 2>"$tests/$name.log" </dev/null || status=$?
else
    # In `make test-all` under the sanitizers, but for this one: PoCL's compiler is not built for them.
    program=$BUILD/sanitized/tests/$name
    [ -z "${QUICK:-}" ] && [ "$name" != test_cl_setup ] || program=$tests/$name
    timeout --kill-after=10 $longest "$program" --jobs 2 --tap="$tap" >"$tests/$name.log" 2>&1 </dev/null || status=$?
    # A program that was killed has written none.
    [ -e "$tap" ] || : >"$tap"
fi
seconds=$(($(date +%s) - started))
echo "$seconds" >"$tests/$name.seconds"

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
elif [ -e "tests/suites/$name.sh" ] && ! grep -qx "1\.\.$((passed + failed + skipped))" "$tap"; then
    failed=$((failed + 1))
    echo "not ok - the suite ended before its plan" >>"$tap"
fi
echo "$passed $failed $skipped" >"$tests/$name.counts"

rm -f "$tests/$name.kept"
[ -z "$STATE" ] || [ "$failed" -gt 0 ] || echo "$STATE $passed $skipped" >"$tests/$name.kept"
said=$(
    line "$(printf '%3d s' "$seconds")"
    if [ "$failed" -gt 0 ]; then
        sed -n '/^not ok/,/^ok/{/^ok/!p;}' "$tap" | sed 's/^/    /'
        tail -n 40 "$tests/$name.log" | sed 's/^/    | /'
    fi
)
printf '%s\n' "$said"

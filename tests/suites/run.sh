#!/bin/sh
# tests/run.sh itself, with tests that are made up here: what it counts, in which order it runs them,
# and that all of it ends when it is told to, but nothing of its caller's.
. tests/tap.sh
# Which programs it takes is its own choice.
unset HEART

course=$PWD
mkdir -p "$scratch/tests/suites" "$scratch/tests/unit" "$scratch/build/tests" "$scratch/build/sanitized/tests"
cp tests/run.sh tests/run_one.sh tests/tap.sh "$scratch/tests"
cd "$scratch" || exit 1

# unit PROGRAM: a unit test, a script on stdin, and its source; its TAP is asked for as --tap=FILE.
# shellcheck disable=SC2016 # for the script that is written
unit() {
    { printf '#!/bin/sh\ntap=${3#--tap=}\n'; cat; } >"$1"
    chmod +x "$1"
    : >"tests/unit/$(basename "$1").c"
}

# runs STATUS NAME...: does run.sh end so? What it said is in said.
runs() {
    wanted=$1 status=0
    shift
    BUILD=build tests/run.sh "$@" >said 2>&1 </dev/null || status=$?
    cat said
    [ "$status" -eq "$wanted" ]
}

# says LINE: is this a line of what it said, its place and seconds aside?
says() { sed 's/^ *[0-9]* of [0-9]*  //; s/ *[0-9]* s$//' said | grep -qxF -- "$1" || { cat said; return 1; }; }

# ---- What it counts -----------------------------------------------------------------------------

unit build/tests/test_cl_setup <<'END'
printf 'ok 1\nok 2\n' >"$tap"
END
for name in a b c d e f; do
    unit "build/sanitized/tests/test_$name" <<'END'
printf 'ok 1\n' >"$tap"
END
done
unit build/sanitized/tests/test_gone <<'END'
printf 'ok 1\n' >"$tap"
END
rm tests/unit/test_gone.c
printf '. tests/tap.sh\nok 0 good\nok 0 better\nskip other why\nfinish\n' >tests/suites/good.sh
check "all pass" runs 0
check "the last line counts them" test "$(tail -n 1 said)" = "10 passed, 0 failed"
! says "test_gone                       1 passed, 0 failed" >/dev/null
ok $? "a program whose source is gone is not run"
check "a suite's line" says "good                            2 passed, 0 failed, 1 skipped"
check "a unit test's line" says "test_cl_setup                   2 passed, 0 failed"

printf '. tests/tap.sh\nok 0 good\nok 1 bad "the reason"\nfinish\n' >tests/suites/bad.sh
check "one fails" runs 1 bad good
check "it is counted, and unit tests that were not asked for are not" \
    test "$(tail -n 1 said)" = "3 passed, 1 failed"
check "with its reason" says "      # the reason"
printf '. tests/tap.sh\nok 0 good\nexit 3\n' >tests/suites/bad.sh
check "a suite dies" runs 1 bad
check "and says so" says "    not ok - the suite ended with exit status 3"
: >tests/suites/bad.sh
check "a suite without a test" runs 1 bad
check "and it says so" says "    not ok - the suite ran no test"
printf '. tests/tap.sh\nok 0 good\nexit 0\nok 1 bad\nfinish\n' >tests/suites/bad.sh
check "a suite that ends before its plan" runs 1 bad
check "and says so" says "    not ok - the suite ended before its plan"
# shellcheck disable=SC2016 # for the script that is written
printf 'kill -9 $PPID $(sed "s/.*) . \\([0-9]*\\) .*/\\1/" "/proc/$PPID/stat")\n' >tests/suites/bad.sh
check "what runs a suite is killed" runs 1 bad good
check "and it says what has no verdict" says "not run to its end: bad"
unit build/sanitized/tests/test_a <<'END'
kill -9 $$
END
check "a unit test dies before it writes anything" runs 1 test_a
check "and it says so" says "    not ok - the suite ended with exit status 137"
check "no test of this name, beside one that is there" runs 1 good none-such
check "and it says so" says "no test is called: none-such"
rm tests/suites/bad.sh tests/unit/test_a.c

# Where the home cannot be written, as in many a container, the tests have a cache for kernels.
# shellcheck disable=SC2016 # for the script that is written
printf '. tests/tap.sh\n[ -w "$POCL_CACHE_DIR" ]\nok $? cache\nfinish\n' >tests/suites/cache.sh
without_home() (
    unset POCL_CACHE_DIR XDG_CACHE_HOME
    HOME=/dev/null runs 0 cache
)
check "without a home there is a cache for kernels" without_home
rm tests/suites/cache.sh

# ---- In another order ---------------------------------------------------------------------------

printf '. tests/tap.sh\nok 0 good\nfinish\n' | tee tests/suites/one.sh >tests/suites/two.sh

# order SEED: the names in the order that they ran in.
order() {
    JOBS=1 ORDER=$1 runs 0 >/dev/null
    sed -n 's/^ *[0-9]* of [0-9]*  //; s/ *[0-9]* passed, 0 failed.* s$//p' said | tr '\n' ' '
}
usual=$(order '')
sorted() { printf '%s\n' "$1" | tr ' ' '\n' | LC_ALL=C sort; }
n_orders=$(for seed in 1 2 3 4 5; do order $seed && echo; done | sort -u | wc -l)
[ "$n_orders" -gt 1 ]
ok $? "seeds give several orders" "five gave $n_orders"
check "a seed always gives the same" test "$(order 7)" = "$(order 7)"
echo 5 >build/tests/one.seconds
echo 9 >build/tests/two.seconds
echo 0 >build/tests/good.seconds
check "without a seed those that took longest are first" sh -c "printf '%s' '$(order '')' | grep -q 'two one.* good'"
check "every test runs" test "$(sorted "$(order 7)")" = "$(sorted "$usual")"
check "the seed is said" says "in the order of seed 7"
ORDER=random
export ORDER
check "what is no number is refused" runs 2
check "with a message" says 'ORDER: found "random", expected a whole number'
unset ORDER

# ---- What has passed before ---------------------------------------------------------------------

# The programs of `make test` have no sanitizers.
cp build/sanitized/tests/test_* build/tests
printf '. tests/tap.sh\n[ ! -e build/broken ]\nok $? whole\nfinish\n' >tests/suites/whole.sh

# again N: does `make test` pass without running N of its tests?
again() {
    status=0
    HEART=1 BUILD=build tests/run.sh >build/again 2>&1 </dev/null || status=$?
    cat build/again
    [ $status -eq 0 ] && [ "$(grep -c 'not run again$' build/again)" -eq "$1" ]
}
n_all=$(find tests/suites tests/unit -type f | wc -l)
check "the first time all tests run" again 0
check "with nothing changed none runs again" again "$n_all"
check "the sum is the same" test "$(tail -n 1 build/again)" = "$((n_all + 2)) passed, 0 failed"
echo '# more' >>tests/suites/one.sh
check "with a file changed all run" again 0
echo '# more' >>build/tests/test_b
check "and with a program changed" again 0
: >build/broken
echo '# more' >>tests/suites/one.sh
! again 0 >/dev/null
ok $? "one fails"
rm build/broken
check "what failed runs again, and no other" again $((n_all - 1))
check "what is asked for by its name runs" env HEART=1 BUILD=build sh -c 'tests/run.sh one | grep -q "  *[0-9]* s$"'
rm tests/suites/whole.sh

# ---- Told to end --------------------------------------------------------------------------------

# A suite and a unit test that wait, each beside a process in a group of its own, as timeout makes one.
cat >tests/suites/long.sh <<'END'
. tests/tap.sh
echo "$scratch" >suite-folder
timeout 1000 sleep 1000 &
echo $! $$ >suite-pids.new
mv suite-pids.new suite-pids
wait
END
unit build/sanitized/tests/test_long <<'END'
timeout 1000 sleep 1000 &
echo $! $$ >unit-pids.new
mv unit-pids.new unit-pids
wait
END

# The caller has one process group with run.sh, and no signal is ignored in it, as in a terminal.
cat >caller.sh <<'END'
trap : INT
caller=$$ BUILD=build sh -c 'echo $$ $caller >caller-pids.new
    mv caller-pids.new caller-pids
    exec tests/run.sh long test_long' >said 2>&1
echo $? >survived
END

both_run() { [ -e suite-pids ] && [ -e unit-pids ] && [ -e caller-pids ]; }
# shellcheck disable=SC2013 # words
have_ended() {
    for process in $(cat ./*-pids); do
        ! kill -0 "$process" 2>/dev/null || return 1
    done
}

# told SIGNAL STATUS: start both, send the signal to run.sh, as `kill` does, or to the whole group of
# its caller, as a terminal does. It ends with the status.
told() {
    rm -f ./*-pids survived
    setsid --fork env --default-signal=HUP,INT,TERM sh ./caller.sh </dev/null
    check "$1: a suite and a unit test wait" await both_run
    read -r runner caller <caller-pids
    case $1 in
    Ctrl-C) kill -s INT -- "-$caller" ;;
    *) kill -s "$1" "$runner" ;;
    esac
    check "$1: all that was started ends" await have_ended
    check "$1: its caller lives on" test "$(cat survived)" = "$2"
    check "$1: and the suite's folder goes" test ! -e "$(cat suite-folder)"
}
told TERM 143
told HUP 129
told Ctrl-C 130

cd "$course" || exit 1
finish

#!/bin/sh
# tests/run.sh itself, with tests that are made up here: a test that does not come to a good end is a failure, however it
# ends, and all of it ends when it is told to, but nothing of its caller's.
. tests/tap.sh
# Which programs it takes is its own choice.
unset QUICK

course=$PWD
mkdir -p "$scratch/tests/suites" "$scratch/tests/unit" "$scratch/build/tests" "$scratch/build/sanitized/tests"
cp tests/run.sh tests/run_one.sh tests/tap.sh "$scratch/tests"
cd "$scratch" || exit 1

# unit NAME: a unit test, a script on stdin, and its source; its TAP is asked for as --tap=FILE.
# shellcheck disable=SC2016 # for the script that is written
unit() {
    { printf '#!/bin/sh\ntap=${3#--tap=}\n'; cat; } >"build/sanitized/tests/$1"
    chmod +x "build/sanitized/tests/$1"
    cp "build/sanitized/tests/$1" build/tests
    : >"tests/unit/$1.c"
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

unit test_right <<'END'
printf 'ok 1\nok 2\n' >"$tap"
END
cp build/sanitized/tests/test_right build/sanitized/tests/test_gone
printf '. tests/tap.sh\nok 0 good\nok 0 better\nskip other why\nfinish\n' >tests/suites/good.sh
check "all pass" runs 0
check "the last line counts them, but not what has no source" test "$(tail -n 1 said)" = "4 passed, 0 failed"
check "a suite's line" says "good                            2 passed, 0 failed, 1 skipped"
unit test_killed <<'END'
kill -9 $$
END

# A suite | what it does | what is said of it.
while IFS='|' read -r title script words; do
    printf '%b' "$script" >tests/suites/bad.sh
    check "a suite that $title, beside a good one" runs 1 bad good
    check "it is said that it $title" says "$words"
done <<'END'
fails|. tests/tap.sh\nok 0 good\nok 1 bad "the reason"\nfinish\n|      # the reason
dies|. tests/tap.sh\nok 0 good\nexit 3\n|    not ok - the suite ended with exit status 3
has no test|:\n|    not ok - the suite ran no test
ends before its plan|. tests/tap.sh\nok 0 good\nexit 0\nok 1 bad\nfinish\n|    not ok - the suite ended before its plan
is killed with its parent|kill -9 $PPID $(sed "s/.*) . \\([0-9]*\\) .*/\\1/" "/proc/$PPID/stat")\n|not run to its end: bad
END
rm tests/suites/bad.sh
check "a unit test that is killed" runs 1 test_killed
check "says so" says "    not ok - the suite ended with exit status 137"
rm tests/unit/test_killed.c
check "a name that is no test's" runs 1 good none-such
check "is refused" says "no test is called: none-such"

# ---- In another order, and not again ---------------------------------------------------------------

printf '. tests/tap.sh\nok 0 good\nfinish\n' | tee tests/suites/one.sh tests/suites/three.sh >tests/suites/two.sh

# order SEED: the names in the order that they ran in.
order() {
    JOBS=1 ORDER=$1 runs 0 >/dev/null
    sed -n 's/^ *[0-9]* of [0-9]*  //; s/ *[0-9]* passed, 0 failed.* s$//p' said | tr '\n' ' '
}
[ "$(for seed in 1 2 3 4 5; do order $seed && echo; done | sort -u | wc -l)" -gt 1 ]
ok $? "seeds give several orders"
check "a seed always gives the same" test "$(order 7)" = "$(order 7)"

# again N: does `make test` pass without running N of its tests?
again() {
    status=0
    QUICK=1 BUILD=build tests/run.sh >build/again 2>&1 </dev/null || status=$?
    cat build/again
    [ $status -eq 0 ] && [ "$(grep -c 'not run again$' build/again)" -eq "$1" ]
}
printf '. tests/tap.sh\n[ ! -e build/broken ]\nok $? whole\nfinish\n' >tests/suites/whole.sh
n_all=$(find tests/suites tests/unit -type f | wc -l)
check "the first time all tests run" again 0
check "with nothing changed none runs again" again "$n_all"
echo '# more' >>tests/suites/one.sh
check "with a file changed all run" again 0
echo '# more' >>build/tests/test_right
check "and with a program changed" again 0
: >build/broken
echo '# more' >>tests/suites/one.sh
! again 0 >/dev/null
ok $? "one fails"
rm build/broken
check "what failed runs again, and no other" again $((n_all - 1))
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
unit test_long <<'END'
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
told Ctrl-C 130

cd "$course" || exit 1
finish

# shellcheck shell=sh
# The Test Anything Protocol for the suites in tests/suites/*.sh. A suite starts with
#     . tests/tap.sh
# calls `ok` or `check` for each test, and ends with `finish`.

n_tests=0
n_failed=0
# The tests choose devices and sandboxes themselves.
unset COURSE_DEVICE COURSE_SANDBOX
scratch=$(mktemp -d "${TMPDIR:-/tmp}/suite-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
# A second signal shall not end the clearing up.
trap 'trap "" HUP INT TERM; exit 1' HUP INT TERM

# ok STATUS NAME [WHY]: one test; STATUS 0 passes, and WHY is printed where it fails.
ok() {
    n_tests=$((n_tests + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $n_tests - $2"
    else
        n_failed=$((n_failed + 1))
        echo "not ok $n_tests - $2"
        [ $# -lt 3 ] || printf '%s\n' "$3" | sed 's/^/  # /'
    fi
}

# check NAME COMMAND...: passes when the command does; what it printed is shown where it fails, below the
# command, of which a list of all files is no news.
check() {
    name=$1
    shift
    if output=$("$@" 2>&1); then ok 0 "$name"; else ok 1 "$name" "$(printf '$ %s' "$*" | cut -c 1-300)
$output"; fi
}

# skip NAME WHY: a test that cannot run here.
skip() {
    n_tests=$((n_tests + 1))
    echo "ok $n_tests - $1 # SKIP $2"
}

# pass_on FILE: lines of TAP that another program has written, numbered on.
pass_on() {
    while IFS= read -r line; do
        case $line in
        "ok "*) ok 0 "${line#ok * - }" ;;
        "not ok "*) ok 1 "${line#not ok * - }" ;;
        "  # "*) echo "$line" ;;
        esac
    done <"$1"
}

# `make test` sets QUICK: each suite tries its quick part, so that all together take minutes. `make test-all` and
# `tests/run.sh NAME` try all.

# quick "WORDS" ALL...: prints WORDS in `make test`, else ALL.
quick() {
    if [ -n "${QUICK:-}" ]; then echo "$1"; else shift && echo "$*"; fi
}

# quick_ends: in `make test` the suite ends here.
quick_ends() {
    [ -z "${QUICK:-}" ] || { finish; exit; }
}

# await COMMAND...: until the command does. What has not come after ten minutes never will.
await() {
    tries=12000
    until "$@"; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        sleep 0.05
    done
}

# The plan, and the suite's exit status.
finish() {
    echo "1..$n_tests"
    [ "$n_failed" -eq 0 ]
}

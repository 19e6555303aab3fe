#!/bin/sh
# Every attack in tests/attacks/ earns nothing, harms nothing and is named in the report, in each of
# the grader's sandboxes; and beside all of them right submissions get their 100 points.
#
#     sh tests/suites/attacks.sh [ATTACK...]     from the top folder, after `make tests`
#
# SANDBOXES="bubblewrap landlock" chooses the sandboxes.
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
export BUILD="$build"
sandboxes=${SANDBOXES:-bubblewrap landlock}
[ $# -gt 0 ] || set -- tests/attacks/*/*

# Whoever the grader runs as may enter: what is unreadable shall be so because of the sandbox.
chmod 711 "$scratch"

# ---- What the attacks aim at ----------------------------------------------------------------------

# One word that stands in every secret, and nowhere else.
canary=CANARY$(od -An -N8 -tx8 /dev/urandom | tr -d ' ')
echo "$canary" >"$scratch/canary"
mkdir -p "$scratch/class/neighbour" "$scratch/reference"
echo "// $canary" | cat - solutions/02-kdtree-2d-build/kdtree2d_build.c \
    >"$scratch/class/neighbour/kdtree2d_build.c"
echo "$canary" >"$scratch/reference/picture.csv"
chmod -R a+rX "$scratch/class" "$scratch/reference"

# Somebody else's process of the sandbox's own user, where the grader runs as root.
as_nobody=
[ "$(id -u)" -ne 0 ] || as_nobody='setpriv --reuid 65534 --regid 65534 --clear-groups'
# shellcheck disable=SC2086 # a command
$as_nobody sleep 1000 &
bystander=$!
"$build/tools/listener" "$scratch/listener" &
listener=$!
trap 'kill "$bystander" "$listener" 2>/dev/null; rm -rf "$scratch"' EXIT
while [ ! -s "$scratch/listener" ] && kill -0 "$listener"; do sleep 0.1; done

cat >"$scratch/facts" <<END
s|@COURSE@|$PWD|g
s|@NEIGHBOUR@|$scratch/class/neighbour/kdtree2d_build.c|g
s|@REFERENCE@|$scratch/reference/picture.csv|g
s|@PORT@|$(cat "$scratch/listener")|g
s|@BYSTANDER@|$bystander|g
s|@TESTER@|$(id -u)|g
s|@BUILD@|$build|g
END

mkdir "$scratch/checks"
for lab in solutions/*; do
    "$build/tools/grade" --lab "${lab#*/}" --list-checks >"$scratch/checks/${lab#*/}"
done

# ---- Trying them, two at a time -------------------------------------------------------------------

# The work of one sandbox, a line each: attacks with a right submission after every sixth, so that
# one is graded beside each kind of attack, and one of each lab after all.
list_work() {
    number=0
    for attack; do
        number=$((number + 1))
        echo "$sandbox $attack"
        [ $((number % 6)) -ne 0 ] || echo "$sandbox 02-kdtree-2d-build beside-$number"
    done
    for lab in 00-hello-pixels 01-naive-2d 02-kdtree-2d-build 03-kdtree-2d-render; do
        echo "$sandbox $lab afterwards"
    done
}

for sandbox in $sandboxes; do
    case $sandbox in
    landlock)
        if [ "$(id -u)" -ne 0 ]; then
            skip "$sandbox: all attacks" "it needs root, to become another user"
            continue
        fi
        ;;
    esac
    list_work "$@" >"$scratch/work.$sandbox"
    xargs -P 2 -L 1 sh tests/attacks/try.sh "$scratch" <"$scratch/work.$sandbox"
    while read -r _ attack when; do
        name=$(basename "${attack%.*}")
        place=$scratch/$name.$sandbox${when:+.$when}
        [ -f "$place/why" ] && [ ! -s "$place/why" ]
        ok $? "$sandbox: ${when:+right submission $when: }${attack#tests/attacks/}" \
            "$(cat "$place/why")"
    done <"$scratch/work.$sandbox"
    kill -0 "$bystander"
    ok $? "$sandbox: a process of the same user is still alive"
    [ ! -e "$scratch/listener.reached" ]
    ok $? "$sandbox: nobody reached the listener" "$(cat "$scratch/listener.reached" 2>&1)"
done

finish

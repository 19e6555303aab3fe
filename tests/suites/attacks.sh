#!/bin/sh
# Every attack in tests/attacks/ earns nothing, harms nothing and is named in the report, in the
# grader's sandboxes; and beside all of them right submissions get their 100 points.
#
#     sh tests/suites/attacks.sh [ATTACK...]     from the top folder, after `make tests`
#
# SANDBOXES="bubblewrap landlock user" chooses the sandboxes. Without it and without
# ATTACKs, those that try the walls meet every sandbox; the others, which try what judges and reports
# them and is the same whatever the sandbox, take turns between the first two. `make test-attacks` tries
# all in each.
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
export BUILD="$build"
sandboxes=${SANDBOXES:-bubblewrap landlock user}
# Only root can have more than one.
taking_turns=
[ -n "${SANDBOXES:-}" ] || [ $# -gt 0 ] || [ "$(id -u)" -ne 0 ] || taking_turns=yes
walls='
    include-neighbour include-shadow incbin link-to-solution kernel-includes
    text-of-other-tasks words-when-alone
    read-grader read-neighbour read-own-process read-other-runs read-reference read-seed read-shadow read-solution shell
    disk-filler files-in-memory files-without-number folders-without-bottom fork-bomb memory-hogs
    survivor shared-memory poisoned-cache answers-a-link signals ptrace network preload
    talk-by-counters talk-by-futex talk-by-locks talk-by-page-cache talk-by-pipes kernel-locks process-1 process-1-limits
    walls-of-its-own held-behind-the-first-thread held-by-a-memory-file held-by-a-page
    mappings-without-number memory-behind-mappings open-files-without-number bytes-in-sockets pages-in-pipes
'

# What `make test` tries in each sandbox: files, the network, processes without number, one that stays.
quick='read-reference.c network.c fork-bomb.c survivor.c'

# Whoever the grader runs as may enter: what is unreadable shall be so because of the sandbox, but for
# where the sandbox goes by the rights of files.
chmod 711 "$scratch"
mkdir -m 700 "$scratch/answers"

# ---- What the attacks aim at ----------------------------------------------------------------------

# One word that stands in every secret, and nowhere else.
canary=CANARY$(od -An -N8 -tx8 /dev/urandom | tr -d ' ')
echo "$canary" >"$scratch/canary"
mkdir -p "$scratch/class/neighbour" "$scratch/reference"
echo "// $canary" | cat - solutions/02-kdtree-2d-build/kdtree2d_build.c \
    >"$scratch/class/neighbour/kdtree2d_build.c"
echo "$canary" >"$scratch/reference/picture.csv"

# Somebody else's process of the sandbox's own user, where the grader runs as root.
as_nobody=
[ "$(id -u)" -ne 0 ] || as_nobody='setpriv --reuid 65534 --regid 65534 --clear-groups'
# Until it is killed at the end, however long the attacks take here.
# shellcheck disable=SC2086 # a command
$as_nobody sleep infinity &
bystander=$!
"$build/tools/listener" "$scratch/listener" &
listener=$!
trap 'kill "$bystander" "$listener" 2>/dev/null; rm -rf "$scratch"' EXIT
while [ ! -s "$scratch/listener" ] && kill -0 "$listener"; do sleep 0.1; done

mkdir "$scratch/checks"
for lab in solutions/*; do
    "$build/tools/grade" --lab "${lab#*/}" --list-checks >"$scratch/checks/${lab#*/}"
done

# set_scene SANDBOX: what an instructor has to close there is closed; else everybody may read all.
# Sets the course's top folder.
set_scene() {
    top=$PWD
    export BUILD="$build"
    chmod -R a+rX "$scratch/class" "$scratch/reference"
    case $1 in
    user)
        top=$scratch/course
        [ -d "$top" ] || tests/closed_course.sh "$top"
        export BUILD="$top/build"
        chmod 700 "$scratch/class" "$scratch/reference"
        ;;
    esac
    cat >"$scratch/facts" <<END
s|@COURSE@|$top|g
s|@NEIGHBOUR@|$scratch/class/neighbour/kdtree2d_build.c|g
s|@REFERENCE@|$scratch/reference/picture.csv|g
s|@PORT@|$(cat "$scratch/listener")|g
s|@BYSTANDER@|$bystander|g
s|@TESTER@|$(id -u)|g
s|@BUILD@|$BUILD|g
END
}

# chosen SANDBOX ATTACK...: the attacks that are tried in it, a line each.
chosen() {
    sandbox=$1
    shift
    if [ $# -gt 0 ]; then
        printf '%s\n' "$@"
        return
    fi
    [ -z "${QUICK:-}" ] || {
        # shellcheck disable=SC2086 # words
        printf 'tests/attacks/02-kdtree-2d-build/%s\n' $quick
        return
    }
    turn=landlock
    for attack in tests/attacks/*/*; do
        # Half a minute of all processors: for `make test-attacks`.
        [ -z "$taking_turns" ] || [ "$(basename "$attack")" != starves-itself.c ] || continue
        if [ -n "$taking_turns" ]; then
            case $walls in
            *[[:space:]]"$(basename "${attack%.*}")"[[:space:]]*) ;;
            *)
                case $turn in landlock) turn=bubblewrap ;; *) turn=landlock ;; esac
                [ "$sandbox" = $turn ] || continue
                ;;
            esac
        fi
        echo "$attack"
    done
}

# ---- Trying them, two at a time -------------------------------------------------------------------

# The work of one sandbox, a line each: attacks with a right submission of host files after every sixth, so
# that one is graded beside each kind of attack; after all, one of host files and kernels and one of kernels.
list_work() {
    number=0
    for attack; do
        number=$((number + 1))
        echo "$sandbox $attack"
        [ $((number % 6)) -ne 0 ] || echo "$sandbox 02-kdtree-2d-build beside-$number"
    done
    for lab in $(quick 03-kdtree-2d-render 00-hello-pixels 03-kdtree-2d-render); do
        echo "$sandbox $lab afterwards"
    done
}

for sandbox in $sandboxes; do
    case $sandbox in
    landlock | user)
        if [ "$(id -u)" -ne 0 ]; then
            skip "$sandbox: all attacks" "it needs root, to become another user"
            continue
        fi
        ;;
    esac
    set_scene "$sandbox"
    # shellcheck disable=SC2046 # names without blanks
    list_work $(chosen "$sandbox" "$@") >"$scratch/work.$sandbox"
    (cd "$top" && xargs -P 2 -L 1 sh tests/attacks/try.sh "$scratch") <"$scratch/work.$sandbox"
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

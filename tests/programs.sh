# shellcheck shell=sh disable=SC2034,SC2154,SC2317 # sourced, behind tests/tap.sh; used by the suites
# What the suites about the solution programs share: running them, and asking whether they drew, said
# or refused what they should.
#
#     . tests/tap.sh
#     . tests/programs.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
unset COURSE_DEVICE

# The folder for what the programs write. In it lies a picture from before, to be left alone by every
# program that fails.
out=$scratch/out
scenes=$scratch/scenes
mkdir "$out" "$scenes"

# One program compares and cuts all pictures of a suite, as loading the library for that takes long; it ends
# with the suite, which alone holds the other end of what it reads.
mkfifo "$scratch/requests" "$scratch/statuses"
"$build/tools/pictures" "$scratch/tool-said" "$scratch/tool-complained" \
    <"$scratch/requests" >"$scratch/statuses" 2>/dev/null &
exec 8>"$scratch/requests" 9<"$scratch/statuses"

# picture_tool NAME ARGUMENT...: as if build/tools/NAME were run here.
picture_tool() {
    : >"$scratch/tool-said"
    : >"$scratch/tool-complained"
    printf '%s\n' $(($# + 1)) "$PWD" "$@" >&8
    read -r tool_status <&9 || tool_status=2
    cat "$scratch/tool-said"
    cat "$scratch/tool-complained" >&2
    return "$tool_status"
}
compare() { picture_tool compare "$@"; }
crop() { picture_tool crop "$@"; }

# run LAB OPTION...: a solution program by its number; what it says goes to $scratch/stdout and stderr.
run() (
    for program in "$build/solutions/$1"-*; do :; done
    shift
    "$program" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null
)

# run_into FILE LAB OPTION...: the same with its standard output going there; "-" closes it.
run_into() (
    into=$1
    for program in "$build/solutions/$2"-*; do :; done
    shift 2
    if [ "$into" = - ]; then
        "$program" "$@" 2>"$scratch/stderr" </dev/null >&-
    else
        "$program" "$@" >"$into" 2>"$scratch/stderr" </dev/null
    fi
)

# run_limited LAB OPTION...: the same for at most ten minutes, for what might wait for ever.
run_limited() (
    for program in "$build/solutions/$1"-*; do :; done
    shift
    timeout 600 "$program" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null
)

# run_sanitized LAB OPTION...: the same with the sanitizers watching. What drivers leak is theirs:
# `with detect_leaks=0` where a device is opened.
run_sanitized() (
    for program in "$build/sanitized/solutions/$1"-*; do :; done
    shift
    export ASAN_OPTIONS="detect_leaks=${detect_leaks:-1}:allocator_may_return_null=1"
    "$program" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null
)

is_sanitized=false
[ ! -x "$build/sanitized/solutions/03-kdtree-2d-render" ] || is_sanitized=true

# with NAME=VALUE COMMAND...: the command with one more variable around it.
with() (
    export "${1?}"
    shift
    "$@"
)

# works COMMAND...: does it end with 0? A sanitizer's or a program's words are shown if not.
works() {
    if "$@"; then return 0; fi
    cat "$scratch/stdout" "$scratch/stderr"
    return 1
}

# has_size FILE WxH: can the picture be read, and is it as large as that?
has_size() {
    found=$(compare "$1" "$1") || { echo "$found"; return 1; }
    [ "$found" = "$2: equal" ] || { echo "$1: found $found, expected $2"; return 1; }
}

# draws LAB WxH FILE OPTION...: does the program write a picture of this size?
draws() {
    lab=$1 size=$2 file=$3
    shift 3
    rm -f "$file"
    works run "$lab" --output "$file" "$@" && has_size "$file" "$size"
}

# differs COMMAND...: does `compare` find two pictures of one size that are not the same?
differs() {
    "$@" >"$scratch/found"
    [ $? -eq 1 ] && grep -q 'pixels differ' "$scratch/found"
}

# figure NAME: its value in $out/figures.json.
figure() { sed -n "s/^  \"$1\": \(.*[^,]\),\{0,1\}\$/\1/p" "$out/figures.json"; }

# is_json: one object, a figure a line, commas between them and none at the end?
is_json() {
    awk 'function wrong() { print "line " NR ": " $0; bad = 1 }
        NR == 1 { if ($0 != "{") wrong(); next }
        ended { wrong() }
        $0 == "}" { ended = 1; if (comma) wrong(); next }
        { if (NR > 2 && !comma) wrong(); comma = sub(/,$/, "") }
        !/^  "[a-zA-Z_.]+": ("([^"\\]|\\.)*"|-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?|null)$/ { wrong() }
        END { exit bad || !ended }' "$out/figures.json"
}

# has_figures NAME...: exactly these, in this order?
has_figures() {
    sed -n 's/^  "\([^"]*\)":.*/\1/p' "$out/figures.json" >"$scratch/names"
    printf '%s\n' "$@" | diff "$scratch/names" -
}

# empty_output_folder: start afresh, with a picture and figures from before, and places where nothing
# can be written. What programs that fail leave behind is seen there.
empty_output_folder() {
    rm -rf "$out"
    mkdir "$out" "$out/folder.png"
    run 00 --size 2x2 --output "$out/old.png"
    echo '{}' >"$out/old.json"
    ln -s /dev/full "$out/full.png"
}

# small_disk COMMAND...: with room for files of 4 KB.
small_disk() (
    trap '' XFSZ
    ulimit -f 8
    "$@"
)

# A folder that full_disk() covers with a small disk, for itself alone: as root, or where users may
# have namespaces. `namespace` is empty where neither works.
small_disk=$scratch/small-disk
mkdir "$small_disk"
namespace=
for try in 'unshare --mount' 'unshare --map-root-user --mount'; do
    if [ -z "$namespace" ] && $try mount -t tmpfs -o size=8k tiny "$small_disk" 2>/dev/null; then
        namespace=$try
    fi
done

# full_disk LIMITS COMMAND...: with a disk of such LIMITS at $small_disk, which holds two files with the
# word "old"; what lies there afterwards goes to $scratch/left.
full_disk() {
    # shellcheck disable=SC2016,SC2086 # they are another shell's variables; the words of a command
    $namespace sh -c '
        mount -t tmpfs -o "$3" tiny "$1" && echo old >"$1/old.png" && echo old >"$1/old.exr" ||
            exit 125
        small_disk=$1 left=$2 status=0
        shift 3
        "$@" || status=$?
        (cd "$small_disk" && ls -A && cat old.png old.exr) >"$left"
        exit $status' full_disk "$small_disk" "$scratch/left" "$@"
}

# fails_on_a_disk LIMITS LEFT WORDS LAB OPTION...: with a disk of such LIMITS, does the program say
# WORDS, and are the files LEFT there, the old ones as they were?
fails_on_a_disk() {
    limits=$1 left=$2 words=$3 lab=$4
    shift 4
    for program in "$build/solutions/$lab"-*; do :; done
    status=0
    full_disk "$limits" "$program" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null || status=$?
    cat "$scratch/stderr"
    [ "$status" -eq 1 ] || { echo "found exit status $status, expected 1"; return 1; }
    [ "$(wc -l <"$scratch/stderr")" -eq 1 ] || { echo "expected one line"; return 1; }
    grep -qF -- "$words" "$scratch/stderr" || { echo "expected the words: $words"; return 1; }
    [ "$(tr '\n' ' ' <"$scratch/left")" = "$left old old " ] ||
        { echo "it left: $(cat "$scratch/left")"; return 1; }
}

# fails_on_a_full_disk WORDS LAB OPTION...: does it say so, and leave what was there and no more? A disk
# may also be full of entries: two pages hold the two old files and no third.
fails_on_a_full_disk() { fails_on_a_disk size=8k "old.exr old.png" "$@"; }

# fails_to_save NUMBER...: pictures and figures of these labs where there is no room for them. A limit
# on the size of files stops PoCL before the picture, so it is for the labs that need no device.
fails_to_save() {
    for number; do
        scene='--scene random:n=40'
        [ "$number" != 00 ] || scene=
        for ending in png exr; do
            case $number in
            02 | 06)
                # shellcheck disable=SC2086 # no scene, no word
                check "lab $number: no room for a .$ending" \
                    refuses "cannot be written: File too large" small_disk \
                    run "$number" --size 317x211 $scene --output "$out/new.$ending"
                ;;
            esac
            if [ -z "$namespace" ]; then
                skip "lab $number: a full disk, .$ending" "no small disk can be mounted here"
                continue
            fi
            # shellcheck disable=SC2086
            check "lab $number: a full disk, .$ending" \
                fails_on_a_full_disk "cannot be written: No space left on device" \
                "$number" --size 317x211 $scene --output "$small_disk/old.$ending"
        done
        [ -z "$namespace" ] || check "lab $number: a full disk for the figures" \
            fails_on_a_full_disk "new.json: cannot be written: No space left on device" \
            "$number" --size 64x48 --output "$out/figures.exr" --stats "$small_disk/new.json"
        rm -f "$out"/figures.*
    done
}

# fails_for_heat_map NUMBER: the same for what --heat-map saves beside the picture, on a disk with an
# entry for the picture, which is saved before, and none for more.
fails_for_heat_map() {
    if [ -z "$namespace" ]; then
        skip "lab $1: a full disk for the heat map" "no small disk can be mounted here"
        return
    fi
    check "lab $1: a full disk for the heat map" \
        fails_on_a_disk nr_inodes=4 "new.png old.exr old.png" \
        "new-work.exr: cannot be written: No space left on device" \
        "$1" --size 317x211 --scene random:n=40 --heat-map --output "$small_disk/new.png"
}

# state: what is in the output folder, and whether what was there before is as it was.
state() { ls -A "$out" && cksum "$out/old.png" "$out/old.json"; }

# refuses WORDS COMMAND...: does it end with a fault, one line that holds WORDS, and leave nothing?
refuses() {
    words=$1
    shift
    before=$(state)
    status=0
    "$@" || status=$?
    cat "$scratch/stderr"
    if [ "$status" -eq 0 ] || [ "$status" -ge 126 ]; then
        echo "found exit status $status, expected a fault's"
        return 1
    fi
    # The address sanitizer comments on memory that it could not give.
    grep -v 'WARNING: AddressSanitizer failed to allocate' "$scratch/stderr" >"$scratch/message"
    [ "$(wc -l <"$scratch/message")" -eq 1 ] || { echo "expected one line"; return 1; }
    # Nothing in it may move the terminal's cursor, whatever a file is called.
    ! tr -d '\n' <"$scratch/message" | LC_ALL=C grep -q '[[:cntrl:]]' ||
        { echo "found a control character"; return 1; }
    grep -qF -- "$words" "$scratch/message" || { echo "expected the words: $words"; return 1; }
    [ "$(state)" = "$before" ] || { echo "it left something: $(ls -A "$out")"; return 1; }
}

# What a run that fails would have drawn.
new="$out/new.png"

# refuses_each: reads a table of LAB | WORDS | OPTIONS. Each row is run with and without sanitizers;
# `--output $new` comes first, so that a row can say otherwise.
refuses_each() {
    while IFS='|' read -r number words options; do
        eval "set -- $options"
        check "lab $number: $options" refuses "$words" run "$number" --output "$new" "$@"
        ! $is_sanitized || check "lab $number, sanitized: $options" \
            refuses "$words" run_sanitized "$number" --output "$new" "$@"
    done
}

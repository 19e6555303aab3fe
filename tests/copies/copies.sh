#!/bin/sh
# Which answers of a class are alike; `make copies` calls this.
#
#     tests/copies/copies.sh [OPTION VALUE]...
#
#     --lab 03               may be left out if OUTPUT was graded
#     --submissions FOLDER   or a zip or tar archive of it; may be left out if OUTPUT was graded
#     --output FOLDER        where everything goes (build/class/03)
#     --export TOOL          jplag, dolos or moss: also writes the answers for it
#     --build FOLDER         the build folder (build)
#
# Nothing of a graded class in OUTPUT changes. Exit status: 0, or 2 after one message. Read next:
# copies_tool.c.
set -u
export LC_ALL=C
# shellcheck source=tests/class/grading/one_run.sh
. tests/class/grading/one_run.sh

die() {
    printf 'copies: %s\n' "$*" >&2
    exit 2
}

lab='' submissions='' output='' other='' build=build
while [ $# -gt 0 ]; do
    [ $# -gt 1 ] || die "$1: expected a value"
    case $1 in
    --lab) lab=$2 ;;
    --submissions) submissions=$2 ;;
    --output) output=$2 ;;
    --export) other=$2 ;;
    --build) build=$2 ;;
    *) die "$1: no such option" ;;
    esac
    shift 2
done
[ -n "$lab$output" ] || die "say which lab: LAB=03"
# No path shall look like an option.
case $submissions in -*) submissions=./$submissions ;; esac
case $output in -*) output=./$output ;; esac

# of_folder FOLDER: the lab that a class's folder says it is of.
of_folder() { head -n 1 "$1/lab" 2>/dev/null; }

# "3", "03" or the whole name.
given=${lab:-$(of_folder "$output")}
[ -n "$given" ] || die "$output: found no graded class, expected LAB= and SUBMISSIONS="
found=
for folder in labs/*; do
    name=${folder#labs/}
    case $name in
    "$given" | "$given"-* | "0$given"-*) found=$name ;;
    esac
done
[ -n "$found" ] || die "--lab: found \"$given\", expected the number or name of a lab"
lab=$found
number=${lab%%-*}
output=${output:-$build/class/$number}
was=$(of_folder "$output")
[ "${was:-$lab}" = "$lab" ] || die "$output: found a class of $was, expected one of $lab (OUTPUT=)"

if [ -z "$submissions" ]; then
    [ -e "$output/roster.json" ] || die "$output: found no graded class, expected SUBMISSIONS="
else
    [ -e "$submissions" ] || die "$submissions: not there"
    inside=$(realpath -m "$output") around=$(realpath -m "$submissions")
    case $inside/ in
    "$around"/*) die "$output: found OUTPUT in SUBMISSIONS, expected it elsewhere" ;;
    esac
    case $around/ in
    "$inside"/*) die "$submissions: found SUBMISSIONS in OUTPUT ($output), expected it elsewhere" ;;
    esac
fi
# Whoever else has an account here has no business with others' answers.
[ -d "$output" ] || { mkdir -p "$output" && chmod o-rwx "$output"; } || die "$output: cannot be made"
output=$(cd "$output" && pwd -P)

# Neither beside a grading nor beside another run.
folder_hold "$output" "make copies"
work=
trap '[ -z "$work" ] || rm -rf "$work"' EXIT
trap 'stop' INT TERM HUP PIPE

# A list of the class of its own, so that the one that was graded stays as it is.
class=$output
if [ -n "$submissions" ]; then
    class=$output/copies
    rm -rf "$class"
    mkdir -m 700 "$class" || exit 2
    if [ -f "$submissions" ]; then
        work=$(mktemp -d "${TMPDIR:-/tmp}/copies-XXXXXX") || exit 2
        # The sandbox's user passes through it.
        { chmod 711 "$work" && mkdir -m 711 "$work/export" &&
            attend "$build/tools/gradebook" unpack "$build" "$submissions" "$work/export" >"$work/unpacked" &&
            attend sh -c 'umask 077 && exec cp -RPT --preserve=timestamps "$@"' - \
                "$(cat "$work/unpacked")" "$class/export"; } || exit 2
        submissions=$class/export
    fi
    attend "$build/tools/gradebook" roster "${number#0}" "$submissions" "$class" >/dev/null || exit 2
fi
attend "$build/tools/copies" --build "$build" ${other:+--export "$other"} -- lab "$lab" "$class" "$output"

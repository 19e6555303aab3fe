#!/bin/sh
# Look at everything that the course needs of this machine, and name one command for each thing that is wrong.
#
#     common/setup/doctor.sh [--json] [--for TARGET]      in the course's top folder: make doctor [JSON=1]
#
# TARGET is the one of packages.txt whose packages are looked for: grade (in a handout) or demo (in the course).
# Nothing has to be built or installed for this, and nothing is changed: it compiles two small programs
# (doctor_device.c, doctor_image.c) in a temporary folder, if there is a compiler.
#
# Ends with 0 if all is well, 1 if something is wrong, 2 if it could not look. make ends with 2 for both.
set -u
LC_ALL=C
export LC_ALL

as_json=
target=grade
while [ $# -gt 0 ]; do
    case $1 in
    --json) as_json=yes ;;
    --for) target=${2-} && shift ;;
    *) echo "doctor: found \"$1\", expected --json or --for TARGET" >&2 && exit 2 ;;
    esac
    shift
done
[ -f common/setup/doctor_device.c ] || { echo "doctor: run it in the top folder of the course" >&2 && exit 2; }
. common/setup/advice.sh

# What it compiles goes here, and what it has to say. Where that fails, nothing may seem to be well.
tmp=${TMPDIR:-/tmp}
cannot_write() {
    free=$(room "$tmp")
    mend=$(other_tmp 500)
    echo "doctor: cannot write to $tmp, the folder for what is temporary, where ${free:-an unknown number of} MB are free" >&2
    echo "    run: ${mend:-$(makes_room "$tmp")}" >&2
    exit 2
}
{ work=$(mktemp -d "$tmp/doctor-XXXXXX"); } 2>/dev/null || cannot_write
trap 'rm -rf "$work"' EXIT
trap 'exit 2' HUP INT TERM
# As much as its programs need.
{ head -c 16000000 /dev/zero >"$work/room"; } 2>/dev/null || cannot_write
rm "$work/room"

# ---- What is said -------------------------------------------------------------------------------

# State, name, what was found, the command: a line each, between tabs.
: >"$work/lines"
# said TEXT: on one line, without signs that a terminal obeys.
said() {
    printf '%s' "$1" | tr '\n\t' '  ' | tr -d '\000-\037\177' | cut -c 1-700
}
line() {
    { printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$(said "$3")" "$(said "${4-}")" >>"$work/lines"; } 2>/dev/null || cannot_write
}
# fine NAME FOUND; wrong NAME FOUND COMMAND; note NAME FOUND [COMMAND]: works, but; skipped NAME WHY
fine() { line ok "$@"; }
wrong() { line wrong "$@"; }
note() { line note "$@"; }
skipped() { line skipped "$@"; }

# ---- System -------------------------------------------------------------------------------------

kernel=$(uname -s 2>/dev/null)
name=$(sed -n 's/^PRETTY_NAME="*\([^"]*\)"*$/\1/p' /etc/os-release 2>/dev/null)
version=$(sed -n -e 's/^ID=//p' -e 's/^VERSION_ID=//p' /etc/os-release 2>/dev/null | tr -d '"' | tr '\n' ' ')
words="${name:-$kernel}, $(uname -m)"
! grep -qi microsoft /proc/version 2>/dev/null || words="$words, WSL"
case $kernel in
Linux)
    case $version in
    "debian 12 "* | "12 debian "* | "debian 13 "* | "13 debian "* | "ubuntu 22.04 "* | "22.04 ubuntu "* | "ubuntu 24.04 "* | "24.04 ubuntu "*)
        fine system "$words" ;;
    *) note system "$words: nobody has tried the course here; Debian 12 and 13, Ubuntu 22.04 and 24.04 are known to work" ;;
    esac
    ;;
Darwin)
    wrong system "$words: the course needs Linux; here it runs in a container (nobody has tried this on a Mac yet)" \
        "brew install podman && podman machine init --now && podman build -t kdtrees ."
    ;;
*)
    wrong system "$words: the course needs Linux; on Windows install WSL, and run this in it" "wsl --install -d Debian"
    ;;
esac
case $words:$PWD in
*WSL:/mnt/[a-z]/*) note folder "$PWD is on Windows' disk, which is slow and has no rights: copy the course to your home in WSL" "$(own_copy)" ;;
esac

# ---- Folders, and room in them ------------------------------------------------------------------

build=${BUILD:-build}
if ! can_write . && ! can_write "$build"; then
    wrong folder "$PWD cannot be written to: copy the course into a folder of your own" "$(own_copy)"
elif [ -d "$build" ] && no_rights=$(find "$build" -type d ! -writable 2>/dev/null | head -n 1) && [ -n "$no_rights" ]; then
    wrong folder "$no_rights cannot be written to: another user made it, as with sudo" "mv \"$build\" \"$build-of-another-user-$$\""
else
    fine folder "$PWD can be written to"
fi

# The build folder of a handout takes 60 MB, of the course 250 MB; the grader some MB for each run.
needed=500
for folder in . "$tmp"; do
    free=$(room "$folder")
    if [ -z "$free" ]; then
        skipped disk "df does not say how much room is in $folder"
    elif [ "$free" -ge $needed ]; then
        fine disk "$free MB are free in $folder"
    else
        mend=
        [ "$folder" = . ] || mend=$(other_tmp $needed)
        wrong disk "$free MB are free in $folder, expected $needed${mend:-: this lists what is large there, for you to choose from}" \
            "${mend:-$(makes_room "$folder")}"
    fi
done

# In a handout nothing asks git.
if [ ! -e .git ]; then
    :
elif checkout=$(sh common/setup/checkout.sh); then
    fine git "$(git --version)"
else
    note git "$(echo "$checkout" | sed -n 1p): make handout and make release need it" "$(echo "$checkout" | sed -n 's/^ *run: //p')"
fi

# ---- Packages, tools ----------------------------------------------------------------------------

list=$(sh common/setup/install.sh --print "$target" 2>&1)
if [ -z "$list" ]; then
    fine packages "all are installed that are needed for: $target"
else
    mend=$(echo "$list" | sed -n 2p)
    if has apt-get; then
        ! has make || mend=$(echo "$mend" | sed 's/^sh .*/make setup/')
    elif [ -x /usr/bin/apt-get ]; then
        mend=$(brings_tool apt-get apt)
    fi
    # Elsewhere install.sh says what these packages are.
    wrong packages "missing: $(echo "$list" | sed -n 1p)" "${mend:-Install what these Debian packages hold}"
    free=$(room /usr)
    [ "${free:-2000}" -ge 2000 ] ||
        wrong disk "$free MB are free in /usr, expected 2000 for the packages: this lists what is large there" "$(makes_room /usr)"
fi

if has make; then
    case $(make --version 2>/dev/null | head -n 1) in
    "GNU Make "*) fine make "$(make --version | head -n 1)" ;;
    *) wrong make "this make is not GNU Make" "$(brings_tool make make)" ;;
    esac
else
    wrong make "there is no make" "$(brings_tool make make)"
fi

compiler=
printf '#include <stdio.h>\nint main(void)\n{\n    return puts("") == EOF;\n}\n' >"$work/hello.c"
# compiles COMPILER PACKAGE SOURCE LANGUAGE: a program for one that prints
compiles() {
    if ! has "$1"; then
        wrong "$1" "there is no $1" "$(brings_tool "$1" "$2")"
    elif ! "$1" "$work/hello.c" -x "$3" -o "$work/hello" >"$work/log" 2>&1; then
        wrong "$1" "$1 makes no program: $(grep -m 1 -i -e error -e 'cannot find' "$work/log")" \
            "$(brings_tool "$1" libc6-dev 'linux-libc-dev*' 'gcc*' 'g++*' 'cpp*' 'libgcc-*' 'libstdc++-*' 'binutils*')"
    elif ! "$work/hello" >/dev/null 2>"$work/log"; then
        mend=$(other_tmp $needed)
        wrong "$1" "what $1 makes does not start in $tmp: $(head -n 1 "$work/log")" "${mend:-$(brings_tool "$1" "$2")}"
    else
        fine "$1" "$("$1" --version | head -n 1)"
        return 0
    fi
    return 1
}
! compiles gcc gcc c || compiler=yes
plus=
! compiles g++ g++ c++ || plus=yes
fine python "none is needed"

# ---- OpenCL -------------------------------------------------------------------------------------

# sources NAME...: files of the library.
sources() { for source; do printf 'common/%s.c ' "$source"; done; }
# asks NAME PROGRAM WORD MEND [BEFORE]: a line for what it answers, BEFORE in front; if it cannot, what the function
# MEND PROGRAM WORD FAULT names.
asks() {
    # Our own words, if there are any: what a driver prints is less clear.
    if "$work/$2" "$3" >"$work/found" 2>"$work/fault"; then
        fine "$1" "${5-}$(tail -n 1 "$work/found")"
    else
        fault=$(grep -m 1 '^OpenCL: ' "$work/fault" || grep -v '^ *$' "$work/fault" | head -n 1)
        wrong "$1" "${fault:-$2 $3 ended without a word}" "$("$4" "$work/$2" "$3" "$fault")"
        return 1
    fi
}

device=
# shellcheck disable=SC2046 # a list of files
if [ -z "$compiler" ]; then
    for what in loader platform device layouts; do skipped $what "needs a compiler"; done
elif ! gcc -std=c11 -D_GNU_SOURCE -O0 -Icommon -Ikernels -Icommon/setup common/setup/doctor_device.c \
    $(sources cl_setup cl_build build_log cl_check complain clean_text utf8 number text_file) -lOpenCL -lm \
    -o "$work/doctor_device" >"$work/log" 2>&1; then
    wrong loader "no program for OpenCL can be made: $(grep -m 1 -e 'error:' -e 'cannot find' "$work/log")" \
        "$(brings_tool gcc ocl-icd-opencl-dev 'ocl-icd-*' 'opencl-*-headers' 'libc6-dev*')"
    for what in platform device layouts; do skipped $what "needs the loader"; done
else
    fine loader "libOpenCL and its headers are there"
    device=yes
fi

# Before the device: PoCL has none where it cannot write here; after sudo make parts of it may be root's.
cache=${POCL_CACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/pocl}
above=$cache
while [ ! -e "$above" ] && [ "$above" != / ] && [ "$above" != . ]; do above=$(dirname "$above"); done
no_rights=$(find "$cache" -type d ! -writable 2>/dev/null | head -n 1)
if can_write "$above" && [ -z "$no_rights" ]; then
    fine cache "$cache can be written"
else
    # A folder that nobody else can make first.
    # shellcheck disable=SC2016 # for the user's shell
    wrong cache "PoCL cannot write its cache folder: ${no_rights:-$cache}" 'export POCL_CACHE_DIR="$(mktemp -d)"'
fi

if [ -n "$device" ]; then
    missing=
    for what in platform device layouts; do
        if [ -n "$missing" ]; then
            skipped $what "needs a $missing"
        elif [ $what = platform ]; then
            asks platform doctor_device platforms mend_opencl || missing=platform
        else
            asks $what doctor_device $what mend_opencl || missing=device
        fi
    done
fi

# ---- Pictures -----------------------------------------------------------------------------------

# shellcheck disable=SC2046 # lists of files and options
if [ -z "$compiler$plus" ]; then
    skipped images "needs a compiler"
elif [ -z "$compiler" ] || [ -z "$plus" ]; then
    skipped images "needs both compilers"
elif ! g++ -std=c++17 -O0 -fPIC -shared -Icommon $(pkg-config --cflags OpenImageIO 2>/dev/null) common/image.cpp \
    $(pkg-config --libs OpenImageIO 2>/dev/null) -lOpenImageIO -o "$work/libimage_codec.so" >"$work/log" 2>&1; then
    wrong images "OpenImageIO cannot be used: $(grep -m 1 -e 'error:' -e 'cannot find' "$work/log")" \
        "$(mend_images)"
elif ! gcc -std=c11 -D_GNU_SOURCE -O0 -Icommon common/setup/doctor_image.c \
    $(sources image image_file complain clean_text utf8 text_file output_file output_place path) -ldl -lm \
    -Wl,-rpath,"$work" -o "$work/doctor_image" >"$work/log" 2>&1; then
    wrong images "no program for pictures can be made: $(grep -m 1 -e 'error:' -e 'cannot find' "$work/log")" \
        "$(brings libc6-dev)"
else
    asks images doctor_image "$work" mend_images \
        "OpenImageIO $(pkg-config --modversion OpenImageIO 2>/dev/null): "
fi

# ---- Sandbox ------------------------------------------------------------------------------------

# The walls are tried as the grader's (tests/grader/sandbox/bwrap_arguments.c).
# As root the grader has other sandboxes, with a user of its own for each run (sandbox_user.c). Many a container has
# too few numbers for users.
has_users() {
    awk '$1 <= 1879048192 && 1879048192 - $1 + 2 ^ 23 < $3 { found = 1 } END { exit !found }' /proc/self/uid_map 2>/dev/null
}
if ! has bwrap; then
    wrong sandbox "there is no bwrap" "$(brings_tool bwrap bubblewrap)"
elif bwrap --unshare-all --unshare-user --disable-userns --die-with-parent --new-session --cap-drop ALL \
    --ro-bind / / --proc /proc --dev /dev true >"$work/log" 2>&1; then
    fine sandbox "$(bwrap --version)"
elif [ "$(id -u)" -eq 0 ] && has_users; then
    note sandbox "bubblewrap does not work ($(head -n 1 "$work/log")): the grader takes another sandbox, as root"
elif [ "${COURSE_SANDBOX:-}" = none ]; then
    note sandbox "bubblewrap does not work ($(head -n 1 "$work/log")): COURSE_SANDBOX=none, your own code runs without walls"
else
    wrong sandbox "bubblewrap does not work: $(head -n 1 "$work/log")" "$(mend_sandbox)"
fi

# ---- A window -----------------------------------------------------------------------------------

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    fine window "there is a display for make view"
else
    note window "there is no display: make view opens no window, make movie and all else work"
fi

# ---- The end ------------------------------------------------------------------------------------

n_wrong=$(grep -c '^wrong	' "$work/lines")
if [ -n "$as_json" ]; then
    sed 's/\\/\\\\/g; s/"/\\"/g' "$work/lines" | awk -F '\t' -v status="$((n_wrong > 0))" '
        BEGIN { printf "{\n  \"status\": %d,\n  \"checks\": [", status }
        { printf "%s\n    {\"name\": \"%s\", \"state\": \"%s\", \"found\": \"%s\", \"command\": \"%s\"}", (NR > 1 ? "," : ""), $2, $1, $3, $4 }
        END { print "\n  ]\n}" }'
else
    # What begins with a capital letter are words, no command.
    awk -F '\t' '
        { printf "%-8s %-9s %s\n", $1 == "wrong" ? "WRONG" : $1, $2, $3 }
        $4 != "" { printf "%-18s %s%s\n", "", $4 ~ /^[A-Z]/ ? "" : "run: ", $4 }' "$work/lines"
    if [ "$n_wrong" -eq 0 ]; then
        echo "doctor: all is well"
    else
        echo "doctor: WRONG: $n_wrong. Do what is named below the first one, then make doctor again."
    fi
fi
[ "$n_wrong" -eq 0 ] || exit 1

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
work=$(mktemp -d "${TMPDIR:-/tmp}/doctor-XXXXXX") ||
    { echo "doctor: cannot write to ${TMPDIR:-/tmp}: export TMPDIR=FOLDER, a folder that you may write to" >&2 && exit 2; }
trap 'rm -rf "$work"' EXIT
trap 'exit 2' HUP INT TERM

# ---- What is said -------------------------------------------------------------------------------

# State, name, what was found, the command: a line each, between tabs.
: >"$work/lines"
# said TEXT: on one line, without signs that a terminal obeys.
said() {
    printf '%s' "$1" | tr '\n\t' '  ' | tr -d '\000-\037\177' | cut -c 1-300
}
line() {
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$(said "$3")" "$(said "${4-}")" >>"$work/lines"
}
# fine NAME FOUND; wrong NAME FOUND COMMAND; note NAME FOUND [COMMAND]: works, but; skipped NAME WHY
fine() { line ok "$@"; }
wrong() { line wrong "$@"; }
note() { line note "$@"; }
skipped() { line skipped "$@"; }

has() { command -v "$1" >/dev/null 2>&1; }
# Where a command needs root.
if [ "$(id -u)" -eq 0 ] || ! has sudo; then sudo=; else sudo='sudo '; fi

# installs PACKAGE TOOL: the command that brings a tool, which may be installed where the shell does not look.
installs() {
    for folder in /usr/bin /bin /usr/local/bin; do
        # shellcheck disable=SC2016 # for the user's shell
        if [ -x "$folder/$2" ]; then echo 'export PATH="$PATH:'"$folder\"" && return; fi
    done
    if has apt-get; then
        echo "${sudo}apt-get install $1"
    elif has dnf; then
        echo "${sudo}dnf install $(name_elsewhere "$1" 2)"
    elif has pacman; then
        echo "${sudo}pacman -S $(name_elsewhere "$1" 3)"
    else
        echo "install what Debian's package $1 holds"
    fi
}
name_elsewhere() {
    awk -v package="$1" -v column="$2" '$1 == package { gsub(",", " ", $column); print $column }' common/setup/packages-elsewhere.txt
}

# ---- System, packages, tools --------------------------------------------------------------------

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
*WSL:/mnt/[a-z]/*) note folder "$PWD is on Windows' disk, which is slow and has no rights: copy the course to your home in WSL" "cp -r . ~/course" ;;
esac

list=$(sh common/setup/install.sh --print "$target" 2>&1)
if [ -z "$list" ]; then
    fine packages "all are installed that are needed for: $target"
else
    mend=$(echo "$list" | sed -n 2p)
    if has apt-get; then
        ! has make || mend="make setup"
    elif [ -x /usr/bin/apt-get ]; then
        mend=$(installs none apt-get)
    fi
    # Elsewhere install.sh says what these packages are.
    wrong packages "missing: $(echo "$list" | sed -n 1p)" "${mend:-sh common/setup/install.sh $target}"
fi

if has make; then
    case $(make --version 2>/dev/null | head -n 1) in
    "GNU Make "*) fine make "$(make --version | head -n 1)" ;;
    *) wrong make "this make is not GNU Make" "$(installs make gmake)" ;;
    esac
else
    wrong make "there is no make" "$(installs make make)"
fi

compiler=
printf '#include <stdio.h>\nint main(void)\n{\n    return puts("") == EOF;\n}\n' >"$work/hello.c"
# compiles COMPILER PACKAGE SOURCE LANGUAGE: a program for one that prints
compiles() {
    if ! has "$1"; then
        wrong "$1" "there is no $1" "$(installs "$2" "$1")"
    elif ! "$1" "$work/hello.c" -x "$3" -o "$work/hello" >"$work/log" 2>&1; then
        wrong "$1" "$1 makes no program: $(grep -m 1 -i -e error -e 'cannot find' "$work/log")" "$(installs libc6-dev none)"
    elif ! "$work/hello" >/dev/null 2>"$work/log"; then
        wrong "$1" "what $1 makes does not start in ${TMPDIR:-/tmp}: $(head -n 1 "$work/log")" "export TMPDIR=\"\$HOME\""
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
# asks NAME PROGRAM WORD COMMAND [BEFORE]: a line for what it answers, BEFORE in front; the command if it cannot.
asks() {
    # Our own words, if there are any: what a driver prints is less clear.
    if "$work/$2" "$3" >"$work/found" 2>"$work/fault"; then
        fine "$1" "${5-}$(tail -n 1 "$work/found")"
    else
        fault=$(grep -m 1 '^OpenCL: ' "$work/fault" || grep -v '^ *$' "$work/fault" | head -n 1)
        wrong "$1" "${fault:-$2 $3 ended without a word}" "$4"
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
        "$(installs ocl-icd-opencl-dev none)"
    for what in platform device layouts; do skipped $what "needs the loader"; done
else
    fine loader "libOpenCL and its headers are there"
    device=yes
fi

# Before the device: PoCL has none where it cannot write here.
cache=${POCL_CACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/pocl}
above=$cache
while [ ! -e "$above" ] && [ "$above" != / ] && [ "$above" != . ]; do above=$(dirname "$above"); done
if [ -d "$above" ] && [ -w "$above" ] && : 2>/dev/null >"$above/.doctor-$$"; then
    fine cache "$cache can be written"
else
    wrong cache "PoCL cannot write its cache folder: $cache" "export POCL_CACHE_DIR=\"${TMPDIR:-/tmp}/pocl-cache\""
fi
rm -f "$above/.doctor-$$" 2>/dev/null

if [ -n "$device" ]; then
    mend=$(installs pocl-opencl-icd none)
    [ -z "${OCL_ICD_VENDORS:-}" ] || mend="unset OCL_ICD_VENDORS"
    if asks platform doctor_device platforms "$mend"; then
        mend="export POCL_CACHE_DIR=\"${TMPDIR:-/tmp}/pocl-cache\""
        [ -z "${POCL_DEVICES:-}" ] || mend="unset POCL_DEVICES"
        [ -z "${COURSE_DEVICE:-}" ] || mend="unset COURSE_DEVICE"
        if asks device doctor_device device "$mend"; then
            asks layouts doctor_device layouts "export COURSE_DEVICE=pthread"
        else
            skipped layouts "needs a device"
        fi
    else
        for what in device layouts; do skipped $what "needs a platform"; done
    fi
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
        "$(installs libopenimageio-dev none)"
elif ! gcc -std=c11 -D_GNU_SOURCE -O0 -Icommon common/setup/doctor_image.c \
    $(sources image image_file complain clean_text utf8 text_file output_file output_place path) -ldl -lm \
    -Wl,-rpath,"$work" -o "$work/doctor_image" >"$work/log" 2>&1; then
    wrong images "no program for pictures can be made: $(grep -m 1 -e 'error:' -e 'cannot find' "$work/log")" \
        "$(installs libc6-dev none)"
else
    asks images doctor_image "$work" "$(installs libopenimageio-dev none)" \
        "OpenImageIO $(pkg-config --modversion OpenImageIO 2>/dev/null): "
fi

# ---- Sandbox ------------------------------------------------------------------------------------

# The walls are tried as the grader's (tests/grader/sandbox/bwrap_arguments.c). What stands in their way, if it is known.
setting() { cat "/proc/sys/$1" 2>/dev/null || echo none; }
sandbox_mend() {
    # In a container these settings are its host's.
    if [ -e /.dockerenv ] || [ -e /run/.containerenv ]; then
        echo "export COURSE_SANDBOX=none"
    elif [ "$(setting user/max_user_namespaces)" = 0 ]; then
        echo "${sudo}sysctl user.max_user_namespaces=10000"
    elif [ "$(setting kernel/unprivileged_userns_clone)" = 0 ]; then
        echo "${sudo}sysctl kernel.unprivileged_userns_clone=1"
    elif [ "$(setting kernel/apparmor_restrict_unprivileged_userns)" = 1 ]; then
        echo "${sudo}sysctl kernel.apparmor_restrict_unprivileged_userns=0"
    else
        # Too old, as in Ubuntu 22.04.
        echo "export COURSE_SANDBOX=none"
    fi
}
# As root the grader has other sandboxes, with a user of its own for each run (sandbox_user.c). Many a container has
# too few numbers for users.
has_users() {
    awk '$1 <= 1879048192 && 1879048192 - $1 + 2 ^ 23 < $3 { found = 1 } END { exit !found }' /proc/self/uid_map 2>/dev/null
}
if ! has bwrap; then
    wrong sandbox "there is no bwrap" "$(installs bubblewrap bwrap)"
elif bwrap --unshare-all --unshare-user --disable-userns --die-with-parent --new-session --cap-drop ALL \
    --ro-bind / / --proc /proc --dev /dev true >"$work/log" 2>&1; then
    fine sandbox "$(bwrap --version)"
elif [ "$(id -u)" -eq 0 ] && has_users; then
    note sandbox "bubblewrap does not work ($(head -n 1 "$work/log")): the grader takes another sandbox, as root"
elif [ "${COURSE_SANDBOX:-}" = none ]; then
    note sandbox "bubblewrap does not work ($(head -n 1 "$work/log")): COURSE_SANDBOX=none, your own code runs without walls"
else
    wrong sandbox "bubblewrap does not work: $(head -n 1 "$work/log")" "$(sandbox_mend)"
fi

# ---- Room, and a window -------------------------------------------------------------------------

# The build folder of a handout takes 60 MB, of the course 250 MB; the grader some MB for each run.
room() {
    df -Pk "$1" 2>/dev/null | awk 'NR == 2 { print int($4 / 1024) }'
}
needed=500
for folder in . "${TMPDIR:-/tmp}"; do
    free=$(room "$folder")
    if [ -z "$free" ]; then
        skipped disk "df does not say how much room is in $folder"
    elif [ "$free" -lt $needed ]; then
        wrong disk "$free MB are free in $folder, expected $needed" "du -xhd 1 \"\$HOME\" | sort -h | tail"
    else
        fine disk "$free MB are free in $folder"
    fi
done

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
    awk -F '\t' '
        { printf "%-8s %-9s %s\n", $1 == "wrong" ? "WRONG" : $1, $2, $3 }
        $4 != "" { printf "%-18s run: %s\n", "", $4 }' "$work/lines"
    if [ "$n_wrong" -eq 0 ]; then
        echo "doctor: all is well"
    else
        echo "doctor: WRONG: $n_wrong. Run the command below the first one, then make doctor again."
    fi
fi
[ "$n_wrong" -eq 0 ] || exit 1

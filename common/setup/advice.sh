# The commands that the doctor names (doctor.sh and checkout.sh read this): each is one that helps where it is named,
# and that this user may run. What is no command but words begins with a capital letter.
# shellcheck shell=sh

has() { command -v "$1" >/dev/null 2>&1; }

# as_root "COMMAND && COMMAND": as this user can run it; nobody can be asked for a password here.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        echo "$1"
    elif has sudo; then
        echo "sudo $1" | sed 's/ && / \&\& sudo /'
    else
        echo "Ask an administrator to run: $1"
    fi
}

# ---- Packages -----------------------------------------------------------------------------------

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# incomplete PATTERN...: the packages of these names (libpocl*) that are installed and lack a file.
incomplete() {
    for pattern; do
        # A pattern, with the machine's name behind it or without.
        # shellcheck disable=SC2231
        for list in /var/lib/dpkg/info/$pattern.list /var/lib/dpkg/info/$pattern:*.list; do
            package=${list##*/}
            package=${package%.list}
            # A container may leave out documents on purpose.
            { ! is_installed "$package" || [ ! -e "$list" ]; } || grep -v -e '^/usr/share/doc' -e '^/usr/share/man' -e '^/usr/share/li' "$list" |
                while IFS= read -r file; do [ -e "$file" ] || { echo "$package" && break; }; done
        done
    done | sort -u | paste -s -d ' ' -
}

# brings PACKAGE [PATTERN...]: the command for what PACKAGE holds and is not there. Is it installed, then a file of
# it, or of the packages of these names, was removed. A file of settings, as pocl.icd, comes back only by force.
brings() {
    package=$1
    if has apt-get; then
        if ! is_installed "$package"; then
            as_root "apt-get update && apt-get install $package"
        else
            again=$(incomplete "$@")
            as_root "apt-get update && apt-get install --reinstall -o Dpkg::Options::=--force-confmiss ${again:-$package}"
        fi
    elif has dnf; then
        as_root "dnf install $(name_elsewhere "$package" 2)"
    elif has pacman; then
        as_root "pacman -S $(name_elsewhere "$package" 3)"
    else
        echo "Install what Debian's package $package holds"
    fi
}
name_elsewhere() {
    awk -v package="$1" -v column="$2" '$1 == package { gsub(",", " ", $column); print $column }' common/setup/packages-elsewhere.txt
}

# brings_tool TOOL PACKAGE [PATTERN...]: the same for a tool; but is there another one that the shell does not take?
brings_tool() {
    tool=$1
    shift
    for folder in /usr/bin /bin /usr/local/bin; do
        [ -x "$folder/$tool" ] || continue
        # shellcheck disable=SC2016 # for the user's shell
        [ "$(command -v "$tool")" = "$folder/$tool" ] || { echo "export PATH=\"$folder:"'$PATH"' && return; }
        break
    done
    brings "$@"
}

# ---- Folders ------------------------------------------------------------------------------------

# room FOLDER: the MB that are free there; nothing if df does not say.
room() {
    df -Pk "$1" 2>/dev/null | awk 'NR == 2 { print int($4 / 1024) }'
}

# can_write FOLDER: as root, too, on a disk that is read-only.
can_write() {
    probe=$(mktemp "$1/.doctor-XXXXXX" 2>/dev/null) && rm -f "$probe"
}

# other_tmp MB: the command that makes programs take another folder for what is temporary, one that has as much room
# and in which programs start; nothing if none is found.
other_tmp() {
    for folder in "${HOME:-/}" /var/tmp /tmp "$PWD"; do
        free=$(room "$folder")
        if [ "$folder" = "${TMPDIR:-/tmp}" ] || [ "${free:-$1}" -lt "$1" ]; then continue; fi
        probe=$(mktemp "$folder/.doctor-XXXXXX" 2>/dev/null) || continue
        printf '#!/bin/sh\n' 2>/dev/null >"$probe" && chmod u+x "$probe"
        starts=$("$probe" 2>/dev/null && echo yes)
        rm -f "$probe"
        [ -z "$starts" ] || { echo "export TMPDIR=\"$folder\"" && return; }
    done
}

# makes_room FOLDER: a list of what is large there.
makes_room() {
    disk=$(df -Pk "$1" 2>/dev/null | awk 'NR == 2 { print $6 }')
    [ "$disk" != "$(df -Pk "${HOME:-/}" 2>/dev/null | awk 'NR == 2 { print $6 }')" ] || disk=${HOME:-/}
    echo "du -xhd 1 \"$disk\" 2>/dev/null | sort -h | tail"
}

# own_copy: the course in a folder of this user's own, where nothing is yet.
own_copy() {
    folder=${HOME:-/tmp}/course
    while [ -e "$folder" ]; do folder=$folder-copy; done
    echo "cp -r . \"$folder\" && cd \"$folder\""
}

# ---- OpenCL, pictures, the sandbox ----------------------------------------------------------------

# mend_images: OpenImageIO, anew if it is there.
mend_images() { brings libopenimageio-dev 'libopenimageio*'; }

# mend_opencl PROGRAM WORD FAULT: the first change of the environment with which the program answers the word; else
# PoCL, anew if it is there.
mend_opencl() {
    for names in LD_LIBRARY_PATH "OCL_ICD_VENDORS OPENCL_VENDOR_PATH" POCL_DEVICES COURSE_DEVICE "COURSE_DEVICE POCL_DEVICES"; do
        # shellcheck disable=SC2086,SC2046 # lists of words
        if env $(printf -- '-u %s ' $names) "$1" "$2" >/dev/null 2>&1; then echo "unset $names" && return; fi
    done
    # Nobody else can make this folder first.
    # shellcheck disable=SC2016 # for the user's shell
    if POCL_CACHE_DIR="$(dirname "$1")/pocl" "$1" "$2" >/dev/null 2>&1; then echo 'export POCL_CACHE_DIR="$(mktemp -d)"' && return; fi
    # Another device, by its number in the programs' own list.
    for number in $("$1" list 2>/dev/null | awk '{ print $1 }'); do
        if COURSE_DEVICE=$number "$1" "$2" >/dev/null 2>&1; then echo "export COURSE_DEVICE=$number" && return; fi
    done
    case $3 in
    *": the device found "*) echo "Take the files of kernels/ as they were handed out" ;;
    *) brings pocl-opencl-icd 'libpocl*' 'ocl-icd-*' ;;
    esac
}

# What stands in the way of bubblewrap, if it is known.
setting() { cat "/proc/sys/$1" 2>/dev/null || echo none; }
mend_sandbox() {
    name=
    if [ "$(setting user/max_user_namespaces)" = 0 ]; then
        name=user/max_user_namespaces value=10000
    elif [ "$(setting kernel/unprivileged_userns_clone)" = 0 ]; then
        name=kernel/unprivileged_userns_clone value=1
    elif [ "$(setting kernel/apparmor_restrict_unprivileged_userns)" = 1 ]; then
        name=kernel/apparmor_restrict_unprivileged_userns value=0
    fi
    # In a container these settings are its host's. Without a name bubblewrap is too old, as in Ubuntu 22.04.
    if [ -z "$name" ] || [ -e /.dockerenv ] || [ -e /run/.containerenv ] || grep -q ' /proc/sys [a-z]* ro' /proc/self/mounts ||
        { [ "$(id -u)" -ne 0 ] && ! has sudo; }; then
        echo "export COURSE_SANDBOX=none"
    else
        as_root "sh -c 'echo $value >/proc/sys/$name'"
    fi
}

#!/bin/sh
# Install the packages of packages.txt that are missing for one target of make.
#
#     common/setup/install.sh [--print] grade|view|editor|notes|demo|test|bench|scale|handout
#
# Does nothing and says nothing when all are there. Without apt it prints what is missing, with the command of Fedora
# or Arch, and stops. With --print it installs nothing: it prints the missing packages, and below them the one command
# that installs them, if there is one.
set -eu

print=
[ "$1" != --print ] || { print=yes && shift; }
target=$1
list=$(dirname "$0")/packages.txt

# The names of the packages that the target needs, as this distribution calls them.
# "target?" marks one that may be missing: it is installed where apt knows it.
ubuntu=$(grep -c '^ID=ubuntu' /etc/os-release 2>/dev/null || true)
machine=$(dpkg --print-architecture 2>/dev/null || true)
packages_of() {
    awk -v target="$1" -v ubuntu="$ubuntu" -v machine="$machine" '
    /^#/ || NF < 2 { next }
    index("," $2 ",", "," target ",") {
        if (split($1, kinds, "@") == 2 && kinds[2] != machine) { next }
        n = split(kinds[1], names, "/")
        print (ubuntu && n == 2 ? names[2] : names[1])
    }' "$list"
}
needed=$(packages_of "$target")
optional=$(packages_of "$target?")

# elsewhere COLUMN COMMAND...: what packages-elsewhere.txt calls them there, those for which the command fails, a line.
elsewhere() {
    column=$1
    shift
    for package in $(echo "$needed" | awk -v column="$column" '
        FNR == NR { if (!/^#/) names[$1] = $column; next }
        { print ($1 in names) ? names[$1] : $1 }' "$(dirname "$0")/packages-elsewhere.txt" - |
        tr ',' '\n' | grep -v -x -e -); do
        "$@" "$package" >/dev/null 2>&1 || printf ' %s' "$package"
    done
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    # Another system: trust a machine that has what the build asks for first, else tell and stop.
    if command -v gcc >/dev/null && command -v g++ >/dev/null &&
        pkg-config --exists OpenCL OpenImageIO jansson 2>/dev/null; then
        exit 0
    fi
    if command -v dnf >/dev/null; then
        missing=$(elsewhere 2 rpm -q --whatprovides)
        how="sudo dnf install$missing"
    elif command -v pacman >/dev/null; then
        missing=$(elsewhere 3 pacman -Qq)
        how="sudo pacman -S --needed$missing"
    else
        missing=$(echo "$needed" | awk '{ printf " %s", $0 }')
        how=
    fi
    [ -n "$missing" ] || exit 0
    if [ -n "$print" ]; then
        printf '%s\n' "${missing# }" ${how:+"$how"}
        exit
    elif [ -n "$how" ]; then
        echo "This system has no apt. Nobody has tried this command yet; run it, then make again:" >&2
        echo "    $how" >&2
    else
        echo "This system has no apt. Install what these Debian packages hold, then run make again:" >&2
        echo "$needed" | sed 's/^/    /' >&2
    fi
    exit 1
fi

# Of these packages those that are not installed.
missing_of() {
    for package; do
        status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
        [ "$status" = installed ] || printf ' %s' "$package"
    done
}
# shellcheck disable=SC2086 # the lists are words on purpose
missing=$(missing_of $needed)
[ -n "$missing" ] || exit 0
if [ -n "$print" ]; then
    printf '%s\n' "${missing# }" "sh $0 $target"
    exit
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null; then
    as_root=sudo
else
    echo "Missing packages:$missing" >&2
    echo "Neither root nor sudo here: ask an administrator to install them, then run make again." >&2
    exit 1
fi
$as_root apt-get update -q
# shellcheck disable=SC2086 # the list is words on purpose
for package in $(missing_of $optional); do
    if apt-cache show "$package" >/dev/null 2>&1; then missing="$missing $package"; fi
done
echo "Installing:$missing"
# shellcheck disable=SC2086 # the list is words on purpose
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing

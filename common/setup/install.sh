#!/bin/sh
# Install the packages of packages.txt that are missing for targets of make.
#
#     common/setup/install.sh [--print] TARGET...      of grade, view, editor, notes, demo, test, test-all, bench, scale,
#                                                     handout
#
# Does nothing and says nothing when all are there. Otherwise it says what it installs, and how many MB that takes,
# before it does. Without apt it prints what is missing, with the command of Fedora or Arch, and stops. With --print it
# installs nothing: it prints the missing packages, and below them the one command that installs them, if there is one.
set -eu

print=
[ "$1" != --print ] || { print=yes && shift; }
list=$(dirname "$0")/packages.txt

# The names of the packages that the target needs, as this distribution calls them.
# "target?" marks one that may be missing: it is installed where apt knows it.
ubuntu=$(grep -c '^ID=ubuntu' /etc/os-release 2>/dev/null || true)
packages_of() {
    mark=$1
    shift
    awk -v targets="$*" -v mark="$mark" -v ubuntu="$ubuntu" '
    BEGIN { n_targets = split(targets, wanted, " ") }
    /^#/ || NF < 2 { next }
    {
        is_needed = 0
        for (i = 1; i <= n_targets; i++) { if (index("," $2 ",", "," wanted[i] mark ",")) { is_needed = 1 } }
        if (!is_needed) { next }
        n = split($1, names, "/")
        print (ubuntu && n == 2 ? names[2] : names[1])
    }' "$list"
}
needed=$(packages_of "" "$@")
optional=$(packages_of "?" "$@")

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

# What installs them, as root; what an administrator can run who does not have this folder.
install="apt-get install --no-install-recommends"
by_administrator="apt-get update && $install$missing"
is_root=$([ "$(id -u)" -ne 0 ] || echo yes)
if [ -n "$print" ]; then
    if [ -n "$is_root" ] || command -v sudo >/dev/null; then how="sh $0 $*"; else how="Ask an administrator to run: $by_administrator"; fi
    printf '%s\n' "${missing# }" "$how"
    exit
fi

as_root=
if [ -z "$is_root" ]; then
    as_root=sudo
    # It may be there and not be allowed: it says so itself.
    if ! command -v sudo >/dev/null || ! sudo true; then
        echo "Missing packages:$missing" >&2
        echo "Neither root nor sudo here: ask an administrator to run this, then run make again:" >&2
        echo "    $by_administrator" >&2
        echo "Or work in a container or a virtual machine in which you are root (common/setup/TROUBLESHOOTING.md)." >&2
        exit 1
    fi
fi
fail() {
    echo "The packages could not be $1; apt-get says why above. Is there a network, and no other installation running?" >&2
    echo "Run make again then: what is there already is not fetched again." >&2
    exit 1
}
$as_root apt-get update -q || fail "looked up"
# shellcheck disable=SC2086 # the list is words on purpose
for package in $(missing_of $optional); do
    if apt-cache show "$package" >/dev/null 2>&1; then missing="$missing $package"; fi
done

# How much that is, in apt-get's own words: "Need to get 366 MB of archives." and "After this operation, 1640 MB ...".
# shellcheck disable=SC2086 # the lists are words on purpose
words=$($as_root env LC_ALL=C $install --assume-no $missing 2>/dev/null || true)
fetched=$(echo "$words" | sed -n 's/^Need to get \([^/]*B\).* of archives\.$/\1/p')
unpacked=$(echo "$words" | sed -n 's/^After this operation, \(.*B\) of additional disk space will be used\.$/\1/p')
echo "Installing:$missing"
echo "That is ${fetched:-an unknown number of MB} to download, and ${unpacked:-an unknown number of MB} on disk."
# shellcheck disable=SC2086 # the list is words on purpose
$as_root env DEBIAN_FRONTEND=noninteractive $install -q -y $missing || fail installed

#!/bin/sh
# Installing: what common/setup/install.sh says and does where packages, apt or rights are missing.
. tests/tap.sh

install=common/setup/install.sh
needed=$(awk '!/^#/ && index("," $2 ",", ",demo,") { print $1 }' common/setup/packages.txt)

# A folder that is the whole PATH: the usual tools, without apt, dpkg or compilers.
bare=$scratch/bare
mkdir "$bare"
for tool in sh awk grep sed dirname id cat env; do
    ln -s "$(command -v $tool)" "$bare/$tool"
done

# runs STATUS PATH ARGUMENT...: does install.sh end so? Its words are in $scratch/said.
runs() {
    wanted=$1
    path=$2
    shift 2
    status=0
    PATH=$path sh "$install" "$@" >"$scratch/said" 2>&1 || status=$?
    [ "$status" -eq "$wanted" ] || { echo "exit status $status"; cat "$scratch/said"; return 1; }
}

check "without apt and compilers it stops" runs 1 "$bare" demo
missing=
for package in $needed; do
    grep -q "^ *$package$" "$scratch/said" || missing="$missing $package"
done
[ -z "$missing" ]
ok $? "and prints the whole list" "not named:$missing"

check "--print says the same on one line" runs 0 "$bare" --print demo
# shellcheck disable=SC2086,SC2116 # the list on one line
[ "$(cat "$scratch/said")" = "$(echo $needed)" ]
ok $? "and nothing else" "$(cat "$scratch/said")"

# Fedora and Arch: the command, with their names, of what their package managers do not have.
elsewhere=$scratch/elsewhere
cp -R "$bare" "$elsewhere"
ln -s "$(command -v tr)" "$elsewhere/tr"
printf '#!/bin/sh\nexit 1\n' >"$elsewhere/dnf"
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\n[ "$3" = make ]\n' >"$elsewhere/rpm"
chmod +x "$elsewhere/dnf" "$elsewhere/rpm"
check "with dnf it stops, too" runs 1 "$elsewhere" grade
check "and names the command, with Fedora's names, of what is missing" \
    grep -q '^    sudo dnf install gcc gcc-c++ glibc-devel pkgconf-pkg-config ocl-icd-devel pocl ' "$scratch/said"
mv "$elsewhere/dnf" "$elsewhere/pacman"
mv "$elsewhere/rpm" "$elsewhere/rpm-of-fedora"
check "with pacman, --print" runs 0 "$elsewhere" --print grade
[ "$(sed -n 2p "$scratch/said" | cut -c 1-63)" = "sudo pacman -S --needed make gcc pkgconf ocl-icd opencl-headers" ]
ok $? "names the command with Arch's names" "$(cat "$scratch/said")"
for target in grade view demo editor; do
    # shellcheck disable=SC2013 # words are wanted
    for package in $(awk -v target=$target '!/^#/ && index("," $2 ",", "," target ",") { print $1 }' common/setup/packages.txt); do
        grep -q "^$package  *[^ ]*  *[^ ]*$" common/setup/packages-elsewhere.txt || echo "$package"
    done
done >"$scratch/unnamed"
[ ! -s "$scratch/unnamed" ]
ok $? "packages-elsewhere.txt has a line for each package of students" "$(cat "$scratch/unnamed")"

# A package database in which nothing is installed, a user who is not root, and no sudo.
printf '#!/bin/sh\nexit 1\n' >"$bare/dpkg-query"
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\necho "apt-get $*" >>"$APT_LOG"\n' >"$bare/apt-get"
chmod +x "$bare/dpkg-query" "$bare/apt-get"
rm "$bare/id"
printf '#!/bin/sh\necho 1000\n' >"$bare/id"
chmod +x "$bare/id"
printf '#!/bin/sh\n' >"$bare/true"
chmod +x "$bare/true"
APT_LOG=$scratch/apt.log
export APT_LOG
check "without root and sudo it stops" runs 1 "$bare" demo
check "and says whom to ask" grep -q "Neither root nor sudo" "$scratch/said"
check "and what to ask for" grep -q "^    apt-get update && apt-get install --no-install-recommends make gcc " "$scratch/said"
[ ! -e "$APT_LOG" ]
ok $? "and installs nothing"

# A sudo that lets this user do nothing.
printf '#!/bin/sh\necho "sudo: no" >&2\nexit 1\n' >"$bare/sudo"
chmod +x "$bare/sudo"
check "with a sudo that refuses it stops" runs 1 "$bare" demo
check "and says what to ask for" grep -q "^    apt-get update && apt-get install --no-install-recommends make gcc " "$scratch/said"
[ ! -e "$APT_LOG" ]
ok $? "and installs nothing"

# With sudo it installs exactly the list, without recommended packages, and says so.
printf '#!/bin/sh\nexec "$@"\n' >"$bare/sudo"
chmod +x "$bare/sudo"
check "with sudo it installs" runs 0 "$bare" demo
check "it says what" grep -q "^Installing: make gcc " "$scratch/said"
asked=$(sed -n 's/^apt-get install.* --no-install-recommends -q -y //p' "$APT_LOG")
# shellcheck disable=SC2086,SC2116 # the list on one line
[ "$asked" = "$(echo $needed)" ]
ok $? "it asks apt for the list, without recommended packages" "asked for: $asked"

# A package that not every release has is asked for where apt knows it, and only there.
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\n[ "$APT_KNOWS" = "$2" ]\n' >"$bare/apt-cache"
chmod +x "$bare/apt-cache"
export APT_KNOWS
optional=$(awk '!/^#/ && index("," $2 ",", ",test-all?,") { sub("/.*", "", $1); print $1 }' common/setup/packages.txt)
for APT_KNOWS in $optional nothing; do
    rm -f "$APT_LOG"
    check "with an apt that knows $APT_KNOWS it installs" runs 0 "$bare" test test-all
    asked=$(sed -n 's/^apt-get install.* --no-install-recommends -q -y //p' "$APT_LOG" | tr ' ' '\n' | grep -x -F "$optional" || true)
    case $APT_KNOWS in
    nothing) [ -z "$asked" ] ;;
    *) [ "$asked" = "$APT_KNOWS" ] ;;
    esac
    ok $? "and asks for no other that may be missing" "asked for: $asked"
done

# Where all is installed it does nothing and says nothing.
printf '#!/bin/sh\necho installed\n' >"$bare/dpkg-query"
rm -f "$APT_LOG"
check "nothing missing: nothing done" runs 0 "$bare" test test-all
[ ! -e "$APT_LOG" ] && [ ! -s "$scratch/said" ]
ok $? "and nothing said"

# It says how much that is, before it fetches it.
printf '#!/bin/sh\nexit 1\n' >"$bare/dpkg-query"
# shellcheck disable=SC2016 # for the script that is written
printf '%s\n' '#!/bin/sh' 'echo "apt-get $*"' 'case $* in *--assume-no*) echo "Need to get 12.3 MB/366 MB of archives."' \
    'echo "After this operation, 1640 MB of additional disk space will be used."; exit 1 ;; esac' >"$bare/apt-get"
check "two targets at a time" runs 0 "$bare" grade view
asked=$(sed -n '/^That is 12.3 MB to download, and 1640 MB on disk.$/{n;s/.* //p;}' "$scratch/said")
[ "$asked" = fonts-dejavu-core ]
ok $? "how much is said before it is fetched" "$(cat "$scratch/said")"
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\necho "apt-get $*" >>"$APT_LOG"\n' >"$bare/apt-get"

# make before make setup: one message, which names it, instead of a compiler's for each file.
for tool in make nproc find mkdir tr uname sort rm; do
    ln -s "$(command -v $tool)" "$bare/$tool"
done
for target in grader "$scratch/none/labs/00-hello-pixels"; do
    env -u MAKEFLAGS -u MAKELEVEL PATH="$bare" make BUILD="$scratch/none" "$target" >"$scratch/said" 2>&1
    [ $? -eq 2 ] && [ "$(grep -c 'not on this machine yet: gcc, g++, pkg-config. Run make setup first' "$scratch/said")" -eq 1 ] &&
        ! grep -q 'not found' "$scratch/said"
    ok $? "make ${target#"$scratch"/} before make setup" "$(cat "$scratch/said")"
done
printf '#!/bin/sh\necho ", jansson.h"\n' >"$scratch/a-compiler"
chmod +x "$scratch/a-compiler"
! common/setup/ready.sh "$scratch/none/ready" gcc "$scratch/a-compiler" >"$scratch/said" 2>&1 &&
    grep -q 'not on this machine yet: jansson.h. Run make setup' "$scratch/said"
ok $? "a header is missing" "$(cat "$scratch/said")"
check "nothing is missing" common/setup/ready.sh "$scratch/none/ready" gcc g++

# The container: Debian, packages of the list, and nothing else; and what VS Code reads of it.
# contained FILE: is each line of a Containerfile one of these?
contained() {
    ! grep -v -e '^#' -e '^FROM docker.io/library/debian:1[0-9]-slim$' -e '^WORKDIR /course$' -e '^COPY common/setup common/setup$' \
        -e '^RUN common/setup/install.sh [a-z ]*$' "$1"
}
check "the Containerfile installs packages of the list, and nothing else" contained Containerfile
printf 'RUN apt-get install -y cowsay\n' | cat Containerfile - >"$scratch/Containerfile"
! contained "$scratch/Containerfile" >/dev/null
ok $? "another package would be found"
# shellcheck disable=SC2013 # words are wanted
for target in $(sed -n 's/^RUN common.setup.install.sh //p' Containerfile); do
    check "packages.txt knows what it installs for: $target" grep -q "^[^# ]*  *[^ ]*\<$target\>" common/setup/packages.txt
done
named=$(jq -er .build.dockerfile .devcontainer/devcontainer.json)
ok $? "devcontainer.json is JSON, and names a Containerfile" "$named"
check "which is there" test -f ".devcontainer/$named"

# In a Turkish locale, [a-z] of grep has no i. make builds the same, command by command.
if localedef -i tr_TR -f UTF-8 "$scratch/tr_TR.UTF-8" 2>"$scratch/said"; then
    # One at a time, whatever make this runs in says: the order is what it would be.
    commands() { env -u MAKEFLAGS -u MAKELEVEL "$@" make --jobs=1 --dry-run BUILD="$scratch/none" all pixels 2>&1; }
    commands LC_ALL=C >"$scratch/commands"
    commands LOCPATH="$scratch" LC_ALL=tr_TR.UTF-8 >"$scratch/commands-turkish"
    [ "$(echo i | LOCPATH="$scratch" LC_ALL=tr_TR.UTF-8 grep -c '[a-z]')" -eq 0 ]
    ok $? "grep of this locale does not find i among the letters"
    check "make builds the same in it" cmp "$scratch/commands" "$scratch/commands-turkish"
else
    skip "make in a Turkish locale" "$(cat "$scratch/said")"
fi

finish

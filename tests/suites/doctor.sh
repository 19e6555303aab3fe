#!/bin/sh
# make doctor: each thing that it looks at is broken on purpose, once. It must say so on the line of its name, with a
# command that mends it, and end with 1; nothing else of the machine is changed. Where this machine can be mended by
# the command, it is run, and the doctor has to be content then.
#
# What is written in single quotes is for the scripts that are made, and for a user's shell.
# shellcheck disable=SC2016
. tests/tap.sh

# A machine of our own: a PATH of links to all that is in the system's, from which things can be taken out, and in
# which a program of ours can stand instead. The folder with it comes first and alone.
machine() {
    rm -rf "${scratch:?}/bin"
    mkdir -p "$scratch/bin" "$scratch/cache" "$scratch/tmp"
    for tool in awk bwrap cat chmod cp cut dash df dirname env find g++ gcc git as ld grep head id make mktemp mount mv \
        paste pkg-config rm sed sh sort sudo tail tr true uname apt-get dpkg-query dpkg; do
        ! path=$(command -v $tool) || ln -sf "$path" "$scratch/bin/$tool"
    done
}
# instead TOOL LINE...: a script of these lines in its place.
instead() {
    tool=$scratch/bin/$1
    shift
    rm -f "$tool"
    printf '%s\n' '#!/bin/sh' "$@" >"$tool"
    chmod +x "$tool"
}

# doctor [NAME=VALUE...] -- [OPTION...]: the status is in $status, the lines are in $scratch/said.
doctor() {
    status=0
    settings=
    while [ "$1" != -- ]; do settings="$settings $1" && shift; done
    shift
    # shellcheck disable=SC2086 # words without blanks
    ${within:-} env -i PATH="$scratch/bin" HOME="$scratch" TMPDIR="$scratch/tmp" POCL_CACHE_DIR="$scratch/cache" $settings \
        sh -c "${first:-:}"' && exec sh common/setup/doctor.sh "$@"' - "$@" >"$scratch/said" 2>&1 || status=$?
}
# doctor_then NAME [SETTING...]: the command below the line of this name is run in the user's shell, and the doctor again.
# What is in $mounting is done before.
doctor_then() {
    first=$(sed -n "/^[A-Za-z]*  *$1 /{n;s/^ *run: //p;q;}" "$scratch/said")
    shift
    [ -n "$first" ] || { cat "$scratch/said" && return 1; }
    first=${mounting:+$mounting && }$first
    doctor "$@" --
    first=
}

# doctor_in_container: the same as root, where there are few users.
doctor_in_container() {
    unshare --user --map-root-user env -i PATH="$scratch/bin" HOME="$scratch" TMPDIR="$scratch/tmp" \
        sh common/setup/doctor.sh >"$scratch/said" 2>&1
    status=$?
    check "a bwrap that fails, as root of a container" finds sandbox 'No permissions to create new namespace' 'COURSE_SANDBOX=none'
}

# says STATE NAME WORDS [COMMAND]: the line of this name, and the command below it.
says() {
    sed -n "/^$1  *$2 /{N;p;}" "$scratch/said" >"$scratch/line"
    if ! sed -n 1p "$scratch/line" | grep -q -e "$3" || { [ $# -gt 3 ] && ! sed -n 2p "$scratch/line" | grep -q -e "^ .*$4"; }; then
        cat "$scratch/said"
        return 1
    fi
}
# finds NAME WORDS COMMAND: it is wrong, that is said, and the status is 1.
finds() {
    says WRONG "$@" || return 1
    [ "$status" -eq 1 ] || { echo "status $status" && return 1; }
}

sed -n 's/^LAYOUT_ASSERT(\([A-Za-z0-9]*\),.*/\1/p' kernels/*.h | sort >"$scratch/asserted"
sed -n 's/^LAYOUT(\([A-Za-z0-9]*\),.*/\1/p' common/setup/doctor_layouts.h | sort >"$scratch/asked"
check "each shared structure is asked for" diff "$scratch/asserted" "$scratch/asked"

machine
doctor -- --for demo
for name in folder disk make gcc g++ loader cache platform device layouts images; do
    check "a machine that can run the tests: $name" says ok $name .
done
check "no line is wrong" test "$(grep -c '^WRONG' "$scratch/said")" -eq "$(grep -c -e '^WRONG *sandbox' -e '^WRONG *packages' "$scratch/said")"
check "nothing of it stays in the temporary folder" test -z "$(ls -A "$scratch/tmp")"

# ---- One thing is broken ------------------------------------------------------------------------

rm "$scratch/bin/gcc"
doctor --
check "no gcc in PATH: where it is" finds gcc 'there is no gcc' 'export PATH="/usr/bin:$PATH"'
check "what needs it is not tried" says skipped platform 'needs a compiler'
check "the command is run" doctor_then gcc
check "and gcc is found" says ok gcc .

machine
instead gcc 'echo "hello.c:1:10: fatal error: stdio.h: No such file or directory" >&2' 'exit 1'
doctor --
check "a gcc without headers, before the system's" finds gcc 'stdio.h: No such file' 'export PATH="/usr/bin:$PATH"'
check "the command is run" doctor_then gcc
check "and the system's is taken" says ok gcc .

machine
rm "$scratch/bin/make"
doctor --
check "no make" finds make 'there is no make' .
instead make 'echo "bmake 1.0"'
doctor --
check "another make" finds make 'not GNU Make' .

machine
instead dpkg-query '[ "$4" != libcsv-dev ] && echo installed'
doctor --
check "a package is missing" finds packages 'missing: libcsv-dev' 'make setup'

quick_ends

for tool in apt-get dpkg-query dnf pacman; do rm -f "$scratch/bin/$tool"; done
rm "$scratch/bin/pkg-config"
instead uname 'case $1 in -m) echo x86_64 ;; *) echo Linux ;; esac'
doctor --
if [ -x /usr/bin/apt-get ]; then mend=/usr/bin; else mend='Install what'; fi
check "a system without apt, or a shell that does not see it" finds packages 'missing: make gcc' "$mend"

# A compiler for which a library or a header is not there.
machine
instead gcc 'case "$*" in *-lOpenCL*) echo "ld: cannot find -lOpenCL: No such file or directory" >&2; exit 1 ;; esac' "exec $(command -v gcc) \"\$@\""
doctor --
check "no loader for this gcc" finds loader 'cannot find -lOpenCL' 'export PATH="/usr/bin:$PATH"'
check "a device is not looked for then" says skipped device 'needs the loader'

machine
instead g++ 'case "$*" in *image.cpp*) echo "image.cpp:6:10: fatal error: OpenImageIO/imageio.h: No such file" >&2; exit 1 ;; esac' "exec $(command -v g++) \"\$@\""
doctor --
check "no OpenImageIO" finds images 'OpenImageIO/imageio.h' libopenimageio-dev

machine
mkdir "$scratch/none"
doctor OCL_ICD_VENDORS="$scratch/none" --
check "no platform where OCL_ICD_VENDORS leads" finds platform 'found no platform' 'unset OCL_ICD_VENDORS'
check "so there is no device to try" says skipped device 'needs a platform'
doctor COURSE_DEVICE=no-such-device --
check "no such device" finds device 'no-such-device' 'unset COURSE_DEVICE'
check "the command is run" doctor_then device COURSE_DEVICE=no-such-device
check "and there is a device" says ok device .

printf 'no folder\n' >"$scratch/file"
doctor POCL_CACHE_DIR="$scratch/file/pocl" --
check "a cache folder that cannot be" finds cache "$scratch/file/pocl" 'export POCL_CACHE_DIR'
check "the command is run" doctor_then cache POCL_CACHE_DIR="$scratch/file/pocl"
first_cache=$(sed -n 's/^ok  *cache  *\(.*\) can be written/\1/p' "$scratch/said")
check "and PoCL has a folder" says ok layouts .
doctor POCL_CACHE_DIR="$scratch/file/pocl" --
doctor_then cache POCL_CACHE_DIR="$scratch/file/pocl"
! grep -qxF "ok       cache     $first_cache can be written" "$scratch/said" && [ -n "$first_cache" ]
ok $? "whose name nobody knows before" "$(cat "$scratch/said")"

instead bwrap 'echo "bwrap: No permissions to create new namespace" >&2' 'exit 1'
doctor --
# Root of all users has another sandbox.
if [ "$(id -u)" -eq 0 ] && grep -q 4294967295 /proc/self/uid_map; then
    check "a bwrap that fails, as root: another sandbox" says note sandbox 'No permissions to create new namespace.*another sandbox'
    unshare --user --map-root-user true && doctor_in_container
fi
instead id 'echo 1000'
doctor --
check "a bwrap that fails" finds sandbox 'No permissions to create new namespace' .
doctor COURSE_SANDBOX=none --
check "a bwrap that fails, and nobody wants it" says note sandbox 'without walls'
rm "$scratch/bin/bwrap"
doctor --
check "no bwrap" finds sandbox 'there is no bwrap' .

machine
instead df 'echo "Filesystem 1024-blocks Used Available Capacity Mounted on"' 'echo "/dev/full 1000000 990000 10240 99% /"'
doctor --
check "a full disk" finds disk '10 MB are free' du
instead df 'exit 1'
doctor --
check "a df that says nothing" says skipped disk 'how much room'

# advises FUNCTION ARGUMENT...: what advice.sh names, on this machine or with a tool of ours.
advises() { PATH="$scratch/bin:$PATH" sh -c '. common/setup/advice.sh && "$@"' - "$@"; }

# Of the programs' own list of devices one that does better is named, by its number.
printf '%s\n' '#!/bin/sh' 'case $1:${COURSE_DEVICE:-0} in' 'list:*) printf "0  PoCL: cpu-of-13\n1  Other: gpu\n" ;;' \
    'layouts:1) ;;' '*) exit 1 ;;' 'esac' >"$scratch/two-devices"
printf '%s\n' '#!/bin/sh' '[ "$1" = list ] && echo "0  PoCL: cpu-of-13"' >"$scratch/one-device"
chmod +x "$scratch/two-devices" "$scratch/one-device"
mend=$(advises mend_opencl "$scratch/two-devices" layouts 'Circle: the device found 32 bytes')
[ "$mend" = 'export COURSE_DEVICE=1' ]
ok $? "a device that sees structures wrongly, and another: it is named" "$mend"
mend=$(advises mend_opencl "$scratch/one-device" layouts 'Circle: the device found 32 bytes')
[ "$mend" = 'Take the files of kernels/ as they were handed out' ]
ok $? "and without another: no device that is not there" "$mend"

# A package that is there and not whole is installed anew, a file of settings by force.
machine
instead id 'echo 0'
instead apt-get 'exit 1'
instead dpkg-query 'exit 1'
mend=$(advises brings pocl-opencl-icd)
[ "$mend" = 'apt-get update && apt-get install pocl-opencl-icd' ]
ok $? "a package that is not there" "$mend"
instead dpkg-query 'echo installed'
mend=$(advises mend_opencl "$scratch/one-device" device 'OpenCL: found no platform')
[ "${mend%pocl-opencl-icd*}" = 'apt-get update && apt-get install --reinstall -o Dpkg::Options::=--force-confmiss ' ]
ok $? "a package that is there, and whose file is not" "$mend"
instead id 'echo 1000'
instead sudo 'exit 1'
mend=$(advises brings pocl-opencl-icd)
[ "$mend" = 'sudo apt-get update && sudo apt-get install --reinstall -o Dpkg::Options::=--force-confmiss pocl-opencl-icd' ]
ok $? "each of the commands through sudo" "$mend"

# A user who may install nothing.
machine
rm -f "$scratch/bin/sudo"
instead id 'echo 1000'
instead dpkg-query '[ "$4" != libcsv-dev ] && echo installed'
doctor --
check "no sudo: whom to ask, and for what" finds packages 'missing: libcsv-dev' \
    '  Ask an administrator to run: apt-get update && apt-get install --no-install-recommends libcsv-dev$'

# ---- Folders ------------------------------------------------------------------------------------

# A copy, in which git tracks everything.
machine
here=$PWD
mkdir "$scratch/copy"
cp -R common kernels "$scratch/copy"
cd "$scratch/copy" || exit 1
check "no checkout" sh -c '[ "$(sh common/setup/checkout.sh)" = "here is no git checkout, as git clone makes one" ]'
doctor --
! grep -q '^[A-Za-z]*  *git ' "$scratch/said"
ok $? "and nobody needs one then" "$(cat "$scratch/said")"
git init -q . && git add . && git -c user.name=A -c user.email=a@b commit -q -m all
export GIT_CONFIG_NOSYSTEM=1
doctor --
check "a checkout" says ok git version
other=GIT_TEST_ASSUME_DIFFERENT_OWNER=1
doctor $other --
check "a checkout of another user" says note git 'another user owns it' 'git config --global --add safe.directory'
check "the command is run" doctor_then git $other
check "and git reads it" says ok git version
rm "$scratch/bin/git" "$scratch/.gitconfig"
doctor --
check "no git" says note git 'git is not installed' 'export PATH="/usr/bin:$PATH"'
check "the command is run" doctor_then git
check "and git is there" says ok git version
machine

# Where disks of ours can be mounted, they lie over a folder.
within="unshare --mount"
[ "$(id -u)" -eq 0 ] || within="unshare --map-root-user --mount"
if $within mount -t tmpfs room "$scratch/tmp" 2>"$scratch/said"; then
    mounting="mount -t tmpfs -o size=1m room $scratch/tmp"
    first=$mounting
    doctor --
    [ $status -eq 2 ] && [ "$(wc -l <"$scratch/said")" -eq 2 ] &&
        grep -q "cannot write to $scratch/tmp, .* where [01] MB are free" "$scratch/said"
    ok $? "a full folder for what is temporary: status 2, one message" "status $status: $(cat "$scratch/said")"
    first="$mounting && $(sed -n 's/^ *run: //p' "$scratch/said")"
    doctor --
    check "the command is run, and there is another folder" says ok images .

    mounting="mount --bind $PWD $PWD && mount -o remount,bind,ro $PWD && cd $PWD"
    first=$mounting
    doctor --
    check "a folder of the course that is read-only" finds folder "$PWD cannot be written to" "cp -r . .$scratch/course. && cd"
    check "the command is run" doctor_then folder
    check "and the copy can be written to" says ok folder "$scratch/course can be"
else
    skip "full disks" "$(cat "$scratch/said")"
fi
mounting='' first='' within=''

# What sudo has left behind.
if [ "$(id -u)" -eq 0 ] && chmod 711 "$scratch" && setpriv --reuid 65534 --clear-groups test -x "$PWD"; then
    within="setpriv --reuid 65534 --clear-groups"
    mkdir -p "$scratch/cache/kcache" build/obj
    chown -R 65534 . "$scratch/tmp"
    chown 0 build/obj
    # Nor has this user a home.
    doctor --
    check "a cache, a part of which is another user's" finds cache "cannot write its cache folder: $scratch/cache" mktemp
    check "the command is run" doctor_then cache
    check "and PoCL has a folder" says ok layouts .
    check "a build folder, a part of which is another user's" finds folder 'build/obj cannot be written to' 'mv "build"'
    check "the command is run" doctor_then folder
    check "and the next one is this user's" says ok folder .
    within=
else
    skip "what sudo has left behind" "it needs root, and a folder that others can read"
fi
cd "$here" || exit 1

# A disk that is full from then on.
instead df "rm -rf $scratch/tmp/doctor-*"
doctor --
[ $status -eq 2 ] && [ "$(grep -c 'cannot write to' "$scratch/said")" -eq 1 ] && ! grep -q -e 'all is well' -e printf "$scratch/said"
ok $? "nothing more can be written: status 2, one message" "status $status: $(cat "$scratch/said")"

# Whatever packs the course's files.
if [ -e .git ]; then
    for packer in 'tests/handout/pack.sh tools 00' 'tests/handout/release.sh notes handouts' 'tests/systems/bundle.sh gradescope 00'; do
        # shellcheck disable=SC2086 # words
        ! said=$(env HOME="$scratch/none" $other sh $packer "$scratch/packed" 2>&1 </dev/null) &&
            case $said in *"another user owns it"*"run: git config --global --add safe.directory "*) ;; *) false ;; esac
        ok $? "${packer%% *} in a checkout of another user" "$said"
    done
else
    skip "packing" "here is no git checkout"
fi

machine
instead uname 'case $1 in -m) echo arm64 ;; *) echo Darwin ;; esac'
doctor --
check "a Mac: a container" finds system 'needs Linux' 'brew install podman'
instead uname 'case $1 in -m) echo x86_64 ;; *) echo FreeBSD ;; esac'
doctor --
check "another system" finds system 'needs Linux' .

# The layouts of a structure that the two sides see differently: a copy, with a field more on the host.
machine
mkdir "$scratch/structures"
cp -R common kernels "$scratch/structures"
sed -i 's|^typedef struct Circle {|&\n#ifndef __OPENCL_C_VERSION__\n    f32 more;\n#endif|; s|^LAYOUT_ASSERT(Circle.*||' "$scratch/structures/kernels/circle.h"
here=$PWD
cd "$scratch/structures" || exit 1
doctor --
cd "$here" || exit 1
check "host and device that see another structure" finds layouts 'Circle: the device found 32 bytes' .

# ---- What it is called with ---------------------------------------------------------------------

machine
doctor -- --json
check "as JSON: the same names, and the status" jq -e '(.checks | map(.name) | index("layouts")) != null and (.status == 0 or .status == 1)' \
    "$scratch/said"
instead bwrap 'printf "bwrap: \"odd\\\\\" \033[31msigns\t\n" >&2' 'exit 1'
instead id 'echo 1000'
doctor -- --json
check "signs of JSON and of terminals in a message" jq -e '.status == 1 and (.checks[] | select(.name == "sandbox") |
    .state == "wrong" and (.found | contains("\"odd\\\" [31msigns")) and (.command | length > 0))' "$scratch/said"

doctor -- --jsn
[ "$status" -eq 2 ] && grep -q 'found "--jsn", expected --json' "$scratch/said"
ok $? "another option: status 2, one message" "status $status: $(cat "$scratch/said")"
machine
env -i PATH="$scratch/bin" sh -c "cd '$scratch' && sh '$PWD/common/setup/doctor.sh'" >"$scratch/said" 2>&1
status=$?
[ "$status" -eq 2 ]
ok $? "another folder: status 2" "status $status: $(cat "$scratch/said")"
doctor TMPDIR="$scratch/file" --
[ "$status" -eq 2 ] && grep -q 'doctor: cannot write to' "$scratch/said"
ok $? "no temporary folder: status 2, one message" "status $status: $(cat "$scratch/said")"

check "make doctor is the same" sh -c 'make -s doctor JSON=1 2>/dev/null | jq -e ".checks | length > 12"'

finish

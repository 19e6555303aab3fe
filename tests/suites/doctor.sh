#!/bin/sh
# make doctor: each thing that it looks at is broken on purpose, once. It must say so on the line of its name, with a
# command that mends it, and end with 1; nothing else of the machine is changed.
#
# What is written in single quotes is for the scripts that are made, and for a user's shell.
# shellcheck disable=SC2016
. tests/tap.sh

# A machine of our own: a PATH of links to all that is in the system's, from which things can be taken out, and in
# which a program of ours can stand instead. The folder with it comes first and alone.
machine() {
    rm -rf "${scratch:?}/bin"
    mkdir -p "$scratch/bin" "$scratch/cache" "$scratch/tmp"
    for tool in awk bwrap cat cut dash df dirname g++ gcc as ld grep head id make mktemp pkg-config rm sed sh sudo tail \
        tr true uname apt-get dpkg-query dpkg; do
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
    env -i PATH="$scratch/bin" HOME="$scratch" TMPDIR="$scratch/tmp" POCL_CACHE_DIR="$scratch/cache" $settings \
        sh common/setup/doctor.sh "$@" >"$scratch/said" 2>&1 || status=$?
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
    if ! sed -n 1p "$scratch/line" | grep -q -e "$3" || { [ $# -gt 3 ] && ! sed -n 2p "$scratch/line" | grep -q -e "run: .*$4"; }; then
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
for name in make gcc g++ loader cache platform device layouts images disk; do
    check "a machine that can run the tests: $name" says ok $name .
done
check "no line is wrong" test "$(grep -c '^WRONG' "$scratch/said")" -eq "$(grep -c -e '^WRONG *sandbox' -e '^WRONG *packages' "$scratch/said")"
check "nothing of it stays in the temporary folder" test -z "$(ls -A "$scratch/tmp")"

# ---- One thing is broken ------------------------------------------------------------------------

rm "$scratch/bin/gcc"
doctor --
check "no gcc in PATH: where it is" finds gcc 'there is no gcc' 'export PATH="$PATH:/usr/bin"'
check "what needs it is not tried" says skipped platform 'needs a compiler'

machine
instead gcc 'echo "hello.c:1:10: fatal error: stdio.h: No such file or directory" >&2' 'exit 1'
doctor --
check "a gcc without headers: which package" finds gcc 'stdio.h: No such file' libc6-dev

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

heart_ends

for tool in apt-get dpkg-query dnf pacman; do rm -f "$scratch/bin/$tool"; done
rm "$scratch/bin/pkg-config"
instead uname 'case $1 in -m) echo x86_64 ;; *) echo Linux ;; esac'
doctor --
if [ -x /usr/bin/apt-get ]; then mend=/usr/bin; else mend=install.sh; fi
check "a system without apt, or a shell that does not see it" finds packages 'missing: make gcc' "$mend"

# A compiler for which a library or a header is not there.
machine
instead gcc 'case "$*" in *-lOpenCL*) echo "ld: cannot find -lOpenCL: No such file or directory" >&2; exit 1 ;; esac' "exec $(command -v gcc) \"\$@\""
doctor --
check "no loader" finds loader 'cannot find -lOpenCL' ocl-icd-opencl-dev
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

printf 'no folder\n' >"$scratch/file"
doctor POCL_CACHE_DIR="$scratch/file/pocl" --
check "a cache folder that cannot be" finds cache "$scratch/file/pocl" 'export POCL_CACHE_DIR'

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

machine
instead uname 'case $1 in -m) echo arm64 ;; *) echo Darwin ;; esac'
doctor --
check "a Mac: a container" finds system 'needs Linux' 'brew install podman'
instead uname 'case $1 in -m) echo x86_64 ;; *) echo FreeBSD ;; esac'
doctor --
check "another system" finds system 'needs Linux' .

# The layouts of a structure that the two sides see differently: a copy, with a field more on the host.
machine
mkdir "$scratch/copy"
cp -R common kernels "$scratch/copy"
sed -i 's|^typedef struct Circle {|&\n#ifndef __OPENCL_C_VERSION__\n    f32 more;\n#endif|; s|^LAYOUT_ASSERT(Circle.*||' "$scratch/copy/kernels/circle.h"
here=$PWD
cd "$scratch/copy" || exit 1
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

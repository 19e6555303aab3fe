#!/bin/sh
# Make a machine ready to grade one lab: install the packages that are missing, build the grader.
#
#     tests/systems/prepare.sh NN
#
# The bundles run it once, where their image is made or in it. Run again, it finds all done, wherever the
# course was carried since: build/prepared names the system and the sources that the grader was built for,
# so that the dates that git or a copy gives to files do not matter.
set -eu
cd "$(dirname "$0")/../.."
. tests/systems/limits.sh

# The system and every source: what is built from others runs nowhere else.
sources() {
    grep -e '^ID=' -e '^VERSION_ID=' /etc/os-release 2>/dev/null || true
    uname -m
    find . \( -path ./build -o -path ./tests/systems \) -prune -o -type f -print0 | LC_ALL=C sort -z |
        xargs -0 cksum | cksum
}

prepared=$(sources)
[ "$prepared" != "$(cat build/prepared 2>/dev/null)" ] || exit 0
choose_jobs
common/setup/install.sh demo
rm -f build/prepared
make -s -j"$JOBS" lab-grader LAB="$1"
# What only make needs to go on from here: a tenth is left to be carried about.
rm -rf build/obj build/libgrader.a
echo "$prepared" >build/prepared

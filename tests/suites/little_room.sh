#!/bin/sh
# Where TMPDIR has little room, and what a run writes goes to it: a right submission is graded there, and
# whoever fills it fails, while the grader goes on.
#
#     sh tests/suites/little_room.sh      from the top folder, after `make tests`
#
# Needs root and mounts, for a TMPDIR of some size. The grader itself may mount nothing, as in most
# containers: else a run's folders would be file systems of their own.
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
chmod 711 "$scratch"
mkdir -m 711 "$scratch/work"
export TMPDIR="$scratch/work"
reports=$scratch/reports

# grade MB LAB PATH: with so much room in TMPDIR. Sets status.
grade() {
    rm -rf "$reports"
    status=0
    # shellcheck disable=SC2016 # for the inner shell
    unshare -m sh -c 'mount -t tmpfs -o size="$1"m,mode=711 room "$TMPDIR" && shift && exec "$@"' room "$1" \
        setpriv --bounding-set -sys_admin --inh-caps -sys_admin \
        "$build/tools/grade" --build "$build" --output "$reports" --lab "$2" --seed 5 --sandbox landlock \
        --submission "$3" >"$scratch/said" 2>&1 </dev/null || status=$?
}

# ends_with STATUS NAME
ends_with() {
    [ "$status" -eq "$1" ]
    ok $? "$2: status $1" "found status $status: $(cat "$scratch/said")"
}

names() { grep -q -- "$1" "$reports/results.json"; }

lab=00-hello-pixels
if [ "$(id -u)" -ne 0 ] || ! unshare -m mount -t tmpfs room "$TMPDIR" 2>/dev/null; then
    skip "little room" "it needs root, and mounts"
    finish
    exit
fi
grade 160 $lab solutions/$lab
if [ "$status" -eq 2 ]; then
    skip "little room" "$(cat "$scratch/said")"
    finish
    exit
fi
ends_with 0 "a right submission in 160 MB"

quick_ends

# ---- Archives ------------------------------------------------------------------------------------

mkdir "$scratch/small" "$scratch/large" "$scratch/copies"
cp solutions/$lab/* "$scratch/small"
cp solutions/$lab/* "$scratch/large"
head -c 41943040 /dev/zero >"$scratch/large/video"
(cd "$scratch/small" && zip -q -r ../small.zip .)
(cd "$scratch/large" && zip -q -0 -r ../large.zip .)
head -c 262144 /dev/zero | tr '\0' ' ' >"$scratch/text"
for i in $(seq 999); do
    mkdir "$scratch/copies/$i" && ln "$scratch/text" "$scratch/copies/$i/render.c"
done
(cd "$scratch/copies" && zip -q -r ../copies.zip .)

grade 40 $lab "$scratch/small.zip"
ends_with 0 "a small archive in 40 MB"
grade 40 $lab "$scratch/large.zip"
ends_with 1 "an archive of 40 MB in 40 MB"
check "it is its own fault" names 'large.zip: its 40.0 MB do not fit into the room that this machine has'
grade 160 $lab "$scratch/copies.zip"
ends_with 1 "250 MB of copies in 160 MB"
check "they are their own fault" names 'copies.zip: the archive holds at least 4.2 MB'
grade 8 $lab "$scratch/small.zip"
ends_with 0 "a small archive in 8 MB: solution and submission run one after the other"
grade 4 $lab "$scratch/small.zip"
ends_with 2 "in 4 MB nobody can be graded"

# ---- Runs ----------------------------------------------------------------------------------------

# A host file that fills TMPDIR before anything is asked of it, and keeps it full while the solution,
# beside it, writes its answers.
cat >"$scratch/fill.c" <<'C'
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
__attribute__((constructor)) static void fill(void)
{
    static char block[1 << 20];
    memset(block, 1, sizeof block);
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "out/%d", i);
        const int file = open(name, O_WRONLY | O_CREAT, 0600);
        for (int n = 0; n < 60 && write(file, block, sizeof block) > 0; n++)
            ;
        for (int n = sizeof block; n > 0; n /= 2) {
            while (i == 3 && write(file, block, n) == n)
                ;
        }
    }
    sleep(3);
}
C
# Lab 02's answers are judged without it, too, and keep their points; lab 00's only task is the file's.
for host_file in 00-hello-pixels/render.c 02-kdtree-2d-build/kdtree2d_build.c; do
    lab=${host_file%/*}
    case $lab in 00-*) wanted=1 ;; *) wanted=0 ;; esac
    cp -R "solutions/$lab" "$scratch/$lab"
    cat "$scratch/fill.c" >>"$scratch/$host_file"
    grade 160 "$lab" "$scratch/$lab"
    ends_with "$wanted" "a run of $lab that fills 160 MB"
    check "and its report says that it did not run to its end" names '"title": "Running",'
    check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"
done

finish

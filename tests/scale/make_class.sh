#!/bin/sh
# A class of N submissions of lab 03 as a lecturer gets them: right, wrong, broken and hostile.
#
#     tests/scale/make_class.sh N FOLDER [BUILD]
#
# The same N gives the same class. Of twenty: nine right, five wrong in the ways of tests/known, a
# skeleton, one that does not compile, one without its file, one that crashes, one that never ends
# and one that is hostile. Every fourth is an archive.
set -eu

n=$1 folder=$2 build=${3:-build}
lab=03-kdtree-2d-render
source=implicit2DRenderer_KD.cl
mkdir -p "$folder"

# wrong NAME: the solution with this known answer.
wrong() {
    cp "solutions/$lab/$source" "$student"
    "$build/tools/known" put $lab "$1" "$student"
}

# instead TEXT: the solution with TEXT in place of the search of a pixel.
instead() {
    printf '%s\n' "$1" >"$folder/.answer"
    "$build/tools/holes" fill "solutions/$lab/$source" descent "$folder/.answer" >"$student/$source"
    rm "$folder/.answer"
}

# One of those that want more than points. All are bounded by themselves.
hostile() {
    case $1 in
    0) # processes that wait for ever, forty a launch
        instead '#ifdef __x86_64__
        for (int i = 0; i < 40 && get_global_id(0) + get_global_id(1) == 0; i++) {
            long id = 57; // fork
            __asm__ volatile("syscall" : "+a"(id) : : "rcx", "r11", "memory");
            while (id == 0) {
                long pause = 34;
                __asm__ volatile("syscall" : "+a"(pause) : : "rcx", "r11", "memory");
            }
        }
#endif' ;;
    1) cp "solutions/$lab/$source" "$student/$source"
        printf '#include "/etc/passwd"\n' >>"$student/$source" ;;
    2) ln -s "$PWD/solutions/$lab/$source" "$student/$source" ;;
    3) instead 'for (int i = 0; i < 200000 && get_global_id(0) + get_global_id(1) == 0; i++) {
            printf("Score 100/100 %d\n", i);
        }' ;;
    4) cp "labs/$lab/$source" "$student/$source"
        echo '{ "score": 100, "max_score": 100 }' >"$student/results.json"
        file=0
        while [ $file -lt 500 ]; do
            : >"$student/file-$file"
            file=$((file + 1))
        done ;;
    5) head -c 400000 /dev/zero | tr '\0' ' ' >"$student/$source" ;;
    esac
}

all_wrong=$("$build/tools/known" list $lab | sed -n '/^wrong endless-/d; s/^wrong \([^ ]*\) .*/\1/p')
set --
n_hostile=0 i=1
while [ "$i" -le "$n" ]; do
    student=$folder/$(printf 'student-%04d' "$i")
    mkdir -p "$student"
    case $((i % 20)) in
    1 | 4 | 7 | 10 | 13 | 16)
        # shellcheck disable=SC2086 # names without blanks
        [ $# -gt 0 ] || set -- $all_wrong
        if [ $((i % 20)) -eq 16 ]; then
            cp "labs/$lab/$source" "$student"
        else
            wrong "$1"
            shift
        fi ;;
    3) instead '        id = no_such_name[id];' ;;
    6) echo "I could not do it." >"$student/README.txt" ;;
    9) instead '*(volatile __global int *)(size_t)(get_global_id(0) & 0) = 1;' ;;
    12) wrong endless-descent ;;
    15) hostile $((n_hostile % 6))
        n_hostile=$((n_hostile + 1)) ;;
    *) cp "solutions/$lab/$source" "$student" ;;
    esac
    if [ $((i % 4)) -eq 0 ] && [ -z "${UNPACKED:-}" ]; then
        tar -C "$student" -czf "$student.tar.gz" . && rm -r "$student"
    fi
    i=$((i + 1))
done

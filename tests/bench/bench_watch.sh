#!/bin/sh
# How long `make watch` takes from a save to its verdict: with PoCL alone, and natively first.
#
#     [ROUNDS=n] tests/bench/bench_watch.sh FOLDER [LAB...]
#
# Writes FOLDER/bench_watch.csv, in the form of bench.h: for each lab, way and round the milliseconds from a
# save to the first verdict and to the round's end, and the processor time until the latter. Natively the processor time
# until the first verdict, too: PoCL's is told by a grader that still runs, of which nothing is known then. What is saved is the
# solution, each time with another comment, so that every kernel is compiled anew. Run it in the top folder, after
# `make all native`. Read next: tables.sh.
set -eu
unset MAKEFLAGS MFLAGS MAKELEVEL COURSE_DEVICE COURSE_SANDBOX
folder=$1 && shift
mkdir -p "$folder"
results=$(cd "$folder" && pwd)/bench_watch.csv
native=$PWD/${BUILD:-build}/native
scratch=$(mktemp -d "${TMPDIR:-/tmp}/bench-XXXXXX")
watch=
trap 'test -z "$watch" || kill "$watch"; rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
chmod 711 "$scratch"
mkdir "$scratch/work"
chmod 711 "$scratch/work"
export TMPDIR="$scratch/work"
. tests/course_copy.sh
make -s skeletons
mkfifo keys news
ticks=$(getconf CLK_TCK)

# processor: ms that the watch and all that it has waited for have used.
processor() {
    sed 's/.*) //' "/proc/$watch/stat" | awk -v ticks="$ticks" '{ printf "%.0f\n", ($12 + $13 + $14 + $15) * 1000 / ticks }'
}
now() { echo $(($(date +%s%N) / 1000000)); }
# row QUANTITY VALUE SINCE
row() { echo "\"watch $number\",\"$way\",\"$1\",$round,$(echo "$2 $3" | awk "{ printf \"%.0f\", \$1 - \$2 }")"; }
# heard WORDS: read the watch's news up to a line that begins with them.
heard() {
    while IFS= read -r line <&4; do
        case $line in "$1"*) return ;; esac
    done
    echo "bench_watch: $lab: the watch has ended" >&2
    exit 1
}
rounds() {
    # shellcheck disable=SC2086 # two words or none
    build/tools/desk watch --lab "$lab" $1 <keys >news 2>&1 &
    watch=$!
    exec 3>keys 4<news
    heard '   h hint'
    for round in $(seq "${ROUNDS:-5}"); do
        since=$(now) processor_since=$(processor)
        { cat "solutions/$lab/$file" && echo "// $way, $round"; } >"labs/$lab/$file.new"
        mv "labs/$lab/$file.new" "labs/$lab/$file"
        heard ' Score 100/'
        row verdict "$(now)" "$since"
        [ -z "$1" ] || row 'verdict, processor' "$(processor)" "$processor_since"
        heard '   h hint'
        row round "$(now)" "$since"
        row 'round, processor' "$(processor)" "$processor_since"
    done
    printf q >&3
    cat <&4 >/dev/null
    wait "$watch"
    watch=
    exec 3>&- 4<&-
}

echo 'scene,what,quantity,round,value' >"$results"
for manifest in labs/*/lab.json; do
    lab=$(basename "$(dirname "$manifest")")
    number=${lab%%-*}
    case " ${*:-$number} " in *" $number "*) ;; *) continue ;; esac
    make -s lab-grader LAB="$number" >/dev/null
    # Its native probes, without those of other labs and the kernels that are kept there.
    rm -rf build/native
    mkdir -p build/native/probes
    cp -pR "$native/probes/$lab"* build/native/probes
    cp -p "$native/libcommon.a" build/native
    for part in tools judges earlier no_macros.h; do ln -s ../$part build/native/$part; done
    for file in $(jq -r '.files[]' "$manifest"); do cp "solutions/$lab/$file" "labs/$lab/"; done
    way='PoCL alone' && rounds '' >>"$results"
    way='natively first' && rounds '--native build/native' >>"$results"
done
echo "The times: $results"

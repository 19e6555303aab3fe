# shellcheck shell=sh disable=SC2034,SC2154,SC2317 # sourced, behind tests/tap.sh; used by the suites
# What the suites about a class share: the driver, what it said, and a grader that stands in for ours.
#
#     . tests/tap.sh
#     . tests/classes.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac

# Where the graders work; what is left there is seen at the end.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/w"
export TMPDIR="$scratch/w"
class=$scratch/class
lab=00-hello-pixels

# run OUTPUT OPTION...: the driver, with its messages in $scratch/said.
run() {
    output=$1
    shift
    tests/class/grading/grade_class.sh --build "$build" --lab 0 --submissions "$class" --output "$output" "$@" \
        >"$scratch/said" 2>&1 </dev/null
}

# exits STATUS COMMAND...
exits() {
    wanted=$1 status=0
    shift
    "$@" || status=$?
    [ "$status" -eq "$wanted" ] || { echo "found exit status $status"; cat "$scratch/said"; return 1; }
}

# said WORDS: did the last run say so?
said() { grep -qF -- "$1" "$scratch/said" || { cat "$scratch/said"; return 1; }; }

# row OUTPUT TEXT: does a row of the CSV begin so?
row() { text=$2 awk 'index($0, ENVIRON["text"]) == 1 { n++ } END { exit n != 1 }' "$1/gradebook.csv" ||
    { cat "$1/gradebook.csv"; return 1; }; }

# all_right: from here on a grader stands in that gives everybody the results of the solution, which it graded once.
all_right() {
    check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
        --submission solutions/$lab --output "$scratch/right"
    stub "$scratch/right"
}

# stub RESULTS [FAULTS]: from here on classes are graded by a grader that gives everybody the results
# in this folder, behind lines of shell that have $student, $submission and $output.
stub() {
    fake=$scratch/fake
    mkdir -p "$fake/tools"
    ln -s "$build/tools/gradebook" "$fake/tools"
    cp "$build/tools/unpack" "$fake/tools"
    ln -s "$build/probes" "$build/earlier" "$build/no_macros.h" "$build/libcommon.a" "$fake"
    cat >"$fake/tools/grade" <<END
#!/bin/sh
while [ "\$1" != --student ]; do shift; done
student=\$2
while [ "\$1" != --submission ]; do shift; done
submission=\$2 output=\$4
${2:-}
cp -R "$1/." "\$output"
[ ! -e "\$output/whose" ] || cat "\$output/whose" >>"\$output/report.html"
END
    chmod +x "$fake/tools/grade"
    build=$fake
}

# own NUMBER: does the line of the list that has this number lead to the student's own file?
own() {
    line=$(grep -e "[ #\"]$1\"" "$class.out/gradebook.csv" | grep -v '^,')
    slug=$(echo "$line" | sed -n 's|.*"students/\([^/]*\)/report.html".*|\1|p')
    [ "$(cat "$class.out/students/$slug/whose")" = "$1" ] || { echo "$line"; return 1; }
}

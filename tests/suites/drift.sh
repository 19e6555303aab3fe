#!/bin/sh
# No drift: labs/ is cut from solutions/, and every hole has points, a task text and a test.
. tests/tap.sh

tools=${BUILD:-build}/tools

# labs/ is what cutting gives.
tests/cut_labs.sh "$tools/holes" "$scratch/labs"
check "labs/ is cut from solutions/ (else: make skeletons)" diff -r labs "$scratch/labs"

# A field of a task in lab.json, which has one field a line: json_field FILE TASK FIELD
json_field() {
    awk -v task="\"$2\"" -v field="\"$3\":" '
        $1 == "\"id\":" { inside = index($2, task) == 1 }
        inside && $1 == field { sub(/^[^:]*: */, ""); sub(/,$/, ""); gsub(/"/, ""); print; exit }' "$1"
}

for folder in solutions/*/; do
    lab=$(basename "$folder")
    manifest=$folder/lab.json
    checks=$("$tools/grade" --lab "$lab" --list-checks)
    n_holes=0
    for source in "$folder"*.c "$folder"*.h "$folder"*.cl; do
        [ -f "$source" ] || continue
        for hole in $("$tools/holes" list "$source"); do
            n_holes=$((n_holes + 1))
            points=$(json_field "$manifest" "$hole" points)
            [ "${points:-0}" -gt 0 ]
            ok $? "$lab: $hole has points in lab.json" "found \"$points\""
            [ "$(json_field "$manifest" "$hole" file)" = "$(basename "$source")" ]
            ok $? "$lab: $hole is in the file that lab.json names"
            grep -q "^### Task $hole\b" "$folder/README.md"
            ok $? "$lab: $hole has a task text in README.md" "no line \"### Task $hole\""
            tested=$(echo "$checks" | awk -F '\t' -v task="$hole" '$2 == task { sum += $3 } END { print sum + 0 }')
            [ "$tested" = "$points" ]
            ok $? "$lab: $hole has checks worth its points" "lab.json: $points, checks: $tested"
        done
    done
    [ "$n_holes" -ge 1 ] && [ "$n_holes" -le 6 ]
    ok $? "$lab: one to six holes" "found $n_holes"
    n_tasks=$(grep -c '"id":' "$manifest")
    [ "$n_tasks" = "$n_holes" ]
    ok $? "$lab: every task of lab.json is a hole" "lab.json: $n_tasks, holes: $n_holes"
    for task in $(echo "$checks" | cut -f 2 | sort -u); do
        grep -q "\"id\": \"$task\"" "$manifest"
        ok $? "$lab: the checks' task $task is in lab.json"
    done
    for id in $(echo "$checks" | cut -f 1); do
        grep -q "$id" "$folder/README.md"
        ok $? "$lab: README.md tells of check $id"
    done
done

# The pictures of the READMEs and notes are what the solutions draw. (make figures mends them.) Colours
# may differ in their last bit from device to device, hence one of 255 levels; in 3D a ray in a thousand
# may graze a sphere here and miss it there, and the heat map shows each step that a ray takes more. What
# the textbook's quadratic makes of small spheres is rounding and nothing else: it only has to be there.
BUILD=${BUILD:-build}
check "the figures can be drawn" tests/figures.sh "$scratch/figures" "$BUILD"
for figure in slides-notes/figures/*; do
    drawn=$scratch/figures/$(basename "$figure")
    case $figure in
    */05-textbook.png) check "$figure is drawn" test -s "$drawn" ;;
    */0[4-7]*.png) check "$figure is what a solution draws" "$tools/compare" "$drawn" "$figure" 0.004 300 ;;
    *.png) check "$figure is what a solution draws" "$tools/compare" "$drawn" "$figure" 0.004 ;;
    *) check "$figure is what a solution draws" cmp "$drawn" "$figure" ;;
    esac
done
for readme in labs/*/README.md slides-notes/*.md README.md; do
    links=$(grep -o '](\([^)#:]*\.\(png\|svg\|md\|json\|txt\)\))' "$readme" | sed 's/^](//; s/)$//')
    for link in $links; do
        [ -f "$(dirname "$readme")/$link" ]
        ok $? "$readme: $link is there"
    done
done

finish

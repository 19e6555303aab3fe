#!/bin/sh
# An instructor's own points (POINTS=): read, refused, graded with, and carried on to a class, bundles and handouts.
#
#     sh tests/suites/points.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh
. tests/schemas.sh

lab=03-kdtree-2d-render
own=$scratch/points.csv
manifest=$scratch/own.json

# own LINE...: a file of points.
own() {
    echo check,points,hint,visible >"$own"
    [ $# -eq 0 ] || printf '%s\n' "$@" >>"$own"
}
# made: the manifest of it.
made() { "$build/tools/points" $lab "$own" "$manifest" >"$scratch/said" 2>&1; }

# ---- Refused, and nothing is written -------------------------------------------------------------

# refused WORDS LINE...
# shellcheck disable=SC2317 # called by check
refused() {
    words=$1
    shift
    own "$@"
    rm -f "$manifest"
    exits 2 made && said "points.csv: $words" && test ! -e "$manifest" && test "$(wc -l <"$scratch/said")" -eq 1
}
check "a check of another lab" refused "line 2: found the check \"overlaps-inside\", expected one of $lab, or TOTAL" \
    overlaps-inside,20,,
check "a check twice" refused "line 3: found leaf-work, which line 2 has already" leaf-work,5,, leaf-work,6,,
check "points that do not add up" refused "all points add up to 105, expected 100; a line TOTAL,105 would say" \
    child-inside,20,,
check "nor to what the file says" refused "all points add up to 105, expected 104" child-inside,20,, TOTAL,104,,
check "no check of a task left" refused "all checks of getContainingChild are turned off" \
    child-inside,0,, child-border,0,, TOTAL,75,,
for points in -5 1.5 ten 1001; do
    check "$points points" refused "line 2: leaf-work: found \"$points\" in the column \"points\", expected a whole" \
        "leaf-work,$points,,"
done
check "a word for visible" refused 'line 2: leaf-work: found "never" in the column "visible", expected yes or no' \
    leaf-work,,,never
check "no time" refused 'line 2: TIME_LIMIT: found "0" in the column "points"' TIME_LIMIT,0,,
check "no seed" refused 'line 2: SEED: found "" in the column "points"' SEED,,,
own
sed -i s/hint/hnt/ "$own"
check "a slip in a title" exits 2 made
check "is named" said 'line 1: found the column "hnt", expected these: check, points, hint, visible'

# ---- Graded with ---------------------------------------------------------------------------------

# A wrong leaf_loop, of which two checks fail: what is equally deep, and the work.
wrong=$scratch/answer
mkdir "$wrong"
cp solutions/$lab/implicit2DRenderer_KD.cl "$wrong"
"$build/tools/known" put $lab later-of-equals "$wrong"
# grade PATH OPTION...
grade() {
    path=$1
    shift
    "$build/tools/grade" --build "$build" --lab 03 --submission "$path" --output "$scratch/graded" "$@" \
        >"$scratch/said" 2>&1
}
value() { jq -r "$1" "$scratch/graded/results.json" | paste -s -d ' '; }

# shellcheck disable=SC2317 # called by check
hides() { ! grep -qF -- "$1" "$2" || { cat "$2"; return 1; }; }

check "a wrong answer, as the course has it" exits 1 grade "$wrong" --seed 7
check "fails what is equally deep" test "$(value '.checks[] | select(.id == "leaf-order") | .status')" = failed

own child-inside,20,, descent-work,0,, 'leaf-order,5,"Say it, in one word.",' leaf-edges,10,, TOTAL,90,, SEED,7,, \
    TIME_LIMIT,30,,
check "own points" exits 0 made
check "graded with them" exits 1 grade "$wrong" --manifest "$manifest"
check "the sum is the file's" test "$(value '.max_score, .score == ([.checks[].points] | add)')" = "90 true"
check "a check has its points" test "$(value '.checks[] | select(.id == "child-inside") | .points')" = 20
check "one that is off is not told" hides descent-work "$scratch/said"
check "nor on the page" hides descent-work "$scratch/graded/report.html"
check "nor in results.json" hides descent-work "$scratch/graded/results.json"
check "its task has the rest" test "$(value '.tasks[] | select(.id == "descent") | .max_points')" = 25
check "the seed is the file's" test "$(value .seed)" = 7
check "the report says whose points these are" said "your instructor's own: 1 check is off, 3 have other points"
check "and the page" grep -qF "your instructor&#39;s own: 1 check is off" "$scratch/graded/report.html"
check "results.json obeys its schema" obeys ../results "$scratch/graded/results.json"
check "a right answer has all" exits 0 grade solutions/$lab --manifest "$manifest"
check "which is the file's sum" said "Score 90/90"
check "a seed of the command line counts before it" exits 0 grade solutions/$lab --manifest "$manifest" --seed 8
check "and is told" test "$(value .seed)" = 8

quick_ends

# ---- Hidden ---------------------------------------------------------------------------------------

# An answer whose wrong colour the checks of leaf_loop name, as nothing else does.
shown=0.7531
loud=$scratch/loud
mkdir "$loud"
"$build/tools/holes" read solutions/$lab/implicit2DRenderer_KD.cl leaf_loop |
    sed "s/(float4)(circle.r/(float4)(${shown}f/" >"$scratch/leaf_loop"
"$build/tools/holes" fill solutions/$lab/implicit2DRenderer_KD.cl leaf_loop "$scratch/leaf_loop" >"$loud/implicit2DRenderer_KD.cl"
# shellcheck disable=SC2317 # called by check
hidden_in() { for one; do hides $shown "$one" || { echo "in $one"; return 1; }; done; }
found_by() { value ".checks[] | select(.id == \"$1\") | .found" | grep -F $shown; }

check "a wrong colour" exits 1 grade "$loud" --seed 7
check "is named" said $shown
own leaf-random,,,no leaf-order,,,no leaf-edges,,,no leaf-work,,,no
check "what these checks find is hidden" exits 0 made
check "from a wrong answer" exits 1 grade "$loud" --manifest "$manifest" --seed 7 --task leaf_loop
check "the terminal says that" said "what it found is not shown"
check "and nothing of it" hidden_in "$scratch/said"
check "the page, too" grep -qF "what it found is not shown" "$scratch/graded/report.html"
check "and nothing of it" hidden_in "$scratch/graded/report.html"
check "no picture shows it" test ! -e "$scratch/graded/pictures.json"
check "nor the page" hides '<img' "$scratch/graded/report.html"
check "results.json has it for the instructor" found_by leaf-random
check "and nowhere else" test "$(jq 'del(.checks[].found) | tostring | contains("'$shown'")' "$scratch/graded/results.json")" = false
check "which its schema says" obeys ../results "$scratch/graded/results.json"
(
    cd tests/systems/formats || exit
    for format in *.jq; do echo "${format%.jq}"; done | grep -v words | paste -s -d ,
) >"$scratch/formats"
tests/systems/formats/write.sh "$(cat "$scratch/formats")" "$scratch/graded" $lab >"$scratch/said" 2>&1
mkdir "$scratch/others"
find "$scratch/graded" -type f ! -name results.json -exec cp {} "$scratch/others" \;
check "every other system's format says only that" grep -q 'what it found is not shown' "$scratch/others"/junit.xml "$scratch/others"/gradescope.json
check "and nothing of it" hidden_in "$scratch/others"/* "$scratch/said"

# ---- Carried on ----------------------------------------------------------------------------------

own child-inside,20,, TOTAL,105,,
make --no-print-directory --old-file=graded grade BUILD="$build" LAB=03 SUBMISSION=solutions/$lab POINTS="$own" \
    >"$scratch/said" 2>&1
check "make grade takes them" said "Score 105/105"

lab=00-hello-pixels
check "right results" exits 0 "$build/tools/grade" --build "$build" --lab 0 --submission solutions/$lab --output "$scratch/right"
sum=$("$build/tools/grade" --build "$build" --lab 0 --list-checks | awk '{ sum += $1 == "gradient-padding" ? 0 : $1 == "gradient-picture" ? 50 : $3 }
    END { print sum }')
own gradient-padding,0,, gradient-picture,50,, "TOTAL,$sum,,"
mkdir -p "$class/Ada Lovelace" && cp solutions/$lab/*.c* "$class/Ada Lovelace"
out=$scratch/out
check "a class" exits 0 run "$out" --points "$own"
score() { jq -r '.students[0].score, .max_score' "$out/gradebook.json" | paste -s -d ' '; }
check "has the points" test "$(score)" = "$sum $sum"
check "keeps the file" cmp "$own" "$out/points.csv"
rm "$own"
check "and takes it by itself" exits 0 run "$out"
check "without grading again" test "$(grep -c grade_one "$out/joblog")" -eq 1
printf 'student,task,points\nAda Lovelace,gradient-padding,+1\n' >"$scratch/changes.csv"
check "a correction of a check that is off" exits 2 run "$out" --changes "$scratch/changes.csv"
check "is refused" said 'but gradient-padding has 0 to 0'
rm "$out/points.csv"
check "without the file" exits 0 run "$out"
check "the course's own count" test "$(score)" = "100 100"

sed "s/(float4)(red,/(float4)(${shown}f,/" solutions/$lab/gradient.cl >"$class/Ada Lovelace/gradient.cl"
own gradient-picture,,,no gradient-padding,,,no
check "a class in which findings are hidden" exits 0 run "$out" --points "$own"
check "its page has them" grep -q $shown "$out/class.html"
check "but not what goes back" exits 0 "$build/tools/gradebook" feedback folders "$out"
check "to the student" hidden_in "$out"/feedback/*/* "$out/feedback.csv"

# ---- Hidden in a handout ----------------------------------------------------------------------------

lab=03-kdtree-2d-render
own leaf-random,,,no leaf-order,,,no leaf-edges,,,no leaf-work,,,no
check "a manifest that hides" exits 0 made
# A handout has the manifest, and no solution.
course=$scratch/at-home
mkdir -p "$course/solutions" "$course/tests/skeletons/$lab"
for part in Makefile common kernels slides-notes tests/probes tests/stubs solutions/0[0-2]*; do ln -s "$PWD/$part" "$course/$part"; done
cp -R labs "$course/labs"
cp "labs/$lab/implicit2DRenderer_KD.cl" "$course/tests/skeletons/$lab/"
cp "$manifest" "$course/labs/$lab/lab.json"
cp "$loud/implicit2DRenderer_KD.cl" "$course/labs/$lab/"
mkdir "$course/build"
for part in tools judges probes earlier; do cp -R "$build/$part" "$course/build"; done
mkdir "$course/build/labs"
cp "$build/labs/$lab" "$course/build/labs"
cp "$build"/*.so "$build"/libcommon.a "$build/no_macros.h" "$course/build"
mkfifo "$scratch/keys"
(cd "$course" && exec build/tools/desk watch --make true --lab $lab <"$scratch/keys" >"$scratch/watched" 2>&1) &
watch=$!
exec 3>"$scratch/keys"
is_graded() { grep -q '^   h hint' "$scratch/watched"; }
await is_graded
printf h >&3
has_answered() { grep -q 'there is no hint' "$scratch/watched"; }
await has_answered
printf q >&3
wait $watch
check "make watch says only that" grep -q 'what it found is not shown' "$scratch/watched"
check "and its page" grep -q 'what it found is not shown' "$course/build/watch/index.html"
check "and nothing of it, nor of a hint" hidden_in "$scratch/watched" "$course/build/watch/index.html" "$course"/build/grade/03/*.*
check "nor has what make progress keeps" hidden_in "$course/progress.json"

# ---- Packed with ---------------------------------------------------------------------------------

own child-inside,20,, descent-work,0,, TOTAL,95,,
make --no-print-directory gradescope POINTS="$own" LAB=03 >"$scratch/said" 2>&1
check "a bundle carries them" test "$(unzip -p build/systems/gradescope-03.zip 'course/solutions/03-*/lab.json' |
    jq '.changed.total, .tasks[1].points["descent-work"]' | paste -s -d ' ')" = "95 0"
make --no-print-directory pack POINTS="$own" LAB=03 >"$scratch/said" 2>&1
check "and a handout" test "$(tar -xzOf build/handout/03-kdtree-2d-render.tar.gz 03-kdtree-2d-render/labs/03-kdtree-2d-render/lab.json |
    jq '.changed.total, .tasks[1].points["descent-work"]' | paste -s -d ' ')" = "95 0"
check "whose README says so" sh -c "tar -xzOf build/handout/03-kdtree-2d-render.tar.gz 03-kdtree-2d-render/README.md |
    grep -q 'your course.s own'"

finish

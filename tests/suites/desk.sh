#!/bin/sh
# The learner's desk: progress, hints, and the watch over what is saved, in a copy of the course.
#
#     sh tests/suites/desk.sh      from the top folder, after `make tests`
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL
. tests/tap.sh
editor_tasks=$PWD/.vscode/tasks.json
native=$PWD/${BUILD:-build}/native
. tests/course_copy.sh
# What judges without a driver; not the kernels that are kept there.
mkdir build/native
cp -pR "$native/probes" "$native/libcommon.a" build/native
for part in tools judges earlier no_macros.h; do ln -s ../$part build/native/$part; done
# Other users may enter, as the sandbox's is somebody else.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/work"
export TMPDIR="$scratch/work"
lab=03-kdtree-2d-render
file=labs/$lab/implicit2DRenderer_KD.cl
right=solutions/$lab/implicit2DRenderer_KD.cl
rm -f progress.json
make -s skeletons

# says WORDS COMMAND...: does its output hold the words?
says() {
    words=$1
    shift
    said=$("$@" 2>&1)
    printf '%s\n' "$said" | grep -qF -- "$words" || { printf '%s\n' "$said"; return 1; }
}

# matched COMMAND FIELD: the lines of stdin that VS Code's matcher of the task with this command finds; a pattern of its
# `background`, or with FIELD `pattern` what is taken out of a line: file, line, column, severity, message.
matched() {
    jq -rR --arg command "$1" --arg field "$2" --slurpfile tasks "$editor_tasks" '
        ($tasks[0].tasks[] | select(.args[0] == $command) | .problemMatcher) as $matcher |
        if $field == "pattern"
        then $matcher.pattern as $p | match($p.regexp).captures as $c |
            [$p.file, $p.line, $p.column, $p.severity, $p.message] | map($c[. - 1].string // "-") | join("|")
        else select(test($matcher.background[$field])) end'
}

# ---- Progress and hints ---------------------------------------------------------------------------

check "without a grading nothing is reached" says "0 of 11 labs done, 0 of 1100 points. Planned: 35 hours" make -s progress
check "a hint needs a grading" says "run make grade LAB=03 first" make -s hint LAB=03
check "the lab is asked for" says "say which lab" make -s hint
make -s grade LAB=03 >/dev/null 2>&1
check "make grade notes what is reached" says "Next: getContainingChild in labs/$lab: make watch LAB=03" make -s progress
check "the first hint is the idea" says "1 of 4  Draw the two cells" make -s hint LAB=03
check "the next time there is one more" says "2 of 4  " make -s hint LAB=03
make -s hint LAB=03 >/dev/null
check "the last one is the formula" says "4 of 4  " make -s hint LAB=03
check "after it there are no more" says "There are no more" make -s hint LAB=03
check "a grading of the same fault keeps them" sh -c 'make -s grade LAB=03 >/dev/null 2>&1; grep -q "\"hints\": 4" progress.json'
check "another's submission is not one's own progress" sh -c "make -s grade LAB=03 SUBMISSION=solutions/$lab >/dev/null 2>&1; grep -q '\"score\": 0' progress.json"
echo '{' >progress.json
check "a damaged record is named" says "progress.json: cannot be read" make -s progress
check "and so in one message that says what to do" says "delete it" build/tools/desk hint --lab "$lab"
rm progress.json

# ---- Watching -------------------------------------------------------------------------------------

mkfifo keys
log=$PWD/watch.log
build/tools/desk watch --lab "$lab" --native build/native <keys >"$log" 2>&1 &
watch=$!
exec 3>keys
trap 'kill $watch 2>/dev/null; rm -rf "$scratch"' EXIT

# News: as many rounds have begun, and are done, when the keys are offered.
rounds() { grep -c '^---- ' "$log"; }
offers() { grep -c '^   h hint' "$log"; }
# done_after N: were the keys offered more than N times?
done_after() { [ "$(offers)" -gt "$1" ]; }
# saved COMMAND...: do it, and wait for what comes of it.
saved() {
    before=$(offers)
    "$@"
    await done_after "$before"
}
# last WORDS: are they in what was printed since the last round began?
last() { awk '/^---- /{text = ""} {text = text "\n" $0} END {print text}' "$log" | grep -qF -- "$1" || { tail -n 40 "$log"; return 1; }; }
# write FILE: save what standard input holds, by renaming: of a file that is written in its place the watch may see a part
# for so long, on a busy machine, that it begins a round with it.
write() { cat >"$1.new" && mv "$1.new" "$1"; }
as_solved() { write "$file" <"$right"; }
with_a_typo() { sed 's/uint offset/uint begin/' "$right" | write "$file"; }
last_missing() { sed 's/i <= n_circles/i < n_circles/' "$right" | write "$file"; }

await done_after 0
check "it begins with a verdict" last "Score 0/100"
saved as_solved
check "a save by renaming is seen, and its picture is right" last "the picture is as it should be"
check "it is graded" last "Score 100/100"
check "without a driver first" last "   judged in "
check "and PoCL says the same" last "   PoCL says the same"
check "what was gained is told" last "+15  leaf-random"
check "the page shows it" grep -q '100 <small>of 100' build/watch/index.html
quick_done=$(rounds)
touch "$file"
as_solved
saved with_a_typo
check "the same bytes again are no save" [ "$(rounds)" -eq $((quick_done + 1)) ]
check "what does not compile is named at once" last "does not compile"
check "at the student's line" last "error: use of undeclared identifier 'offset'"
check "and on the page" grep -q "undeclared identifier" build/watch/index.html
check "with the picture of the save before" grep -q 'before this change</figcaption><img src="picture.png' build/watch/index.html
check "and the expected one" grep -q 'src="expected.png' build/watch/index.html
# found_by_editor COMMAND FILE PLACE: is this one of those that VS Code finds in a file?
found_by_editor() {
    matched "$1" pattern <"$2" >"$scratch/found"
    grep -qxF "$3" "$scratch/found" || { cat "$scratch/found"; return 1; }
}
# place_of WORD: the line of our file, and the column, where it is first.
place_of() { awk -v word="$1" 'index($0, word) { print NR "|" index($0, word); exit }' "$file"; }
check "VS Code finds the place in what the watch prints" found_by_editor watch "$log" \
    "$file|$(place_of offset)|error|use of undeclared identifier 'offset'"
saved last_missing
check "what was lost is told" last "-15  leaf-random"
check "a wrong pixel can be followed" last "see why: make pixel LAB=03 AT="
# The first line of an answer, of which the editor is told.
answer=$(awk '/ TASK leaf_loop/ { inside = 1 } inside && !/^ *\/\/ / { print NR; exit }' "$file")
tail -n 16 "$log" >"$scratch/fault"
check "so can its answer in VS Code" found_by_editor watch "$scratch/fault" \
    "$file|$answer|-|error|leaf-random: $(jq -r '.checks[] | select(.id == "leaf-random") | .cause // .message' build/grade/03/results.json)"
check "the page has the difference" grep -q 'difference.png' build/watch/index.html
saved eval 'printf h >&3'
check "h shows a hint" last "1 of 4  "
check "a second watch is refused" says "one runs here already" build/tools/desk watch --lab "$lab"

check "VS Code sees when a round begins and ends" [ "$(matched watch beginsPattern <"$log" | wc -l) $(matched watch endsPattern <"$log" | wc -l)" = \
    "$(rounds) $(offers)" ]

kill -INT "$watch"
wait "$watch"
ok $? "Ctrl-C ends it" "$(tail -n 5 "$log")"
nothing_is_left() { [ -z "$(ls -A "$TMPDIR")" ] && ! pgrep -f "$course" >/dev/null; }
await nothing_is_left
ok $? "and nothing of it is left" "$(ls -A "$TMPDIR")"
quick_ends

# ---- Two judges, and two saves ------------------------------------------------------------------------

# begin_watch LAB OPTION...: another one.
begin_watch() {
    : >"$log"
    build/tools/desk watch --lab "$@" <keys >"$log" 2>&1 &
    watch=$!
    exec 3>keys
    await done_after 0
}
end_watch() {
    printf q >&3
    wait "$watch"
}
begin_watch "$lab" --native build/native
two_wrong() { sed -e 's/i <= n_circles/i < n_circles/' -e 's/x < box.maxX/x <= box.maxX/' "$right" | write "$file"; }
saved two_wrong
check "a later task that failed, too, is marked as the first one" \
    [ "$(grep -o 'check failed' build/watch/index.html | wc -l)" -eq 2 ]

# What only one of the two sees: the header of the native runtime, a function that it lacks.
wrong_natively() { sed 's/i <= n_circles/i < n_circles + (NATIVELY == 0)/' "$right" | sed '/^#include "work.h"/a\
#ifdef NATIVE_KERNELS_H\
#define NATIVELY 1\
#else\
#define NATIVELY 0\
#endif' | write "$file"; }
saved wrong_natively
check "where PoCL judges otherwise, that is said" last "PoCL judges otherwise, and that counts"
check "with what it found" last "Score 100/100"
check "and what is another verdict" last "+15  leaf-random"
check "and it counts" says "100/100" make -s progress
lacking() { sed 's/const int y = get_global_id(1);/& mem_fence(CLK_GLOBAL_MEM_FENCE);/' "$right" | write "$file"; }
saved lacking
check "what cannot be compiled without a driver is graded by PoCL" last "Score 100/100"
check "without a word" sh -c "! tail -n 20 '$log' | grep -e 'judged in' -e 'PoCL' -e symbol"

# Two saves, the second while the first one is graded, which needs seconds of processor time for an endless loop: the last
# one has its verdict.
before=$(offers)
rounds_before=$(rounds)
sed 's/const int y = get_global_id(1);/& for (;;) { }/' "$right" | write "$file"
more_rounds() { [ "$(rounds)" -gt "$rounds_before" ]; }
await more_rounds
as_solved
await done_after "$before"
check "a save in the middle of a round ends it" [ "$(grep -c 'not graded to its end' "$log")" -ge 1 ]
check "and is not missed" last "Score 100/100"
check "what was reached is noted" says "100/100" make -s progress
end_watch

# ---- A host file ------------------------------------------------------------------------------------

host=labs/00-hello-pixels/render.c
cp solutions/00-hello-pixels/gradient.cl labs/00-hello-pixels/
cp solutions/00-hello-pixels/render.c "$host"
begin_watch 00-hello-pixels
check "a lab of host files is watched" last "the picture is as it should be"
touch -d '2 days ago' "$scratch/older"
sed 's/^    \/\/ TASK read_back.*/    exit(0);\n&/' "$host" >"$scratch/exits.c"
touch -r "$scratch/older" "$scratch/exits.c"
saved mv "$scratch/exits.c" "$host"
check "a file with an older time is compiled, too" last "ends without a picture"
check "and the page shows why it ended" grep -q "it ended by itself" build/watch/index.html
saved mv "$host" "$scratch/away.c"
check "a file that is gone is no program of before" last "does not compile"
saved mkdir "$host"
check "nor is a folder in its place" last "does not compile"
saved rmdir "$host"
host_back() { write "$host" <solutions/00-hello-pixels/render.c; }
saved host_back
check "it goes on when the file is back" last "Score 100/100"
end_watch
check "the page says that the watch has ended" grep -q "the watch has ended" build/watch/index.html
begin_watch 00-hello-pixels
mv build/watch "$scratch/gone"
wait "$watch"
check "without its folder it ends" last "is gone: start make watch again"
mv "$scratch/gone" build/watch

# ---- A wrong pixel ----------------------------------------------------------------------------------

last_missing
check "make grade says how a wrong pixel is followed" says "See why: make pixel LAB=03 AT=x,y" make -s grade LAB=03
cp "$right" "$file"
check "a right picture has none" sh -c "! make -s grade LAB=03 2>&1 | grep 'See why'"

# ---- Somebody else's file in labs/ ------------------------------------------------------------------

# What it does when a program starts that it is a part of, before main(). Nothing of the program is called.
other=04-camera-rays
for labs_file in camera_from_view.c primary_ray.cl draw_directions.cl; do
    cp "solutions/$other/$labs_file" "labs/$other/"
done
build/tools/known put $other flipped-picture "labs/$other"
cat >>"labs/$other/camera_from_view.c" <<END
#include <fcntl.h>
__attribute__((constructor)) static void begin(void) { creat("$scratch/ran-outside", 0600); }
END
stays_inside() { "$@" >"$scratch/said" 2>&1; [ ! -e "$scratch/ran-outside" ]; }
check "make grade runs it in the sandbox only" stays_inside make -s grade LAB=04
check "and it was about a pixel" grep -q ': pixel (' "$scratch/said"
check "so does make hint" stays_inside make -s hint LAB=04
check "so does make progress" stays_inside make -s progress
mkdir -p "$scratch/class/Ada"
cp "labs/$other"/*.c* "$scratch/class/Ada/"
check "so does make grade-class" stays_inside tests/class/grading/grade_class.sh --build build --lab 04 \
    --submissions "$scratch/class" --output "$scratch/graded"
check "which graded it" grep -q '^1 of 1 graded' "$scratch/said"
check "so does make copies" stays_inside tests/copies/copies.sh --build build --lab 04 --output "$scratch/graded"
check "which read it" grep -q '^1 authors' "$scratch/said"
make -s build/labs/$other >/dev/null 2>&1
check "and it would have been seen" sh -c "build/labs/$other --size 8x8 --output open.png >/dev/null 2>&1; test -e '$scratch/ran-outside'"

# ---- A grading that is ended ------------------------------------------------------------------------

for signal in TERM KILL; do
    build/tools/grade --lab 03 >/dev/null 2>&1 &
    grading=$!
    # Its folders are made when who clears up behind it is there.
    has_begun() { ls -d "$TMPDIR"/*/tree >/dev/null 2>&1; }
    await has_begun
    kill -$signal $grading
    wait $grading 2>/dev/null
    await nothing_is_left
    ok $? "a grading that is ended by $signal leaves nothing" "$(ls -A "$TMPDIR")"
done

# ---- The open scene -----------------------------------------------------------------------------------

for manifest in solutions/*/lab.json; do
    name=$(basename "$(dirname "$manifest")")
    figure=$(sed -n 's/^  "figure": "\(.*\)",$/\1/p' "$manifest")
    [ -n "$figure" ] || continue
    options=$(sed -n 's/^  "look": "\(.*\)",$/\1/p' "$manifest")
    # shellcheck disable=SC2086 # words
    "build/solutions/$name" $options --output open.png >/dev/null 2>&1
    check "$name: the solution draws the figure that students compare with" \
        build/tools/compare open.png "slides-notes/figures/$figure" 0.006 500
done

finish

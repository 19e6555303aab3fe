#!/bin/sh
# Following one pixel (common/follow): is what is told what the programs draw and count, and does it tell where a
# known wrong answer parts from the reference?
#
#     sh tests/suites/pixel.sh      from the top folder, after `make tests`
set -u
# Suites run under make, and call it: not as a part of that one.
unset MAKEFLAGS MFLAGS MAKELEVEL
. tests/tap.sh
. tests/programs.sh

# follow LAB X,Y OPTION...: the solution's pixel; what it says goes to $scratch/stdout and stderr.
follow() (
    for program in "$build/pixel/solutions/$1"-*; do :; done
    at=$2
    shift 2
    "$program" --pixel "$at" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null
)

# says REGULAR-EXPRESSION...: does a line of what was told look like each?
says() {
    for words; do
        grep -q -- "$words" "$scratch/stdout" || { echo "no line: $words"; cat "$scratch/stdout"; return 1; }
    done
}

# ---- The right outcome ----------------------------------------------------------------------------

# value PICTURE OTHER X Y: the numbers of a pixel, "r g b a". compare prints them where two differ, so OTHER is a
# picture that does.
value() {
    for file in "$1" "$2"; do
        crop "$file" "$3" "$4" 1 1 "$out/$(basename "$file" .exr)-one.exr" || return 1
    done
    compare "$out/$(basename "$1" .exr)-one.exr" "$out/$(basename "$2" .exr)-one.exr" |
        sed 's/.*found (\(.*\)), expected.*/\1/; s/,//g'
}

# drawn LAB OPTION...: the lab's own picture and counters of a scene, for the checks behind it.
drawn() {
    drawn_lab=$1
    shift
    run "$drawn_lab" --output "$out/drawn.exr" --heat-map "$@" || { cat "$scratch/stderr"; return 1; }
}

# as_drawn X Y OPTION...: are the counted steps those of the counting kernel, and, in 2D, the colour the picture's?
as_drawn() {
    x=$1 y=$2
    shift 2
    works follow "$drawn_lab" "$x,$y" "$@" || return 1
    counted=$(value "$out/drawn-work.exr" "$out/drawn.exr" "$x" "$y")
    told=$(sed -n 's/^your kernel: //p' "$scratch/stdout" | sed 's/[^0-9]/ /g')
    # shellcheck disable=SC2086 # numbers
    set -- $told 0 0
    [ "$1 $2 $3 $4" = "$counted" ] || { echo "told $1 $2 $3 $4, counted $counted"; return 1; }
    # shellcheck disable=SC2086
    set -- $told
    [ $# -eq 2 ] || return 0
    colour=$(sed -n 's/^ *[0-9]* *colour: //p' "$scratch/stdout")
    expected=$(value "$out/drawn.exr" "$out/drawn-work.exr" "$x" "$y")
    printf '%s %s\n' "$colour" "$expected" | awk '{ for (i = 1; i <= 4; i++) if (($i - $(i + 4))^2 > 1e-6) exit 1 }' ||
        { echo "told $colour, drawn $expected"; return 1; }
}

# agrees X Y OPTION...: the same, and the reference does what the kernel does.
agrees() {
    as_drawn "$@" && says 'they do the same in all'
}

empty_output_folder
circles='--scene random:n=500 --size 64x48'
spheres='--scene sphereflake:size=2 --size 64x48'
# shellcheck disable=SC2086 # options
{
    drawn 01 $circles
    check "lab 01: as drawn and counted" agrees 20 30 $circles
    drawn 03 $circles
    check "lab 03: as drawn and counted" agrees 20 30 $circles
    check "lab 03: in a corner" agrees 63 47 $circles
    drawn 05 $spheres
    check "lab 05: as counted" agrees 30 20 $spheres
    drawn 07 $spheres
    check "lab 07: as counted" agrees 30 20 $spheres
    check "lab 07: another ray" agrees 33 35 $spheres
    check "lab 07: a ray beside the box" agrees 0 0 $spheres
    drawn 08 $spheres
    check "lab 08: as counted, through a tree by cost" agrees 30 20 $spheres
    check "lab 08: another ray" agrees 33 35 $spheres
}

# ---- The worked examples of the notes -------------------------------------------------------------

check "the search for node 13" works follow 03 7,7 --scene example --max-depth 4 --leaf-size 1
check "takes the steps of notes-2d" says '^   0  node 0: x \[0, 10), y \[0, 10)$' '^   1  node 2:' '^   2  node 6:' \
    '^        left child 13: x \[5, 7.5), y \[5, 10); right 14$' '^   3  leaf 13:' '2 circles, from offset 16 on' \
    '^   4    circle 2: nearest so far' '^   5    circle 4: no$' '^   6  colour: 0.15 0.35 0.95 1$' \
    '^your kernel: 2 tests, 3 nodes$' '^they do the same in all 7 steps$'

# notes-3d, section 5: from (-2.1, -1.1, -0.5) in the direction (0.8, 0.6, 0).
check "the eye of the worked example" works follow 07 1,1 --scene tests/scenes/worked.nff --leaf-size 1
check "takes the steps of notes-3d" says '^   0  node 0: x = 0, t 1.5 to 3.333' 't_split 2.625, near 1, far 2: both' \
    '^   1  node 1: y = 0, t 1.5 to 2.625' 't_split 1.8333, near 3, far 4: both' \
    '^   2  node 3: z = 0' '^        waiting: 4 \[1.833, 2.625\], 2 \[2.625, 3.333\]$' '^   3  leaf 7: t 1.5 to 1.833' \
    '^   4    sphere 0: missed$' '^   5  node 4: ' '^   6  leaf 9: ' '^   7    sphere 2: t 2$' '^   8  hit: sphere 2, t 2$' \
    'which asks all 8 spheres: hit: sphere 2, t 2$' '^they do the same in all 9 steps$'

quick_ends

# ---- As JSON, and as a picture --------------------------------------------------------------------

# same_steps: are the steps of $out/steps.json those that were told: kinds, numbers, t, who waits, the counts?
same_steps() {
    jq -r '.own | .steps as $all | range($all | length) as $i | $all[$i] | "\($i) \(.step) \(.id)"' \
        "$out/steps.json" >"$scratch/json" || return 1
    sed -n 's/^ *\([0-9]*\)  *\(node\|leaf\) \([0-9]*\):.*/\1 \2 \3/p
        s/^ *\([0-9]*\)  *\(sphere\|circle\) \([0-9]*\):.*/\1 test \3/p' "$scratch/stdout" >"$scratch/told"
    # What ends it has other words in either.
    grep -v ' end ' "$scratch/json" | diff "$scratch/told" - || return 1
    counts=$(jq -r '.own | "\(.tests) \(.nodes) \(.leaves) \(.most_waiting)"' "$out/steps.json")
    told=$(sed -n 's/^your kernel: //p' "$scratch/stdout" | sed 's/[^0-9]/ /g')
    # shellcheck disable=SC2086 # numbers
    set -- $told 0 0
    [ "$1 $2 $3 $4" = "$counts" ] || { echo "told $told, found $counts"; return 1; }
}

# is_legible FILE: is it well-formed, is no text of less than 20 px, and every text inside? A letter is taken for
# 0.62 of its size wide.
is_legible() {
    xmllint --noout --nonet "$1" || return 1
    # Entities are one letter each, and so are the bytes of one character.
    sed 's/&[a-z]*;/x/g' "$1" | LC_ALL=C sed 's/[\x80-\xbf]//g' | LC_ALL=C awk '
        function of(name,  text) { text = $0; if (!sub(".* " name "=\"", "", text)) return ""; sub("\".*", "", text); return text }
        /^<svg xmlns/ { width = of("width") + 0; height = of("height") + 0; size = of("font-size") + 0 }
        /^<text/ {
            n++
            own = of("font-size") == "" ? size : of("font-size") + 0
            words = $0; sub(/^<text[^>]*>/, "", words); sub(/<.*/, "", words)
            wide = 0.62 * own * length(words)
            left = of("x") - (of("text-anchor") == "end" ? wide : of("text-anchor") == "middle" ? wide / 2 : 0)
            if (left < 0 || left + wide > width || of("y") - own < 0 || of("y") + own / 4 > height || own < 20)
                { print "not inside: " $0; bad = 1 }
        }
        END { if (n == 0 || width != 1024) print "no text, or not as wide as all: " n " " width; exit bad || n == 0 || width != 1024 }'
}

# written LAB X,Y OPTION...: JSON with the same steps as the words, and a picture that can be read.
written() {
    written_lab=$1 at=$2
    shift 2
    works follow "$written_lab" "$at" --json "$out/steps.json" --svg "$out/steps.svg" "$@" && same_steps && is_legible "$out/steps.svg"
}

empty_output_folder
check "lab 01: written and drawn" written 01 20,30 --scene random:n=50 --size 64x48
check "lab 03: written and drawn" written 03 320,200 --scene random --size 640x480
check "lab 05: written and drawn" written 05 30,20 --scene sphereflake:size=2 --size 64x48
check "lab 07: written and drawn" written 07 33,35 --scene sphereflake --size 64x48
check "a ray beside the box, too" written 07 0,0 --scene sphereflake --size 64x48
check "the worked example" written 07 1,1 --scene tests/scenes/worked.nff --leaf-size 1
found=$(jq -c '[.lab, .pixel, .parting, .rounding_decides, .own.n_steps, .own.steps[1].waiting[0].node,
    .own.steps[0].meets, .own.steps[0].near, .own.steps[4].t, .own.steps[8].id]' "$out/steps.json")
[ "$found" = '["07-kdtree-3d-trace",[1,1],null,false,9,2,"both",1,null,2]' ]
ok $? "its JSON names the pixel, who waits, both children, a miss and the hit" "$found"
found=$(grep -c '<rect.*fill="#cfe8f7"\|<rect.*fill="#f7dfb0"' "$out/steps.svg")
[ "$found" -eq 8 ]
ok $? "its picture has a bar for each of its six visits, and two in the legend" "$found"
check "a scene's name with what XML takes for its own" sh -c "cp tests/scenes/worked.nff '$scratch/a<&b>.nff'"
check "is drawn all the same" written 07 1,1 --scene "$scratch/a<&b>.nff"
check "as JSON says it" sh -c "jq -e '.scene | endswith(\"a<&b>.nff\")' '$out/steps.json'"

# watched LAB X,Y OPTION...: all of it with the sanitizers watching; what drivers leak is theirs.
watched() {
    for program in "$build/sanitized/pixel/solutions/$1"-*; do :; done
    at=$2
    shift 2
    works with ASAN_OPTIONS=detect_leaks=0 run_into_scratch "$program" --pixel "$at" --json "$out/steps.json" --svg "$out/steps.svg" "$@" ||
        return 1
    [ ! -s "$scratch/stderr" ] || { cat "$scratch/stderr"; return 1; }
}
run_into_scratch() { "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null; }
if $is_sanitized; then
    check "lab 01, watched: more steps than are kept" watched 01 20,30 --scene random:n=600 --size 64x48
    check "lab 03, watched" watched 03 20,30 --scene random:n=500 --size 64x48
    check "lab 05, watched: more steps than are kept" watched 05 30,20 --scene sphereflake:size=3 --size 64x48
    check "lab 07, watched" watched 07 30,20 --scene sphereflake --size 64x48
fi

# ---- The notes' figures ---------------------------------------------------------------------------

# Those that explain; the other drawing is of a picture's size.
for figure in slides-notes/figures/*.svg; do
    drawing=${figure##*/}
    [ "$drawing" != 02-kdtree-2d-build.svg ] || continue
    check "$drawing can be read" is_legible "$figure"
    grep -q "!\[.\{40,\}\](figures/$drawing)" slides-notes/notes-*.md
    ok $? "$drawing stands in the notes, with a text for those who cannot see it"
done

# ---- Wrong answers --------------------------------------------------------------------------------

# mutant LAB MUTANT X,Y OPTION...: the skeleton's program over this known wrong answer to one task, with the
# solution's files beside it.
course=$scratch/course
mutant() {
    for lab in solutions/"$1"-*; do lab=${lab#solutions/}; done
    rm -rf "$course"
    mkdir -p "$course/labs" "$course/build"
    for entry in kernels solutions common tests; do ln -s "$PWD/$entry" "$course/$entry"; done
    cp -r "solutions/$lab" "$course/labs/"
    "$build/tools/known" put "$lab" "$2" "$course/labs/$lab" || return 1
    at=$3
    shift 3
    (cd "$course" && "$build/pixel/labs/$lab" --pixel "$at" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null)
}

check "lab 03, left and right swapped: it runs" mutant 03 \
    left-right-swapped 7,7 --scene example --max-depth 4 --leaf-size 1
check "and parts at the second node" says '^they part at step 1$' '^   1  node 1: .*| node 2: '
check "lab 03, the upper side closed: a pixel elsewhere is the same" mutant 03 \
    upper-side-closed 7,7 --scene example --max-depth 4 --leaf-size 1
check "and says so" says '^they do the same in all 7 steps$'
check "one on the border" mutant 03 upper-side-closed 5,5 \
    --scene example --max-depth 4 --leaf-size 1
check "goes the wrong way" says '^they part at step 1$'
check "lab 07, t_min kept: it runs" mutant 07 child-far-keeps-t_min 1,1 \
    --scene tests/scenes/worked.nff --leaf-size 1
check "and parts where that far child waits" says '^they part at step 1$' \
    '^        waiting: 2 \[1.5, 3.333\]  *| *waiting: 2 \[2.625, 3.333\]$'
check "lab 07, any hit ends: it runs" mutant 07 waiting-never-ends-early 1,1 \
    --scene tests/scenes/worked.nff --leaf-size 1 --svg "$out/parted.svg"
check "and parts where the search should have ended" says '^they part at step 8$' '^   8  node 2: .*| hit: sphere 2, t 2$'

check "its picture shows both" sh -c "grep -q 'Here they part. Your kernel:' '$out/parted.svg' && grep -q '>The reference:' '$out/parted.svg'"
check "and can be read" is_legible "$out/parted.svg"

# ---- What is wrong --------------------------------------------------------------------------------

empty_output_folder
check "a pixel to the right of the picture" refuses 'found "64,3", expected X from 0 to 63 and Y from 0 to 47' \
    follow 03 64,3 --size 64x48 --scene random:n=5
check "a pixel below it" refuses 'found "3,48", expected X from 0 to 63' follow 07 3,48 --size 64x48 --scene one
check "no pixel at all" refuses 'found "-1,4", expected X,Y' follow 01 -1,4 --size 64x48
check "a folder for its JSON that is not there" refuses '--json: found' follow 01 1,1 --size 64x48 --json "$out/no/a.json"
check "nor one for its picture" refuses '--svg: found' follow 01 1,1 --size 64x48 --svg "$out/no/a.svg"
check "words" refuses 'found "a,b", expected X,Y' follow 01 a,b --size 64x48
# pixel_make WORD...: make pixel, without make's own last line.
pixel_make() {
    status=0
    make -s pixel "$@" BUILD="$build" >"$scratch/stdout" 2>"$scratch/said" </dev/null || status=$?
    grep -v '^make' "$scratch/said" >"$scratch/stderr"
    grep '^make pixel' "$scratch/said" >>"$scratch/stderr"
    return $status
}
check "a lab without a kernel that draws" refuses 'make pixel: 02-kdtree-2d-build has no pixel to follow. These labs have one: 01-naive-2d ' pixel_make LAB=02 AT=1,1
check "a lab with many rays a pixel" refuses 'make pixel: 09-shadows-and-mirrors has no pixel to follow. ' pixel_make LAB=09 AT=1,1
check "and make asks for a pixel" refuses 'say which pixel: make pixel LAB=03 AT=200,120' pixel_make LAB=03

finish

#!/bin/sh
# The demonstration behind `make demo`: render every solution into a gallery, grade a small class.
#
#     tests/demo.sh [BUILD-FOLDER]
#
# Ends with the paths of both pages.
set -eu

build=${1:-build}
gallery=$build/gallery
class=$build/demo-class
rm -rf "$gallery" "$class"
mkdir -p "$gallery" "$class"

# ---- The gallery ------------------------------------------------------------------------------

# HTML's special characters in a text.
escape() {
    sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g'
}

# The title in a lab's manifest.
title() {
    jq -er .title "solutions/$1/lab.json" | escape
}

# One picture: run a solution with options and add it to the page. figure LAB FILE OPTION...
figure() {
    lab=$1
    file=$2
    shift 2
    echo "  $lab $*"
    "$build/solutions/$lab" "$@" --output "$gallery/$file" --stats "$gallery/$file.json" >"$gallery/$file.txt"
    {
        echo "<figure><img src=\"$file\" alt=\"$(title "$lab")\">"
        # A line may break between words, not inside "--size".
        words=$(echo "build/solutions/$lab $*" | escape | sed 's|[^ ][^ ]*|<span>&</span>|g')
        echo "<figcaption><code>$words</code></figcaption>"
        echo "<details><summary>Figures of this run</summary><pre>$(escape <"$gallery/$file.txt")</pre></details>"
        echo "</figure>"
    } >>"$gallery/index.html"
}

# One more picture that the last run has made. picture LAB FILE TEXT
picture() {
    echo "<figure><img src=\"$2\" alt=\"$(title "$1")\"><figcaption>$3</figcaption></figure>" \
        >>"$gallery/index.html"
}

# Start a lab's section.
section() {
    printf '</section><section><h2>%s <span>%s</span></h2>\n' "$1" "$(title "$1")" >>"$gallery/index.html"
}

echo "Rendering every solution:"
cat >"$gallery/index.html" <<'HTML'
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>From circles to rays: gallery</title>
<style>
:root { color-scheme: light dark; --ink: #1c2430; --soft: #667; --paper: #f6f7f9; --card: #fff; --line: #dde1e7 }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ee; --soft: #99a; --paper: #14171c; --card: #1d2128; --line: #333a44 } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 76rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-weight: 650; margin-bottom: .2rem } h2 { font-size: 1.15rem; margin: 2.2rem 0 .8rem } h2 span { color: var(--soft); font-weight: 400 }
section { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(22rem, 100%), 1fr)); gap: 1rem } section > h2 { grid-column: 1 / -1; margin-bottom: 0 }
figure { margin: 0; padding: .8rem; background: var(--card); border: 1px solid var(--line); border-radius: .6rem; min-width: 0 }
img { width: 100%; height: auto; border-radius: .3rem; display: block; image-rendering: auto; background: #000 }
figcaption { margin-top: .6rem } code { font-size: .8rem } code span { white-space: nowrap } summary { color: var(--soft); font-size: .85rem; cursor: pointer }
pre { font-size: .75rem; overflow-x: auto; margin: .4rem 0 0 } p { color: var(--soft); margin-top: 0 }
</style></head><body>
<h1>From circles to rays</h1>
<p>Every picture here was just rendered by a solution on this machine.</p>
<section>
HTML

section 00-hello-pixels
figure 00-hello-pixels 00.png
figure 00-hello-pixels 00-odd.png --size 317x211
section 01-naive-2d
figure 01-naive-2d 01.png --scene random:n=500,seed=1 --size 640x480
figure 01-naive-2d 01-ties.png --scene equal-depths --size 640x480
figure 01-naive-2d 01-borders.png --scene borders --size 640x480
section 02-kdtree-2d-build
figure 02-kdtree-2d-build 02-example.png --scene example --max-depth 4 --leaf-size 1
figure 02-kdtree-2d-build 02.png --scene random:n=500,seed=1 --size 640x480
figure 02-kdtree-2d-build 02-deep.png --scene random:n=60,seed=2,max=60 --size 640x480 --leaf-size 2
section 03-kdtree-2d-render
figure 03-kdtree-2d-render 03.png --scene random:n=500,seed=1 --size 640x480
figure 03-kdtree-2d-render 03-lecture.png --scene random:n=8192,seed=1 --frames 5
figure 03-kdtree-2d-render 03-odd.png --scene random:n=8192,seed=3,max=8 --size 317x211
section 04-camera-rays
figure 04-camera-rays 04.png
figure 04-camera-rays 04-planes.png --scene planes --size 640x480
section 05-spheres
figure 05-spheres 05.png --scene sphereflake:size=2
figure 05-spheres 05-caffeine.png --scene tests/scenes/caffeine.xyz
figure 05-spheres 05-example.png --scene tests/scenes/example.nff --size 640x480
figure 05-spheres 05-far.png --scene tests/scenes/far.nff
figure 05-spheres 05-textbook.png --scene tests/scenes/far.nff --textbook
section 06-kdtree-3d-build
figure 06-kdtree-3d-build 06.png
figure 06-kdtree-3d-build 06-random.png --scene random:n=200,seed=3
figure 06-kdtree-3d-build 06-lattice.png --scene lattice:n=5 --leaf-size 1
section 07-kdtree-3d-trace
figure 07-kdtree-3d-trace 07.png --size 1024x1024 --heat-map
picture 07-kdtree-3d-trace 07-work.png "The same, by work: the brighter, the more nodes, leaves and spheres a ray asks"
figure 07-kdtree-3d-trace 07-large.png --scene random:n=100000 --size 1024x1024 --frames 5
figure 07-kdtree-3d-trace 07-helix.png --scene tests/scenes/helix.pdb --size 1024x640
figure 07-kdtree-3d-trace 07-c60.png --scene tests/scenes/c60.xyz
figure 07-kdtree-3d-trace 07-lattice.png --scene lattice:n=40 --size 640x640
section 08-surface-area-heuristic
figure 08-surface-area-heuristic 08.png --scene stadium --heat-map
picture 08-surface-area-heuristic 08-work.png "The same, by work, with the tree that is built by cost"
picture 08-surface-area-heuristic 08-middle-work.png "With lab 06's tree, to a scale of its own"
section 09-shadows-and-mirrors
figure 09-shadows-and-mirrors 09.png --size 1024x1024
figure 09-shadows-and-mirrors 09-shadows.png --bounces 0
figure 09-shadows-and-mirrors 09-inside.png --scene inside
figure 09-shadows-and-mirrors 09-acne.png --scene one --bounces 0 --acne
section 10-realtime
figure 10-realtime 10.png --size 1024x1024 --frames 5 --heat-map
picture 10-realtime 10-work.png "The same, by work: a square is a tile of 8 x 8 rays that went through the tree as one"
figure 10-realtime 10-large.png --scene random:n=100000 --size 1024x1024 --frames 5
echo "</section></body></html>" >>"$gallery/index.html"

# ---- A small class ----------------------------------------------------------------------------

lab=03-kdtree-2d-render

# A submission: the solution with the answer of one mutant.
wrong() {
    mkdir -p "$class/submissions/$1"
    cp "solutions/$lab/implicit2DRenderer_KD.cl" "$class/submissions/$1"
    "$build/tools/known" put "$lab" "$1" "$class/submissions/$1"
}

mkdir "$class/submissions"
cp -r "solutions/$lab" "$class/submissions/right"
tests/tools/cut_labs.sh "$build/tools/holes" "$class/cut"
mv "$class/cut/$lab" "$class/submissions/skeleton"
rm -r "$class/cut"
wrong one-level
wrong later-of-equals
wrong red-blue-swapped

echo "Grading a class of five:"
setpriv --pdeathsig TERM tests/class/grading/grade_class.sh --build "$build" --lab "$lab" --submissions "$class/submissions" \
    --output "$class/graded" --seed 7

echo
echo "Gallery: $gallery/index.html"
echo "Report:  $class/graded/class.html"

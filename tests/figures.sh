#!/bin/sh
# The pictures of the READMEs and the lecture notes, drawn by the course's own programs.
#
#     tests/figures.sh FOLDER [BUILD-FOLDER]
set -eu

folder=$1
build=${2:-build}
scene="--scene random:n=500,seed=1 --size 640x480"
mkdir -p "$folder"

"$build/solutions/00-hello-pixels" --size 640x480 --output "$folder/00-hello-pixels.png"
for lab in 01-naive-2d 02-kdtree-2d-build 03-kdtree-2d-render; do
    # shellcheck disable=SC2086 # two options and their arguments
    "$build/solutions/$lab" $scene --output "$folder/$lab.png"
done
"$build/solutions/04-camera-rays" --scene planes --size 640x480 --output "$folder/04-camera-rays.png"
"$build/solutions/05-spheres" --scene sphereflake:size=3 --output "$folder/05-spheres.png"
"$build/solutions/05-spheres" --scene tests/scenes/far.nff --textbook --output "$folder/05-textbook.png"
"$build/solutions/06-kdtree-3d-build" --output "$folder/06-kdtree-3d-build.png"
"$build/solutions/07-kdtree-3d-trace" --heat-map --output "$folder/07-kdtree-3d-trace.png"
mv "$folder/07-kdtree-3d-trace-work.png" "$folder/07-work.png"
rm "$folder/07-kdtree-3d-trace-work.exr"
"$build/solutions/08-surface-area-heuristic" --scene stadium --heat-map --output "$folder/08-stadium.png"
mv "$folder/08-stadium-work.png" "$folder/08-work.png"
mv "$folder/08-stadium-middle-work.png" "$folder/08-middle-work.png"
rm "$folder"/08-stadium*-work.exr
"$build/solutions/09-shadows-and-mirrors" --output "$folder/09-shadows-and-mirrors.png"
for acne in "" --acne; do
    # shellcheck disable=SC2086 # one option or none
    "$build/solutions/09-shadows-and-mirrors" --scene one --bounces 0 $acne --output "$folder/09-one$acne.png"
done
"$build/tools/crop" "$folder/09-one--acne.png" "$folder/09-one.png" 126 126 260 260 "$folder/09-acne.png"
rm "$folder/09-one.png" "$folder/09-one--acne.png"
"$build/solutions/10-realtime" --heat-map --output "$folder/10-realtime.png"
mv "$folder/10-realtime-work.png" "$folder/10-work.png"
rm "$folder/10-realtime-work.exr" "$folder/10-realtime.png"
# What explains.
"$build/tools/figures2d" "$folder"
"$build/tools/figures3d" "$folder"

# A window, where a display can be had. How fast it was stands in it, so it differs from run to run.
. tests/display.sh
if display_open; then
    trap display_close EXIT
    printf '%s\n' 'frames 2' 'key M' 'click 262 250' 'frames 2' 'key +' 'frames 1' 'key -' 'frames 30' \
        "save $folder/07-view.png" >"$folder/07-view.script"
    "$build/view/solutions/07-kdtree-3d-trace" --size 640x640 --script "$folder/07-view.script" >/dev/null
    rm "$folder/07-view.script"
fi

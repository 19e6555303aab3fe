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
flake="--scene sphereflake --size 512x512"
for lab in 04-camera-rays 06-kdtree-3d-build 07-kdtree-3d-trace; do
    # shellcheck disable=SC2086
    "$build/solutions/$lab" $flake --output "$folder/$lab.png"
done
"$build/solutions/02-kdtree-2d-build" --scene example --max-depth 4 --leaf-size 1 \
    --output "$folder/02-example.png"

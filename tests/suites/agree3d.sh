#!/bin/sh
# Programs that must draw the same do: labs 08 and 10 what lab 07 draws, and lab 10's circles what lab 03 draws; lab
# 09 what lab 05 draws where nothing is mirrored or in the way; labs 09 and 10 what the oracle draws in double.
#
#     sh tests/suites/agree3d.sh      from the top folder, after `make tests` and `make SANITIZE=1`
set -u
. tests/tap.sh
. tests/programs.sh

# ---- Other trees, and tiles --------------------------------------------------------------------

for scene in $(quick "stadium none" stadium clusters one-cell inside planes none); do
    works run 07 --scene "$scene" --size 96x64 --output "$out/07.exr"
    works run 08 --scene "$scene" --size 96x64 --output "$out/08.exr"
    check "lab 08 draws what lab 07 draws: $scene" compare "$out/08.exr" "$out/07.exr"
done
# In lab 10's picture a colour is a byte, half a step of which may be off; and sides are no multiples of a tile's.
for scene in $(quick sphereflake:size=3 sphereflake:size=3 random:n=2000 inside planes behind one-cell none); do
    works run 07 --scene "$scene" --size 99x67 --output "$out/07.exr"
    works run 10 --scene "$scene" --size 99x67 --output "$out/10.exr"
    check "lab 10 draws what lab 07 draws: $scene" compare "$out/10.exr" "$out/07.exr" 0.0021 3
done
# Circles: centres and radii are on the grid of 1/16 px, so that colours differ by the byte's rounding only.
for scene in $(quick "random none" random random:n=400,min=10,max=60 example equal-depths borders touching huge tiny outside none); do
    works run 03 --scene "$scene" --size 99x67 --output "$out/03.exr"
    works run 10 --circles --scene "$scene" --size 99x67 --output "$out/10.exr"
    check "lab 10 draws what lab 03 draws: $scene" compare "$out/10.exr" "$out/03.exr" 0.00197
    works run 03 --scene "$scene" --size 99x67 --output "$out/03.png"
    works run 10 --circles --scene "$scene" --size 99x67 --output "$out/10.png"
    check "and as PNG the same to the bit: $scene" compare "$out/10.png" "$out/03.png"
done
# Off the grid: the nearer circle covers the tile's last corner by a hair, and in float perhaps not. Either colour is right,
# so both are the same here; black is not.
cat >"$scenes/off-grid.csv" <<'END'
x,y,radius,depth,r,g,b
8,8,100,0.9,0,1,0
7.1620917320251465,5.935239791870117,11.983433723449707,0.1,0,1,0
END
works run 03 --scene "$scenes/off-grid.csv" --size 16x16 --output "$out/03.png"
works run 10 --circles --scene "$scenes/off-grid.csv" --size 16x16 --output "$out/10.png"
check "lab 10 leaves no hole off the grid" compare "$out/10.png" "$out/03.png"
quick_ends

works run 03 --size 99x67 --output "$out/03.exr"
for limits in 1/1 3/2 64/100; do
    works run 10 --circles --size 99x67 --output "$out/10.exr" --max-depth ${limits%/*} \
        --leaf-size ${limits#*/}
    check "lab 10 draws the same circles, --max-depth/--leaf-size $limits" compare "$out/10.exr" \
        "$out/03.exr" 0.00197
done
! $is_sanitized || check "lab 10 draws circles, watched by the sanitizers" \
    works with detect_leaks=0 run_sanitized 10 --circles --heat-map --output "$out/watched.exr" \
    --size 65x33 --stats "$out/watched.json"

# ---- Shadows and mirrors -----------------------------------------------------------------------

# shellcheck disable=SC2317 # called by check
differs_with_acne() {
    works run 09 --scene one --size 96x64 --bounces 0 --acne --output "$out/acne.exr" &&
        differs compare "$out/acne.exr" "$out/05.exr" 0.00002
}
# Where no ray is mirrored and nothing is in the way, lab 09 draws what lab 05 does.
check "lab 05 draws one" draws 05 96x64 "$out/05.exr" --scene one --size 96x64
check "lab 09 draws it, too" draws 09 96x64 "$out/09.exr" --scene one --size 96x64 --bounces 0
check "and the same, within rounding" compare "$out/09.exr" "$out/05.exr" 0.00002
check "with --acne it does not" differs_with_acne
for bounces in 1 5 64; do
    check "lab 09 follows up to $bounces mirrors" draws 09 64x48 "$out/09.exr" --scene inside \
        --size 64x48 --bounces $bounces
done
# mirrors_as_oracle LAB SCENE N_BOUNCES TOLERANCE [OPTION...]: is the picture the oracle's, but where rounding decides?
mirrors_as_oracle() {
    lab=$1 scene=$2 bounces=$3 tolerance=$4
    shift 4
    works run "$lab" --scene "$scene" --size 99x67 --bounces "$bounces" --output "$out/lit.exr" "$@" &&
        "$build/tools/compare_mirrors" "$scene" 99x67 "$bounces" "$out/lit.exr" "$tolerance"
}
# The sides of the picture are no multiples of a tile's. Lab 10 may follow a ray where lab 09 ends (LEAST_WEIGHT): here no
# surface mirrors more than half of the light, so that adds less than a step of a byte.
for scene in sphereflake:size=2 inside planes random:n=60 coincident none; do
    for bounces in 0 1 5; do
        check "lab 09 draws what the oracle draws: $scene, $bounces mirrors" mirrors_as_oracle 09 $scene $bounces 0
        check "lab 10, tile by tile, too: $scene, $bounces mirrors" mirrors_as_oracle 10 $scene $bounces 0.004 --shadows
    done
done

# A ball that hardly mirrors, in a room that mirrors nearly all. On its 7th mirror lab 09 ends, and lab 10 goes on: that adds
# no more than half a step of a byte for each mirror that is left; and each program rounds by half a step.
cat >"$scenes/room.nff" <<'END'
b 0 0 0
v
from 0 -6 0.5
at 0 0 0
up 0 0 1
angle 40
hither 0
resolution 64 48
l 4 -5 6
f 1 1 1 0.1 0.0021 0 0 0
s 0 0 0 1
f 1 1 1 1 0.99 0 0 0
s 5 3 2 15
END
for bounces in 7 20 60; do
    works run 09 --scene "$scenes/room.nff" --bounces $bounces --output "$out/09.png"
    works run 10 --scene "$scenes/room.nff" --bounces $bounces --shadows --output "$out/10.png"
    check "lab 10 adds no more than half a step a mirror, of $bounces" compare "$out/10.png" "$out/09.png" \
        "$(awk "BEGIN { print (0.5 * ($bounces - 7) + 1.01) / 255 }")"
done
# Bytes are rounded as in a PNG: 76.5 and 178.5 to the even one.
sed -e 's/^b .*/b 0.3 0.7 0.1/' -e 's/^from.*/from 0 -6 99/;s/^at.*/at 0 -7 99/;/^s 5/d' "$scenes/room.nff" >"$scenes/sky.nff"
works run 09 --scene "$scenes/sky.nff" --output "$out/09.png"
works run 10 --scene "$scenes/sky.nff" --output "$out/10.png"
check "a background that lies between two bytes is the same one" compare "$out/10.png" "$out/09.png"

# ---- Eyes and lights where float is coarse -----------------------------------------------------

# An eye and a light on a side of the tree's box, which is a float's step wider than the spheres'; a light so far away that
# a float's steps there are wider than a cell of the tree; and one so far that no float holds the square of its distance.
nff() {
    printf 'v\nfrom %s\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 96 96\nl %s\nf 0.8 0.6 0.4 1 0 0 0 0\ns -1.75 -1.5 -1.5 0.25\n' "$1" "$2"
    LC_ALL=C awk 'BEGIN { srand(1); for (i = 0; i < 2000; i++)
        printf "s %.6f %.6f %.6f 0.03\n", 2 * rand() - 1, 2 * rand() - 1, 2 * rand() - 1 }'
}
nff '-2.00000024 0.7 0.3' '-4 3 2' >"$scenes/eye-on-side.nff"
nff '3 2 1.5' '-2.00000024 0.7 0.3' >"$scenes/light-on-side.nff"
nff '3 2 1.5' '9333900 3111300 3215010' >"$scenes/far-light.nff"
nff '3 2 1.5' '3e19 1e19 1e19' >"$scenes/farthest-light.nff"
for scene in eye-on-side light-on-side far-light farthest-light; do
    works run 07 --scene "$scenes/$scene.nff" --size 192x192 --output "$out/07.png"
    works run 10 --scene "$scenes/$scene.nff" --size 192x192 --output "$out/10.png"
    check "lab 10 draws what lab 07 draws: $scene" compare "$out/10.png" "$out/07.png" 0.004 3
    works run 09 --scene "$scenes/$scene.nff" --size 192x192 --bounces 0 --output "$out/09.png"
    works run 10 --scene "$scenes/$scene.nff" --size 192x192 --bounces 0 --shadows --output "$out/lit.png"
    check "and with shadows what lab 09 draws: $scene" compare "$out/lit.png" "$out/09.png" 0.004 3
done

# The largest numbers that a file may hold: what is drawn of these spheres is drawn of all of them 2^59 times as large. They
# and the eye are at the corners.
printf '%s\n' v 'from 1 1 1' 'at -1 -1 -1' 'up 0 1 0' 'angle 90' 'hither 0' 'resolution 48 48' 'l 3 4 5' 'l -1 1 1' 'f 1 0 0 1 0.5 0 0 0' \
    's -1 -1 -1 1' 's 1 -1 -1 1' 'f 0 1 0 1 0.5 0 0 0' 's -1 1 -1 0.5' 's -1 -1 1 -1' 's 0 0.25 0.125 0.25' >"$scenes/corners.nff"
LC_ALL=C awk '/^(from|at|l|s) / { for (i = 2; i <= NF; i++) $i = sprintf("%.17g", $i * 2 ^ 59) } { print }' "$scenes/corners.nff" >"$scenes/vast.nff"
for lab in 05 07 08 09 10; do
    works run $lab --scene "$scenes/corners.nff" --output "$out/corners.exr"
    works run $lab --scene "$scenes/vast.nff" --output "$out/vast.exr"
    check "lab $lab draws the largest spheres as it draws small ones" compare "$out/vast.exr" "$out/corners.exr"
done

finish

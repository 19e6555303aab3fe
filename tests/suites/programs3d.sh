#!/bin/sh
# The solution programs of the labs in 3D as a user runs them: good runs and their outputs. What they
# refuse stands in refusals3d.sh.
#
#     sh tests/suites/programs3d.sh      from the top folder, after `make tests` and `make SANITIZE=1`
set -u
. tests/tap.sh
. tests/programs.sh
labs=$(quick '07-kdtree-3d-trace 10-realtime' 04-camera-rays 05-spheres 06-kdtree-3d-build 07-kdtree-3d-trace \
    08-surface-area-heuristic 09-shadows-and-mirrors 10-realtime)

# ---- Good runs ----------------------------------------------------------------------------------

for lab in $labs; do
    number=${lab%%-*}
    check "$lab draws the scene's own size" draws "$number" 512x512 "$out/$number.png" \
        --scene sphereflake:size=1
    check "$lab draws 317x211 as EXR" draws "$number" 317x211 "$out/$number.exr" --size 317x211 \
        --scene random:n=40
    check "$lab draws a single pixel" draws "$number" 1x1 "$out/one.exr" --size=1x1 --scene one
    check "$lab has a help" works run "$number" --help
    check "the help of $lab names its scenes" grep -q '^Scenes: FILE.nff, .*sphereflake.*coincident' \
        "$scratch/stdout"
    [ "$number" != 10 ] || check "and apart from them its scenes of circles" \
        grep -q '^Scenes with --circles: FILE.csv, ' "$scratch/stdout"
    ! $is_sanitized || check "$lab draws, watched by the sanitizers" \
        works with detect_leaks=0 run_sanitized "$number" --heat-map \
        --output "$out/watched.exr" --size 65x33 --stats "$out/watched.json" --scene random:n=40
done
! $is_sanitized || check "lab 06 leaks nothing" \
    works run_sanitized 06 --output "$out/one.exr" --scene random:n=500

quick_ends

for scene in tests/scenes/*.nff tests/scenes/*.pdb tests/scenes/*.xyz; do
    check "lab 07 draws ${scene##*/}" works run 07 --scene "$scene" --output "$out/07.png"
    ! $is_sanitized || check "lab 06 reads ${scene##*/} and leaks nothing" \
        works run_sanitized 06 --scene "$scene" --output "$out/06.png"
done
check "what is not drawn is counted in one warning" \
    test "$(run 07 --scene tests/scenes/example.nff --output "$out/07.png"; grep -c skipped \
        "$scratch/stderr")" -eq 1

# ---- Haines' own programs -----------------------------------------------------------------------

# Scenes in the manner of his "lattice", "rings", "tree", "jacks" and "sample": cones on one line, and
# polygons and patches whose numbers stand where they like.
manner() {
    cat <<'END'
b 0.08 0.36 0.75
v
from 4 -6 3
at 0.5 0.5 0.5
up 0 0 1
angle 30
hither 0.001
resolution 96 64
l 5 -8 6
f 0.9 0.6 0.2 0.8 0.2 30 0 0
END
    awk -v manner="$1" '
        function cone(x, y, z, r) { print "c " x, y, z, r, x, y, z + 0.5, r / 2 }
        function ball(x, y, z, r) { print "s " x, y, z, r }
        BEGIN {
            if (manner == "lattice")
                for (i = 0; i < 8; i++) { cone(i % 2, int(i / 2) % 2, int(i / 4), 0.05); ball(i % 2, int(i / 2) % 2, int(i / 4), 0.2) }
            if (manner == "rings")
                for (i = 0; i < 12; i++) { ball(cos(i / 2), sin(i / 2), 0, 0.1); print "c"; print cos(i / 2), sin(i / 2), 0, 0.05; print cos(i / 2), sin(i / 2), 1, 0.05 }
            if (manner == "tree") {
                print "p 4\n -9 -9 0\n 9 -9 0\n 9 9 0\n -9 9 0"
                for (i = 0; i < 5; i++) { cone(0, 0, i / 4, 0.2); ball(i / 8, 0, i / 4, 0.15) }
            }
            if (manner == "jacks")
                for (i = 0; i < 3; i++) { print "c " i, 0, 0, "0.1"; print i, 0, 1, "0.1"; ball(i, 0, 0, 0.2); ball(i, 0, 1, 0.2) }
            if (manner == "sample") {
                print "pp 3 0 0 0 0 0 1 1 0 0 0 0 1\n0 1 0 0 0 1"
                print "p\n3\n0 0 0 1 0 0\n0 1\n0"
                print "c 0 0 0 1 0 0 1 0 s 0.5 0.5 0.5 0.4"
            }
        }'
}
for manner in lattice rings tree jacks sample; do
    manner $manner >"$scenes/$manner.nff"
    tr -s ' \n' '\n' <"$scenes/$manner.nff" |
        awk '/^[a-z]+$/ { drawn = !/^(c|p|pp)$/; if (drawn) print "" } drawn { printf "%s ", $0 }
            END { print "" }' >"$scenes/spheres.nff"
    check "lab 05 draws a scene in the manner of $manner" \
        draws 05 96x64 "$out/05.exr" --scene "$scenes/$manner.nff"
    check "with one warning" grep -q "$manner.nff: warning: skipped what is no sphere: [0-9]* c " \
        "$scratch/stderr"
    check "and no other word" test "$(wc -l <"$scratch/stderr")" -eq 1
    check "what it skipped changes nothing" draws 05 96x64 "$out/spheres.exr" \
        --scene "$scenes/spheres.nff"
    check "to the bit" compare "$out/05.exr" "$out/spheres.exr"
done

# ---- The tree shows what every sphere shows -----------------------------------------------------

# equals_lab_05 OPTION...: does lab 07 draw with these what lab 05 drew into 05.exr?
# shellcheck disable=SC2317 # called by check
equals_lab_05() {
    rm -f "$out/07.exr"
    works run 07 --output "$out/07.exr" "$@" && compare "$out/07.exr" "$out/05.exr"
}

works run 05 --scene none --size 96x64 --output "$out/none.exr"
for scene in sphereflake:size=2 random:n=300 lattice:n=4 inside planes one-cell one none coincident \
    large-small behind tests/scenes/caffeine.xyz; do
    check "lab 05 draws $scene" draws 05 96x64 "$out/05.exr" --scene $scene --size 96x64
    case $scene in none) ;; *) check "$scene shows something" differs \
        compare "$out/05.exr" "$out/none.exr" ;; esac
    for limits in 1/1 6/1 12/8; do
        check "lab 07 draws the same, --max-depth/--leaf-size $limits" equals_lab_05 \
            --scene $scene --size 96x64 --max-depth ${limits%/*} --leaf-size ${limits#*/}
    done
done

# Of two spheres at the same distance the lower id wins, in whichever leaf it is met first: pairs
# that mirror each other in the plane x = 0, which the eye is in, and a pair that touches a plane.
cat >"$scenes/view" <<'END'
v
from 0 -6 0.5
at 0 0 0
up 0 0 1
angle 45
hither 0.1
resolution 129 129
l 5 -10 10
END
# A generator of Park and Miller, so that the scene is the same everywhere.
awk 'function random() { seed = seed * 16807 % 2147483647; return seed / 2147483647 }
    BEGIN { seed = 6; for (i = 0; i < 40; i++) {
        x = random() / 2; y = 4 * random() - 2; z = 4 * random() - 2; r = x + (1 - x) * random()
        if (random() < 0.5) x = -x
        print "f", i % 2, i % 3 / 2, i % 5 / 4, "0.8 0 0 0 1"; print "s", x, y, z, r
        print "f", i % 3 / 2, i % 5 / 4, i % 2, "0.8 0 0 0 1"; print "s", -x, y, z, r } }' |
    cat "$scenes/view" - >"$scenes/mirror.nff"
sed -e 's/^from.*/from 0 -1000 0/' -e 's/^angle.*/angle 0.05/' "$scenes/view" >"$scenes/border.nff"
cat >>"$scenes/border.nff" <<'END'
f 1 0 0 0.8 0 0 0 1
s 0 1 0 0.99999994
f 0 1 0 0.8 0 0 0 1
s 0 1 0 1
s 0.5 -1.5 0.5 0.5
END
for scene in mirror border; do
    check "lab 05 draws $scene" draws 05 129x129 "$out/05.exr" --scene "$scenes/$scene.nff"
    for limits in 2/1 12/1 12/6; do
        check "lab 07 draws the same, --max-depth/--leaf-size $limits" equals_lab_05 \
            --scene "$scenes/$scene.nff" --max-depth ${limits%/*} --leaf-size ${limits#*/}
    done
done

# Scenes that no split takes apart, with the limits that the programs choose: as in lab 05, and
# each sphere in no more than some leaves.
# spheres N RADIUS: N spheres at one place, RADIUS an expression of i.
spheres() {
    cat "$scenes/view"
    echo 'f 1 0.8 0.4 0.8 0 0 0 1'
    awk "BEGIN { for (i = 0; i < $1; i++) print \"s\", 0.1, 0.2, 0.3, $2 }"
}
spheres 5000 1 >"$scenes/equal.nff"
spheres 5000 '0.2 + i / 5000' >"$scenes/concentric.nff"
for scene in equal concentric; do
    check "lab 05 draws $scene" draws 05 32x32 "$out/05.exr" --scene "$scenes/$scene.nff" --size 32x32
    check "lab 07 draws the same" equals_lab_05 --scene "$scenes/$scene.nff" --size 32x32 \
        --stats "$out/figures.json"
    check "with few ids" test "$(figure tree.n_sphere_ids)" -lt 1000000
done
spheres 100000 1 >"$scenes/many.nff"
check "lab 06 builds a tree over 100 000 equal spheres" works run 06 --scene "$scenes/many.nff" \
    --size 16x16 --output "$out/06.png" --stats "$out/figures.json"
check "with few ids" test "$(figure tree.n_sphere_ids)" -lt 2000000
# A spiral of spheres that overlap ever more the more there are, after Pickover's shells.
{
    sed -e 's/^from.*/from -6 -60 35/' -e 's/^at.*/at 0 8 -15/' "$scenes/view"
    echo 'f 1 0.8 0.4 0.8 0 0 0 1'
    awk 'BEGIN { n = 46080; for (i = -n * 2 / 3; i <= n / 3; i++) {
        angle = 18 * 3.14159265358979 * i / n; r = exp(0.15 * angle)
        print "s", r * sin(angle), r * cos(angle), -2 * r, r } }'
} >"$scenes/shells.nff"
check "lab 07 draws 46 081 spheres along a spiral" works run 07 --scene "$scenes/shells.nff" \
    --size 32x32 --output "$out/07.exr" --stats "$out/figures.json"
check "with far fewer ids than are allowed" test "$(figure tree.n_sphere_ids)" -lt 40000000

# ---- The published counts -----------------------------------------------------------------------

# Haines' database "balls", size 4, has 513² eye rays, which all hit: a sphere or the floor.
works run 07 --scene sphereflake --size 513x513 --output "$out/balls.exr" >/dev/null
"$build/tools/count_hits" sphereflake 513x513 "$out/balls.exr" >"$scratch/counts" 2>&1
ok $? "the sphereflake's rays hit what the oracle says" "$(cat "$scratch/counts")"
check "of its 513² rays all hit when the floor is there" grep -x 'with the floor 263169' "$scratch/counts"
check "without the floor not" grep -q -v -x 'by the oracle 263169' "$scratch/counts"

# He also published how many rays his program followed. Ours finds its directions in double, his we do not know:
# a hundredth may differ. One mirror more or less would be a tenth.
"$build/tools/count_rays" >"$scratch/rays"
ok $? "the rays of balls and floor can be counted"
awk 'function off(found, expected) { return found > expected ? found / expected - 1 : 1 - found / expected }
    $3 != "of" || off($2, $4) > 0.01 { exit 1 }
    END { if (NR != 3) exit 1 }' "$scratch/rays"
ok $? "and are as many as Haines', within a hundredth" "$(cat "$scratch/rays")"
check "those from the eye exactly" grep -x 'eye 263169 of 263169' "$scratch/rays"

# ---- The textbook's quadratic -------------------------------------------------------------------

# Seen from afar the spheres are small against their distance.
cat >"$scenes/far.nff" <<'END'
b 0 0 0
v
from 3000 0 0
at 0 0 0
up 0 0 1
angle 0.05
hither 1
resolution 128 128
l 3000 1000 1000
f 1 0.5 0.2 1 0 0 0 1
END
LC_ALL=C awk 'BEGIN { for (i = 0; i < 20; i++) for (j = 0; j < 20; j++)
    print "s", 0, (i - 9.5) / 9, (j - 9.5) / 9, 0.04 }' >>"$scenes/far.nff"
check "lab 05 draws a scene from afar" draws 05 128x128 "$out/far.exr" --scene "$scenes/far.nff"
check "by the textbook's quadratic as well" draws 05 128x128 "$out/textbook.exr" \
    --scene "$scenes/far.nff" --textbook
check "which looks otherwise" differs compare "$out/textbook.exr" "$out/far.exr"
check "and is right where spheres are near" draws 05 96x64 "$out/near.exr" --scene one --size 96x64
works run 05 --scene one --size 96x64 --textbook --output "$out/textbook.exr"
check "up to rounding" compare "$out/textbook.exr" "$out/near.exr" 0.001

# At 100 000 float's steps are 1/128: a small sphere reaches out of its rounded box.
cat >"$scenes/small-far.nff" <<'END'
b 0 0.5 1
v
from 100000 0 0.05
at 100000 0 0
up 0 1 0
angle 45
hither 0
resolution 256 256
l 100000 1 5
f 1 1 1 1 0 0 0 1
s 100000 0 0 0.01
END
check "lab 05 draws a small sphere far from the origin" draws 05 256x256 "$out/05.exr" \
    --scene "$scenes/small-far.nff"
check "lab 07 draws all of it" equals_lab_05 --scene "$scenes/small-far.nff"

# ---- Figures and heat maps ----------------------------------------------------------------------

frame='frame.min_ms frame.median_ms frame.max_ms'
work='sphere_tests.mean_per_pixel sphere_tests.max_per_pixel nodes_visited.mean_per_pixel
    nodes_visited.max_per_pixel leaves_visited.mean_per_pixel leaves_visited.max_per_pixel
    stack_depth.mean_per_pixel stack_depth.max_per_pixel'
scene_names='lab device scene n_spheres width height'
for lab in $labs; do
    case $lab in
    04*) names="lab device scene width height fov $frame" ;;
    05*) names="$scene_names $frame $work" ;;
    06*) names="lab scene n_spheres width height max_depth leaf_size tree.build.min_ms
        tree.build.median_ms tree.build.max_ms tree.n_nodes tree.n_leaves tree.n_empty_leaves tree.depth
        tree.n_sphere_ids tree.largest_leaf tree.spheres_per_leaf" ;;
    07*) names="$scene_names max_depth leaf_size tree.build_ms tree.n_nodes tree.n_sphere_ids $frame $work" ;;
    08*)
        names=$scene_names
        for tree in middle by_cost; do
            for name in cost build_ms n_nodes depth largest_leaf n_sphere_ids; do
                names="$names $tree.$name"
            done
        done
        names="$names $frame $work"
        for name in $work; do
            names="$names middle.$name"
        done
        ;;
    09*) names="$scene_names tree.cost tree.build_ms tree.n_nodes tree.depth tree.largest_leaf
        tree.n_sphere_ids max_bounces $frame $work" ;;
    10*) names="$scene_names tree.cost tree.build_ms tree.n_nodes tree.depth tree.largest_leaf tree.n_sphere_ids
        tile.width tile.height tile.lanes $frame $work" ;;
    esac
    rm -f "$out/figures.json"
    works run "${lab%%-*}" --scene random:n=500 --size 64x48 --output "$out/tiny.exr" \
        --stats "$out/figures.json"
    check "the figures of $lab are JSON" is_json
    # shellcheck disable=SC2086 # names are words
    check "the figures of $lab are these" has_figures $names
    case $lab in
    05*)
        check "every ray of lab 05 asks every sphere" test \
            "$(figure sphere_tests.mean_per_pixel) $(figure sphere_tests.max_per_pixel)" = "500.0 500"
        ;;
    07*)
        check "a ray of lab 07 asks fewer" test "$(figure sphere_tests.max_per_pixel)" -lt 500
        check "a ray of lab 07 visits nodes and leaves" test "$(figure nodes_visited.max_per_pixel)" \
            -ge "$(figure leaves_visited.max_per_pixel)"
        check "and lets some wait" test "$(figure stack_depth.max_per_pixel)" -ge 1
        ;;
    esac
done
works run 08 --scene one-cell --size 64x48 --output "$out/08.exr" --stats "$out/figures.json"
check "by cost one cell costs less than by its middle" test \
    "$(figure sphere_tests.max_per_pixel)" -lt "$(figure middle.sphere_tests.max_per_pixel)"
check "no heat map without --heat-map" test ! -e "$out/tiny-work.png"
for lab in 01 03 05 07 09 10; do
    scene=random:n=50
    check "lab $lab saves a heat map" works run $lab --scene $scene --size 64x48 --heat-map \
        --output "$out/heat.png"
    check "lab $lab: of the picture's size" has_size "$out/heat-work.png" 64x48
    check "lab $lab: and as EXR" has_size "$out/heat-work.exr" 64x48
    rm -f "$out"/heat*
done
check "lab 08 saves a heat map of either tree" works run 08 --scene random:n=50 --size 64x48 --heat-map \
    --output "$out/heat.png"
for heat in work middle-work; do
    check "lab 08: $heat of the picture's size" has_size "$out/heat-$heat.png" 64x48
    check "lab 08: $heat as EXR" has_size "$out/heat-$heat.exr" 64x48
done
rm -f "$out"/heat*
# Kernels that show in the picture that they count: it is drawn by those that do not.
mkdir "$scratch/shown"
cp -R labs solutions kernels "$scratch/shown"
for kernel in 01-naive-2d/implicit2DRenderer 03-kdtree-2d-render/implicit2DRenderer_KD \
    05-spheres/render_spheres 07-kdtree-3d-trace/render_kdtree 09-shadows-and-mirrors/render_mirrors; do
    lab=${kernel%%-*}
    file=$scratch/shown/solutions/$kernel.cl
    works run "$lab" --scene random:n=50 --size 64x48 --output "$out/drawn.exr"
    sed -i 's/write_imagef(image, (int2)(x, y), /&SHOWN + /' "$file"
    printf '#ifdef COUNT_WORK\n#define SHOWN 1.0f\n#else\n#define SHOWN 0.0f\n#endif\n' | cat - "$file" >"$file.new"
    mv "$file.new" "$file"
    # shellcheck disable=SC2317 # called by check
    draws_uncounted() (
        cd "$scratch/shown" && works run "$lab" --scene random:n=50 --size 64x48 --heat-map \
            --stats "$out/figures.json" --output "$out/counted.exr" &&
            grep -q nodes_visited "$out/figures.json" && compare "$out/counted.exr" "$out/drawn.exr"
    )
    check "lab $lab: the picture is not the counting kernel's" draws_uncounted
done
check "lab 10 says how many mirrors" works run 10 --shadows --bounces 2 --scene one --size 64x48 \
    --output "$out/lit.exr" --stats "$out/figures.json"
# shellcheck disable=SC2086 # names are words
check "and counts the work of its rays" has_figures $scene_names tree.cost tree.build_ms tree.n_nodes tree.depth \
    tree.largest_leaf tree.n_sphere_ids tile.width tile.height tile.lanes max_bounces $frame $work
works run 05 --scene one --size 96x64 --output "$out/05.exr"
check "the heat map leaves the picture as it is" equals_lab_05 --scene one --size 96x64 --heat-map

finish

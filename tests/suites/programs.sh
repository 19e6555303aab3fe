#!/bin/sh
# The solution programs of the labs in 2D as a user runs them: good runs and their outputs. What they
# refuse stands in refusals.sh.
#
#     sh tests/suites/programs.sh      from the top folder, after `make tests` and `make SANITIZE=1`
set -u
. tests/tap.sh
. tests/programs.sh
labs=$(quick '02-kdtree-2d-build 03-kdtree-2d-render' 00-hello-pixels 01-naive-2d 02-kdtree-2d-build 03-kdtree-2d-render)

# ---- Good runs ----------------------------------------------------------------------------------

for lab in $labs; do
    number=${lab%%-*}
    default=1024x1024 middle=317x211 smallest=1x1
    scene='--scene=random:n=40'
    case $number in
    00) default=640x480 scene= ;;
    02) middle=634x422 smallest=640x640 ;; # a drawing of the tree, magnified
    esac
    # shellcheck disable=SC2086 # no scene, no word
    check "$lab draws the default size" draws "$number" "$default" "$out/$number.png" $scene
    # shellcheck disable=SC2086
    check "$lab draws 317x211 as EXR" \
        draws "$number" "$middle" "$out/$number.exr" --size 317x211 $scene
    # shellcheck disable=SC2086
    check "$lab draws a single pixel" draws "$number" "$smallest" "$out/one.exr" --size=1x1 $scene
    check "$lab has a help" works run "$number" --help
    check "the help of $lab names it and its options" \
        grep -q -- "^ *--size WxH  *the picture's size" "$scratch/stdout"
    check "$lab lists the devices" works run "$number" --list-devices
    check "the list of $lab starts with device 0" grep -q '^0  .*: ..*' "$scratch/stdout"
    # shellcheck disable=SC2086
    ! $is_sanitized || check "$lab draws, watched by the sanitizers" \
        works with detect_leaks=0 run_sanitized "$number" \
        --output "$out/watched.exr" --size 65x33 --stats "$out/watched.json" $scene
done
if $is_sanitized; then
    check "lab 02 leaks nothing" \
        works run_sanitized 02 --output "$out/one.exr" --scene random:n=500
else
    skip "programs with sanitizers" "make SANITIZE=1 all was not run"
fi

works run 00 --size 317x211 --output "$out/00.png" >/dev/null
works run 00 --size 317x211 --output "$out/00.exr" >/dev/null
check "a PNG shows what the EXR holds" compare "$out/00.png" "$out/00.exr" 0.002

# From another folder with the kernels in it: where the picture goes when nobody says.
mkdir "$scratch/elsewhere"
cp -R solutions kernels "$scratch/elsewhere"
# shellcheck disable=SC2317 # called by check
draws_by_default() { (cd "$scratch/elsewhere" && works run 00) && has_size "$1" 640x480; }
check "the picture goes to build/NN-name.png" \
    draws_by_default "$scratch/elsewhere/build/00-hello-pixels.png"

# A program that was carried off without build/libimage_codec.so.
# shellcheck disable=SC2317 # called by check
fails_without_codec() {
    status=0
    "$scratch/elsewhere/00" --size 8x8 --output "$out/carried.exr" >"$scratch/stdout" 2>"$scratch/stderr" ||
        status=$?
    cat "$scratch/stderr"
    [ $status -eq 1 ] && [ "$(wc -l <"$scratch/stderr")" -eq 1 ] &&
        grep -q "carried.exr: OpenImageIO cannot be loaded: .*; run make" "$scratch/stderr" &&
        [ ! -e "$out/carried.exr" ]
}
cp "$build/solutions/00-hello-pixels" "$scratch/elsewhere/00"
check "a picture without the library for pictures" fails_without_codec
check "what needs no picture needs no library for it" works "$scratch/elsewhere/00" --help

quick_ends

# ---- Devices ------------------------------------------------------------------------------------

works run 00 --list-devices >/dev/null
part=$(sed -n '1s/^0  \(.\{9\}\).*/\1/p' "$scratch/stdout" | tr '[:lower:]' '[:upper:]')
tiny="--size 8x8 --output $out/tiny.exr"
# shellcheck disable=SC2086
{
    check "a device by number" works run 00 --device 0 $tiny
    check "a device by a part of its name, $part" works run 00 --device "$part" $tiny
    check "a device from COURSE_DEVICE" works with COURSE_DEVICE="$part" run 00 $tiny
    check "--device before COURSE_DEVICE" \
        works with COURSE_DEVICE=none-such run 00 --device 0 $tiny
    check "lab 02 needs no OpenCL" \
        works with OCL_ICD_VENDORS=/nonexistent run 02 --scene example $tiny
}

# ---- Options of other labs ----------------------------------------------------------------------

# notes EXPECTED LAB OPTION...: does it work, with these lines on stderr?
notes() {
    expected=$1
    shift
    # shellcheck disable=SC2086
    works run "$@" $tiny || return 1
    [ "$(cat "$scratch/stderr")" = "$expected" ] || { cat "$scratch/stderr"; return 1; }
}

check "lab 00 takes the options of all labs" notes \
    "00-hello-pixels: --scene is not used in this lab
00-hello-pixels: --max-depth is not used in this lab
00-hello-pixels: --leaf-size is not used in this lab" 00 --leaf-size 3 --scene example --max-depth=2
check "lab 01 takes --max-depth" notes \
    "01-naive-2d: --max-depth is not used in this lab" 01 --max-depth 2 --scene example
check "lab 02 takes --device" notes \
    "02-kdtree-2d-build: --device is not used in this lab" 02 --device 0 --scene example
check "lab 03 uses every option" notes "" 03 --device 0 --scene example --max-depth 2 --leaf-size 3

# ---- The tree shows what every circle shows -----------------------------------------------------

# equals_lab_01 OPTION...: does lab 03 draw with these what lab 01 drew into 01.exr?
# shellcheck disable=SC2317 # called by check
equals_lab_01() {
    rm -f "$out/03.exr"
    works run 03 --output "$out/03.exr" "$@" && compare "$out/03.exr" "$out/01.exr"
}

works run 01 --scene none --size 317x211 --output "$out/none.exr"
for scene in random:n=500 example equal-depths borders touching huge tiny outside none; do
    size=317x211
    [ $scene != example ] || size=10x10
    check "lab 01 draws $scene" draws 01 $size "$out/01.exr" --scene $scene --size $size
    case $scene in none | example) ;; *) check "$scene is not black" differs \
        compare "$out/01.exr" "$out/none.exr" ;; esac
    for limits in 1/1 4/1 12/12 16/1; do
        check "lab 03 draws the same, --max-depth/--leaf-size $limits" equals_lab_01 \
            --scene $scene --size $size --max-depth ${limits%/*} --leaf-size ${limits#*/}
    done
done

# ---- The worked example -------------------------------------------------------------------------

# prints_worked_example: the cells that hold pixel (7, 7), down to node 13 with circles C and E.
# shellcheck disable=SC2317 # called by check
prints_worked_example() {
    sed -n '/^The cells that hold pixel (7, 7)/,/^[^ ]/s/^  node *//p' "$scratch/stdout" |
        tr -s ' ' >"$scratch/cells"
    diff "$scratch/cells" - <<'END'
0 x [0, 10] y [0, 10] children 1 and 2
2 x [5, 10] y [0, 10] children 5 and 6
6 x [5, 10] y [5, 10] children 13 and 14
13 x [5, 7.5] y [5, 10] leaf, 2 circles: 2 4
END
}

works run 02 --scene example --max-depth 4 --leaf-size 1 --output "$out/example.png"
check "lab 02 prints the worked example" prints_worked_example
check "and the tree of fifteen nodes" \
    test "$(sed -n '/^The tree:/,$p' "$scratch/stdout" | grep -c '^  node')" -eq 15
check "lab 02 writes a PNG" has_size "$out/example.png" 640x640
check "and an SVG with eight cells" test "$(grep -c '<text' "$out/example.svg")" -eq 8
if command -v xmllint >/dev/null; then
    check "the SVG is XML" xmllint --noout "$out/example.svg"
else
    skip "the SVG is XML" "no xmllint"
fi

# ---- Figures ------------------------------------------------------------------------------------

frame='frame.min_ms frame.median_ms frame.max_ms'
work='circle_tests.mean_per_pixel circle_tests.max_per_pixel nodes_visited.mean_per_pixel
    nodes_visited.max_per_pixel'
scene='lab device scene n_circles width height'
for lab in $labs; do
    case $lab in
    00*) names="lab device width height $frame" ;;
    01*) names="$scene $frame $work" ;;
    02*) names="lab scene n_circles width height max_depth leaf_size tree.build.min_ms tree.build.median_ms
        tree.build.max_ms tree.n_nodes tree.n_leaves tree.depth tree.n_map tree.largest_leaf
        tree.circles_per_leaf" ;;
    03*) names="$scene tree.build_ms tree.n_nodes tree.n_map $frame $work" ;;
    esac
    rm -f "$out/figures.json"
    works run "${lab%%-*}" --scene random:n=500 --size 64x48 --output "$out/tiny.exr" \
        --stats "$out/figures.json"
    check "the figures of $lab are JSON" is_json
    # shellcheck disable=SC2086 # names are words
    check "the figures of $lab are these" has_figures $names
    case $lab in 01*)
        check "every pixel of lab 01 asks every circle" test \
            "$(figure circle_tests.mean_per_pixel) $(figure circle_tests.max_per_pixel)" = "500.0 500"
        ;;
    03*)
        check "a pixel of lab 03 asks fewer" test "$(figure circle_tests.max_per_pixel)" -lt 500
        check "a pixel of lab 03 visits nodes" test "$(figure nodes_visited.max_per_pixel)" -ge 1
        ;;
    esac
done

for n_frames in 1 3; do
    works run 01 --scene random:n=500 --size 317x211 --frames $n_frames --output "$out/$n_frames.exr" \
        --stats "$out/figures.json"
    check "--frames $n_frames are measured one by one" test $n_frames -eq "$(for name in $frame; do
        figure "$name"
    done | sort -u | wc -l)"
done
check "--frames does not change the picture" compare "$out/3.exr" "$out/1.exr"

# ---- Scene files --------------------------------------------------------------------------------

header=x,y,radius,depth,r,g,b
circle=30,20,9.5,0.25,1,0.5,0
printf '%s\n%s\n' $header $circle >"$scenes/plain.csv"
printf '# a comment\r\n\r\n%s,a\r\n"30",20,9.5,0.25,1,0.5,0,1' $header >"$scenes/other.csv"
printf 'r,g,b,depth,radius,y,x\n1,.5,0,2.5e-1,9.5,20,30\n' >"$scenes/order.csv"
printf '%s\n' $header >"$scenes/header.csv"
for name in plain other order header; do
    check "a scene file, $name" draws 01 64x48 "$out/$name.exr" --size 64x48 --scene "$scenes/$name.csv"
done
run 01 --scene none --size 64x48 --output "$out/none.exr"
check "line ends, quotes, comments and alpha change nothing" compare "$out/other.exr" "$out/plain.exr"
check "the order of columns changes nothing" compare "$out/order.exr" "$out/plain.exr"
check "a header alone is an empty scene" compare "$out/header.exr" "$out/none.exr"
awk -v header=$header -v circle=$circle 'BEGIN { print header; while (n++ < 20000) print circle }' \
    >"$scenes/same.csv"
check "20 000 circles that no split parts" draws 01 64x48 "$out/same-naive.exr" --size 64x48 \
    --scene "$scenes/same.csv"
check "in a tree" draws 03 64x48 "$out/same.exr" --size 64x48 --scene "$scenes/same.csv"
check "look the same" compare "$out/same.exr" "$out/same-naive.exr"
check "their tree can be drawn" works run 02 --size 64x48 --output "$out/same.exr" \
    --scene "$scenes/same.csv" --stats "$out/figures.json"
check "and lists each a few times" test "$(figure tree.n_map)" -lt 400000
check "a circle is something" differs compare "$out/plain.exr" "$out/none.exr"

# ---- What nobody wrote is black -----------------------------------------------------------------

# New memory full of 5a, and tasks that are not answered yet. Lab 00's host code is the solution's
# here: its empty read_back would hide the picture.
mkdir "$scratch/unfinished"
cp -R labs solutions kernels "$scratch/unfinished"
cp labs/00-hello-pixels/gradient.cl "$scratch/unfinished/solutions/00-hello-pixels"
# shellcheck disable=SC2317 # called by check
draws_black() {
    (cd "$scratch/unfinished" && export MALLOC_PERTURB_=90 &&
        "$build/$1" --size 317x211 --output "$out/black.exr") >"$scratch/stdout" 2>&1 &&
        compare "$out/black.exr" "$out/none.exr"
}
works run 01 --scene none --size 317x211 --output "$out/none.exr"
for program in solutions/00-hello-pixels labs/00-hello-pixels labs/01-naive-2d labs/03-kdtree-2d-render; do
    check "$program: unanswered, it draws black" draws_black $program
done

finish

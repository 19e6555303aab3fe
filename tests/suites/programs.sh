#!/bin/sh
# The solution programs as a user runs them: good runs and their outputs, then bad input, each with one
# message and nothing left behind.
#
#     sh tests/suites/programs.sh      from the top folder, after `make tests` and `make SANITIZE=1`
set -u
. tests/tap.sh
. tests/programs.sh
labs='00-hello-pixels 01-naive-2d 02-kdtree-2d-build 03-kdtree-2d-render'

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
check "a PNG shows what the EXR holds" "$compare" "$out/00.png" "$out/00.exr" 0.002

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
    works run 03 --output "$out/03.exr" "$@" && "$compare" "$out/03.exr" "$out/01.exr"
}

works run 01 --scene none --size 317x211 --output "$out/none.exr"
for scene in random:n=500 example equal-depths borders touching huge tiny outside none; do
    size=317x211
    [ $scene != example ] || size=10x10
    check "lab 01 draws $scene" draws 01 $size "$out/01.exr" --scene $scene --size $size
    case $scene in none | example) ;; *) check "$scene is not black" differs \
        "$compare" "$out/01.exr" "$out/none.exr" ;; esac
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
check "--frames does not change the picture" "$compare" "$out/3.exr" "$out/1.exr"

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
check "line ends, quotes, comments and alpha change nothing" "$compare" "$out/other.exr" "$out/plain.exr"
check "the order of columns changes nothing" "$compare" "$out/order.exr" "$out/plain.exr"
check "a header alone is an empty scene" "$compare" "$out/header.exr" "$out/none.exr"
awk -v header=$header -v circle=$circle 'BEGIN { print header; while (n++ < 20000) print circle }' \
    >"$scenes/same.csv"
check "20 000 circles that no split parts" draws 01 64x48 "$out/same-naive.exr" --size 64x48 \
    --scene "$scenes/same.csv"
check "in a tree" draws 03 64x48 "$out/same.exr" --size 64x48 --scene "$scenes/same.csv"
check "look the same" "$compare" "$out/same.exr" "$out/same-naive.exr"
check "their tree can be drawn" works run 02 --size 64x48 --output "$out/same.exr" \
    --scene "$scenes/same.csv" --stats "$out/figures.json"
check "and lists each a few times" test "$(figure tree.n_map)" -lt 400000
check "a circle is something" differs "$compare" "$out/plain.exr" "$out/none.exr"

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
        "$compare" "$out/black.exr" "$out/none.exr"
}
works run 01 --scene none --size 317x211 --output "$out/none.exr"
for program in solutions/00-hello-pixels labs/00-hello-pixels labs/01-naive-2d labs/03-kdtree-2d-render; do
    check "$program: unanswered, it draws black" draws_black $program
done

# ---- Bad input ----------------------------------------------------------------------------------

empty_output_folder

: >"$scenes/empty.csv"
odd=$(printf 'two\nlines\033[2J') # as a name, it would clear the terminal
: >"$scenes/empty$odd.csv"
printf '# only a comment\n' >"$scenes/comment.csv"
printf '%s\n1,2,3,0.5,1' $header >"$scenes/truncated.csv"
printf '%s\n%s\n%s,7\n' $header $circle $circle >"$scenes/more.csv"
printf '%s\n%s\n\n1,2,three,0.5,1,1,1\n' $header $circle >"$scenes/word.csv"
printf '%s\n1,2,nan,0.5,1,1,1\n' $header >"$scenes/nan.csv"
printf '%s\n1,inf,3,0.5,1,1,1\n' $header >"$scenes/inf.csv"
printf '%s\n1e39,2,3,0.5,1,1,1\n' $header >"$scenes/large.csv"
printf '%s\n1,2,-3,0.5,1,1,1\n' $header >"$scenes/negative.csv"
printf '%s\n1,2,3,0.5,1,1,1.5\n' $header >"$scenes/colour.csv"
printf '%s\n1,2,,0.5,1,1,1\n' $header >"$scenes/gap.csv"
printf '%s\n"1,2,3,0.5,1,1,1\n' $header >"$scenes/quote.csv"
printf 'x,y,radius,r,g,b\n1,2,3,1,1,1\n' >"$scenes/column.csv"
printf '%s,size\n' $header >"$scenes/unknown.csv"
printf '%s,x\n' $header >"$scenes/twice.csv"
printf '%s\n' $circle >"$scenes/no-header.csv"
printf '%s\n\001\000\377\n' $header >"$scenes/binary.csv"
awk 'BEGIN { for (i = 0; i < 5000; i++) printf "1,"; print "" }' >"$scenes/long.csv"
mkdir "$scenes/folder.csv"
mkfifo "$scenes/pipe.csv"
check "a pipe without a writer is not waited for" refuses \
    "pipe.csv: cannot be read: found a pipe or a device, expected a regular file" \
    run_limited 01 --scene "$scenes/pipe.csv" --output "$new"

# shellcheck disable=SC2119 # its rows come from the table
refuses_each <<'END'
01|missing.csv: cannot be read: No such file|--scene $scenes/missing.csv
01|empty.csv:1: found the end of the file|--scene $scenes/empty.csv
02|comment.csv:2: found the end of the file|--scene $scenes/comment.csv
01|truncated.csv:2: found 5 fields, expected 7|--scene $scenes/truncated.csv
02|more.csv:3: found more fields|--scene $scenes/more.csv
03|word.csv:4: radius: found "three"|--scene $scenes/word.csv
01|nan.csv:2: radius: found "nan", expected a finite number|--scene $scenes/nan.csv
02|inf.csv:2: y: found "inf", expected a finite number|--scene $scenes/inf.csv
03|large.csv:2: x: found "1e39", expected a finite number|--scene $scenes/large.csv
01|negative.csv:2: radius: found "-3"|--scene $scenes/negative.csv
02|colour.csv:2: b: found "1.5", expected a number from 0 to 1|--scene $scenes/colour.csv
03|gap.csv:2: radius: found ""|--scene $scenes/gap.csv
01|quote.csv:2: found a quote in a wrong place|--scene $scenes/quote.csv
02|column.csv:1: found no column "depth"|--scene $scenes/column.csv
03|unknown.csv:1: found "size"|--scene $scenes/unknown.csv
01|twice.csv:1: found "x", expected each column once|--scene $scenes/twice.csv
02|no-header.csv:1: found "30", expected the names of columns|--scene $scenes/no-header.csv
03|binary.csv:2: found a NUL byte|--scene $scenes/binary.csv
01|long.csv:1: found more than 4096 characters|--scene $scenes/long.csv
02|folder.csv: cannot be read: found a folder, expected a file|--scene $scenes/folder.csv
03|found no such scene|--scene ''
01|found no such scene|--scene randomly
02|n=N, a whole number|--scene random:n=-1
03|from 0 to 10000000|--scene random:n=10000001
01|seed=S|--scene random:seed=1.5
02|max=R, a radius from 0 to 255|--scene random:max=256
03|found min=9 above max=2|--scene random:min=9,max=2
00|--size: found "-3x5", expected WxH|--size -3x5
01|--size: found "0x0"|--size 0x0
02|--size: found "640"|--size 640
03|--size: found "1000001x1"|--size 1000001x1
02|1000000x1000000|--scene none --size 1000000x1000000
00|--frames: found "0", expected a whole number of at least 1|--frames 0
01|--max-depth: found "0", expected a whole number from 1 to 64|--max-depth 0
02|--max-depth: found "99"|--max-depth 99
03|--leaf-size: found "0"|--leaf-size 0
00|--colour is no option here|--colour
01|-x is no option here|-x
02|--size needs an argument|--size
03|stray word "stray"|--size 8x8 stray
00|"picture.gif", expected a file that ends in .png or .exr|--output picture.gif
01|expected a file that ends in .png or .exr|--output $out/picture
02|expected a file in a folder that exists|--output $out/nowhere/new.png
03|expected a file in a folder that exists|--output $out/old.png/new.png
00|expected a file, not a folder|--output $out/folder.png
01|full.png", expected a regular file|--output $out/full.png
02|--stats: found "/dev/full", expected a regular file|--stats /dev/full
03|--stats: found|--stats $out/nowhere/new.json
01|OpenCL: found no device "", expected a number or a part of a name from|--device ''
01|--scene two lines|--scene "$odd"
02|[2J.csv: cannot be read: No such file|--scene $scenes/"$odd".csv
03|[2J.csv:1: found the end of the file|--scene $scenes/"empty$odd".csv
00|stray word "two lines|"$odd"
01|expected a file that ends in|--output "$odd"
02|expected a file in a folder that exists|--output "$out/$odd/new.png"
03|found no device "two lines|--device "$odd"
00|is no option here|"--$odd"
03|word.csv:4|--scene $scenes/word.csv --output $out/old.png --stats $out/old.json
END

if [ "$(id -u)" -eq 0 ]; then
    skip "a folder without rights" "the superuser may write anywhere"
else
    mkdir -m 555 "$scratch/locked"
    check "a folder without rights" refuses "in a folder that can be written" \
        run 02 --output "$scratch/locked/new.png"
fi

check "no room for the picture" refuses "new.exr: cannot be written: File too large" \
    small_disk run 02 --scene example --output "$out/new.exr"
check "no room for the SVG beside the picture" refuses "new.svg: cannot be written: File too large" \
    small_disk run 02 --scene random:n=200 --size 640x640 --output "$out/new.png"
mkdir "$out/new.svg"
check "no place for the SVG beside the picture" refuses "new.svg: cannot be written" \
    run 02 --scene example --output "$new"
rmdir "$out/new.svg"
fails_to_save 00 01 02 03
fails_for_heat_map 01

# ---- Standard output ----------------------------------------------------------------------------

# fails_without_output FILE REASON LAB OPTION...: a fault, told once, and a whole picture all the same?
# shellcheck disable=SC2317 # called by check
fails_without_output() {
    into=$1 reason=$2 status=0
    shift 2
    run_into "$into" "$@" --output "$out/new.png" || status=$?
    cat "$scratch/stderr"
    [ $status -eq 1 ] && [ "$(wc -l <"$scratch/stderr")" -eq 1 ] &&
        grep -qF "standard output: cannot be written: $reason" "$scratch/stderr"
}
for number in 00 01 02 03; do
    options="--size 64x48 --scene example"
    [ $number != 00 ] || options="--size 64x48"
    for into in '/dev/full|No space left on device' '-|Bad file descriptor'; do
        # shellcheck disable=SC2086
        check "lab $number: standard output is ${into%|*}" \
            fails_without_output "${into%|*}" "${into#*|}" $number $options
        check "lab $number: the picture is whole" works "$compare" "$out/new.png" "$out/new.png"
        rm -f "$out"/new.*
    done
    check "lab $number: help that nobody can read" fails_without_output /dev/full No $number --help
done

# ---- Bad devices --------------------------------------------------------------------------------

for number in 00 01 03; do
    set -- run "$number" --scene example --output "$new"
    [ "$number" != 00 ] || set -- run 00 --output "$new"
    check "lab $number: a size beyond the device" refuses "--size: found 20000x16, expected at most" \
        "$@" --size 20000x16
    check "lab $number: a size beyond all memory" refuses "1000000x1000000" \
        "$@" --size 1000000x1000000
    check "lab $number: no such device" refuses 'found no device "none-such"' "$@" --device none-such
    check "lab $number: no device of this number" refuses 'found no device "99"' "$@" --device 99
    check "lab $number: no device as in COURSE_DEVICE" \
        refuses 'found no device "none-such"' with COURSE_DEVICE=none-such "$@"
    check "lab $number: no OpenCL platform" \
        refuses "OpenCL: found no platform; install" with OCL_ICD_VENDORS=/nonexistent "$@"
    check "lab $number: a device without images" refuses \
        "has no images; choose another with --device" \
        with LD_PRELOAD="$build/tests/no_images.so" "$@"
done
check "no devices to list" refuses "OpenCL: found no platform" \
    with OCL_ICD_VENDORS=/nonexistent run 00 --list-devices
if run 00 --list-devices && grep -q '^0  Portable Computing Language' "$scratch/stdout"; then
    check "a cache that PoCL cannot write" refuses "PoCL needs a cache folder" \
        with POCL_CACHE_DIR="$out/old.json/cache" run 00 --output "$new"
else
    skip "a cache that PoCL cannot write" "the first device is not PoCL's"
fi

# ---- Bad kernels --------------------------------------------------------------------------------

# elsewhere FOLDER COMMAND...: there.
elsewhere() (
    cd "$1" && shift && "$@"
)
mkdir "$scratch/nowhere"
for program in "$build"/solutions/0*-* "$build/tools/grade --lab 01" "$build/tools/memcheck --lab 01"; do
    # shellcheck disable=SC2086,SC2317 # words of a command; called by refuses
    start() { elsewhere "$scratch/nowhere" $program >"$scratch/stdout" 2>"$scratch/stderr"; }
    check "started in the wrong folder: ${program##*/}" refuses \
        "started in the wrong folder, expected the course's top folder" start
    check "it makes nothing there" test -z "$(ls -A "$scratch/nowhere")"
done
check "help is for every folder" elsewhere "$scratch/nowhere" run 01 --help

kernel=solutions/01-naive-2d/overlaps_N_Nearer.cl
echo 'int broken(void) { return no_such_name; }' >>"$scratch/elsewhere/$kernel"
line=$(wc -l <"$kernel")
before=$(state)
elsewhere "$scratch/elsewhere" run 01 --scene example --output "$new"
ok $(($? != 1)) "a kernel that does not compile ends the program with 1" "$(cat "$scratch/stderr")"
ok "$(grep -q "^$kernel:$((line + 1)):[0-9]*: error: .*no_such_name" "$scratch/stderr"; echo $?)" \
    "its message names file and line" "$(cat "$scratch/stderr")"
check "it leaves nothing behind" test "$(state)" = "$before"

finish

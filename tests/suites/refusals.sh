#!/bin/sh
# What the solution programs of the labs in 2D refuse: bad input, places that cannot be written, bad
# devices and kernels. Each fault is one message, and leaves nothing behind.
#
#     sh tests/suites/refusals.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/programs.sh
header=x,y,radius,depth,r,g,b
circle=30,20,9.5,0.25,1,0.5,0

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
        check "lab $number: the picture is whole" works compare "$out/new.png" "$out/new.png"
        rm -f "$out"/new.*
    done
    check "lab $number: help that nobody can read" fails_without_output /dev/full No $number --help
done

# ---- Bad devices --------------------------------------------------------------------------------

for number in 00 01 03; do
    set -- run "$number" --scene example --output "$new"
    [ "$number" != 00 ] || set -- run 00 --output "$new"
    check "lab $number: a size beyond the device" refuses "picture's size: found 20000x16, expected" \
        "$@" --size 20000x16
    check "lab $number: a size beyond all memory" refuses "1000000x1000000" \
        "$@" --size 1000000x1000000
    check "lab $number: no such device" refuses 'found no device "none-such"' "$@" --device none-such
    check "lab $number: no device of this number" refuses 'found no device "99"' "$@" --device 99
    check "lab $number: no device as in COURSE_DEVICE" \
        refuses 'found no device "none-such"' with COURSE_DEVICE=none-such "$@"
    check "lab $number: no OpenCL platform" \
        refuses "OpenCL: found no platform in OCL_ICD_VENDORS=/nonexistent; unset it" with OCL_ICD_VENDORS=/nonexistent "$@"
    check "lab $number: a device without images" refuses \
        "has no images; choose another with --device" \
        with LD_PRELOAD="$build/tests/no_images.so" "$@"
done
check "no devices to list" refuses "OpenCL: found no platform" \
    with OCL_ICD_VENDORS=/nonexistent run 00 --list-devices
if run 00 --list-devices && grep -q '^0  Portable Computing Language' "$scratch/stdout"; then
    check "a cache that PoCL cannot write" refuses "PoCL needs a cache folder" \
        with POCL_CACHE_DIR="$out/old.json/cache" run 00 --output "$new"
    check "a kind of device that PoCL does not have" refuses "does POCL_DEVICES=none-such name one" \
        with POCL_DEVICES=none-such run 00 --output "$new"
else
    skip "a cache that PoCL cannot write" "the first device is not PoCL's"
fi

# ---- The grader's machine -----------------------------------------------------------------------

# grades STATUS WORDS VARIABLE...: a right submission, with what the grader says.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/vendors" "$scratch/temporary"
grades() {
    wanted=$1 words=$2 status=0
    shift 2
    env TMPDIR="$scratch/temporary" "$@" "$build/tools/grade" --lab 00 --submission solutions/00-hello-pixels \
        --output "$scratch/report" >"$scratch/stdout" 2>"$scratch/stderr" || status=$?
    { [ $status -eq "$wanted" ] && { [ -z "$words" ] || grep -qF -- "$words" "$scratch/stderr"; } &&
        [ -z "$(ls -A "$scratch/temporary")" ]; } ||
        { echo "status $status"; cat "$scratch/stderr"; return 1; }
}
check "a list of drivers that the sandbox sees goes on inside" \
    grades 2 "found no platform in OCL_ICD_VENDORS=/usr/share/doc;" OCL_ICD_VENDORS=/usr/share/doc
check "of one that it does not see, the system's are taken" \
    grades 0 "" OCL_ICD_VENDORS="$scratch/vendors"
# shellcheck disable=SC2016 # for the inner shell
check "a shell that lets nobody write large files" grades 2 "at most 1024000 bytes in a file allowed here (ulimit -f)" \
    sh -c 'ulimit -f 2000 && exec "$@"' -

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

mkdir "$scratch/elsewhere"
cp -R solutions kernels "$scratch/elsewhere"
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

#!/bin/sh
# The windows of the labs and their films (common/view), by scripts of keys and mouse events, on a display that
# nobody sees. What they show is held against the pictures that the labs' programs save.
#
#     sh tests/suites/view.sh      from the top folder, after `make tests`
set -u
# Suites run under make, and call it: not as a part of that one.
unset MAKEFLAGS MFLAGS MAKELEVEL
. tests/tap.sh
. tests/programs.sh
if [ -n "${QUICK:-}" ] && [ ! -e "$build/view/solutions/07-kdtree-3d-trace" ]; then
    skip "windows" "SDL is not installed: make test-all installs it"
    finish
    exit
fi

# window LAB SCRIPT-LINES OPTION...: the solution's window, run through a script; "@" stands for $out.
window() {
    for program in "$build/view/solutions/$1"-*; do :; done
    shift
    run_script "$program" "$@"
}

# run_script PROGRAM SCRIPT-LINES OPTION...
run_script() (
    program=$1
    printf '%s\n' "$2" | sed "s|@|$out|g" >"$scratch/script"
    shift 2
    "$program" --script "$scratch/script" "$@" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null
)

# picture FILE WxH: the window's picture, without the panel: FILE.png becomes FILE-part.png.
picture() {
    crop "$out/$1.png" 0 0 "${2%x*}" "${2#*x}" "$out/$1-part.png" && echo "$out/$1-part.png"
}

# shows FILE WxH PICTURE [TOLERANCE [N]]: does the window's picture look like this file?
shows() { part=$(picture "$1" "$2") && shift 2 && compare "$part" "$@"; }

# shows_another FILE WxH PICTURE: does it not?
shows_another() { part=$(picture "$1" "$2") && differs compare "$part" "$3"; }

# ---- Without a display ----------------------------------------------------------------------------

empty_output_folder
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER
check "without a display there is one message" refuses "no window can be opened" \
    window 01 'frames 1' --size 64x48
check "nor on a display that is not there" \
    refuses "no window can be opened" with DISPLAY=:4242 window 07 'frames 1' --size 64x48 --scene one
check "a path that cannot be written is refused before" refuses "--record: found" \
    window 01 'frames 1' --record /no/such.path
check "a lab without a window has none" sh -c '! make -s view LAB=02 2>&1 | grep -v "^make: \*\*\*" | grep -v "^make view: 02-kdtree-2d-build has no window. These labs have one: 01-naive-2d "'

# ---- A display ------------------------------------------------------------------------------------

. tests/display.sh
if ! display_open; then
    skip "windows" "there is no Xvfb"
    finish
    exit
fi
trap 'display_close; rm -rf "$scratch"' EXIT

# ---- What is shown --------------------------------------------------------------------------------

# matches_lab LAB WxH OPTION...: the window, its heat map and the picture that P saves, as the lab's program has
# them.
matches_lab() {
    lab=$1 size=$2
    shift 2
    run "$lab" --output "$out/lab.png" --heat-map --size "$size" "$@" || { cat "$scratch/stderr"; return 1; }
    works window "$lab" "$(printf 'frames 1\nsave @/window.png\nkey M\nkey P\nframes 1\nsave @/heat.png\n')" \
        --output "$out/saved.png" --size "$size" "$@" &&
        shows window "$size" "$out/lab.png" && shows heat "$size" "$out/lab-work.png" &&
        compare "$out/saved.png" "$out/lab.png"
}

# screen_shows OPTION...: is the lab's picture on the screen, where lab 07's window stands, whose size window.png has?
# Another program looks, again and again, as the window has to come up first.
is_on_screen() {
    # shellcheck disable=SC2046 # two numbers
    display_save "$out/screen.png" &&
        crop "$out/screen.png" $(display_middle "$out/window.png") 317 211 "$out/screen-part.png" &&
        said=$(compare "$out/screen-part.png" "$out/lab.png")
}
screen_shows() {
    "$build/view/solutions/07-kdtree-3d-trace" "$@" >/dev/null 2>&1 </dev/null &
    window=$! shown=0 said=
    await is_on_screen || shown=1
    kill $window && echo "$said"
    return $shown
}
check "lab 01: picture and heat map are the lab's" matches_lab 01 317x211 --scene random:n=50
check "lab 03: picture and heat map are the lab's" matches_lab 03 317x211 --scene random:n=500
check "lab 04: the picture is the lab's" works window 04 "$(printf '%s\n' 'frames 1' 'save @/window.png' 'key M' 'frames 1' \
    'save @/heat.png' 'click 9 9' 'drag 20 20 90 60' 'key N' 'frames 1' 'save @/turned.png')" --size 131x97 --scene planes
run 04 --size 131x97 --scene planes --output "$out/lab.png"
check "so it is" shows window 131x97 "$out/lab.png"
check "nothing is counted, so there is no heat map" shows heat 131x97 "$out/lab.png"
check "turned, it is another one" shows_another turned 131x97 "$out/lab.png"
check "lab 05: picture and heat map are the lab's" matches_lab 05 131x97 --scene sphereflake:size=1
check "lab 07: picture and heat map are the lab's" matches_lab 07 317x211 --scene sphereflake:size=2

quick_ends

if command -v ffmpeg >/dev/null; then
    check "and the screen has that picture" screen_shows --size 317x211 --scene sphereflake:size=2
else
    skip "the screen itself" "there is no ffmpeg"
fi
check "lab 08: picture and heat map are the lab's" matches_lab 08 131x97 --scene clusters
check "lab 09: picture and heat map are the lab's" matches_lab 09 131x97 --scene sphereflake:size=2
check "lab 09: with fewer mirrors" matches_lab 09 64x48 --scene inside --bounces 1
check "lab 09: with acne" matches_lab 09 64x48 --scene one --acne
check "lab 10: picture and heat map are the lab's" matches_lab 10 317x211 --scene sphereflake:size=2
check "lab 10: and with shadows and mirrors" matches_lab 10 131x97 --scene sphereflake:size=2 --shadows --bounces 2
check "a picture higher than the panel" matches_lab 03 120x700 --scene random:n=50

# both_draw_alike LAB OPTION...: do the tree's kernel and the naive one, which N gets, show the same, from the
# scene's own view and from another?
both_draw_alike() {
    lab=$1
    shift
    works window "$lab" "$(printf '%s\n' 'frames 1' 'save @/tree.png' 'key N' 'frames 1' 'save @/naive.png' \
        'down W' 'down D' 'frames 5' 'up W' 'up D' 'drag 50 50 71 62' 'wheel 2 50 50' 'frames 2' \
        'save @/naive-2.png' 'key N' 'frames 1' 'save @/tree-2.png')" --size 160x120 "$@" &&
        shows naive 160x120 "$(picture tree 160x120)" &&
        shows naive-2 160x120 "$(picture tree-2 160x120)" &&
        shows_another tree-2 160x120 "$(picture tree 160x120)"
}
check "lab 03: tree and naive show the same, here and elsewhere" both_draw_alike 03 --scene random:n=300
check "lab 07: tree and naive show the same, here and elsewhere" both_draw_alike 07 --scene sphereflake:size=2
# The same in lab 10, of three kernels, each through a tree of its own. Two bytes may differ by one step where rounding
# decides, and three pixels by more, at silhouettes.
three_draw_alike() {
    works window 10 "$(printf '%s\n' 'frames 1' 'save @/fast.png' 'key N' 'key N' 'frames 1' 'save @/tree.png' \
        'down W' 'down D' 'frames 5' 'up W' 'up D' 'drag 50 50 71 62' 'wheel 2 50 50' 'frames 2' 'save @/tree-2.png' \
        'key N' 'frames 1' 'save @/naive-2.png' 'key N' 'frames 1' 'save @/fast-2.png')" --size 157x119 "$@" &&
        shows fast 157x119 "$(picture tree 157x119)" 0.004 3 &&
        shows fast-2 157x119 "$(picture tree-2 157x119)" 0.004 3 &&
        shows naive-2 157x119 "$(picture tree-2 157x119)" &&
        shows_another fast-2 157x119 "$(picture fast 157x119)"
}
check "lab 10: fast, tree and naive show the same, here and elsewhere" three_draw_alike --scene sphereflake:size=2
# works_like LAB KEYS OTHER-LAB OPTION...: behind N, pressed KEYS times, is the heat map that of another lab?
works_like() {
    lab=$1 n_keys=$2 other=$3
    shift 3
    run "$other" --size 96x64 --heat-map --output "$out/other.png" "$@" &&
        works window "$lab" "$(yes 'key N' | head -n "$n_keys"; printf '%s\n' 'key M' 'frames 1' 'save @/window.png')" \
            --size 96x64 "$@" && shows window 96x64 "$out/other-work.png"
}
check "lab 03: the naive kernel asks every circle" works_like 03 1 01 --scene random:n=100
check "lab 07: the naive kernel asks every sphere" works_like 07 1 05 --scene sphereflake:size=1
check "lab 08: the middle's tree is lab 06's" works_like 08 1 07 --scene stadium
check "lab 08: the naive kernel has none" works_like 08 2 05 --scene sphereflake:size=1
check "lab 08: and then its own comes again" works_like 08 3 08 --scene stadium
check "lab 10: lab 07's kernel goes through lab 06's tree" works_like 10 2 07 --scene stadium
check "lab 10: the naive kernel has none" works_like 10 3 05 --scene sphereflake:size=1
check "lab 10: and then the tiles have theirs again" works_like 10 4 10 --scene stadium
check "lab 01 has one kernel; R builds it again" works window 01 \
    "$(printf '%s\n' 'frames 1' 'save @/before.png' 'key N' 'key R' 'frames 1' 'save @/after.png')" --size 64x48
check "and it shows the same" shows after 64x48 "$(picture before 64x48)"

# ---- Shadows and mirrors --------------------------------------------------------------------------

mirrors='--scene sphereflake:size=2 --size 96x64'
# shellcheck disable=SC2086 # options
{
    run 07 $mirrors --output "$out/lab-07.png"
    run 09 $mirrors --output "$out/five.png"
    run 09 $mirrors --bounces 4 --output "$out/four.png"
    run 09 $mirrors --bounces 0 --output "$out/none.png"
    check "lab 09: keys for shadows and mirrors" works window 09 "$(printf '%s\n' 'key V' 'frames 1' 'save @/v.png' \
        'key B' 'frames 1' 'save @/b.png' 'key L' 'frames 1' 'save @/l.png' 'key V' 'key V' 'key V' 'key V' 'key V' \
        'frames 1' 'save @/plain.png' 'key V' 'frames 1' 'save @/fewer.png' 'key L' 'frames 1' 'save @/shadows.png' \
        'key N' 'frames 1' 'save @/tree.png' 'key L' 'key B' 'frames 1' 'save @/tree-2.png' 'key N' 'frames 1' \
        'save @/naive.png' 'key N' 'frames 1' 'save @/back.png')" $mirrors
}
check "V: four mirrors" shows v 96x64 "$out/four.png"
check "which is another picture" shows_another v 96x64 "$out/five.png"
check "B: five again" shows b 96x64 "$out/five.png"
check "L: no shadows is another picture" shows_another l 96x64 "$out/five.png"
# Light falls on a point a little off the surface, so that a byte may be rounded to the other side: a step of 1/255.
check "neither shadows nor mirrors: lab 07's picture" shows plain 96x64 "$out/lab-07.png" 0.004
check "there are no fewer mirrors than none" shows fewer 96x64 "$(picture plain 96x64)"
check "L: shadows again" shows shadows 96x64 "$out/none.png"
check "they are another picture than lab 07's by far" differs compare "$out/none.png" "$out/lab-07.png" 0.1
check "N: lab 07's kernel" shows tree 96x64 "$out/lab-07.png"
check "for which the keys do nothing" shows tree-2 96x64 "$out/lab-07.png"
check "N: lab 05's" shows naive 96x64 "$out/lab-07.png"
check "N: and its own, with shadows and no mirrors" shows back 96x64 "$out/none.png"

# says_so KEY LAB OPTION...: does a key that means nothing in a lab change the panel's last line, and no picture?
says_so() {
    key=$1 lab=$2
    shift 2
    works window "$lab" "$(printf '%s\n' 'frames 1' 'frames 1' 'save @/before.png' "key $key" 'frames 1' 'save @/after.png')" \
        --size 64x48 "$@" || return 1
    for shown in before after; do
        crop "$out/$shown.png" 64 608 352 32 "$out/$shown-line.png" || return 1
    done
    shows after 64x48 "$(picture before 64x48)" && differs compare "$out/after-line.png" "$out/before-line.png"
}
check "lab 04: M says that it does nothing" says_so M 04
for key in L V B; do
    check "lab 07: $key says that it does nothing" says_so $key 07 --scene one
done
check "lab 01: L says so, too" says_so L 01
check "and lab 10's" says_so L 10 --scene one
run 10 --scene sphereflake:size=2 --size 96x64 --output "$out/lab-10.png"
run 10 --shadows --bounces 1 --scene sphereflake:size=2 --size 96x64 --output "$out/lab-one.png"
check "lab 10: N goes on to shadows, where the keys work" works window 10 "$(printf '%s\n' 'key N' 'frames 1' \
    'save @/one.png' 'key V' 'key L' 'frames 1' 'save @/plain.png')" --scene sphereflake:size=2 --size 96x64 --bounces 1
check "there is one mirror" shows one 96x64 "$out/lab-one.png"
check "and without shadows and mirrors the picture without them" shows plain 96x64 "$out/lab-10.png" 0.004
check "lab 10: --shadows begins with them" works window 10 "$(printf '%s\n' 'frames 1' 'save @/one.png')" \
    --scene sphereflake:size=2 --size 96x64 --bounces 1 --shadows
check "so it does" shows one 96x64 "$out/lab-one.png"
check "lab 09: V says so where there are no mirrors" says_so V 09 --scene one --bounces 0

# ---- The tree's depth -----------------------------------------------------------------------------

# At every depth up to 30 this tree is another one.
deep='--scene random:n=300,min=0.1,max=0.3 --leaf-size 1 --size 96x64'

# depth_is DEPTH OTHER SCRIPT-LINE...: after these, is the heat map that of the lab with --max-depth DEPTH, and not
# that with OTHER? $depth_lab's window and $like_lab's heat map.
depth_lab=07 like_lab=07
depth_is() {
    depth=$1 other=$2
    shift 2
    # shellcheck disable=SC2086 # options
    for levels in "$depth" "$other"; do
        run $like_lab $deep --max-depth "$levels" --heat-map --output "$out/depth-$levels.png" || return 1
    done
    # shellcheck disable=SC2086
    works window $depth_lab "$(printf '%s\n' 'key M' "$@" 'frames 1' 'save @/window.png')" $deep --max-depth 10 &&
        shows window 96x64 "$out/depth-$depth-work.png" && shows_another window 96x64 "$out/depth-$other-work.png"
}
check "a key takes a level off the tree" depth_is 9 11 'key -'
check "and another one gives it one more" depth_is 11 9 'key ='
check "the slider's left end is one level" depth_is 1 2 'drag 280 286 110 286'
check "its right end is 30" depth_is 30 20 'drag 280 286 520 286'
check "its middle is what it stands for" depth_is 16 15 'click 277 286'
check "a press beside it changes nothing" depth_is 10 16 'click 277 330'
for lab in 08 10; do
    depth_lab=$lab like_lab=$lab
    # Lab 10 has a line more above it, and another kernel before lab 07's.
    case $lab in 10) y=303 more='key N' ;; *) y=286 more='frames 1' ;; esac
    check "lab $lab: the slider" depth_is 4 5 "drag 280 $y 143 $y"
    like_lab=07
    check "lab $lab: its depth goes with N" depth_is 4 5 "drag 280 $y 143 $y" 'frames 1' 'key N' "$more"
done

# ---- A pixel is followed --------------------------------------------------------------------------

# follows LAB OPTION...: are the steps of a picture's one pixel as many as the lab counts? Of nodes, leaves and
# tests; of those that miss there are several in a line.
follows() {
    lab=$1
    shift
    run "$lab" --size 1x1 --stats "$out/figures.json" --output "$out/one.png" "$@" &&
        works window "$lab" "$(printf 'click 0 0\nframes 1\n')" --size 1x1 "$@" || return 1
    tests=$(figure sphere_tests.max_per_pixel)$(figure circle_tests.max_per_pixel)
    expected="$(figure nodes_visited.max_per_pixel) $(figure leaves_visited.max_per_pixel) $tests"
    found=$(awk '/^node/ { nodes++ } /^leaf .*wait/ { leaves++ } /^  missed:/ { tests += NF - 1 }
        /^  (sphere|circle) / { tests++ }
        END { print nodes + 0, leaves + 0, tests + 0 }' "$scratch/stdout")
    case $lab in 0[13]) found="${found% 0 *}  ${found##* }" ;; esac
    [ "$found" = "$expected" ] || { echo "found $found, expected $expected"; cat "$scratch/stdout"; return 1; }
}
check "lab 01: all that a pixel asks" follows 01 --scene random:n=40
check "lab 03: nodes and circles of a pixel" follows 03 --scene random:n=40,min=1,max=1 --leaf-size 2
check "lab 05: all that a ray asks" follows 05 --scene sphereflake:size=1
check "lab 08: nodes, leaves and spheres of a ray" follows 08 --scene sphereflake:size=3
check "lab 07: nodes, leaves and spheres of a ray" follows 07 --scene sphereflake:size=3
check "its last line is what the ray hits" grep -q '^hit: sphere [0-9]*, t [0-9.]*$' "$scratch/stdout"
end=$(grep '^hit:' "$scratch/stdout")
window 07 "$(printf 'key N\nclick 0 0\nframes 1\n')" --size 1x1 --scene sphereflake:size=3
[ "$(grep '^hit:' "$scratch/stdout")" = "$end" ]
ok $? "the naive kernel's ray hits the same" "$(tail -n 1 "$scratch/stdout"), expected $end"
# Many rays a pixel, or many pixels a tile.
for lab in 09 10; do
    works window $lab "$(printf '%s\n' 'click 0 0' 'frames 1' 'key N' 'frames 1')" --size 1x1 --scene sphereflake:size=3 &&
        ! grep -q pixel "$scratch/stdout"
    ok $? "lab $lab: of its own kernel no pixel is followed" "$(cat "$scratch/stdout")"
    case $lab in 10) more='key N' ;; *) more='frames 1' ;; esac
    works window $lab "$(printf '%s\n' 'key N' "$more" 'click 0 0' 'frames 1' 'key N' 'frames 1')" --size 1x1 --scene sphereflake:size=3
    [ "$(grep '^hit:' "$scratch/stdout")" = "$end" ]
    ok $? "lab $lab: but of lab 07's there" "$(cat "$scratch/stdout"), expected $end"
done
window 07 "$(printf 'key N\nclick 0 0\nframes 1\n')" --size 1x1 --scene sphereflake:size=3
check "more steps than are kept: all are counted" grep -q '^and 3[0-9]* more$' "$scratch/stdout"

# ---- Watched by the sanitizers --------------------------------------------------------------------

# All keys, and a mouse that leaves the picture.
restless() {
    for program in "$build/sanitized/view/solutions/$1"-*; do :; done
    with ASAN_OPTIONS=detect_leaks=0 run_script "$program" "$(printf '%s\n' 'frames 1' 'click 300 20' 'click 30 20' \
        'key H' 'key M' 'key L' 'key V' 'key B' 'key B' 'frames 1' 'key N' 'frames 1' 'key PageDown' 'key P' 'wheel -2 300 500' 'wheel 2 30 20' 'key -' 'frames 2' \
        'drag 10 10 900 900' 'drag 10 10 -50 -50 right' 'key O' 'frames 3' 'key Home' 'key R' 'key C' 'key F' \
        'drag 500 286 700 286' 'frames 1' 'key Escape' 'frames 1')" --scene random:n=40 --size 64x48 \
        --record "$out/restless.path" --output "$out/restless.png"
}
if $is_sanitized; then
    check "lab 03: every key, watched" works restless 03
    check "lab 04: every key, watched" works restless 04
    check "lab 07: every key, watched" works restless 07
    check "lab 08: every key, watched" works restless 08
    check "lab 09: every key, watched" works restless 09
    check "lab 10: every key, watched" works restless 10
    [ ! -s "$scratch/stderr" ]
    ok $? "and nothing is said" "$(cat "$scratch/stderr")"
fi

# ---- Paths and films ------------------------------------------------------------------------------

# A flight is recorded, and its last pose is where the window ended.
check "a flight is recorded" works window 07 \
    "$(printf 'down W\ndown LEFT\nframes 10\nup W\nup LEFT\nsave @/flown.png\n')" \
    --scene sphereflake:size=1 --size 64x48 --record "$out/flight.path"
[ "$(grep -vc '^#' "$out/flight.path")" -eq 10 ]
ok $? "with a pose for each of its frames" "$(cat "$out/flight.path")"
check "its path is flown" works window 07 "$(printf 'frames 10\nsave @/again.png\n')" \
    --scene sphereflake:size=1 --size 64x48 --path "$out/flight.path"
check "and ends in the same place" shows again 64x48 "$(picture flown 64x48)"
check "F flies it once more" works window 07 "$(printf 'frames 12\nkey HOME\nframes 1\nkey F\nframes 10\nsave @/again.png\n')" \
    --scene sphereflake:size=1 --size 64x48 --path "$out/flight.path"
check "and ends there, too" shows again 64x48 "$(picture flown 64x48)"

# An hour of standing still. However the window ends meanwhile, the flight up to then is there.
yes '2 1.5 1.75 0 0 0 0 0 1' | head -n 90000 >"$scratch/hour.path"
is_flying() { [ "$(wc -l <"$out/flown.path")" -gt 5 ]; }
ends_by() (
    [ "$1" != display ] || display_open
    # sh lets no signal of the keyboard reach what it starts in the background.
    env --default-signal=INT "$build/view/solutions/07-kdtree-3d-trace" --scene one --size 64x48 \
        --path "$scratch/hour.path" --record "$out/flown.path" >/dev/null 2>&1 </dev/null &
    window=$!
    await is_flying
    n_poses=$(wc -l <"$out/flown.path")
    case $1 in display) kill "$display_server" ;; *) kill -s "$1" $window ;; esac
    ! wait $window && sed -n '2,$p' "$out/flown.path" | head -n $((n_poses - 1)) >"$scratch/before" &&
        head -n $((n_poses - 1)) "$scratch/hour.path" | cmp - "$scratch/before"
)
for end in INT TERM HUP KILL display; do
    : >"$out/flown.path"
    check "a flight that $end ends is recorded up to there" ends_by $end
    check "and can be flown" works window 07 'frames 1' --scene one --size 64x48 --path "$out/flown.path"
done

mkdir "$out/film"
# A frame of a film before, which was longer.
: >"$out/film/frame-00200.png"
film() { common/view/movie.sh "$build/view/solutions/$1" "$out/film" "$2" "$3" --size 63x48 >"$scratch/stdout" 2>"$scratch/stderr"; }
check "a film needs no display" works with DISPLAY= film 07-kdtree-3d-trace --scene sphereflake:size=1
[ "$(find "$out/film" -name 'frame-*.png' | wc -l)" -eq 100 ]
ok $? "it goes once round the scene in 100 frames" "$(find "$out/film")"
run 07 --scene sphereflake:size=1 --size 63x48 --output "$out/lab.png"
check "its first frame is the scene's own view" compare "$out/film/frame-00001.png" "$out/lab.png"
check "the others are not" differs compare "$out/film/frame-00026.png" "$out/lab.png"
if command -v ffprobe >/dev/null; then
    found=$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height -of csv=p=0 "$out/film.mp4")
    [ "$found" = 64,48,100 ]
    ok $? "and as a film there are as many" "found $found"
else
    skip "a film" "there is no ffmpeg"
fi
film 07-kdtree-3d-trace --scene nowhere.nff
[ "$(find "$out/film" -name 'frame-*.png' | wc -l)" -eq 100 ] && [ ! -e "$out/film.new" ]
ok $? "a film that cannot be made leaves the one before" "$(find "$out/film")"
check "a film of the recorded flight" works film 07-kdtree-3d-trace --path "$out/flight.path"
[ "$(find "$out/film" -name 'frame-*.png' | wc -l)" -eq 10 ]
ok $? "has a frame a pose, and none of the film before" "$(find "$out/film")"
rm -r "$out/film" "$out"/*.mp4
check "in 2D the plane moves" works film 03-kdtree-2d-render --scene random:n=50
rm -rf "$out/film" "$out"/*.mp4

# ---- What is wrong --------------------------------------------------------------------------------

empty_output_folder
check "a script's unknown command" refuses 'script:2: found "dance"' window 01 "$(printf 'frames 1\ndance\n')" --size 64x48
check "a script's unknown key" refuses 'expected key NAME' window 01 'key no-such-key' --size 64x48
check "a script's number that is none" refuses 'expected click X Y' window 01 'click 1 x' --size 64x48
echo 1 2 3 >"$scratch/flight.path"
check "a path of the wrong kind" refuses 'flight.path:1: found 3 numbers, expected 9' \
    window 07 'frames 1' --scene one --size 8x8 --path "$scratch/flight.path"

# A course in which lab 01 does not build.
course=$scratch/course
mkdir -p "$course/labs"
for entry in kernels solutions common tests; do ln -s "$PWD/$entry" "$course/$entry"; done
cp -r labs/01-naive-2d "$course/labs/"
sed 's/^    float4 color.*/    float5 color;/' solutions/01-naive-2d/implicit2DRenderer.cl \
    >"$course/labs/01-naive-2d/implicit2DRenderer.cl"
in_course() (cd "$course" && run_script "$build/view/labs/01-naive-2d" "$@" --size 64x48 --output "$out/01.png")
status=0
in_course 'frames 1' || status=$?
[ $status -eq 1 ] && grep -q 'labs/01-naive-2d/implicit2DRenderer.cl:[0-9]*:[0-9]*: error:.*float5' "$scratch/stderr"
ok $? "a kernel that does not build gives the message of the lab's program" "$(cat "$scratch/stderr")"

cp labs/01-naive-2d/implicit2DRenderer.cl "$course/labs/01-naive-2d/"
check "the skeleton has a window" works in_course 'frames 1'

# as_program NAME OPTION...: does a lab's window in that course show what the program there saves? Then `N` is pressed
# twice, and the window saved as next.png and next-but-one.png.
as_program() (
    name=$1
    shift
    cd "$course" && "$build/labs/$name" "$@" --size 64x48 --output "$out/own.png" >"$scratch/stdout" 2>&1 &&
        works run_script "$build/view/labs/$name" "$(printf '%s\n' 'frames 1' 'save @/window.png' 'key N' 'frames 1' \
            'save @/next.png' 'key N' 'frames 1' 'save @/next-but-one.png')" "$@" --size 64x48 && shows window 64x48 "$out/own.png"
)
cp -r labs/09-shadows-and-mirrors "$course/labs/"
check "lab 09: the skeleton's picture" as_program 09-shadows-and-mirrors --scene one
check "behind N stands lab 07's" shows_another next 64x48 "$out/own.png"
# A colour that is no number: black, as in a .png.
sed 's/^    float3 color = .*/    float3 color = (float3)(NAN);/' labs/09-shadows-and-mirrors/mirrors.cl \
    >"$course/labs/09-shadows-and-mirrors/mirrors.cl"
cp "$out/own.png" "$out/skeleton.png"
check "lab 09: no number for a colour" as_program 09-shadows-and-mirrors --scene one
check "is black" compare "$out/own.png" "$out/skeleton.png"
cp -r labs/04-camera-rays "$course/labs/"
check "lab 04: the skeleton's picture" as_program 04-camera-rays
cp -r labs/10-realtime "$course/labs/"
check "lab 10: the skeleton's picture" as_program 10-realtime --scene sphereflake:size=1
check "behind N stands lab 07's" shows_another next-but-one 64x48 "$out/own.png"

finish

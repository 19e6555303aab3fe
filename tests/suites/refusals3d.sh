#!/bin/sh
# What the solution programs of the labs in 3D refuse: bad scenes, numbers and places. Each fault is
# one message, and leaves nothing behind.
#
#     sh tests/suites/refusals3d.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/programs.sh

# ---- Bad input ----------------------------------------------------------------------------------

empty_output_folder

# nff FROM AT UP ANGLE [LINE...]: a file with this view, and further lines.
nff() {
    printf 'v\nfrom %s\nat %s\nup %s\nangle %s\nhither 0.1\nresolution 64 48\n' "$1" "$2" "$3" "$4"
    shift 4
    printf '%s\n' "$@"
}

nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0 nan' >"$scenes/nan.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0 0' >"$scenes/zero.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0 2e18' >"$scenes/vast.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0' >"$scenes/short.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 'q 0 0 0' >"$scenes/unknown.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 'p 3' '0 0 0' >"$scenes/cut.nff"
nff '0 -5 0' '0 0 0' '0 0 1' inf 's 0 0 0 1' >"$scenes/angle.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 180 's 0 0 0 1' >"$scenes/wide.nff"
nff '0 0 0' '0 0 0' '0 0 1' 45 's 0 0 0 1' >"$scenes/direction.nff"
nff '0 -5 0' '0 0 0' '0 0 0' 45 's 0 0 0 1' >"$scenes/up.nff"
nff '0 -5 0' '0 0 0' '0 3 0' 45 's 0 0 0 1' >"$scenes/parallel.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0 -1' >"$scenes/inside.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 0 0 0 1' | sed 's/^resolution.*/resolution 20000 16/' \
    >"$scenes/large.nff"
echo 's 0 0 0 1' >"$scenes/blind.nff"
nff '0 -5 0' '0 0 0' '0 0 1' 1.4e-45 's 0 0 0 1' >"$scenes/thin.nff"
nff '2 -5 1' '0 0 0' '0 0 1' 1e-6 's 0 0 0 1' >"$scenes/thin2.nff"
printf 'ATOM      1  CA  ALA A   1      11.104   6.134   1.000\nHETA' >"$scenes/name.pdb"
printf 'ATOM      1  CA  ALA A   1      11.104   6.134   1.0' >"$scenes/number.pdb"
mkfifo "$scenes/pipe.nff"
check "a pipe without a writer is not waited for" refuses "pipe.nff: cannot be read: found a pipe" \
    run_limited 06 --scene "$scenes/pipe.nff" --output "$new"
# Two small spheres at one place, and one far off: splitting gets nearer to the two without an end.
nff '0 -5 0' '0 0 0' '0 0 1' 45 's 1 1 1 0.1' 's 0.3 0.3 0.3 1e-9' 's 0.3 0.3 0.3 1e-9' \
    >"$scenes/same.nff"
: >"$scenes/empty.nff"
: >"$scenes/empty.xyz"
: >"$scenes/empty.pdb"
printf '3\nwater\nO 0 0 0\nH 1 0 0\n' >"$scenes/cut.xyz"
printf '1\nnone\nO 0 nan 0\n' >"$scenes/nan.xyz"
printf 'many\nnone\nO 0 0 0\n' >"$scenes/count.xyz"
echo data_1ABC >"$scenes/model.cif"
printf 'ATOM      1  CA  ALA A   1      11.104   6.134\n' >"$scenes/cut.pdb"
printf 'REMARK nothing\nEND\n' >"$scenes/none.pdb"
check "a sphere seen from inside is drawn" works run 07 --scene "$scenes/inside.nff" --output "$new"
rm -f "$new"

# shellcheck disable=SC2119 # its rows come from the table
refuses_each <<'END'
04|missing.nff: cannot be read: No such file|--scene $scenes/missing.nff
05|nan.nff:8: |--scene $scenes/nan.nff
07|vast.nff:8: radius: found "2e18", expected a number from 1e-18 to 1e18|--scene $scenes/vast.nff
06|zero.nff:8: |--scene $scenes/zero.nff
07|short.nff:8: |--scene $scenes/short.nff
04|unknown.nff:8: |--scene $scenes/unknown.nff
05|cut.nff:|--scene $scenes/cut.nff
06|angle.nff:5: |--scene $scenes/angle.nff
07|wide.nff:5: |--scene $scenes/wide.nff
04|the view's direction is zero|--scene $scenes/direction.nff
05|up is zero|--scene $scenes/up.nff
06|up is parallel to the view|--scene $scenes/parallel.nff
06|thin.nff: found a view's angle of 1.4013e-45 degrees, expected at least|--scene $scenes/thin.nff
06|degrees, expected at least|--scene $scenes/thin2.nff
06|name.pdb:2: found the end of the file in the name of a record|--scene $scenes/name.pdb
06|number.pdb:1: found the end of the file in column 52, expected x, y and z|--scene $scenes/number.pdb
05|the picture's size: found 20000x16, expected at most|--scene $scenes/large.nff
07|blind.nff:|--scene $scenes/blind.nff
04|empty.nff:|--scene $scenes/empty.nff
05|empty.xyz:|--scene $scenes/empty.xyz
06|empty.pdb:|--scene $scenes/empty.pdb
07|cut.xyz:|--scene $scenes/cut.xyz
04|nan.xyz:3: |--scene $scenes/nan.xyz
05|count.xyz:1: |--scene $scenes/count.xyz
05|model.cif: found a molecule as mmCIF, expected PDB or XYZ|--scene $scenes/model.cif
06|cut.pdb:1: |--scene $scenes/cut.pdb
07|none.pdb:|--scene $scenes/none.pdb
04|found no such scene|--scene example
05|size=N, a whole number|--scene sphereflake:size=8
06|n=N, a whole number|--scene random:n=-1
07|found min=0.5 above max=0.25|--scene random:min=0.5,max=0.25
04|n=N, a whole number|--scene lattice:n=1000
05|--textbook does not take an argument|--textbook=1
09|--bounces: found "65", expected a whole number from 0 to 64|--bounces 65
09|--bounces: found "-1", expected a whole number from 0 to 64|--bounces -1
09|--acne does not take an argument|--acne=1
07|too deep for the todo stack (TODO_SIZE); choose|--scene $scenes/same.nff --max-depth 64 --leaf-size 1
END

fails_to_save 04 05 06 07 08 09 10
fails_for_heat_map 07 09 10

finish

# shellcheck shell=sh disable=SC2154 # sourced, behind tests/tap.sh
# A copy of the course with what is built, in which a suite may change anything: the suite goes there.
course=$scratch/course
mkdir -p "$course/build"
build=${BUILD:-build}
for part in * .clang-format; do
    case $part in build | "$build") ;; *) cp -pR "$part" "$course" ;; esac
done
for part in obj labs solutions probes judges tools; do cp -pR "$build/$part" "$course/build"; done
cp -p "$build"/*.a "$build"/*.so "$build/no_macros.h" "$course/build"
cd "$course" || exit 1
export BUILD=build

#!/bin/sh
# A copy of the course that only its owner may enter, with what of build/ the grader needs: where the
# sandbox goes by the rights of files, the grader refuses to work in an open one.
#
#     tests/closed_course.sh FOLDER      from the top folder; FOLDER is made; $BUILD is what is built
set -eu
build=${BUILD:-build}
mkdir -m 700 "$1" "$1/build"
cp -R common kernels labs solutions tests "$1"
cp -R "$build/tools" "$build/judges" "$build/probes" "$build/earlier" "$build/libcommon.a" "$build/no_macros.h" \
    "$build/libimage_codec.so" "$1/build"

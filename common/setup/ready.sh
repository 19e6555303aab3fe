#!/bin/sh
# Can the course be built here? make asks before it compiles the first file.
#
#     common/setup/ready.sh BUILD/ready CC CXX
#
# Makes this file if so. If not: one message that says what to do, instead of a compiler's for each file.
set -eu
folder=$(dirname "$1")

missing=
# shellcheck disable=SC2086 # the first word of each command
for tool in ${2%% *} ${3%% *} pkg-config; do
    command -v "$tool" >/dev/null || missing="$missing, $tool"
done
# The headers of all libraries; those of the class grader where it is.
headers="stdio.h CL/cl.h jansson.h csv.h archive.h seccomp.h OpenImageIO/imageio.h"
[ ! -d tests/class ] || headers="$headers nettle/sha2.h unicode/uspoof.h"
# shellcheck disable=SC2046,SC2086 # lists of words
[ -n "$missing" ] || missing=$(printf '%s\n' $headers |
    sed 's/.*/#if !__has_include(<&>)\n, &\n#endif/' |
    $3 -E -P -x c++ $(pkg-config --cflags OpenImageIO 2>/dev/null) - | tr -d '\n')
if [ -n "$missing" ]; then
    echo "make: not on this machine yet:${missing#,}. Run make setup first, which installs what is missing." >&2
    echo "It ends with a message? make doctor says more." >&2
    exit 1
fi

if ! { mkdir -p "$folder" && : >"$1"; } 2>/dev/null; then
    echo "make: cannot write to $folder in $PWD: make doctor says what to do" >&2
    exit 1
fi

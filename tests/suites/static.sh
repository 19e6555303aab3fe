#!/bin/sh
# What can be said without running anything: format, warnings, static analysis, house rules.
. tests/tap.sh

# by TOOL NAME COMMAND...: a check by a tool that `make test` does without where it is not installed.
by() {
    tool=$1
    shift
    if [ -n "${QUICK:-}" ] && ! command -v "$tool" >/dev/null; then
        skip "$1" "$tool is not installed: make test-all installs it"
    else
        check "$@"
    fi
}

sources=$(git ls-files -- '*.c' '*.h' '*.cpp' '*.cl' 2>/dev/null)
[ -n "$sources" ] || sources=$(find common kernels labs solutions tests -name '*.[ch]' -o -name '*.cpp' -o -name '*.cl')
written=$(echo "$sources" | grep -v -e '^labs/' -e '^tests/stubs/' -e '^tests/attacks/')

# shellcheck disable=SC2086 # lists of names without spaces
by clang-format-19 "clang-format (make format mends it)" clang-format-19 --dry-run -Werror \
    --style='{BasedOnStyle: InheritParentConfig, InsertBraces: true}' $written

# In the quick part with one set of macros for each file.
# shellcheck disable=SC2046,SC2086
by cppcheck "cppcheck" cppcheck $(quick --max-configs=1 "") --quiet --error-exitcode=1 --inline-suppr --std=c11 --language=c \
    --enable=warning,performance,portability --suppress=missingIncludeSystem \
    --suppress=normalCheckLevelMaxBranches --suppress=nullPointerOutOfMemory \
    --suppress=nullPointerArithmeticOutOfMemory --suppress=nullPointerOutOfResources \
    -Icommon -Icommon/view -Icommon/follow -Ikernels -Itests/stubs $(find tests -name '*.h' -exec dirname {} + | sort -u | sed 's/^/-I/') -Isolutions/02-kdtree-2d-build \
    -Isolutions/04-camera-rays -Isolutions/05-spheres -Isolutions/06-kdtree-3d-build -Isolutions/08-surface-area-heuristic \
    -DJSON_INTEGER_FORMAT='"lld"' -DLAB_NAME='"lab"' -DLAB_FOLDER='"labs/lab"' -DKERNEL_OPTIONS='""' -DSTEPS_FOLDER='""' -DPROBE_KERNEL_OPTIONS='""' \
    -DSANDBOX_INIT='""' -D'JUDGES=JUDGE(00)' -DNATIVE_HEADER='""' -DNATIVE_FAULT='""' -DNATIVE_CACHE='""' \
    $(echo "$written" | grep '\.c$' | grep -v '^tests/unit/')

# Skeletons have no warnings, though a student's half-written code may.
for source in $(echo "$sources" | grep '^labs/.*\.c$'); do
    lab=$(basename "$(dirname "$source")")
    # shellcheck disable=SC2046
    check "gcc -Wall -Wextra $source" gcc -std=c11 -D_GNU_SOURCE -Wall -Wextra -Werror -fsyntax-only \
        -Icommon -Ikernels "-Ilabs/$lab" $(printf -- '-I%s ' solutions/*) \
        -DLAB_NAME='""' -DLAB_FOLDER='""' -DKERNEL_OPTIONS='""' "$source"
done

# The OpenCL compiler of each clang that is here (in the quick part of the first), with warnings, on every kernel, counting and not. PoCL is made of one,
# and prints what it says before a program's own output.
clangs=$(for n in 14 15 16 17 18 19 20 21; do command -v clang-$n; done)
[ -n "$clangs" ] || clangs=$(command -v clang)
clangs=$(quick "${clangs%%[[:space:]]*}" "$clangs")
# A file that others include is checked by itself, so its static functions have no caller.
# A kernel's own folder comes first, so that the same name in another lab does no harm.
sh tests/probes/no_macros.sh >"$scratch/no_macros.h"
includes="-I kernels -I tests/probes -I solutions -I $scratch"
for folder in solutions/*/ tests/probes/*/; do
    includes="$includes -I $folder"
done
# says_nothing OPTION...: does each compile this in silence? Some warnings come only with the code.
says_nothing() {
    for clang in $clangs; do
        "$clang" -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -S -emit-llvm -o /dev/null "$@" >"$scratch/clang" 2>&1
        [ ! -s "$scratch/clang" ] || { echo "$clang:"; cat "$scratch/clang"; return 1; }
    done
}
for kernel in $(echo "$sources" | grep '\.cl$' | grep -v -e '^tests/stubs/' -e '^tests/attacks/'); do
    for variant in "" -DCOUNT_WORK -DTEXTBOOK; do
        case $variant$kernel in -DTEXTBOOK*/05-*) ;; -DTEXTBOOK*) continue ;; esac
        # shellcheck disable=SC2086
        check "clang -Wall -Wextra $kernel $variant" says_nothing -Wall -Wextra -Wno-unused-function $includes $variant "$kernel"
    done
done

# Those of other versions do not know each warning that a kernel turns off.
mkdir -p "$scratch/older"
for file in $(echo "$sources" | grep -e '^solutions/.*\.[hc]l*$' -e '^common/follow/steps/' | xargs grep -l 'diagnostic ignored'); do
    sed 's/"-W[a-z-]*"/"-Wno-such-warning"/' "$file" >"$scratch/older/$(basename "$file")"
    echo "#include \"$(basename "$file")\"" >"$scratch/older/kernel.cl"
    # shellcheck disable=SC2086
    check "a clang that does not know what $file turns off says nothing" says_nothing -I "$scratch/older" \
        -I "$(dirname "$file")" $includes "$scratch/older/kernel.cl"
done

# shellcheck disable=SC2046
# SC2319: `ok $?` after a condition is meant to see the condition's own status.
# shellcheck disable=SC2046
by shellcheck "shellcheck" shellcheck -e SC2319 $(git ls-files -- '*.sh' .ci/run '*/run_autograder' 2>/dev/null || find . -name '*.sh')

# What a user sets is text to make, too (Makefile). What makefiles mention and do not set is from outside.
makefiles=$(git ls-files -- Makefile '*.mk' 2>/dev/null | grep . || find Makefile common tests slides-notes -name Makefile -o -name '*.mk')
# shellcheck disable=SC2016 # make's
outside=$(make -s --eval='outside:;@echo $(FROM_OUTSIDE)' outside)
# shellcheck disable=SC2086 # a list of names without spaces
unset_names=$(cat $makefiles | awk -v outside="$outside" '
    BEGIN { n = split(outside " AR CURDIR MAKE MAKEFLAGS MAKELEVEL MAKECMDGOALS MAKEFILE_LIST", known); for (i = 1; i <= n; i++) is_set[known[i]] = 1 }
    /^ *#/ { next }
    match($0, /(^|: )[A-Z][A-Z0-9_]* *[:+]?= /) { name = substr($0, RSTART, RLENGTH); gsub(/[^A-Z0-9_]/, "", name); is_set[name] = 1 }
    { for (rest = $0; match(rest, /\$[({][A-Z][A-Z0-9_]*[)},:]/); rest = substr(rest, RSTART + RLENGTH))
        mentioned[substr(rest, RSTART + 2, RLENGTH - 3)] = 1 }
    END { for (name in mentioned) if (!(name in is_set)) print name }')
[ -z "$unset_names" ]
ok $? "every variable that comes from outside is in the Makefile's FROM_OUTSIDE" "$unset_names"
# Its text gets into no recipe: a makefile asks whether it is set, or picks a name of ours with it.
mention="[$][({]($(echo "$outside" | sed 's/ /|/g'))[)}]"
# shellcheck disable=SC2086
texts=$(grep -nE "$mention" $makefiles | grep -vE '^[^:]*:[0-9]*:(graded_lab = |ifeq |#)|BUILD: found' |
    sed -E 's/[$][(](if|and|filter [a-z-]*) *[$][(][A-Z_]+[)]//g; s/[$][(](BUILD|CLANG|LDFLAGS|FUZZ_OPTIONS)[)]//g' |
    grep -E "$mention")
[ -z "$texts" ]
ok $? "no recipe holds the text of one: recipes take it from the environment, as \$\$NAME" "$texts"

# House rules.
# shellcheck disable=SC2016 # awk's $0
lines=$(echo "$written" | xargs awk 'length($0) > 100 { print FILENAME ":" FNR ": " length($0) " characters" }')
[ -z "$lines" ]
ok $? "no line of code over 100 characters" "$lines"

words=$(echo "$written" | xargs grep -n -w -E 'TODO|FIXME|XXX|HACK' || true)
[ -z "$words" ]
ok $? "no notes to self left in the code" "$words"

if git ls-files >/dev/null 2>&1; then
    changed=$(git ls-files -- '*.sh' '*.mk' Makefile .ci/run '*.[ch]' '*.cl' | git check-attr --stdin eol | grep -v ': lf$')
    [ -z "$changed" ]
    ok $? "a clone on Windows (core.autocrlf) keeps the ends of lines" "$changed"

    # Git for Windows ends a clone without a checkout where a path has other signs.
    odd=$(git ls-files -z | tr '\0\n' '\n\t' | LC_ALL=C grep -v '^[A-Za-z0-9._/-]*$' | cat -v)
    [ -z "$odd" ]
    ok $? "every path in the repository is made of A-Z, a-z, 0-9, '.', '_', '/' and '-'" "$odd"
fi

# The order and the lines of a JSON file are nobody's promise.
readers=$(grep -rnE '(^|[|({ ])(sed|awk|grep|tail|head|cut) [^|#]*[.]json' common tests/class tests/copies tests/demo.sh tests/handout \
    tests/systems tests/tools --include='*.sh' || true)
[ -z "$readers" ]
ok $? "scripts read JSON with jq" "$readers"

# The rooms of tests/class, each of which includes only rooms before it.
rooms="texts term exports folders entries grading people points pages ways_back"
later=$rooms upward=
for room in $rooms; do
    later=${later#*"$room"}
    # shellcheck disable=SC2086 # rooms are words
    headers=$(for above in $later; do find "tests/class/$above" -name '*.h' -printf '%f\n'; done)
    upward=$upward$(grep -n '^#include "' tests/class/"$room"/*.[ch] | grep -wF -e "${headers:-no header}")
done
[ -z "$upward" ] && [ "$(echo "$rooms" | tr ' ' '\n' | sort)" = "$(find tests/class -mindepth 1 -type d -printf '%f\n' | sort)" ]
ok $? "no room of tests/class includes one that comes after it" "$upward"

strays=$(find common kernels labs solutions slides-notes tests -name '*.o' -o -name '*.orig' -o -name '*~' -o -name 'a.out')
[ -z "$strays" ]
ok $? "nothing built beside a source" "$strays"

finish

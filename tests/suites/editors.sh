#!/bin/sh
# What editors are told: by .clangd and compile_flags.txt, clangd finds no fault in the course's sources, names one that
# is made, and nothing had to be built for it.
. tests/tap.sh

if ! command -v clangd >/dev/null; then
    skip "what clangd says" "clangd is not installed: common/setup/install.sh test-all"
    finish
    exit
fi

# faults FOLDER FILE...: what clangd says of each file of the course there, a line each: "FILE:LINE: message".
faults() {
    (
        cd "$1" && shift
        for file; do
            clangd --check="$file" --check-lines=1-1 2>&1 | sed -n \
                -e "s|^E\[[^]]*\] \[[^]]*\] Line \([0-9]*\): |$file:\1: |p" -e "s|^E\[[^]]*\] \(config error .*\)|$file: \1|p" \
                -e '/All checks completed/q'
        done
    )
}

# has_none FOLDER FILE...
has_none() {
    faults "$@" >"$scratch/faults"
    cat "$scratch/faults"
    [ ! -s "$scratch/faults" ]
}

# Without build/, as after a clone or in a handout: what students open, and what it includes.
course=$scratch/course
mkdir "$course"
cp -R .clangd compile_flags.txt common kernels labs solutions "$course"
for folder in labs $(quick "" solutions common kernels); do
    files=$(cd "$course" && find "$folder" -name '*.c' -o -name '*.h' -o -name '*.cl' | sort)
    # A header takes types from the file that includes it, and one is a list.
    files=$(echo "$files" | grep -v -x -e common/follow/steps/spheres.h -e common/setup/doctor_layouts.h)
    # shellcheck disable=SC2086 # a list of names without blanks
    check "no fault in $folder/" has_none "$course" $files
done

# A wrong kernel and a wrong file in C, in a lab: the fault, at its line; and those behind it.
lab=labs/09-shadows-and-mirrors
printf '#include "shade.cl"\n\nkernel void wrong(global float *d_values)\n{\n    d_values[0] = nowhere;\n}\n' >"$course/$lab/wrong.cl"
printf '#include "camera_from_view.h"\n#include "nowhere.h"\n' >"$course/$lab/header.c"
printf '#include "camera_from_view.h"\n\nint wrong(void)\n{\n    return 1\n}\n' >"$course/$lab/wrong.c"
faults "$course" "$lab/wrong.cl" "$lab/header.c" "$lab/wrong.c" >"$scratch/found"
check "a name that there is not, in a kernel" grep -q "wrong.cl:5: use of undeclared identifier 'nowhere'" "$scratch/found"
check "a header that there is not" grep -q "header.c:2: 'nowhere.h' file not found" "$scratch/found"
check "a semicolon that is missing" grep -q "wrong.c:[56]: expected ';'" "$scratch/found"
[ "$(wc -l <"$scratch/found")" -eq 3 ]
ok $? "and nothing else" "$(cat "$scratch/found")"

# What the check above would find if a line of .clangd were missing.
grep -v -e '-Isolutions/05' .clangd >"$course/.clangd"
check "without the folder of an earlier lab, its kernel is not found" \
    sh -c "$(command -v clangd) --check='$course/$lab/mirrors.cl' --check-lines=1-1 2>&1 | grep -q \"'shade.cl' file not found\""

# A new folder is one more line.
# unnamed FILE FOLDER...: the folders that a file does not name.
unnamed() {
    file=$1 && shift
    for folder; do
        grep -qxF -- "    - -I${folder%/}" "$file" || echo "$file: expected a line \"    - -I${folder%/}\""
    done >"$scratch/unnamed"
    cat "$scratch/unnamed"
    [ ! -s "$scratch/unnamed" ]
}
check ".clangd names each folder of solutions/" unnamed .clangd solutions/*/
# shellcheck disable=SC2046 # a list of names without blanks
check "tests/.clangd names each folder of tests/ with headers" unnamed tests/.clangd \
    $(find tests -name '*.h' -exec dirname {} + | sort -u)
! unnamed .clangd solutions/77-new >/dev/null
ok $? "and one that is missing is found"

quick_ends

# What authors write: of each folder the first file in C and the first header. Not parts of answers, which are no
# whole files, lists that others include, and what needs another compiler or a library that may be missing.
for kind in c h; do
    # shellcheck disable=SC2046 # a list of names without blanks
    check "no fault in tests/: *.$kind" has_none . $(find tests -name "*.$kind" | sort |
        grep -v -e '/\(stubs\|attacks\|native\|fuzz\)/' -e _known -e embree -e probe_stack -e test_builder_guard |
        awk '{ folder = $0; sub(/[^\/]*$/, "", folder) } !seen[folder]++')
done

finish

#!/bin/sh
# Print which files each lab's judge is made of: a line LAB:FILE for each source and header.
#
#     sh tests/judge/sources.sh JUDGE BUILDER...      in the course's top folder
#
# JUDGE is the folder tests/judge; BUILDERs are the solutions that judges may use. A judge is made of its lab's
# folder and of what that includes, directly or not. An included NAME.h brings NAME.c, and also NAME_more.c
# beside it, unless there is a NAME_more.h. common/ is a library, so its files are not listed.
set -eu
judge=$1
shift
headers=$(for builder; do printf '%s\n' "${builder%/*}"/*.h; done)
# shellcheck disable=SC2086 # a list of names without spaces
awk '
FNR == 1 {
    base = FILENAME
    sub(/.*\//, "", base)
    file_of[base] = FILENAME
}
/^#include "/ {
    split($0, part, "\"")
    sub(/.*\//, "", part[2])
    included[FILENAME] = included[FILENAME] " " part[2]
}

function folder_of(file) {
    sub(/\/[^\/]*$/, "", file)
    return file
}

# The header that a source implements, or "".
function header_of(source,    stem) {
    stem = source
    gsub(/.*\/|\.c$/, "", stem)
    while (!(stem ".h" in file_of)) {
        if (!sub(/_[^_]*$/, "", stem)) {
            return ""
        }
    }
    return folder_of(file_of[stem ".h"]) == folder_of(source) ? file_of[stem ".h"] : ""
}

# Take a file into a lab, with all that it needs.
function take(lab, file,    names, n, i) {
    if ((lab, file) in is_taken) {
        return
    }
    is_taken[lab, file]
    print lab ":" file
    n = split(included[file] sources_of[file], names)
    for (i = 1; i <= n; i++) {
        if (names[i] in file_of) {
            take(lab, file_of[names[i]])
        }
    }
}

END {
    for (base in file_of) {
        if (base ~ /\.c$/) {
            sources_of[header_of(file_of[base])] = sources_of[header_of(file_of[base])] " " base
        }
    }
    for (base in file_of) {
        if (base ~ /^judge_[0-9][0-9]\.c$/) {
            folder = lab = folder_of(file_of[base])
            sub(/.*\//, "", lab)
            for (other in file_of) {
                if (folder_of(file_of[other]) == folder) {
                    take(lab, file_of[other])
                }
            }
        }
    }
}' "$judge"/*.[ch] "$judge"/*/*.[ch] tests/grader/verdict/*.[ch] tests/probes/*.[ch] tests/probes/*/jobs_*.h "$@" $headers | sort

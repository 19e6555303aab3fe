#!/bin/sh
# Print the lines that a handout of a lab must not hold: those of the holes of its solution and of
# later ones.
#
#     tests/handout/solution_lines.sh HOLES-TOOL LAB
#
# A line is printed without its blanks. Left out is what says nothing: lines of fewer than 16 letters
# and digits, such as `return n_child_ids;` or `hit.t = t;`, and lines that stand in what is given
# anyway, in the skeletons, common/, kernels/ and the solutions of earlier labs.
set -eu

holes=$1
lab=$2

# The lines that are there for everybody, and the solutions of earlier labs.
given() {
    find common kernels -type f -name '*.[ch]*' -exec cat {} +
    for folder in solutions/*/; do
        for source in "$folder"*.[ch]*; do
            if is_earlier "$folder"; then cat "$source"; else "$holes" cut "$source"; fi
        done
    done
}

# Is a folder of solutions/ that of a lab before this one?
is_earlier() {
    name=$(basename "$1")
    [ "$name" != "$lab" ] && [ "$(printf '%s\n' "$name" "$lab" | sort | head -n 1)" = "$name" ]
}

answers() {
    for folder in solutions/*/; do
        is_earlier "$folder" && continue
        for source in "$folder"*.[ch]*; do
            for task in $("$holes" list "$source"); do
                "$holes" read "$source" "$task"
            done
        done
    done
}

{
    given | tr -d ' \t' | sed 's/^/given /'
    answers | sed 's|^ *//>.*||' | tr -d ' \t' | sed 's/^/answer /'
} | awk '
    { line = substr($0, index($0, " ") + 1) }
    /^given / { is_given[line]; next }
    { letters = line; gsub(/[^A-Za-z0-9]/, "", letters) }
    length(letters) >= 16 && !(line in is_given) && !(line in printed) { printed[line]; print line }'

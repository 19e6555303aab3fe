#!/bin/sh
# A verdict on what is there: one file that cannot be used costs its own tasks, and its name or its
# place is told.
#
#     sh tests/suites/staging.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/grading.sh

# points_beside LAB FILE: of the lab's tasks, those of this file aside.
points_beside() {
    "$build/tools/grade" --lab "$1" --list-checks |
        awk -F '\t' -v own=" $("$holes" list "solutions/$1/$2" | tr '\n' ' ')" \
            '!index(own, " " $2 " ") { sum += $3 } END { print sum + 0 }'
}

# ---- One file that cannot be used ---------------------------------------------------------------

file=implicit2DRenderer.cl
# shellcheck disable=SC2317 # called by make_unusable
as_text() { cat "solutions/$lab/$file"; }

# make_unusable KIND: put something else into the place of $file.
make_unusable() {
    copy_lab solutions "$lab"
    place=$scratch/submission/$file
    rm "$place"
    case $1 in
    link) ln -s "$PWD/solutions/$lab/$file" "$place" ;;
    folder) mkdir "$place" ;;
    utf-16) as_text | iconv -f UTF-8 -t UTF-16 >"$place" ;;
    nul) { as_text && printf '\0'; } >"$place" ;;
    large) { as_text && head -c 300000 /dev/zero | tr '\0' ' '; } >"$place" ;;
    empty) : >"$place" ;;
    esac
}

lab=01-naive-2d
while IFS='|' read -r kind reason; do
    make_unusable "$kind"
    # shellcheck disable=SC2046,SC2086 # options
    check "$kind: the other file counts" grades 1 40 $(kept $lab) $submission
    check "$kind: the report says why" stage Staging failed "$file: $reason"
    check "$kind: and what was done about it" holds \
        "$file: replaced by the file as it was handed out, so that your other files count"
    check "$kind: its tasks were not tried" test \
        "$(count_lines "\"message\": \"not tried: $file could not be used")" -eq 5
done <<'END'
missing|not in the submission
link|a symbolic link
folder|not a regular file
utf-16|found a text in UTF-16, expected a source text
nul|found a file of unknown kind
large|larger than the allowed 256 KB
empty|found an empty file, which counts as not handed in
END

# A file of every lab that has several.
for lab in $(quick 00-hello-pixels "$labs"); do
    files=$(cd "solutions/$lab" && grep -l '// TASK ' -- *.c *.cl 2>/dev/null)
    [ "$(echo "$files" | wc -l)" -gt 1 ] || continue
    file=$(echo "$files" | head -n 1)
    make_unusable missing
    points=$(points_beside "$lab" "$file")
    # shellcheck disable=SC2046,SC2086 # options
    check "$lab without $file gets the other $points" grades 1 "$points" $(kept "$lab") $submission
done

file=implicit2DRenderer.cl
quick_ends

# ---- One damaged marker ------------------------------------------------------------------------

lab=01-naive-2d
copy_lab solutions $lab
sed -i '/END own_pixel/d; $a no C at all' "$scratch/submission/$file"
# shellcheck disable=SC2046,SC2086 # options
check "a file that does not compile, with a marker that is gone, costs that task" \
    grades 1 80 $(kept $lab) $submission
check "which was not tried" \
    test "$(count_lines "not tried: $file does not compile, and without its markers")" -eq 2
check "and nothing is said of what was handed out" test "$(count_lines 'not written')" -eq 0

# ---- Characters that nobody sees ----------------------------------------------------------------

copy_lab solutions $lab
printf '\nint no\342\200\213body;\n' >>"$scratch/submission/$file"
line=$(wc -l <"$scratch/submission/$file")
# shellcheck disable=SC2046,SC2086 # options
check "a zero-width space outside of the markers costs nothing" \
    grades 0 100 $(kept $lab) $submission
check "and is named with its line" holds "$file:$line: a zero-width space, U+200B"

# ---- Names and places ---------------------------------------------------------------------------

lab=01-naive-2d
while IFS='|' read -r found score says; do
    copy_lab solutions $lab
    mkdir -p "$(dirname "$scratch/submission/$found")"
    mv "$scratch/submission/$file" "$scratch/submission/$found"
    status=$((score != 100))
    # shellcheck disable=SC2046,SC2086 # options
    check "$found: $score points" grades $status "$score" $(kept $lab) $submission
    check "$found: the report says why" grep -qF -- "$file: $says" "$said"
    # As an archive, it is the same.
    rm -f "$scratch/names.zip"
    (cd "$scratch/submission" && zip -q -r "$scratch/names.zip" .)
    # shellcheck disable=SC2046 # options
    check "$found in an archive: $score points" \
        grades $status "$score" $(kept $lab) --submission "$scratch/names.zip"
    check "$found in an archive: the report says why" grep -qF -- "$file: $says" "$said"
done <<'END'
implicit2DRenderer-1.cl|100|taken from "implicit2DRenderer-1.cl"
x/20261103102233_77_implicit2DRenderer.cl|100|taken from "x/20261103102233_77_implicit2DRenderer.cl"
Implicit2DRenderer.cl|40|not in the submission: found "Implicit2DRenderer.cl", expected the name
implicit2DRenderer.cl.txt|40|not in the submission: found "implicit2DRenderer.cl.txt", expected
.abgabe/implicit2DRenderer.cl|40|not in the submission: found it in ".abgabe", which is passed over
END

# Of several uploads of one name the last one counts, and that is said.
copy_lab solutions $lab
mv "$scratch/submission/$file" "$scratch/submission/implicit2DRenderer-10.cl"
cp "labs/$lab/$file" "$scratch/submission/implicit2DRenderer-9.cl"
# shellcheck disable=SC2046,SC2086 # options
check "of two uploads the later one counts" grades 0 100 $(kept $lab) $submission
check "and the report says which" grep -qF \
    'taken from "implicit2DRenderer-10.cl"; an earlier upload, which' "$said"

# ---- Archives beside other files ----------------------------------------------------------------

# packed TREE DAY ARCHIVE: the lab's files of labs or solutions, changed on that day of a month.
packed() {
    copy_lab "$1" $lab
    touch -d "2026-11-$2 12:00" "$scratch/submission"/*
    (cd "$scratch/submission" && zip -q "$scratch/class/$3" ./*.cl)
}

# in_class SCORE WORDS...: the folder "class" gets this, and the report says all of these.
# shellcheck disable=SC2317 # called by check
in_class() {
    wanted=$1
    shift
    # shellcheck disable=SC2046 # options
    grades $((wanted != 100)) "$wanted" $(kept $lab) --submission "$scratch/class" || return 1
    for words; do
        grep -qF -- "$words" "$said" || { echo "not said: $words"; return 1; }
    done
}

mkdir "$scratch/class"
echo '%PDF-1.4' >"$scratch/class/Bericht.pdf"
packed solutions 02 lab01.zip
check "an archive beside another file is opened" in_class 100 "$file: taken from lab01.zip"
check "and that file is named" \
    grep -qF 'handed in besides, and not looked at: "Bericht.pdf"' "$said"
packed labs 01 lab01_alt.zip
check "of two archives the newest file counts" in_class 100 \
    "$file: taken from lab01.zip; an older one, which does not count, is in lab01_alt.zip"
printf 'Rar!\032\007\001' >"$scratch/class/lab01.rar"
check "one that cannot be read costs nothing" in_class 100 "lab01.rar: found a RAR archive" \
    "$file: taken from lab01.zip"
cp "labs/$lab/$file" "$scratch/class"
check "a plain file comes before the archives" in_class 40 \
    "$file: taken from the folder; another one, which does not count, is in lab01.zip" \
    "overlaps_N_Nearer.cl: taken from lab01.zip"
cp "solutions/$lab"/*.cl "$scratch/class"
check "where all files are plain, no archive is opened" in_class 100 \
    "lab01.zip: not opened: each of the lab's files lies beside it, and counts"

# A plain file that cannot be used does not stand in the way of an archive.
iconv -f UTF-8 -t UTF-16 "solutions/$lab/$file" >"$scratch/class/$file"
check "a plain file that cannot be used is replaced by an archive's" in_class 100 \
    "$file: found a text in UTF-16" "$file: taken from lab01.zip instead"
check "and nothing is said to be taken before it is refused" \
    test "$(grep -c "$file: taken from the folder" "$said")" -eq 0

# ---- One file by itself -------------------------------------------------------------------------

for single in "$file" implicit2DRenderer-1.cl; do
    cp "solutions/$lab/$file" "$scratch/$single"
    # shellcheck disable=SC2046 # options
    check "$single by itself is that file of the lab" grades 1 60 $(kept $lab) --submission "$scratch/$single"
    check "$single: and the other one is missing" stage Staging failed "overlaps_N_Nearer.cl: not in the submission"
done
cp "solutions/$lab/$file" "$scratch/Implicit2DRenderer.cl"
# shellcheck disable=SC2046 # options
check "by a name that a student changed it is not taken" \
    grades 1 0 $(kept $lab) --submission "$scratch/Implicit2DRenderer.cl"
check "which is said" grep -qF 'found "Implicit2DRenderer.cl", expected the name implicit2DRenderer.cl' "$said"
cp "solutions/$lab/$file" "$scratch/answer.cl"
# shellcheck disable=SC2046 # options
check "another file by itself is not taken" grades 1 0 $(kept $lab) --submission "$scratch/answer.cl"
check "and it is said what was expected" stage Staging failed \
    "answer.cl: found a single text file, expected overlaps_N_Nearer.cl and implicit2DRenderer.cl in a folder, or in"

# An archive may be called like a file of the lab.
copy_lab solutions $lab
mkdir "$scratch/moodle"
(cd "$scratch/submission" && zip -q -r "$scratch/moodle/implicit2DRenderer.zip" .)
mv "$scratch/moodle/implicit2DRenderer.zip" "$scratch/moodle/implicit2DRenderer"
for handed_in in "$scratch/moodle/implicit2DRenderer" "$scratch/moodle"; do
    # shellcheck disable=SC2046 # options
    check "an archive without an ending is unpacked: ${handed_in##*/}" \
        grades 0 100 $(kept $lab) --submission "$handed_in"
done

# large_one: grade a file of 1 GB, and write none of more than 64 MB.
# shellcheck disable=SC2046,SC2317 # options; called by check
large_one() {
    truncate -s 1G "$scratch/$file" &&
        (ulimit -f 131072 && grades 1 0 $(kept $lab) --submission "$scratch/$file")
}
check "a large file by itself is refused" large_one
check "and was not copied" stage Staging failed "$file: larger than the allowed 256 KB"
rm "$scratch/$file"

# A class's links have names of their own.
printf 'Rar!\032\007\001' >"$scratch/lab01.rar"
ln -s "$scratch/lab01.rar" "$scratch/ada-cacd3bfac5f0e135"
# shellcheck disable=SC2046 # options
check "an archive is named as the student has named it" \
    grades 1 0 $(kept $lab) --submission "$scratch/ada-cacd3bfac5f0e135"
check "and not as the class calls it" stage Staging failed '"lab01.rar: found a RAR archive'

mkdir "$scratch/nothing"
# shellcheck disable=SC2046 # options
check "nothing usable gets nothing" grades 1 0 $(kept $lab) --submission "$scratch/nothing"
check "and the report says so" stage Staging failed "$file: not in the submission"
check "and nothing was compiled" test "$(count_lines '"title": "Compiling"')" -eq 0

finish

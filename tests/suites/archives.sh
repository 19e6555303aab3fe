#!/bin/sh
# What can be handed in: folders and archives as students, Moodle, Gradescope and GitHub make them,
# and hostile ones; each ends in marks or in a message to the student, never in the grader's fault.
#
#     sh tests/suites/archives.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh

build=${BUILD:-build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
lab=00-hello-pixels
course=$PWD

# Where the grader works; whatever it forgets there is seen at the end. Other users may enter, as
# what it runs is somebody else.
chmod 711 "$scratch"
mkdir -m 711 "$scratch/work"
export TMPDIR="$scratch/work"
reports=$scratch/reports
mkdir -p "$scratch/answers/00" "$scratch/answers/02"

# grade PATH: exits as the grader does. The solution's answers are kept: it need not run every time.
grade() {
    rm -rf "$reports"
    "$build/tools/grade" --build "$build" --output "$reports" --lab $lab --seed 5 \
        --answers "$scratch/answers/${lab%%-*}" --submission "$1" >"$scratch/said" 2>&1 </dev/null
}

# field NAME: a number of results.json's outermost level.
field() { sed -n "s/^  \"$1\": \([0-9]*\),\{0,1\}\$/\1/p" "$reports/results.json"; }

# What the first stage, staging, said to the student.
said() { sed -n 's/^      "message": "\(.*\)"$/\1/p' "$reports/results.json" | head -n 1; }

# earns SCORE PATH [WORDS]: is this the score, with these words about what was handed in, or none?
# shellcheck disable=SC2317 # called by check
earns() {
    status=0
    grade "$2" || status=$?
    cat "$scratch/said"
    [ "$status" -lt 2 ] && [ "$(field score)" -eq "$1" ] || return 1
    case $(said) in
    '') [ -z "${3:-}" ] ;;
    *"${3:-nothing}"*) ;;
    *) echo "found: $(said)"; return 1 ;;
    esac
}

# refuses PATH WORDS: no points, and a line for the student with the words, at most one a file?
# shellcheck disable=SC2317 # called by check
refuses() {
    status=0
    grade "$1" || status=$?
    cat "$scratch/said"
    [ "$status" -eq 1 ] || { echo "found exit status $status"; return 1; }
    [ "$(field score)" -eq 0 ] || return 1
    case $(said) in
    *'\n'*'\n'*) echo "more than two lines: $(said)"; return 1 ;;
    *"$2"*) ;;
    *) echo "found: $(said)"; return 1 ;;
    esac
}

# in_new_folder: go to an empty folder.
n_folders=0
in_new_folder() {
    n_folders=$((n_folders + 1))
    mkdir "$scratch/$n_folders"
    cd "$scratch/$n_folders" || exit 1
}

# the_answer FOLDER: all files of the lab, and some more, as a student works on them.
the_answer() {
    mkdir -p "$1"
    cp "$course/solutions/$lab"/* "$1"
}

# graded COMMAND...: check it from the course's top folder.
graded() {
    here=$PWD
    cd "$course" || exit 1
    check "$@"
    cd "$here" || exit 1
}

# ---- Kinds of archives --------------------------------------------------------------------------

# Of lab 02, which is graded without a kernel.
lab=02-kdtree-2d-build
in_new_folder
the_answer $lab
zip -q -r folder.zip $lab
zip -q -j flat.zip $lab/*
tar -cf plain.tar -C $lab .
tar -czf folder.tar.gz $lab
tar -cjf folder.tar.bz2 $lab
tar -cJf folder.tar.xz $lab
for archive in folder.zip flat.zip plain.tar folder.tar.gz folder.tar.bz2 folder.tar.xz; do
    graded "$archive gets full marks" earns 100 "$PWD/$archive"
done
cp folder.tar.gz named.zip
graded "the content counts, not the name" earns 100 "$PWD/named.zip"
chmod 600 folder.zip
graded "an archive that only the instructor may read is read" earns 100 "$PWD/folder.zip"

quick_ends

# ---- Shapes -------------------------------------------------------------------------------------

# Of lab 00, which has two files to find.
lab=00-hello-pixels
in_new_folder
the_answer course-main/labs/$lab
mkdir -p course-main/solutions
cp -r "$course/labs/$lab" course-main/solutions
mkdir -p course-main/.git course-main/build
cp "$course/labs/$lab/render.c" course-main/.git
cp "$course/labs/$lab/render.c" course-main/build
zip -q -r course-main.zip course-main
another='render.c: taken from \"course-main/labs/00-hello-pixels\"; a different one, which does not count, is in \"course-main/solutions/00-hello-pixels\"'
graded "GitHub's archive: labs/NN-name in a folder" earns 100 "$PWD/course-main.zip" "$another"
mkdir unpacked
mv course-main unpacked
graded "the same unpacked" earns 100 "$PWD/unpacked" "$another"
mv unpacked/course-main .
cp -r "$course/labs/$lab" skeleton
zip -q -r both.zip course-main skeleton
graded "fewer folders above win" earns 0 "$PWD/both.zip" \
    'taken from \"skeleton\"; a different one, which does not count, is in \"course-main/labs/00-hello-pixels\"'

in_new_folder
moodle='Jane Doe_123456_assignsubmission_file_'
the_answer answer
mkdir "$moodle"
(cd answer && zip -q -r "../$moodle/My Lab (final).zip" .)
graded "Moodle's folder with an archive in it" earns 100 "$PWD/$moodle"
graded "Moodle's folder with two files" earns 100 "$PWD/answer"

in_new_folder
the_answer submission_123456789
echo ':submissions: []' >submission_metadata.yml
graded "Gradescope's folder beside others' metadata" earns 100 "$PWD"

in_new_folder
the_answer 'Übung 1/Lösung'
mkdir -p '__MACOSX/Übung 1'
echo 'resource fork' >'__MACOSX/Übung 1/._render.c'
echo 'int resource_fork' >__MACOSX/render.c
zip -q -r mac.zip .
graded "macOS' archive, names with umlauts" earns 100 "$PWD/mac.zip"

in_new_folder
the_answer one
the_answer two
tar -czf equal.tar.gz one two
graded "the same files twice" earns 100 "$PWD/equal.tar.gz" \
    'gradient.cl: taken from \"one\"; the same is in \"two\"\nrender.c: taken'
echo '// later' >>two/render.c
tar -czf different.tar.gz one two
graded "two versions of a file" earns 40 "$PWD/different.tar.gz" \
    'render.c: found in \"one\" and, with another content, in \"two\": hand in only one'
tar -cf twice.tar -C "$course/labs" $lab
tar -rf twice.tar -C "$course/solutions" $lab/render.c $lab/gradient.cl
graded "two entries of one path: the last one counts" earns 100 "$PWD/twice.tar" \
    "render.c: 2 times in the archive as \\\"$lab/render.c\\\", with different contents: the last one counts"

# ---- What is no archive -------------------------------------------------------------------------

in_new_folder
expected='expected gradient.cl and render.c in a folder, or in a zip or tar archive'
while IFS='|' read -r file bytes kind; do
    # shellcheck disable=SC2059 # escapes on purpose
    printf "$bytes" >"$file"
    graded "$file: $kind" refuses "$PWD/$file" "$file: found $kind, $expected"
done <<'END'
answer.c|int main(void) { return 0; }|a single text file
answer.rar|Rar!\032\007\001|a RAR archive
END
mkdir word
echo '<Types/>' >word/'[Content_Types].xml'
(cd word && zip -q ../answer.docx '[Content_Types].xml')
graded "a document" refuses "$PWD/answer.docx" "answer.docx: found an office program's document"
mkfifo fifo
graded "a FIFO" refuses "$PWD/fifo" "fifo: neither a folder nor an archive"

# ---- Hostile and broken archives ----------------------------------------------------------------

in_new_folder
the_answer $lab
zip -q -r -P secret encrypted.zip $lab
graded "an encrypted archive" refuses "$PWD/encrypted.zip" \
    "encrypted.zip: the archive is encrypted: hand it in without a password"
zip -q -r whole.zip $lab
head -c 3000 whole.zip >cut.zip
graded "a zip archive that is cut off" refuses "$PWD/cut.zip" "zip archive that is damaged or cut"
# Compressed a little only, so that the first entry is there whole.
tar -cf - $lab | gzip -1 >whole.tar.gz
head -c 4000 whole.tar.gz >cut.tar.gz
graded "a tar archive that is cut off" refuses "$PWD/cut.tar.gz" "cut off"
head -c 65536 /dev/urandom >garbage.zip
graded "garbage" refuses "$PWD/garbage.zip" "garbage.zip: found "
zip -q nested.zip whole.zip
graded "an archive in an archive is not opened" refuses "$PWD/nested.zip" \
    "nested.zip: the archive holds another one, whole.zip, and none of the lab's files"

in_new_folder
the_answer labs
rm labs/render.c
ln -s "$course/solutions/$lab/render.c" labs/render.c
zip -q -r -y link.zip labs
graded "a link in an archive" earns 40 "$PWD/link.zip" "render.c: a symbolic link"
rm labs/render.c
ln labs/gradient.cl labs/render.c
# In this order, whatever a folder lists first: the second name of a file is the link.
tar -czf hard.tar.gz labs/gradient.cl labs/render.c
graded "a hard link in an archive" earns 40 "$PWD/hard.tar.gz" "render.c: a symbolic link"

lab=02-kdtree-2d-build
in_new_folder
the_answer x
mkdir target
tar -P -cf upwards.tar --transform "s,^x,../../../../../../../..$PWD/target," x
graded "paths that lead upwards" refuses "$PWD/upwards.tar" "not in the submission"
tar -P -cf absolute.tar --transform "s,^x,$PWD/target," x
graded "absolute paths are taken from the archive's top" earns 100 "$PWD/absolute.tar"
check "nothing was written there" test -z "$(ls -A target)"
long=$(printf '%0255d' 0)
mkdir "$long" "new
line"
the_answer "$long/new
line"
tar -czf odd.tar.gz "$long"
graded "a name of 255 bytes and one of two lines" earns 100 "$PWD/odd.tar.gz"

# Bombs, bounded: what unpacks to 100 MB, says that it would to 600, holds 131072 entries.
lab=00-hello-pixels
in_new_folder
the_answer x
rm x/render.c
head -c 104857600 /dev/zero >x/render.c
(cd x && zip -q ../zeros.zip render.c gradient.cl)
rm x/render.c
check "a bomb is small" test "$(wc -c <zeros.zip)" -lt 200000
graded "a zip of zeros" earns 40 "$PWD/zeros.zip" "render.c: larger than the allowed 256 KB"
truncate -s 600M x/video
tar -czSf sparse.tar.gz x
graded "an archive of 600 MB" refuses "$PWD/sparse.tar.gz" "more than 512 MB, unpacked"
truncate -s 65M large.zip
graded "a file of 65 MB" refuses "$PWD/large.zip" "large.zip: larger than the allowed 64 MB"
: >entry
tar -cf entry.tar entry
head -c 512 entry.tar >entries.tar
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17; do
    cat entries.tar entries.tar >twice.tar
    mv twice.tar entries.tar
done
tar -cf answer.tar -C "$course/solutions" $lab
cat entries.tar answer.tar | gzip -1 >many.tar.gz
rm entries.tar
graded "an archive of 131072 entries" earns 100 "$PWD/many.tar.gz"

# ---- The grader's own faults --------------------------------------------------------------------

cd "$course" || exit 1
mkdir -p "$scratch/build/tools"
for entry in "$build"/*; do
    [ "${entry##*/}" = tools ] || ln -s "$entry" "$scratch/build"
done
status=0
"$build/tools/grade" --build "$scratch/build" --output "$reports" --lab $lab \
    --submission "$scratch/1/plain.tar" >"$scratch/said" 2>&1 || status=$?
ok $((status != 2)) "without its tool the grader says that it cannot work" "$(cat "$scratch/said")"
check "and names the tool" grep -q 'tools/unpack: cannot be copied: No such file' "$scratch/said"
# What reads an archive is not believed: where it works over another one, the archive is at fault.
cat >"$scratch/build/tools/unpack" <<'SH'
#!/bin/sh
[ "$1" = /dev/null ] && exit 1
exit 2
SH
chmod 755 "$scratch/build/tools/unpack"
status=0
"$build/tools/grade" --build "$scratch/build" --output "$reports" --lab $lab \
    --submission "$scratch/1/plain.tar" >"$scratch/said" 2>&1 || status=$?
ok $((status != 1)) "an archive over which the tool says that it cannot work is refused" \
    "$(cat "$scratch/said")"
check "and the report says so" grep -q 'plain.tar: the archive is damaged, unpacking it fails' "$reports/results.json"
check "nothing stays behind in TMPDIR" test -z "$(ls -A "$TMPDIR")"

finish

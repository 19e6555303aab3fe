#!/bin/sh
# What make finds out: that a header has changed, also one saved while a compiler runs.
# And that a lab is its folders: one that is made up, lab 01 under another number, is built, graded and tried
# without a line changed elsewhere: in a copy of the course, which is removed with the suite.
. tests/tap.sh

# ---- A header of which make must know ------------------------------------------------------------

# A folder for the course in which headers may change.
top=$PWD
mkdir "$scratch/top" && cd "$scratch/top" && ln -s "$top"/* . && rm -f common build && cp -pR "$top/common" common || exit 1
cat >"$scratch/compiler" <<'END'
#!/bin/sh
# It has read the header, and writes the object last.
gcc "$@" || exit
echo '// saved' >>common/path.h
for object; do :; done
touch "$object"
END
chmod +x "$scratch/compiler"
is_old() { make -q "$1" >/dev/null 2>&1; [ $? -eq 1 ]; }
for object in build/obj/common/path.c.o build/native/obj/common/path.c.o; do
    check "$object: made while its header is saved" make -s CC="$scratch/compiler" "$object"
    check "it is old" is_old "$object"
    check "it is made again" make -s "$object"
    check "and is new" make -q "$object"
    echo '// saved' >>common/path.h
    check "until its header changes" is_old "$object"
done
cd "$top" || exit 1

# ---- A lab that is made up -----------------------------------------------------------------------

if [ -n "${QUICK:-}" ]; then
    skip "a lab that is made up" "building it takes a minute: make test-all"
    finish
    exit
fi

. tests/course_copy.sh  # so that only the new lab is compiled

# From lab 01's folders, files and names.
for folder in solutions tests/judge tests/probes tests/known tests/stubs; do
    cp -R $folder/01-naive-2d $folder/11-made-up
done
for file in tests/*/11-made-up/*_01*; do
    mv "$file" "$(echo "$file" | sed 's/_01/_11/')"
done
find solutions/11-made-up tests/*/11-made-up -type f -exec sed -i \
    's/_01\b/_11/g; s/_01_/_11_/g; s/OverlapJob/NewJob/g; s/Job01/Job11/g; s/01-naive-2d/11-made-up/g; s/lab 01/lab 11/g' {} +

# scores POINTS [SUBMISSION=FOLDER]: does make grade say so?
scores() {
    points=$1
    shift
    make -s grade LAB=11 "$@" 2>&1 | tee grade.log | grep -qx " Score $points/100" || { cat grade.log; return 1; }
}
check "its skeleton is cut" make -s skeletons
check "its programs are built" make -s build/labs/11-made-up build/solutions/11-made-up
check "it draws" build/solutions/11-made-up --size 64x48 --output picture.png
check "its skeleton has no points" scores 0
check "its solution has all" scores 100 SUBMISSION=solutions/11-made-up
check "its known answers can be tried" make -s native
LAB=11 sh tests/suites/native.sh >answers.log 2>&1
ok $? "each is judged as it should be" "$(grep -A 3 '^not ok' answers.log)"
n_answers=$(cat tests/known/11-made-up/* | grep -cE '^(wrong|right) ')
[ "$(grep -c '^ok .*11-made-up/' answers.log)" -eq "$n_answers" ]
ok $? "all $n_answers of them" "$(tail -n 3 answers.log)"

finish

#!/bin/sh
# Grade one submission of a class into a folder of its own, which appears whole or not at all.
#
#     tests/class/grading/grade_one.sh SLUG
#
# grade_class.sh sets CLASS_FOLDER, CLASS_BUILD, CLASS_LAB, CLASS_WORK and more, and runs this
# through GNU parallel or Slurm, from the course's top folder. The key and the seed are in
# CLASS_FOLDER/keys: other users of the machine, and runs in the sandbox "user", see command lines.
# Exit status 0 when there is a result,
# 1 when the machinery failed: then CLASS_FOLDER/faults/SLUG says how. Read first: grade_class.sh.
set -u

slug=$1
students=$CLASS_FOLDER/students
new=$students/$slug.new
# What the grader makes while it works; of a grading that was killed, everything is in here. Only the
# whole slug is unique: whoever shares a folder with another clears it under their feet.
work=$CLASS_WORK-$slug
log=$CLASS_FOLDER/logs/$slug.txt

# clear FOLDER: what its last processes still write may come in between.
clear() {
    rm -rf "$1" 2>/dev/null || { sleep 0.2 && rm -rf "$1"; }
}

# fail REASON: what the gradebook says instead of a score.
fail() {
    echo "$1" >"$CLASS_FOLDER/faults/$slug.new"
    mv "$CLASS_FOLDER/faults/$slug.new" "$CLASS_FOLDER/faults/$slug"
    exit 1
}

clear "$new"
clear "$work"
trap 'clear "$work"; clear "$new"' EXIT
trap 'exit 1' INT TERM
if ! { mkdir "$new" && mkdir -m 711 "$work"; } 2>"$log"; then
    fail "no folder to work in"
fi

key='' seed=''
while read -r of its_key its_seed; do
    [ "$of" != "$slug" ] || key=$its_key seed=$its_seed
done <"$CLASS_FOLDER/keys"
[ -n "$key" ] || fail "it has no key"
# A slug is of small letters, digits and dashes.
name=$(sed -n "s/^$slug	//p" "$CLASS_FOLDER/names")

# The grader must end with this script and this script with the driver, however they end. It does
# not inherit the driver's lock.
status=0
# shellcheck disable=SC2016 # for the inner shell
TMPDIR=$work setpriv --pdeathsig KILL timeout --foreground --kill-after=5 "$CLASS_SECONDS" \
    sh -c 'exec setpriv --pdeathsig KILL "$@" 9<&-' grade \
    "$CLASS_BUILD/tools/grade" --build "$CLASS_BUILD" --lab "$CLASS_LAB" --read-seed \
    --student "$name" \
    --submission "$CLASS_FOLDER/submissions/$slug" --output "$new" ${CLASS_DEVICE:+--device "$CLASS_DEVICE"} \
    ${CLASS_MANIFEST:+--manifest "$CLASS_MANIFEST"} \
    --answers "$CLASS_FOLDER/answers" ${CLASS_TIME_LIMIT:+--time-limit "$CLASS_TIME_LIMIT"} \
    >"$log" 2>&1 <<END || status=$?
$seed
END

case $status in
0 | 1) ;;
2) fail "the grader could not work" ;;
124) fail "the grader took longer than $CLASS_SECONDS s" ;;
129 | 13? | 14? | 15?) fail "the grader was killed by signal $((status - 128))" ;;
*) fail "the grader ended with status $status" ;;
esac
echo "$key" >"$new/key"
# Killed between these two, it is graded again.
rm -rf "${students:?}/$slug"
mv "$new" "$students/$slug" || fail "its folder cannot be put in place"
rm -f "$CLASS_FOLDER/faults/$slug" "$CLASS_FOLDER/pending/$slug"
[ -z "$CLASS_TELLS" ] || printf '  %s:%s\n' "$name" "$(sed -n 's/^ Score//p' "$log")"
rm -f "$log"

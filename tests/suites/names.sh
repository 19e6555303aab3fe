#!/bin/sh
# A name is a name: whatever is in it, make and our scripts hand it on as it is, and run nothing of it.
# shellcheck disable=SC2016,SC2089,SC2090,SC2317 # signs that nothing expands; checks called by `arrived`
. tests/tap.sh
. tests/grading.sh
top=$PWD
trap_file=$top/names-trap
rm -f "$trap_file"
trap 'rm -rf "$scratch" "$trap_file"' EXIT

# The last part leaves a file in the top folder, if make or a shell takes it for more than signs.
hostile='-a  b$(shell touch names-trap)${HOME}$$`touch names-trap`$(touch names-trap)"; touch names-trap; '"'; touch names-trap; "' #&|<>*?%~\=:,
é'

# makes STATUS ARGUMENT...: does make end so? What it says is in $said.
makes() {
    wanted_status=$1 status=0
    shift
    make --no-print-directory "$@" >"$said" 2>&1 </dev/null || status=$?
    [ "$status" -eq "$wanted_status" ] || { cat "$said"; echo "found exit status $status"; return 1; }
}

# both_ways WHAT STATUS VARIABLE TEXT ARGUMENT...: make, told VARIABLE on its command line and in the
# environment; afterwards `holds_on`, which a part below defines, says whether the text has arrived.
both_ways() {
    what=$1 wanted=$2 variable=$3 text=$4
    shift 4
    check "$what: $variable, from the command line" makes "$wanted" "$@" "$variable=$text"
    arrived
    check "$what: $variable, from the environment" env_makes "$wanted" "$@"
    arrived
}
env_makes() (
    export "$variable=$text"
    makes "$@"
)
arrived() {
    check "it arrives as it is" holds_on
    [ ! -e "$trap_file" ]
    ok $? "and nothing of it is run"
    rm -f "$trap_file" "$scratch/arguments"
}

# ---- What programs are given ----------------------------------------------------------------------

# In the places of our programs: they write down what they are given, an argument a line.
fake=$scratch/fake
mkdir -p "$fake/tools"
for program in grade memcheck; do
    printf '#!/bin/sh\nprintf "<%%s>\\n" "$@" >"%s"\n' "$scratch/arguments" >"$fake/tools/$program"
    chmod +x "$fake/tools/$program"
done
given() { grep -qzF -- "<$text>" "$scratch/arguments" || { cat "$scratch/arguments"; return 1; }; }
holds_on() { given; }

for variable in SUBMISSION SEED DEVICE TIME_LIMIT; do
    both_ways "make grade" 0 $variable "$hostile" --old-file=graded grade BUILD="$fake" LAB=00
done
both_ways "make grade" 0 LAB "$hostile" --old-file=graded grade BUILD="$fake"
quick_ends

for variable in SUBMISSION SEED TIME_LIMIT; do
    both_ways "make memcheck" 0 $variable "$hostile" --old-file=graded --old-file=memcheck-libraries --old-file="$fake/tools/memcheck" memcheck BUILD="$fake" LAB=00
done

# The words of OPTIONS are told apart as a shell does, by blanks and quotes; signs are signs.
scene='$(shell touch names-trap) `touch names-trap` $(touch names-trap);touch names-trap;#&|<>*?%~,.csv'
mkdir "$scratch/scenes"
printf 'x,y,radius,depth,r,g,b\n3,3,2,0.5,1,0,0\n' >"$scratch/scenes/$scene"
holds_on() { grep -q 'at step\|written to' "$said" || { cat "$said"; return 1; }; }
both_ways "make pixel" 0 OPTIONS "--size 8x8 --scene \"$scratch/scenes/$scene\"" pixel BUILD="$build" LAB=03 AT=3,3 SOLUTION=1
holds_on() { grep -qF "found \"$text\", expected X,Y" "$said" || { cat "$said"; return 1; }; }
both_ways "make pixel" 2 AT "-1,$scene" pixel BUILD="$build" LAB=03 SOLUTION=1

# What a lab's name is looked for in.
holds_on() { grep -qzF "found LAB=\"$text\", expected" "$said" || { cat "$said"; return 1; }; }
for target in pixel view movie lab-grader; do
    both_ways "make $target" 2 LAB "$hostile" $target BUILD="$build" AT=1,1
done
holds_on() { grep -qzF "found \"$text\"" "$said" || grep -qzF "and \"$text\"" "$said" || { cat "$said"; return 1; }; }
for target in pack gradescope autolab prairielearn github gitlab vpl grade-class copies; do
    both_ways "make $target" 2 LAB "$hostile" $target BUILD="$build" SUBMISSIONS="$scratch"
done

# ---- Real gradings --------------------------------------------------------------------------------

# A folder of this name is graded, and one whose whole path begins with a minus.
mkdir "$scratch/class"
cp -R solutions/00-hello-pixels "$scratch/class/$hostile"
holds_on() { grep -q '^ Score  *100/100' "$said" || { cat "$said"; return 1; }; }
both_ways "make grade" 0 SUBMISSION "$scratch/class/$hostile" grade BUILD="$build" LAB=00 SEED=5

# A class: its folder, what comes out, Moodle's and the older list, and what an instructor decides have such names.
cp -R "$scratch/class" "$scratch/$hostile"
moodle=$scratch/moodle$hostile.csv
printf 'Identifier,Full name,Grade,Maximum Grade\nParticipant 1,Ada,,100\n' >"$moodle"
echo entry,student >"$scratch/who$hostile"
echo student,task,points >"$scratch/changes$hostile"

# class STATUS VARIABLE=VALUE...: of make, which says 2 where the list has nobody of this name.
class() {
    status=$1
    shift
    makes "$status" grade-class BUILD="$build" LAB=00 SEED=5 "$@"
}
check "a class of such names" class 2 SUBMISSIONS="$scratch/$hostile" OUTPUT="$scratch/out$hostile" MOODLE="$moodle" \
    WHO="$scratch/who$hostile" CHANGES="$scratch/changes$hostile"
check "everybody is graded" grep -q ',100,100,' "$scratch/out$hostile/gradebook.csv"
cp "$scratch/out$hostile/gradebook.json" "$scratch/older$hostile"
check "by a list of corrections" grep -q '"score before"' "$scratch/out$hostile/gradebook.csv"
check "and compared" class 0 SUBMISSIONS="$scratch/$hostile" OUTPUT="$scratch/out$hostile" AGAINST="$scratch/older$hostile"
check "answers that are alike" makes 0 copies BUILD="$build" LAB=00 SUBMISSIONS="$scratch/$hostile" OUTPUT="$scratch/alike$hostile" EXPORT=moss
check "are written where they should be" test -s "$scratch/alike$hostile/copies.html"
holds_on() { grep -qzF "found \"$text\", expected jplag, dolos or moss" "$said" || { cat "$said"; return 1; }; }
both_ways "make copies" 2 EXPORT 'x$(touch names-trap)`touch names-trap`"; touch names-trap' copies BUILD="$build" LAB=00 \
    SUBMISSIONS="$scratch/class" OUTPUT="$scratch/alike"
# In the top folder such names begin with a minus, as options do.
cp -R "$scratch/class" "$top/$hostile"
cp "$moodle" "$top/$hostile.csv"
cp "$scratch/who$hostile" "$top/$hostile.who"
cp "$scratch/changes$hostile" "$top/$hostile.changes"
trap 'rm -rf "$scratch" "$trap_file" "./$hostile" "./$hostile.csv" "./$hostile.who" "./$hostile.changes" "./$hostile.out" "./$hostile.tar"' EXIT
check "and where they are looked for from here" class 2 SUBMISSIONS="$hostile" OUTPUT="$hostile.out" LIST="$hostile.csv" \
    WHO="$hostile.who" CHANGES="$hostile.changes"
check "all is graded, too" grep -q ',100,100,' "./$hostile.out/gradebook.csv"
(cd solutions/00-hello-pixels && tar -cf "$top/$hostile.tar" .)
check "an archive whose name begins so" grades 0 100 --lab 00 --submission "$hostile.tar" --seed 5
[ ! -e "$trap_file" ]
ok $? "nothing of all these names is run"

# ---- Every variable there is ----------------------------------------------------------------------

# All that makefiles take from outside, at once, each with a trap of its own; and every target of `make help`.
outside=$(make -s --eval='outside:;@echo $(filter-out BUILD,$(FROM_OUTSIDE))' outside)
targets=$(make -s help | sed -n 's/^  make \([a-z-]*\) .*/\1/p' | grep -v '^clean$')
# dry_run WAY LAB: nothing is made; lines with a + are run all the same.
dry_run() (
    set -- "$1" "LAB=$2"
    for variable in $outside; do
        [ "$variable" = LAB ] || set -- "$@" "$variable=\$(shell touch names-trap-$variable)"
    done
    way=$1
    shift
    # shellcheck disable=SC2086 # a list of targets
    case $way in
    line) make --dry-run --keep-going $targets BUILD="$build" "$@" ;;
    environment) env "$@" BUILD="$build" make --dry-run --keep-going $targets ;;
    esac >"$said" 2>&1 </dev/null
    find . -maxdepth 1 -name 'names-trap*' | grep .
)
for way in line environment; do
    for lab in 03 '$(shell touch names-trap-LAB)'; do
        found=$(dry_run $way "$lab")
        [ -z "$found" ] && grep -q 'tools/grade' "$said"
        ok $? "make expands no variable from outside ($way, LAB=$lab)" "$found"
        rm -f names-trap*
    done
done
makes 2 help BUILD='x$(shell touch names-trap)' && [ ! -e "$trap_file" ] && grep -q '^Makefile:.*BUILD: found ' "$said"
ok $? "a build folder with such a name is refused"

finish

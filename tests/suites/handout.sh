#!/bin/sh
# What students get: make handout packs no file of the lab's solution or of a later one, the same bytes
# every time, and what comes out builds and grades by itself, with the instructor's scores.
. tests/tap.sh

build=${BUILD:-build}
course=$PWD
labs=$(cd solutions && printf '%s\n' */ | tr -d /)

if ! why=$(sh common/setup/checkout.sh); then
    skip "handouts" "$why"
    finish
    exit
fi

# `make test` packs one lab.
[ -z "${QUICK:-}" ] || labs=02-kdtree-2d-build

# pack LAB FOLDER: says nothing.
pack() {
    tests/handout/pack.sh "$build/tools" "$1" "$2" >/dev/null
}

case $build in /*) ;; *) build=$PWD/$build ;; esac

# ---- The archives -------------------------------------------------------------------------------

# In another place, at another time, for another user: the same bytes.
same_bytes() {
    pack "$1" "$scratch/first" || return 1
    (
        umask 077
        mkdir -p "$scratch/other place"
        chmod 711 "$scratch" "$scratch/other place"  # what the grader runs there is another user
        TMPDIR="$scratch/other place" LC_ALL=C TZ=Asia/Kolkata TAR_OPTIONS='--exclude=*.md' pack "${1%%-*}" "$scratch/second"
    ) || return 1
    cmp "$scratch/first/$1.tar.gz" "$scratch/second/$1.tar.gz"
}

# A lab.json laid out in another way is the same: nothing but itself differs in the handout. laid_out LAB OPTION...
laid_out() {
    lab=$1 copy=$scratch/laid-out git=$(git rev-parse --absolute-git-dir)
    shift
    rm -rf "$copy" "$scratch/third" "$scratch/unpacked"
    mkdir "$copy" "$scratch/unpacked" "$scratch/unpacked/first" "$scratch/unpacked/third"
    git ls-files -z | tar --null --files-from=- -cf - | tar -xf - -C "$copy"
    for manifest in labs/*/lab.json solutions/*/lab.json; do jq "$@" . "$manifest" >"$copy/$manifest"; done
    (cd "$copy" && GIT_DIR=$git GIT_WORK_TREE=$copy pack "$lab" "$scratch/third") || return 1
    for folder in first third; do tar -xzf "$scratch/$folder/$lab.tar.gz" -C "$scratch/unpacked/$folder"; done
    rm "$scratch"/unpacked/*/"$lab"/labs/*/lab.json
    rm -rf "$scratch"/unpacked/*/"$lab"/solutions/*/lab.json
    diff -r "$scratch/unpacked/first" "$scratch/unpacked/third"
}

# Every file but the README, the skeleton and the packed judge is one of the course, and none is from
# this lab's solution or later labs, nor has such a file's content under another name.
only_its_files() {
    (cd "$1" && find . -type f) | sed 's|^\./||' | sort >"$scratch/files"
    git ls-files | sort >"$scratch/tracked"
    strays=$(comm -23 "$scratch/files" "$scratch/tracked" | grep -v -x -e tests/judge/judge.tar -e "tests/skeletons/$2/[^/]*")
    [ -z "$strays" ] || { echo "not tracked: $strays"; return 1; }
    strays=$(grep '^tests/' "$scratch/files" | grep -v -e '^tests/grader/' -e "^tests/probes/$2/" \
        -e '^tests/desk/' -e '^tests/probes/[^/]*\.[ch]$' -e '^tests/probes/no_macros.sh$' \
        -e '^tests/probes/[^/]*/jobs_[0-9]*\.h$' -e "^tests/stubs/$2/" -e "^tests/skeletons/$2/" \
        -e '^tests/judge/judge.tar$' -e '^tests/judge/judge.mk$' -e '^tests/memcheck/[a-z_]*\.\([ch]\|mk\)$' \
        -e '^tests/native/' \
        -e '^tests/scenes/' -e '^tests/GRADING.md$' -e '^tests/bench/RESULTS.md$')
    [ -z "$strays" ] || { echo "not expected: $strays"; return 1; }
    grep -q '^.gitattributes$' "$scratch/files" || { echo "git may change its ends of lines"; return 1; }
    sed 's/^[0-9]* //' "$scratch/first/$2.txt" | LC_ALL=C sort | diff - "$scratch/files" ||
        { echo "the list beside the archive is another"; return 1; }
    strays=$(sed -n -E 's/^common.follow.(steps.)?([0-9]{2}-[^.]*).*/\2/p' "$scratch/files" | awk -v lab="$2" '$0 > lab')
    [ -z "$strays" ] || { echo "follows later labs: $strays"; return 1; }
    later=
    for lab in $(cd solutions && printf '%s\n' */ | tr -d /); do
        if [ "$lab" = "$2" ]; then
            grep -q "^labs/$lab/README.md$" "$scratch/files" || { echo "labs/$lab is missing"; return 1; }
            later=yes
        elif grep "^labs/$lab/" "$scratch/files"; then
            echo "expected nothing in labs/$lab"
            return 1
        fi
        if [ -n "$later" ]; then
            ! grep "^solutions/$lab/" "$scratch/files" || return 1
        else
            grep -q "^solutions/$lab/lab.json$" "$scratch/files" || { echo "solutions/$lab is missing"; return 1; }
        fi
    done
}

# no_solution FOLDER LAB: is no file the same as one that has answers, of the lab's solution or of later ones?
no_solution() {
    (cd solutions && printf '%s\n' */*.[ch]*) | awk -v lab="$2" '$0 >= lab' | while IFS= read -r file; do
        if grep -q '// TASK' "solutions/$file"; then cksum <"solutions/$file"; fi
    done >"$scratch/sums"
    [ -s "$scratch/sums" ] || { echo "no sums to look for"; return 1; }
    find "$1" -type f -exec cksum {} + | grep -F -f "$scratch/sums" || return 0
    return 1
}

# judged FOLDER LAB: has it the judge of its lab, no other's, and needs that no solution that is not in it?
judged() {
    tar -tf "$1/tests/judge/judge.tar" >"$scratch/packed" || return 1
    grep -qx "$2/judge_${2%%-*}.c" "$scratch/packed" && ! grep '/judge_[0-9][0-9]\.c$' "$scratch/packed" | grep -v "^$2/" || return 1
    # shellcheck disable=SC2046 # a list of names without spaces
    sh tests/judge/sources.sh tests/judge $(printf '%s\n' solutions/*/*.c | grep -v main.c) | sed -n "s|^$2:||p" >"$scratch/needed"
    grep '^solutions/' "$scratch/needed" | while IFS= read -r file; do
        [ -e "$1/$file" ] || { echo "needs $file"; return 1; }
    done
}

# Every link that is not of the web, and every picture, leads to a file; and to a heading, where it
# names one.
links() {
    (cd "$1" && find . -name '*.md') | while IFS= read -r page; do
        grep -o '](\([^)]*\))' "$1/$page" | sed 's/^](//; s/)$//' | while IFS= read -r link; do
            case $link in *://*) continue ;; esac
            target=$1/$(dirname "$page")/${link%%#*}
            [ -n "${link%%#*}" ] || target=$1/$page
            [ -e "$target" ] || echo "$page: $link leads nowhere"
            case $link in *#*)
                sed -n 's/^##* //p' "$target" | tr 'A-Z ' 'a-z-' | tr -d '?' | grep -qx -- "${link#*#}" ||
                    echo "$page: no heading for $link"
                ;;
            esac
        done
    done >"$scratch/dangling"
    cat "$scratch/dangling"
    [ ! -s "$scratch/dangling" ]
}

# finished FOLDER: are earlier solutions without the authors' placeholders, and does the README name their
# folder where there is one?
finished() {
    ! grep -rn '^ *//>' "$1/solutions" 2>/dev/null || return 1
    named=no
    ! grep -q 'labs before' "$1/README.md" || named=yes
    [ "$named" = "$([ -d "$1/solutions" ] && echo yes || echo no)" ] || { echo "labs before: $named"; return 1; }
}

# contained FOLDER: are the files of its container there, and does it get what a handout needs?
contained() {
    [ -f "$1/.devcontainer/$(jq -r .build.dockerfile "$1/.devcontainer/devcontainer.json")" ] || return 1
    ! grep demo "$1/Containerfile" && grep -qx 'RUN common/setup/install.sh grade view editor' "$1/Containerfile"
}

# run_by_editor FOLDER: has it the tasks of VS Code?
run_by_editor() { jq -e '.tasks | length == 2' "$1/.vscode/tasks.json"; }

# edited FOLDER: does clangd, by what the handout tells it, find no fault in the lab's files?
edited() {
    find "$1/labs" -name '*.[ch]*' >"$scratch/sources"
    while IFS= read -r file; do
        clangd --check="$file" --check-lines=1-1 >"$scratch/said" 2>&1 || { grep '^E' "$scratch/said"; return 1; }
    done <"$scratch/sources"
    [ -s "$scratch/sources" ]
}

# The commands that its READMEs name: does make know each target?
commands() {
    grep -h -o 'make [A-Za-z][A-Za-z0-9_/=. -]*' "$1/README.md" "$1/labs/$2/README.md" |
        sed 's/ -.*//; s/[. ]*$//' | sort -u | while IFS= read -r words; do
        case $words in
        make\ setup | make\ help | make\ grade* | make\ *build/*) ;;
        *) continue ;;
        esac
        # shellcheck disable=SC2086 # the words of a command
        alone "$1" $words --dry-run >"$scratch/said" 2>&1 || { echo "$words:"; cat "$scratch/said"; }
    done >"$scratch/unknown"
    cat "$scratch/unknown"
    [ ! -s "$scratch/unknown" ]
}

# counts FOLDER LAB: would the first make grade say each step once, from 1 to the number that it says there are?
counts() {
    alone "$1" make --dry-run grade LAB="${2%%-*}" >"$scratch/said" 2>&1 || { tail -n 5 "$scratch/said"; return 1; }
    sed -n "s/.*printf '[^']*' 'building the course once: \([0-9]* of [0-9]*\)'.*/\1/p" "$scratch/said" >"$scratch/steps"
    n_steps=$(wc -l <"$scratch/steps")
    seq -f "%g of $n_steps" 1 "$n_steps" | diff - "$scratch/steps" && [ "$n_steps" -gt 50 ]
}

# helps FOLDER LAB: does make help list no target for which its lab has nothing? And is what to hand in named?
helps() {
    alone "$1" make help >"$scratch/said"
    for target in pixel view; do
        status=0
        alone "$1" make -s --dry-run $target LAB="${2%%-*}" AT=1,1 >"$scratch/dry" 2>&1 || status=$?
        listed=no
        ! grep -q "^  make $target " "$scratch/said" || listed=yes
        case $status:$listed:$(grep -c "$2 has no " "$scratch/dry") in
        *:no:0) echo "make $target is not listed" && return 1 ;;
        *:yes:[1-9]*) echo "make $target is listed, and $(cat "$scratch/dry")" && return 1 ;;
        esac
    done
    ! grep -e SOLUTION= -e classes "$scratch/said" || return 1
    for heading in 'Mac or Windows' 'How to hand in'; do
        grep -qx "## $heading" "$1/README.md" || { echo "no heading: $heading"; return 1; }
    done
    for file in $(jq -r '.files[]' "$1/labs/$2/lab.json"); do
        grep -q "^Hand in .*\`labs/$2/$file\`" "$1/README.md" || { echo "$file is not named as handed in"; return 1; }
    done
}

# alone FOLDER COMMAND...: run it there with nothing of this make's or of the course's variables.
alone() {
    where=$1
    shift
    (cd "$where" && env -i PATH="$PATH" HOME="$HOME" ${TMPDIR:+TMPDIR="$TMPDIR"} ${CC:+CC="$CC"} ${CXX:+CXX="$CXX"} "$@")
}

for lab in $labs; do
    check "$lab: the same bytes twice" same_bytes "$lab"
    for layout in --indent\ 7 -c; do
        # shellcheck disable=SC2086 # an option and its value
        check "$lab: nor does the layout of lab.json change it ($layout)" laid_out "$lab" $layout
    done
    tar -xzf "$scratch/first/$lab.tar.gz" -C "$scratch"
    check "$lab: its files and no others" only_its_files "$scratch/$lab" "$lab"
    check "$lab: no solution under another name" no_solution "$scratch/$lab" "$lab"
    check "$lab: the judge of its lab, which needs no other solution" judged "$scratch/$lab" "$lab"
    check "$lab: earlier solutions, where there are any, as a reader wants them" finished "$scratch/$lab"
    check "$lab: no link leads nowhere" links "$scratch/$lab"
    check "$lab: its container gets what a handout needs" contained "$scratch/$lab"
    check "$lab: VS Code has its tasks" run_by_editor "$scratch/$lab"
    check "$lab: make help and the README name what there is for it" helps "$scratch/$lab" "$lab"
    check "$lab: the first make grade counts its steps" counts "$scratch/$lab" "$lab"
    if command -v clangd >/dev/null; then
        check "$lab: editors understand its files" edited "$scratch/$lab"
    else
        skip "$lab: editors understand its files" "clangd is not installed"
    fi
    check "$lab: make knows the commands of its READMEs" commands "$scratch/$lab" "$lab"
done
owners=$(tar -tvzf "$scratch/first/$lab.tar.gz" --numeric-owner | awk '{ print $2, $4 }' | sort -u)
[ "$(echo "$owners" | wc -l)" -eq 1 ] && [ "${owners%% *}" = 0/0 ]
ok $? "one owner, one time" "$owners"

# What is looked for would be found.
cp solutions/02-kdtree-2d-build/kdtree2d_build.c "$scratch/02-kdtree-2d-build/tests/grader/another.c"
! no_solution "$scratch/02-kdtree-2d-build" 02-kdtree-2d-build >/dev/null
ok $? "a solution in the wrong place is found"
rm "$scratch/02-kdtree-2d-build/tests/grader/another.c"

! pack 77 "$scratch/none" 2>"$scratch/said" && [ ! -e "$scratch/none" ]
ok $? "another lab's number is refused"
check "with one message" grep -qx 'handout: LAB: found "77", expected the number or name of a lab' "$scratch/said"

quick_ends

# ---- On their own -------------------------------------------------------------------------------

# The points of every check. verdicts RESULTS
verdicts() {
    sed -n '/^  "score"/p; /^  "checks"/,$p' "$1" | grep -E '"(id|points|score|status)":'
}

# same_scores FOLDER LAB SUBMISSION SCORE [SEED]: is each check judged as the instructor's grader does?
same_scores() {
    status=0
    seed=${5:-11}
    # Here the solution runs once for all; a handout has none.
    mkdir -p "$scratch/answers/$2"
    "$build/tools/grade" --build "$build" --lab "$2" --submission "$3" --seed "$seed" \
        --answers "$scratch/answers/$2" --output "$scratch/instructor" >"$scratch/said" 2>&1 || status=$?
    [ "$status" -le 1 ] || { cat "$scratch/said"; return 1; }
    alone "$1" make grade LAB="${2%%-*}" SEED="$seed" >"$scratch/said" 2>&1
    verdicts "$scratch/instructor/results.json" >"$scratch/expected"
    verdicts "$1/build/grade/${2%%-*}/results.json" >"$scratch/found" || { cat "$scratch/said"; return 1; }
    diff "$scratch/expected" "$scratch/found" && grep -q "\"score\": $4," "$scratch/found"
}

# some_wrong FOLDER LAB: the first task's answer is the placeholder, and no other task loses a point.
some_wrong() {
    rm -rf "$scratch/wrong"
    mkdir "$scratch/wrong"
    cp "solutions/$2"/*.[ch]* "$scratch/wrong/"
    "$build/tools/grade" --lab "$2" --list-checks >"$scratch/checks"
    task=$(head -n 1 "$scratch/checks" | cut -f 2)
    source=$(grep -l "// TASK $task:" "$scratch/wrong"/*)
    "$build/tools/holes" read "labs/$2/$(basename "$source")" "$task" >"$scratch/placeholder"
    "$build/tools/holes" fill "$source" "$task" "$scratch/placeholder" >"$scratch/filled"
    cp "$scratch/filled" "$source"
    cp "$scratch/wrong"/* "$1/labs/$2/"
    missing=$(awk -F '\t' -v task="$task" '$2 == task { sum += $3 } END { print sum }' "$scratch/checks")
    same_scores "$1" "$2" "$scratch/wrong" $((100 - missing))
}

# says_why FOLDER: of a mistake in lab 00's kernel the report says all, with pictures.
says_why() {
    cp solutions/00-hello-pixels/*.[ch]* "$1/labs/00-hello-pixels/"
    sed 's/(float)x/(float)y/' solutions/00-hello-pixels/gradient.cl >"$1/labs/00-hello-pixels/gradient.cl"
    ! cmp solutions/00-hello-pixels/gradient.cl "$1/labs/00-hello-pixels/gradient.cl" >/dev/null || return 1
    alone "$1" make grade LAB=00 >"$scratch/said" 2>&1 || { cat "$scratch/said"; return 1; }
    grep -q expected "$1/build/grade/00/results.json" && [ -e "$1/build/grade/00/pictures.json" ]
}

# Labs with and without host files, with and without earlier solutions that the grader needs. They are
# built in one folder, one after the other, so that common/ and the grader, which are the same in each, are
# compiled once: a source or a header that a handout lacks is missed by make all the same. Nothing else stays.
clean=$scratch/clean
mkdir "$clean"
for lab in 00-hello-pixels 02-kdtree-2d-build 07-kdtree-3d-trace; do
    find "$clean" -mindepth 1 -maxdepth 1 ! -name build -exec rm -r {} +
    find "$clean/build" -mindepth 1 -maxdepth 1 ! -name obj -exec rm -r {} + 2>/dev/null
    find "$clean/build/obj" -type f ! -path '*/obj/common/*' ! -path '*/obj/tests/grader/*' -exec rm {} + 2>/dev/null
    tar -xzf "$scratch/first/$lab.tar.gz" -C "$clean" --strip-components=1
    # Not optimised: only what a student hands in runs for long here, and the grader compiles that as ever.
    check "$lab: everything builds" alone "$clean" make -j2 OPTIMISATION=-O0 all
    check "$lab: the skeleton's score is the instructor's" same_scores "$clean" "$lab" "labs/$lab" 0
    check "$lab: so is that of answers of which some are wrong" some_wrong "$clean" "$lab"
    [ "$lab" != 00-hello-pixels ] || check "$lab: of a mistake it says all" says_why "$clean"
    cp "solutions/$lab"/*.[ch]* "$clean/labs/$lab/"
    check "$lab: the solution's score is the instructor's" same_scores "$clean" "$lab" "solutions/$lab" 100
    ! grep -rlF "$course/" "$clean/build" >"$scratch/said"
    ok $? "$lab: no file of the course was used" "$(cat "$scratch/said")"
done

# no_device: without the device that was named nothing is judged, and the last report stays.
no_device() {
    cp "$clean/build/grade/07/results.json" "$scratch/last" || return 1
    status=0
    alone "$clean" make grade LAB=07 DEVICE=none-such >"$scratch/said" 2>&1 || status=$?
    cat "$scratch/said"
    [ "$status" -eq 2 ] && grep -q 'found no device "none-such"' "$scratch/said" &&
        ! grep -q Score "$scratch/said" && cmp "$scratch/last" "$clean/build/grade/07/results.json"
}
check "a device that is not there is no verdict" no_device

# Of other labs it says which one is here.
refuses_lab() {
    ! alone "$clean" make "$@" >"$scratch/said" 2>&1 || { cat "$scratch/said"; return 1; }
    grep -q 'found .*01.*07-kdtree-3d-trace$' "$scratch/said" || { cat "$scratch/said"; return 1; }
}
check "make grade says which lab is here" refuses_lab grade LAB=01
check "make memcheck, too" refuses_lab memcheck LAB=01
check "and make of a program" refuses_lab build/labs/01-naive-2d
# A window is on the lab as a task, and on those before it as solutions.
refuses_to() {
    want=$1 && shift
    ! alone "$clean" make -s "$@" >"$scratch/said" 2>&1 || { echo "it works"; return 1; }
    grep "$want" "$scratch/said" || { cat "$scratch/said"; return 1; }
}
check "make view says that the solution is not here" refuses_to "no solution of 07-kdtree-3d-trace here" view LAB=07 SOLUTION=1
check "and that an earlier lab is one" refuses_to "05-spheres is here as a solution only: add SOLUTION=1" view LAB=05
# Each target that `make help` lists, as it is.
targets() {
    alone "$clean" make help | sed -n 's/^  make \([a-z-]*\) .*/\1/p' >"$scratch/targets"
    grep -q memcheck "$scratch/targets" || { echo "no memcheck in make help"; return 1; }
    ! alone "$clean" make help | grep FORMAT || return 1 # what writes formats is not here
    while IFS= read -r target; do
        case $target in
        setup) set -- --dry-run setup ;;
        clean) continue ;;  # last
        watch) continue ;;  # has no end: suite desk
        grade | hint | memcheck | view) set -- "$target" LAB=07 ;;
        pixel) set -- pixel LAB=07 AT=20,20 OPTIONS="--size 64x48" ;;
        movie) set -- movie LAB=07 OPTIONS="--size 32x24" ;;
        *) set -- "$target" ;;
        esac
        status=0
        alone "$clean" make "$@" </dev/null >"$scratch/said" 2>&1 || status=$?
        case $target:$status in
        *:0) ;;
        view:2) grep -q 'a display is needed' "$scratch/said" || { echo "$target"; cat "$scratch/said"; } ;;
        *) echo "$target: status $status"; cat "$scratch/said" ;;
        esac
    done <"$scratch/targets" >"$scratch/broken"
    alone "$clean" make clean && [ ! -e "$clean/build" ] || echo "clean" >>"$scratch/broken"
    cat "$scratch/broken"
    [ ! -s "$scratch/broken" ]
}

# Its programs can be installed from scratch: the list of packages is there, and make asks for it.
mkdir "$scratch/bare"
for tool in sh awk grep sed dirname make; do
    ln -s "$(command -v $tool)" "$scratch/bare/$tool"
done
(cd "$clean" && env -i PATH="$scratch/bare" make setup) >"$scratch/said" 2>&1
check "make setup names what a bare machine lacks" grep -q '^ *pocl-opencl-icd$' "$scratch/said"
! grep -x -e ' *jq' -e ' *parallel' -e ' *nettle-dev' "$scratch/said"
ok $? "and nothing that only the course needs"

# What the course's README says of FORMAT is not for here.
! alone "$clean" make -s grade LAB=7 FORMAT=junit >"$scratch/said" 2>&1
ok $? "make grade with FORMAT is refused"
check "with one message" test "$(grep -v '^make: ' "$scratch/said")" = \
    "make grade: a handout has no FORMAT: build/grade/ holds what it writes"

check "each target of make help works" targets

finish

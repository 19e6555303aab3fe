#!/bin/sh
# Every bundle for another system, from its archive to the points, in a clean folder, as that system
# would run it.
#
#     sh tests/suites/bundles.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/systems.sh
# Each bundle's make is the first one where it runs; not optimised, as nothing runs for long here.
unset MFLAGS MAKELEVEL
export MAKEFLAGS=OPTIMISATION=-O0

# ---- Bundles: the same bytes, and only what belongs to the course -------------------------------

# The course as an unpacked archive has it: no git, other times, other rights.
mkdir "$scratch/copy"
{ git ls-files 2>/dev/null | grep . || find ./* -path ./build -prune -o -type f -print; } |
    tar -cf - -T - | tar -xmf - -C "$scratch/copy"
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)
export SOURCE_DATE_EPOCH
bundles=$scratch/first/systems
for bundle in gradescope-00.zip github-00.zip $(heart "" autolab-00.tar autolab-00-image.tar prairielearn-00.zip autolab-07.tar); do
    system=${bundle%%-*} number=${bundle#*-} number=${number%%[.-]*}
    check "$bundle" make -s "$system" LAB="${number#0}" BUILD="$scratch/first"
    (umask 077 && cd "$scratch/copy" && TZ=Asia/Tokyo LC_ALL=C.UTF-8 \
        make -s "$system" LAB="$number" BUILD="$scratch/second") >/dev/null
    check "$bundle: the same bytes from another copy" \
        cmp "$bundles/$bundle" "$scratch/second/systems/$bundle"
done
tests/systems/bundle.sh gradescope 99 "$scratch/none" 2>"$scratch/said"
[ $? -eq 2 ] && [ ! -e "$scratch/none" ]
ok $? "no bundle of a lab that is not there" "$(cat "$scratch/said")"
more=$(unzip -l "$bundles/gradescope-00.zip" | grep -e 'solutions/0[1357]' -e /mutants/ -e /unit/)
[ -z "$more" ]
ok $? "the bundle of lab 00 holds no solution that it does not need, and no test" "$more"

check "a repository on GitHub keeps its scripts' ends of lines" unzip -l "$bundles/github-00.zip" .gitattributes

# ---- How many processes, and how long -----------------------------------------------------------

# A container's limits, as its files tell them. choose WANTED [NAME=VALUE]...: what is said then.
mkdir -p "$scratch/cgroup/cpu" "$scratch/cgroup/memory"
echo "Max processes  unlimited  unlimited  processes" >"$scratch/limits"
# shellcheck disable=SC2317 # called by check
choose() {
    wanted=$1
    shift
    # shellcheck disable=SC2016 # for the inner shell
    said=$(env -i PATH="$PATH" CGROUP_ROOT="$scratch/cgroup" LIMITS_FILE="$scratch/limits" "$@" \
        sh -c '. tests/systems/limits.sh; choose_limits && echo "$JOBS $OPENIMAGEIO_THREADS $limit"' 2>&1)
    # shellcheck disable=SC2254 # a pattern
    case $said in $wanted) ;; *) printf 'found %s\nexpected %s\n' "$said" "$wanted" && return 1 ;; esac
}
processors=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc)
check "as many processes as processors" \
    choose "Processes: $processors (processors here: $processors)*default*$processors $processors "
check "whatever limits OpenMP has" choose "Processes: $processors (*" OMP_NUM_THREADS=1 OMP_THREAD_LIMIT=1
check "or what is asked for" choose "Processes: 7 (JOBS)*: 30 s of processor time (TIME_LIMIT)*7 7 --time-limit 30" \
    JOBS=7 TIME_LIMIT=30
for value in 0 07 -1 1.5 513 99999999999999999999 "2 --sandbox none"; do
    check "JOBS=$value is refused" \
        choose "JOBS: found \"$value\", expected a whole number from 1 to 512" "JOBS=$value"
done
check "TIME_LIMIT=1h is refused" choose "*TIME_LIMIT: found \"1h\", expected a whole number from 1 to 3600" \
    JOBS=1 TIME_LIMIT=1h
echo "50000 100000" >"$scratch/cgroup/cpu.max"
check "half a processor" choose "Processes: 1 (50% of a processor here)*"
echo "max 100000" >"$scratch/cgroup/cpu.max"
check "no quota" choose "Processes: $processors (*"
rm "$scratch/cgroup/cpu.max"
echo 90000 >"$scratch/cgroup/cpu/cpu.cfs_quota_us"
echo 100000 >"$scratch/cgroup/cpu/cpu.cfs_period_us"
check "an older kernel's quota" choose "Processes: 1 (90% of a processor here)*"
echo -1 >"$scratch/cgroup/cpu/cpu.cfs_quota_us"
check "none there" choose "Processes: $processors (*"
echo 402653184 >"$scratch/cgroup/memory.max"
check "little memory" choose "Processes: 1 (*"
rm "$scratch/cgroup/memory.max"
echo 9223372036854771712 >"$scratch/cgroup/memory/memory.limit_in_bytes"
check "as much memory as there is" choose "Processes: $processors (*"
echo "Max processes  40  40  processes" >"$scratch/limits"
check "few processes" choose "Processes: 1 (*"

heart_ends

# ---- Each bundle, as its system would run it ----------------------------------------------------

# quietly COMMAND...: run it; stdout goes to $scratch/said, and anything on stderr is a failure.
quietly() {
    status=0
    "$@" >"$scratch/said" 2>"$scratch/said.err" </dev/null || status=$?
    [ "$status" -eq 0 ] && [ ! -s "$scratch/said.err" ] && return 0
    echo "exit status $status"
    tail -n 20 "$scratch/said" "$scratch/said.err"
    return 1
}

# Gradescope: the zip in source/, setup.sh once, run_autograder copied beside it.
root=$scratch/autograder
mkdir -p "$root/source" "$root/results"
unzip -q "$bundles/gradescope-00.zip" -d "$root/source"
cp "$root/source/run_autograder" "$root"
check "Gradescope: setup.sh" quietly env AUTOGRADER_ROOT="$root" "$root/source/setup.sh"

# gradescope NAME SCORE: a submission as Gradescope grades it.
# shellcheck disable=SC2317 # called by check
gradescope() {
    rm -rf "$root/submission"
    cp -r "$scratch/$1" "$root/submission"
    (cd "$root" && quietly env AUTOGRADER_ROOT="$root" ./run_autograder) || return 1
    cp "$root/results/results.json" "$scratch/gradescope-$1.json"
    grep "^{\"score\":$2," "$scratch/gradescope-$1.json" && return
    cat "$scratch/gradescope-$1.json"
    return 1
}
check "Gradescope: a right submission" gradescope right 100
check "Gradescope: a wrong one" gradescope wrong 60
check "Gradescope: a crashing one" gradescope hostile 80
check "Gradescope: none" gradescope missing 0
[ ! -e "$root/source/course/build/obj" ]
ok $? "the grader is built without what only make needs"

# graded_by SCRIPT COMMAND...: run it with this script in place of the grader.
# shellcheck disable=SC2317 # called by check
graded_by() {
    mv "$course/build/tools/grade" "$course/build/tools/real"
    printf '#!/bin/sh\n%s\n' "$1" >"$course/build/tools/grade"
    chmod +x "$course/build/tools/grade"
    shift
    swapped=0
    "$@" || swapped=$?
    mv "$course/build/tools/real" "$course/build/tools/grade"
    return $swapped
}
# no_result COMMAND...: does it fail, with a message, and without a result of this or an earlier run?
# shellcheck disable=SC2317 # called by check
no_result() {
    echo '{"score":100}' >"$root/results/results.json"
    status=0
    "$@" >"$scratch/said" 2>&1 </dev/null || status=$?
    cat "$scratch/said"
    [ "$status" -eq 2 ] && grep -q "^No grade: " "$scratch/said" && [ -z "$(ls "$root/results")" ]
}
course=$root/source/course
check "Gradescope: the time limit is passed on" graded_by 'echo "$@"; exit 2' \
    no_result env AUTOGRADER_ROOT="$root" JOBS=3 TIME_LIMIT=33 "$root/run_autograder"
check "and said" grep 'Time limit of a submission: 33 s of processor time (TIME_LIMIT)' "$scratch/said"
check "to the grader" grep -e '--output [^ ]* --deadline 400 --time-limit 33$' "$scratch/said"
check "Gradescope: a killed grader" graded_by 'kill -9 $$' \
    no_result env AUTOGRADER_ROOT="$root" "$root/run_autograder"
check "Gradescope: a variable that is no number" \
    no_result env AUTOGRADER_ROOT="$root" TIME_LIMIT=soon "$root/run_autograder"
if [ "$(id -u)" -eq 0 ]; then
    # An ordinary user, where nothing but Landlock would be left, which needs root.
    mkdir -m 1777 "$scratch/everybodys"
    as_user="setpriv --reuid 65534 --regid 65534 --clear-groups env AUTOGRADER_ROOT=$root"
    as_user="$as_user TMPDIR=$scratch/everybodys SANDBOX=landlock"
    echo '{"score":100}' >"$root/results/results.json"
    chown 65534 "$root"
    # shellcheck disable=SC2086 # a command and its words
    $as_user "$root/run_autograder" >"$scratch/said" 2>&1 </dev/null
    [ $? -eq 2 ] && grep -q "^No grade: .* cannot write $root/results: run this as root" "$scratch/said"
    ok $? "Gradescope: an ordinary user cannot write, and a message says so" "$(cat "$scratch/said")"
    chown 65534 "$root/results"
    # shellcheck disable=SC2086 # a command and its words
    check "Gradescope: an ordinary user without a sandbox has no result" no_result $as_user "$root/run_autograder"
    check "and the message says why" grep "Landlock needs a grader that runs as root" "$scratch/said"
    chown 0 "$root" "$root/results"
else
    skip "Gradescope: an ordinary user in a container" "needs root"
fi

# build_again COURSE: take what was built for Gradescope: the course in it is the same, whatever the
# dates, and prepare.sh finds all done.
# shellcheck disable=SC2317 # called by check
build_again() {
    diff -r --exclude systems --exclude build "$scratch/autograder/source/course" "$1" || return 1
    cp -R "$scratch/autograder/source/course/build" "$1"
    find "$1" -name '*.c' -exec touch {} +
    quietly "$1/tests/systems/prepare.sh" 00 || return 1
    [ ! -s "$scratch/said" ] || { cat "$scratch/said"; return 1; }
}

# Autolab: what its Dockerfile does; then an empty folder with the handin and the two files of the
# assessment, the Makefile under its own name. Here sudo finds the course elsewhere.
unpacked=$scratch/unpacked
mkdir "$unpacked" "$scratch/autolab" "$scratch/autolab-image" "$scratch/bin"
tar -xf "$bundles/autolab-00.tar" -C "$unpacked"
tar -xf "$bundles/autolab-00-image.tar" -C "$scratch/autolab-image"
cp "$unpacked/lab00/autograde.tar" "$scratch/autolab"
cp "$unpacked/lab00/autograde-Makefile" "$scratch/autolab/Makefile"
course=$scratch/autolab-image/course
check "Autolab: the image" build_again "$course"
cat >"$scratch/bin/sudo" <<END
#!/bin/sh
[ "\$1" = -n ] && exec "$scratch/autolab-image\$2" "\$3"
END
chmod +x "$scratch/bin/sudo"
check "Autolab: the assessment names the tasks as its problems" \
    grep -A3 -e '^- name: read_back$' "$unpacked/lab00/lab00.yml"
found=$(tar -tf "$bundles/autolab-00.tar" | grep -v -x -e lab00/ -e lab00/autograde-Makefile \
    -e lab00/autograde.tar -e lab00/lab00.yml)
[ -z "$found" ]
ok $? "Autolab: the assessment holds nothing else" "$found"

# hand_in NAME: what Autolab takes for the feedback, its last line in $scratch/autolab-NAME.json.
# Autolab's autodriver makes one stream of stdout and stderr.
hand_in() {
    if [ "$1" = broken ]; then
        echo "no archive" >"$scratch/autolab/handin.tar"
    else
        tar -cf "$scratch/autolab/handin.tar" -C "$scratch/$1" .
    fi
    (cd "$scratch/autolab" && PATH=$scratch/bin:$PATH make) >"$scratch/said" 2>&1 </dev/null || {
        cat "$scratch/said"
        return 1
    }
    tail -n 1 "$scratch/said" >"$scratch/autolab-${2:-$1}.json"
}
# autolab NAME "POINTS...": a submission as Autolab grades it.
# shellcheck disable=SC2317 # called by check
autolab() {
    hand_in "$1" || return 1
    # shellcheck disable=SC2086 # four numbers
    scores=$(printf '"gradient":%s,"set_arguments":%s,"enqueue_pixels":%s,"read_back":%s' $2)
    grep -F "{\"scores\":{$scores}," "$scratch/autolab-$1.json" && return
    cat "$scratch/said"
    return 1
}
check "Autolab: a right submission" autolab right "40 20 20 20"
check "Autolab: a wrong one" autolab wrong "0 20 20 20"
check "Autolab: a crashing one" autolab hostile "40 0 20 20"
check "Autolab: none" autolab missing "0 0 0 0"
check "Autolab: a handin that is no archive" autolab broken "0 0 0 0"
# no_points COMMAND...: does the feedback end with no points for any problem?
# shellcheck disable=SC2317 # called by check
no_points() {
    "$@" || return 1
    cat "$scratch/said"
    grep -qxF '{"scores":{"gradient":null,"set_arguments":null,"enqueue_pixels":null,"read_back":null}}' \
        "$scratch/autolab-fault.json"
}
check "Autolab: a fault of the grader gives no points" \
    no_points graded_by 'echo "{\"scores\":{\"gradient\":40}}"; exit 2' hand_in right fault
check "Autolab: nor does a killed one" no_points graded_by 'kill -9 $$' hand_in right fault
mv "$course/build/prepared" "$scratch/prepared"
check "Autolab: nor does an image without a grader" no_points hand_in right fault
check "and the message says why" grep "^No grade: the grader is not built in this image" "$scratch/said"
mv "$scratch/prepared" "$course/build/prepared"
mv "$scratch/bin/sudo" "$scratch/bin/no-sudo"
printf '#!/bin/sh\nexit 1\n' >"$scratch/bin/sudo"
chmod +x "$scratch/bin/sudo"
check "Autolab: nor does an image without sudo's leave" no_points hand_in right fault

# PrairieLearn: an image of packages; what question and tests/ hold, then info.json's entrypoint with
# the files in student/.
unzip -q "$bundles/prairielearn-00.zip" -d "$scratch/prairielearn"
root=$scratch/grade
question=$scratch/prairielearn/questions/$lab
check "PrairieLearn: the question asks for the lab's files" \
    grep 'file-names="gradient.cl,render.c"' "$question/question.html"
check "PrairieLearn: info.json" obeys prairielearn-info "$question/info.json"
found=$(cd "$scratch/prairielearn/image" && find . -type f | sort | tr '\n' ' ')
[ "$found" = "./Dockerfile ./setup/install.sh ./setup/packages.txt " ]
ok $? "PrairieLearn: the image holds packages and nothing of the course" "$found"
course=$question/tests/course
check "PrairieLearn: the course, built in the image" build_again "$course"
entrypoint=$root$(sed -n 's|.*"entrypoint": "/grade\(.*\)",|\1|p' "$question/info.json")

# container NAME: a fresh container with a submission; PrairieLearn itself marks the entrypoint.
container() {
    rm -rf "$root"
    mkdir "$root"
    cp -R "$question/tests" "$root/tests"
    cp -R "$scratch/$1" "$root/student"
    course=$root/tests/course
    chmod +x "$entrypoint"
}
# prairielearn NAME PATTERN: a submission as PrairieLearn grades it.
# shellcheck disable=SC2317 # called by check
prairielearn() {
    container "$1"
    quietly env GRADE_ROOT="$root" "$entrypoint" || return 1
    cp "$root/results/results.json" "$scratch/prairielearn-$1.json"
    grep -e "$2" "$scratch/prairielearn-$1.json" && return
    cat "$scratch/prairielearn-$1.json"
    return 1
}
check "PrairieLearn: a right submission" prairielearn right '^{"gradable":true,"score":1,'
check "PrairieLearn: a wrong one" prairielearn wrong '^{"gradable":true,"score":0.6,'
check "PrairieLearn: a crashing one" prairielearn hostile '^{"gradable":true,"score":0.8,'
check "PrairieLearn: none" prairielearn missing '^{"gradable":false,'
# not_gradable COMMAND...: is the end a good one, as any other is a zero there, and the result no grade?
# shellcheck disable=SC2317 # called by check
not_gradable() {
    "$@" >"$scratch/said" 2>&1 </dev/null || return 1
    cat "$scratch/said" "$root/results/results.json"
    cp "$root/results/results.json" "$scratch/prairielearn-fault.json"
    grep -q "^No grade: " "$scratch/said" && [ "$(ls "$root/results")" = results.json ] &&
        grep -q '^{"gradable":false,.*The grader could not work' "$root/results/results.json"
}
container right
check "PrairieLearn: a killed grader is not gradable" graded_by 'kill -9 $$' \
    not_gradable env GRADE_ROOT="$root" "$entrypoint"
check "PrairieLearn: nor is a fault of the grader" graded_by 'exit 2' \
    not_gradable env GRADE_ROOT="$root" "$entrypoint"
check "PrairieLearn: nor is a variable that is no number" \
    not_gradable env GRADE_ROOT="$root" JOBS=all "$entrypoint"
rm -r "$course/build" "$course/Makefile"
check "PrairieLearn: nor is a grader that cannot be built" \
    not_gradable env GRADE_ROOT="$root" "$entrypoint"

# GitHub: the workflow in a repository that begins as the handout.
repository=$scratch/repository
mkdir "$repository"
# By what is built already: to build the judges for both kinds of processors takes minutes.
# In the course's own build folder nothing is to be made otherwise than before.
check "GitHub: the handout" quietly env -u MAKEFLAGS make -s handout LAB=00 BUILD="${BUILD:-build}"
tar -xzf "${BUILD:-build}/handout/$lab.tar.gz" -C "$repository" --strip-components 1
unzip -q "$bundles/github-00.zip" -d "$repository"
named=$(grep -cx -e 'name: Autograding Tests' -e '  run-autograding-tests:' \
    "$repository/.github/workflows/classroom.yml")
[ "$named" -eq 2 ]
ok $? "GitHub: the workflow has the names that Classroom looks for"

# github STATUS NAME POINTS: a push as the workflow grades it. A handout has no solution to try each
# task with, so that one mistake may cost more.
# shellcheck disable=SC2317 # called by check
github() {
    cp "$scratch/$2"/* "$repository/labs/$lab"
    : >"$scratch/summary"
    status=0
    (cd "$repository" && GITHUB_STEP_SUMMARY="$scratch/summary" .github/grade.sh) \
        >"$scratch/said" 2>"$scratch/said.err" || status=$?
    cat "$scratch/said" "$scratch/said.err"
    [ "$status" -eq "$1" ] && [ ! -s "$scratch/said.err" ] &&
        grep -q "^::notice title=Autograding complete::Points $3/100$" "$scratch/said" &&
        [ "$(grep -c '' "$scratch/said")" -eq 2 ] && grep -q "Score $3/100" "$scratch/summary"
}
check "GitHub: a right submission" github 0 right 100
check "GitHub: a wrong one" github 1 wrong 60
check "GitHub: a crashing one" github 1 hostile 80
rm "$repository/labs/$lab/lab.json"
status=0
(cd "$repository" && .github/grade.sh) >"$scratch/said" 2>&1 || status=$?
[ "$status" -eq 2 ] && ! grep -q 'Points' "$scratch/said"
ok $? "GitHub: a fault of the grader gives no points" "$(cat "$scratch/said")"

for system in gradescope autolab prairielearn; do
    check "$system: what its bundle wrote obeys the schema" obeys $system "$scratch/$system"-*.json
done

left=$(ls -A "$TMPDIR")
[ -z "$left" ]
ok $? "nothing is left in the folder for temporary files" "$left"

finish

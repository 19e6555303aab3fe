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
for bundle in gradescope-00.zip github-00.zip gitlab-00.zip vpl-00.zip $(quick "" autolab-00.tar autolab-00-image.tar prairielearn-00.zip autolab-07.tar); do
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
more=$(unzip -l "$bundles/gradescope-00.zip" | grep -e 'solutions/0[1357]' -e /known/ -e /unit/)
[ -z "$more" ]
ok $? "the bundle of lab 00 holds no solution that it does not need, and no test" "$more"

for bundle in github gitlab; do
    check "a repository on $bundle keeps its scripts' ends of lines" unzip -l "$bundles/$bundle-00.zip" .gitattributes
done
more=$(unzip -l "$bundles/vpl-00.zip"; unzip -l "$bundles/gitlab-00.zip"; unzip -l "$bundles/github-00.zip")
! echo "$more" | grep -e solutions -e judge
ok $? "what students get holds no solution and no judge"

# ---- What an instructor chooses for Gradescope --------------------------------------------------

# chosen STATUS HIDE THROTTLE: is that taken?
# shellcheck disable=SC2317 # called by check
chosen() {
    # shellcheck disable=SC2016 # for the inner shell
    status=0 && HIDE=$2 THROTTLE=$3 sh -c '. tests/systems/gradescope/options.sh; check_options' >"$scratch/said" 2>&1 || status=$?
    [ "$status" -eq "$1" ] || { echo "exit status $status"; cat "$scratch/said"; return 1; }
}
for value in "" after_due_date after_published; do check "HIDE=$value" chosen 0 "$value" ""; done
for value in hidden visible AFTER_PUBLISHED "after_due_date " 'after_due_date";'; do
    check "HIDE=$value is refused" chosen 2 "$value" ""
done
for value in 1/hour 10/day 999/week; do check "THROTTLE=$value" chosen 0 "" "$value"; done
# shellcheck disable=SC2016 # a value
for value in 0/day x/week 5x/hour 5 5/ /day 1000/day 5/month 05/day -1/day 5/day/day "5 / day" '5/day|$(id)'; do
    check "THROTTLE=$value is refused" chosen 2 "" "$value"
done
check "no bundle of what is refused" sh -c "! HIDE=never tests/systems/bundle.sh gradescope 00 '$scratch/none'"
check "and one of what is not" make -s gradescope LAB=00 BUILD="$scratch/chosen" HIDE=after_published THROTTLE=5/day
# shellcheck disable=SC2016 # a line of the script
check "has it" sh -c "unzip -p '$scratch/chosen/systems/gradescope-00.zip' run_autograder |
    grep -qxF 'HIDE=\${HIDE:-after_published} THROTTLE=\${THROTTLE:-5/day}'"

# Four earlier submissions: two at the same moment in two time zones, one that the autograder failed at, and one
# that was not graded itself.
cat >"$scratch/metadata.json" <<'END'
{ "id": 7, "created_at": "2026-11-27T10:00:00.365935-08:00", "assignment": { "due_date": null },
  "previous_submissions": [
    { "submission_time": "2026-11-26T09:30:00.000000-08:00", "score": 10, "autograder_error": false,
      "results": { "score": 10, "tests": [{ "name": "too early" }] } },
    { "submission_time": "2026-11-26T11:00:00.000000-08:00", "score": 20, "autograder_error": false,
      "results": { "score": 20, "tests": [{ "name": "at the same time" }] } },
    { "submission_time": "2026-11-26T20:00:00+01:00", "score": 30,
      "results": { "tests": [{ "name": "Random scenes", "score": 30, "max_score": 40, "status": "passed" }],
        "output": "all well", "execution_time": 3, "visibility": "after_published" } },
    { "submission_time": "2026-11-27T09:50:00-08:00", "score": 0, "autograder_error": true, "results": {} },
    { "submission_time": "2026-11-27T09:55:00-08:00", "score": 30, "autograder_error": false,
      "results": { "score": 30, "output": "not graded", "extra_data": { "throttled": true } } },
    5, null, { "submission_time": "soon", "score": 100, "results": { "score": 100 } } ] }
END

# instead MOST/WINDOW [FILE]: what the submission gets in place of a result, if it must not be graded.
# shellcheck disable=SC2317 # called by check
instead() {
    # shellcheck disable=SC2016 # for the inner shell
    THROTTLE=$1 sh -c '. tests/systems/gradescope/options.sh; earlier_result "$1" tests/systems/gradescope/throttle.jq' \
        sh "${2:-$scratch/metadata.json}" >"$scratch/instead.json" 2>"$scratch/said"
}
# shellcheck disable=SC2317 # called by check
is_graded() { ! instead "$@" && [ ! -s "$scratch/instead.json" ]; }
check "of three each day it is the third" is_graded 3/day
check "and graded without a word" [ ! -s "$scratch/said" ]
check "of two the third" instead 2/day
check "gets the last result" grep '"score":30,"tests":\[{"name":"Random scenes",' "$scratch/instead.json"
check "as hidden as that was" grep '"visibility":"after_published"' "$scratch/instead.json"
check "with what the student must know" grep \
    '"output":"This submission was not graded: at most 2 submissions each day are. The next one is graded from 2026-11-27 11:00 on. Your points, and what you see below, are those of 2026-11-26 11:00.\\n\\nall well"' \
    "$scratch/instead.json"
check "and does not count itself" grep '"extra_data":{"throttled":true}' "$scratch/instead.json"
check "which obeys the schema" obeys gradescope "$scratch/instead.json"
check "of three each week the fourth" instead 3/week
check "of one each hour the first" is_graded 1/hour
# Two that are still graded, and one that is older than any grading takes.
cat >"$scratch/flight.json" <<'END'
{ "created_at": "2026-11-27T10:00:00Z", "previous_submissions": [
    { "submission_time": "2026-11-27T08:00:00Z", "score": 40, "results": { "score": 40, "tests": [{ "name": "a" }] } },
    { "submission_time": "2026-11-27T09:30:00Z", "results": null },
    { "submission_time": "2026-11-27T09:59:00Z" }, { "submission_time": "2026-11-27T09:59:30Z", "results": null } ] }
END
check "two at once count, though they have no result yet" instead 3/day "$scratch/flight.json"
check "the last result is of one that has" grep '"score":40' "$scratch/instead.json"
check "one that never got a result does not count" is_graded 4/day "$scratch/flight.json"
for text in '' '{}' '[]' null 5 '"x"' '{"created_at": "2026-11-27T10:00:00Z"}' '{"created_at": 5, "previous_submissions": [{}]}' \
    '{"created_at": "2026-11-27T10:00:00Z", "previous_submissions": {"submission_time": "2026-11-27T09:00:00Z"}}' \
    '{"created_at": "2026-11-27T10:00:00Z", "previous_submissions": [{"submission_time": "2026-11-27T09:00:00Z", "results": {"tests": 5}}]}'; do
    printf '%s' "$text" >"$scratch/odd.json"
    check "odd metadata are no limit: $text" is_graded 1/day "$scratch/odd.json"
done
check "nor are none" is_graded 1/day "$scratch/none.json"
check "and the log says so" grep 'none.json cannot be read: graded' "$scratch/said"

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

quick_ends

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
cp "$scratch/metadata.json" "$root/submission_metadata.json"
echo '{"score":1}' >"$root/results/results.json"
check "Gradescope: one submission too many" quietly env AUTOGRADER_ROOT="$root" THROTTLE=2/day "$root/run_autograder"
cp "$root/results/results.json" "$scratch/gradescope-throttled.json"
check "Gradescope: keeps its points" grep '^{"score":30,' "$scratch/gradescope-throttled.json"
rm "$root/submission_metadata.json"
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
    -e lab00/autograde.tar -e lab00/lab00.yml -e lab00/lab00.rb)
[ -z "$found" ]
ok $? "Autolab: the assessment holds nothing else" "$found"

# Releases before 3.0 look for this file, and for a module of this name in it, which they give another one.
check "Autolab: the module of older releases" [ "$(tr '\n' ' ' <"$unpacked/lab00/lab00.rb")" = "module Lab00 end " ]

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
# In the course's own build folder nothing is to be made otherwise than before.
check "GitHub: the handout" quietly env -u MAKEFLAGS make -s handout LAB=00 BUILD="${BUILD:-build}"
tar -xzf "${BUILD:-build}/handout/$lab.tar.gz" -C "$repository" --strip-components 1
unzip -q -o "$bundles/github-00.zip" -d "$repository"
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

# GitLab: the same, by the handout as it was.
rm -rf "$repository"
mkdir "$repository"
tar -xzf "${BUILD:-build}/handout/$lab.tar.gz" -C "$repository" --strip-components 1
unzip -q -o "$bundles/gitlab-00.zip" -d "$repository"
# Read by another reader of YAML than GitLab's.
check "GitLab: the pipeline" sh -c "/usr/bin/python3 -c 'import json, sys, yaml; json.dump(yaml.safe_load(sys.stdin), sys.stdout)' \
    <'$repository/.gitlab-ci.yml' | jq -e '.grade | .script == [\".gitlab/grade.sh\"] and .artifacts.when == \"always\" and
        .artifacts.reports.junit == \"build/grade/00/junit.xml\" and .coverage == \"/^Points (\\\\d+)\\\\/100/\"'"
# gitlab STATUS NAME POINTS: a push as the pipeline grades it; nothing of the student's is in its log.
# shellcheck disable=SC2317 # called by check
gitlab() {
    cp "$scratch/$2"/* "$repository/labs/$lab"
    status=0
    (cd "$repository" && .gitlab/grade.sh) >"$scratch/said" 2>&1 || status=$?
    cat "$scratch/said"
    [ "$status" -eq "$1" ] && [ "$(cat "$scratch/said")" = \
        "Points $3/100; the report is among the artifacts of this job, as report.html" ] &&
        xmllint --noout --schema "$schemas/junit.xsd" "$repository/build/grade/00/junit.xml" &&
        [ -s "$repository/build/grade/00/report.html" ]
}
check "GitLab: a right submission" gitlab 0 right 100
check "GitLab: a crashing one" gitlab 1 hostile 80
mv "$repository/labs/$lab/lab.json" "$scratch/lab.json"
status=0
(cd "$repository" && .gitlab/grade.sh) >"$scratch/said" 2>&1 || status=$?
[ "$status" -eq 2 ] && grep -q 'build/grade/00/log among the artifacts' "$scratch/said" &&
    [ ! -e "$repository/build/grade/00/junit.xml" ] && ! grep -q Points "$scratch/said"
ok $? "GitLab: a fault of the grader gives no points, and leaves no older report" "$(cat "$scratch/said")"
mv "$scratch/lab.json" "$repository/labs/$lab"

# VPL: the handout on the jail server, built once; an evaluation in a folder with the student's files.
unzip -q -o "$bundles/vpl-00.zip" .vpl/'*' -d "$repository"
check "VPL: the handout is built" quietly make -s -C "$repository" lab-grader LAB=00
# vpl STATUS NAME GRADE [GRADEMAX]: an evaluation; "" is no grade. VPL's own files are none of the student's.
# shellcheck disable=SC2317 # called by check
vpl() {
    rm -rf "$scratch/jail"
    cp -R "$scratch/$2" "$scratch/jail"
    unzip -q "$bundles/vpl-00.zip" vpl_evaluate.sh -d "$scratch/jail"
    # A student's file may be called as VPL's own line.
    printf '%s\n' '#!/bin/bash' 'export VPL_SUBFILES="' 'export VPL_GRADEMAX=1000' '"' \
        "export VPL_GRADEMAX='${4:-100}'" "export VPL_VARIATIONS=( 'a' )" >"$scratch/jail/vpl_environment.sh"
    (cd "$scratch/jail" && COURSE=$repository ./vpl_evaluate.sh) || return 1
    status=0
    (cd "$scratch/jail" && ./vpl_execution) >"$scratch/said" 2>&1 || status=$?
    cat "$scratch/said"
    [ "$status" -eq "$1" ] && obeys_vpl "$scratch/said" && ! grep vpl_ "$scratch/said" &&
        [ "$(sed -n 's/^Grade :=>> //p' "$scratch/said")" = "$3" ]
}
check "VPL: a right submission" vpl 0 right 100
check "VPL: a wrong one, of another highest grade" vpl 0 wrong 6 10
check "VPL: a crashing one, whose words are no grade" vpl 0 hostile 80
check "VPL: none" vpl 0 missing 0
course=$repository
check "VPL: a killed grader gives no grade" graded_by 'echo "Grade :=>> 100"; kill -9 $$' vpl 2 right ""
check "VPL: nor does one that is not there" sh -c "rm -r '$repository/build/tools'" && check "and says so" vpl 2 right ""

for system in gradescope autolab prairielearn; do
    check "$system: what its bundle wrote obeys the schema" obeys $system "$scratch/$system"-*.json
done

left=$(ls -A "$TMPDIR")
[ -z "$left" ]
ok $? "nothing is left in the folder for temporary files" "$left"

finish

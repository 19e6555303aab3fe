#!/bin/sh
# Pack what one of the systems that courses use needs to grade one lab (tests/systems/README.md).
#
#     tests/systems/bundle.sh gradescope|autolab|prairielearn|github|gitlab|vpl LAB FOLDER [MANIFEST]
#
# LAB is a lab's number or name: 3, 03 or 03-kdtree-2d-render. MANIFEST takes the place of the lab's lab.json: an
# instructor's own points (tests/class/points/points_tool.c). HIDE and THROTTLE in the environment are for Gradescope
# (gradescope/options.sh).
#
# The same sources make the same bytes: names are sorted, owners and rights are fixed, and every
# time is that of the last commit (or SOURCE_DATE_EPOCH). Only what git tracks is packed.
set -eu
umask 022
export LC_ALL=C TZ=UTC

usage="usage: bundle.sh gradescope|autolab|prairielearn|github|gitlab|vpl LAB FOLDER"
system=${1:?$usage} wanted=${2:?$usage} folder=${3:?$usage}
cd "$(dirname "$0")/../.."
templates=tests/systems/$system
lab=
for manifest in solutions/"$wanted"/lab.json solutions/"$wanted"-*/lab.json solutions/0"$wanted"-*/lab.json; do
    [ ! -f "$manifest" ] || lab=$(basename "$(dirname "$manifest")")
done
if [ ! -d "$templates" ] || [ -z "$lab" ]; then
    printf 'bundle: found "%s" and "%s", expected a system and a lab\n' "$system" "$wanted" >&2
    echo "$usage" >&2
    exit 2
fi
# shellcheck source=tests/systems/gradescope/options.sh
. tests/systems/gradescope/options.sh
[ "$system" != gradescope ] || check_options || exit 2
command -v jq >/dev/null || { echo "bundle: jq is not here: install the package jq" >&2 && exit 2; }
number=${lab%%-*}
manifest=${4:-solutions/$lab/lab.json}
# Where there is no checkout, every file is the course's. Where git does not read the one that is there, nobody knows.
[ ! -e .git ] || why=$(sh common/setup/checkout.sh) || { echo "bundle: only files that git tracks are packed, but $why" >&2 && exit 2; }
date=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)}
stage=$(mktemp -d "${TMPDIR:-/tmp}/bundle-XXXXXX")
trap 'rm -rf "$stage"' EXIT

# tracked PATH...: the files under these that belong to the course. An unpacked archive of it has no
# git, and nothing but them outside build/.
tracked() {
    git ls-files -- "$@" 2>/dev/null | grep . || find "$@" -type f
}

# copy_course FOLDER: what the grader of this lab is built from. Its trees and cameras come from the
# solutions of labs 02, 04 and 06; the other solutions are those of this lab and of the ones before.
copy_course() {
    solutions=$(for one in solutions/*/; do
        name=$(basename "$one")
        case $name in 02-* | 04-* | 06-*) printf '%s\n' "$name" ;; *)
            if expr "$name" \<= "$lab" >/dev/null; then printf '%s\n' "$name"; fi ;;
        esac
    done)
    mkdir -p "$1"
    # shellcheck disable=SC2046,SC2086 # lists of names without spaces
    tracked Makefile LICENSE common kernels tests/grader tests/judge \
        $(find tests/probes -maxdepth 1 -type f) tests/probes/*/jobs_*.h "tests/probes/$lab" tests/stubs \
        tests/systems/formats tests/systems/prepare.sh tests/systems/limits.sh "tests/systems/$system" \
        "labs/$lab" $(printf 'solutions/%s ' $solutions) |
        grep -v '\.md$' | tar -cf - -T - | tar -xf - -C "$1"
    for whose in labs solutions; do cp "$manifest" "$1/$whose/$lab/lab.json"; done
}

# fill NAME...: replace the @WORDS@ in files of the stage.
where=
fill() {
    title=$(jq -er .title "solutions/$lab/lab.json" | sed 's/[&\\/]/\\&/g')
    files=$(jq -er '.files | join(",")' "solutions/$lab/lab.json")
    # An identifier of the question that never changes, in the form of a UUID (version 8: our own).
    uuid=$(printf '%s' "$lab" | sha1sum |
        sed 's/^\(.\{8\}\)\(.\{4\}\).\(.\{3\}\).\(.\{3\}\)\(.\{12\}\).*/\1-\2-8\3-8\4-\5/')
    for name; do
        sed -i -e "s/@LAB@/$lab/g" -e "s/@NN@/$number/g" -e "s/@TITLE@/$title/g" \
            -e "s/@FILES@/$files/g" -e "s/@UUID@/$uuid/g" \
            -e "s/@IMAGE@/autograding_lab$number/g" -e "s/@SYSTEM@/$system/g" -e "s|@WHERE@|$where|g" \
            -e "s/@HIDE@/${HIDE:-}/g" -e "s|@THROTTLE@|${THROTTLE:-}|g" "$stage/$name"
    done
}

# Give everything in a folder the same rights and times wherever it is packed.
settle() {
    chmod -R u=rwX,go=rX "$1"
    find "$1" -exec touch -h -d "@$date" {} +
}

# pack_tar FOLDER TAR: the folder's contents.
pack_tar() {
    settle "$1"
    # shellcheck disable=SC2046 # names without spaces
    tar --sort=name --format=gnu --mtime="@$date" --owner=0 --group=0 --numeric-owner \
        -cf "$2" -C "$1" $(cd "$1" && ls -A)
}

# pack_zip FOLDER ZIP: the folder's contents.
pack_zip() {
    settle "$1"
    rm -f "$2"
    (cd "$1" && find . -type f | sort | zip -q -X -D -@ "$2")
}

# Each task of the lab: "ID POINTS".
tasks() { jq -r '.tasks[] | "\(.id) \([.points[]] | add)"' "$manifest"; }

# The problems of an Autolab assessment are the lab's tasks, with their points.
write_problems() {
    tasks | awk '{
        printf "- name: %s\n  description: \047\047\n  max_score: %s\n  optional: false\n", $1, $2 }'
}

# Autolab's last line that gives no points: for each problem null, which is no zero there.
write_no_grade() {
    tasks | awk '{ printf "%s\"%s\":null", NR == 1 ? "{\"scores\":{" : ",", $1 }
        END { print "}}" }'
}

# pack_repository HOME: what a student's repository needs beside the handout, in a folder of this name.
pack_repository() {
    mkdir -p "$stage/$1/formats"
    cp tests/systems/limits.sh "$stage/$1"
    cp tests/systems/formats/*.jq tests/systems/formats/write.sh "$stage/$1/formats"
}

case $folder in /*) ;; *) folder=$PWD/$folder ;; esac
mkdir -p "$folder"
bundle=$folder/$system-$number.zip
case $system in
gradescope)
    copy_course "$stage/course"
    mv "$stage/course/$templates"/* "$stage"
    fill setup.sh run_autograder options.sh
    pack_zip "$stage" "$bundle"
    ;;
autolab)
    bundle=$folder/$system-$number.tar
    assessment=lab$number
    copy_course "$stage/image/course"
    mkdir -p "$stage/all/$assessment" "$stage/inner"
    for file in Dockerfile autograde-Makefile assessment.yml; do
        mv "$stage/image/course/$templates/$file" "$stage"
    done
    no_grade=$(write_no_grade)
    sed -i "s/@NO_GRADE@/$no_grade/" "$stage/autograde-Makefile"
    write_problems | sed -i -e '/^@PROBLEMS@$/{r /dev/stdin' -e 'd;}' "$stage/assessment.yml"
    fill Dockerfile autograde-Makefile assessment.yml "image/course/$templates/grade.sh"
    mv "$stage/Dockerfile" "$stage/image"
    mv "$stage/autograde-Makefile" "$stage/all/$assessment"
    mv "$stage/assessment.yml" "$stage/all/$assessment/$assessment.yml"
    # Releases before 3.0 insist on a module of this name.
    printf 'module Lab%s\nend\n' "$number" >"$stage/all/$assessment/$assessment.rb"
    # Autolab insists on this file; the grader is in the image.
    echo "The grader of $lab is in the image." >"$stage/inner/README"
    pack_tar "$stage/inner" "$stage/all/$assessment/autograde.tar"
    pack_tar "$stage/all" "$bundle"
    pack_tar "$stage/image" "$folder/$system-$number-image.tar"
    ;;
prairielearn)
    tests=questions/$lab/tests
    copy_course "$stage/$tests/course"
    mkdir -p "$stage/image"
    for file in Dockerfile info.json question.html grade.sh; do
        mv "$stage/$tests/course/$templates/$file" "$stage"
    done
    fill info.json question.html grade.sh
    mv "$stage/Dockerfile" "$stage/image"
    mv "$stage/info.json" "$stage/question.html" "$stage/questions/$lab"
    mv "$stage/grade.sh" "$stage/$tests"
    mkdir -p "$stage/image/setup"
    cp common/setup/install.sh common/setup/packages.txt "$stage/image/setup"
    pack_zip "$stage" "$bundle"
    ;;
github)
    where="the summary of this run"
    pack_repository .github
    mkdir -p "$stage/.github/workflows"
    cp "$templates/classroom.yml" "$stage/.github/workflows/classroom.yml"
    cp tests/systems/repository.sh "$stage/.github/grade.sh"
    cp .gitattributes "$stage"
    fill .github/workflows/classroom.yml .github/grade.sh
    pack_zip "$stage" "$bundle"
    ;;
gitlab)
    where="build/grade/$number/log among the artifacts of this job"
    pack_repository .gitlab
    cp "$templates/gitlab-ci.yml" "$stage/.gitlab-ci.yml"
    cp tests/systems/repository.sh "$stage/.gitlab/grade.sh"
    cp .gitattributes "$stage"
    fill .gitlab-ci.yml .gitlab/grade.sh
    pack_zip "$stage" "$bundle"
    ;;
vpl)
    pack_repository .vpl
    cp "$templates/grade.sh" "$stage/.vpl"
    cp "$templates/vpl_evaluate.sh" "$stage"
    fill vpl_evaluate.sh .vpl/grade.sh
    pack_zip "$stage" "$bundle"
    ;;
esac
printf '%s\n' "$bundle"

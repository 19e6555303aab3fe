#!/bin/sh
# Collect what a lecturer needs who has no pandoc: FOLDER/VERSION with the site of each edition, the handouts of
# HANDOUTS, CONTENTS.txt, which lists all files in them, and SHA256SUMS. Prints its path.
#
#     tests/handout/release.sh NOTES HANDOUTS FOLDER <PATHS
#
# PATHS are the pages and PDFs below NOTES/student and NOTES/instructor, a line each. VERSION is CHANGELOG.md's
# newest version and the commit: 1.0-3f6f46c7a1b2. If a step fails, an older release of this version stays as it was.
set -eu
. tests/handout/archive.sh

notes=$1
handouts=$2
folder=$3
why=$(sh common/setup/checkout.sh) || { echo "release: a release is named after its commit, but $why" >&2 && exit 1; }
commit=$(git describe --always --exclude='*' --abbrev=12 --dirty)
version=$(sed -n 's/^## \([0-9][0-9.]*\).*/\1/p' CHANGELOG.md | head -n 1)-$commit

mkdir -p "$folder"
stage=$(mktemp -d "$folder/unfinished-XXXXXX")
trap 'rm -rf "$stage"' EXIT
trap 'exit 1' HUP INT TERM
new=$stage/$version
cat >"$stage/paths"

for edition in student instructor; do
    name=slides-notes-$edition
    mkdir "$stage/$name"
    sed -n "s|^$notes/$edition/||p" "$stage/paths" >"$stage/files"
    tar --create --directory="$notes/$edition" --files-from="$stage/files" --file="$stage/part.tar"
    tar --extract --directory="$stage/$name" --file="$stage/part.tar"
    archive "$stage" "$name" "$new"
done
cp "$handouts"/[0-9]*.tar.gz "$handouts"/[0-9]*.txt "$new"

# The lists of all archives become one.
(
    cd "$new"
    echo "From circles to rays: kd-trees in OpenCL, version $version"
    echo "For lecturers only: slides-notes-instructor.tar.gz. Hand out a lab after the deadline of the lab before."
    for list in *.txt; do
        printf '\n%s (bytes, file)\n\n' "${list%.txt}.tar.gz"
        cat "$list"
        rm "$list"
    done
) >"$stage/contents"
mv "$stage/contents" "$new/CONTENTS.txt"
(cd "$new" && sha256sum -- *) >"$stage/sums"
mv "$stage/sums" "$new/SHA256SUMS"

rm -rf "${folder:?}/$version"
mv "$new" "$folder/$version"
echo "$folder/$version"

#!/bin/sh
# Pack what students get for a lab: FOLDER/NN-name.tar.gz, and print its path. FOLDER/NN-name.txt lists what
# is in it.
#
#     tests/handout/pack.sh TOOLS LAB FOLDER [MANIFEST]
#
# It holds the lab's skeleton, the solutions of the labs before it, common/, kernels/, the grader, this
# lab's probe and judge, and a README of its own; never anything of this lab's solution or of later labs. Of the
# course only tracked files go in. The same commit gives the same
# bytes. TOOLS is the folder with the built tool `holes`. MANIFEST takes the place of the lab's lab.json: an instructor's own points (tests/class/points/points_tool.c).
set -eu
. tests/handout/archive.sh

holes=$1/holes
folder=$3

fail() {
    echo "handout: $1" >&2
    exit 1
}

lab=
for path in labs/*/; do
    name=$(basename "$path")
    case $2 in
    "$name" | "${name%%-*}") lab=$name ;;
    [0-9]) [ "0$2" != "${name%%-*}" ] || lab=$name ;;
    esac
done
[ -n "$lab" ] || fail "LAB: found \"$2\", expected the number or name of a lab"
number=${lab%%-*}
manifest=labs/$lab/lab.json
command -v jq >/dev/null || fail "jq is not here: install the package jq"
why=$(sh common/setup/checkout.sh) || fail "only files that git tracks go into it, but $why"

stage=$(mktemp -d "${TMPDIR:-/tmp}/handout-XXXXXX")
trap 'rm -rf "$stage"' EXIT
trap 'exit 1' INT TERM
root=$stage/$lab
mkdir "$root"

# copy: the paths read from stdin go into the handout, from the course's top folder or from $1.
copy() {
    tar --create --directory="${1:-.}" --files-from=- --file="$stage/part.tar"
    tar --extract --directory="$root" --file="$stage/part.tar"
}

# ---- What goes in -----------------------------------------------------------------------------

git ls-files -- common kernels LICENSE Makefile .clang-format .clangd compile_flags.txt .devcontainer .vscode .editorconfig \
    .gitattributes .gitignore Containerfile |
    # What follows later labs' kernels finds none here.
    awk -v lab="$number" '!match($0, /^common\/follow\/(steps\/)?[0-9][0-9]-/) || substr($0, RLENGTH - 2, 2) <= lab' | copy
# The course's container can grade classes, too.
sed -i 's/install\.sh demo /install.sh grade /' "$root/Containerfile"

# The skeleton is cut anew: in labs/ somebody may have tried the tasks.
tests/tools/cut_labs.sh "$holes" "$stage/cut/labs" "$lab"
git ls-files -- "labs/$lab" | copy "$stage/cut"
for path in solutions/*/; do
    earlier=$(basename "$path")
    [ "$(printf '%s\n' "$earlier" "$lab" | sort | head -n 1)" = "$lab" ] || git ls-files -- "$path" | copy
done

# What an author's `//>` lines hold is no part of a solution (tests/grader/lab/holes.h).
find "$root" -type f -path '*/solutions/*.[ch]*' -exec sed -i '/^ *\/\/>/d' {} +

# How grading works, and the times that labs' texts link.
git ls-files -- tests/GRADING.md tests/bench/RESULTS.md | copy

# The lecture's notes stay here: links to them keep only their words, and numbers have no marks (slides-notes/make).
find "$root" -name '*.md' -exec sed -i -e '/^\*\*In the lecture\*\*/,+1d' -e '/^| in the lecture |/d' \
    -e 's/\[\([^]]*\)\]([./]*slides-notes\/[a-z0-9-]*\.md[^)]*)/\1/g' \
    -e 's/<!-- [^>]* -->//g' {} +

# The figures that their READMEs show, and scenes.
grep -oh '](\.\./\.\./slides-notes/figures/[^)]*)' "$root"/*/*/*.md | sed 's|](\.\./\.\./||; s|)$||' | sort -u | copy
git ls-files -- tests/scenes | copy

# The grader and the learner's desk, which judges natively first; of the probes and stubs this lab's; and the
# lab's files as they are handed out, whatever becomes of them in labs/.
git ls-files -- tests/grader tests/desk tests/native ":(glob)tests/probes/*.[ch]" tests/probes/no_macros.sh "tests/probes/*/jobs_*.h" \
    "tests/probes/$lab" "tests/stubs/$lab" | sort -u | copy
# memcheck, which runs kernels natively, too; its known faults stay here.
git ls-files -- ":(glob)tests/memcheck/*.[ch]" tests/memcheck/memcheck.mk | copy
mkdir -p "$root/tests/skeletons/$lab"
files=$(jq -er '.files[]' "$manifest")
for file in $files; do
    cp "$stage/cut/labs/$lab/$file" "$root/tests/skeletons/$lab/"
done

if [ -n "${4:-}" ]; then
    cp "$4" "$root/labs/$lab/lab.json"
    own_points='The points that '"\`make grade LAB=$number\`"' shows are your course'"'"'s own: they count, and not those in the texts.'
fi

# The text of the lab's judge, packed: it has right answers in other words.
mkdir -p "$root/tests/judge"
cp tests/handout/judge.mk "$root/tests/judge/"
judge_files=$(sh tests/judge/sources.sh tests/judge | sed -n "s|^$lab:tests/judge/||p")
# shellcheck disable=SC2086 # a list of names without spaces
(cd tests/judge && git ls-files -- judge.mk judges.c sources.sh $judge_files) |
    settled --directory=tests/judge --files-from=- --file="$root/tests/judge/judge.tar"

# ---- Its README -------------------------------------------------------------------------------

title=$(jq -er .title "$manifest")
{
    # The first lab has no solutions of others.
    [ -d "$root/solutions" ] && none= || none='/labs before/d'
    files=$(jq -er --arg lab "$lab" '.files | map("`labs/\($lab)/\(.)`") |
        [(.[:-1] | join(", ") | select(. != "")), .[-1]] | join(" and ")' "$manifest")
    # Lab 10 has a page for each of its parts.
    grep -q '^## Tasks$' "labs/$lab/README.md" && tasks=tasks || tasks=which-part
    sed -e "$none" -e "s/@TASKS@/$tasks/" -e "s|@FILES@|$files|g" -e "s/@LAB@/$lab/g" -e "s/@NUMBER@/$number/g" -e "s|@TITLE@|$title|g" tests/handout/README.in
    [ -z "${own_points:-}" ] || printf '## Points\n\n%s\n\n' "$own_points"
    awk '/^## / { inside = $0 == "## Licence" } inside' README.md
} >"$root/README.md"

# ---- The archive ------------------------------------------------------------------------------

archive "$stage" "$lab" "$folder"
echo "$folder/$lab.tar.gz"

#!/bin/sh
# Take the paragraphs of slides that changed into slides-notes/german.po:
#
#     slides-notes/make/german.sh NOTES-FOLDER CHAPTER...
#
# A changed paragraph gets the German of the most similar one as a draft, marked as fuzzy; what no
# slide uses is dropped.
set -eu

notes=$1
shift
command -v msgmerge >/dev/null || {
    echo "make german: found no gettext, expected it to be installed (make notes does)" >&2
    exit 1
}
work=$(mktemp -d "${TMPDIR:-/tmp}/german-XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

german=slides-notes/german.po
export GERMAN_TEMPLATE="$work/german.pot"
printf 'msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n\n' >"$GERMAN_TEMPLATE"
for chapter; do
    slides-notes/make/build.sh "$notes/instructor" instructor slides \
        "slides-notes/notes-$chapter.md" "$work/slides.de.html" "" 2>"$work/log" ||
        { cat "$work/log" >&2 && exit 1; }
done
msguniq --use-first --output-file="$work/unique.pot" "$GERMAN_TEMPLATE"
msgmerge --quiet --previous --width=100 --output-file="$work/merged.po" $german "$work/unique.pot"
msgattrib --no-obsolete --width=100 --output-file=$german "$work/merged.po"
echo "$german: $(LC_ALL=C msgfmt --statistics --output-file=/dev/null $german 2>&1)"

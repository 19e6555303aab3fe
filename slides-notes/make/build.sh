#!/bin/sh
# Make one page of the site from one Markdown file: self-contained HTML.
#
#     slides-notes/make/build.sh SITE EDITION FORM SOURCE OUTPUT "PAGE..." [TOUCH]
#
# EDITION is student or instructor; FORM is notes, slides or page; SOURCE and PAGE... are paths from the
# course's top folder, where this runs; OUTPUT lies below the folder SITE; beside SITE, runs/ has what the
# programs counted. TOUCH is a piece of a page that lets its figures be touched.
set -eu

site=$1
edition=$2
form=$3
source=$4
output=$5
pages=$6
live=
[ "$form" != notes ] || live=${7:-}
make=slides-notes/make

# The way from the page up to the site's top folder.
below=${output#"$site"/}
up=
case $below in */*) up=$(dirname "$below" | sed 's|[^/][^/]*|..|g')/ ;; esac

work=$(mktemp -d "${TMPDIR:-/tmp}/notes-XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
case $form in
slides)
    cat $make/style.css $make/slides.css >"$work/style"
    [ "$edition" = student ] || cat $make/speaker.css >>"$work/style"
    cat $make/slides.js >"$work/script"
    ;;
notes) cat $make/style.css $make/page.css slides-notes/touch/touch.css >"$work/style" && : >"$work/script" ;;
*) cat $make/style.css $make/page.css >"$work/style" && : >"$work/script" ;;
esac
language=en
case $output in *.de.html) language=de ;; esac
{
    echo "<a href=\"${up}index.html\">Course</a>"
    case $form in
    notes | slides)
        chapter=$(basename "$source" .md)
        chapter=${chapter#notes-}
        echo "<a href=\"notes-$chapter.html\">Notes</a> <a href=\"slides-$chapter.html\">Slides</a>"
        ! grep -q "^#:.* $source" slides-notes/german.po || echo "<a href=\"slides-$chapter.de.html\" lang=\"de\">Folien</a>"
        ! $make/browser.sh >/dev/null || echo "<a href=\"$(basename "$output" .html).pdf\">PDF</a>"
        ;;
    esac
    [ "$edition" = student ] || echo "Instructor's edition"
} >"$work/bar"

# pandoc 3 has another name for it.
embed=--self-contained
! pandoc --help | grep -q -e --embed-resources || embed="--embed-resources --standalone"
title=$(sed -n 's/^# //p' "$source" | head -n 1)
case $form in notes | slides) title="$form $chapter: $title" ;; esac
mkdir -p "$(dirname "$output")"
# The site's pages are read as a forge reads them.
# shellcheck disable=SC2086 # one or two words
pandoc --from=gfm --to=html5 $embed --mathml --wrap=preserve --no-highlight \
    --resource-path="$(dirname "$source")" --template=$make/page.html \
    --lua-filter=$make/chapter.lua \
    --metadata=pagetitle:"$title" --metadata=source:"$source" --metadata=form:"$form" --metadata=language:$language \
    --metadata=edition:"$edition" --metadata=pages:"$pages" --metadata=runs:"$(dirname "$site")/runs" --metadata=up:"$up" \
    --variable=form:"$form" --variable=edition:"$edition" \
    --variable=style:"$(cat "$work/style")" --variable=script:"$(cat "$work/script")" \
    --variable=bar:"$(cat "$work/bar")" ${live:+--include-after-body="$live"} \
    --output="$work/page.html" "$source"
mv "$work/page.html" "$output"

#!/bin/sh
# Print a page to PDF: slides-notes/make/print.sh PAGE.html PAGE.pdf
#
# A page is the course's own: it is opened without Chromium's sandbox, which root cannot have. Its links to other
# pages lead from the PDF's folder, so that they work wherever the site is copied to. Chromium writes whole paths.
set -eu

browser=$(slides-notes/make/browser.sh) || { echo "print: found no Chromium, expected it to be installed" >&2 && exit 1; }
scratch=$(mktemp -d "${TMPDIR:-/tmp}/print-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
# The folder above the page's, by a path that is in no other text.
ln -s "$(realpath "$(dirname "$1")/..")" "$scratch/site"
page=$scratch/site/$(basename "$(realpath "$(dirname "$1")")")/$(basename "$1")
"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$scratch" --no-pdf-header-footer \
    --print-to-pdf="$scratch/page.pdf" "file://$page" >"$scratch/log" 2>&1 || true
# Its exit status says little.
test -s "$scratch/page.pdf" || { cat "$scratch/log" >&2 && exit 1; }

# As many bytes as before: a PDF knows where its parts begin.
site=$(grep -a -o "(file://[^)]*/${scratch##*/}/site/" "$scratch/page.pdf" | head -n 1 || true)
if [ -n "$site" ]; then
    more=$(printf '%*s' $((${#site} - 4)) '')
    pattern=$(printf '%s' "$site" | sed 's/[].[\*^$|]/\\&/g')
    LC_ALL=C sed -i "s|$pattern\([^)]*\))|(../\1)$more|g" "$scratch/page.pdf"
fi
mv "$scratch/page.pdf" "$2"

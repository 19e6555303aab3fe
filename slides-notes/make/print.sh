#!/bin/sh
# Print a page to PDF: slides-notes/make/print.sh PAGE.html PAGE.pdf
#
# A page is the course's own: it is opened without Chromium's sandbox, which root cannot have.
set -eu

browser=$(slides-notes/make/browser.sh) || { echo "print: found no Chromium, expected it to be installed" >&2 && exit 1; }
profile=$(mktemp -d "${TMPDIR:-/tmp}/print-XXXXXX")
trap 'rm -rf "$profile"' EXIT
trap 'exit 1' HUP INT TERM
"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$profile" --no-pdf-header-footer \
    --print-to-pdf="$profile/page.pdf" "file://$(realpath "$1")" >"$profile/log" 2>&1 || true
# Its exit status says little.
test -s "$profile/page.pdf" || { cat "$profile/log" >&2 && exit 1; }
mv "$profile/page.pdf" "$2"

#!/bin/sh
# Notes, slides and the site: every page is opened in Chromium; links, pictures, contrast, editions.
. tests/tap.sh

build=${BUILD:-build}
notes=$build/notes
browser=$(slides-notes/make/browser.sh) || browser=
if ! command -v pandoc >/dev/null || [ -z "$browser" ]; then
    skip "notes, slides and the site" "pandoc and Chromium are not both here (make notes installs them)"
    finish
    exit
fi

# The quick part: a page of each form.
pages=$(quick "$notes/student/slides-notes/slides-2d.html $notes/instructor/slides-notes/notes-2d.html $notes/student/README.html" notes-html)
# Wrong numbers are said when a page is made: in the quick part each is made anew.
# shellcheck disable=SC2086 # words
[ -z "${QUICK:-}" ] || rm -f $pages
# shellcheck disable=SC2086 # words
make --no-print-directory BUILD="$build" $pages >"$scratch/log" 2>&1
ok $? "the pages are made" "$(cat "$scratch/log")"
numbers_are_counted() {
    ! grep " of .* is .*, the text says " "$scratch/log" >"$scratch/counts"
    ok $? "numbers in the texts are what the programs count" "$(cat "$scratch/counts")"
}
[ -z "${QUICK:-}" ] || numbers_are_counted

quick_ends

# ---- In a browser --------------------------------------------------------------------------------

# All pages at the width of a screen and of a phone, in one run of the browser.
inspect() {
    {
        echo '<!DOCTYPE html><meta charset="utf-8"><body><script>const jobs = ['
        find "$(realpath "$notes")" -name '*.html' | LC_ALL=C sort |
            sed 's|.*|{page: "file://&", width: 1280}, {page: "file://&", width: 390},|'
        echo '];</script><script>'
        cat tests/pages/inspect.js
        echo '</script>'
    } >"$scratch/inspect.html"
    "$browser" --headless --no-sandbox --disable-gpu --allow-file-access-from-files --window-size=1280,720 \
        --user-data-dir="$scratch/profile" --virtual-time-budget=600000 --dump-dom \
        "file://$scratch/inspect.html" >"$scratch/seen" 2>"$scratch/browser.log"
    grep -q '^end' "$scratch/seen"
}
check "every page can be opened" inspect
n_pages=$(find "$notes" -name '*.html' | wc -l)
n_opened=$(grep -c '^\(<[^>]*>\)*opened ' "$scratch/seen")
[ "$n_opened" -eq $((2 * n_pages)) ] && [ "$n_pages" -gt 0 ]
ok $? "on a screen and on a phone" "pages: $n_pages, opened: $n_opened"
# none WORDS NAME: no page has a fault that says so.
none() {
    ! grep -o "fault .*$1.*" "$scratch/seen" >"$scratch/faults"
    ok $? "$2" "$(cat "$scratch/faults")"
}
none "a picture is missing" "no picture is missing"
none "no text in its place" "every picture has a text in its place"
none "is cut off" "nothing is cut off on a slide"
none "letters of" "no letter on a slide is smaller than 24 of 720"
none "words of" "no word in a drawing on a slide is smaller than 20 of 720"
none "wider than the screen" "no page is wider than the screen, at 1280 and at 390"

# ---- Figures that can be touched -----------------------------------------------------------------

# What the reader does, and what the figure then says of all its steps (tests/pages/touch.js).
touch_figures() {
    {
        echo "<!DOCTYPE html><meta charset=\"utf-8\"><body><script>const folder = \"file://$(realpath "$notes")/student/slides-notes/\";</script><script>"
        cat tests/pages/touch.js
        echo '</script>'
    } >"$scratch/touch.html"
    "$browser" --headless --no-sandbox --disable-gpu --allow-file-access-from-files --window-size=1280,720 \
        --user-data-dir="$scratch/profile" --virtual-time-budget=600000 --dump-dom \
        "file://$scratch/touch.html" >"$scratch/touched" 2>"$scratch/browser.log"
    grep -q '^end' "$scratch/touched"
}
# The steps of one state, as the page has said them.
touched() {
    sed -n "s/^$1 //p" "$scratch/touched" | sed 's/&gt;/>/g; s/&lt;/</g; s/&amp;/\&/g'
}
# said_is STATE LAB OPTIONS...: every line that `make pixel` prints of the steps, the page says, in this order, and no node more.
said_is() {
    state=$1
    lab=$2
    shift 2
    "$build/pixel/solutions/$lab" "$@" | sed -n 's/^[ 0-9]\{4\}   *//p' >"$scratch/expected"
    touched "$state" | grep -F -x -f "$scratch/expected" >"$scratch/found"
    [ -s "$scratch/expected" ] && diff "$scratch/expected" "$scratch/found" &&
        [ "$(grep -c '^\(node\|leaf\) ' "$scratch/expected")" -eq "$(touched "$state" | grep -c '^\(node\|leaf\) ')" ]
}
make --no-print-directory BUILD="$build" "$build/pixel/solutions/03-kdtree-2d-render" "$build/pixel/solutions/07-kdtree-3d-trace" >"$scratch/log" 2>&1
if slides-notes/touch/compiler.sh >/dev/null; then
    check "figures can be touched" touch_figures
    # The rays that tests/pages/touch.js makes of the worked example's: its eye moved, then turned.
    sed 's/^from .*/from -1.8 -1.1 -0.5/; s/^at .*/at -1.0 -0.5 -0.5/' tests/scenes/worked.nff >"$scratch/moved.nff"
    sed 's/^from .*/from -1.8 -1.1 -0.5/; s/^at .*/at 0 -0.3 -0.5/' tests/scenes/worked.nff >"$scratch/dragged.nff"
    example="--scene example --max-depth 4 --leaf-size 1"
    # shellcheck disable=SC2086 # options
    {
        check "03-search takes the steps of make pixel" said_is 03-search:first 03-kdtree-2d-render $example --pixel 7,7
        check "and where the arrow keys lead" said_is 03-search:moved 03-kdtree-2d-render $example --pixel 5,5
        check "and where the pixel is dragged" said_is 03-search:dragged 03-kdtree-2d-render $example --pixel 2,3
        check "07-search takes the steps of make pixel" said_is 07-search:first 07-kdtree-3d-trace --scene tests/scenes/worked.nff --leaf-size 1 --pixel 1,1
        check "and where the arrow keys move its eye" said_is 07-search:moved 07-kdtree-3d-trace --scene "$scratch/moved.nff" --leaf-size 1 --pixel 1,1
        check "and where the ray is dragged" said_is 07-search:dragged 07-kdtree-3d-trace --scene "$scratch/dragged.nff" --leaf-size 1 --pixel 1,1
    }
    touched 08-cost:first | sed -n 's/^Plane .*, cost //p' >"$scratch/costs"
    [ "$(wc -l <"$scratch/costs")" -eq 31 ] &&
        grep -q "the cheapest: $(sort -n "$scratch/costs" | awk 'NR == 1 { printf "%.3g", $1 }')" slides-notes/figures/08-cost.svg
    ok $? "08-cost has 31 planes, and the still figure's cheapest" "$(sort -n "$scratch/costs" | head -n 2)"
    ! grep '^fault ' "$scratch/touched" >"$scratch/faults"
    ok $? "they can be stepped back, run, and be read without JavaScript" "$(cat "$scratch/faults")"
    release_is_live() {
        make -n -p BUILD="$build" release-pack >"$scratch/rules" 2>/dev/null
        grep -a -q '^TOUCH := .' "$scratch/rules"
    }
    check "and in a release, too" release_is_live
else
    skip "figures that can be touched" "there is no compiler for them (common/setup/packages.txt names the packages)"
fi

# ---- PDF -----------------------------------------------------------------------------------------

slides=$notes/student/slides-notes/slides-2d
check "slides can be printed" slides-notes/make/print.sh "$slides.html" "$scratch/slides.pdf"
n_slides=$(grep -o '<div[^>]* class="slide' "$slides.html" | wc -l)
n_printed=$(grep -a -c '/Type /Page$' "$scratch/slides.pdf")
[ "$n_slides" -gt 1 ] && [ "$n_printed" -eq "$n_slides" ]
ok $? "each is a page" "slides: $n_slides, pages: $n_printed"
! grep -a -q '(file:' "$scratch/slides.pdf" && grep -a -q '(\.\./labs/01-naive-2d/README\.html)' "$scratch/slides.pdf"
ok $? "their links lead from its folder, wherever that is" "$(grep -a -o '(file:[^)]*)' "$scratch/slides.pdf" | sort -u)"

# ---- Links ---------------------------------------------------------------------------------------

# Links of a page that lead nowhere, or not by a relative path; of PDF only those that `make notes` will print.
broken_links() {
    folder=$(dirname "$1")
    grep -o '<a [^>]*href="[^"]*"' "$1" | sed 's/.*href="//; s/"$//' | sort -u | while IFS= read -r link; do
        file=${link%%#*}
        case $link in
        https:*) continue ;;
        /* | *:*) echo "$1: $link is no relative path" ;;
        *.pdf) [ -e "$folder/${link%.pdf}.html" ] || echo "$1: $link has no page" ;;
        *)
            target=$1
            [ -z "$file" ] || target=$folder/$file
            [ -f "$target" ] || { echo "$1: $link leads nowhere" && continue; }
            case $link in
            *#*) grep -q " id=\"${link#*#}\"" "$target" || echo "$1: nothing is called ${link#*#} in $target" ;;
            esac
            ;;
        esac
    done
}
find "$notes" -name '*.html' | while IFS= read -r page; do broken_links "$page"; done >"$scratch/broken"
[ ! -s "$scratch/broken" ]
ok $? "no link is broken" "$(cat "$scratch/broken")"

# ---- German slides -------------------------------------------------------------------------------

# What the slides of a page share in both languages, a line each, by slide: links, figures, code, marks and numbers; so also
# the minutes of the speaker notes. Not blocks of pseudocode, pictures, gaps in formulas, and what stands for a character.
facts() {
    sed 's/\(src="data:\|lspace="\|rspace="\|width="\)[^"]*"//g; s/&#[0-9]*;//g; s/<pre[^>]*><code>/<pre>/g' "$1" | tr '\n' ' ' | sed 's/<div[^>]* class="slide/\n&/g' | awk '
    NR > 1 {
        while (match($0, /href="[^"]*"|data-name="[^"]*"|<code[^>]*>[^<]*|<!--[^>]*-->|[0-9]+([.][0-9]+)?/)) {
            print "slide " NR - 1 ": " substr($0, RSTART, RLENGTH)
            $0 = substr($0, RSTART + RLENGTH)
        }
    }' | LC_ALL=C sort
}
german=$notes/instructor/slides-notes
for chapter in 2d 3d; do
    facts "$german/slides-$chapter.html" >"$scratch/english"
    facts "$german/slides-$chapter.de.html" >"$scratch/german"
    [ "$(wc -l <"$scratch/english")" -gt 100 ] && grep -q '<html lang="de">' "$german/slides-$chapter.de.html" &&
        diff "$scratch/english" "$scratch/german" >"$scratch/differ"
    ok $? "slides-$chapter: minutes, links, figures, code and numbers of each slide are the same in German" "$(cat "$scratch/differ")"
done

# In a copy of the course: a paragraph that is changed, and an entry that is a draft, stay English.
in_copy() {
    (cd "$scratch/course" && "$@" 2>&1)
}
# What building the copy's slides says of their German.
slides_of_copy() {
    for chapter in 2d 3d; do
        in_copy slides-notes/make/build.sh site instructor slides slides-notes/notes-$chapter.md site/slides-$chapter.de.html ""
    done
}
mkdir -p "$scratch/course/site"
for part in ./*; do ln -s "$PWD/$part" "$scratch/course/$part"; done
ln -s "$(realpath "$notes")/runs" "$scratch/course/runs"
rm "$scratch/course/slides-notes"
cp -R slides-notes "$scratch/course"
slides_of_copy >"$scratch/before"
n_english=$(grep -c 'not in German yet' "$scratch/before")
awk '/^<details>/ { on_slide = 1 } on_slide && !done && sub(/^- /, "- Changed: ") { done = 1 } { print }' slides-notes/notes-2d.md \
    >"$scratch/course/slides-notes/notes-2d.md"
awk '/^#: / && ++n == 2 { print "#, fuzzy" } { print }' slides-notes/german.po >"$scratch/course/slides-notes/german.po"
draft=$(sed -n '/^#, fuzzy/,/^$/s/^msgid "\(.*\)"$/\1/p' "$scratch/course/slides-notes/german.po")
slides_of_copy >"$scratch/after"
[ "$(grep -c 'not in German yet' "$scratch/after")" -eq $((n_english + 2)) ] &&
    grep -q '<li>Changed: ' "$scratch/course/site/slides-2d.de.html" && grep -q -F ">$draft</h2>" "$scratch/course/site/slides-2d.de.html"
ok $? "a changed paragraph and a draft are in English (now $n_english paragraphs)" "$(cat "$scratch/after")"
if command -v msgmerge >/dev/null; then
    check "make german runs" in_copy slides-notes/make/german.sh . 2d 3d
    sed -n '/^#, fuzzy/,/^$/p' "$scratch/course/slides-notes/german.po" >"$scratch/drafts"
    grep -q 'Changed: ' "$scratch/drafts"
    ok $? "it takes the paragraph in as a draft" "$(cat "$scratch/drafts")"
else
    skip "make german" "there is no gettext (make notes installs it)"
fi

# ---- Editions ------------------------------------------------------------------------------------

# The words of pages, without marks and blanks, on one line.
words() {
    sed 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g; s/&quot;/"/g; s/&#39;/'"'"'/g; s/\xc2\xa0//g' "$@" | tr -d '\n\t *`'
}
# The beginning of each reason and of each solved exercise in the key, a line each.
sed '1,/^## Answers/d; s/^\([0-9]*\)\. /**00.\1** /; s/<!-- [^>]*-->//g' slides-notes/questions.md | tr '\n' ' ' |
    grep -o '\*\*[0-9][0-9]\.[0-9]*\*\* [^*]*' | sed 's/^[^ ]* //; s/ - $//; s/ ---.*//' | tr -d ' `' >"$scratch/answers"
for edition in student instructor; do
    find "$notes/$edition/slides-notes" -name '*.html' -exec grep -h -v -e 'data:image' {} + >"$scratch/pages"
    words "$scratch/pages" >"$scratch/$edition"
done
n_answers=$(wc -l <"$scratch/answers")
for edition in student instructor; do
    while IFS= read -r answer; do
        ! grep -q -F -e "$answer" "$scratch/$edition" || echo "$answer"
    done <"$scratch/answers" | sort >"$scratch/found-$edition"
done
[ "$n_answers" -eq 48 ] && [ "$(wc -l <"$scratch/found-instructor")" -eq "$n_answers" ]
ok $? "the instructor's edition holds every answer of the key" "$(sort "$scratch/answers" | comm -23 - "$scratch/found-instructor")"
[ ! -s "$scratch/found-student" ] && ! grep -r -l -e 'class="answer"' -e 'class="speaker"' "$notes/student" >>"$scratch/found-student" &&
    [ -f "$notes/instructor/slides-notes/TEACHING.html" ] && [ ! -e "$notes/student/slides-notes/TEACHING.html" ]
ok $? "the student edition holds none, nor the page for lecturers" "$(cat "$scratch/found-student")"

# A lecturer says "03.1": the number is on the slide, in the list of questions and in the key.
sed -n 's/^- \*\*\([0-9][0-9]\.[0-9]\)\*\* .*/\1/p' slides-notes/questions.md | sort -u >"$scratch/numbers"
for edition in student instructor; do
    cat "$notes/$edition"/slides-notes/slides-*.html | grep -o '<h2[^>]*>Question [^<]*' | sed 's/.* //' | sort >"$scratch/on-slides"
    grep -o '<strong>[0-9][0-9]\.[0-9]</strong>' "$notes/$edition/slides-notes/questions.html" | tr -dc '0-9.\n' | sort >"$scratch/listed"
    if [ "$edition" = student ]; then cp "$scratch/numbers" "$scratch/expected"; else sort "$scratch/numbers" "$scratch/numbers" >"$scratch/expected"; fi
    check "every question has its number on a slide ($edition)" diff "$scratch/numbers" "$scratch/on-slides"
    check "and in the list of questions ($edition)" diff "$scratch/expected" "$scratch/listed"
done

# The labs' own programs are skeletons, which draw next to nothing.
! grep -n '^>.*make \(view\|pixel\|movie\) ' slides-notes/notes-*.md | grep -v 'SOLUTION=1' >"$scratch/skeletons"
ok $? "speaker notes show the solutions" "$(cat "$scratch/skeletons")"

# ---- A release -----------------------------------------------------------------------------------

if why=$(sh common/setup/checkout.sh); then
    # Of the pages that are here, and of a handout that is none. release [PAGE]: with one page more.
    mkdir "$scratch/handouts"
    echo packed | tee "$scratch/handouts/03-lab.tar.gz" >"$scratch/handouts/03-lab.txt"
    release() {
        { find "$notes/student" "$notes/instructor" -name '*.html' && printf '%s\n' "$@"; } |
            tests/handout/release.sh "$notes" "$scratch/handouts" "$scratch/release"
    }
    check "a release is packed" release
    packed=$(find "$scratch/release" -mindepth 1 -maxdepth 1)
    is_whole() {
        (cd "$packed" && sha256sum --quiet -c SHA256SUMS && [ "$(wc -l <SHA256SUMS)" -eq 4 ]) || return 1
        for edition in student instructor; do
            tar --extract --directory="$scratch" --file="$packed/slides-notes-$edition.tar.gz" || return 1
            (cd "$notes/$edition" && find . -name '*.html' | sort) >"$scratch/expected"
            (cd "$scratch/slides-notes-$edition" && find . -type f | sort) | diff "$scratch/expected" - || return 1
        done
        grep -q '^[0-9]* slides-notes/slides-2d.html$' "$packed/CONTENTS.txt" && grep -q '^03-lab.tar.gz ' "$packed/CONTENTS.txt"
    }
    check "its sums are right, and each edition has all of its pages" is_whole
    ! grep -r -l -e 'class="answer"' -e 'class="speaker"' -e "Instructor's edition" "$scratch/slides-notes-student" >"$scratch/answers"
    ok $? "the students' archive has no answer" "$(cat "$scratch/answers")"
    nothing_half_written() {
        ! release "$notes/student/no-such-page.html" || { echo "packed without a page"; return 1; }
        [ "$(ls -A "$scratch/release")" = "$(basename "$packed")" ] && (cd "$packed" && sha256sum --quiet -c SHA256SUMS)
    }
    check "where a page is missing, the release before stays as it was" nothing_half_written
else
    skip "a release" "$why"
fi

# ---- Contrast, time, sameness --------------------------------------------------------------------

# The lowest contrast of a text and its ground in style.css, in the light and the dark scheme (WCAG 2.1).
contrasts() {
    awk '
    function part(hex) { hex = (index("0123456789abcdef", substr(hex, 1, 1)) - 1) * 16 + index("0123456789abcdef", substr(hex, 2, 1)) - 1
        hex /= 255; return hex <= 0.04045 ? hex / 12.92 : ((hex + 0.055) / 1.055) ^ 2.4 }
    function light(c) { return 0.2126 * part(substr(c, 2, 2)) + 0.7152 * part(substr(c, 4, 2)) + 0.0722 * part(substr(c, 6, 2)) }
    function against(a, b, x, y) { x = light(a); y = light(b); return x > y ? (x + 0.05) / (y + 0.05) : (y + 0.05) / (x + 0.05) }
    /^ *--[a-z]+: #/ { name = $1; gsub(/[-:]/, "", name); if (name == "ground") scheme++; colour[scheme, name] = substr($2, 1, 7) }
    END { split("ground panel", grounds); split("text muted link accent", texts)
        for (s = 1; s <= 2; s++) for (g in grounds) for (t in texts)
            print against(colour[s, grounds[g]], colour[s, texts[t]]), s, texts[t], grounds[g] }' slides-notes/make/style.css
}
contrasts | sort -n >"$scratch/contrasts"
[ "$(wc -l <"$scratch/contrasts")" -eq 16 ] && awk '$1 < 4.5 { exit 1 }' "$scratch/contrasts"
ok $? "text stands out from its ground (WCAG AA)" "$(head -n 3 "$scratch/contrasts")"

# The minutes of a chapter's plan are those of its slides, and two for each question.
for chapter in slides-notes/notes-*.md; do
    awk '
    /^## [0-9]+\./ { section = $2; next }
    /^## / { section = "" }
    /<summary>Slide, / { split($0, at, "Slide, "); spent[section] += at[2] }
    /^\[Question / { spent[section] += 2 }
    /^\| [0-9]+\. .* \| [0-9]+ \|$/ { planned[$2] = $(NF - 1) }
    END { for (s in spent) if (spent[s] != planned[s]) { print s, "plan:", planned[s], "slides:", spent[s]; bad = 1 }; exit bad }
    ' "$chapter" >"$scratch/plan"
    ok $? "$chapter: the plan's minutes are the slides'" "$(cat "$scratch/plan")"
done

(cd "$notes" && find . -name '*.html' -exec sha256sum {} + | sort) >"$scratch/first"
find "$notes" -name '*.html' -delete
make --no-print-directory BUILD="$build" notes-html >"$scratch/log" 2>&1
(cd "$notes" && find . -name '*.html' -exec sha256sum {} + | sort) >"$scratch/second"
check "made twice, the pages are the same bytes" cmp "$scratch/first" "$scratch/second"
numbers_are_counted
# In the labs' texts the marks of numbers are cut off with the solutions: there these are looked at.
marked_numbers() {
    grep -l '<!-- [0-9][0-9]-[a-z0-9-]*: ' solutions/*/*.md | while IFS= read -r text; do
        slides-notes/make/build.sh "$notes/solutions" student page "$text" "$scratch/text.html" "" 2>&1 || echo "$text: no page"
    done
}
make --no-print-directory BUILD="$build" notes-runs >"$scratch/log" 2>&1
ok $? "each count of a text is made" "$(cat "$scratch/log")"
marked_numbers >"$scratch/counts"
[ ! -s "$scratch/counts" ]
ok $? "numbers in the labs' texts, too" "$(cat "$scratch/counts")"

finish

#!/bin/sh
# No drift: labs/ is cut from solutions/, every hole has points, a task text and a test, and links lead somewhere.
. tests/tap.sh

tools=${BUILD:-build}/tools

# labs/ is what cutting gives.
tests/tools/cut_labs.sh "$tools/holes" "$scratch/labs"
check "labs/ is cut from solutions/ (else: make skeletons)" diff -r labs "$scratch/labs"

# A text of a task in lab.json, which has one field a line: json_field FILE TASK FIELD
json_field() {
    awk -v task="\"$2\"" -v field="\"$3\":" '
        $1 == "\"id\":" { inside = index($2, task) == 1 }
        inside && $1 == field { sub(/^[^:]*: */, ""); sub(/,$/, ""); gsub(/"/, ""); print; exit }' "$1"
}

# The hints of a lab.json: a line "task TAB check TAB hint" each, the check "first" for the task's own.
json_hints() {
    awk '
        function text(line) { sub(/^ *"[^"]*": "/, "", line); sub(/",?$/, "", line); return line }
        $1 ~ /^}/ { inside = 0 }
        $1 == "\"id\":" { task = $2; gsub(/[",]/, "", task) }
        $1 == "\"hint\":" { print task "\tfirst\t" text($0) }
        inside { check = $1; gsub(/[":]/, "", check); print task "\t" check "\t" text($0) }
        $1 == "\"hints\":" { inside = 1 }' "$1"
}

# The names that a text has, sorted.
names() {
    grep -o '[A-Za-z_][A-Za-z0-9_]*' | sort -u
}

# What of a hint is code of the answer, a finding a line. A hint asks or points at a place. Code shows by an
# operator, a bracket or a call, as in "{width, height, 1}", and by a name that stands in the solution's
# code and in nothing that is handed out, as CL_TRUE and INFINITY. Those names are in $scratch/own-names.
hint_code() {
    echo "$1" | grep -o '[][{}<>=*&|%^]\|[A-Za-z0-9_](\| [-+/] '
    echo "$1" | names | comm -12 - "$scratch/own-names"
}

printf 'CL_TRUE\nINFINITY\n' >"$scratch/own-names"
for hint in 'clEnqueueReadImage with CL_TRUE waits.' 'The region is {width, height, 1}.' \
    'At first nothing has been seen: INFINITY.' 'Where is b - sqrt(disc)?' 'Ask get_global_id(0).'; do
    [ -n "$(hint_code "$hint")" ]
    ok $? "the code in a hint is found: $hint"
done
[ -z "$(hint_code 'In a half-open cell of 4 x 2, where is the point (3, 4)?')" ]
ok $? "no code is found in a hint without"

# wrong_points CHECKS PAGE...: a line for each number of points in the pages that is not lab.json's, of which
# --list-checks tells in CHECKS; and for each task of which they state none. A task's is the first "N points" from its
# heading on, a check's the number behind its name, or in its row of a table.
wrong_points() {
    awk '
        function compare(id, found) {
            if (found + 0 != points[id])
                printf "%s:%d: found %d points for %s, lab.json: %d\n", FILENAME, FNR, found, id, points[id]
        }
        FNR == NR { points[$1] = $3; points[$2] += $3; tasks[$2]; next }
        /^### Task / { task = $3 }
        task in tasks && match($0, /[0-9]+ points/) {
            compare(task, substr($0, RSTART, RLENGTH))
            delete tasks[task]
        }
        {
            rest = $0
            while (match(rest, /`[^`]*` [0-9]+/)) {
                split(substr(rest, RSTART + 1, RLENGTH - 1), words, /` /)
                if (words[1] in points) compare(words[1], words[2])
                rest = substr(rest, RSTART + RLENGTH)
            }
        }
        /^\| `[^`]*` \|/ {
            n = split($0, cells, / *\| */)
            id = substr(cells[2], 2, length(cells[2]) - 2)
            for (i = 3; id in points && i <= n; i++) if (cells[i] ~ /^[0-9]+$/) compare(id, cells[i])
        }
        END { for (task in tasks) printf "%s: found no line \"%d points\" for %s\n", FILENAME, points[task], task }
    ' "$@"
}

printf 'a-far\ta\t30\na-near\ta\t10\nb-all\tb\t60\n' >"$scratch/checks"
cat >"$scratch/page.md" <<'END'
### Task a
`a.cl`, 41 points
### Task b
| `a-far` | a | 30 |
| `a-near` | a | 11 |
- Checks: `a-far` 30, `a-near` 12.
END
cat >"$scratch/expected" <<END
$scratch/page.md:2: found 41 points for a, lab.json: 40
$scratch/page.md:5: found 11 points for a-near, lab.json: 10
$scratch/page.md:6: found 12 points for a-near, lab.json: 10
$scratch/page.md: found no line "60 points" for b
END
wrong_points "$scratch/checks" "$scratch/page.md" >"$scratch/found"
check "wrong points in a page are found" diff "$scratch/expected" "$scratch/found"

for folder in solutions/*/; do
    lab=$(basename "$folder")
    manifest=$folder/lab.json
    "$tools/grade" --lab "$lab" --list-checks >"$scratch/checks" 2>"$scratch/said"
    ok $? "$lab: lab.json has points for the judge's checks, 100 in all" "$(cat "$scratch/said")"
    checks=$(cat "$scratch/checks")
    wrong=$(wrong_points "$scratch/checks" "$folder"*.md)
    [ -z "$wrong" ]
    ok $? "$lab: its pages state the points of lab.json" "$wrong"
    n_holes=0
    for source in "$folder"*.c "$folder"*.h "$folder"*.cl; do
        [ -f "$source" ] || continue
        for hole in $("$tools/holes" list "$source"); do
            n_holes=$((n_holes + 1))
            [ "$(json_field "$manifest" "$hole" file)" = "$(basename "$source")" ]
            ok $? "$lab: $hole is in the file that lab.json names"
            cat "$folder"*.md | grep -q "^### Task $hole\b"
            ok $? "$lab: $hole has a task text in its pages" "no line \"### Task $hole\""
        done
    done
    [ "$n_holes" -ge 1 ] && [ "$n_holes" -le 6 ]
    ok $? "$lab: one to six holes" "found $n_holes"
    n_tasks=$(grep -c '"id":' "$manifest")
    [ "$n_tasks" = "$n_holes" ]
    ok $? "$lab: every task of lab.json is a hole" "lab.json: $n_tasks, holes: $n_holes"
    for id in $(echo "$checks" | cut -f 1); do
        cat "$folder"*.md | grep -q "\`$id\`"
        ok $? "$lab: its pages name the check $id"
    done
    # Of the solution only the code, of what is handed out the words of comments, too.
    cat labs/"$lab"/*.[ch]* labs/"$lab"/*.md | names >"$scratch/given-names"
    sed 's|//.*||' "$folder"*.[ch]* | names | comm -23 - "$scratch/given-names" >"$scratch/own-names"
    json_hints "$manifest" >"$scratch/hints"
    n_first=$(grep -c "$(printf '\tfirst\t')" "$scratch/hints")
    [ "$n_first" = "$n_tasks" ]
    ok $? "$lab: every task has a first hint" "tasks: $n_tasks, first hints: $n_first"
    while IFS="$(printf '\t')" read -r task check hint; do
        code=$(hint_code "$hint")
        [ -z "$code" ]
        ok $? "$lab: the hint for $check of $task holds no code of the answer" "found: $code"
    done <"$scratch/hints"
done

# ---- Links --------------------------------------------------------------------------------------

# headings FILE: as they are named behind a "#", a line each: lower case, no punctuation, hyphens for blanks.
headings() {
    sed -n 's/^##* //p' "$1" | tr 'A-Z ' 'a-z-' | LC_ALL=C sed 's/[]!-,.:-@^`{-~\/[]//g'
}

# link_fault FILE LINK: why it leads nowhere: to no file or folder, or there to no heading; nothing where it does.
link_fault() {
    target=$(dirname "$1")/${2%%#*}
    [ -n "${2%%#*}" ] || target=$1
    if [ ! -e "$target" ]; then
        echo "there is no $target"
    elif [ "$2" != "${2#*#}" ] && ! headings "$target" | grep -q -x -e "${2#*#}"; then
        echo "$target has no such heading"
    fi
}

printf '# A heading (of two)\n' >"$scratch/text.md"
for link in '#a-heading-of-two' 'text.md#a-heading-of-two' .; do
    fault=$(link_fault "$scratch/text.md" "$link")
    [ -z "$fault" ]
    ok $? "a link to $link is found" "$fault"
done
for link in '#a-heading' none.md 'text.md#a-heading'; do
    [ -n "$(link_fault "$scratch/text.md" "$link")" ]
    ok $? "a link to $link is missed"
done

for text in README.md CONTRIBUTING.md $(find slides-notes labs common kernels tests -name '*.md' | sort); do
    # shellcheck disable=SC2013,SC2016 # words are wanted, and no expansion: no name in the course has a blank in it
    for link in $(sed 's/`[^`]*`//g' "$text" | grep -o '](\([^)]*\))' | sed 's/^](//; s/)$//' | grep -v ://); do
        fault=$(link_fault "$text" "$link")
        [ -z "$fault" ]
        ok $? "$text: $link leads somewhere" "$fault"
    done
done

# ---- Sizes of texts -----------------------------------------------------------------------------

# is_short FILE LINES WORDS
is_short() {
    [ "$(wc -l <"$1")" -le "$2" ] && [ "$(wc -w <"$1")" -le "$3" ] && return
    echo "found $(wc -l <"$1") lines and $(wc -w <"$1") words"
    return 1
}

# Does a page with tasks have its worked example in its first 60 lines?
example_comes_early() {
    ! grep -q '^### Task ' "$1" || sed -n '1,60s/^\(#\|\*\*\)//p' "$1" | grep -q -i -w -e 'example' -e 'by hand'
}

check "README.md has at most 130 lines, 1500 words" is_short README.md 130 1500
check "TEACHING.md has at most 150 lines, 2500 words" is_short slides-notes/TEACHING.md 150 2500
for text in labs/*/*.md; do
    check "$text has at most 150 lines, 1700 words" is_short "$text" 150 1700
    check "$text: the worked example is in the first 60 lines" example_comes_early "$text"
done

# A lab's row in README.md: the hours that its page names, and the lines of its answers without comments.
for folder in solutions/*/; do
    lab=$(basename "$folder")
    hours=$(cat "$folder"*.md | grep -o 'about [a-z]* hours' | sed 's/^about //; q')
    n_lines=$(for source in "$folder"*.[ch]*; do
        for hole in $("$tools/holes" list "$source"); do "$tools/holes" read "$source" "$hole"; done
    done | grep -v -c -e '^ *//' -e '^ *$')
    grep -F "labs/$lab/" README.md | grep -q "| $hours | $n_lines |\$"
    ok $? "README.md: $lab takes $hours, $n_lines lines"
done

# ---- Measured times -----------------------------------------------------------------------------

# They are in one file. Elsewhere is a round ratio, bound to a figure there by a mark behind it; a time that nobody
# measured is marked as given.
times=tests/bench/RESULTS.md

# times_in FILE: its lines with a time or a rate that says nothing of being given.
times_in() {
    grep -n -E '[0-9] ?(ms|µs)\b|[0-9] ?[MG]rays?/s|(million|billion) rays (a|per) second|[0-9] (frames|pictures) (a|per) second|[0-9] FPS\b|[Mm]illiseconds (a|per) frame' "$1" |
        grep -v '<!-- given -->'
}

# ratios_off FILE: ratios whose figure is not in the one file, or further off than a fifth.
ratios_off() {
    grep -o '[0-9.]*<!-- measured: [^>]* -->' "$1" | while IFS= read -r ratio; do
        figure=$(echo "$ratio" | sed 's/.*measured: \(.*\) -->/\1/')
        grep -q -F -e "| $figure |" "$times" || echo "$times has no \"| $figure |\""
        echo "${ratio%%<*} ${figure%% *}" | awk '$1 < 0.8 * $2 || $1 > 1.2 * $2 { print $1, "is more than a fifth off", $2 }'
    done
}

# What is looked for would be found.
printf '%s\n' 'A frame takes 12.5 ms.' 'It draws 3.1 Mray/s.' 'That is 60 frames a second.' '16.7 ms<!-- given -->' >"$scratch/text.md"
[ "$(times_in "$scratch/text.md" | wc -l)" -eq 3 ]
ok $? "a measured time is found, a given one is not"
printf '30<!-- measured: 30 (25 to 32) --> 25<!-- measured: 34 (32 to 37) --> 3<!-- measured: 3 (1 to 2) -->\n' >"$scratch/text.md"
[ "$(ratios_off "$scratch/text.md" | wc -l)" -eq 2 ]
ok $? "a ratio that is off, and one without a figure, is found"

for text in README.md solutions/*/*.md slides-notes/notes-*.md $(find common -name '*.md' | sort) tests/*.md; do
    found=$(times_in "$text")
    [ -z "$found" ]
    ok $? "$text has no measured time: these are in $times" "$found"
    found=$(ratios_off "$text")
    [ -z "$found" ]
    ok $? "$text: its ratios are those of $times" "$found"
done

quick_ends

# ---- Figures ------------------------------------------------------------------------------------

# The pictures of the READMEs and notes are what the solutions draw. (make figures mends them.) Colours
# may differ in their last bit from device to device, hence one of 255 levels; in 3D a ray in a thousand
# may graze a sphere here and miss it there, and the heat map shows each step that a ray takes more. What
# the textbook's quadratic makes of small spheres, and a point of its own surface, is rounding and nothing
# else: they only have to be there. Small mirrors multiply rounding, so one ray in fifty may end elsewhere.
# A window, drawn where there is a display for it, shows how fast it was.
BUILD=${BUILD:-build}
check "the figures can be drawn" tests/figures.sh "$scratch/figures" "$BUILD"
for figure in slides-notes/figures/*; do
    drawn=$scratch/figures/$(basename "$figure")
    case $figure in
    */07-view.png) ! command -v Xvfb >/dev/null || check "$figure is drawn" test -s "$drawn" ;;
    */05-textbook.png | */09-acne.png) check "$figure is drawn" test -s "$drawn" ;;
    */09-*.png) check "$figure is what a solution draws" "$tools/compare" "$drawn" "$figure" 0.004 5000 ;;
    */0[4-8]*.png | */10-*.png) check "$figure is what a solution draws" "$tools/compare" "$drawn" "$figure" 0.004 300 ;;
    *.png) check "$figure is what a solution draws" "$tools/compare" "$drawn" "$figure" 0.004 ;;
    *) check "$figure is what a solution draws" cmp "$drawn" "$figure" ;;
    esac
done

finish

#!/bin/sh
# make copies: in made classes the planted pairs come first; innocents do not; nothing is said or given away
# that should not be.
#
#     sh tests/suites/copies.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh
out=$scratch/out

# look STATUS OPTION...: into $out, with its messages in $scratch/said
look() {
    wanted_status=$1
    shift
    exits "$wanted_status" look_at "$@"
}
look_at() { tests/copies/copies.sh --build "$build" --output "$out" "$@" >"$scratch/said" 2>&1 </dev/null; }

# pair N: the two names of a pair, from 1, in the order of the alphabet.
pair() { jq -r --argjson n "$1" '[.pairs[$n - 1].authors[].name] | sort | join(" ")' "$out/copies.json"; }
# no_pair JQ: is there no listed pair for which this holds of both names?
no_pair() { jq -e "[.pairs[] | select([.authors[].name | $1] | all)] == []" "$out/copies.json"; }
# lacks FILE WORDS...: has the file none of these, in any case?
lacks() {
    in_file=$1
    shift
    for words; do ! grep -inF -- "$words" "$in_file" || return 1; done
}
is() { [ "$1" = "$2" ] || { echo "found \"$1\", expected \"$2\""; return 1; }; }

# ---- A class of 25 ------------------------------------------------------------------------------

# The text of one task: the solution's without its placeholders and comments.
solved() { "$build/tools/holes" read "solutions/$1/$2" "$3" | grep -v '^ *//'; }
# The names of the known answers to a task, right or wrong.
known() { "$build/tools/known" list "$2" | awk -v kind="$1" -v task="$3" '$1 == kind && $3 == task { print $2 }' | LC_ALL=C sort; }
# The N-th line, from 0 and round again.
nth() { awk -v n="$1" '{ line[NR - 1] = $0 } END { print line[n % NR] }'; }
text_of() { "$build/tools/known" read "$@"; }

# Other names for all that an answer declares, and no comments: the names get an ending.
renamed() {
    cat >"$scratch/text"
    grep -oE '\b(float[234]?|u?int[24]?|uchar|bool|Circle|NodeRel|BBox2D|Light|Sphere|TodoEntry) \*?[a-zA-Z_0-9]+( =|;|\[)' "$scratch/text" |
        sed -E 's/( =|;|\[)$//; s/.* \*?//' | sort -u |
        sed "s/.*/s,(^|[^.>a-zA-Z_0-9])&\\\\b,\\\\1&_$1,g/" >"$scratch/names"
    sed -E -f "$scratch/names" "$scratch/text" | grep -v '^ *//'
}

# hand_in NAME LAB DRAW...: a submission from the skeleton; `DRAW... FILE TASK` prints the answer to each task.
hand_in() {
    who=$1 of_lab=$2
    shift 2
    mkdir -p "$class/$who"
    jq -r '.files[]' "solutions/$of_lab/lab.json" | while read -r file; do cp "labs/$of_lab/$file" "$class/$who"; done
    jq -r '.tasks[] | "\(.file) \(.id)"' "solutions/$of_lab/lab.json" | while read -r file task; do
        "$@" "$file" "$task" >"$scratch/answer" </dev/null &&
            "$build/tools/holes" fill "$class/$who/$file" "$task" "$scratch/answer" >"$scratch/filled" &&
            cp "$scratch/filled" "$class/$who/$file"
    done
}

# What innocent number I writes: mostly what all write, sometimes another right answer, or a wrong one.
innocent() { # I LAB FILE TASK
    turn=$(($1 * 7 + $(printf %s "$4" | wc -c) * ($1 + 3)))
    case $((turn % 10)) in
    [6-7]) text_of "$2" "$(known right "$2" "$4" | nth $turn)" ;;
    [8-9]) text_of "$2" "$(known wrong "$2" "$4" | nth $turn)" ;;
    *) solved "$2" "$3" "$4" ;;
    esac | renamed "$1"
}
# The same mistake in the first task: its text is word for word alike.
mistaken() { # I LAB FILE TASK
    if [ "$4" = "$(jq -r '.tasks[0].id' "solutions/$2/lab.json")" ]; then
        text_of "$2" "$(known wrong "$2" "$4" | nth 3)"
    else
        innocent "$@"
    fi
}
# A text of an author's own; or, where none was written, of the N-th right answers.
own() { # AUTHOR N LAB FILE TASK
    if [ -e "tests/copies/authors/$3/$1.txt" ]; then
        "$build/tools/holes" read "tests/copies/authors/$3/$1.txt" "$5"
    else
        text_of "$3" "$({ known right "$3" "$5" && known wrong "$3" "$5"; } | nth "$2")"
    fi
}
own_renamed() { own "$@" | renamed copy | sed 's/^ *//'; }
# The same in another order, as a text that nobody runs: statements that follow each other from the last to the first,
# operands exchanged.
own_reordered() {
    own "$@" | awk '
        function run_end() { for (; n > 0; n--) print run[n] }
        { indent = match($0, /[^ ]/) }
        n > 0 && indent != at { run_end() }
        /;$/ && !/(if|return|for|continue)/ { run[++n] = $0; at = indent; next }
        { run_end(); print }
        END { run_end() }' |
        sed -E 's/\(([^()&|]*) && ([^()&|]*)\)/(\2 \&\& \1)/; s/([=(]) (\w+) ([+*]) (\w+);/\1 \4 \3 \2;/'
}

class_make() { # LAB
    rm -rf "$class"
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do hand_in "innocent $i" "$1" innocent $i "$1"; done
    for i in 16 17 18 19; do hand_in "mistaken $i" "$1" mistaken $i "$1"; done
    hand_in "pair1 a" "$1" own first 0 "$1"
    hand_in "pair1 b" "$1" own_renamed first 0 "$1"
    hand_in "pair2 a" "$1" own second 1 "$1"
    hand_in "pair2 b" "$1" own_renamed second 1 "$1"
    hand_in "pair3 a" "$1" own third 2 "$1"
    hand_in "pair3 b" "$1" own_reordered third 2 "$1"
}
planted() { # the first three pairs are the planted ones
    found=$(for n in 1 2 3; do pair $n; done | sort)
    is "$found" "pair1 a pair1 b
pair2 a pair2 b
pair3 a pair3 b"
}

for of_all in $(quick 03-kdtree-2d-render 05-spheres 07-kdtree-3d-trace 03-kdtree-2d-render); do
    rm -rf "$out"
    class_make "$of_all"
    check "$of_all: a class of 25" look 0 --lab "$of_all" --submissions "$class"
    check "$of_all: two renamed texts and one in another order are the first three pairs" planted
    check "$of_all: no two with the same known mistake are listed" no_pair 'startswith("mistaken")'
done

# ---- What it says -------------------------------------------------------------------------------

check "a line for each pair" said "look at \"$(jq -r '.pairs[0].authors[0].name' "$out/copies.json")\" and "
check "the last line counts" said "25 authors, 0 without an answer; $(jq '.pairs | length' "$out/copies.json") pairs to look at: see $out/copies.html"
check "the page asks to look" grep -q 'Look at these pairs' "$out/copies.html"
check "the page accuses nobody" lacks "$out/copies.html" copied cheat plagia
check "nor does what is printed" lacks "$scratch/said" copied cheat plagia
check "lines that nobody else has are marked" grep -q '<span class="line only" title="nobody else has this">' "$out/copies.html"
# xmllint knows HTML 4.
xmllint --html --noout "$out/copies.html" 2>&1 | grep error | grep -v 'Tag [a-z]* invalid' >"$scratch/errors"
check "the page is well formed" is "$(cat "$scratch/errors")" ""
check "others cannot read it" test "$(stat -c %a "$out" | cut -c 3)" = 0
cp "$out/copies.json" "$scratch/before.json"
check "once more" look 0 --lab 3 --submissions "$class"
check "gives the same bytes" cmp "$out/copies.json" "$scratch/before.json"
(cd "$scratch" && tar -cf class.tar class)
check "from an archive" look 0 --lab 03 --submissions "$scratch/class.tar"
check "the same" cmp "$out/copies.json" "$scratch/before.json"
check "nothing is left of it" test -z "$(ls "$TMPDIR")"
quick_ends

# ---- A graded class -----------------------------------------------------------------------------

graded=$scratch/graded
mkdir "$graded"
"$build/tools/gradebook" roster 3 "$class" "$graded" >"$graded/names"
echo 03-kdtree-2d-render >"$graded/lab"
mkdir -p "$graded/students/$(jq -r '.pairs[0].authors[0].id' "$out/copies.json")"
echo report >"$graded/students/$(jq -r '.pairs[0].authors[0].id' "$out/copies.json")/report.html"
sums() { find "$graded" -type f ! -path "$graded/copies*" ! -name lock -exec sha256sum {} + | sort; }
sums >"$scratch/sums"
out=$graded
check "the folder of a graded class is enough" look 0
check "the same pairs" cmp "$graded/copies.json" "$scratch/before.json"
check "its files stay as they are" is "$(sums)" "$(cat "$scratch/sums")"
check "names link to reports that are there" grep -q '<a href="students/[a-z0-9-]*/report.html">pair' "$graded/copies.html"
check "with other submissions" look 0 --submissions "$class"
check "they stay as they are, too" is "$(sums)" "$(cat "$scratch/sums")"
check "another lab's class is refused" look 2 --lab 05
check "with one message" said "found a class of 03-kdtree-2d-render, expected one of 05-spheres"
out=$scratch/out

# ---- Names and texts that mean harm --------------------------------------------------------------

lab=03-kdtree-2d-render
mv "$class/pair1 a" "$class/<b>Eve"
mv "$class/pair1 b" "$class/=cmd()"
hand_in comment "$lab" own first 0 "$lab"
file=implicit2DRenderer_KD.cl
sed -i 's,bool atLeaf,/* </pre><script>alert(1)</script> \x1b[31m */ bool atLeaf,' "$class/<b>Eve/$file"
# lines N TEXT: N lines, with their number from 0 for @.
lines() { awk -v n="$1" -v line="$2" 'BEGIN { for (i = 0; i < n; i++) { copy = line; gsub(/@/, i, copy); print copy } }'; }
# Brackets without an end, signs that write their operand twice, a line without one, no UTF-8, DOS line ends, links, no markers, a skeleton.
brackets() { awk 'BEGIN { for (i = 0; i < 50000; i++) printf "(-"; print ";" }'; }
wide() { awk 'BEGIN { printf "x = 0"; for (i = 0; i < 40000; i++) printf "+a"; print ";" }'; }
doubling() {
    printf '#if 1\nx'
    lines 40 "++"
    printf ';\n#endif\n'
    lines 40 "++ "
    printf 'a; '
    lines 90 "(" | tr -d '\n'
    printf a
    lines 90 "+= 1)"
    echo ";"
}
open_comment() { printf '{ { if (x /* \377\376 "\n'; }
for bad in brackets wide doubling open_comment; do hand_in "$bad" "$lab" $bad; done
hand_in dos "$lab" innocent 3 "$lab"
sed -i 's/$/\r/' "$class/dos/$file"
mkdir "$class/linked" "$class/unmarked" "$class/skeleton"
ln -s ../../out/copies.json "$class/linked/$file"
grep -v '// TASK' "$class/dos/$file" >"$class/unmarked/$file"
cp "labs/$lab/$file" "$class/skeleton"
(cd "$class/pair2 b" && zip -qr "../pair2 b.zip" . && cd .. && rm -r "pair2 b")
check "hostile names and texts" look 0 --lab 03 --submissions "$class" --export moss
listed() { jq -e --arg a "$1" --arg b "$2" '[.pairs[] | [.authors[].name] | sort] | index([[$a, $b]])' "$out/copies.json"; }
check "a pair of which one is an archive is found" listed "pair2 a" "pair2 b"
check "a pair of which one has the line ends of DOS" listed dos "innocent 3"
check "three with one text make two pairs" is \
    "$(jq '[.pairs[] | select([.authors[].name | . == "comment" or test("Eve|cmd")] | all)] | length' "$out/copies.json")" 2
check "a name is shown" grep -qF '&lt;b&gt;Eve' "$out/copies.html"
check "and is no markup" lacks "$out/copies.html" '<b>Eve'
check "an answer is shown" grep -qF '&lt;script&gt;' "$out/copies.html"
check "and is no markup, either" lacks "$out/copies.html" '<script'
check "no control characters" is "$(LC_ALL=C tr -dc '\001-\010\013-\037' <"$out/copies.html" | wc -c)" 0
check "skeletons, links, files without markers and those that are no text are no answers" said "4 without an answer"

# ---- For other programs --------------------------------------------------------------------------

export=$out/copies-export
check "the call is said" said "perl moss.pl -l c -d -b base/answers.c answers/*/answers.c"
check "a file for each author" is "$(find "$export/answers" -name answers.c | wc -l)" "$(jq .authors "$out/copies.json")"
check "with the answers" grep -q 'void leaf_loop(void)' "$export/answers/001/answers.c"
check "the skeleton is the base" grep -qF '(void)circles, (void)nodes_Relations, (void)mapNode2Circles;' "$export/base/answers.c"
(cd "$export" && find . && cat info.csv) >"$scratch/goes-out"
check "no names go out" lacks "$scratch/goes-out" eve innocent mistaken pair comment
check "who has which number is beside it" grep -qF "\"'=cmd()\"" "$out/copies-names.csv"
check "another program is refused" look 2 --lab 03 --submissions "$class" --export turnitin
check "with one message" said 'copies: --export: found "turnitin", expected jplag, dolos or moss'

# ---- Too short, too few, too often ----------------------------------------------------------------

everybody() { solved "$@"; }
rm -rf "$class"
for i in 1 2 3 4 5 6 7 8; do hand_in "author $i" "$lab" everybody "$lab"; done
check "where all write the same" look 0 --lab 03 --submissions "$class"
check "no pair is listed" no_pair true
check "and the list says that it says nothing" said "too short to tell: only 0 of 8 authors wrote enough that few others wrote"
check "the page, too" grep -q 'too short to tell' "$out/copies.html"
for i in 1 2 3 4 5 6 7; do hand_in "author $i" "$lab" own third 0 "$lab"; done
hand_in "author 8" "$lab" own second 0 "$lab"
check "where nearly all follow one example" look 0 --lab 03 --submissions "$class"
check "it makes no pair" no_pair true
rm -r "$class"
for i in 1 2 3; do hand_in "author $i" "$lab" everybody "$lab"; done
# Three have the solution's text, and the others their own.
for i in 4 5 6 7; do hand_in "author $i" "$lab" innocent $((i * 2)) "$lab"; done
hand_in "author 8" "$lab" own second 0 "$lab"
check "three with the solution's text, five with others" look 0 --lab 03 --submissions "$class"
check "the solution's text makes no pair" no_pair 'test("[123]$")'
check "they are listed apart" is "$(sed -n '/id="given"/,/<\/div>/p' "$out/copies.html" | grep -o 'author [0-9]' | head -3 | tr '\n' ' ')" \
    "author 1 author 2 author 3 "
rm -r "$class/author "[3-8]
check "two authors" look 0 --lab 03 --submissions "$class"
check "are too few" grep -q 'Found 2 authors, expected 3 or more' "$out/copies.html"
# Two attempts of one student are one author, with the later one's text.
for i in 3 4 5 6; do hand_in "Author $i Doe_${i}_assignsubmission_file_" "$lab" innocent $i "$lab"; done
mv "$class/author 1" "$class/Ada Lovelace_1_assignsubmission_file_"
rm -r "$class/author 2"
hand_in "twice" "$lab" own first 0 "$lab"
mkdir "$class/Jane Doe_2_assignsubmission_file_" "$class/Jane Doe_2_assignsubmission_onlinetext_"
cp "$class/twice/$file" "$class/Jane Doe_2_assignsubmission_file_"
cp "$class/twice/$file" "$class/Jane Doe_2_assignsubmission_onlinetext_"
rm -r "$class/twice"
check "attempts of one student" look 0 --lab 03 --submissions "$class"
check "are one author" is "$(jq -c '[.authors, (.pairs | length)]' "$out/copies.json")" '[6,0]'

# ---- Put around a text so that it is not found ----------------------------------------------------

# A class of 14 in which two have one text, and one of them changed it without another thought.
in_macro() { sed 's/$/ \\/; 1s/^/#define P0 /' "$scratch/plain"; printf '\nP0\n'; }
in_function() { echo "void p0(void) {"; cat "$scratch/plain"; echo "} p0();"; }
after_flood() { echo "#if 0"; lines 20001 "z;"; echo "#endif"; cat "$scratch/plain"; }
after_live_flood() { lines 20001 "z;"; cat "$scratch/plain"; }
after_shadows() {
    printf '{ int x = 0, y = 0, id = 0'
    grep -oE '\b[a-zA-Z_][a-zA-Z_0-9]*\b' "$scratch/skeleton" | sort -u | sed 's/.*/, & = 0/' | tr -d '\n'
    echo '; (void)x; }'
    cat "$scratch/plain"
}
after_dead_shadows() { echo "#if 0"; after_shadows | sed 's/}$/}\n#endif/'; }
after_names() { lines 1001 "int junk@;"; sed 's/\bid\b/number/g; 1s/^/uint number = id;\n/' "$scratch/plain"; }
diluted() { echo "#if 0"; lines 300 "junk_$1_@(@);"; echo "#endif"; cat "$scratch/plain"; }
diluted_block() { echo "if (0) {"; lines 300 "junk_$1_@(@);"; echo "}"; cat "$scratch/plain"; }
after_empty_lines() { lines 401 ""; cat "$scratch/plain"; }
after_many_forms() { lines 3001 "z = @;"; cat "$scratch/plain"; }
after_other_lines() { lines 401 "a_line(@);"; cat "$scratch/plain"; }
hidden() { # HOW LAB FILE TASK
    own first 0 "$2" "$3" "$4" >"$scratch/plain"
    [ -s "$scratch/plain" ] || return 1
    cp "labs/$2/$3" "$scratch/skeleton"
    $1
}
hand_in_pair() { # HOW [HOW OF THE OTHER]
    rm -rf "$class/pair a" "$class/pair b"
    hand_in "pair a" "$lab" hidden "$1" "$lab"
    hand_in "pair b" "$lab" hidden "${2:-plain}" "$lab"
}
plain() { cat "$scratch/plain"; }
one() { diluted one; }
other() { diluted other; }
one_block() { diluted_block one; }
other_block() { diluted_block other; }
hard() { jq -r '.hard[] | "\(.author.name): \(.found)"' "$out/copies.json"; }
rm -rf "$class"
for i in 1 2 3 4 5 6 7 8 9 10 11 12; do hand_in "innocent $i" "$lab" innocent $i "$lab"; done
for how in plain in_macro in_function after_flood after_live_flood after_shadows after_dead_shadows after_names \
    "one other" "one_block other_block" after_empty_lines after_other_lines; do
    # shellcheck disable=SC2086 # one or two words
    hand_in_pair $how
    check "a pair of which a text is changed: $how" look 0 --lab 03 --submissions "$class"
    check "$how: it is listed" listed "pair a" "pair b"
    case $how in
    in_macro | after_flood | "one other") check "$how: and is hard to compare" sh -c 'grep -q "^pair a: " && ! grep -q innocent' <<EOF ;;
$(hard)
EOF
    plain) check "$how: nobody is hard to compare" is "$(hard)" "" ;;
    esac
done
hand_in_pair after_many_forms after_many_forms
check "a pair that shares many forms" look 0 --lab 03 --submissions "$class"
check "has a thousand of them in copies.json" is "$(jq -c '[.pairs[] | .forms | length] | max' "$out/copies.json")" 1000
check "and all are counted" test "$(jq '[.pairs[].shared] | max' "$out/copies.json")" -gt 3000
hand_in_pair after_other_lines
check "a text behind 401 other lines" look 0 --lab 03 --submissions "$class"
check "of a long answer the page has the lines that count" grep -q '<span class="line soft">[0-9]* more lines</span>' "$out/copies.html"
marked() { grep -o '<span class="line only"[^>]*>[^<]*' "$out/copies.html" | sed 's/.*>//' | sort | uniq -c | awk '$1 % 2' | grep .; }
check "as often on the one side as on the other" is "$(marked)" ""
hand_in_pair after_empty_lines
check "behind empty lines" look 0 --lab 03 --submissions "$class"
check "the same" is "$(marked)" ""

# ---- What cannot be read --------------------------------------------------------------------------

as_user=
[ "$(id -u)" -ne 0 ] || as_user="setpriv --reuid 65534 --regid 65534 --clear-groups"
mkdir -m 1777 "$scratch/everybodys"
mkdir "$class/<i>closed"
cp "$class/pair a/$file" "$class/<i>closed"
chmod 000 "$class/<i>closed"
read_as_user() {
    # shellcheck disable=SC2086 # a command and its words
    TMPDIR=$scratch/everybodys SANDBOX=none $as_user tests/copies/copies.sh --build "$build" --lab 03 \
        --submissions "$class" --output "$scratch/everybodys/out" >"$scratch/said" 2>&1 </dev/null
}
check "a folder that is closed" exits 0 read_as_user
check "is named" said 'copies: "<i>closed" cannot be read, and is not compared'
check "and counted" said 'cannot be read: 1 of the submissions'
out=$scratch/everybodys/out
check "it is on the page" grep -qF '<td class="name">&lt;i&gt;closed</td><td>files that cannot be read' "$out/copies.html"
check "and in what programs read" is "$(jq -c '[.unread[].name]' "$out/copies.json")" '["<i>closed"]'
check "the others are compared" listed "pair a" "pair b"
chmod 000 "$class"/*
check "where all are closed" exits 2 read_as_user
check "one message says so" said "none of 15 entries can be read"
chmod 755 "$class"/*
out=$scratch/out

# ---- Over several labs ----------------------------------------------------------------------------

# In each of two labs all are alike only a little, and one pair is alike in both. A student has another name
# and the same address.
graded_as() { # FOLDER LAB: the class, as if it had been graded
    rm -rf "${scratch:?}/$1"
    mkdir "$scratch/$1"
    "$build/tools/gradebook" roster "${2%%-*}" "$class" "$scratch/$1" >"$scratch/$1/names"
    jq --arg lab "$2" '{lab: $lab, title: "A lab", max_score: 100, tasks: [], without: [], students: [.entries[] |
        {id, name, number, attempt, entry, status: "graded", score: 50, counts: true,
        owners: [{name, id_number: "", address: (if (.name | startswith("Ada")) then "ada@example.org" else "" end)}]}]}' \
        "$scratch/$1/roster.json" >"$scratch/$1/gradebook.json"
}
several() { # LAB ADA
    rm -rf "$class"
    for i in 1 2 3 4 5 6 7 8; do hand_in "innocent $i" "$1" innocent $i "$1"; done
    hand_in "$2" "$1" own third 2 "$1"
    hand_in "Grace Hopper" "$1" own_reordered third 2 "$1"
}
term_of() { "$build/tools/copies" --build "$build" -- term "$scratch/term" "$scratch/g5" "$scratch/g3" >"$scratch/said" 2>&1; }
class=$scratch/class03
several 03-kdtree-2d-render "Ada Lovelace"
hand_in "only here" "$lab" own first 0 "$lab"
graded_as g3 "$lab"
class=$scratch/class05
several 05-spheres "Ada"
graded_as g5 05-spheres
check "two labs" exits 0 term_of
check "a person is found again by the address" is \
    "$(jq -c '.pairs[0] | [.persons, (.labs | keys)]' "$scratch/term/copies-term.json")" \
    '[["Ada Lovelace","Grace Hopper"],["03-kdtree-2d-render","05-spheres"]]'
check "scores are added" jq -e '.pairs[0] | (.labs | add) - .score | fabs < 0.02' "$scratch/term/copies-term.json"
check "a line says so" said 'look at "Ada Lovelace" and "Grace Hopper": 2 labs, score '
check "the page has both labs side by side" is "$(grep -o '<b>0[35]-[a-z0-9-]*: ' "$scratch/term/copies-term.html" | sort -u | wc -l)" 2
check "the page accuses nobody" lacks "$scratch/term/copies-term.html" copied cheat plagia
rm -r "$class"
check "submissions that are gone" exits 2 term_of
check "are named" said "leads to nothing: the submission was moved or removed"

# ---- Refusals --------------------------------------------------------------------------------------

check "no lab" look 2 --output "$scratch/none"
check "is named" said "found no graded class, expected LAB= and SUBMISSIONS="
check "no such lab" look 2 --lab 77 --submissions "$class"
check "is named, too" said 'found "77", expected the number or name of a lab'
check "OUTPUT in SUBMISSIONS" look 2 --lab 03 --submissions "$scratch"
check "is refused" said "found OUTPUT in SUBMISSIONS"
check "no submissions" look 2 --lab 03 --submissions "$scratch/nowhere"
check "are named" said "nowhere: not there"
finish

#!/bin/sh
# The labs of a term in one table: who is who across labs, sums, rules; what goes on to the next year.
#
#     sh tests/suites/term.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh
term=$build/tools/term
out=$scratch/out

# exits and said (tests/classes.sh) speak of the last run; this is one of the tool that adds up.
# table STATUS OPTION_OR_FOLDER...: into $out, from folders below $scratch
table() {
    wanted_status=$1
    shift
    exits "$wanted_status" add_up "$@"
}
add_up() { (cd "$scratch" && "$term" table "$@") >"$scratch/said" 2>&1 </dev/null; }

# line TEXT: is this a whole line of the table, once?
line() {
    [ "$(grep -cxF -- "$1" "$out/term.csv")" -eq 1 ] || { cat "$out/term.csv"; return 1; }
}

# gradebook FOLDER LAB: a made-up one; stdin has a line of JSON for each row, and one for each of the list
# who is without a row (no "id").
gradebook() {
    mkdir -p "$scratch/$1"
    jq -s --arg lab "$2" '{lab: $lab, title: "A lab", max_score: 100, tasks: [],
        students: map(select(.id) | {number: "", attempt: 1, entry: .name, counts: true, owners: []} + .),
        without: map(select(.id | not))}' >"$scratch/$1/gradebook.json"
}

# same_sums FOLDER...: in each lab, do the rows have the points that its gradebook has? Counted anew, and for
# each owner.
same_sums() {
    for folder; do
        of_lab=$(jq -r .lab "$scratch/$folder/gradebook.json")
        sum=$(jq '[.students[] | select(.counts) | (.owners | length) as $n | (.score // 0) * ($n + (if $n == 0 or .not_entered then 1 else 0 end))] | add' \
            "$scratch/$folder/gradebook.json")
        found=$(python3 -c 'import csv, sys
print(sum(int(row[sys.argv[2]] or 0) for row in csv.DictReader(open(sys.argv[1], encoding="utf-8"))))' \
            "$out/term.csv" "$of_lab")
        [ "$sum" = "$found" ] || { echo "$of_lab: found $found, expected $sum"; return 1; }
    done
    total=$(python3 -c 'import csv, sys
rows = list(csv.reader(open(sys.argv[1], encoding="utf-8")))
n = rows[0].index("sum")
print(all(sum(int(cell or 0) for cell in row[3:n]) == int(row[n]) for row in rows[1:]))' "$out/term.csv")
    [ "$total" = True ] || { cat "$out/term.csv"; return 1; }
}

page_of_markup() {
    gradebook markup 00-hello-pixels <<'END'
{"id": "a-1", "name": "<b>Ada</b>", "status": "graded", "score": 9}
END
    add_up "$scratch/markup.out" markup && grep -qF '&lt;b&gt;Ada&lt;/b&gt;' "$scratch/markup.out/term.html" &&
        ! grep -qF '<b>Ada' "$scratch/markup.out/term.html"
}

# ---- Who is who ---------------------------------------------------------------------------------

# In lab 00 a list was given; in lab 03 there are addresses only, and a name.
gradebook g0 00-hello-pixels <<'END'
{"id": "a-1", "name": "Ada Lovelace", "status": "graded", "score": 90, "owners": [{"name": "Ada Lovelace", "address": "ada@example.org", "id_number": "0017"}]}
{"id": "b-0", "name": "Grace Hopper", "status": "graded", "score": 20, "counts": false}
{"id": "b-1", "name": "Grace Hopper", "status": "graded", "score": 50, "attempt": 2, "owners": [{"name": "Grace Hopper", "address": "grace@example.org", "id_number": ""}]}
{"id": "t-1", "name": "Team 1", "status": "graded", "score": 70, "owners": [{"name": "Carol", "address": "carol@example.org", "id_number": ""}, {"name": "=Joan", "address": "joan@example.org", "id_number": "18"}]}
{"id": "x-1", "name": "Ada Lovelace", "status": "graded", "score": 33, "not_entered": "line 2 of the list has another number than 99"}
{"id": "p-1", "name": "Team 2", "status": "graded", "score": 11, "owners": [{"name": "Kim", "address": "kim@example.org", "id_number": ""}], "not_entered": "Lee fits no line of the list"}
{"name": "Mary Shaw", "address": "mary@example.org", "id_number": "", "status": "no submission"}
END
gradebook g3 03-kdtree-2d-render <<'END'
{"id": "a-2", "name": "lovelace", "status": "graded", "score": 60, "owners": [{"name": "A. Lovelace", "address": "ADA@example.org", "id_number": ""}]}
{"id": "b-2", "name": "Grace Hopper", "status": "not graded", "reason": "no device"}
{"id": "c-2", "name": "Carol", "status": "graded", "score": 49}
{"id": "j-1", "name": "Joan Clarke", "status": "graded", "score": 5, "counts": false}
{"id": "j-2", "name": "Joan Clarke", "status": "graded", "score": 100, "owners": [{"name": "Joan Clarke", "address": "", "id_number": "18"}]}
{"id": "m-2", "name": "Mary Shaw", "status": "nothing of this lab"}
END
check "two labs" table 0 --need 2 "$out" g3 g0
check "the head has a column for each lab" line \
    '"name","address","number","00-hello-pixels","03-kdtree-2d-render","sum","max","passed","admitted","note"'
check "joined by the address, in any letters" line \
    '"Ada Lovelace","ada@example.org","0017",90,60,150,200,2,"yes",""'
check "by the number; no cell is a formula" line \
    "\"'=Joan\",\"joan@example.org\",\"18\",70,100,170,200,2,\"yes\",\"\""
check "by the name, where nothing else is known" line \
    '"Carol","carol@example.org","",70,49,119,200,1,"no",""'
check "of several attempts the one that counts; what could not be graded is open, no zero" line \
    '"Grace Hopper","grace@example.org","",50,,50,200,1,"open","03-kdtree-2d-render not graded"'
check "who handed in nothing has a row" line '"Mary Shaw","mary@example.org","",,,0,200,0,"no",""'
check "what was entered for nobody is joined with nobody" line \
    '"Ada Lovelace","","",33,,33,200,0,"no","to be decided by you"'
check "and a line names it" said 'look at "Ada Lovelace": to be decided by you'
check "a team that is entered for one of two only is that one's" line \
    '"Kim","kim@example.org","",11,,11,200,0,"no",""'
check "and has a row of its own, too" line '"Team 2","","",11,,11,200,0,"no","to be decided by you"'
check "nobody else has a row" test "$(wc -l <"$out/term.csv")" -eq 9
check "no point is lost" same_sums g0 g3
check "the last line counts" said "8 rows for 2 labs, 2 admitted (NEED=2, PASS=50): see $out/term.csv, $out/term.html"
gradebook late 00-hello-pixels <<'END'
{"id": "o-1", "name": "olga", "status": "graded", "late": {"unknown": "nothing says when"}, "owners": [{"name": "Olga", "address": "olga@example.org", "id_number": ""}]}
END
late_or_not() {
    add_up --need 1 "$scratch/late.out" late
    grep -qxF '"Olga","olga@example.org","",,0,100,0,"open","00-hello-pixels to be decided by you"' "$scratch/late.out/term.csv" ||
        { cat "$scratch/late.out/term.csv"; return 1; }
}
check "what may be late is open, too" late_or_not
check "others cannot read it" test "$(stat -c %a "$out" | cut -c 3)" = 0
check "other points to pass" table 0 --need 1 --pass 71 "$out" g0 g3
check "change who is admitted" line '"Carol","carol@example.org","",70,49,119,200,0,"no",""'
cp "$out/term.csv" "$scratch/before.csv"
check "the folders in another order" table 0 --need 1 --pass 71 "$out" g3 g0
check "give the same bytes" cmp "$out/term.csv" "$scratch/before.csv"

check "the page has the same" grep -qF \
    '<b>170</b> / 200' "$out/term.html"
sed -n '/^<tr>.*>Ada Lovelace/,/tr>$/p' "$out/term.html" | grep -q '>to be decided by you<'
ok $? "with notes"
check "names are no markup" page_of_markup

# Two of one name.
gradebook t0 00-hello-pixels <<'END'
{"id": "a", "name": "Ada", "status": "graded", "score": 1}
{"id": "b", "name": "Ada", "status": "graded", "score": 2}
{"id": "c", "name": "Joan", "status": "graded", "score": 4, "owners": [{"name": "Joan", "address": "j1@example.org", "id_number": ""}]}
{"id": "d", "name": "Eve", "status": "graded", "score": 64, "owners": [{"name": "Eve", "address": "e@example.org", "id_number": ""}]}
{"id": "e", "name": "Eve's team", "status": "graded", "score": 50, "owners": [{"name": "Eve", "address": "e@example.org", "id_number": ""}]}
END
gradebook t1 01-naive-2d <<'END'
{"id": "a", "name": "Ada", "status": "graded", "score": 8}
{"id": "c", "name": "Joan", "status": "graded", "score": 16, "owners": [{"name": "Joan", "address": "j2@example.org", "id_number": ""}]}
{"id": "d", "name": "Eve", "status": "graded", "score": 32, "owners": [{"name": "Eve", "address": "e@example.org", "id_number": ""}]}
END
check "two of one name" table 0 "$out" t0 t1
for cells in '1,' '2,' ',8'; do
    check "one of two Adas keeps a row of their own ($cells)" line \
        "\"Ada\",\"\",\"\",$cells,$(echo "$cells" | tr -d ,),200,0,\"not joined with another row of this name\""
done
check "and a line says so" said 'look at "Ada": not joined with another row of this name'
check "two addresses of one name are not joined" line \
    '"Joan","j1@example.org","",4,,4,200,0,"not joined with another row of this name"'
check "nor are rows of one address, of which one lab has two" line \
    '"Eve","e@example.org","",64,,64,200,1,"one lab has this address or number twice"'
check "in every lab" line '"Eve","e@example.org","",,32,32,200,0,"one lab has this address or number twice"'
check "here, too, no point is lost" same_sums t0 t1

check "for Excel" table 0 --excel "$out" g0 g3
check "with its mark" test "$(head -c 3 "$out/term.csv" | od -An -tx1)" = " ef bb bf"
check "with semicolons" line '"Carol";"carol@example.org";"";70;49;119;200;1;""'

# ---- For the next year --------------------------------------------------------------------------

figures() { (cd "$scratch" && "$term" figures "$@") >"$scratch/said" 2>&1 </dev/null; }
mkdir "$scratch/g4"
jq '.tasks = [{id: "search", title: "The search", max_points: 60}, {id: "leaf", title: "A leaf", max_points: 40}] |
    .checks = [{id: "near", title: "The near child", task: "search"}, {id: "far", title: "The far child", task: "search"},
        {id: "loop", title: "The loop", task: "leaf"}] |
    .students |= map(. + {number: "PRIVATE", reason: "PRIVATE", report: "PRIVATE", seed: "PRIVATE",
            first_fault: {title: "PRIVATE", check: "PRIVATE", message: "PRIVATE"},
            points: {search: 30, leaf: 0}, not_passed: ["far", "loop"], not_run: ["loop"],
            causes: {far: "the far child is never visited"}} |
        if .id == "a-2" then .causes.far = "a child is missing" | .not_run = [] else . end |
        if .status != "graded" then del(.points) else . end |
        .id = "PRIVATE" | .name = "PRIVATE" | .entry = "PRIVATE" | .owners |= map_values(map_values("PRIVATE"))) |
    .without |= map(map_values("PRIVATE"))' \
    "$scratch/g3/gradebook.json" >"$scratch/g4/gradebook.json"
check "figures without names" exits 0 figures "$out" g4
jq -e '.labs == [{lab: "03-kdtree-2d-render", title: "A lab", submissions: 3,
    tasks: [{task: "search", title: "The search", max_points: 60, mean: 30}, {task: "leaf", title: "A leaf", max_points: 40, mean: 0}],
    checks: [{check: "near", title: "The near child", task: "search", failed: 0, not_run: 0, causes: []},
        {check: "far", title: "The far child", task: "search", failed: 3, not_run: 0,
            causes: [{cause: "the far child is never visited", submissions: 2}, {cause: "a child is missing", submissions: 1}]},
        {check: "loop", title: "The loop", task: "leaf", failed: 1, not_run: 2, causes: []}]}]' \
    "$out/class-figures.json" >/dev/null
ok $? "what failed, how often, and why" "$(cat "$out/class-figures.json")"
! grep -q PRIVATE "$out/class-figures.json" "$scratch/said"
ok $? "nothing of a person is in them" "$(grep PRIVATE "$out/class-figures.json" "$scratch/said")"
check "the table has what fails most often" said \
    "  3 failed far (task search), 2 of them: the far child is never visited"
check "then the rest" said "  1 failed loop (task leaf)"

# ---- What is refused ----------------------------------------------------------------------------

rm -rf "$out"
# refused WORDS ARGUMENT...: one line, with these words, and nothing written
refused() {
    words=$1
    shift
    check "refused: $words" table 2 "$@"
    check "in one line" test "$(wc -l <"$scratch/said")" -eq 1
    check "that says it" said "$words"
    check "and nothing is written" test ! -e "$out"
}
cp -R "$scratch/g0" "$scratch/again"
refused "found 00-hello-pixels in again and in g0, expected one folder for each lab" "$out" again g0
refused "none/gradebook.json: unable to open" "$out" g0 none
mkdir "$scratch/old"
jq 'del(.students[].counts)' "$scratch/g0/gradebook.json" >"$scratch/old/gradebook.json"
refused "old/gradebook.json: of an older version: run make grade-class for it again" "$out" old
jq '.students[0].score = 101' "$scratch/g0/gradebook.json" >"$scratch/old/gradebook.json"
refused "old/gradebook.json: found a score that is no number of points of the lab" "$out" old
jq '.lab = null' "$scratch/g0/gradebook.json" >"$scratch/old/gradebook.json"
refused "old/gradebook.json: nothing was graded there: leave this folder out" "$out" old
echo '[]' >"$scratch/old/gradebook.json"
refused 'old/gradebook.json: no list "students": not a gradebook.json' "$out" old
refused '--pass: found "x"' --pass x "$out" g0
jq 'del(.checks)' "$scratch/g4/gradebook.json" >"$scratch/old/gradebook.json"
check "figures of an older gradebook are refused" exits 2 figures "$out" old
check "with what to do" said "old/gradebook.json: of an older version: run make grade-class for it again"
check "and nothing is written" test ! -e "$out/class-figures.json"

# Names are words: make and the shell run nothing of them, and expand nothing.
# shellcheck disable=SC2016 # signs that nothing expands
hostile='g$(touch${IFS}names-trap);`id`*'
cp -R "$scratch/g0" "$scratch/$hostile"
cp -R "$scratch/g3" "$scratch/${hostile%\*}x"
make_term() { make --no-print-directory --old-file="${BUILD:-build}/tools/term" term "BUILD=${BUILD:-build}" "$@" >"$scratch/said" 2>&1; }
check "make term" exits 0 make_term "CLASSES=$scratch/t1 $scratch/$hostile" "OUTPUT=$out" NEED=1 PASS=60
check "takes a folder's name as it is" said "11 rows for 2 labs, 3 admitted (NEED=1, PASS=60)"
[ ! -e names-trap ]
ok $? "and runs nothing of it"
rm -f names-trap
check "make class-figures" exits 0 make --no-print-directory --old-file="${BUILD:-build}/tools/term" class-figures "BUILD=${BUILD:-build}" \
    "CLASSES=$scratch/g4" "OUTPUT=$out"
check "writes them" test -s "$out/class-figures.json"
check "without CLASSES it says what to do" exits 2 make_term
check "in one line" said 'say which folders: make term CLASSES="../grades-00 ../grades-03"'

# ---- Of classes that were graded ----------------------------------------------------------------

# Real gradings: right, a wrong answer, and one that does not compile, whose report quotes it.
cp -R solutions/$lab "$scratch/flipped"
"$build/tools/known" put $lab flipped "$scratch/flipped"
cp -R solutions/$lab "$scratch/broken"
printf '#error PRIVATE\n' >"$scratch/error.cl"
"$build/tools/holes" fill solutions/$lab/gradient.cl gradient "$scratch/error.cl" >"$scratch/broken/gradient.cl"
# graded STATUS SUBMISSION RESULTS
graded() {
    exits "$1" "$build/tools/grade" --build "$build" --lab 0 --submission "$2" --output "$3"
}
check "a right answer" graded 0 solutions/$lab "$scratch/right"
check "a wrong answer" graded 1 "$scratch/flipped" "$scratch/wrong"
check "one that does not compile" graded 1 "$scratch/broken" "$scratch/quoted"
stub "$scratch/wrong" "
if [ -e \"\$submission/right\" ]; then cp -R '$scratch/right/.' \"\$output\"; exit; fi
if [ -e \"\$submission/broken\" ]; then cp -R '$scratch/quoted/.' \"\$output\"; exit 1; fi"
cat >"$scratch/list.csv" <<'END'
Identifier,"Full name","Email address","ID number",Status,Grade
"Participant 7","Carol Shaw",carol@example.org,0042,Submitted,
"Participant 8","Jean Bartik",jean@example.org,0043,Submitted,
"Participant 9","Zoe Early",zoe@example.org,0044,Submitted,
"Participant 10","Bob Kilby",bob@example.org,0045,Submitted,
END
for student in "Carol Shaw_7" Nobody_99 "Zoe Early_9" "Bob Kilby_10"; do
    mkdir -p "$class/${student}_assignsubmission_file_"
done
: >"$class/Zoe Early_9_assignsubmission_file_/right"
: >"$class/PRIVATE.txt"
: >"$class/Bob Kilby_10_assignsubmission_file_/broken"
check "a class by a list" exits 1 run "$scratch/real" --moodle "$scratch/list.csv"
check "goes into a table" table 0 "$out" real g3
score=$(jq .score "$scratch/wrong/results.json")
check "with the list's address and number" line \
    "\"Carol Shaw\",\"carol@example.org\",\"0042\",$score,,$score,200,1,\"\""
check "who may be any of the list is open" line \
    '"Jean Bartik","jean@example.org","0043",,,0,200,0,"00-hello-pixels not entered"'
check "what is nobody's has a row" line "\"Nobody\",\"\",\"\",$score,,$score,200,1,\"to be decided by you\""
check "figures of it" exits 0 figures "$out" real
check "name the known mistake" jq -e '.labs[0] | .submissions == 4 and
    any(.checks[].causes[]; .cause == "it looks flipped top to bottom" and .submissions == 2)' "$out/class-figures.json"
! grep -q PRIVATE "$out/class-figures.json"
ok $? "and quote nothing"

# ---- The page for the lecture hall --------------------------------------------------------------

page=$scratch/real/class-no-names.html
check "the page without names is not made unless it is asked for" test ! -e "$page"
check "another word is refused" exits 2 run "$scratch/real" --names off
check "with what is expected" said '--names: found "off", expected no'
check "with NAMES=no it is made" exits 1 run "$scratch/real" --moodle "$scratch/list.csv" --names no
# Of the style sheet and the policy nothing is looked at.
sed '1,/<main/d' "$page" >"$scratch/shown" 2>/dev/null
! grep -niE 'carol|shaw|jean|bartik|zoe|early|bob|kilby|nobody|PRIVATE|students/|logs/|src=|id="[a-z]*-' "$scratch/shown" &&
    grep -q PRIVATE "$scratch/real/class.html"
ok $? "it has no name, no link to a report, and nothing that a student wrote" "$(cat "$scratch/shown")"
# rows: the number and score of each row of its table
rows() { grep -o '<td class="name">No. [0-9]*</td><td class="number"><b>[0-9]*' "$scratch/shown" | sed 's/[^0-9]*\([0-9]*\)[^0-9]*/\1 /g'; }
check "the numbers are in the order of the scores" test "$(rows | tr -d '\n')" = "1 100 2 $score 3 $score 4 $(jq .score "$scratch/quoted/results.json") "
check "who failed alike is listed by number" grep -q 'No. 2 &middot; No. 3' "$scratch/shown"
# ---- Slides, and what went wrong ----------------------------------------------------------------

page=$scratch/real/class-slides.html
sed '1,/<main/d' "$page" >"$scratch/shown" 2>/dev/null
check "the slides are well-formed" xmllint --html --noout "$page"
! grep -niE 'carol|shaw|jean|bartik|zoe|early|bob|kilby|nobody|PRIVATE|students/|logs/' "$scratch/shown"
ok $? "they have no name, and nothing that a student wrote" "$(cat "$scratch/shown")"
check "the most frequent mistake has the first" \
    sh -c "grep -A 3 'id=\"slide-1\"><p class=\"soft\">2 of 4' '$scratch/shown' | grep -q 'it looks flipped top to bottom'"
check "with its hint" grep -qF "$(jq -r '.tasks[0].hint' solutions/$lab/lab.json | cut -c 1-20)" "$scratch/shown"
check "and what it should be" test "$(grep -c '<figcaption>as it should be' "$scratch/shown")" -ge 1
check "whole, not cut" sh -c "grep -o 'src=\"[^\"]*' '$scratch/shown' | grep -c '^src=\"data:image/png;base64,[A-Za-z0-9+/]*=*$' |
    grep -qx \"\$(grep -c '<figure>' '$scratch/shown')\""
check "a compiler's error has none" sh -c "! grep -q Compiling '$scratch/shown'"
page=$scratch/real/class.html
check "the page groups all faults by cause" sh -c "grep -A 1 '<span class=\"number\">2</span>' '$page' |
    grep -q 'it looks flipped top to bottom'"
check "with a picture of one" sh -c "sed -n '/id=\"failures\"/,/id=\"tasks\"/p' '$page' | grep -q '<figure>'"
check "and says how many answered a task" sh -c "sed -n '/id=\"tasks\"/,/id=\"checks\"/p' '$page' |
    grep -q 'gradient</code></td><td class=\"number\">4</td><td class=\"number\">1</td>'"

check "without NAMES=no an older one is removed" exits 1 run "$scratch/real" --moodle "$scratch/list.csv"
check "as its scores would be old" test ! -e "$scratch/real/class-no-names.html"
finish

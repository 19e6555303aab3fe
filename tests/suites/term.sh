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

# ---- Who is who ---------------------------------------------------------------------------------

# In lab 00 a list was given; in lab 03 there are addresses only, and a name.
gradebook g0 00-hello-pixels <<'END'
{"id": "a-1", "name": "Ada Lovelace", "status": "graded", "score": 90, "owners": [{"name": "Ada Lovelace", "address": "ada@example.org", "id_number": "0017"}]}
{"id": "b-0", "name": "Grace Hopper", "status": "graded", "score": 20, "counts": false}
{"id": "b-1", "name": "Grace Hopper", "status": "graded", "score": 50, "attempt": 2, "owners": [{"name": "Grace Hopper", "address": "grace@example.org", "id_number": ""}]}
{"id": "t-1", "name": "Team 1", "status": "graded", "score": 70, "owners": [{"name": "Carol", "address": "carol@example.org", "id_number": ""}, {"name": "=Joan", "address": "joan@example.org", "id_number": "18"}]}
{"id": "x-1", "name": "Ada Lovelace", "status": "graded", "score": 33, "not_entered": "line 2 of the list has another number than 99"}
{"name": "Mary Shaw", "address": "mary@example.org", "id_number": "", "status": "no submission"}
END
gradebook g3 03-kdtree-2d-render <<'END'
{"id": "a-2", "name": "lovelace", "status": "graded", "score": 60, "owners": [{"name": "A. Lovelace", "address": "ADA@example.org", "id_number": ""}]}
{"id": "b-2", "name": "Grace Hopper", "status": "not graded", "reason": "no device"}
{"id": "c-2", "name": "Carol", "status": "graded", "score": 49}
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
check "nobody else has a row" test "$(wc -l <"$out/term.csv")" -eq 7
check "no point is lost" same_sums g0 g3
check "the last line counts" said "6 students in 2 labs, 2 admitted (NEED=2, PASS=50): see $out/term.csv"
check "others cannot read it" test "$(stat -c %a "$out" | cut -c 3)" = 0
check "other points to pass" table 0 --need 1 --pass 71 "$out" g0 g3
check "change who is admitted" line '"Carol","carol@example.org","",70,49,119,200,0,"no",""'
cp "$out/term.csv" "$scratch/before.csv"
check "the folders in another order" table 0 --need 1 --pass 71 "$out" g3 g0
check "give the same bytes" cmp "$out/term.csv" "$scratch/before.csv"

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

# Names are words: make and the shell run nothing of them, and expand nothing.
# shellcheck disable=SC2016 # signs that nothing expands
hostile='g$(touch${IFS}names-trap);`id`*'
cp -R "$scratch/g0" "$scratch/$hostile"
cp -R "$scratch/g3" "$scratch/${hostile%\*}x"
make_term() { make --no-print-directory --old-file="$term" term "BUILD=${BUILD:-build}" "$@" >"$scratch/said" 2>&1; }
check "make term" exits 0 make_term "CLASSES=$scratch/t1 $scratch/$hostile" "OUTPUT=$out" NEED=1 PASS=60
check "takes a folder's name as it is" said "9 students in 2 labs, 3 admitted (NEED=1, PASS=60)"
[ ! -e names-trap ]
ok $? "and runs nothing of it"
rm -f names-trap
check "without CLASSES it says what to do" exits 2 make_term
check "in one line" said 'say which folders: make term CLASSES="../grades-00 ../grades-03"'
finish

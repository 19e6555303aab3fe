#!/bin/sh
# Grades into the lists of course systems: the gradebooks that Canvas, Blackboard and Brightspace export, Moodle's
# worksheet, and any other list. What comes back is read as the system's importer reads it.
#
#     sh tests/suites/lists.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

all_right

# class_of NAME FILE...: a class of such single files.
class_of() {
    class=$scratch/$1
    mkdir -p "$class"
    shift
    for file; do echo x >"$class/$file"; done
}

# listed STATUS OPTION...: grade the class by $class.csv.
listed() {
    wanted_status=$1
    shift
    exits "$wanted_status" run "$class.out" --list "$class.csv" "$@"
}

# uploads LINE: is that a line of what goes back?
uploads() { grep -qxF -- "$1" "$class.out/upload.csv" || { cat "$class.out/upload.csv"; return 1; }; }

# uploaded LINES: is that all of it?
uploaded() { [ "$(cat "$class.out/upload.csv")" = "$1" ] || { cat "$class.out/upload.csv"; return 1; }; }

# ---- Canvas -------------------------------------------------------------------------------------

class_of canvas lovelaceada_40012_880012_gradient.cl lovelaceada_LATE_40013_880013_gradient.cl \
    mullerjorg_40014_880014_gradient.cl hoppergrace_40017_880017_gradient.cl shawmary_40019_880019_gradient.cl
cat >"$class.csv" <<'END'
Student,ID,SIS User ID,SIS Login ID,Section,Notes,Lab 0 (4711),Lab 10 (4712),"Labs, all Current Score",0 Final Score (2026)
,,,,,,Manual Posting,,,
    Points Possible,,,,,,40.00,10.00,(read only),(read only)
"Lovelace, Ada",40012,u12,ada,A,,,9.00,90.00,90.00
"Lovelace, Ada",40013,u13,alove,B,,,8.00,80.00,80.00
"Müller, Jörg",40014,u14,=1+1,A,,12.00,,,
"Hopper, Grace",40017,u17,gh,A,,EX,,,
"Shaw, Mary",40019,u19,ms,A,,N/A,,,
"Student, Test",40099,,0a1b,A,,,,,
END
check "canvas: graded" listed 0
check "canvas: what to do with it" said "canvas.out/upload.csv, your list with the column \"Lab 0 (4711)\" filled in: in Canvas choose Grades, Import"
check "canvas: this assignment only, and no line more" uploaded '"Student","ID","SIS User ID","SIS Login ID","Section","Lab 0 (4711)"
"","","","","","Manual Posting"
"Points Possible","","","","","40.00"
"Lovelace, Ada","40012","u12","ada","A","40.00"
"Lovelace, Ada","40013","u13","alove","B","40.00"
"Müller, Jörg","40014","u14","'"'"'=1+1","A","40.00"
"Hopper, Grace","40017","u17","gh","A","EX"
"Shaw, Mary","40019","u19","ms","A","N/A"
"Student, Test","40099","","0a1b","A",""'
check "canvas: a grade that is there already is told" said 'line 6 has the grade "12.00" already: gradebook.csv has ours'
check "canvas: who is excused stays so" said 'line 7 has the grade "EX" already: it stays'
check "canvas: the other columns are in gradebook.csv" \
    grep -q '^"Lovelace, Ada","40012","u12","ada","A","","40.00","9.00",' "$class.out/gradebook.csv"

# A comma for the decimals, semicolons between cells, first and last names apart, a byte order mark.
printf '\357\273\277%s\n' 'LastName;FirstName;ID;SIS Login ID;Section;Teil 1, Lab 00 (4711);Lab 1 (4712)' >"$class.csv"
cat >>"$class.csv" <<'END'
    Points Possible;;;;;87,50;10,00
Lovelace;Ada;40012;ada;A;;
Lovelace;Ada;40013;alove;A;;
END
check "canvas in German: graded" listed 1
check "canvas in German: a comma for the decimals" uploads '"Lovelace","Ada","40012","ada","A","87,50"'
check "and two of one name have their own" uploads '"Lovelace","Ada","40013","alove","A","87,50"'

# choice STATUS HEAD WORDS [OPTION...]: which column is it? The list has nobody but Ada.
choice() {
    wanted_status=$1 words=$3
    printf 'Student,ID,SIS Login ID,Section,%s\n    Points Possible,,,,%s\n"Lovelace, Ada",40012,ada,A,%s\n' "$2" \
        "$(printf %s "$2" | sed 's/[^,]//g; s/,/10,/g; s/$/10/')" "$(printf %s "$2" | sed 's/[^,]//g')" >"$class.csv"
    shift 3
    listed "$wanted_status" "$@" && said "$words"
}
check "of two columns none has the number" choice 2 'Lab 1 (1),Lab 2 (2)' \
    'line 1: found 2 columns of grades, of which none has the number 0; say which with COLUMN=, one of these: "Lab 1 (1)", "Lab 2 (2)"'
check "two have it" choice 2 'Lab 0 (1),Bonus 0 (2)' 'of which more than one has the number 0'
check "the only one has another lab's" choice 2 'Lab 3 (1)' 'found 1 columns of grades, of which none has the number 0'
check "the only one without a number is it" choice 1 'Circles (17)' 'the column "Circles (17)" filled in'
check "10 is not 0, nor is Canvas' own number" choice 2 'Lab 10 (0),Lab 20 (1)' 'none has the number 0'
check "by its title" choice 1 'Lab 1 (1),Lab 2 (2)' 'the column "Lab 2 (2)" filled in' --column 'Lab 2 (2)'
check "by its title without Canvas' number" choice 1 'Lab 1 (1),Lab 2 (2)' 'the column "Lab 1 (1)" filled in' --column 'Lab 1'
quick_ends

many=$(seq -s, -f 'Lab %.0f (1)' 100 249)
check "a course of 150 assignments" choice 1 "$many,Lab 0 (7)" 'the column "Lab 0 (7)" filled in'
check "a title that is none" choice 2 'Lab 1 (1),Lab 2 (2)' 'found no column of grades "Lab 3"; say which' --column 'Lab 3'
check "a title without a list" exits 2 run "$class.out" --column 'Lab 3'
check "is refused" said 'Lab 3: found no list of participants beside it, expected LIST='
sed -i 's/10,10$/ten,10/; s/,10$/,ten/' "$class.csv"
check "a maximum that is no number" listed 2 --column 'Lab 2'
check "is named" said 'line 1: "Lab 2 (2)": found the maximum "ten", expected a number such as 100 or 1000.00'

# ---- Blackboard ---------------------------------------------------------------------------------

class_of blackboard "Lab 0_ada_attempt_2026-11-03-10-22-33_gradient.cl" "Lab 0_gh_attempt_2026-11-03-10-22-33_gradient.cl" \
    "Lab 0_jm_attempt_2026-11-03-10-22-33_gradient.cl"
# As it is downloaded: tabs between cells in quotes, in UTF-16, called .xls.
tab=$(printf '\t')
sed "s/|/$tab/g; s/BAR/|/g" >"$scratch/blackboard.txt" <<'END'
"Last Name"|"First Name"|"Username"|"Student ID"|"Last Access"|"Availability"|"Total [Total Pts: up to 110 Score] BAR90"|"Lab 0, the first [Total Pts: 40 Score] BAR91"|"Lab 1 [Total Pts: 10 Score] BAR92"
"Lovelace"|"Ada"|"ada"|"40012"|"2026-11-03 10:22:33"|"Yes"|"0.00"|"Needs Grading"|""
"Müller"|"Jörg"|"jm"|"40014"|""|"Yes"|""|""|"7.00"
"Hopper"|"Grace"|"gh"|"40017"|""|"Yes"|""|"40.00"|""
"Clarke"|"Joan"|"jc"|"40018"|""|"Yes"|""|""|""
END
for order in LE BE; do
    { if [ $order = LE ]; then printf '\377\376'; else printf '\376\377'; fi && iconv -f UTF-8 -t UTF-16$order "$scratch/blackboard.txt"; } \
        >"$class.csv"
    check "blackboard in UTF-16$order: graded" listed 0
    check "blackboard in UTF-16$order: this column only" uploaded \
        '"Last Name","First Name","Username","Student ID","Last Access","Availability","Lab 0, the first [Total Pts: 40 Score] |91"
"Lovelace","Ada","ada","40012","2026-11-03 10:22:33","Yes","40.00"
"Müller","Jörg","jm","40014","","Yes","40.00"
"Hopper","Grace","gh","40017","","Yes","40.00"
"Clarke","Joan","jc","40018","","Yes",""'
    check "blackboard in UTF-16$order: words for no grade are none" sh -c "! grep -q 'already' '$scratch/said'"
done
head -c 400 "$class.csv" >"$scratch/cut.csv" && printf '\330\000x' >>"$scratch/cut.csv" && mv "$scratch/cut.csv" "$class.csv"
check "damaged UTF-16" listed 2
check "is named" said 'found UTF-16; save it as CSV in UTF-8'
# Of a single column, with feedback.
cat >"$class.csv" <<'END'
"Username","Lab 0 [Total Pts: 50 Score] |91","Feedback to Learner","Feedback Format"
"ada","","","PLAIN_TEXT"
"gh","","well done","PLAIN_TEXT"
END
check "blackboard, a single column: graded" listed 1
check "blackboard: the points of each task are feedback" \
    grep -q '^"ada","50.00","100 of 100 points: gradient 40/40, .*","PLAIN_TEXT"$' "$class.out/upload.csv"
check "blackboard: somebody's own feedback stays" uploads '"gh","50.00","well done","PLAIN_TEXT"'

# ---- Brightspace --------------------------------------------------------------------------------

class=$scratch/brightspace
mkdir -p "$class/40012-88003 - Ada Lovelace - Nov 3, 2026 1022 PM" "$class/40017-88003 - Grace Hopper - Nov 3, 2026 1022 PM"
cat >"$class.csv" <<'END'
OrgDefinedId,Username,Last Name,First Name,Email,Lab 0 Points Grade <Numeric MaxPoints:25 Weight:10>,Lab 1 Points Grade <Numeric MaxPoints:10>,Calculated Final Grade Numerator,End-of-Line Indicator
#40012,#ada,Lovelace,Ada,ada@example.org,,3,,#
#40017,#gh,Hopper,Grace,gh@example.org,,,,#
END
check "brightspace: graded" listed 0
check "brightspace: this grade item, and the end of each line" uploaded \
    '"OrgDefinedId","Username","Last Name","First Name","Email","Lab 0 Points Grade <Numeric MaxPoints:25 Weight:10>","End-of-Line Indicator"
"#40012","#ada","Lovelace","Ada","ada@example.org","25.00","#"
"#40017","#gh","Hopper","Grace","gh@example.org","25.00","#"'

# ---- Moodle, and any other list -----------------------------------------------------------------

class_of moodle "Ada Lovelace_12_assignsubmission_file_gradient.cl" "Nobody_99_assignsubmission_file_gradient.cl"
cat >"$class.csv" <<'END'
Identifier,"Full name",Status,Grade,"Maximum Grade","Grade can be changed","Feedback comments"
"Participant 12","Ada Lovelace",Submitted,,"20,00",Yes,
"Participant 13","Grace Hopper","No submission",,"20,00",Yes,
END
check "moodle: graded, and one is nobody's" listed 1
check "moodle: what could not be entered is in gradebook.csv" grep -q '"Nobody"' "$class.out/gradebook.csv"
check "moodle: and not in what goes back" test "$(grep -c '' "$class.out/upload.csv")" -eq 3
check "moodle: the grade, as a part of the maximum, and the comment" \
    grep -q '^"Participant 12","Ada Lovelace","Submitted","20,00","20,00","Yes","100 of 100 points: ' "$class.out/upload.csv"
check "the older name of the list" exits 1 run "$class.out" --moodle "$class.csv"
check "both names" exits 2 run "$class.out" --moodle "$class.csv" --list "$class.csv"
check "are one too many" said 'found a list already, expected one: LIST=, or MOODLE=, its older name'

# Stud.IP's list of participants has no grades: a column of one's own takes them.
class_of studip '[1]_ada.zip' '[2]_gh.zip'
printf 'Vorname;Nachname;Nutzernamen;Matrikelnummer;Blatt 3\nAda;Lovelace;ada;40012;\nGrace;Hopper;gh;40017;\n' >"$class.csv"
check "a list without grades" listed 0
check "is not filled" said 'found no column "Grade" or "Bewertung" to fill, nor was another named (COLUMN=)'
check "and nothing goes back, nor is left of an older run" test ! -e "$class.out/upload.csv"
check "a column by its name" listed 0 --column 'Blatt 3'
check "takes the points" uploads '"Ada";"Lovelace";"ada";"40012";"100.00"'
check "a column that is none" listed 2 --column 'Blatt 4'
check "is named" said 'line 1: found no column "Blatt 4"'

printf 'Colour,Size\nred,3\n' >"$class.csv"
check "a table of something else is refused" listed 2
check "with what is expected" said 'line 1: found no column of names, user names, numbers or addresses, expected one such as "Full name"'
: >"$class.csv"
check "an empty file is refused" listed 2
check "as what it is" said 'empty; expected a list of participants (Moodle, Canvas, Blackboard, Brightspace)'

finish

#!/bin/sh
# Lists that an instructor wrote, and folders under the names of such lists: which titles are known, and in which ways
# a name, a number or an address stands for a person.
#
#     sh tests/suites/own_lists.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

all_right

# listed STATUS OPTION...: grade the class by $class.csv.
listed() {
    wanted_status=$1
    shift
    exits "$wanted_status" run "$class.out" --list "$class.csv" "$@"
}

# has NUMBER ENTRY: is the entry of this name in the line of the list with this number?
has() {
    grep -e "[#\"]$1\"" "$class.out/gradebook.csv" | grep -v '^,' | grep -qF -- ",\"$2\"," && return
    cat "$class.out/gradebook.csv"
    return 1
}

# owners FILTER: of all rows of gradebook.json.
owners() { jq -r "[.students[].owners[]? | $1] | sort | join(\" \")" "$class.out/gradebook.json"; }

# ---- Titles -------------------------------------------------------------------------------------

class=$scratch/titles
mkdir -p "$class/Ada Lovelace" "$class/Jürgen_Müller" "$class/0042"

# titles HEAD ADA JÜRGEN JOAN: are all three found in a list with this head, with names, numbers and addresses?
titles() {
    printf '%s\n' "$@" >"$class.csv"
    check "$1" listed 0
    check "$1: all are entered" said "3 of 3 graded and entered"
    check "$1: names" test "$(owners .name)" = "Ada Lovelace Joan Clarke Jürgen Müller"
    check "$1: numbers" test "$(owners .id_number)" = "0040 0041 0042"
}
titles 'Name;Matrikelnummer;E-Mail;Punkte' 'Ada Lovelace;0040;a@x.de;' 'Jürgen Müller;0041;j@x.de;' 'Joan Clarke;0042;c@x.de;'
check "addresses" test "$(owners .address)" = "a@x.de c@x.de j@x.de"
titles 'Name;Vorname;Matrikel-Nr.' 'Lovelace;Ada;0040' 'Müller;Jürgen;0041' 'Clarke;Joan;0042'
titles 'Nachname;Vorname;Matr.-Nr.' 'Lovelace;Ada;0040' 'Müller;Jürgen;0041' 'Clarke;Joan;0042'
titles 'name,first name,matrikelnr.,email' 'Lovelace,Ada,0040,' 'Müller,Jürgen,0041,' 'Clarke,Joan,0042,'
# Beside both of them "Name" is the whole name.
titles 'Name;Vorname;Nachname;Student number' 'Ada Lovelace;A.;L.;0040' 'Jürgen Müller;J.;M.;0041' 'Joan Clarke;J.;C.;0042'

# ---- Names with a comma -------------------------------------------------------------------------

class=$scratch/commas
mkdir -p "$class/Fischer, Tom" "$class/Ada Lovelace" "$class/Hopper,Grace" "$class/Weiß, Anna, Maria" "$class/Li, Na"
: >"$class/Groß-Schäfer, Anna-Lena.zip"
: >"$class/Müller_Jürgen.zip"
cat >"$class.csv" <<'LIST'
Nachname;Vorname;Matrikelnummer
Fischer;Tom;1
Groß-Schäfer;Anna-Lena;2
Müller;Jürgen;3
Lovelace;Ada;4
Hopper;Grace;5
Weiß;Anna, Maria;6
Li;Na;7
Na;Li;8
LIST
check "last names first, and a comma: graded" listed 1
for line in "1:Fischer, Tom" "2:Groß-Schäfer, Anna-Lena" "3:Müller_Jürgen" "4:Ada Lovelace" "5:Hopper,Grace" "6:Weiß, Anna, Maria"; do
    check "${line#*:} has the grade" has "${line%%:*}" "${line#*:}"
done
check "a name that two may have is nobody's" said '"Li, Na": fits 2 lines of the list, among them 8 and 9'
printf '%s\n' 'Name;Matrikelnummer' 'Tom Fischer;1' 'Anna-Lena Groß-Schäfer;2' '"Lovelace, Ada";4' 'Grace Hopper;5' >"$class.csv"
check "by whole names: graded" listed 1
for line in "1:Fischer, Tom" "2:Groß-Schäfer, Anna-Lena" "4:Ada Lovelace" "5:Hopper,Grace"; do
    check "by whole names: ${line#*:} has the grade" has "${line%%:*}" "${line#*:}"
done

# The time of handing in, in either language.
for title in "Handed in" abgegeben; do
    printf '%s\n' "Name;Vorname;$title" 'Fischer;Tom;2026-11-25 23:05' >"$class.csv"
    check "$title: graded" listed 1 --due "2026-11-25 23:00"
    check "$title: the time is known" test "$(jq '[.students[].late.handed_in // empty] | length' "$class.out/gradebook.json")" -eq 1
done

# ---- The form that goes back --------------------------------------------------------------------

# form TITLE PRINTF...: does a list that printf makes so come back with the grade, and else the same but for quotes?
form() {
    # shellcheck disable=SC2059 # the format is what is tried
    printf "$2" '' >"$class.csv"
    # shellcheck disable=SC2059
    printf "$2" 100.00 >"$scratch/expected"
    check "$1: graded" listed 1
    # shellcheck disable=SC2016 # for the inner shell
    check "$1: goes back as it came" sh -c 'tr -d "\"" <"$1" | cmp - "$2"' - "$class.out/upload.csv" "$scratch/expected"
}
class=$scratch/forms
mkdir -p "$class/Jürgen Müller" "$class/nobody"
form "a German Excel's list" '\357\273\277Name;Bewertung;Seminar\r\nJürgen Müller;%s;A, B\r\n'
form "with sep=;" 'sep=;\nName;Bewertung\nJürgen Müller;%s\n'
form "tabs" 'Name\tBewertung\nJürgen Müller\t%s\n'

# ---- The university's number --------------------------------------------------------------------

# numbered ENTRY NAME NUMBER: do CHANGES and WHO find the student of this entry and name by the number?
numbered() {
    printf 'student,task,points\n%s,score,7\n' "$3" >"$scratch/changes.csv"
    check "${class##*/}: CHANGES for $3" listed 0 --changes "$scratch/changes.csv"
    check "${class##*/}: $3 has the points" test "$(name=$2 jq '.students[] | select(.name == env.name) | .score' "$class.out/gradebook.json")" -eq 7
    printf 'entry,student,counts\n"%s",%s,yes\n' "$1" "$3" >"$scratch/who.csv"
    check "${class##*/}: WHO for $3" listed 0 --who "$scratch/who.csv"
    check "${class##*/}: $3 has the entry" has 4000100 "$2"
}

class=$scratch/canvas
mkdir "$class"
for name in lovelaceada_71 clarkejoan_72; do echo x >"$class/${name}_880012_gradient.cl"; done
printf '%s\n' 'Student,ID,SIS User ID,SIS Login ID,Section,Lab 0 (4711)' '"Lovelace, Ada",71,4000100,ada,A,' \
    '"Clarke, Joan",72,4000101,joan,A,' >"$class.csv"
for number in 4000100 ada "Ada Lovelace"; do numbered lovelaceada_71_880012_gradient.cl lovelaceada "$number"; done
check "canvas: the number is in gradebook.json" test "$(owners .id_number)" = "4000100 4000101"

class=$scratch/brightspace
mkdir -p "$class/71-88003 - Ada Lovelace - Nov 3, 2026 1022 PM" "$class/72-88003 - Joan Clarke - Nov 3, 2026 1022 PM"
printf '%s\n' 'OrgDefinedId,Username,Last Name,First Name,Lab 0 Points Grade <Numeric MaxPoints:25>,End-of-Line Indicator' \
    '#4000100,#ada,Lovelace,Ada,,#' '#4000101,#joan,Clarke,Joan,,#' >"$class.csv"
for number in 4000100 '#4000100' ada '#ada'; do
    numbered "71-88003 - Ada Lovelace - Nov 3, 2026 1022 PM" "Ada Lovelace" "$number"
done
check "brightspace: the number is in gradebook.json without the sign" test "$(owners .id_number)" = "4000100 4000101"
mkdir "$class/4000101"
rm -r "$class"/7*
check "a folder of one's own under the number" listed 0
check "is the student's" has 4000101 4000101

finish

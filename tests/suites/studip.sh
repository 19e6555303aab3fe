#!/bin/sh
# A class as Stud.IP exports it: a folder with the files of all, and archive_filelist.csv beside it, which says whose
# they are. Nobody is lost, and nobody has another's grade. A list among the files decides nothing.
#
#     sh tests/suites/studip.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
# Beside them it is written down whose file was graded: each holds its student's number.
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" 'cat "$submission"/* >"$output/whose" 2>/dev/null || cat "$submission" >"$output/whose"'

# ---- The folder of the class --------------------------------------------------------------------

# pack NAME: the folder $scratch/NAME as $scratch/NAME.zip, without a folder around it, which is the class from here on.
pack() {
    class=$scratch/$1.zip
    rm -rf "$class" "$scratch/$1.out"
    (cd "$scratch/$1" && zip -qr "$class" .)
}
mkdir -p "$scratch/plain/Lab 0"
for name in "Ada Lovelace" "Grace Hopper" "Joan Clarke"; do echo "$name" >"$scratch/plain/Lab 0/$name.zip"; done
# What systems and desktops put beside a folder is none of the class.
for beside in "" archive_filelist.csv Thumbs.db desktop.ini .DS_Store index.html ._x; do
    [ -z "$beside" ] || echo x >"$scratch/plain/$beside"
    pack plain
    check "the only folder beside \"$beside\"" exits 0 run "$scratch/plain.out"
    check "is the class" said "3 submissions, 3 graded"
    [ -z "$beside" ] || rm "$scratch/plain/$beside"
done

# ---- Whose each file is -------------------------------------------------------------------------

# listed FIRST LAST PATH [TIME]: a line of Stud.IP's list of files, by the system's own rules (FileArchiveManager).
listed() { printf '"%s";"5";"%s";"%s";"0";"%s";"%s"\n' "${3##*/}" "$1" "$2" "${4:-25.11.2026 18:00}" "$3" >>"$list"; }

# file FIRST LAST PATH CONTENT [TIME]: a file of the class, and its line.
file() {
    mkdir -p "$(dirname "$scratch/$class_name/$3")"
    echo "$4" >"$scratch/$class_name/$3"
    listed "$1" "$2" "$3" "${5:-}"
}

# new NAME [HEAD]: a class without files yet, and the head of its list.
new() {
    class_name=$1 list=$scratch/$1/archive_filelist.csv
    mkdir -p "$scratch/$1"
    echo "${2:-\"Name\";\"Größe\";\"Vorname\";\"Nachname\";\"Downloads\";\"Datum\";\"Pfad\"}" >"$list"
}

# graded STATUS WORDS [OPTION...]: grade the class by the list of participants; the last line begins so.
graded() {
    wanted_status=$1 words=$2
    shift 2
    check "$class_name: graded" exits "$wanted_status" run "$scratch/$class_name.out" --list "$scratch/people.csv" "$@"
    check "$class_name: $words" said "$words"
    class=$scratch/$class_name
}

# As the system exports its participants.
cat >"$scratch/people.csv" <<'END'
Vorname;Nachname;Nutzernamen;Matrikelnummer
Ada;Lovelace;ada;40012
Jürgen;Müller;jm;40013
Grace;Hopper;gh;40014
Joan;Clarke;jc;40015
Lukas;Schmidt;ls;40016
Lukas;Schmidt;ls2;40017
END

# The names of the files say somebody else, or nothing; one is that of another's whole name.
people() {
    file Ada Lovelace "$1Grace Hopper.zip" 40012
    file Jürgen Müller "$1[0]_Müller_Jürgen_lab00.zip" 40013
    file Grace Hopper "$1abgabe.zip" 40014 '26.11.2026 00:30'
    file Joan Clarke "$1gradient.cl" 40015
}
everybody() { for number in 40012 40013 40014 40015; do check "$class_name: $number has the own grade" own $number; done; }

new folder && people "Lab 0/"
pack folder
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over"
everybody
# Unpacked by the instructor: the folder around it, or the one with the files.
class=$scratch/folder
rm -r "$scratch/folder.out"
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over"
everybody
class="$scratch/folder/Lab 0"
rm -r "$scratch/folder.out"
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over" --due "2026-11-26 00:00 Europe/Berlin"
everybody
check "when it was handed in" test "$(jq -r '.students[] | select(.name == "Grace Hopper") | .late.seconds' "$class.out/gradebook.json")" -eq 1800
check "and who was in time" test "$(jq '[.students[] | select(.late.is_late == false)] | length' "$class.out/gradebook.json")" -eq 3

# Single files with the list among them: a student could have written it.
new flat && people ""
pack flat
graded 1 "1 of 3 graded and entered; 0 without submission; 2 passed over"
check "a list among the files is told" said "flat.out/export/archive_filelist.csv: decides nothing: it is among what students handed in"
check "and on the page" grep -q 'Passed over.*\|.*archive_filelist.csv.*gradient.cl' "$class.out/class.html"
new english '"Name";"Size";"First name";"Last name";"Downloads";"Date";"Path"' && people "Course/[0]_Lab 0/"
class="$scratch/english/Course/[0]_Lab 0"
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over"
everybody
# A Mac writes accents apart; a file of another lab has the same name.
new accents && people "Lab 0/"
mv "$scratch/accents/Lab 0/[0]_Müller_Jürgen_lab00.zip" "$scratch/accents/Lab 0/$(printf '[0]_Mu\314\210ller_Ju\314\210rgen_lab00.zip')"
listed Eve Evil "Lab 1/abgabe.zip"
pack accents
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over"
everybody

# Single files and one archive are one attempt, of the last time.
new several && people "Lab 0/"
file Joan Clarke "Lab 0/[1]_notes.txt" 40015 '27.11.2026 09:00'
file Ada Lovelace "Lab 0/readme.txt" 40012
pack several
graded 0 "4 of 4 graded and entered; 2 without submission; 0 passed over" --due "2026-11-26 12:00 Europe/Berlin"
check "files of one are together" test "$(cd "$class.out/collected" && echo joan-clarke-*/* ada-lovelace-*/*)" = \
    "$(cd "$class.out/collected" && echo joan-clarke-*/gradient.cl joan-clarke-*/notes.txt ada-lovelace-*/"Grace Hopper.zip" ada-lovelace-*/readme.txt)"
check "handed in with the last" test "$(jq -r '.students[] | select(.name == "Joan Clarke") | .late.is_late' "$class.out/gradebook.json")" = true

quick_ends

# ---- What is not certain ------------------------------------------------------------------------

# nobody NUMBER: has the line of the list with this number no grade?
nobody() { ! grep -e "\"$1\"" "$class.out/gradebook.csv" | grep -v '^,' | grep -q /report.html || { cat "$class.out/gradebook.csv"; return 1; }; }

# Two of one name: their archives stay apart, and the instructor says whose they are.
new namesakes && people "Lab 0/"
file Lukas Schmidt "Lab 0/ls.zip" 40016
file Lukas Schmidt "Lab 0/ls2.zip" 40017
pack namesakes
graded 1 "4 of 6 graded and entered"
everybody
check "two of one name: neither is guessed" nobody 40016
check "nor the other" nobody 40017
printf 'entry,student,counts\nls.zip,ls,yes\nls2.zip,ls2,yes\n' >"$scratch/who.csv"
class=$scratch/namesakes.zip
graded 0 "6 of 6 graded and entered" --who "$scratch/who.csv" --due "2026-11-26 00:00 Europe/Berlin"
check "two of one name: when each was handed in" test "$(jq '[.students[].late.handed_in // empty] | length' "$scratch/namesakes.out/gradebook.json")" -eq 6
check "two of one name: as the instructor says" own 40016
check "and the other" own 40017
# Two archives of one person may be those of two, too.
new twice && people "Lab 0/"
file Ada Lovelace "Lab 0/again.zip" 40012
pack twice
graded 1 "3 of 5 graded and entered"
check "two archives of one name: none is guessed" nobody 40012

# Two owners of one file: nobody's, though its name is somebody's.
new contested && people "Lab 0/"
file Grace Hopper "Lab 0/Joan Clarke.zip" 1
listed Jürgen Müller "Lab 0/Joan Clarke.zip"
sed -i '/gradient.cl/d' "$list" && rm "$scratch/contested/Lab 0/gradient.cl"
pack contested
graded 1 "3 of 4 graded and entered"
check "a file with two owners is nobody's" nobody 40015
check "and is told of" said '"Joan Clarke.zip": fits no line of the list'

# A student's own file of this name, which Stud.IP lists as any other: as a folder, a level higher, and as a zip.
new forged && people "Lab 0/"
sed 's/Ada";"Lovelace/X/; s/Jürgen";"Müller/Ada";"Lovelace/; s/X/Jürgen";"Müller/' "$list" >"$scratch/swapped"
file Ada Lovelace "Lab 0/archive_filelist.csv" 40012
cp "$scratch/swapped" "$scratch/forged/Lab 0/archive_filelist.csv"
for class in "$scratch/forged/Lab 0" "$scratch/forged"; do
    rm -rf "$scratch/forged.out"
    graded 0 "4 of 4 graded and entered"
    for number in 40013 40014 40015; do check "a forged list beside the files: $number has the own grade" own $number; done
done
pack forged
graded 0 "4 of 4 graded and entered"
for number in 40013 40014 40015; do check "a forged list in the zip: $number has the own grade" own $number; done
# Without the system's own, whatever the student knows of the names.
new guessed && people "Lab 0/"
mv "$list" "$scratch/guessed/Lab 0/archive_filelist.csv"
class="$scratch/guessed/Lab 0"
graded 1 "1 of 3 graded and entered"
check "a list among the files counts for nothing" nobody 40012
check "and gives nobody what is another's" nobody 40013
check "it is told" said "Lab 0/archive_filelist.csv: decides nothing"
pack guessed
graded 1 "1 of 3 graded and entered"
check "in a zip, too" nobody 40012
ln -s "$scratch/swapped" "$scratch/guessed/archive_filelist.csv"
class="$scratch/guessed/Lab 0"
graded 1 "1 of 3 graded and entered"
rm "$scratch/guessed/archive_filelist.csv"
for bad in 'Name;Autor' '"Vorname";"Nachname";"Pfad' "$(printf 'x\377')" ''; do
    printf '%s\n' "$bad" >"$scratch/guessed/archive_filelist.csv"
    class="$scratch/guessed/Lab 0"
    graded 1 "1 of 3 graded and entered"
    check "a list that is none is told" said "guessed/archive_filelist.csv: "
done
# A drop folder: the names of the archives say whose they are. Eve hands in lists that say otherwise.
mkdir "$scratch/drop"
printf 'Nr;Vorname;Nachname;Datum;Dateiname;Pfad\n' >"$scratch/drop/archive_filelist.csv"
for login in ada:gh jm:ada gh:jc jc:jm; do
    grep -- ";${login%:*};" "$scratch/people.csv" | cut -d ';' -f 4 >"$scratch/drop/${login%:*}.zip"
    printf '1;%s;;2026-11-24 10:00;%s.zip;%s.zip\n' "${login#*:}" "${login%:*}" "${login%:*}" >>"$scratch/drop/archive_filelist.csv"
done
class=$scratch/drop class_name=drop
graded 1 "4 of 4 graded and entered; 2 without submission; 1 passed over"
everybody
graded 1 "0 of 4 graded and entered" --due "2026-11-25 00:00 Europe/Berlin"
check "drop: nor is any time known" test "$(jq '[.students[].late.handed_in // empty] | length' "$class.out/gradebook.json")" -eq 0
check "drop: it is told" said "drop/archive_filelist.csv: decides nothing"
# Names and files of any kind.
new hostile
for i in 1 2 3 4; do file "=1+1$i" '<b>\n' "Lab 0/-rf \$(id) $i.zip" "$i"; done
file "" "" "Lab 0/gone.zip" 5
listed Eve Evil "../../../etc/passwd"
listed Eve Evil "Lab 0/.."
listed Eve Evil "Lab 0/"
pack hostile
check "hostile names: graded" exits 0 run "$scratch/hostile.out"
check "hostile names: all" said "5 submissions, 5 graded"
check "hostile names: no formula" sh -c "! grep -E '(^|,)\"?=' '$scratch/hostile.out/gradebook.csv'"
check "hostile names: as text" grep -q '&lt;b&gt;' "$scratch/hostile.out/class.html"

finish

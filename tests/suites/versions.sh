#!/bin/sh
# Several versions of one file in one submission: each is graded, none is entered, and the instructor decides. Only times
# that a system writes say which one is the last.
#
#     sh tests/suites/versions.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

check "the results of a right answer" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
check "and of none" exits 1 "$build/tools/grade" --build "$build" --lab 0 \
    --submission labs/$lab --output "$scratch/wrong"
# A file "wrong" earns nothing.
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" '
cat "$submission"/gradient*.cl >"$output/whose" 2>/dev/null
! grep -q wrong "$output/whose" || { cp -R "${0%/*}/../../wrong/." "$output"; exit 1; }'

# The list of every class: last name, first name, login, number.
cat >"$scratch/people.csv" <<'END'
Nachname;Vorname;Benutzername;Matrikelnummer;Grade
Lovelace;Ada;ada;40012;
Hopper;Grace;gh;40014;
Clarke;Joan;jc;40015;
Schmidt;Lukas;ls;40016;
Schmidt;Lukas;ls2;40017;
END

# begin NAME: a class without entries.
begin() {
    of=$1 class=$scratch/$1
    mkdir -p "$class"
}

# file PATH CONTENT: a file of the class.
file() {
    mkdir -p "$(dirname "$class/$1")"
    echo "$2" >"$class/$1"
}

# graded STATUS WORDS [OPTION...]: grade the class by the list; the last line begins so.
graded() {
    wanted_status=$1 words=$2
    shift 2
    check "$of: graded" exits "$wanted_status" run "$scratch/$of.out" --list "$scratch/people.csv" "$@"
    check "$of: $words" said "$words"
}

# feedback OPTION... SYSTEM: give the reports of the last class back.
feedback() { "$build/tools/gradebook" feedback "$@" "$scratch/$of.out" >"$scratch/said" 2>&1; }

# has NUMBER SCORE: what upload.csv has for the student of this number; "": nothing.
has() { grep -q "\"$1\"[,;]\"$2\"\$" "$scratch/$of.out/upload.csv" || { cat "$scratch/$of.out/upload.csv"; return 1; }; }

# undecided ENTRY WORDS: has who.csv a line for the entry, and does its reason say so?
undecided() { grep -F -- ",\"$1\"," "$scratch/$of.out/who.csv" | grep -qF -- "$2" || { cat "$scratch/$of.out/who.csv"; return 1; }; }

# ---- ILIAS --------------------------------------------------------------------------------------

# Without its times ILIAS gives the oldest upload the plain name, and the next one a number.
ada=Lovelace_Ada_ada_30001
begin ilias
file $ada/gradient.cl wrong
file "$ada/gradient (2).cl" ada
file "$ada/notes (2).txt" ada
file $ada/notes.txt other
file Hopper_Grace_gh_30002/gradient.cl grace
file "Clarke_Joan_jc_30003/gradient (2).cl" joan
file "Clarke_Joan_jc_30003/gradient.cl" joan
graded 1 "2 of 4 graded and entered; 2 without submission; 0 passed over; 0 with nothing of this lab; 2 to be decided by you"
check "ilias: no version is entered" has 40012 ""
check "ilias: one that has one is" has 40014 100.00
check "ilias: two of one content are one" has 40015 100.00
for version in gradient.cl "gradient (2).cl"; do
    check "ilias: \"$version\" is to be decided, with the scores of both" undecided "$ada/$version" \
        "is one of several versions, and no time says which is the last: \"\"$ada/gradient.cl\"\" earns 0, \"\"$ada/gradient (2).cl\"\" earns 100"
done
check "ilias: on the page, too" grep -q 'gradient (2).cl&quot; earns 100' "$scratch/ilias.out/class.html"
check "ilias: what else was handed in goes along" test "$(find "$scratch/ilias.out/collected" -name 'notes (2).txt' | wc -l)" -eq 2
check "ilias: it is not said that nothing was handed in" grep -q 'Lovelace.*"not entered"' "$scratch/ilias.out/gradebook.csv"
check "ilias: no report goes to anybody" sh -c "'$build/tools/gradebook' feedback folders '$scratch/ilias.out' |
    grep -c 'not given back: Lovelace_Ada .*one of several versions' | grep -qx 2"

# decide ENTRY COUNTS OTHER COUNTS [STUDENT]: the instructor's decisions about two entries of Ada's.
decide() { printf 'entry,student,counts\n"%s",ada,%s\n"%s",%s,%s\n' "$1" "$2" "$3" "${5-ada}" "$4" >"$scratch/who.csv"; }
decide "$ada/gradient (2).cl" yes "$ada/gradient.cl" no
graded 0 "3 of 4 graded and entered; 2 without submission; 0 passed over; 0 with nothing of this lab; 1 left out by you; 0 to be decided by you" \
    --who "$scratch/who.csv"
check "ilias: the one that counts" has 40012 100.00
decide "$ada/gradient.cl" yes "$ada/gradient (2).cl" "" ""
graded 0 "3 of 4 graded and entered" --who "$scratch/who.csv"
check "ilias: one yes is enough" has 40012 0.00
run "$scratch/ilias.out"
check "without a list: they are listed" said "\"$ada/gradient.cl\" (a version that earns 0), \"$ada/gradient (2).cl\" (a version that earns 100)"
check "and counted" said "1 to be decided by you"

check "a version's report goes back to the student" exits 0 feedback --list "$scratch/people.csv" --who "$scratch/who.csv" ilias
check "under the number that ILIAS knows" sh -c "unzip -l '$scratch/ilias.out/feedback-ilias.zip' | grep _30001/report.html"

# ILIAS has marked one of two versions as late: it says nothing of the other.
begin marked
file $ada/gradient.cl wrong
file "$ada/Verspaetete Abgabe - gradient (2).cl" ada
file Hopper_Grace_gh_30002/gradient.cl grace
graded 1 "1 of 3 graded and entered" --due "2026-11-25 23:59"
decide "$ada/gradient.cl" yes "$ada/Verspaetete Abgabe - gradient (2).cl" "" ""
graded 1 "1 of 3 graded and entered" --due "2026-11-25 23:59" --who "$scratch/who.csv"
check "marked: nobody knows when a version came" said "ILIAS marked some of the student's files as late, and not all"

# Where ILIAS writes times, they decide, whatever a student calls a file.
begin stamped
file $ada/20261103102233_17_gradient.cl wrong
file "$ada/20261104102233_18_gradient (2).cl" ada
file Hopper_Grace_gh_30002/20261103102233_19_gradient.cl grace
file "Clarke_Joan_jc_30003/20261103102233_20_gradient (2).cl" wrong
file Clarke_Joan_jc_30003/20261104102233_20_gradient.cl joan
graded 0 "3 of 3 graded and entered"
for number in 40012 40014 40015; do check "times decide: $number" has $number 100.00; done
# A student's own files called so are no times, where others' have none.
begin forged-times
file Hopper_Grace_gh_30002/gradient.cl grace
file Clarke_Joan_jc_30003/gradient.cl joan
file $ada/20251103102233_17_gradient.cl ada
file $ada/gradient.cl wrong
graded 1 "2 of 4 graded and entered" --due "2026-11-25 23:59"
check "a time that a student wrote decides nothing" has 40012 ""
check "and nothing is known of when it was" test "$(jq '[.students[].late.handed_in // empty] | length' "$scratch/forged-times.out/gradebook.json")" -eq 0

# A team's folder contains a folder for each member who uploaded. Who else is in the team ILIAS does not say.
begin teams
file "Team 12/Hopper_Grace_gh_30002/gradient.cl" team
file "Team 13/$ada/gradient.cl" ada
file "Team 14/Clarke_Joan_jc_30003/gradient.cl" joan
file "Team 14/Schmidt_Lukas_ls_30004/gradient.cl" wrong
graded 1 "2 of 4 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 2 to be decided by you"
check "teams: the member who uploaded" has 40014 100.00
check "teams: and one of another team" has 40012 100.00
check "teams: of nobody it is said that nothing was handed in" sh -c "! grep -q 'no submission' '$scratch/teams.out/gradebook.csv'"
check "teams: it is told" said '3 teams of ILIAS: it names only the members who uploaded'
check "teams: two uploads of one team" undecided "Team 14/Schmidt_Lukas_ls_30004/gradient.cl" 'gradient.cl"" earns 100'
sed '1s/$/;Group/; s/;$/&;/; /gh\|ls2/s/$/Team 12/' "$scratch/people.csv" >"$scratch/groups.csv"
rm -r "$class/Team 14"
check "teams: with groups" exits 0 run "$scratch/teams.out" --list "$scratch/groups.csv"
check "teams: all of the group" sh -c "[ \$(grep -c '100.00' '$scratch/teams.out/upload.csv') -eq 3 ] && grep 40017 '$scratch/teams.out/upload.csv' | grep -q 100.00"

# A student who is in the list twice, and one number under two names: said before anything is graded.
sed '2{p;}' "$scratch/people.csv" >"$scratch/twice.csv"
check "a line twice: refused" exits 2 run "$scratch/teams.out" --list "$scratch/twice.csv"
check "a line twice: what to do" said "line 3: the student of line 2 again: delete one of the two lines"
printf 'Identifier,"Full name",Grade\n"Participant 7","Ada Lovelace",\n"Participant 7","Grace Hopper",\n' >"$scratch/number.csv"
check "one number, two names: refused" exits 2 run "$scratch/teams.out" --list "$scratch/number.csv"
check "one number, two names: said" said "line 3: found the number of line 2 under another name"

quick_ends

# ---- Other systems ------------------------------------------------------------------------------

# studip NAME OWNER|FILE|CONTENT...: a class of Stud.IP's.
studip() {
    begin "$1"
    printf '"Name";"Größe";"Vorname";"Nachname";"Downloads";"Datum";"Pfad"\n' >"$class/archive_filelist.csv"
    shift
    for listed; do
        owner=${listed%%|*} path=${listed#*|}
        file "Lab 0/${path%|*}" "${path#*|}"
        printf '"%s";"5";"%s";"%s";"0";"25.11.2026 18:00";"Lab 0/%s"\n' "${path%|*}" "${owner% *}" "${owner#* }" "${path%|*}" >>"$class/archive_filelist.csv"
    done
}

# Two of one name, one file each: the system numbers the second, before or behind the name.
for names in "gradient(1).cl gradient(2).cl" "[1]_gradient.cl [2]_gradient.cl"; do
    one=${names% *} two=${names#* }
    studip "namesakes $two" "Ada Lovelace|gradient.cl|ada" "Lukas Schmidt|$one|wrong" "Lukas Schmidt|$two|right" "Grace Hopper|x.zip|gh"
    graded 1 "2 of 4 graded and entered; 1 without submission; 0 passed over; 0 with nothing of this lab; 2 to be decided by you"
    check "$of: neither is guessed" has 40016 ""
    check "$of: nor the other" has 40017 ""
    check "$of: the one file" undecided "$one" "\"\"$one\"\" earns 0, \"\"$two\"\" earns 100"
    check "$of: the other file" undecided "$two" "fits 2 lines of the list"
    printf 'entry,student,counts\n%s,ls,yes\n%s,ls2,yes\n' "$one" "$two" >"$scratch/who.csv"
    graded 0 "4 of 4 graded and entered" --who "$scratch/who.csv"
    check "$of: each has the own mark" has 40016 0.00
    check "$of: and the other" has 40017 100.00
done
# Files of different names are one submission. Which ones they are is said.
studip parts "Ada Lovelace|gradient.cl|ada" "Lukas Schmidt|gradient(1).cl|ls" "Lukas Schmidt|notes.txt|ls2" "Grace Hopper|x.zip|gh"
graded 1 "2 of 3 graded and entered"
check "parts: the names of all files" undecided "gradient(1).cl + notes.txt" "fits 2 lines of the list"

# Folders of one's own: names that are alike, and two folders that are equally good.
begin folders
file "Ada Lovelace/gradient.cl" wrong
file "Ada Lovelace/gradient-1.cl" ada
file "gh/src/gradient(1).cl" gh
file "gh/src/gradient.cl" wrong
file "jc/old/gradient.cl" wrong
file "jc/new/gradient.cl" jc
graded 1 "0 of 6 graded and entered; 2 without submission; 0 passed over; 0 with nothing of this lab; 6 to be decided by you"
check "folders: a name in a folder" undecided "gh/src/gradient(1).cl" '""gh/src/gradient.cl"" earns 0, ""gh/src/gradient(1).cl"" earns 100'
check "folders: two folders" undecided "jc/new/gradient.cl" '""jc/new/gradient.cl"" earns 100, ""jc/old/gradient.cl"" earns 0'
begin moodle
for f in gradient.cl:wrong "gradient (1).cl:ada"; do file "Ada Lovelace_7_assignsubmission_file_${f%:*}" "${f#*:}"; done
file "Grace Hopper_8_assignsubmission_file_gradient.cl" gh
graded 1 "1 of 3 graded and entered"
check "moodle: flat files" undecided "Ada Lovelace_7_assignsubmission_file_gradient (1).cl" "earns 100"
# Another entry that fits the same student is not entered beside them.
begin beside
file ada/gradient.cl wrong
file "ada/gradient (2).cl" ada
file "Ada Lovelace/gradient.cl" ada
graded 1 "0 of 3 graded and entered"
check "beside: nothing is entered" has 40012 ""

# As many as somebody likes to hand in: some are graded, and none counts.
begin many
i=1
while [ $i -le 300 ]; do file "ada/gradient ($i).cl" "$i" && i=$((i + 1)); done
file gh/gradient.cl gh
graded 1 "1 of 17 graded and entered"
check "many: none is entered" has 40012 ""

finish

#!/bin/sh
# Classes of 25 with odd and hostile names, as Canvas, Blackboard, ILIAS, Stud.IP and VPL write them into an export, with
# late and repeated uploads. Nobody is lost, and nobody has another's grade.
#
#     sh tests/suites/odd_names.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
# Beside them it is written down whose file was graded: each holds its student's number.
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" 'cat "$submission"/gradient.cl "$submission/gradient (2).cl" "$submission"/*/gradient.cl "$submission"/*"- gradient.cl" 2>/dev/null | tail -n 1 >"$output/whose"
[ -s "$output/whose" ] || cat "$submission" >"$output/whose"'

# Number, first name, last name, login; the name that Canvas puts before its numbers, and ILIAS' folder. Both were
# made by the systems' own rules: content_zipper.rb, and getASCIIFilename().
cat >"$scratch/people" <<'END_OF_PEOPLE'
40001;Ada;Lovelace;ada;lovelaceada_40001;Lovelace_Ada_ada_40001
40002;Ada;Lovelace;alove;lovelaceada_40002;Lovelace_Ada_alove_40002
40003;Jörg;Müller;jm;müllerjörg_40003;Mueller_Joerg_jm_40003
40004;Joerg;Mueller;jom;muellerjoerg_40004;Mueller_Joerg_jom_40004
40005;Anna-Lena;von Weiß-Groß;alw;vonweißgroßannalena_40005;von Weiss-Gross_Anna-Lena_alw_40005
40006;Sean;O'Brien;sob;obriensean_40006;O'Brien_Sean_sob_40006
40007;René;D’Arcy;rda;darcyrené_40007;DrArcy_Rene_rda_40007
40008;Łukasz;Żółć;lz;żółćłukasz_40008;__o_______ukasz_lz_40008
40009;Văn An;Nguyễn;vna;nguyễnvănan_40009;Nguy___n_V__n An_vna_40009
40010;名前;山田;yn;山田名前_40010;______________yn_40010
40011;Μαρία;Παπαδοπούλου;mp;παπαδοπούλουμαρία_40011;Papadopo__lou_Mar__a_mp_40011
40012;عمر;خيام;ok;خيامعمر_40012;________________ok_40012
40013;X Æ A-12;Møsk;xm;møskxæa12_40013;Mosk_X A A-12_xm_40013
40014;Charles;d_Artagnan;c_da;d_artagnancharles_40014;d_Artagnan_Charles_c_da_40014
40015;Robert') DROP TABLE;Students;bobby;studentsrobertdroptable_40015;Students_Robert') DROP TABLE_bobby_40015
40016;=1+1;Formula;=fo;formula11_40016;Formula_=1+1_=fo_40016
40017;-rf;Minus;rf;minusrf_40017;Minus_-rf_rf_40017
40018;Ulf "Quote";Quotes;uq;quotesulfquote_40018;Quotes_Ulf _Quote__uq_40018
40019;Anna, Maria;Comma;am;commaannamaria_40019;Comma_Anna, Maria_am_40019
40020;;Sukarno;suk;sukarno_40020;Sukarno__suk_40020
40021;Maria;Late;_LATE;latemaria_40021;Late_Maria__LATE_40021
40022;Eve;attempt_2026-11-03-10-22-33_x;eve;attempt_20261103102233_xeve_40022;attempt_2026-11-03-10-22-33_x_Eve_eve_40022
40023;Zoë;Ångström;za;ångströmzoë_40023;Angstroem_Zoe_za_40023
40024;Smiley 😊;Name;sn;namesmiley_40024;Name_Smiley _____sn_40024
40025;Eve;x_40001;eve2;x_40001eve_40025;x_40001_Eve_eve2_40025
END_OF_PEOPLE

# class_of NAME HEAD LINE FUNCTION: a class of which FUNCTION makes what each has handed in, and its list with
# NUMBER, FIRST, LAST and LOGIN in each line.
class_of() {
    class=$scratch/$1 line=$3 function=$4
    mkdir -p "$class"
    printf '%s\n' "$2" >"$class.csv"
    while IFS=';' read -r number first last login canvas ilias; do
        "$function"
        FIRST=$(printf %s "$first" | sed 's/"/""/g') NUMBER=$number LAST=$last LOGIN=$login LINE=$line awk 'BEGIN {
            text = ENVIRON["LINE"]
            while (match(text, /FIRST|LAST|NUMBER|LOGIN/)) {
                printf "%s%s", substr(text, 1, RSTART - 1), ENVIRON[substr(text, RSTART, RLENGTH)]
                text = substr(text, RSTART + RLENGTH)
            }
            print text }' >>"$class.csv"
    done <"$scratch/people"
}

# all_graded LINE: is everybody graded, with the own file, and does the last line begin so?
all_graded() {
    check "${class##*/}: graded" exits 0 run "$class.out" --list "$class.csv"
    check "${class##*/}: $1" said "$1"
    while IFS=';' read -r number _; do
        check "${class##*/}: $number has the own grade" own "$number"
    done <"$scratch/people"
}

canvas() {
    # Every third is late, every fourth handed in again; a Mac writes accents apart from letters.
    again='' name=$canvas
    [ $((number % 3)) -ne 0 ] || name=${canvas%_*}_LATE_${canvas##*_}
    [ $((number % 4)) -ne 0 ] || again=-1
    case $number in 40023) name=$(printf 'a\314\212ngstro\314\210mzoe\314\210_LATE_40023') ;; esac
    echo "$number" >"$class/${name}_88${number}_gradient$again.cl"
    echo "$number" >"$class/${name}_99${number}_render.c"
}
class_of canvas 'Student,ID,SIS User ID,SIS Login ID,Section,Lab 0 (4711)' '"LAST, FIRST",NUMBER,uNUMBER,"LOGIN",A,' canvas
all_graded "25 of 25 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"

# As newer releases of ILIAS write it: the student's own names of files.
ilias() {
    folder="$class/Lab 0/Submissions/$ilias"
    mkdir -p "$folder"
    case $((number % 3)) in
    0) echo "$number" >"$folder/Late Submission - gradient.cl" ;;
    1) echo "$number" >"$folder/gradient (2).cl" ;;
    2) echo "$number" >"$folder/gradient.cl" ;;
    esac
}
class_of ilias '"Nachname";"Vorname";"Benutzername";"Matrikelnummer"' '"LAST";"FIRST";"LOGIN";"NUMBER"' ilias
all_graded "25 of 25 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"

quick_ends

# Logins as they are: of two, one is the end of the other's.
blackboard() {
    for time in 2026-11-03-10-22-33 2026-11-04-10-22-33; do
        # Every third has a second attempt.
        case $time$((number % 3)) in *-04-*[12]) continue ;; esac
        stem="$class/Lab 0_${login}_attempt_$time"
        echo "Name: $first $last ($login)" >"$stem.txt"
        case $time$((number % 3)) in *-03-*0) echo older ;; *) echo "$number" ;; esac >"${stem}_gradient.cl"
    done
}
class_of blackboard '"Last Name","First Name","Username","Student ID","Lab 0 [Total Pts: 100 Score] |91"' \
    '"LAST","FIRST","LOGIN","NUMBER",""' blackboard
all_graded "25 of 33 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 8 earlier attempts; 0 to be decided by you"

studip() { echo "$number" >"$class/[$((number % 7))]_$login.zip"; }
class_of studip 'Vorname;Nachname;Nutzernamen;Matrikelnummer' '"FIRST";"LAST";"LOGIN";NUMBER' studip
all_graded "25 of 25 graded and entered; 0 without submission; 0 passed over"

# Moodle's VPL: a folder for each attempt, and what VPL's own evaluation said beside it.
vpl() {
    folder="$class/$(printf %s "$last $first $number $login" | tr '?.,:*<>|/' '_________')"
    mkdir -p "$folder/2026-11-03-10-22-33" "$folder/2026-11-03-10-22-33.ceg"
    echo "$number" >"$folder/2026-11-03-10-22-33/gradient.cl"
    echo "Grade :=>> 100" >"$folder/2026-11-03-10-22-33.ceg/execution.txt"
    echo "Number of users: 25" >"$class/Report.txt"
}
class_of vpl 'Vorname,Nachname,Anmeldename,ID-Nummer,Test: Lab 0 (Punkte)' '"FIRST","LAST","LOGIN","NUMBER",' vpl
all_graded "25 of 25 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"

# A class without logins in its list: who has a name that two have in ASCII is left to the instructor.
class=$scratch/ilias
printf '%s\n' '"Nachname";"Vorname"' '"Müller";"Jörg"' '"Mueller";"Joerg"' '"Minus";"-rf"' >"$class.csv"
check "ilias without logins: graded" exits 1 run "$class.out" --list "$class.csv"
check "a name of ASCII is its own" grep -q '^"Minus","'"'"'-rf","Minus_-rf","40017"' "$class.out/gradebook.csv"
check "an umlaut that ILIAS has written as two letters is nobody's" grep -q '^"Müller","Jörg",,,,"not entered"' "$class.out/gradebook.csv"

finish

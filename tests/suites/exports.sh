#!/bin/sh
# A class as each course system exports it: the names of files and folders that the systems document, with
# their own lists of participants. Nobody is lost, and nobody has another's grade.
#
#     sh tests/suites/exports.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
# Beside them it is written down whose file was graded: each holds its student's number.
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" 'echo "$student" >"$output/student"; echo " Score 100/100"
cat "$submission/gradient.cl" >"$output/whose" 2>/dev/null || cat "$submission" >"$output/whose"'

# Number, first name, last name, login: two of one name, and letters that are not ASCII.
cat >"$scratch/people" <<'END_OF_PEOPLE'
40012,Ada,Lovelace,ada
40013,Ada,Lovelace,alove
40014,Jörg,Müller,jm
40015,Anna-Lena,Weiß,alw
40016,Sean,O'Brien,sob
40017,Grace,Hopper,gh
40018,Joan,Clarke,jc
40019,Mary,Shaw,ms
40020,Jean,Jennings,jj
40021,Kathleen,Booth,kb
40022,Radia,Perlman,rp
40023,Barbara,Liskov,bl
END_OF_PEOPLE

# export_of SYSTEM FUNCTION: a class of which FUNCTION makes what each has handed in, from number, first
# and last name, login.
export_of() {
    class=$scratch/$1
    mkdir -p "$class"
    while IFS=, read -r number first last login; do
        "$2" "$number" "$first" "$last" "$login"
    done <"$scratch/people"
}

# list HEAD LINE: a list of the class, with NUMBER, FIRST, LAST and LOGIN of each in the line.
list() {
    echo "$1" >"$class.csv"
    awk -F , -v line="$2" '{ text = line
        gsub("NUMBER", $1, text); gsub("FIRST", $2, text); gsub("LAST", $3, text); gsub("LOGIN", $4, text)
        print text }' "$scratch/people" >>"$class.csv"
}

# graded STATUS LINE [SUBMISSIONS]: grade it by the list; the last line begins so.
graded() {
    all=$class
    class=${3:-$class}
    check "${all##*/}: graded" exits "$1" run "$all.out" --moodle "$all.csv"
    class=$all
    check "${all##*/}: $2" said "$2"
}

# all_own: everybody's.
all_own() {
    while IFS=, read -r number _; do
        check "${class##*/}: $number has the own grade" own "$number"
    done <"$scratch/people"
}

# given_back FOR FILE PATTERN: does everybody get the own report back? It ends in the student's number,
# which stands for NUMBER in the pattern of its path.
given_back() {
    "$build/tools/gradebook" feedback --moodle "$class.csv" "$1" "$class.out" >"$scratch/said" 2>&1 || { cat "$scratch/said"; return 1; }
    rm -rf "$class.back"
    case $2 in *.zip) unzip -q -d "$class.back" "$class.out/$2" ;; *) cp -R "$class.out/$2" "$class.back" ;; esac
    while IFS=, read -r number _; do
        path=$(echo "$3" | sed "s/NUMBER/$number/")
        # shellcheck disable=SC2086 # a pattern
        [ "$(cat "$class.back"/$path | tail -n 1)" = "$number" ] || { echo "$number has not its report"; return 1; }
    done <"$scratch/people"
}

# ---- Moodle -------------------------------------------------------------------------------------

moodle() {
    name="$2 $3"
    # As an archiver of a Mac, of Windows, and Moodle itself write these names.
    case $1 in
    40014) name=$(printf 'Jo\314\210rg Mu\314\210ller') ;;
    40015) name=$(printf 'Anna-Lena Wei\341') ;;
    40016) name="Sean OBrien" ;;
    esac
    mkdir "$class/${name}_$1_assignsubmission_file_"
    echo "$1" >"$class/${name}_$1_assignsubmission_file_/gradient.cl"
}
export_of moodle moodle
list 'Identifier,"Full name",Grade,"Feedback comments"' '"Participant NUMBER","FIRST LAST",,'
mkdir "$class/Grace Hopper_40017_assignsubmission_onlinetext_" "$class/mailed"
echo "by mail" >"$class/mailed/gradient.cl"
echo "my text" >"$class/Grace Hopper_40017_assignsubmission_onlinetext_/onlinetext.html"
graded 1 "12 of 14 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 1 earlier attempts; 1 to be decided by you"
all_own
check "moodle: everybody gets the own report back" \
    given_back moodle feedback-moodle.zip '*_NUMBER_assignsubmission_file_/report.html'
check "moodle: the zip holds nothing else" [ "$(find "$class.back" -type f | wc -l)" -eq 12 ]
check "moodle: the points of each task are comments" \
    [ "$(grep -c '"100 of 100 points: gradient 40/40, ' "$class.out/gradebook.csv")" -eq 12 ]
check "without addresses nobody is written to" \
    sh -c "'$build/tools/gradebook' feedback --moodle '$class.csv' mail '$class.out' | grep -q '^0 reports given back, 13 not'"
check "an unknown way is refused" \
    sh -c "'$build/tools/gradebook' feedback fax '$class.out' 2>&1 | grep -q 'found \"fax\", expected moodle'"

moodle_flat() {
    for file in gradient.cl render.c; do echo "$1" >"$class/$2 $3_$1_assignsubmission_file_$file"; done
}
export_of moodle-flat moodle_flat
list 'Identifier,"Full name",Grade' '"Participant NUMBER","FIRST LAST",'
echo '"Participant 99","Nobody",' >>"$class.csv"
graded 0 "12 of 12 graded and entered; 1 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"
all_own

check "two of one name are told apart on the page" \
    test "$(grep -c 'class="name"><a [^>]*>Ada Lovelace (4001[23])<' "$class.out/class.html")" -eq 2
check "and in lines of progress, which hold names" said "  Ada Lovelace (40012): "
check "who has a name for himself has no number there" said "  Joan Clarke: "
check "and reports are given the name" test "$(cat "$class.out"/students/joan-clarke-*/student)" = "Joan Clarke"

# An archive beside loose files is no second attempt.
for file in a.zip b.zip; do
    echo zip >"$class/Ada Lovelace_40012_assignsubmission_file_$file"
done
rm -r "$class.out"
graded 0 "12 of 12 graded and entered; 1 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"
all_own
check "the archives of an upload lie beside its files" \
    test "$(find "$class.out/collected"/ada-lovelace-*/ -name '*.zip' | wc -l)" -eq 2

# Of a team each member has a folder, or all have one: by a column of groups.
moodle_team() {
    mkdir "$class/Team A-$2 $3_$1_assignsubmission_file_"
    echo "$1" >"$class/Team A-$2 $3_$1_assignsubmission_file_/gradient.cl"
}
export_of moodle-team moodle_team
list 'Identifier,"Full name",Grade' '"Participant NUMBER","FIRST LAST",'
graded 0 "12 of 12 graded and entered"
all_own

# ---- Canvas -------------------------------------------------------------------------------------

canvas() {
    name=$(printf %s "$3$2" | tr -d "'-" | sed 'y/ABCDEFGHIJKLMNOPQRSTUVWXYZ/abcdefghijklmnopqrstuvwxyz/')
    late='' again=''
    case $1 in *8) late=_LATE ;; *9) again=-2 ;; esac
    echo "$1" >"$class/$name${late}_$1_8800${1#400}_gradient$again.cl"
    echo "$1" >"$class/$name${late}_$1_8801${1#400}_render.c"
}
export_of canvas canvas
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"
"    Points Possible",,,,,100.00' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
echo "7" >"$class/mailed.c"
graded 1 "12 of 12 graded and entered; 0 without submission; 1 passed over; 0 with nothing of this lab; 0 to be decided by you"
all_own
check "canvas: a file that is nobody's is named" said '"mailed.c"'
check "canvas: ILIAS would not know whose they are" \
    sh -c "'$build/tools/gradebook' feedback --list '$class.csv' ilias '$class.out' | grep -q '^0 reports given back, 12 not'"
check "canvas: everybody gets the own report back, beside the number of a file" \
    given_back canvas feedback-canvas.zip '*_NUMBER_880[01]*_report.html'

quick_ends

# Two uploads of one name lie side by side: which one counts is staging's to say (suite staging).
class=$scratch/canvas-twice
mkdir "$class"
for number in 2 10; do echo $number >"$class/lovelaceada_40012_8800${number}_gradient-$number.cl"; done
echo 1 >"$class/hoppergrace_40017_880017_gradient-1.cl"
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
graded 0 "2 of 2 graded and entered"
check "two uploads are both kept" \
    test "$(cd "$class.out/collected" && echo ./*/*)" = "$(cd "$class.out/collected" && echo ./hop*/gradient.cl ./love*/gradient-10.cl ./love*/gradient-2.cl)"

# ---- Blackboard ---------------------------------------------------------------------------------

blackboard() {
    for day in 03 04; do
        # All have one attempt, and one has two, of which the first has less.
        [ $day = 03 ] || [ "$1" = 40020 ] || continue
        stem="$class/Lab 0_$4_attempt_2026-11-$day-10-22-33"
        echo "Name: $2 $3 ($4)" >"$stem.txt"
        case $day$1 in
        0340020) echo "older" >"${stem}_gradient.cl" ;;
        *) echo "$1" >"${stem}_gradient.cl" ;;
        esac
    done
}
export_of blackboard blackboard
# A student's own name of a file may look like the system's.
echo "of ada" >"$class/Lab 0_ada_attempt_2026-11-03-10-22-33_Lab 0_gh_attempt_2026-11-30-10-22-33_gradient.cl"
list '"Last Name","First Name",Username,"Student ID"' '"LAST","FIRST",LOGIN,NUMBER'
graded 0 "12 of 13 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 1 earlier attempts; 0 to be decided by you"
all_own

# ---- ILIAS --------------------------------------------------------------------------------------

ilias() {
    folder="$class/Übung 3/Abgaben/$3_$2_$4_$1"
    mkdir -p "$folder"
    echo "older" >"$folder/20261103102233_1${1}_gradient.cl"
    echo "$1" >"$folder/20261104102233_2${1}_gradient.cl"
}
export_of ilias ilias
list '"Nachname";"Vorname";"Benutzername";"Matrikelnummer"' '"LAST";"FIRST";"LOGIN";"NUMBER"'
: >"$class/Übung 3/Übersicht.xlsx"
graded 0 "12 of 12 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 0 to be decided by you"
check "ilias: and which folder that is" said "Übung 3/Abgaben: this folder is graded"
all_own
check "ilias: everybody gets the own report back, under ILIAS' number" \
    given_back ilias feedback-ilias.zip 'multi_feedback/*_NUMBER/report.html'
check "ilias: in three parts each, and nothing else" \
    test "$(unzip -Z1 "$class.out/feedback-ilias.zip" | grep -c '^multi_feedback/[A-Za-z -]*_[0-9]*/report.html$')" -eq "$(unzip -Z1 "$class.out/feedback-ilias.zip" | wc -l)"
rm -r "$class.out"
graded 0 "12 of 12 graded and entered" "$class/Übung 3/Abgaben"
all_own

# ---- Stud.IP, Gradescope, GitHub, Brightspace ---------------------------------------------------

studip() { echo "$1" >"$class/[1]_$4.zip"; }
export_of studip studip
echo '"Name";"Autor"' >"$class/archive_filelist.csv"
list 'Vorname;Nachname;Nutzernamen;Matrikelnummer' 'FIRST;LAST;LOGIN;NUMBER'
graded 1 "12 of 12 graded and entered; 0 without submission; 1 passed over"
all_own
check "studip: the list among the files decides nothing" said "archive_filelist.csv: decides nothing"

gradescope() {
    mkdir "$class/submission_9$1"
    echo "$1" >"$class/submission_9$1/gradient.cl"
    printf "submission_9%s:\n  :submitters:\n  - :name: %s %s\n    :sid: '%s'\n    :email: %s@example.org\n" \
        "$1" "$2" "$3" "$1" "$4" >>"$class/submission_metadata.yml"
}
export_of gradescope gradescope
list 'First Name,Last Name,Student ID,Email' 'FIRST,LAST,NUMBER,LOGIN@example.org'
graded 0 "12 of 12 graded and entered; 0 without submission; 0 passed over"
all_own

github() {
    mkdir -p "$class/raytracing-lab03-$4/.git"
    echo "$1" >"$class/raytracing-lab03-$4/gradient.cl"
}
export_of github github
list '"Full name","GitHub username","ID number"' '"FIRST LAST",LOGIN,NUMBER'
graded 0 "12 of 12 graded and entered; 0 without submission; 0 passed over"
all_own

brightspace() {
    for time in "Nov 3, 2026 1022 PM" "Nov 4, 2026 922 AM"; do
        case $time$1 in "Nov 4"*[13579]) continue ;; esac
        folder="$class/$1-88003 - $2 $3 - $time"
        mkdir "$folder"
        case $time$1 in
        "Nov 3"*[02468]) echo "older" >"$folder/gradient.cl" ;;
        *) echo "$1" >"$folder/gradient.cl" ;;
        esac
    done
}
export_of brightspace brightspace
: >"$class/index.html"
list 'OrgDefinedId,Username,"Last Name","First Name",Email,"Lab 0 Points Grade"' \
    '#NUMBER,LOGIN,"LAST","FIRST",LOGIN@example.org,'
graded 0 "12 of 18 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 6 earlier attempts; 0 to be decided by you"
all_own

# ---- A whole course: several exercises side by side -----------------------------------------------

# exercise NUMBER: an exercise, as ILIAS or Moodle exports one.
exercise() {
    n=$1
    case $kind in
    ilias)
        for name in Lovelace_Ada_ada_40012 Hopper_Grace_gh_40017; do
            mkdir -p "$class/Übung $n/Abgaben/$name"
            echo "${name##*_}" >"$class/Übung $n/Abgaben/$name/20261104102233_2_gradient.cl"
        done ;;
    moodle)
        for name in "Ada Lovelace_40012" "Grace Hopper_40017"; do
            mkdir -p "$class/Lab $n/${name}_assignsubmission_file_"
            echo "${name##*_}" >"$class/Lab $n/${name}_assignsubmission_file_/gradient.cl"
        done ;;
    esac
}
for kind in ilias moodle; do
    class=$scratch/course-$kind
    for number in 1 2 3; do exercise $number; done
    check "$kind: of several exercises none is taken where none has the lab's number" exits 2 run "$class.out"
    check "$kind: they are named, and what to do" said "found several exercises side by side, and none has the number 0; give the folder of one of them, as SUBMISSIONS=\"$class/"
    exercise 0
    mkdir "$class/Sheet 0"
    check "$kind: the one with the lab's number is entered" exits 0 run "$class.out"
    check "$kind: that is said" said " 0: this folder is graded"
    check "$kind: and only its submissions are graded" said "2 of 2 graded"
done

class=$scratch/course-moodle
rm -r "$class"/*0
(cd "$class" && zip -q -r ../course.zip .)
class=$scratch/course.zip
check "a course as an archive: none is taken either" exits 2 run "$scratch/course.out"
check "and the advice is none that is refused later" \
    said '; unpack the archive yourself and give the folder of one of them, as SUBMISSIONS="FOLDER/Lab '

# Whoever hands in folders like these is no course.
class=$scratch/no-course
mkdir -p "$class/ada/Abgaben/lab" "$class/bob/Submissions/lab" "$class/cy"
for student in ada bob cy; do echo x >"$class/$student/gradient.cl"; done
check "two students' folders are no exercises" exits 0 run "$class.out"
check "all three are graded" said "3 of 3 graded"
class=$scratch/no-course-of-gradescope
for number in 1 2 3; do
    mkdir -p "$class/submission_$number"
    echo x >"$class/submission_$number/gradient.cl"
    [ $number = 3 ] || mkdir "$class/submission_$number/"Ada_1_assignsubmission_file_ "$class/submission_$number/"Bob_2_assignsubmission_file_
    printf "submission_%s:\n  :submitters:\n  - :name: Student %s\n" $number $number >>"$class/submission_metadata.yml"
done
check "nor beside Gradescope's list of who handed in" exits 0 run "$class.out"
check "of whom all three are graded" said "3 of 3 graded"

# ---- One student's many files ---------------------------------------------------------------------

# read_soon SUBMISSIONS: is the folder read in a minute of processor time, where it once took many?
# shellcheck disable=SC2317 # called by check
read_soon() {
    rm -rf "$scratch/soon" && mkdir "$scratch/soon"
    exits 0 prlimit --cpu=60 "$build/tools/gradebook" roster 0 "$1" "$scratch/soon" >"$scratch/said" 2>&1
}
class=$scratch/many
mkdir -p "$class/ada" "$class/bob"
(cd "$class/bob" && seq -f 'Lab_a_attempt_2026-11-03-10-22-33_f%.0f' 4000 | xargs touch)
check "one student's many files do not make the class wait" read_soon "$class"
check "nor do those of an export" read_soon "$class/bob"

# ---- An export that is an archive ---------------------------------------------------------------

# same_as NAME: is the gradebook that of this class, with everybody's own file?
same_as() { cmp "$class.out/gradebook.csv" "$scratch/$1.out/gradebook.csv"; }

# What a student hands in may hold links, archives, an editor's files and more folders than are searched.
class=$scratch/moodle
student="$class/Joan Clarke_40018_assignsubmission_file_"
mkdir -p "$student/a/b/c/d/e/f/g/h/i/j/.git"
ln -s /etc/passwd "$student/link"
echo deep >"$student/a/b/c/d/e/f/g/h/i/j/.git/x"
graded 1 "12 of 14 graded and entered"
(cd "$class" && zip -q -r -y ../moodle-export.zip .)
(cd "$scratch" && tar -czf packed.tar.gz --transform 's|^moodle|packed|' moodle && cp packed.tar.gz renamed.tgz)
for archive in moodle-export.zip packed.tar.gz renamed.tgz; do
    class=$scratch/${archive%%.*}
    cp "$scratch/moodle.csv" "$class.csv"
    graded 1 "12 of 14 graded and entered" "$scratch/$archive"
    check "$archive: nobody is lost, and nobody swapped" same_as moodle
    check "$archive: links lead nowhere" \
        test "$(find "$class.out/export" -path '*/Joan Clarke_40018_assignsubmission_file_/link' -exec readlink {} +)" = nowhere
    check "$archive: nothing is left of unpacking" test -z "$(ls "$scratch/w")"
done
for student in "$class.out/students"/*; do : >"$student/kept"; done
graded 1 "12 of 14 graded and entered" "$scratch/packed.tar.gz"
check "the same archive again: nobody is graded anew" \
    test "$(find "$class.out/students" -name kept | wc -l)" -eq 14
class=$scratch/renamed
graded 1 "12 of 14 graded and entered" "$scratch/renamed.tgz"
check "of an archive of another name it is said that its folder is graded" \
    said "gradebook: renamed.tgz: its only folder is graded: packed"
check "no others may read what is unpacked" test -z "$(find "$class.out/export" ! -type l -perm /077)"

# A student's own folder may hold several.
while IFS='|' read -r archive top folders graded; do
    class=$scratch/$archive
    mkdir "$class"
    (cd "$class" && for folder in $folders; do mkdir -p "$top/$folder" && echo x >"$top/$folder/gradient.cl"; done &&
        tar -cf "$class.tar" .)
    class=$class.tar
    check "$archive: graded" exits 0 run "$scratch/$archive.out"
    check "$archive: $graded of $graded" said "$graded of $graded graded;"
done <<'END'
classes (1)|class|ada bob|2
one folder|ada|src|1
a repository|ada|.git src|1
one of Moodle|Ada Lovelace_40012_assignsubmission_file_|labs build|1
one of Brightspace|40012-88003 - Ada Lovelace - Nov 3, 2026 1022 PM|labs build|1
END
class=$scratch/hidden.tar
mkdir -p "$scratch/hidden/ada" "$scratch/hidden/bob" "$scratch/.eve"
(cd "$scratch" && tar -cf hidden.tar hidden .eve)
check "a name that begins with a dot: graded" exits 0 run "$scratch/hidden.out"
check "and is not passed over" test -n "$(find "$scratch/hidden.out/students" -name 'eve-*')"

# refused ARCHIVE WORDS: not graded, for this reason?
refused() {
    exits 2 tests/class/grading/grade_class.sh --build "$build" --lab 0 --submissions "$scratch/$1" --output "$scratch/refused" \
        >"$scratch/said" 2>&1 </dev/null && said "gradebook: $1: $2"
}
head -c -40 "$scratch/packed.tar.gz" >"$scratch/cut.tar.gz"
(cd "$scratch" && for student in ada bob cy; do echo x >$student.zip; done &&
    tar -c ada.zip bob.zip cy.zip | head -c 2048 >cut.tar)
printf 'Rar!\032\007\001' >"$scratch/class.rar"
(cd "$scratch" && tar -cf twice.tar moodle.csv && tar -rf twice.tar moodle.csv && tar -Pcf out.tar ../../etc/hostname &&
    zip -q -P secret secret.zip moodle.csv)
while IFS='|' read -r archive words; do
    check "$archive is refused as what it is" refused "$archive" "$words"
done <<'END'
cut.tar|the archive is damaged or cut off (a tar archive without its end mark): unpack it yourself
cut.tar.gz|found a compressed file (gzip) that is cut off or no tar archive
class.rar|found a RAR archive, expected the submissions in a folder, or in a zip or tar archive
twice.tar|"moodle.csv" is in the archive twice: unpack it yourself, and give the folder
secret.zip|the archive is encrypted: unpack it yourself, and give the folder
out.tar|"../../etc/hostname" is no path below a folder, or a long one: unpack it yourself
END

class=$scratch/cut.tar.gz
check "after a good archive, one that is refused" exits 2 run "$scratch/packed.out"
check "leaves what was unpacked" test -e "$scratch/packed.out/export"
mkdir "$scratch/bin"
# shellcheck disable=SC2016 # for the other shell
printf '#!/bin/sh\ncase $* in */export) exit 1 ;; esac\nPATH=%s exec rm "$@"\n' "$PATH" >"$scratch/bin/rm"
chmod +x "$scratch/bin/rm"
class=$scratch/packed.tar.gz
# shellcheck disable=SC2317 # called by check
without_rm() (
    PATH=$scratch/bin:$PATH
    exits 2 run "$scratch/packed.out"
)
check "an older one that cannot be removed ends it" without_rm

# full_disk: unpack an archive where the program finds no room for its files.
# shellcheck disable=SC2317 # called by check
full_disk() {
    mkdir -p "$scratch/full/tools" "$scratch/full/to"
    # shellcheck disable=SC2016 # for the other shell
    printf '#!/bin/sh\n[ "$1" != /dev/null ] || exit 1\necho "unpack: no space left" >&2\nexit 2\n' \
        >"$scratch/full/tools/unpack"
    chmod +x "$scratch/full/tools/unpack"
    chmod 711 "$scratch/full" "$scratch/full/to"
    exits 2 "$build/tools/gradebook" unpack "$scratch/full" "$scratch/packed.tar.gz" "$scratch/full/to" \
        >"$scratch/said" 2>&1
}
check "a full disk ends it" full_disk
check "and is not taken for a damaged archive" said ": unpack: no space left"

# ---- Names that students choose -----------------------------------------------------------------

# nobody NUMBER: has the line of the list that has this number no grade?
nobody() { ! grep -w -- "$1" "$class.out/gradebook.csv" | grep -v '^,' | grep -q /report.html || { cat "$class.out/gradebook.csv"; return 1; }; }

# Eve's files, more than all others', look like those of another system, and of another student.
class=$scratch/looks-like-blackboard
mkdir "$class"
for number in 40013 40014 40015; do echo $number >"$class/student${number}_${number}_8800${number}_gradient.cl"; done
for file in gradient.cl render.c a.c b.c; do
    echo 40099 >"$class/evileve_40099_8810${#file}_x_ada_attempt_2026-11-03-10-22-33_$file"
done
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
run "$class.out" --moodle "$class.csv"
for number in 40013 40014 40015; do check "files like another system's: $number has the own grade" own $number; done
check "and who handed in nothing has no grade" nobody 40012

# The same where Canvas' own pattern cannot be read in them: most files of the folder look like Blackboard's, of ada.
class=$scratch/most-files
mkdir "$class"
for number in 40013 40014 40015; do echo $number >"$class/student${number}_${number}_8800${number}_gradient.cl"; done
for file in a b c d e f g h; do
    echo 40099 >"$class/evileve_40099_88101_1_ada_attempt_2026-11-03-10-22-33_$file.cl"
done
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
run "$class.out" --moodle "$class.csv"
for number in 40013 40014 40015; do check "one student's many files: $number has the own grade" own $number; done
check "one student's many files make no entry of another" nobody 40012
# One login in many files, which ends in another's login: that is no title of the assignment.
class=$scratch/most-titles
mkdir "$class"
for login in gh jc; do echo $login >"$class/Lab 0_${login}_attempt_2026-11-03-10-22-33_gradient.cl"; done
for file in gradient.cl a b c; do echo eve >"$class/Lab 0_eve_ada_attempt_2026-11-03-10-22-33_$file"; done
list '"Last Name","First Name",Username,"Student ID"' '"LAST","FIRST",LOGIN,NUMBER'
run "$class.out" --moodle "$class.csv"
check "many files of the login eve_ada are not ada's" nobody 40012
check "and the others have theirs" said "2 of 3 graded and entered"
# A folder that all can write to. One student's many files look like Blackboard's, with a time of her own.
class=$scratch/drop-folder
mkdir "$class"
for login in ada gh jc; do mkdir "$class/$login" && echo $login >"$class/$login/gradient.cl"; done
for file in gradient.cl a b c d; do echo ls >"$class/Lab 0_ls_attempt_2026-11-03-10-22-33_$file"; done
list 'First Name,Last Name,Login,Grade' 'FIRST,LAST,LOGIN,'
check "one student's many files in a drop folder" exits 1 run "$class.out" --list "$class.csv" --due "2026-11-25 23:59"
check "make no system of it, and set no time" test "$(jq '[.students[].late.handed_in // empty] | length' "$class.out/gradebook.json")" -eq 0
check "they are nobody's" said "passed over 5 files, as no name says whose they are"

# One student's folders look like the exercises of a course, with the work of all.
class=$scratch/forged-course
mkdir "$class"
for login in ada gh jc; do mkdir "$class/$login" && echo $login >"$class/$login/gradient.cl"; done
for folder in "ls Lab 00" a b c; do
    for name in "Ada Lovelace_12" "Grace Hopper_13" "Joan Clarke_14"; do
        mkdir -p "$class/$folder/${name}_assignsubmission_file_"
        echo forged >"$class/$folder/${name}_assignsubmission_file_/gradient.cl"
    done
done
list 'First Name,Last Name,Login,Grade' 'FIRST,LAST,LOGIN,'
check "one student's folders that look like a course" exits 1 run "$class.out" --list "$class.csv"
for login in ada gh jc; do check "take nobody's place: $login" test "$(cat "$class.out"/students/$login-*/whose)" = $login; done
check "it is said what they look like" said "4 of its folders look like exports of several students, and 3 do not"

# A drop folder of a folder for each student, called submission_NUMBER. Eve hands in Gradescope's list, in which she is ada.
class=$scratch/submission-names
mkdir "$class"
for number in 40012 40017; do mkdir "$class/submission_$number" && echo $number >"$class/submission_$number/gradient.cl"; done
echo 40099 >"$class/submission_40099.zip"
printf 'submission_%s:\n  :submitters:\n  - :name: %s\n    :email: %s\n' 40012 "Eve Evil" eve@example.org 40099 "Ada Lovelace" ada@example.org \
    40017 "Joan Clarke" jc@example.org >"$class/submission_metadata.yml"
list 'First Name,Last Name,Student ID,Email' 'FIRST,LAST,NUMBER,LOGIN@example.org'
run "$class.out" --moodle "$class.csv"
check "a student's list of Gradescope's decides nothing" nobody 40012
check "it is told" said "submission_metadata.yml: decides nothing"

# Of two logins, one ends as the other does.
class=$scratch/logins
mkdir "$class"
for login in ada eve_ada gh; do echo $login >"$class/Lab 0_${login}_attempt_2026-11-03-10-22-33_gradient.cl"; done
list '"Last Name","First Name",Username,"Student ID"' '"LAST","FIRST",LOGIN,NUMBER'
run "$class.out" --moodle "$class.csv"
check "the login eve_ada is not ada" test "$(cat "$class.out"/students/ada-*/whose)" = ada
check "and fits nobody" said '"Lab 0_eve_ada_attempt_2026-11-03-10-22-33_gradient.cl": fits no line of the list'

# A login that is another one's name, written as one: whether the list has logins or not.
class=$scratch/login-like-a-name
mkdir "$class"
for login in lovelaceada gh; do echo $login >"$class/Lab 0_${login}_attempt_2026-11-03-10-22-33_gradient.cl"; done
for head in '"Last Name","First Name","Student ID",Section' '"Last Name","First Name","Student ID",Username'; do
    list "$head" '"LAST","FIRST",NUMBER,LOGIN'
    echo 'Evil,Eve,40099,lovelaceada' >>"$class.csv"
    run "$class.out" --moodle "$class.csv"
    check "a login that is a name written as one is doubtful" \
        said "\"lovelaceada\" may be somebody's login, or the name in line 3 of the list written as one"
    for number in 40012 40013 40099; do check "and is not $number's" nobody $number; done
    check "of whom it is not said that nothing was handed in" said " 0 without submission"
done

class=$scratch/last-of-a-login
for name in Evil_Eve_eve_ada_2 Hopper_Grace_gh_3 Clarke_Joan_jc_4; do
    mkdir -p "$class/$name" && echo "$name" >"$class/$name/20261104102233_2_gradient.cl"
done
list '"Nachname";"Vorname";"Benutzername";"Matrikelnummer"' '"LAST";"FIRST";"LOGIN";"NUMBER"'
run "$class.out" --moodle "$class.csv"
check "ILIAS: the end of a login is nobody's" nobody 40012
check "and the others have theirs" said "2 of 3 graded and entered"

# A number of one, and the name of another.
class=$scratch/number-and-name
mkdir "$class"
echo 1 >"$class/hoppergrace_40018_880018_gradient.cl"
echo 2 >"$class/shawmary_40019_880019_gradient.cl"
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
run "$class.out" --moodle "$class.csv"
check "a number that contradicts the name is entered for neither" said "is called as line 7 of the list, and has the number of line 8"
check "not for one" nobody 40017
check "nor for the other" nobody 40018

# A student's folder is no export, however its files are called.
class=$scratch/alone
mkdir -p "$class/ada"
for id in 37 38; do echo $id >"$class/ada/bobbuilder_40013_8800${id}_gradient.cl"; done
list 'Student,ID,"SIS User ID","SIS Login ID",Section,"Lab 0 (4711)"' '"LAST, FIRST",NUMBER,uNUMBER,LOGIN,A,'
run "$class.out" --moodle "$class.csv"
check "the only folder is one student's" nobody 40013
check "and what it looks like is said" said "look as if Canvas had named them; if it is the export, give this folder"

# ---- One folder too low -------------------------------------------------------------------------

class=$scratch/low
mkdir "$class"
cp solutions/$lab/*.c* "$class"
check "one student's folder is none of a class" exits 2 run "$class.out"
check "and a message says what it looks like" said "is this the folder of one student? Then give the one above it"

finish

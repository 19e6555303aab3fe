#!/bin/sh
# Whose grade it is: entries of a class under every name, beside lists of Moodle and of Gradescope. What
# fits two, or somebody not for certain, is entered for nobody.
#
#     sh tests/suites/owners.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

all_right

# ---- Who is who in Moodle's list ----------------------------------------------------------------

# lists STATUS NAME FILE ENTRY...: grade a class of such entries (with the grader above) by a list. The
# status is 1 if one of them is left to the instructor.
lists() {
    wanted_status=$1 class=$scratch/$2
    list=$3
    shift 3
    mkdir "$class"
    for entry; do
        case $entry in *.zip) : >"$class/$entry" ;; *) mkdir "$class/$entry" ;; esac
    done
    [ ! -e "$class.yml" ] || cp "$class.yml" "$class/submission_metadata.yml"
    check "by the list of ${class##*/}" exits "$wanted_status" run "$class.out" --moodle "$list"
}

# has PARTICIPANT NAME: is the entry of this name beside the participant of the list?
# "": has the participant handed in nothing? "-": is that not certain?
# shellcheck disable=SC2317 # called by check
has() {
    case $2 in
    '') words=',"",,,,"no submission"' ;;
    -) words=',"",,,,"not entered"' ;;
    *) words=",\"100.00\",\"$2\"," ;;
    esac
    grep "^\"$1\"," "$class.out/gradebook.csv" | grep -qF -- "$words" && return
    cat "$class.out/gradebook.csv"
    return 1
}

# Moodle: a number of a team is no student's; two of one name are told apart by theirs.
cat >"$scratch/numbers.csv" <<'END'
Identifier,"Full name","Email address",Status,Grade
"Participant 7","Carol Shaw",carol@example.org,Submitted,
"Participant 21","Ada Lovelace",a1@example.org,Submitted,
"Participant 22","Ada Lovelace",a2@example.org,Submitted,
"Participant 30","Sean O'Brien",sean@example.org,Submitted,
"Participant 31","Joan Clarke",joan@example.org,Submitted,
"Participant 12","Grace Hopper",grace@example.org,Submitted,
"Participant 40","Mary Shaw",Mary.Shaw@Example.org,Submitted,
"Participant 41","Jean Jennings",jean@example.org,Submitted,
END
lists 1 numbers "$scratch/numbers.csv" "Group A_7_assignsubmission_file_" \
    "Ada Lovelace_22_assignsubmission_file_" "Sean OBrien_30_assignsubmission_file" \
    "Joan Clarke_99_assignsubmission_file_" "Participant_12_assignsubmission_file_" \
    "mary.shaw@example.org" submission_41
check "a team's number is nobody's" has "Participant 7" -
check "and a message names the team" said '"Group A_7_assignsubmission_file_": fits no line of the list'
check "the last line counts everybody" said \
    "4 of 7 graded and entered; 0 without submission; 0 passed over; 0 with nothing of this lab; 3 to be decided by you"
check "of two of one name the number decides" has "Participant 22" "Ada Lovelace"
check "and the other has no grade" has "Participant 21" -
check "a name as Moodle puts it into file names" has "Participant 30" "Sean OBrien"
check "one of another number is nobody's" has "Participant 31" -
check "and a message names it" said 'line 6 of the list has another number than 99'
check "a number alone only as Participant N" has "Participant 12" "Participant"
check "an address in other letters" has "Participant 40" "mary.shaw@example.org"
check "a submission's number is nobody's" has "Participant 41" -
check "and stands below the list, with the reason" \
    grep -q '^,,,,,"submission_41",.*,"fits no line of the list"$' \
    "$class.out/gradebook.csv"

# Whoever may give any address may have chosen another's name before the @.
cat >"$scratch/addresses.csv" <<'END'
Identifier,"Full name","Email address",Status,Grade
"Participant 1","Ada Lovelace",ada@uni.example.org,Submitted,
"Participant 2","Mallory",countess@example.com,Submitted,
END
lists 1 addresses "$scratch/addresses.csv" countess
check "a name before the @ of any address is nobody's" has "Participant 2" "-"
check "and a message says whose it looks like" said '"countess": fits no line of the list, but looks like line 3'

# Teams, as Moodle gives them: a column of groups, and folders that begin with a group's name.
cat >"$scratch/teams.csv" <<'END'
Identifier,"Full name",Username,Group,Grade
"Participant 1",Ada,ada,"Team 1",
"Participant 2",Grace,grace,"Team 1",
"Participant 3",Carol,carol,"Team 1-2",
"Participant 4",Joan,joan,"Default group",
"Participant 5",Mary,mary,carol,
"Participant 6",Jean,jean,"Team_3",
END
lists 1 teams "$scratch/teams.csv" "Team 1_3_assignsubmission_file_" \
    "Team 1-2_4_assignsubmission_file_" "Default group_assignsubmission_file_" \
    "carol_9_assignsubmission_file_" "Team 3_2_assignsubmission_file_lab.zip" \
    "Team 3_2_assignsubmission_onlinetext_"
for participant in "Participant 1" "Participant 2"; do
    check "a team's points for $participant" has "$participant" "Team 1"
done
check "a group's name may end like an attempt's" has "Participant 3" "Team 1-2"
check "those without a group are one" has "Participant 4" "Default group"
check "a group that is called like a student is nobody's" has "Participant 5" -
check "and a message names it" said '"carol_9_assignsubmission_file_": is a group of the list and also fits its line 4'
check "a file and a text are one entry, an underscore is a blank" has "Participant 6" "Team 3"

# A file and a text are one entry only where Moodle says so: here somebody else chose a name.
lists 1 forged "$scratch/teams.csv" "Team 3_2_assignsubmission_file_" \
    "Team 3_2_assignsubmission_onlinetext_" "Team 3"
check "a name that is made like Moodle's takes nothing over" has "Participant 6" -
check "and a message names it" said 'line 7 of the list also fits "Team 3_2_assignsubmission_file_"'
# A student's name in Moodle may hold Moodle's pattern.
lists 1 pattern "$scratch/teams.csv" "Team 3_2_assignsubmission_file_" \
    "Team 3_2_assignsubmission_onlinetext_" "Ada_1_assignsubmission_file__9_assignsubmission_file_"
check "a name with Moodle's pattern is nobody else's" has "Participant 1" -
check "and takes nothing from the others" has "Participant 6" "Team 3"

# Teams and pairs, as Gradescope gives them.
cat >"$scratch/pairs.yml" <<'END'
---
submission_1:
  :submitters:
  - :name: Ada Lovelace
    :sid: '4711'
    :email: ada@example.org
  - :name: Grace Hopper
    :sid: '4712'
    :email: GRACE@example.org
  :created_at: 2026-11-21 10:00:00.000000000 Z
submission_2:
  :submitters:
  - :name: Ada Lovelace
    :sid: '4799'
    :email: ada2@example.org
submission_3:
  :submitters:
  - :name: Joan Clarke
    :email: j.clarke@example.com
submission_4:
  :submitters:
  - :email: mary@example.org
    :sid: '4713'
    :name: Somebody Else
submission_5:
  :submitters:
  - :name: Jean Jennings
    :email: jean@example.org
submission_6:
  :submitters:
  - :name: Jean Jennings
    :email: jean@example.org
  - :name: Carol Shaw
    :sid: '4714'
submission_7:
  :submitters:
  - :name: Team-2
    :email: team2@example.org
END
cat >"$scratch/pairs.csv" <<'END'
Identifier,"Full name","ID number","Email address",Grade
"Participant 1","Ada Lovelace",4711,ada@example.org,
"Participant 2","Grace Hopper",,grace@example.org,
"Participant 3","Joan Clarke",,joan@example.org,
"Participant 4","Mary Shaw",4713,m.shaw@example.org,
"Participant 5","Jean Jennings",,jean@example.org,
"Participant 6","Carol Shaw",4714,,
"Participant 8","Team",,team@example.org,
END
lists 1 pairs "$scratch/pairs.csv" submission_1 submission_2 submission_3 submission_4 \
    submission_5 submission_6 submission_7
for participant in "Participant 1" "Participant 2"; do
    check "a pair's points for $participant" has "$participant" "Ada Lovelace & Grace Hopper"
done
check "a name alone is not enough against an address" has "Participant 3" -
check "and a message names it" \
    said '"submission_3": "Joan Clarke": line 4 of the list has another e-mail address or number'
check "the university's number is enough" has "Participant 4" "Somebody Else"
check "who is in two teams has the points of neither" has "Participant 5" -
check "and a message names it" said 'line 6 of the list also fits "submission_6"'
check "the other of the team has them" has "Participant 6" "Jean Jennings & Carol Shaw"
check "a name that ends like an attempt's is not cut" has "Participant 8" -

# ---- Whose grade it is --------------------------------------------------------------------------

# Names that somebody chose to get another's grade, to spoil it, or to break the run.
cat >"$scratch/whose.csv" <<'END'
Identifier,"Full name","Email address",Username,Grade
"Participant 1","Carol Shaw",c.shaw@example.org,carol,
"Participant 2","Bob Ross",bob@example.org,bob,
"Participant 3","=1+1;＝2",b2@example.org,bob-2,
"Participant 4","Dora",dora@example.org,dora,
"Participant 5","Erin",erin@example.org,erin,
"Participant 6","Frank",frank@example.org,frank,
"Participant 7","Gina",gina@example.org,gina,
"Participant 8","Hanna Müller",hm@example.org,hm,
"Participant 9","Judy",judy@example.org,judy,
"Participant 10","Kay",kay@example.org,kay,
"Participant 11","Lou",lou@example.org,lou,
END
newline='
'
cyrillic=$(printf 'c\320\260rol')
decomposed=$(printf 'Hanna Mu\314\210ller')
escape=$(printf 'frank\033[2J')
widthless=$(printf 'fra\342\200\213nk')
soft_hyphen=$(printf 'k\302\255ay')
filler=$(printf 'lou\343\205\244')
full_width=$(printf '\357\274\235HYPERLINK(1)')
twin=$(printf '%0254d' 0)
# shellcheck disable=SC2016 # a name
lists 1 whose "$scratch/whose.csv" carol carol-2 "carol (3)" lab-00-carol-4 "$cyrillic" bob bob-2 \
    dora dora.zip erin lab-00-erin frank "frank " frank. "frank$newline" 'frank\x0A' "$escape" \
    "$widthless" "$soft_hyphen" "$filler" gina GINA "Hanna Müller" "$decomposed" judy "Participant 9" "${twin}a" "${twin}b" \
    gradebook.csv students roster.json lock -- --moodle -n ... '*' '$(exit)' '%s%n' '~' \
    'x;=1+1;b' "$full_width" ada-76651 ada-117211 3d submission_metadata.yml
check "the grade of carol is that of carol, not of carol-2 nor of carol (3)" row "$class.out" \
    '"Participant 1","Carol Shaw","c.shaw@example.org","carol","100.00","carol","",1,"graded"'
check "a participant called bob-2 has the grade of bob-2" has "Participant 3" bob-2
check "and bob his own" has "Participant 2" bob
for attack in carol-2 "carol (3)" lab-00-carol-4 "$cyrillic"; do
    check "$attack: no participant, and like one" \
        said "\"$attack\": fits no line of the list, but looks like line 2"
done
check "carol is listed with all that look like her" said \
    "perhaps one person, each with a row: \"carol\", \"carol (3)\", \"carol-2\", \"lab-00-carol-4\", \"$cyrillic\""
for participant in "Participant 4" "Participant 5" "Participant 7" "Participant 9"; do
    check "$participant, whose name two have handed in under: entered for neither" \
        has "$participant" -
done
check "an archive and a folder of one name are named" \
    said '"dora.zip": line 5 of the list also fits "dora"'
check "a repository and a folder, too" said '"lab-00-erin": line 6 of the list also fits "erin"'
check "other letters' size, too" said '"gina": line 8 of the list also fits "GINA"'
check "a number of the list as a name, too" \
    said '"judy": line 10 of the list also fits "Participant 9"'
check "blanks, dots and what cannot be seen make another name" has "Participant 6" frank
for attack in "frank " frank. 'frank\x0A' 'frank\x5Cx0A' 'frank\x1B[2J' 'fra\xE2\x80\x8Bnk'; do
    check "$attack: told of" said "\"$attack\": fits no line of the list"
done
check "$soft_hyphen: nobody's, told of, and shown with what is not seen" \
    said '"k\xC2\xADay": fits no line of the list, but looks like line 11'
check "and kay may have handed in, if not this" has "Participant 10" -
check "$filler: nobody's, and told of" \
    said "\"$filler\": fits no line of the list, but looks like line 12"
check "and lou may have handed in, if not this" has "Participant 11" -
check "accents that are written apart make the same name, which two have handed in under" has "Participant 8" -
check "and a message names them" said "\"$decomposed\": line 9 of the list also fits \"Hanna Müller\""
check "every entry has its row" \
    test "$(grep -c '"students/[^"]*/report.html"' "$class.out/gradebook.csv")" -eq 46
check "and its folder" test "$(find "$class.out/students" -mindepth 1 -maxdepth 1 | wc -l)" -eq 46
check "a name is no file of the driver's" test -f "$class.out/gradebook.csv"
# shellcheck disable=SC2016 # for the inner shell
check "no cell is a formula wherever it is parted" sh -c \
    '! grep -E "(^|[,;|	])[\" ]*(=|[+@]|＝|＋|－|＠)" "$1"' - "$class.out/gradebook.csv"
check "the page is well-formed" xmllint --html --noout "$class.out/class.html"
slug=$(basename "$class.out"/students/carol-????????????????)
mkdir "$class/$slug"
check "only the latest, and an entry called like the slug of carol's" \
    exits 1 run "$class.out" --moodle "$scratch/whose.csv" --only latest
check "every entry still has its row" \
    test "$(grep -c '"students/[^"]*/report.html"' "$class.out/gradebook.csv")" -eq 47
check "carol her own files" test -e "$class.out/students/$slug/key"
check "and the grade" has "Participant 1" carol

# What is neither a folder nor a file waits for nobody and leads nowhere.
class=$scratch/kinds
mkdir -p "$class/carol"
mkfifo "$class/pipe" "$class/submission_metadata.yml"
ln -s carol "$class/carol-2"
check "a pipe and a link to another's folder" exits 1 run "$class.out"
for name in pipe carol-2 submission_metadata.yml; do
    check "$name is not graded" row "$class.out" "\"$name\",\"\",1,\"not graded\","
done
check "carol is" row "$class.out" '"carol","",1,"graded",100,'

# Names in Gradescope's list are their owners' choice, too: long ones must not cost all the others.
class=$scratch/long
mkdir -p "$class/submission_1" "$class/submission_2"
wide=$(printf '%084d' 0 | sed 's/0/名/g')
cat >"$class/submission_metadata.yml" <<END
submission_1:
  :submitters:
$(for i in 1 2 3 4 5; do echo "  - :name: $i$wide"; done)
submission_2:
  :submitters:
  - :name: Ada
END
check "long names of a large team" exits 0 run "$class.out"
check "the others have their rows" row "$class.out" '"Ada",'

finish

#!/bin/sh
# The seeds of a class: what a report gives away of one tells nothing of another, and nothing that is handed
# in later meets an old one.
#
#     sh tests/suites/seeds.sh      from the top folder, after `make tests`
set -u
. tests/tap.sh
. tests/classes.sh

# One real grading, which everybody gets. Beside it every grader looks for the class's secret.
check "the results that everybody gets" exits 0 "$build/tools/grade" --build "$build" --lab 0 \
    --submission solutions/$lab --output "$scratch/right"
# shellcheck disable=SC2016 # for the other shell
stub "$scratch/right" "SCRATCH='$scratch'"'
{ cat /proc/[0-9]*/cmdline; printenv; } 2>/dev/null >>"$SCRATCH/seen"'

mkdir "$class"
for name in ada bob carol; do cp -R labs/$lab "$class/$name"; done

# seeds OUTPUT...: the seeds of all entries there.
seeds() { for of; do cut -d ' ' -f 3 "$of/keys"; done; }
# found_in FOLDER: the files that hold the secret, or half of it.
found_in() { (cd "$1" && grep -rlF -e "$(cut -c 1-32 "$drawn/secret")" \
    -e "$(cut -c 33-64 "$drawn/secret")" .); }
# are_long OUTPUT: are they of more digits than 32 bits have?
are_long() { seeds "$1" | awk 'length < 12 { exit 1 }'; }
# no_seed_in FILE...: do these show none of the seeds?
no_seed_in() { ! seeds "$drawn" | grep -aqF -f - "$@"; }
# is_new ENTRY OUTPUT: has it a seed that was not there before?
is_new() { ! grep "^$1-" "$2/keys" | cut -d ' ' -f 3 | grep -qxF -f "$scratch/seeds-before"; }

# ---- The secret ---------------------------------------------------------------------------------

drawn=$scratch/drawn
check "without SEED" exits 0 run "$drawn"
check "a secret is drawn, of 256 bits" grep -Eqx '[0-9a-f]{64}' "$drawn/secret"
check "for its owner alone" test "$(stat -c %a "$drawn/secret")" = 600
check "it is nowhere else in the folder" test "$(found_in "$drawn")" = ./secret
check "nor in a command line or the environment" test -s "$scratch/seen" -a -z "$(found_in "$scratch" | grep seen)"
check "where no seed is, either" no_seed_in "$drawn/joblog" "$scratch/seen"
check "the seeds have 64 bits" are_long "$drawn"
check "the same class once more" exits 0 run "$scratch/drawn-again"
seeds "$drawn" >"$scratch/seeds-before"
for name in ada bob carol; do check "with other seeds: $name" is_new $name "$scratch/drawn-again"; done
mkdir "$scratch/drawn-copy"
cp "$drawn/secret" "$scratch/drawn-copy"
chmod 644 "$scratch/drawn-copy/secret"
check "with the same secret" exits 0 run "$scratch/drawn-copy"
check "it has the same" cmp "$drawn/keys" "$scratch/drawn-copy/keys"
check "and a copy is closed again" test "$(stat -c %a "$scratch/drawn-copy/secret")" = 600

# ---- Rounds -------------------------------------------------------------------------------------

cp "$drawn/keys" "$scratch/keys-before"
echo "// again" >>"$class/bob/gradient.cl"
check "one hands in again" exits 0 run "$drawn"
check "on scenes of a round of its own" is_new bob "$drawn"
check "the others keep theirs" test "$(grep -cxF -f "$scratch/keys-before" "$drawn/keys")" -eq 2
for state in emptied removed; do
    seeds "$drawn" >>"$scratch/seeds-before"
    case $state in emptied) : >"$drawn/rounds" ;; *) rm "$drawn/rounds" ;; esac
    echo "// once more" >>"$class/bob/gradient.cl"
    check "the record of rounds $state" exits 0 run "$drawn"
    check "nothing new meets an old seed" is_new bob "$drawn"
done

# ---- A secret that is damaged, a number in its place, or none yet -------------------------------

echo "0123" >"$drawn/secret"
check "a secret that is cut short is refused" exits 2 run "$drawn"
check "and it is said what to do" said "without this file a new one is drawn"
rm "$drawn/secret"
mv "$drawn/rounds" "$drawn/seed"
mkdir "$drawn/rounds"
echo 3 >"$drawn/round"
check "a folder of a version with seeds of 32 bits" exits 0 run "$drawn"
check "has a secret now" grep -Eqx '[0-9a-f]{64}' "$drawn/secret"
check "and nothing of the old ones" test ! -e "$drawn/seed" -a ! -e "$drawn/round" -a -f "$drawn/rounds"

check "SEED in the place of the secret" exits 0 run "$drawn" --seed 0005
check "is one class for all who know it" test "$(cat "$drawn/secret")" = SEED=5
check "and that is said" said "all seeds of this class follow from SEED=5"
check "a seed of more than 64 bits is refused" exits 2 run "$drawn" --seed 18446744073709551616

finish

# shellcheck shell=sh disable=SC2034,SC2317 # sourced, from the top folder; used by the suites
# What other systems ask of a result: their schemas, and results.json's own.
#
#     . tests/schemas.sh

formats=junit,tap,gradescope,autolab,prairielearn,github,vpl
schemas=$PWD/tests/systems

# obeys SCHEMA FILE...: are these documents what the system's documentation asks for?
obeys() {
    schema=$schemas/$1.schema.json
    shift
    for file; do set -- "$@" -i "$file"; shift; done
    /usr/bin/python3 -W ignore -m jsonschema "$@" "$schema"
}

# obeys_vpl FILE...: are these one comment, whose lines are titles or quoted, and then a grade at most?
obeys_vpl() {
    for file; do
        awk 'function wrong() { print FILENAME ": " FNR ": " $0; exit failed = 1 }
            FNR == 1 { if ($0 != "<|--") wrong(); next }
            $0 == "--|>" { if (ended) wrong(); ended = FNR; next }
            !ended { if ($0 !~ /^[->]/) wrong(); next }
            { if (FNR != ended + 1 || $0 !~ /^Grade :=>> [0-9]+([.][0-9]+)?$/) wrong() }
            END { exit failed || !ended }' "$file" || return
    done
}

# obey_schemas FOLDER: the checks of all reports in it, NAME/results.json and beside it every format.
obey_schemas() {
    for reported in "$1"/*; do
        [ -f "$reported/autolab.txt" ] || continue
        tail -n 1 "$reported/autolab.txt" >"$reported/autolab.json"
        tail -n 2 "$reported/autolab.txt" | head -n 1 >"$reported/feedback.json"
    done
    check "the grader's own results.json" obeys ../results "$1"/*/results.json
    check "Gradescope's results.json" obeys gradescope "$1"/*/gradescope.json
    check "PrairieLearn's results.json" obeys prairielearn "$1"/*/prairielearn.json
    check "Autolab's last line" obeys autolab "$1"/*/autolab.json
    check "Autolab's feedback" obeys autolab-feedback "$1"/*/feedback.json
    check "VPL's comment and grade" obeys_vpl "$1"/*/vpl.txt
    check "JUnit XML" xmllint --noout --schema "$schemas/junit.xsd" "$1"/*/junit.xml
    large=$(find "$1" -name prairielearn.json -size +1000000c)
    [ -z "$large" ]
    ok $? "PrairieLearn's file has at most 1 MB" "$large"
}

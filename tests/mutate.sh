#!/bin/sh
# Mechanical mutants of every lab: at least 95 in 100 of those that change anything lose points.
#
#     tests/mutate.sh BUILD [LAB...]      all labs, or some: 03 05
#
# Prints for each lab the mutants that no check notices and a line of figures. See "Mechanical
# mutants" in tests/mutation/README.md. The last line is "N labs passed, N failed".
set -u
build=$1
shift
[ $# -gt 0 ] || set -- solutions/*/

passed=0
failed=0
for lab; do
    # The seed is fixed: the same mutants shall have the same fate everywhere. What hangs gets ten
    # seconds, as on a machine with other work three are too few for a right answer.
    if "$build/tools/mutate" --lab "$(basename "$lab")" --seed 1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
done
echo "mechanical mutants: $passed labs passed, $failed failed"
[ "$failed" -eq 0 ]

#!/bin/sh
# Lab @LAB@ in Moodle's VPL: an execution file of the activity, which VPL runs for each evaluation.
#
# It writes vpl_execution, whose output VPL reads. The grader is a handout of the lab that lies on the jail
# server, with .vpl/ of this bundle in it. Set these here; .vpl/limits.sh explains the first two.
#
#     COURSE    where the handout is, as students' programs see it in the jail
#     SANDBOX   none: what VPL's jail needs if no other sandbox works there; the README says what that means
COURSE=${COURSE:-/opt/lab@NN@} TIME_LIMIT=${TIME_LIMIT:-} JOBS=${JOBS:-} SANDBOX=${SANDBOX:-}
set -eu
# The activity's highest grade, as VPL writes it for scripts: behind the names of the student's files.
highest=$(sed -n 's/^export VPL_GRADEMAX=[^0-9]*\([0-9.]*\).*/\1/p' vpl_environment.sh 2>/dev/null | tail -n 1)
# quoted TEXT: for the shell that reads vpl_execution.
quoted() { printf %s "$1" | sed "s/'/'\\\\''/g; 1s/^/'/; \$s/\$/'/"; }
{
    echo '#!/bin/sh'
    for name in COURSE TIME_LIMIT JOBS SANDBOX; do
        eval "value=\$$name"
        # shellcheck disable=SC2154 # set above
        echo "export $name=$(quoted "$value")"
    done
    echo "export VPL_GRADEMAX=$(quoted "$highest")"
    # shellcheck disable=SC2016 # for the shell that reads it
    echo 'exec "$COURSE/.vpl/grade.sh" "$PWD"'
} >vpl_execution
chmod +x vpl_execution

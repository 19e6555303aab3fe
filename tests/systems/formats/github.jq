# The points for GitHub Classroom, as its own reporter prints them: two workflow commands, which
# become annotations of the run.
# https://github.com/classroom-resources/autograding-grading-reporter
#
# Only numbers stand in them. The workflow must print nothing of a student's beside them, as any
# line that begins with "::" is a command; tests/systems/github/ keeps to that. After a fault
# nothing is written, and there are no points.
if . == null then
  empty
else
  "::notice title=Autograding complete::Points \(.score)/\(.max_score)",
  "::notice title=Autograding report::" + ({ totalPoints: .score, maxPoints: .max_score } | tojson)
end

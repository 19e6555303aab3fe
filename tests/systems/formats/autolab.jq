# The last lines on stdout that Autolab reads. https://docs.autolabproject.com/lab/
#
# The last one gives points to the problems of the assessment, which are called like the tasks. The
# one before it is Autolab's formatted feedback: a stage a task, a test a check.
# https://docs.autolabproject.com/features/formatted-feedback/
# After a fault nothing is written: the bundle's Makefile then gives no points.
include "words";

def task_feedback($checks):
  .id as $task
  | $checks
  | map(select(.task == $task) | { (.title): (
      if .status == "passed" then { passed: true } else { passed: false, hint: .words } end) })
  | add;

def feedback:
  checks as $checks
  | { _presentation: "semantic", stages: [.tasks[].id] }
    + (.tasks | map({ (.id): task_feedback($checks) }) | add);

if . == null then
  empty
else
  feedback,
  { scores: (.tasks | map({ (.id): .points }) | add), scoreboard: [.score] }
end

# Gradescope's results.json. https://gradescope-autograders.readthedocs.io/en/latest/specs/
#
# Its tests are passed or failed: a check that did not run is a failed one there, and says so.
# Gradescope escapes text itself; only the pictures are HTML. After a fault nothing is written:
# without the file Gradescope tells the student that the autograder failed, and gives no points.
#
# HIDE in the environment, "after_due_date" or "after_published", hides every check and picture from
# students until then, and with them the total. What was wrong with the files, or with compiling them,
# they see at once, as `output`.
include "words";

def hiding: env.HIDE // "";

def visibility: if hiding == "" then {} else { visibility: hiding } end;

# What the program printed, and where it crashed, tells what it was asked: hidden with the checks.
def seen_stages:
  if hiding == "" then .
  else .stages |= map(if .title == "Staging" or .title == "Compiling" or .title == "Points" then .
                      elif .status == "passed" then .message = "" else .message = "what it found is hidden" end)
  end;

# The documentation names no limit; what fits PrairieLearn's is taken here, too.
def max_picture_bytes: 400000;

# "2.1": the first of the second task's checks; $i is the check's index among all.
def number($i):
  .checks[$i].task as $task
  | (.tasks | map(.id) | index($task) + 1) as $task_number
  | (.checks[:$i + 1] | map(select(.task == $task)) | length) as $place
  | "\($task_number).\($place)";

def check_tests:
  . as $result
  | checks as $checks
  | range($checks | length) as $i
  | $checks[$i]
  | {
      score: .points, max_score: .max_points,
      status: (if .status == "passed" then "passed" else "failed" end),
      name: .title, number: ($result | number($i)),
      output: .words, output_format: "text", tags: [.task]
    };

# In labs with a leaderboard, of who has a figure: a column of Gradescope's, in which the largest
# number comes first. https://gradescope-autograders.readthedocs.io/en/latest/leaderboards/
def leaderboard:
  if .leaderboard == null or hiding != "" then {}
  else { leaderboard: [.leaderboard | { name: .title, value, order: "desc" }] } end;

# Tests without points that show a picture each.
def picture_tests:
  $pictures[0] // []
  | fitting(max_picture_bytes)[]
  | {
      name: .label,
      output: @html "<img alt=\"\(.label)\" src=\"\(.url)\">", output_format: "html"
    };

if . == null then
  empty
else
  {
    score, execution_time: (.seconds | round), output: (seen_stages | stages_words), output_format: "text",
    tests: [(check_tests, picture_tests) + visibility],
    extra_data: { lab, seed, device }
  } + leaderboard
end

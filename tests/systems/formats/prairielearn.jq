# PrairieLearn's results.json. https://prairielearn.readthedocs.io/en/latest/externalGrading/
#
# A submission that could not be judged at all, as a file is missing or nothing compiles, is "not
# gradable": PrairieLearn then shows why and takes no attempt. So is, for another reason, a fault.
# The points of a test are the check's; the score is their share, from 0 to 1.
include "words";

# "This file should be limited to 1 MB", in the documentation's words; a MB in its smaller sense.
def max_file_bytes: 1000000;

def not_gradable($why): { gradable: false, format_errors: [$why] };

# The stage that kept the submission from running; null where there is none.
def kept_from_running:
  first((.stages[] | select(.status == "failed")), null)
  | if .title == "Running" then null else . end;

def document:
  . as $result
  | {
      gradable: true,
      score: (if .max_score > 0 then .score / .max_score else 0 end),
      message: points_words, output: stages_words,
      tests: (checks | map(.task as $task | {
        name: .title,
        description: first(($result.tasks[] | select(.id == $task) | .title), $task),
        points, max_points, message: .words
      }))
    };

if . == null then
  not_gradable(fault)
elif kept_from_running != null and all(.checks[]; .status == "not-run") then
  # No answer could be tried alone either.
  not_gradable(kept_from_running.message)
else
  document
  | (. + { images: [] } | tojson + "\n" | utf8bytelength) as $n_bytes
  | . + { images: ($pictures[0] // [] | fitting(max_file_bytes - $n_bytes)) }
end

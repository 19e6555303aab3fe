# What the filters of the formats have in common: a result in words. Each function takes the whole
# of results.json (its schema is tests/results.schema.json), where nothing else is said.
#
# A filter's input is results.json, or null after a fault of the machinery. $lab is the lab's name;
# $pictures[0] is pictures.json, where there is one. All their text is valid UTF-8 without control
# characters. What has a meaning in a format, as < in XML, its filter escapes.

# What a person reads in place of a result; the fault itself is on stderr.
def fault: "The grader could not work. This is no grade; its log says why.";

def points_words: "\(.score) of \(.max_score) points";

# A list of texts, each below the other. Those that are empty are left out.
def lines: map(select(. != "")) | join("\n");

# How the submission as a whole went: each stage that failed or has something to say.
def stages_words:
  [ .stages[]
    | select(.status != "passed" or .message != "")
    | (if .status == "passed" then "\(.title):" else "\(.title): \(.status)" end), .message
  ] | lines;

# The checks, each with its `words`: its message, and its hint below. `found` is for the instructor alone.
def checks:
  .checks
  | map(. + { words: ([
      (if .status == "not-run" then "Not run: something before it failed." else "" end),
      .message,
      (if (.hint // "") == "" then "" else "Hint: \(.hint)" end)
    ] | lines) });

# Stages and checks alike as tests: {group, title, status, message, words}.
def tests:
  .lab as $lab
  | (.stages[] | { group: $lab, title, status, message, words: .message }),
    (checks[] | { group: .task, title, status, message, words });

# Of a list of pictures those that fit: the list that is left, written down, has at most $max_bytes.
def fitting($max_bytes):
  reduce .[] as $picture ({ left: $max_bytes, list: [] };
    ($picture | tojson + "," | utf8bytelength) as $n_bytes
    | if $n_bytes > .left then . else .left -= $n_bytes | .list += [$picture] end)
  | .list;

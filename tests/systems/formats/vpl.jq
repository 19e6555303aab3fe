# What Moodle's VPL reads on stdout: comments for the student, and the grade.
# https://github.com/jcrodriguez-dis/moodle-mod_vpl, vpl_submission.class.php
#
# VPL takes the last line of all that begins with "Grade :=>>" for the grade, in a comment or not, and
# ends a comment at a line "--|>". So every line of a text begins with ">", which VPL shows as it is
# written; titles begin with "-". The grade is a part of the activity's highest one, which VPL gives in
# VPL_GRADEMAX. After a fault there is none.
include "words";

# Every line, whatever a reader takes for its end.
def quoted:
  if . == "" then empty
  else gsub("[\u0085\u2028\u2029\r\u000b\f]"; " ") | split("\n")[] | ">" + . end;

# VPL takes "(-2)" at the end of a title for points to take off.
def titled: "-" + (gsub("[\r\n]"; " ") | sub("\\)\\s*$"; ") "; "") | sub("\\s+$"; ""));

def highest: (env.VPL_GRADEMAX // "" | tonumber? // 100) | if . > 0 then . else 100 end;

def grade:
  (if .max_score > 0 then .score / .max_score else 0 end) * highest * 100 | round / 100;

"<|--",
if . == null then
  ("No grade" | titled), (fault | quoted)
else
  (points_words | titled),
  (stages_words | quoted),
  (checks[]
    | ("\(.task): \(.title): \(.status | sub("-"; " ")), \(.points) of \(.max_points)" | titled), (.words | quoted))
end,
"--|>",
if . == null then empty else "Grade :=>> \(grade)" end

# May this submission be graded, or were there too many before it? Gradescope's submission_metadata.json.
# https://gradescope-autograders.readthedocs.io/en/latest/submission_metadata/
#
#     jq --argjson most 5 --arg window day -f throttle.jq submission_metadata.json
#
# A submission that has no result yet counts for ten minutes, so that many at once are no way around it. Only a
# result with tests is given again.
#
# Writes nothing if it may be graded; else the last earlier result, with a message, so that no points are
# lost. Times count from when this one was handed in: graded again, it is decided alike. Submissions that
# were not graded, by this limit or by a fault, do not count. What is odd in the file does not count either.

# Seconds of "2018-07-01T14:22:32.365935-07:00", and of what stands behind the time; null if it is none.
def seconds: try (.[0:19] + "Z" | fromdateiso8601) catch null;
def offset:
  (capture("(?<sign>[+-])(?<h>[0-9]{2}):?(?<m>[0-9]{2})$") // { sign: "+", h: "0", m: "0" })
  | ((.h | tonumber) * 3600 + (.m | tonumber) * 60) * (if .sign == "-" then -1 else 1 end);
def moment:
  if type != "string" then null
  else seconds as $local | if $local == null then null else $local - offset end end;

def length_of_window: { hour: 3600, day: 86400, week: 604800 }[$window];

def has_failed: .autograder_error // false;
# Of $now: it may still be graded.
def is_in_flight($now): type == "object" and (has_failed | not) and ((.results | type) != "object") and .at > $now - 600;
def has_tests: (.results.tests | type) == "array" and (.results.tests | length) > 0;

def was_graded:
  type == "object" and (.autograder_error // false | not) and (.results | type == "object")
  and (.results.extra_data | if type == "object" then (.throttled // false | not) else true end);

def allowed: "\($most) \(if $most == 1 then "submission" else "submissions" end) each \($window)";

# In the time zone of the submission.
def written($at): ($at + (.created_at | offset) | todateiso8601 | .[0:16] | sub("T"; " "));

(.created_at | moment) as $now
| ([.previous_submissions | if type == "array" then .[] else empty end | select(type == "object")
    | . + { at: (.submission_time | moment) } | select(.at != null and .at <= ($now // 0))
    | select((was_graded and has_tests) or is_in_flight($now // 0))] | sort_by(.at)) as $earlier
| ($earlier | map(select(.at > ($now // 0) - length_of_window))) as $recent
| if $now == null or ($recent | length) < $most then empty
  else
    ($earlier | map(select(has_tests)) | last) as $last
    | if $last == null then empty else . end
    | ($recent[($recent | length) - $most].at + length_of_window) as $again
    | ("This submission was not graded: at most \(allowed) are. The next one is graded from "
        + "\(written($again)) on. Your points, and what you see below, are those of "
        + "\(written($last.at)).") as $why
    | $last.results
    | { score: (.score // $last.score), tests, leaderboard, visibility }
    + { output: ([$why, (.output // "" | if type == "string" and . != "" then . else empty end)] | join("\n\n")),
        output_format: "text", extra_data: { throttled: true } }
    | with_entries(select(.value != null))
    # A result without points would be none: then it is better graded.
    | . + { tests: (.tests // []) }
    | if (.score | type) == "number" and (.tests | type) == "array" then . else empty end
  end

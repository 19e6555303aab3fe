# The Test Anything Protocol, version 13: a test a stage and a check. A fault bails out.
# https://testanything.org/tap-version-13-specification
#
# Messages are comments, which every reader of TAP shows or drops, and none takes for a test: each
# of their lines begins with "# ". What did not run is a skipped test, as in JUnit XML.
include "words";

# A description is one line in which "#" does not begin a directive.
def description: split("\\") | join("\\\\") | split("#") | join("\\#");

def comment: if . == "" then empty else "# " + split("\n")[] end;

def test_lines($number):
  (if .status == "failed" then "not ok" else "ok" end)
    + " \($number) - \(.group | description): \(.title | description)"
    + (if .status == "not-run" then " # SKIP not run" else "" end),
  (.words | comment);

"TAP version 13",
if . == null then
  "Bail out! \($lab | description): \(fault)"
else
  [tests] as $tests
  | "1..\($tests | length)",
    (range($tests | length) as $i | $tests[$i] | test_lines($i + 1)),
    (points_words | comment)
end

# JUnit XML: a test case a stage and a check. After a fault there is one, with an <error>.
#
# The format has no standard; this keeps to what the readers of Jenkins, GitLab and GitHub share
# (tests/systems/junit.xsd). What did not run is skipped, and the stage that kept it from running
# has failed, so that no reader takes the whole for good. @html escapes what is put into the string
# after it, for text and for attributes.
include "words";

# "4.250": readers know no other form.
def three_decimals:
  (. * 1000 | round) as $thousandths
  | "\($thousandths / 1000 | floor)." + ("00\($thousandths % 1000)" | .[-3:]);

# What stands in an attribute has no ends of lines; the whole is the element's text.
def first_line: split("\n")[0] // "";

def test_case:
  @html "    <testcase classname=\"\(.group)\" name=\"\(.title)\"" as $begin
  | { failed: "failure", "not-run": "skipped", error: "error" }[.status] as $element
  | if $element != null then
      "\($begin)>",
      @html "      <\($element) message=\"\(.message | first_line)\">\(.words)</\($element)>",
      "    </testcase>"
    elif .words != "" then
      # A remark on what went well: the stage that tells what stands out has one.
      "\($begin)>", @html "      <system-out>\(.words)</system-out>", "    </testcase>"
    else
      "\($begin)/>"
    end;

def property($name; $value): @html "      <property name=\"\($name)\" value=\"\($value)\"/>";

def properties:
  "    <properties>",
  property("score"; points_words), property("seed"; .seed),
  property("device"; .device), property("submission"; .submission),
  "    </properties>";

# The whole document, of a list of tests.
#   $properties  a list of lines
def document($lab; $seconds; $properties):
  def n($status): map(select(.status == $status)) | length;
  @html "name=\"\($lab)\" tests=\"\(length)\" failures=\"\(n("failed"))\" errors=\"\(n("error"))\""
    as $totals
  | ($seconds | three_decimals) as $time
  | "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
    # Here Jenkins' xUnit plugin knows no "skipped", and refuses the file.
    "<testsuites \($totals) time=\"\($time)\">",
    "  <testsuite \($totals) skipped=\"\(n("not-run"))\" time=\"\($time)\">",
    $properties[],
    (.[] | test_case),
    "  </testsuite>",
    "</testsuites>";

# Some readers know a case by its name alone: of two with one title each gets its task behind it.
def named:
  (group_by(.title) | map(select(length > 1)[0].title)) as $twice
  | map(if .title | IN($twice[]) then .title += " (\(.group))" else . end);

if . == null then
  [{ group: $lab, title: "grader", status: "error", message: fault, words: "" }]
  | document($lab; 0; [])
else
  . as $result
  | [tests] | named | document($result.lab; $result.seconds; [$result | properties])
end

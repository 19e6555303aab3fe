// mutation/edits: what edits make of a text, and which ones are refused.
#include "edits.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

TestSuite(edits);

static const char TEXT[] = "a\n"
                           "    b\n"
                           "}\n"
                           "c\n"
                           "}\n";

static void expect_text(const char *edits, const char *expected)
{
    char *why;
    int line;
    char *found = edits_apply(TEXT, edits, &why, &line);
    cr_expect_null(why, "%s: %s", edits, why);
    cr_expect_str_eq(found, expected);
    free(found);
    free(why);
}

// Are the edits refused, with these words and this line, from 0?
static void expect_refused(const char *edits, const char *words, int expected_line)
{
    char *why;
    int line;
    cr_expect_null(edits_apply(TEXT, edits, &why, &line));
    cr_assert_not_null(why);
    cr_expect_not_null(strstr(why, words), "found \"%s\", expected \"%s\"", why, words);
    cr_expect_eq(line, expected_line, "%s: found line %d, expected %d", edits, line, expected_line);
    free(why);
}

Test(edits, a_line_becomes_another)
{
    expect_text("-    b\n+    d\n", "a\n    d\n}\nc\n}\n");
    expect_text("-a\n+d", "d\n    b\n}\nc\n}\n");
}

Test(edits, lines_go_and_come)
{
    expect_text("-    b\n-}\n", "a\nc\n}\n");
    expect_text(" c\n+d\n+\n", "a\n    b\n}\nc\nd\n\n}\n");
    expect_text("+d\n a\n", "d\na\n    b\n}\nc\n}\n");
}

Test(edits, a_line_around_says_which)
{
    expect_text(" c\n-}\n+)\n", "a\n    b\n}\nc\n)\n");
}

Test(edits, an_empty_line_is_between_two)
{
    expect_text("-a\n+d\n\n-c\n", "d\n    b\n}\n}\n");
}

Test(edits, lines_to_be_added_alone_are_the_text)
{
    expect_text("+d\n+\n+e\n", "d\n\ne\n");
}

Test(edits, what_does_not_fit_is_refused)
{
    expect_refused("-d\n+e\n", "does not fit", 0);
    expect_refused("-b\n+e\n", "does not fit", 0);  // only the end of a line
    expect_refused("-a\n+d\n\n\n-a\n-c\n", "does not fit", 4);
}

Test(edits, what_fits_twice_is_refused)
{
    expect_refused("-}\n+)\n", "fits in two places", 0);
}

Test(edits, what_changes_nothing_is_refused)
{
    expect_refused("", "nothing differs", 0);
    expect_refused("\n\n", "nothing differs", 2);
    expect_refused(" a\n", "changes nothing", 0);
    expect_refused("-a\n+a\n", "changes nothing", 0);
    expect_refused("+a\n+    b\n+}\n+c\n+}\n", "is the solution's", 0);
}

Test(edits, what_belongs_nowhere_is_refused)
{
    expect_refused("-a\n+d\n\n+e\n", "where does it belong", 3);
    expect_refused("+e\n\n-a\n", "where does it belong", 0);
}

Test(edits, two_in_the_wrong_order_are_refused)
{
    expect_refused("-c\n+d\n\n-a\n+d\n", "before the one above", 3);
    expect_refused("-a\n     b\n\n     b\n-}\n", "before the one above", 3);
}

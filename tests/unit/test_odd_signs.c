// grader/stands_out_unseen: characters that nobody sees are named with line and code point.
#include "stands_out.h"

#include <criterion/criterion.h>
#include <stdlib.h>

static void expect_notes(const char *text, int n_expected, const char *expected)
{
    char *said = NULL;
    size_t n_bytes;
    FILE *notes = open_memstream(&said, &n_bytes);
    cr_expect_eq(stands_out_unseen("a.cl", text, notes), n_expected, "%s", text);
    fclose(notes);
    cr_expect_str_eq(said, expected);
    free(said);
}

Test(odd_signs, names_each_with_its_line)
{
    expect_notes("int a;\nint\xC2\xA0"
                 "b;\nint c\xCD\xBE\n",
                 2,
                 "a.cl:2: a no-break space, U+00A0, which looks like something else: type a space "
                 "there\n"
                 "a.cl:3: a Greek question mark, U+037E, which looks like something else: type a "
                 "semicolon there\n");
    expect_notes("a\xE2\x80\x8B"
                 "b\xE2\x80\xA8"
                 "c\xEF\xBB\xBF",
                 3,
                 "a.cl:1: a zero-width space, U+200B, which looks like something else: delete it\n"
                 "a.cl:1: a line separator, U+2028, which looks like something else: begin a new "
                 "line there\n"
                 "a.cl:1: a byte order mark, U+FEFF, which looks like something else: delete it\n");
}

Test(odd_signs, says_nothing_of_what_harms_nobody)
{
    expect_notes("", 0, "");
    expect_notes("\xEF\xBB\xBFint a; // Gr\xC3\xB6\xC3\x9F\x65:\xC2\xA0x \xE2\x80\x93\n", 0, "");
    expect_notes("\xEF\xBB\xBF// first\n/* \xE2\x80\xA8 */ char *t = \"\xC2\xA0\";", 0, "");
    expect_notes("int \xC3\xA4; \xFF\xC2", 0, "");
}

Test(odd_signs, shows_a_few)
{
    char text[64] = "";
    for (int i = 0; i < 9; i++) {
        strcat(text, ";\xE2\x80\x8B");
    }
    char *said = NULL;
    size_t n_bytes;
    FILE *notes = open_memstream(&said, &n_bytes);
    cr_expect_eq(stands_out_unseen("a.cl", text, notes), 9);
    fclose(notes);
    cr_expect_not_null(strstr(said, "\na.cl: and 5 more such characters\n"), "%s", said);
    free(said);
}

// common/complain: a message is one line, whatever the names in it hold.
#include "clean_text.h"
#include "complain.h"
#include "surroundings.h"

static const char *complaint_about(const char *name)
{
    capture_begin(2);
    complain("%s: cannot be read", name);
    return capture_end(2);
}

Test(complain, names_are_shown_in_one_line)
{
    static const char *const PAIRS[][2] = {
        {"a.csv", "a.csv"},
        {"two\nlines", "two lines"},
        {"tab\there", "tab here"},
        {"\033[2Jgone", "\\x1B[2Jgone"},
        {"back\rward", "back\\x0Dward"},
        {"K\xC3\xA4se", "K\xC3\xA4se"},
        {"broken\xFF", "broken\\xFF"},
        {"turned\xE2\x80\xAE", "turned\\xE2\\x80\\xAE"},
    };
    for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
        char expected[128];
        snprintf(expected, sizeof expected, "%s: cannot be read\n", PAIRS[i][1]);
        cr_expect_str_eq(complaint_about(PAIRS[i][0]), expected);
    }
}

// A name beyond all measure, each byte of it one that grows, gives one line that still says why.
Test(complain, a_long_message_loses_its_middle)
{
    static char name[130000];
    memset(name, '\033', sizeof name - 1);
    const char *message = complaint_about(name);
    cr_expect_leq(strlen(message), 8000 * CLEAN_TEXT_GROWTH + 1);
    expect_one_message(message, " [... left out ...] ");
    const char *reason = strstr(message, ": cannot be read\n");
    cr_expect(reason != NULL && reason[strlen(": cannot be read\n")] == '\0', "no reason");
}

Test(complain, nothing_is_left_out_of_8000_bytes)
{
    static char name[8000 - sizeof ": cannot be read" + 2];
    memset(name, 'n', sizeof name - 1);
    const char *message = complaint_about(name);
    cr_expect_eq(strlen(message), 8000 + 1);
    cr_expect_eq(strspn(message, "n"), sizeof name - 1);
}

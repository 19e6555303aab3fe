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
        {"\033[2Jgone", "\xEF\xBF\xBD[2Jgone"},
        {"back\rward", "back\xEF\xBF\xBDward"},
        {"K\xC3\xA4se", "K\xC3\xA4se"},
        {"broken\xFF", "broken\xEF\xBF\xBD"},
        {"turned\xE2\x80\xAE", "turned\xEF\xBF\xBD"},
    };
    for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
        char expected[128];
        snprintf(expected, sizeof expected, "%s: cannot be read\n", PAIRS[i][1]);
        cr_expect_str_eq(complaint_about(PAIRS[i][0]), expected);
    }
}

// The longest path, each byte of it one that grows, is still one line.
Test(complain, a_long_message_is_cut_off)
{
    static char name[20000];
    memset(name, '\033', sizeof name - 1);
    const char *message = complaint_about(name);
    cr_expect_eq(strlen(message), 8000 * CLEAN_TEXT_GROWTH + 1);
    cr_expect_eq(strchr(message, '\n'), message + strlen(message) - 1);
}

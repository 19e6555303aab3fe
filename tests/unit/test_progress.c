// grader/progress: the line that says what is done, on a terminal and nowhere else.
#include "progress.h"
#include "sandbox_clock.h"
#include "surroundings.h"

#include <fcntl.h>

TestSuite(progress, .init = folder_enter, .fini = folder_leave);

// The clock stands still unless a test moves it: a busy machine cannot change what is shown.
static double now = 1000;

double seconds_now(void)
{
    return now;
}

// Make stderr a terminal. Returns its other end, which shows what is on the screen.
static int terminal_open(void)
{
    const int screen = posix_openpt(O_RDWR | O_NOCTTY);
    cr_assert_geq(screen, 0);
    cr_assert_eq(grantpt(screen), 0);
    cr_assert_eq(unlockpt(screen), 0);
    const int terminal = open(ptsname(screen), O_RDWR | O_NOCTTY);
    cr_assert_geq(terminal, 0);
    cr_assert_eq(dup2(terminal, STDERR_FILENO), STDERR_FILENO);
    return screen;
}

// Expect that exactly this was written to it since the last time. Two writes may arrive one by one:
// a mark after them says where they end.
static void expect_screen(int screen, const char *expected, const char *when)
{
    char text[128];
    size_t n = 0;
    cr_assert_eq(write(STDERR_FILENO, "|", 1), 1);
    do {
        cr_assert_lt(n, sizeof text);
        cr_assert_eq(read(screen, text + n, 1), 1);
    } while (text[n++] != '|');
    text[n - 1] = '\0';
    cr_expect_str_eq(text, expected, "%s: \"%s\", expected \"%s\"", when, text, expected);
}

Test(progress, a_line_says_what_is_done_and_for_how_long)
{
    const int screen = terminal_open();
    progress_say("checking %s alone: task %d of %d", "lit_color", 2, 3);
    now += 1.9;
    progress_show();
    expect_screen(screen, "", "not at once");
    now += 0.2;
    progress_show();
    expect_screen(screen, "\r\033[Kchecking lit_color alone: task 2 of 3, 2 s",
                  "after two seconds");
    now += 0.5;
    progress_show();
    expect_screen(screen, "", "not twice in a second");
    now += 0.5;
    progress_show();
    expect_screen(screen, "\r\033[Kchecking lit_color alone: task 2 of 3, 3 s", "in the next one");
}

Test(progress, it_is_rewritten_and_taken_away)
{
    const int screen = terminal_open();
    progress_say("compiling");
    now += 3;
    progress_show();
    expect_screen(screen, "\r\033[Kcompiling, 3 s", "the first step");
    progress_say("running your program");
    progress_show();
    expect_screen(screen, "\r\033[K\r\033[Krunning your program, 0 s", "the next step");
    progress_hide();
    expect_screen(screen, "\r\033[K", "taken away");
    progress_hide();
    expect_screen(screen, "", "once");
}

Test(progress, where_stderr_is_no_terminal_there_is_no_line)
{
    capture_begin(2);
    progress_say("compiling");
    now += 3;
    progress_show();
    progress_hide();
    cr_expect_str_eq(capture_end(2), "");
}

// grader/progress: the line that says what is done, on a terminal and nowhere else.
#include "progress.h"
#include "surroundings.h"

#include <fcntl.h>
#include <poll.h>
#include <time.h>

TestSuite(progress, .init = folder_enter, .fini = folder_leave);

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

// Read what was written to it, or "" if that is nothing.
static void screen_read(int screen, char *text, size_t n_room)
{
    struct pollfd ready = {screen, POLLIN, 0};
    const ssize_t n = poll(&ready, 1, 0) > 0 ? read(screen, text, n_room - 1) : 0;
    text[n > 0 ? n : 0] = '\0';
}

// Show it again and again until there is something to see.
static void show_until_seen(int screen, char *text, size_t n_room)
{
    const struct timespec pause = {.tv_nsec = 20 * 1000 * 1000};
    for (text[0] = '\0'; text[0] == '\0'; nanosleep(&pause, NULL)) {
        progress_show();
        screen_read(screen, text, n_room);
    }
}

Test(progress, a_line_says_what_is_done_and_for_how_long)
{
    char text[128];
    const int screen = terminal_open();
    progress_say("checking %s alone: task %d of %d", "lit_color", 2, 3);
    progress_show();
    screen_read(screen, text, sizeof text);
    cr_expect_str_eq(text, "", "not at once");
    show_until_seen(screen, text, sizeof text);
    cr_expect_str_eq(text, "\r\033[Kchecking lit_color alone: task 2 of 3, 2 s");
    progress_show();
    screen_read(screen, text, sizeof text);
    cr_expect_str_eq(text, "", "not twice in a second");
}

Test(progress, it_is_rewritten_and_taken_away)
{
    char text[128];
    const int screen = terminal_open();
    progress_say("compiling");
    show_until_seen(screen, text, sizeof text);
    progress_say("running your program");
    progress_show();
    screen_read(screen, text, sizeof text);
    cr_expect_str_eq(text, "\r\033[K\r\033[Krunning your program, 0 s");
    progress_hide();
    screen_read(screen, text, sizeof text);
    cr_expect_str_eq(text, "\r\033[K");
    progress_hide();
    screen_read(screen, text, sizeof text);
    cr_expect_str_eq(text, "", "once");
}

// Waiting for its two seconds shows nothing of it either.
Test(progress, where_stderr_is_no_terminal_there_is_no_line)
{
    const struct timespec quiet = {.tv_sec = 2, .tv_nsec = 100 * 1000 * 1000};
    capture_begin(2);
    progress_say("compiling");
    nanosleep(&quiet, NULL);
    progress_show();
    progress_hide();
    cr_expect_str_eq(capture_end(2), "");
}

// One line of the terminal (see progress.h).
#include "progress.h"

#include "sandbox_clock.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

// Who waits no longer than this needs no word.
#define QUIET_SECONDS 2.0

// To the begin of the line, and forget what is on it.
#define ERASE "\r\033[K"

static struct {
    double start, begin;  // of all, and of what is done now; 0: nothing was said yet
    int shown;            // the seconds on the screen; -1: no line is there
    char text[64];
} progress = {.shown = -1};

void progress_say(const char *format, ...)
{
    char text[sizeof progress.text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (strcmp(text, progress.text) == 0) {
        return;
    }
    progress_hide();
    strcpy(progress.text, text);
    progress.begin = seconds_now();
    progress.start = progress.start > 0 ? progress.start : progress.begin;
}

void progress_show(void)
{
    const double now = seconds_now();
    const int seconds = (int)(now - progress.begin);
    if (progress.start == 0 || now - progress.start < QUIET_SECONDS || seconds == progress.shown ||
        !isatty(STDERR_FILENO)) {
        return;
    }
    progress.shown = seconds;
    fprintf(stderr, ERASE "%s, %d s", progress.text, seconds);
    fflush(stderr);
}

void progress_hide(void)
{
    if (progress.shown >= 0) {
        fputs(ERASE, stderr);
        fflush(stderr);
        progress.shown = -1;
    }
}

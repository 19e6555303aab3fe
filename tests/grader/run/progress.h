// What the grader is doing, on one line of the terminal: "running your program, 4 s".
//
// The line is on stderr, and only if that is a terminal. It appears after two seconds, is
// written anew while something runs in a sandbox, and is gone before anything else is printed.
// Used by variant_run.c and memcheck_passes.c; what is done is said by grade.c and grading_alone.c.
#ifndef GRADER_PROGRESS_H
#define GRADER_PROGRESS_H

// Say what is done now: a short text without an end of line. The seconds are counted from when that
// was said first.
__attribute__((format(printf, 1, 2))) void progress_say(const char *format, ...);

// Show it, if it is time for that. Call it every now and then.
void progress_show(void);

// Take the line away.
void progress_hide(void);

#endif

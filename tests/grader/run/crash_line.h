// The line of a crash, from the address sanitizer's report.
//
// The report is a file that the run wrote, and the run is a student's: taken from it are a line's
// number in a file that the lab has, and which kind of fault it was, out of a table of ours. The
// line itself is read from the file that was handed in.
// Used by variant_run.c.
#ifndef GRADER_CRASH_LINE_H
#define GRADER_CRASH_LINE_H

#include "manifest.h"

// What the run's environment holds: the report goes into a file of its own, as a program may print
// what it likes; leaks are no faults here.
#define CRASH_LINE_OPTIONS                                                                         \
    "ASAN_OPTIONS=log_path=out/crash:detect_leaks=0:handle_abort=1:handle_sigfpe=1:"               \
    "handle_sigill=1:handle_sigbus=1:allocator_may_return_null=1:color=never"

// Look for a report in the folder `out`. Returns "render.c:12, task set_arguments: ..." and below
// it the line in the folder `lab`, each with its newline; free() it. NULL where nothing is found.
//   task   out; the task of the manifest between whose markers the line is, or NULL
char *crash_line_find(const char *out, const char *lab, const Manifest *manifest,
                      const char **task);

// The same of a report's text: returns the line's number, and sets *file to the manifest's file and
// *says to our words for the fault. Returns 0 where no frame of its first stack is in one of the
// lab's files.
int crash_line_read(const char *report, const Manifest *manifest, const char **file,
                    const char **says);

// What the sanitizers and others leave for us, as far as memcheck reads it, too.
//
// The beginning of a regular file; free() it. NULL where there is none, or nothing in it. Neither a
// link is followed nor a FIFO waited for.
char *report_load(const char *path);

// The same of the first such file, by name, in the folder `out` whose name begins so: it ends with
// the number of a process that nobody knows here.
char *report_find(const char *out, const char *prefix);

// The task that a line of a file belongs to, or NULL.
//   text   of the file
const char *task_of_line(const Manifest *manifest, const char *file, const char *text, int line);

#endif

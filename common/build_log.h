// The compiler's log of an OpenCL program, made readable: file, line, column, the line, a caret.
//
// Drivers differ: PoCL writes "error: file:line:column: text" and no more; others write like clang
// and draw the caret themselves. Read next: cl_build.c, which uses it.
#ifndef COMMON_BUILD_LOG_H
#define COMMON_BUILD_LOG_H

#include <stdio.h>

// Print what in a log is of use to the author of a program.
//   log          the driver's text
//   path         the program's file; lines that name no place are printed after it
//   alias        how the driver calls the program's folder, or NULL; printed as `folder`
// A line that is repeated is printed once; lines that only count errors or name the device are not.
// Returns the number of messages printed.
int build_log_print(FILE *out, const char *log, const char *path, const char *alias,
                    const char *folder);

#endif

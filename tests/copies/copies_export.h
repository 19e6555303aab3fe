// The answers of a class for other programs that look for copies: JPlag, Dolos and MOSS.
//
// One folder fits all three. Authors have numbers there, since MOSS is a service elsewhere; which
// number is whose is in a file beside that folder. Read next: copies_export.c.
#ifndef COPIES_EXPORT_H
#define COPIES_EXPORT_H

#include "alike.h"

typedef enum OtherTool { OTHER_JPLAG, OTHER_DOLOS, OTHER_MOSS } OtherTool;

// Returns 0, or -1 where no tool is called so.
int other_tool_find(const char *name, OtherTool *tool);

// Make anew OUTPUT/copies-export and OUTPUT/copies-names.csv. Returns 0, or -1 after one message on
// stderr.
int copies_export(const Alike *alike, const char *output);

// Print how the tool is called for it.
void copies_export_print(const char *output, OtherTool tool);

#endif

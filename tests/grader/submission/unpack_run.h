// Unpacking one archive in the sandbox, by the program unpack (unpack_tool.c).
#ifndef GRADER_UNPACK_RUN_H
#define GRADER_UNPACK_RUN_H

#include "workdir.h"

#include <limits.h>

// Unpack an open file into a new folder of the workdir: the files of its manifest; or all, where
// it has none, for a class's export.
//   workdir  what counts is its folder, build, sandbox and manifest
//   number    of the archive: each has a folder of its own
//   path      the archive's, whose last part names it in messages
//   folder    out: where its files are
//   message   out: as submission_stage() does; owned by the caller
// Returns 0, 1 with a message when the archive is at fault, or -1 after one message on stderr.
int archive_unpack(const Workdir *workdir, int number, const char *path, int archive,
                   char folder[PATH_MAX], char **message);

#endif

// What was handed in: a folder, or an archive that becomes one.
//
// Flow: SUBMISSION -> (unpack) -> places -> staged. Archives are read only in the sandbox. Read
// next: unpack.h, stage.h.
#ifndef GRADER_SUBMISSION_H
#define GRADER_SUBMISSION_H

#include "manifest.h"

#include <stddef.h>

// The largest archive that is looked into.
enum { SUBMISSION_MAX_MEGABYTES = 64 };

// The folder to stage from: `path` itself where it is a folder; else a new folder, into which the
// manifest's files are unpacked. A folder with nothing but one file, which is none of the
// manifest's, stands for that file: Moodle puts one around each upload.
//   path     what was handed in; links on the way are the instructor's and followed
//   build    the build folder, where tools/unpack is
//   room     an existing folder, readable by sandbox_user(); "room/unpack" is made in it
//   folder   out: where to stage from, [n_bytes]
//   message  out: NULL, or what is wrong, for the student; owned by the caller
// Returns 0; 1 with a message when the submission is at fault: no archive, a damaged, an encrypted
// or an excessive one; -1 after one message on stderr when the machinery is.
int submission_folder(const Manifest *manifest, const char *path, const char *build,
                      const char *room, char *folder, size_t n_bytes, char **message);

#endif

// Staging: taking the named files, and only those, out of a submission.
#ifndef GRADER_STAGE_H
#define GRADER_STAGE_H

#include "manifest.h"

// The largest file a student may hand in.
#define STAGE_MAX_FILE_BYTES (256 * 1024)

// Copy the manifest's files from folder `submission` to folder `destination`, which exists.
// Symbolic links, devices, folders in a file's place, files that are too large, hold NUL bytes or
// are not there are refused: nothing else of the submission is opened or followed.
//   message   out: NULL, or what is wrong, for the student, "overlaps_N_Nearer.cl: not in the
//             submission ..."; owned by the caller
// Returns 0; 1 with a message when the submission is at fault; -1 after one message on stderr when
// the machinery is (no disk space, `submission` is not a folder).
int stage_submission(const Manifest *manifest, const char *submission, const char *destination,
                     char **message);

#endif

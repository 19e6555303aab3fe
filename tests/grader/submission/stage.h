// Staging: taking the named files, and only those, out of a submission.
#ifndef GRADER_STAGE_H
#define GRADER_STAGE_H

#include "manifest.h"

// The largest file a student may hand in.
#define STAGE_MAX_FILE_BYTES (256 * 1024)

// Copy the manifest's files from folder `submission`, each from its best place there (places.h), to
// folder `destination`, which exists. Links, devices, folders in a file's place, files that are too
// large, hold NUL bytes, are not there or are in two equally good places with different content are
// refused: nothing else of the submission is opened or followed.
//   message   out: NULL, or what there is to say to the student, "overlaps_N_Nearer.cl: not in the
//             submission ...", at most a line for each file: what is wrong, or where there are
//             several, which one was taken. Owned by the caller
// Returns 0; 1 with a message when the submission is at fault, STAGE_NOTHING when not even one of
// the files is in it; -1 after one message on stderr when the machinery is at fault (no disk space,
// `submission` is not a folder).
enum { STAGE_NOTHING = 2 };
int stage_submission(const Manifest *manifest, const char *submission, const char *destination,
                     char **message);

#endif

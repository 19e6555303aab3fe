// Staging: taking the named files, and only those, out of a submission.
#ifndef GRADER_STAGE_H
#define GRADER_STAGE_H

#include "manifest.h"

// The largest file a student may hand in.
#define STAGE_MAX_FILE_BYTES (256 * 1024)

// The most folders that are staged from.
enum { STAGE_MAX_SOURCES = 9 };

// Where to stage from: what was handed in, or what was unpacked of it.
typedef struct StageSource {
    const char *folder;
    const char *archive;  // the name of the one that was unpacked there, or NULL
} StageSource;

// Copy the manifest's files from folders, each from its best place there (places.h), to folder
// `destination`, which exists. A folder that was handed in comes before archives; of archives the
// one with the newest file counts. Links, devices, folders in a file's place, files that are too
// large, are no text, are not there or are in two equally good places with different content are
// refused, and then nothing of that name is in `destination`. Nothing else of the submission is
// opened or followed.
//   sources   [n_sources], at most STAGE_MAX_SOURCES, one without an archive first
//   message   out: NULL, or what there is to say to the student, "overlaps_N_Nearer.cl: not in the
//             submission ...": what is wrong, or where there are several, which one was taken.
//             Owned by the caller
// Returns 0; 1 with a message when the submission is at fault, STAGE_NOTHING when not even one of
// the files is in it; -1 after one message on stderr when the machinery is at fault (no disk space,
// a source is not a folder).
enum { STAGE_NOTHING = 2 };
int stage_submission(const Manifest *manifest, const StageSource sources[], int n_sources,
                     const char *destination, char **message);

#endif

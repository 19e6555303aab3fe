// Staging what was handed in: a folder, or an archive that becomes one, or one of the lab's files.
//
// Archives are read only in the sandbox. Read next: unpack.h, stage.h.
#ifndef GRADER_SUBMISSION_H
#define GRADER_SUBMISSION_H

#include "stage.h"
#include "workdir.h"

// The largest archive that is looked into, and how many.
enum { SUBMISSION_MAX_MEGABYTES = 64, SUBMISSION_MAX_ARCHIVES = 8 };

// Copy the manifest's files from what was handed in to folder `destination`, as stage_submission()
// does: from `path` itself where it is a folder; else from a new folder, into which they are
// unpacked. A folder with nothing but one file, which is none of the manifest's, stands for that
// file: Moodle puts one around each upload. Where a folder lacks one of the files, or it cannot be
// used, the archives at its top are unpacked, too. A file that is called like one of the manifest's
// and is no archive is staged as if a folder held it.
//   workdir     open; folders are made in it, so only one submission for a workdir
//   path         what was handed in; links on the way are the instructor's and followed
//   destination  an existing folder
//   message      out: NULL, or what there is to say to the student: what is wrong, or which of
//                several files was taken; owned by the caller
// Returns 0; 1 with a message when the submission is at fault; STAGE_NOTHING with one when nothing
// of the lab was handed in: none of its files, or an archive that cannot be read (no archive,
// damaged, encrypted, excessive); -1 after one message on stderr when the machinery is at fault.
int submission_stage(const Workdir *workdir, const char *path, const char *destination,
                     char **message);

#endif

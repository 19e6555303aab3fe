// Staging under way: shared by stage.c, which chooses among sources, and stage_file.c, which takes
// a file from one. No others use it.
#ifndef GRADER_STAGING_H
#define GRADER_STAGING_H

#include "places.h"
#include "stage.h"

#include <stdio.h>

// One of the folders to stage from, searched.
typedef struct Source {
    int folder;  // open
    Places places[MANIFEST_MAX_FILES];
} Source;

typedef struct Staging {
    const StageSource *sources;
    Source *searched;  // [n_sources]
    int n_sources;
    unsigned unusable;  // of the file under way: a bit for each source whose file was refused
    const char *submission, *destination;  // as the instructor named them, for messages
    int from, to;                          // the two folders under way, open
    FILE *said;                            // to the student, one line each
    unsigned char *bytes;                  // [STAGE_MAX_FILE_BYTES + 1] the file under way
    unsigned char *others;                 // the same for one that may be equal to it
} Staging;

// One message on stderr. Returns -1.
int machinery_fault(const char *folder, const char *file, int fault);

// Take a file from its best place in the folder under way. Returns 0, 1 (the submission is at
// fault) or -1.
int file_stage(const Staging *staging, const char *file, const Places *places);

#endif

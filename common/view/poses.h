// Paths through a scene: poses, one a line, as --record writes and --path reads them.
//
//     # a path, 25 poses a second: from x y z, at x y z, up x y z
//     2.1 1.3 1.7 0 0 0 0 0 1
//
// Read next: poses.c.
#ifndef VIEW_POSES_H
#define VIEW_POSES_H

#include "world.h"

#include <stdio.h>

// Eleven hours of poses.
#define POSES_MAX 1000000

typedef struct Poses {
    Pose *poses;  // [n]
    int n;
    int n_allocated;
} Poses;

// Read a file. Returns 0, or -1 after one message on stderr that names the file and the line. A
// path of no pose is refused, and one of more than POSES_MAX. Release with poses_free(), which
// accepts zeroed Poses.
int poses_read(const char *path, const WorldKind *kind, Poses *poses);
void poses_free(Poses *poses);

// A path that is written while it is flown. Each pose is in the file as soon as it is written, so
// that nothing of a flight is lost however the program ends. What was in the file before is gone.
typedef struct PosesRecord {
    FILE *file;  // NULL before poses_record_open()
    const char *path;
    int64_t n;  // poses that are written
} PosesRecord;

// Begin, go on with one more pose, and end. Return 0, or -1 after one message on stderr.
int poses_record_open(const char *path, const WorldKind *kind, PosesRecord *record);
int poses_record_add(PosesRecord *record, const WorldKind *kind, const Pose *pose);
int poses_record_close(PosesRecord *record);

#endif

// Paths through a scene: poses, one a line, as --record writes and --path reads them.
//
//     # a path, 25 poses a second: from x y z, at x y z, up x y z
//     2.1 1.3 1.7 0 0 0 0 0 1
//
// Read next: poses.c.
#ifndef VIEW_POSES_H
#define VIEW_POSES_H

#include "world.h"

// An hour of poses.
#define POSES_MAX 90000

typedef struct Poses {
    Pose *poses;  // [n]
    int n;
    int n_allocated;
} Poses;

// Add one at the end; beyond POSES_MAX nothing is added. Release with poses_free(), which accepts
// zeroed Poses.
void poses_add(Poses *poses, Pose pose);
void poses_free(Poses *poses);

// Read or write a file. Return 0, or -1 after one message on stderr that names the file and the
// line. A path of no pose is refused.
int poses_read(const char *path, const WorldKind *kind, Poses *poses);
int poses_write(const char *path, const WorldKind *kind, const Poses *poses);

#endif

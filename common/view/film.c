// A film (see film.h).
//
// Called by view.c.
#include "film.h"

#include "complain.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { OWN_PATH_FRAMES = 100 };

static int frame_save(const Frame *frame, const char *folder, int number)
{
    char *path;
    if (asprintf(&path, "%s/frame-%05d.png", folder, number) < 0) {
        complain("%s: no memory", folder);
        return -1;
    }
    const int result = image_save(&frame->picture, path);
    free(path);
    return result;
}

int film_make(World *world, Frame *frame, const Poses *path, const char *folder)
{
    if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
        complain("%s: cannot be made: %s", folder, strerror(errno));
        return -1;
    }
    const int n_frames = path->n > 0 ? path->n : OWN_PATH_FRAMES;
    for (int i = 0; i < n_frames; i++) {
        world->pose = path->n > 0 ? path->poses[i] : world->kind->film_pose(world, i, n_frames);
        if (world->kind->place(world) != 0) {
            return -1;
        }
        frame_draw(frame, world);
        if (frame_save(frame, folder, i + 1) != 0) {
            return -1;
        }
    }
    return 0;
}

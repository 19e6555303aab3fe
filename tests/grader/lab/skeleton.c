// Reading skeletons and stand-ins (see skeleton.h).
#include "skeleton.h"

#include "holes.h"
#include "path.h"
#include "text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

char *skeleton_read(const Manifest *manifest, const char *file)
{
    char path[PATH_MAX];
    path_make(path, "tests/skeletons/%s/%s", manifest->lab, file);
    if (access(path, F_OK) == 0) {
        return text_file_read(path);
    }
    path_make(path, "solutions/%s/%s", manifest->lab, file);
    char *solution = text_file_read(path);
    char *skeleton = solution != NULL ? holes_cut(solution, path) : NULL;
    free(solution);
    return skeleton;
}

char *stand_in_read(const Manifest *manifest, const Task *task)
{
    char path[PATH_MAX];
    const char *ending = strrchr(task->file, '.');
    path_make(path, "tests/stand_ins/%s/%s%s", manifest->lab, task->id, ending ? ending : "");
    return access(path, F_OK) == 0 ? text_file_read(path) : NULL;
}

// The folder in which programs are started (see course_folder.h).
//
// Read next: options.c.
#include "course_folder.h"

#include "complain.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int has_folder(const char *folder, const char *name)
{
    char path[PATH_MAX];
    struct stat status;
    const int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    return length < (int)sizeof path && stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

static int is_top_folder(const char *folder)
{
    return has_folder(folder, "kernels") &&
           (has_folder(folder, "labs") || has_folder(folder, "solutions"));
}

int course_folder_check(const char *program)
{
    if (is_top_folder(".")) {
        return 0;
    }
    // It is one of those above the program, if that was not moved.
    char folder[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
    folder[length > 0 ? length : 0] = '\0';
    for (char *slash; (slash = strrchr(folder, '/')) != NULL && slash > folder;) {
        *slash = '\0';
        if (is_top_folder(folder)) {
            complain("%s: started in the wrong folder, expected the course's top folder: cd '%s'",
                     program, folder);
            return -1;
        }
    }
    complain("%s: started in the wrong folder, expected the course's top folder, which holds "
             "kernels, labs and Makefile",
             program);
    return -1;
}

// Where a file is to be written (see output_place.h).
//
// Called by options.c.
#include "output_place.h"

#include <limits.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// The folder of a path as stat() takes it, "." where the path names none.
//   folder   out; holds PATH_MAX bytes
// Returns the file's name in it, or NULL where the path is too long.
static const char *folder_of(const char *path, char *folder)
{
    const char *slash = strrchr(path, '/');
    if (slash == NULL) {
        strcpy(folder, ".");
        return path;
    }
    const size_t length = (size_t)(slash - path) + 1;
    if (length >= PATH_MAX) {
        return NULL;
    }
    memcpy(folder, path, length);
    folder[length] = '\0';
    return slash + 1;
}

const char *output_place_fault(const char *path)
{
    struct stat status;
    if (stat(path, &status) == 0 && !S_ISREG(status.st_mode)) {
        return S_ISDIR(status.st_mode) ? "a file, not a folder" : "a regular file";
    }

    char folder[PATH_MAX];
    const char *name = folder_of(path, folder);
    if (name == NULL || strlen(name) > NAME_MAX) {
        return "a shorter path";
    }
    if (stat(folder, &status) != 0 || !S_ISDIR(status.st_mode)) {
        return "a file in a folder that exists";
    }
    return access(folder, W_OK | X_OK) == 0 ? NULL : "a file in a folder that can be written";
}

int output_place_is_same(const char *left, const char *right)
{
    char left_folder[PATH_MAX], right_folder[PATH_MAX];
    const char *left_name = folder_of(left, left_folder);
    const char *right_name = folder_of(right, right_folder);
    struct stat left_status, right_status;
    return left_name != NULL && right_name != NULL && strcmp(left_name, right_name) == 0 &&
           stat(left_folder, &left_status) == 0 && stat(right_folder, &right_status) == 0 &&
           left_status.st_dev == right_status.st_dev && left_status.st_ino == right_status.st_ino;
}

// Collecting single files (see loose_files.h). Hard links where the file system has them, as
// nothing is written to either; else copies.
#include "loose_files.h"

#include "bytes_write.h"
#include "complain.h"
#include "entry_content.h"
#include "file_names.h"
#include "ilias.h"
#include "path.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int fault(const char *path, int number)
{
    complain("gradebook: %s: %s", path, strerror(number));
    return -1;
}

static int file_copy(int from, int to)
{
    char block[1 << 16];
    ssize_t n;
    while ((n = read(from, block, sizeof block)) > 0) {
        if (bytes_write(to, block, (size_t)n) != 0) {
            return -1;
        }
    }
    return n < 0 ? -1 : 0;
}

int loose_file_put(int from, const char *file, int to, const char *name)
{
    struct stat status;
    if (fstatat(from, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    if (!S_ISREG(status.st_mode) || name[0] == '\0' || strcmp(name, ".") == 0 ||
        strcmp(name, "..") == 0) {
        return 0;
    }
    unlinkat(to, name, 0);
    if (linkat(from, file, to, name, 0) == 0) {
        return 0;
    }
    const int source = openat(from, file, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    const int copy = openat(to, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    // What is too large to be graded is not copied: it may be made to fill the disk. An empty file
    // of its size is refused in the same way.
    const int is_large = status.st_size > (off_t)CONTENT_MOST_FILE_MB << 20;
    int result = source >= 0 && copy >= 0 ? 0 : -1;
    if (result == 0) {
        result = is_large ? ftruncate(copy, status.st_size) : file_copy(source, copy);
    }
    const int number = errno;
    if (source >= 0) {
        close(source);
    }
    if (copy >= 0) {
        close(copy);
    }
    errno = number;
    return result;
}

// Canvas writes "file-1.cl" for a file.cl that was handed in again: take that off.
static void number_remove(char *name)
{
    char *end = strrchr(name, '.');
    end = end != NULL ? end : name + strlen(name);
    char *digits = end;
    while (digits > name && isdigit((unsigned char)digits[-1])) {
        digits--;
    }
    if (digits < end && digits > name + 1 && digits[-1] == '-') {
        memmove(digits - 1, end, strlen(end) + 1);
    }
}

// Stud.IP parts two files of one name only by the number before it: from the second on they get one
// behind it, as other systems write it. versions.h tells them apart.
static void number_add(const Export *export, int begin, int i, char name[NAME_MAX + 1])
{
    char stem[NAME_MAX + 1];
    int n = 1;
    for (int k = begin; k < i; k++) {
        n += strcmp(export->found[k].file + export->found[k].name.file, name) == 0;
    }
    snprintf(stem, sizeof stem, "%s", name);
    const char *ending = strrchr(stem, '.');
    const int n_stem = (int)(ending != NULL ? ending - stem : (ptrdiff_t)strlen(stem));
    if (n > 1) {
        snprintf(name, NAME_MAX + 1, "%.*s (%d)%.32s", n_stem < 200 ? n_stem : 200, stem, n,
                 stem + n_stem);
    }
}

void loose_file_name(const Export *export, int begin, int end, int i, char name[NAME_MAX + 1])
{
    const Found *found = &export->found[i];
    snprintf(name, NAME_MAX + 1, "%s", found->file + found->name.file);
    if (found->name.system == SYSTEM_STUDIP) {
        number_add(export, begin, i, name);
    }
    if (found->name.system != SYSTEM_CANVAS) {
        return;
    }
    char shorter[NAME_MAX + 1];
    snprintf(shorter, sizeof shorter, "%s", name);
    number_remove(shorter);
    for (int k = begin; k < end; k++) {
        char other[NAME_MAX + 1];
        snprintf(other, sizeof other, "%s", export->found[k].file + export->found[k].name.file);
        int is_taken = strcmp(other, shorter) == 0;
        number_remove(other);
        is_taken = is_taken || strcmp(other, shorter) == 0;
        if (k != i && is_taken) {
            return;
        }
    }
    memcpy(name, shorter, sizeof shorter);
}

static int names_compare(const struct dirent **left, const struct dirent **right)
{
    return strcmp((*left)->d_name, (*right)->d_name);
}

// The lab's own name for a file that has it, or has it with a number; any other as it is. Where
// times tell which upload is the last, the number tells nothing.
static const char *plain_name(const Manifest *manifest, const char *name)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (name_match(name, manifest->files[i]) <= NAME_CHANGED) {
            return manifest->files[i];
        }
    }
    return name;
}

// The files of a folder of ILIAS's, without the times before their names: the latest of one name.
static int ilias_put(int parent, const char *file, int to, const Manifest *manifest)
{
    struct dirent **entries = NULL;
    const int from = openat(parent, file, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    const int n = from >= 0 ? scandirat(from, ".", &entries, NULL, names_compare) : -1;
    int result = n >= 0 ? 0 : -1;
    for (int i = 0; i < n; i++) {
        const size_t length = ilias_time_length(entries[i]->d_name);
        if (length > 0 && result == 0) {
            result = loose_file_put(from, entries[i]->d_name, to,
                                    plain_name(manifest, entries[i]->d_name + length));
        }
        free(entries[i]);
    }
    free(entries);
    if (from >= 0) {
        close(from);
    }
    return result;
}

int loose_files_collect(const Export *export, int begin, int end, const Manifest *manifest,
                        const char *folder)
{
    if (mkdir(folder, 0700) != 0) {
        return fault(folder, errno);
    }
    const int from = open(export->path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int to = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int result = from >= 0 && to >= 0 ? 0 : -1;
    for (int i = begin; i < end && result == 0; i++) {
        const Found *found = &export->found[i];
        char name[NAME_MAX + 1];
        if (found->name.system == SYSTEM_ILIAS) {
            result = ilias_put(from, found->file, to, manifest);
        } else {
            loose_file_name(export, begin, end, i, name);
            result = loose_file_put(from, found->file, to, name);
        }
    }
    const int number = errno;
    if (from >= 0) {
        close(from);
    }
    if (to >= 0) {
        close(to);
    }
    return result == 0 ? 0 : fault(folder, number);
}

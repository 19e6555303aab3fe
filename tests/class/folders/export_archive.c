// Unpacking an export (see export_archive.h). Read next: unpack_export.c, what is taken of it.
#include "export_archive.h"

#include "clean_text.h"
#include "complain.h"
#include "contents.h"
#include "entry_name.h"
#include "export_read.h"
#include "path.h"
#include "settings.h"
#include "unpack_run.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int is_folder(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

// The folder that is the only entry of a folder, beside what no student hands in: its name, or ""
// where there is none.
static void only_folder(const char *folder, char name[NAME_MAX + 1])
{
    char path[PATH_MAX];
    DIR *entries = opendir(folder);
    int n = 0;
    struct dirent *entry;
    name[0] = '\0';
    while (entries != NULL && n < 2 && (entry = readdir(entries)) != NULL) {
        if (!export_is_extra(entry->d_name)) {
            n++;
            snprintf(name, NAME_MAX + 1, "%s", entry->d_name);
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
    path_make(path, "%s/%s", folder, name);
    if (n != 1 || !is_folder(path)) {
        name[0] = '\0';
    }
}

// Are there two folders or archives at least in a folder, one for each student?
static int holds_several(const char *folder)
{
    char path[PATH_MAX];
    DIR *entries = opendir(folder);
    int n = 0;
    struct dirent *entry;
    while (entries != NULL && n < 2 && (entry = readdir(entries)) != NULL) {
        path_make(path, "%s/%s", folder, entry->d_name);
        // A student's own may hold ".git" and ".vscode".
        n += entry->d_name[0] != '.' && !export_is_extra(entry->d_name) &&
             (archive_stem_length(entry->d_name) > 0 || is_folder(path));
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return n == 2;
}

// Is it one student's by its name, which a system made?
static int is_of_student(const char *folder)
{
    return entry_name_read(folder, 0).system != SYSTEM_NONE ||
           entry_name_read_export(folder, 1, SYSTEM_BRIGHTSPACE).system != SYSTEM_NONE;
}

// Whoever packs a folder has that folder in the archive, which may get another name later:
// "class (1).zip".
static void wrapper_enter(const char *archive, char unpacked[PATH_MAX])
{
    char name[NAME_MAX + 1], inner[PATH_MAX];
    const char *slash = strrchr(archive, '/');
    const char *file = slash != NULL ? slash + 1 : archive;
    const size_t n_stem = (size_t)archive_stem_length(file);
    only_folder(unpacked, name);
    path_make(inner, "%s/%s", unpacked, name);
    const int is_same = n_stem == strlen(name) && strncmp(file, name, n_stem) == 0;
    if (name[0] == '\0' || (!is_same && (is_of_student(name) || !holds_several(inner)))) {
        return;
    }
    if (!is_same) {
        complain("gradebook: %s: its only folder is graded: %s", file, name);
    }
    memcpy(unpacked, inner, sizeof inner);
}

int export_archive_unpack(const char *build, const char *archive, const char *folder,
                          char unpacked[PATH_MAX])
{
    Workdir workdir = {.build = build};
    char *message = NULL;
    path_make(workdir.folder, "%s", folder);
    if (settings_find_sandbox(NULL, &workdir.sandbox) != 0 ||
        sandbox_choose(workdir.sandbox, &workdir.sandbox) != 0) {
        return -1;
    }
    const int file = open(archive, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        complain("gradebook: %s: %s", archive, strerror(errno));
        return -1;
    }
    const int outcome = archive_unpack(&workdir, 0, archive, file, unpacked, &message);
    close(file);
    if (outcome > 0) {
        char *clean = message_clean(message);
        complain("gradebook: %s", clean);
        free(clean);
    }
    free(message);
    if (outcome != 0) {
        return -1;
    }
    wrapper_enter(archive, unpacked);
    return 0;
}

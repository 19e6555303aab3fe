// Unpacking an export (see export_archive.h). Read next: unpack_export.c, what is taken of it.
#include "export_archive.h"

#include "clean_text.h"
#include "complain.h"
#include "contents.h"
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

// Is there nothing else in a folder, but for what a Mac adds?
static int holds_only(const char *folder, const char *name)
{
    DIR *entries = opendir(folder);
    int n_others = entries == NULL;
    struct dirent *entry;
    while (n_others == 0 && (entry = readdir(entries)) != NULL) {
        n_others = entry->d_name[0] != '.' && strcmp(entry->d_name, "__MACOSX") != 0 &&
                   strcmp(entry->d_name, name) != 0;
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return n_others == 0;
}

// Whoever packs a folder has that folder in the archive.
static void wrapper_enter(const char *archive, char unpacked[PATH_MAX])
{
    char stem[NAME_MAX + 1], inner[PATH_MAX];
    struct stat status;
    const char *slash = strrchr(archive, '/');
    const char *name = slash != NULL ? slash + 1 : archive;
    snprintf(stem, sizeof stem, "%.*s", archive_stem_length(name), name);
    path_make(inner, "%s/%s", unpacked, stem);
    if (stem[0] != '\0' && lstat(inner, &status) == 0 && S_ISDIR(status.st_mode) &&
        holds_only(unpacked, stem)) {
        memcpy(unpacked, inner, sizeof inner);
    }
}

int export_archive_unpack(const char *build, const char *archive, const char *folder,
                          char unpacked[PATH_MAX])
{
    Workshop workshop = {.build = build};
    char *message = NULL;
    path_make(workshop.folder, "%s", folder);
    if (settings_find_sandbox(NULL, &workshop.sandbox) != 0 ||
        sandbox_choose(workshop.sandbox, &workshop.sandbox) != 0) {
        return -1;
    }
    const int file = open(archive, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        complain("gradebook: %s: %s", archive, strerror(errno));
        return -1;
    }
    const int outcome = archive_unpack(&workshop, 0, archive, file, unpacked, &message);
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

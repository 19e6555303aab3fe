// A folder of links in the place of mounts (see sandbox_view.h).
//
// The links only save the command from knowing where things are: what it may open is said by
// Landlock and by the rights of files, and both look at where a link leads.
// Read next: sandbox_walls.c.
#include "sandbox_view.h"

#include "folder.h"
#include "limited_folder.h"
#include "path.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Is there a mount at this place, or (below) anywhere under it?
static int has_mount(const SandboxCommand *command, const char *inside, int below)
{
    size_t length = strlen(inside);
    for (int i = 0; i < command->n_mounts; i++) {
        const char *place = command->mounts[i].inside;
        if (strncmp(place, inside, length) == 0 && place[length] == (below ? '/' : '\0')) {
            return 1;
        }
    }
    return 0;
}

// A folder that may be there already, open to the run's user whatever the umask.
static int open_folder_make(const char *path)
{
    if (mkdir(path, 0755) != 0) {
        return errno == EEXIST ? 0 : -1;
    }
    return chmod(path, 0755);
}

// The folders above view/inside.
static int parents_make(const char *view, const char *inside)
{
    char path[PATH_MAX];
    path_make(path, "%s%s", view, inside);
    for (char *slash = path + strlen(view) + 1; (slash = strchr(slash, '/')) != NULL; slash++) {
        *slash = '\0';
        if (open_folder_make(path) != 0) {
            return -1;
        }
        *slash = '/';
    }
    return 0;
}

static int entry_make(const SandboxCommand *command, const char *view, const char *outside,
                      const char *inside);

// A folder whose entries are links, but for those that other mounts take the place of.
static int folder_make(const SandboxCommand *command, const char *view, const char *outside,
                       const char *inside)
{
    char path[PATH_MAX];
    path_make(path, "%s%s", view, inside);
    if (open_folder_make(path) != 0) {
        return -1;
    }
    DIR *folder = opendir(outside);
    if (folder == NULL) {
        return -1;
    }
    int result = 0;
    const struct dirent *entry;
    while (result == 0 && (entry = readdir(folder)) != NULL) {
        char entry_outside[PATH_MAX], entry_inside[PATH_MAX];
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) {
            continue;
        }
        path_make(entry_outside, "%s/%s", outside, entry->d_name);
        path_make(entry_inside, "%s/%s", inside, entry->d_name);
        if (!has_mount(command, entry_inside, 0)) {
            result = entry_make(command, view, entry_outside, entry_inside);
        }
    }
    closedir(folder);
    return result;
}

static int entry_make(const SandboxCommand *command, const char *view, const char *outside,
                      const char *inside)
{
    char path[PATH_MAX];
    if (has_mount(command, inside, 1)) {
        return folder_make(command, view, outside, inside);
    }
    path_make(path, "%s%s", view, inside);
    return symlink(outside, path);
}

int view_make(const SandboxCommand *command, uid_t user, char view[PATH_MAX])
{
    char path[PATH_MAX];
    if (temporary_folder_make(view, "sandbox") != 0) {
        return -1;
    }
    path_make(path, "%s/tmp", view);
    if (chmod(view, 0750) != 0 || mkdir(path, 0700) != 0) {
        return -1;
    }
    // The folder is the grader's, and open to the user's group; only root can hand it over.
    if (geteuid() == 0 &&
        (chown(view, 0, (gid_t)user) != 0 || chown(path, user, (gid_t)user) != 0)) {
        return -1;
    }
    if (command->total_file_mb > 0 && command->n_files > 0) {
        limited_folder_mount(path, command->total_file_mb, command->n_files);
    }
    for (int i = 0; i < command->n_mounts; i++) {
        const SandboxMount *mount = &command->mounts[i];
        if (parents_make(view, mount->inside) != 0 ||
            entry_make(command, view, mount->outside, mount->inside) != 0) {
            return -1;
        }
    }
    return 0;
}

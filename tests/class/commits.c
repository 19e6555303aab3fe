// Asking Git in the sandbox (see commits.h).
#include "commits.h"

#include "complain.h"
#include "moment.h"
#include "path.h"
#include "sandbox.h"
#include "settings.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COMMIT_SECONDS = 20, COMMIT_WALL_SECONDS = 300, COMMIT_MEMORY_MB = 1024 };

#define GIT "/usr/bin/git"

// The repository of an entrant's folder, with no link in its path but ours. Returns 0, or -1 where
// there is none.
static int repository_find(const char *folder, const Entrant *entrant, char path[PATH_MAX])
{
    char link[PATH_MAX], target[PATH_MAX];
    struct stat status;
    path_make(link, "%s/submissions/%s", folder, entrant->slug);
    if (entrant->is_link || realpath(link, target) == NULL) {
        return -1;
    }
    path_make(path, "%s/.git", target);
    return lstat(path, &status) == 0 && S_ISDIR(status.st_mode) ? 0 : -1;
}

// The time as Git says it, or "". Owned, free() it.
static char *commit_time(const char *repository)
{
    static const char *const argv[] = {
        GIT, "--git-dir=/work/repository", "log", "-1", "--format=%cI", NULL};
    // Of the settings of the machine none; the repository is another user's there.
    static const char *const environment[] = {
        "GIT_CONFIG_NOSYSTEM=1",           "GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_COUNT=1",
        "GIT_CONFIG_KEY_0=safe.directory", "GIT_CONFIG_VALUE_0=*",        NULL};
    const SandboxCommand command = {
        .kind = SANDBOX_BUBBLEWRAP,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{repository, "/work/repository", 0}},
        .n_mounts = 1,
        .time = {COMMIT_SECONDS, COMMIT_SECONDS, COMMIT_WALL_SECONDS},
        .memory_mb = COMMIT_MEMORY_MB,
        .file_mb = 1,
        .n_processes = 32,
    };
    time_t moment;
    SandboxRun *run = sandbox_start(&command);
    if (run == NULL) {
        return strdup("");
    }
    const SandboxResult result = sandbox_wait(run);
    result.output[strcspn(result.output, "\n")] = '\0';
    const int is_time = result.outcome == SANDBOX_EXITED && result.exit_status == 0 &&
                        moment_read(result.output, &moment) == 0;
    char *time = strdup(is_time ? result.output : "");
    free(result.output);
    return time;
}

int commits_take(const char *folder, Roster *roster)
{
    char path[PATH_MAX];
    SandboxKind kind = SANDBOX_ANY;
    int is_ready = -1;  // not looked at yet
    for (int i = 0; i < roster->n_entrants; i++) {
        Entrant *entrant = &roster->entrants[i];
        if (entrant->time[0] != '\0' || repository_find(folder, entrant, path) != 0) {
            continue;
        }
        if (is_ready < 0) {
            is_ready = access(GIT, X_OK) == 0 && settings_find_sandbox(NULL, &kind) == 0 &&
                       sandbox_choose(kind, &kind) == 0 && kind == SANDBOX_BUBBLEWRAP;
            if (!is_ready) {
                complain("gradebook: the times of commits stay unknown: they need git and the "
                         "sandbox bubblewrap");
            }
        }
        char *time = is_ready ? commit_time(path) : strdup("");
        if (time == NULL) {
            complain("gradebook: %s: out of memory", folder);
            return -1;
        }
        free(entrant->time);
        entrant->time = time;
    }
    return 0;
}

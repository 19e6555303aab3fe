// Asking Git in the sandbox (see roster.h).
#include "roster.h"

#include "complain.h"
#include "moment.h"
#include "path.h"
#include "sandbox.h"
#include "settings.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COMMIT_SECONDS = 5, COMMIT_WALL_SECONDS = 120, COMMIT_MEMORY_MB = 1024 };

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

// The time in the line "committer Ada <ada@example.org> 1795644300 +0100" of a commit's head. The
// name is the student's own, the last two words are not. Returns 0, or -1 where there is none.
static int committer_read(const char *commit, time_t *moment)
{
    static const char word[] = "committer ";
    for (const char *line = commit; *line != '\0' && *line != '\n';) {
        const size_t length = strcspn(line, "\n");
        if (strncmp(line, word, strlen(word)) == 0) {
            char text[1024];
            long long seconds;
            snprintf(text, sizeof text, "%.*s", (int)length, line);
            const char *end = strrchr(text, '>');
            int n = 0;
            if (end == NULL || sscanf(end + 1, " %15lld %*1[+-]%*4[0-9]%n", &seconds, &n) != 1 ||
                n == 0 || end[1 + n] != '\0') {
                return -1;
            }
            *moment = (time_t)seconds;
            return 0;
        }
        line += length + (line[length] == '\n');
    }
    return -1;
}

// The time as a text for moment_read(), or "". Owned, free() it. Git reads one object: of all that
// it can do, this starts no program.
static char *commit_time(const char *repository)
{
    static const char *const argv[] = {
        GIT, "--no-replace-objects", "--git-dir=/work/repository", "cat-file", "commit", "HEAD",
        NULL};
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
        .total_memory_mb = COMMIT_MEMORY_MB,
        .file_mb = 1,
        .total_file_mb = 1,
        .n_files = 16,
        .n_processes = 4,
    };
    time_t moment;
    char stamp[MOMENT_BYTES] = "";
    SandboxRun *run = sandbox_start(&command);
    if (run == NULL) {
        return strdup("");
    }
    const SandboxResult result = sandbox_wait(run);
    if (result.outcome == SANDBOX_EXITED && result.exit_status == 0 &&
        committer_read(result.output, &moment) == 0) {
        moment_stamp(moment, stamp);
    }
    free(result.output);
    return strdup(stamp);
}

int commits_take(const char *folder, Roster *roster)
{
    char path[PATH_MAX];
    SandboxKind kind = SANDBOX_ANY;
    int is_ready = -1;  // not looked at yet
    for (int i = 0; i < roster->n_entrants; i++) {
        Entrant *entrant = &roster->entrants[i];
        if (entrant->time_from != SYSTEM_NONE || entrant->time[0] != '\0' ||
            repository_find(folder, entrant, path) != 0) {
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
        entrant->time_from = time[0] != '\0' ? SYSTEM_GIT : SYSTEM_NONE;
    }
    return 0;
}

// The walls around one sandboxed command (see sandbox_walls.h).
//
// By bubblewrap they are its argument list (bwrap_arguments.c). By Landlock they stand here: a user
// of the run's own, rules about files, and a folder of links in the place of mounts. The filter of
// system calls belongs to both. Read next: sandbox_supervisor.c, who makes and enters them.
#include "sandbox_walls.h"

#include "bwrap_arguments.h"
#include "folder.h"
#include "landlock.h"
#include "sandbox_filter.h"
#include "sandbox_limits.h"
#include "sandbox_system.h"
#include "sandbox_view.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <grp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

// Behind Landlock, a run's user is this number plus its supervisor's process id, which no other run
// has at the same time. Neither people nor services nor containers are given numbers from here to
// 0x7fffffff (systemd's list, UIDS-GIDS.md), and process ids stay below 2^22.
#define FIRST_USER 0x70000000U

// ---- Before the supervisor -------------------------------------------------------------------

// Absolute paths, as the walls are entered in another folder.
static int mounts_resolve(SandboxCommand *command)
{
    for (int i = 0; i < command->n_mounts; i++) {
        const char *given = command->mounts[i].outside;
        command->mounts[i].outside = realpath(given, NULL);
        if (command->mounts[i].outside == NULL) {
            fprintf(stderr, "sandbox: %s: %s\n", given, strerror(errno));
            command->n_mounts = i;
            return -1;
        }
    }
    return 0;
}

int walls_prepare(const SandboxCommand *command, Walls *walls)
{
    *walls = (Walls){.command = *command, .filter = -1};
    if (mounts_resolve(&walls->command) != 0) {
        return -1;
    }
    for (const char *const *variable = command->environment; variable != NULL && *variable != NULL;
         variable++) {
        if (strchr(*variable, '=') == NULL) {
            fprintf(stderr, "sandbox: \"%s\": expected NAME=value\n", *variable);
            return -1;
        }
    }
    if (command->kind == SANDBOX_BUBBLEWRAP) {
        walls->bwrap = bwrap_arguments(&walls->command);
        if (walls->bwrap == NULL) {
            return -1;
        }
    }
    walls->filter = filter_open();
    if (walls->filter < 0) {
        fprintf(stderr, "sandbox: cannot make the filter of system calls: %s\n", strerror(errno));
        return -1;
    }
    return 0;
}

void walls_free(Walls *walls)
{
    for (int i = 0; i < walls->command.n_mounts; i++) {
        free((char *)walls->command.mounts[i].outside);
    }
    bwrap_arguments_free(walls->bwrap);
    if (walls->filter >= 0) {
        close(walls->filter);
    }
}

// ---- In the supervisor -----------------------------------------------------------------------

static uid_t user_choose(SandboxKind kind)
{
    if (kind == SANDBOX_LANDLOCK) {
        return FIRST_USER + (uid_t)getpid();
    }
    return kind == SANDBOX_BUBBLEWRAP && geteuid() == 0 ? WALLS_NOBODY : geteuid();
}

// Give the writable mounts to `user`, or take them back. Only the folders themselves: they are the
// grader's, and nobody else can have put something in their place.
static int mounts_give(const SandboxCommand *command, uid_t user)
{
    for (int i = 0; i < command->n_mounts && geteuid() == 0; i++) {
        const SandboxMount *mount = &command->mounts[i];
        if (mount->writable && lchown(mount->outside, user, (gid_t)user) != 0) {
            return -1;
        }
    }
    return 0;
}

// The command's environment. C.UTF-8: what compilers say is English, whatever the instructor's own
// language is.
static char **environment_make(const SandboxCommand *command, const char *view)
{
    enum { N_OWN = 5 };
    size_t n_given = 0;
    while (command->environment != NULL && command->environment[n_given] != NULL) {
        n_given++;
    }
    char **environment = calloc(N_OWN + n_given + 1, sizeof *environment);
    if (environment == NULL || asprintf(&environment[0], "PATH=/usr/bin:/bin") < 0 ||
        asprintf(&environment[1], "HOME=%s/tmp", view) < 0 ||
        asprintf(&environment[2], "TMPDIR=%s/tmp", view) < 0 ||
        asprintf(&environment[3], "LC_ALL=C.UTF-8") < 0 ||
        asprintf(&environment[4], "POCL_CACHE_DIR=%s/tmp/pocl-cache", view) < 0) {
        return NULL;
    }
    for (size_t i = 0; i < n_given; i++) {
        environment[N_OWN + i] = (char *)command->environment[i];
    }
    return environment;
}

int walls_make(Walls *walls, const char **step)
{
    const SandboxCommand *command = &walls->command;
    walls->user = user_choose(command->kind);
    *step = "Landlock needs a grader that runs as root";
    if (command->kind == SANDBOX_LANDLOCK && geteuid() != 0) {
        errno = EPERM;
        return -1;
    }
    *step = "cannot hand a folder over";
    if (mounts_give(command, walls->user) != 0) {
        return -1;
    }
    *step = "cannot make a folder in $TMPDIR or /tmp";
    if (command->kind != SANDBOX_BUBBLEWRAP && view_make(command, walls->user, walls->view) != 0) {
        return -1;
    }
    walls->environment = environment_make(command, walls->view);
    return walls->environment != NULL ? 0 : -1;
}

void walls_take_down(Walls *walls)
{
    mounts_give(&walls->command, geteuid());
    if (walls->view[0] != '\0') {
        folder_remove(walls->view);
    }
}

void walls_end_user(const Walls *walls)
{
    if (walls->command.kind != SANDBOX_LANDLOCK) {
        return;
    }
    // Only a process of that user's is stopped by the kernel from hitting anybody else. It kills
    // all of them in one step, so that none can fork away.
    if (fork() == 0) {
        if (setresuid(walls->user, walls->user, walls->user) == 0 && getuid() >= FIRST_USER) {
            kill(-1, SIGKILL);
        }
        _exit(0);
    }
}

// ---- In the process that becomes the command -------------------------------------------------

static int user_become(uid_t user)
{
    if (geteuid() != 0) {
        return 0;
    }
    if (setgroups(0, NULL) != 0 || setresgid((gid_t)user, (gid_t)user, (gid_t)user) != 0 ||
        setresuid(user, user, user) != 0) {
        return -1;
    }
    return 0;
}

static int list_allow(int rules, const char *const *paths, size_t n, LandlockAccess access)
{
    for (size_t i = 0; i < n; i++) {
        if (landlock_allow(rules, paths[i], access) != 0) {
            return -1;
        }
    }
    return 0;
}

static int devices_allow(int rules)
{
    static const char *const plain[] = {"/dev/null", "/dev/zero", "/dev/full", "/dev/random",
                                        "/dev/urandom"};
    int result = list_allow(rules, plain, SYSTEM_COUNT(plain), LANDLOCK_DEVICE);
    // NVIDIA's driver looks through all that is in /dev.
    if (result == 0 && has_graphics_card()) {
        result = landlock_allow(rules, "/dev", LANDLOCK_LIST);
    }
    for (size_t i = 0; result == 0 && i < SYSTEM_COUNT(system_devices); i++) {
        glob_t found = {0};
        if (glob(system_devices[i], 0, NULL, &found) == 0) {
            result = list_allow(rules, (const char *const *)found.gl_pathv, found.gl_pathc,
                                LANDLOCK_DEVICE);
        }
        globfree(&found);
    }
    return result;
}

static int mounts_allow(int rules, const SandboxCommand *command)
{
    int result = 0;
    for (int i = 0; result == 0 && i < command->n_mounts; i++) {
        const SandboxMount *mount = &command->mounts[i];
        result =
            landlock_allow(rules, mount->outside, mount->writable ? LANDLOCK_WRITE : LANDLOCK_READ);
    }
    return result;
}

// Opening files is limited to what is named here.
static int files_close(const Walls *walls)
{
    // Of /proc what describes the machine, and this process: its number stays the same when it
    // becomes the command. What the command starts has no part of /proc of its own.
    static const char *const paths[] = {"/usr",
                                        "/proc/self",
                                        "/proc/cpuinfo",
                                        "/proc/meminfo",
                                        "/proc/stat",
                                        "/proc/version",
                                        "/proc/filesystems",
                                        "/proc/devices",
                                        "/proc/driver",
                                        "/proc/sys/kernel/osrelease",
                                        "/proc/sys/vm/overcommit_memory"};
    char own[PATH_MAX + sizeof "/tmp"];
    snprintf(own, sizeof own, "%s/tmp", walls->view);
    int rules = landlock_open();
    if (rules < 0) {
        return -1;
    }
    if (list_allow(rules, paths, SYSTEM_COUNT(paths), LANDLOCK_READ) != 0 ||
        list_allow(rules, system_folders, SYSTEM_COUNT(system_folders), LANDLOCK_READ) != 0 ||
        list_allow(rules, system_settings, SYSTEM_COUNT(system_settings), LANDLOCK_READ) != 0 ||
        devices_allow(rules) != 0 || mounts_allow(rules, &walls->command) != 0 ||
        landlock_allow(rules, walls->view, LANDLOCK_READ) != 0 ||
        landlock_allow(rules, own, LANDLOCK_WRITE) != 0) {
        return -1;
    }
    return landlock_enter(rules);
}

// Behind bubblewrap, what cannot be executed is an exit code of prlimit(1); so it is here.
static _Noreturn void command_become(const Walls *walls)
{
    char *const *argv = (char *const *)walls->command.argv;
    execve(argv[0], argv, walls->environment);
    int status = errno == ENOENT ? 127 : 126;
    dprintf(STDERR_FILENO, "%s: cannot be executed: %s\n", argv[0], strerror(errno));
    _exit(status);
}

// Returns 0, or -1 with errno set.
static int landlock_walls_enter(const Walls *walls, const char **step)
{
    *step = "cannot become another user";
    // The kernel tells a user's processes of their parent's end only if they ask after the change.
    if (user_become(walls->user) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 ||
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return -1;
    }
    *step = "cannot use Landlock";
    if (files_close(walls) != 0) {
        return -1;
    }
    *step = "cannot use the filter of system calls";
    return filter_enter(WALLS_FILTER_DESCRIPTOR);
}

void walls_enter(const Walls *walls, const char **step)
{
    if (walls->bwrap != NULL) {
        *step = "cannot start bwrap";
        if (limits_set(&walls->command) == 0 && user_become(walls->user) == 0) {
            execvpe(walls->bwrap[0], walls->bwrap, walls->environment);
        }
        return;
    }
    char folder[PATH_MAX + 64];
    snprintf(folder, sizeof folder, "%s%s", walls->view, walls->command.folder);
    *step = "cannot enter its folder";
    if (chdir(folder) != 0 || fcntl(WALLS_STATUS_DESCRIPTOR, F_SETFD, FD_CLOEXEC) != 0 ||
        fcntl(WALLS_FILTER_DESCRIPTOR, F_SETFD, FD_CLOEXEC) != 0) {
        return;
    }
    if (walls->command.kind == SANDBOX_LANDLOCK && landlock_walls_enter(walls, step) != 0) {
        return;
    }
    const char started[] = "\"child-pid\": 1";
    *step = "cannot set its limits";
    if (limits_set(&walls->command) == 0 &&
        write(WALLS_STATUS_DESCRIPTOR, started, strlen(started)) > 0) {
        command_become(walls);
    }
}

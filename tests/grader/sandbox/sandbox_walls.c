// The walls around one sandboxed command (see sandbox_walls.h).
//
// By bubblewrap they are its argument list (bwrap_arguments.c). The others stand here: a user of
// the run's own, whose folders nobody else can enter, a folder of links in the place of mounts, and
// where the kernel has Landlock, rules about files (landlock.c). The filter of system calls
// belongs to all. Read next: sandbox_supervisor.c, who makes and enters them.
#include "sandbox_walls.h"

#include "bwrap_arguments.h"
#include "complain.h"
#include "folder.h"
#include "landlock.h"
#include "limited_folder.h"
#include "path.h"
#include "sandbox_filter.h"
#include "sandbox_init.h"
#include "sandbox_limits.h"
#include "sandbox_system.h"
#include "sandbox_user.h"
#include "sandbox_view.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- Before the supervisor -------------------------------------------------------------------

// Absolute paths, as the walls are entered in another folder.
static int mounts_resolve(SandboxCommand *command)
{
    for (int i = 0; i < command->n_mounts; i++) {
        const char *given = command->mounts[i].outside;
        command->mounts[i].outside = realpath(given, NULL);
        if (command->mounts[i].outside == NULL) {
            complain("sandbox: %s: %s", given, strerror(errno));
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
            complain("sandbox: \"%s\": expected NAME=value", *variable);
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
        complain("sandbox: cannot make the filter of system calls: %s", strerror(errno));
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

// Bubblewrap's namespaces need no user of the run's own. But what the kernel counts by user (memory
// of pipes, pending signals, watches) would be one count for all runs: they could use it up for
// each other, and feel that. In a container that has few users it is nobody.
static uid_t user_choose(SandboxKind kind)
{
    if (sandbox_has_own_user(kind)) {
        return user_own();
    }
    if (kind != SANDBOX_BUBBLEWRAP || geteuid() != 0) {
        return geteuid();
    }
    return user_is_known(user_own()) ? user_own() : WALLS_NOBODY;
}

// Hand a mount over. What may be written becomes its user's, and closed to everybody else: another
// run might copy an answer. What only the grader may read is opened to the user's group. Only the
// mounts themselves are changed: they are the grader's, and nobody else can have put something in
// their place.
static int mount_give(const SandboxMount *mount, mode_t mode, uid_t user)
{
    if (mount->writable) {
        return lchown(mount->outside, user, (gid_t)user) == 0 ? chmod(mount->outside, mode & 0700)
                                                              : -1;
    }
    if ((mode & S_IROTH) != 0) {
        return 0;
    }
    mode = (mode & 0700) | (mode & 0500) >> 3;
    return lchown(mount->outside, (uid_t)-1, (gid_t)user) == 0 ? chmod(mount->outside, mode) : -1;
}

// Who is not root can become nobody else, and nothing need be handed over.
static int mounts_give(Walls *walls)
{
    for (int i = 0; i < walls->command.n_mounts; i++) {
        const SandboxMount *mount = &walls->command.mounts[i];
        struct stat status;
        if (stat(mount->outside, &status) != 0) {
            return -1;
        }
        walls->modes[i] = status.st_mode & 07777;
        walls->n_given = i + 1;
        if (geteuid() == 0 && mount_give(mount, walls->modes[i], walls->user) != 0) {
            return -1;
        }
    }
    return 0;
}

// The modes are the ones from before: the run may have opened its folders to others. What was only
// to be read may be another run's own at the same time.
static void mounts_take_back(const Walls *walls)
{
    for (int i = 0; i < walls->n_given; i++) {
        const SandboxMount *mount = &walls->command.mounts[i];
        const uid_t owner = mount->writable ? geteuid() : (uid_t)-1;
        if ((mount->writable || (walls->modes[i] & S_IROTH) == 0) &&
            lchown(mount->outside, owner, getegid()) == 0) {
            chmod(mount->outside, walls->modes[i]);
        }
    }
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
    const char *vendors = visible_vendors();
    char **environment = calloc(N_OWN + n_given + 2, sizeof *environment);
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
    if (vendors != NULL &&
        asprintf(&environment[N_OWN + n_given], VENDORS_VARIABLE "=%s", vendors) < 0) {
        return NULL;
    }
    return environment;
}

int walls_make(Walls *walls, const char **step)
{
    const SandboxCommand *command = &walls->command;
    walls->user = user_choose(command->kind);
    *step = "a user of its own needs a grader that runs as root";
    if (sandbox_has_own_user(command->kind) && geteuid() != 0) {
        errno = EPERM;
        return -1;
    }
    *step = "cannot hand a folder over";
    if (mounts_give(walls) != 0) {
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
    mounts_take_back(walls);
    if (walls->view[0] != '\0') {
        char tmp[PATH_MAX];
        path_make(tmp, "%s/tmp", walls->view);
        limited_folder_unmount(tmp);
        folder_remove(walls->view);
    }
    if (sandbox_is_open(walls->command.kind)) {
        leftovers_remove(walls->user);
    }
}

void walls_end_user(const Walls *walls)
{
    if (sandbox_has_own_user(walls->command.kind)) {
        user_end(walls->user);
    }
}

// ---- In the process that becomes the command -------------------------------------------------

// Behind bubblewrap, what cannot be executed is an exit code of process 1; so it is here.
static _Noreturn void command_become(const Walls *walls)
{
    char *const *argv = (char *const *)walls->command.argv;
    execve(argv[0], argv, walls->environment);
    int status = errno == ENOENT ? 127 : 126;
    dprintf(STDERR_FILENO, "%s: cannot be executed: %s\n", argv[0], strerror(errno));
    _exit(status);
}

// Returns 0, or -1 with errno set.
static int own_user_walls_enter(const Walls *walls, const char **step)
{
    *step = "cannot become another user";
    // The kernel tells a user's processes of their parent's end only if they ask after the change.
    if (user_become(walls->user) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 ||
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return -1;
    }
    *step = "cannot use Landlock";
    if (walls->command.kind == SANDBOX_LANDLOCK && landlock_rules_enter(walls) != 0) {
        return -1;
    }
    *step = "cannot use the filter of system calls";
    return filter_enter(WALLS_FILTER_DESCRIPTOR);
}

// Put what bubblewrap's process 1 needs in its place: its program, and where to tell of the start.
static int init_arrange(void)
{
    const int program = init_open();
    return program >= 0 && dup2(program, WALLS_INIT_DESCRIPTOR) >= 0 && close(program) == 0 &&
                   dup2(WALLS_STATUS_DESCRIPTOR, WALLS_STARTED_DESCRIPTOR) >= 0
               ? 0
               : -1;
}

void walls_enter(const Walls *walls, const char **step)
{
    if (walls->bwrap != NULL) {
        *step = "cannot start bwrap";
        if (init_arrange() == 0 && limits_set(&walls->command) == 0 &&
            user_become(walls->user) == 0) {
            execvpe(walls->bwrap[0], walls->bwrap, walls->environment);
        }
        return;
    }
    char folder[PATH_MAX];
    path_make(folder, "%s%s", walls->view, walls->command.folder);
    *step = "cannot enter its folder";
    if (chdir(folder) != 0 || fcntl(WALLS_STATUS_DESCRIPTOR, F_SETFD, FD_CLOEXEC) != 0 ||
        fcntl(WALLS_FILTER_DESCRIPTOR, F_SETFD, FD_CLOEXEC) != 0) {
        return;
    }
    if (sandbox_has_own_user(walls->command.kind) && own_user_walls_enter(walls, step) != 0) {
        return;
    }
    const char started[] = "\"child-pid\": 1";
    *step = "cannot set its limits";
    if (limits_set(&walls->command) == 0 &&
        write(WALLS_STATUS_DESCRIPTOR, started, strlen(started)) > 0) {
        command_become(walls);
    }
}

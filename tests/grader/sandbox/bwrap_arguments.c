// The sandbox's walls: which parts of the host are inside, and which are not by not being named
// here.
//
// The file system inside starts empty. Whatever stands below is added to it, in this order; nothing
// of the host but the mounts asked for can be written. Read next: sandbox_supervisor.c, the limits.
#include "bwrap_arguments.h"

#include "sandbox_limits.h"
#include "sandbox_system.h"
#include "sandbox_walls.h"

#include <errno.h>
#include <glob.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Where process 1's program lies inside.
#define INIT_PATH "/sandbox-init"

typedef struct Arguments {
    char **items;  // [n_items + 1], the last one NULL
    size_t n_items;
    int fault;  // an errno, kept so that only the end has to look
} Arguments;

static void argument_add(Arguments *arguments, const char *text)
{
    char *copy = strdup(text);
    char **items = realloc(arguments->items, (arguments->n_items + 2) * sizeof *items);
    if (items != NULL) {
        arguments->items = items;
    }
    if (copy == NULL || items == NULL) {
        free(copy);
        arguments->fault = ENOMEM;
        return;
    }
    items[arguments->n_items++] = copy;
    items[arguments->n_items] = NULL;
}

static void list_add(Arguments *arguments, const char *const *list)
{
    for (; *list != NULL; list++) {
        argument_add(arguments, *list);
    }
}

#define ADD(arguments, ...) list_add(arguments, (const char *const[]){__VA_ARGS__, NULL})

// Namespaces of its own for everything: no network, no processes, no System V memory of the host.
static void isolation_add(Arguments *arguments)
{
    char status_descriptor[16], filter_descriptor[16];
    snprintf(status_descriptor, sizeof status_descriptor, "%d", WALLS_STATUS_DESCRIPTOR);
    snprintf(filter_descriptor, sizeof filter_descriptor, "%d", WALLS_FILTER_DESCRIPTOR);
    ADD(arguments, "--unshare-all", "--unshare-user");
    ADD(arguments, "--disable-userns");   // inside, nobody becomes root of a namespace of their own
    ADD(arguments, "--die-with-parent");  // killing bwrap kills everything inside
    ADD(arguments, "--new-session");      // no terminal to push keystrokes into
    ADD(arguments, "--cap-drop", "ALL", "--hostname", "sandbox");
    ADD(arguments, "--json-status-fd", status_descriptor);
    ADD(arguments, "--seccomp", filter_descriptor);
}

// /bin, /lib and so on: links into /usr on today's Debian, folders on older systems.
static void system_folder_add(Arguments *arguments, const char *folder)
{
    char target[PATH_MAX];
    struct stat status;
    if (lstat(folder, &status) != 0) {
        return;
    }
    ssize_t n = S_ISLNK(status.st_mode) ? readlink(folder, target, sizeof target - 1) : -1;
    if (n >= 0) {
        target[n] = '\0';
        ADD(arguments, "--symlink", target, folder);
    } else {
        ADD(arguments, "--ro-bind", folder, folder);
    }
}

// Programs, libraries, OpenCL's drivers.
static void system_add(Arguments *arguments)
{
    ADD(arguments, "--ro-bind", "/usr", "/usr");
    for (size_t i = 0; i < SYSTEM_COUNT(system_folders); i++) {
        system_folder_add(arguments, system_folders[i]);
    }
    for (size_t i = 0; i < SYSTEM_COUNT(system_settings); i++) {
        ADD(arguments, "--ro-bind-try", system_settings[i], system_settings[i]);
    }
}

static void devices_add(Arguments *arguments)
{
    for (size_t i = 0; i < SYSTEM_COUNT(system_devices); i++) {
        glob_t found = {0};
        if (glob(system_devices[i], 0, NULL, &found) == 0) {
            for (size_t k = 0; k < found.gl_pathc; k++) {
                ADD(arguments, "--dev-bind", found.gl_pathv[k], found.gl_pathv[k]);
            }
        }
        globfree(&found);
    }
}

// Of /proc what counts the doings of the whole machine: two runs could tell each other something by
// it. Nobody needs it but the drivers of graphics cards, of which we do not know what they read.
static void counters_hide(Arguments *arguments)
{
    static const char *const files[] = {
        "/proc/loadavg",  "/proc/stat",      "/proc/uptime",    "/proc/locks",
        "/proc/vmstat",   "/proc/zoneinfo",  "/proc/buddyinfo", "/proc/pagetypeinfo",
        "/proc/softirqs", "/proc/schedstat", "/proc/diskstats", "/proc/interrupts",
        "/proc/keys",     "/proc/key-users", "/proc/swaps",
    };
    static const char *const folders[] = {"/proc/sys", "/proc/pressure", "/proc/fs"};
    static const char *const kept[] = {"/proc/sys/kernel/osrelease",
                                       "/proc/sys/vm/overcommit_memory"};
    for (size_t i = 0; i < SYSTEM_COUNT(files); i++) {
        if (access(files[i], F_OK) == 0) {
            ADD(arguments, "--ro-bind", "/dev/null", files[i]);
        }
    }
    for (size_t i = 0; i < SYSTEM_COUNT(folders); i++) {
        if (access(folders[i], F_OK) == 0) {
            ADD(arguments, "--tmpfs", folders[i]);
        }
    }
    for (size_t i = 0; i < SYSTEM_COUNT(kept); i++) {
        ADD(arguments, "--ro-bind-try", kept[i], kept[i]);
    }
    for (size_t i = 0; i < SYSTEM_COUNT(folders); i++) {
        if (access(folders[i], F_OK) == 0) {
            ADD(arguments, "--remount-ro", folders[i]);
        }
    }
}

static void memory_folder_add(Arguments *arguments, const char *folder, int n_bytes)
{
    char size[16];
    snprintf(size, sizeof size, "%d", n_bytes);
    ADD(arguments, "--size", size, "--tmpfs", folder);
}

static void private_folders_add(Arguments *arguments)
{
    ADD(arguments, "--proc", "/proc", "--dev", "/dev");
    if (!has_graphics_card()) {
        counters_hide(arguments);
    }
    memory_folder_add(arguments, "/dev/shm", BWRAP_SHM_BYTES);
    devices_add(arguments);
    memory_folder_add(arguments, "/tmp", BWRAP_TMP_BYTES);
}

// Executed, and never read: so the kernel closes its memory to all inside from its first moment.
static void init_add(Arguments *arguments)
{
    char descriptor[16];
    snprintf(descriptor, sizeof descriptor, "%d", WALLS_INIT_DESCRIPTOR);
    ADD(arguments, "--perms", "0111", "--file", descriptor, INIT_PATH);
}

// The command, started by process 1 of our own (sandbox_init_tool.c). When it cannot be executed (a
// program made to be none), that is an exit code like any other and no fault of the sandbox.
static void command_add(Arguments *arguments, const SandboxCommand *command)
{
    char status_descriptor[16], n_processes[32];
    snprintf(status_descriptor, sizeof status_descriptor, "%d", WALLS_STARTED_DESCRIPTOR);
    snprintf(n_processes, sizeof n_processes, "%llu", limits_processes(command));
    ADD(arguments, "--as-pid-1", "--", INIT_PATH, status_descriptor, n_processes);
    list_add(arguments, command->argv);
}

char **bwrap_arguments(const SandboxCommand *command)
{
    Arguments arguments = {0};
    ADD(&arguments, "bwrap");
    isolation_add(&arguments);
    system_add(&arguments);
    private_folders_add(&arguments);
    for (int i = 0; i < command->n_mounts; i++) {
        const SandboxMount *mount = &command->mounts[i];
        ADD(&arguments, mount->writable ? "--bind" : "--ro-bind", mount->outside, mount->inside);
    }
    init_add(&arguments);
    // Only now, with every mount in its place: the folders between them live in memory, too.
    // Of /proc nothing is written: it would set how a run is scheduled, and who is ended first.
    ADD(&arguments, "--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/");
    ADD(&arguments, "--chdir", command->folder);
    command_add(&arguments, command);

    if (arguments.fault == 0) {
        return arguments.items;
    }
    fprintf(stderr, "sandbox: %s\n", strerror(arguments.fault));
    bwrap_arguments_free(arguments.items);
    return NULL;
}

void bwrap_arguments_free(char **arguments)
{
    for (char **argument = arguments; argument != NULL && *argument != NULL; argument++) {
        free(*argument);
    }
    free(arguments);
}

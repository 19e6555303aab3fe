// Which files a command behind Landlock may open (see landlock_rules.h): what is named here.
// Read next: landlock.c, the system calls.
#include "landlock_rules.h"

#include "landlock.h"
#include "path.h"
#include "sandbox_system.h"

#include <glob.h>
#include <stdio.h>

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
    // NVIDIA's driver looks through all that is in /dev, and reads of the machine what follows.
    static const char *const for_drivers[] = {"/proc/devices", "/proc/driver", "/proc/stat"};
    if (result == 0 && has_graphics_card()) {
        result = list_allow(rules, for_drivers, SYSTEM_COUNT(for_drivers), LANDLOCK_READ);
    }
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

int landlock_rules_enter(const Walls *walls)
{
    // Of /proc what PoCL and the libraries of C and of the address sanitizer read: of the machine,
    // and of this process, whose number stays the same when it becomes the command. What the
    // command starts has no part of /proc of its own. Not the whole folder of the process, in which
    // the machine's network, mounts and control groups stand, too.
    static const char *const paths[] = {"/usr",
                                        "/proc/cpuinfo",
                                        "/proc/meminfo",
                                        "/proc/version",
                                        "/proc/filesystems",
                                        "/proc/sys/kernel/osrelease",
                                        "/proc/sys/vm/overcommit_memory",
                                        "/proc/self/auxv",
                                        "/proc/self/cmdline",
                                        "/proc/self/comm",
                                        "/proc/self/environ",
                                        "/proc/self/fd",
                                        "/proc/self/limits",
                                        "/proc/self/maps",
                                        "/proc/self/smaps",
                                        "/proc/self/stat",
                                        "/proc/self/statm",
                                        "/proc/self/status"};
    char own[PATH_MAX];
    path_make(own, "%s/tmp", walls->view);
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

// The workshop's folders: what every variant's sandbox gets to see.
#include "workshop.h"

#include "folder.h"
#include "limited_folder.h"
#include "path.h"
#include "run_end.h"
#include "workshop_files.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

// Copy what matches the pattern into tree/folder; that nothing does is a fault of the machinery.
static int copy_matching(const Workshop *workshop, const char *pattern, const char *folder)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", workshop->tree, folder);
    if (make_folder(path) != 0) {
        return -1;
    }
    glob_t found;
    if (glob(pattern, GLOB_BRACE, NULL, &found) != 0) {
        fprintf(stderr, "grade: %s: not found; run make grader in the course's top folder\n",
                pattern);
        return -1;
    }
    int result = 0;
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        path_make(path, "%s/%s/%s", workshop->tree, folder, name);
        result = copy_file(found.gl_pathv[i], path);
    }
    globfree(&found);
    return result;
}

// Headers and kernels of the labs before this one; their host files are compiled already
// (copy_libraries()).
static int copy_earlier_solutions(const Workshop *workshop)
{
    glob_t found;
    int result = 0;
    if (glob("solutions/*", GLOB_ONLYDIR, NULL, &found) != 0) {
        return 0;  // a handout of the first lab has none
    }
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *folder = found.gl_pathv[i];
        char pattern[PATH_MAX];
        if (strcmp(folder + strlen("solutions/"), workshop->manifest->lab) >= 0) {
            continue;
        }
        path_make(pattern, "%s/*.{h,cl}", folder);
        result = copy_matching(workshop, pattern, folder);
    }
    globfree(&found);
    return result;
}

static int copy_libraries(const Workshop *workshop)
{
    const char *lab = workshop->manifest->lab;
    char pattern[PATH_MAX];
    path_make(pattern, "%s/probes/%s*", workshop->build, lab);
    int result = copy_matching(workshop, pattern, "lib");
    path_make(pattern, "%s/earlier/%s.a", workshop->build, lab);
    result |= copy_matching(workshop, pattern, "lib/earlier");
    path_make(pattern, "%s/no_macros.h", workshop->build);
    result |= copy_matching(workshop, pattern, "probes");
    path_make(pattern, "%s/libcommon.a", workshop->build);
    return result | copy_matching(workshop, pattern, "lib");
}

// The kernels of the lab's probe; a lab of host files alone has none.
static int copy_probe_kernels(const Workshop *workshop)
{
    char from[PATH_MAX], folder[128];
    snprintf(folder, sizeof folder, "probes/%s", workshop->manifest->lab);
    path_make(from, "tests/%s/probe.cl", folder);
    if (access(from, F_OK) != 0) {
        return 0;
    }
    path_make(from, "tests/%s/*.cl", folder);
    return copy_matching(workshop, from, folder);
}

// Empty folders that the sandbox puts others in the place of.
static int make_mount_points(const Workshop *workshop)
{
    static const char *const folders[] = {"labs", "job", "build", "out"};
    char path[PATH_MAX];
    int result = 0;
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        path_make(path, "%s/%s", workshop->tree, folders[i]);
        result |= make_folder(path);
    }
    path_make(path, "%s/labs/%s", workshop->tree, workshop->manifest->lab);
    result |= make_folder(path);
    path_make(path, "%s/job", workshop->folder);
    return result | make_folder(path);
}

// Returns 0 when nothing is left of it.
static int folder_clear(void *what)
{
    const Workshop *workshop = what;
    glob_t found;
    char pattern[PATH_MAX];
    path_make(pattern, "%s/variant-*/{build,out}", workshop->folder);
    if (glob(pattern, GLOB_BRACE, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc; i++) {
            limited_folder_unmount(found.gl_pathv[i]);
        }
        globfree(&found);
    }
    return folder_remove(workshop->folder) == 0 || errno == ENOENT ? 0 : -1;
}

int workshop_open(Workshop *workshop, const Manifest *manifest, const char *build,
                  const char *device, SandboxKind sandbox)
{
    *workshop =
        (Workshop){.build = build, .manifest = manifest, .device = device, .sandbox = sandbox};
    workshop->needs_compiler = manifest_has_host_files(manifest);
    if (temporary_folder_make(workshop->folder, "grade") != 0) {
        fprintf(stderr, "grade: no temporary folder in $TMPDIR or /tmp: %s\n", strerror(errno));
        return -1;
    }
    if (janitor_start(&workshop->janitor, folder_clear, workshop) != 0) {
        fprintf(stderr, "grade: no process can be started: %s\n", strerror(errno));
        return -1;
    }
    char path[PATH_MAX];
    path_make(workshop->tree, "%s/tree", workshop->folder);
    int result = make_folder(workshop->folder) | make_folder(workshop->tree);
    path_make(path, "%s/solutions", workshop->tree);
    result |= make_folder(path) | make_mount_points(workshop);
    if (workshop->needs_compiler) {
        result |= copy_matching(workshop, "common/*.h", "common");
    }
    result |= copy_matching(workshop, "kernels/*.h", "kernels");
    result |= copy_matching(workshop, "tests/probes/{*.h,*/jobs_*.h}", "probes");
    return result | copy_probe_kernels(workshop) | copy_earlier_solutions(workshop) |
                   copy_libraries(workshop)
               ? -1
               : 0;
}

SandboxCommand workshop_command(const Workshop *workshop, const char *const *argv,
                                const char *const *environment, SandboxTime time)
{
    return (SandboxCommand){
        .kind = workshop->sandbox,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{workshop->tree, "/work", 0}},
        .n_mounts = 1,
        .time = time,
        .memory_mb = MEMORY_MB,
        .file_mb = FILE_MB,
        .n_processes = N_PROCESSES,
        .total_memory_mb = TOTAL_MEMORY_MB,
        .total_file_mb = TOTAL_FILE_MB,
        .n_files = N_FILES,
    };
}

void workshop_close(Workshop *workshop)
{
    if (workshop->folder[0] != '\0') {
        folder_clear(workshop);
    }
    workshop->folder[0] = '\0';
    janitor_dismiss(&workshop->janitor);
}

void workshop_job_suffix(int job, char suffix[16])
{
    suffix[0] = '\0';
    if (job > 0) {
        snprintf(suffix, 16, ".%d", job);
    }
}

void workshop_job_path(const Workshop *workshop, int job, char path[PATH_MAX])
{
    char suffix[16];
    workshop_job_suffix(job, suffix);
    path_make(path, "%s/job/job%s", workshop->folder, suffix);
}

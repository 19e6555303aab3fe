// The workdir's folders: what every variant's sandbox gets to see.
#include "workdir.h"

#include "folder.h"
#include "limited_folder.h"
#include "path.h"
#include "run_end.h"
#include "workdir_files.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

// Copy what matches the pattern into tree/folder; that nothing does is a fault of the machinery.
static int copy_matching(const Workdir *workdir, const char *pattern, const char *folder)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", workdir->tree, folder);
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
        path_make(path, "%s/%s/%s", workdir->tree, folder, name);
        result = copy_file(found.gl_pathv[i], path);
    }
    globfree(&found);
    return result;
}

// Headers and kernels of the labs before this one; their host files are compiled already
// (copy_libraries()).
static int copy_earlier_solutions(const Workdir *workdir)
{
    glob_t found;
    int result = 0;
    if (glob("solutions/*", GLOB_ONLYDIR, NULL, &found) != 0) {
        return 0;  // a handout of the first lab has none
    }
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *folder = found.gl_pathv[i];
        char pattern[PATH_MAX];
        if (strcmp(folder + strlen("solutions/"), workdir->manifest->lab) >= 0) {
            continue;
        }
        path_make(pattern, "%s/*.{h,cl}", folder);
        result = copy_matching(workdir, pattern, folder);
    }
    globfree(&found);
    return result;
}

static int copy_libraries(const Workdir *workdir)
{
    const char *lab = workdir->manifest->lab;
    char pattern[PATH_MAX];
    path_make(pattern, "%s/probes/%s*", workdir->build, lab);
    int result = copy_matching(workdir, pattern, "lib");
    path_make(pattern, "%s/earlier/%s.a", workdir->build, lab);
    result |= copy_matching(workdir, pattern, "lib/earlier");
    path_make(pattern, "%s/no_macros.h", workdir->build);
    result |= copy_matching(workdir, pattern, "probes");
    path_make(pattern, "%s/libcommon.a", workdir->build);
    return result | copy_matching(workdir, pattern, "lib");
}

// The kernels of the lab's probe; a lab of host files alone has none.
static int copy_probe_kernels(const Workdir *workdir)
{
    char from[PATH_MAX], folder[128];
    snprintf(folder, sizeof folder, "probes/%s", workdir->manifest->lab);
    path_make(from, "tests/%s/probe.cl", folder);
    if (access(from, F_OK) != 0) {
        return 0;
    }
    path_make(from, "tests/%s/*.cl", folder);
    return copy_matching(workdir, from, folder);
}

// Empty folders that the sandbox puts others in the place of.
static int make_mount_points(const Workdir *workdir)
{
    static const char *const folders[] = {"labs", "job", "build", "out"};
    char path[PATH_MAX];
    int result = 0;
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        path_make(path, "%s/%s", workdir->tree, folders[i]);
        result |= make_folder(path);
    }
    path_make(path, "%s/labs/%s", workdir->tree, workdir->manifest->lab);
    result |= make_folder(path);
    path_make(path, "%s/job", workdir->folder);
    return result | make_folder(path);
}

// Returns 0 when nothing is left of it.
static int folder_clear(void *what)
{
    const Workdir *workdir = what;
    glob_t found;
    char pattern[PATH_MAX];
    path_make(pattern, "%s/variant-*/{build,out}", workdir->folder);
    if (glob(pattern, GLOB_BRACE, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc; i++) {
            limited_folder_unmount(found.gl_pathv[i]);
        }
        globfree(&found);
    }
    return folder_remove(workdir->folder) == 0 || errno == ENOENT ? 0 : -1;
}

int workdir_open(Workdir *workdir, const Manifest *manifest, const char *build, const char *device,
                 SandboxKind sandbox)
{
    *workdir =
        (Workdir){.build = build, .manifest = manifest, .device = device, .sandbox = sandbox};
    workdir->needs_compiler = manifest_has_host_files(manifest);
    if (temporary_folder_make(workdir->folder, "grade") != 0) {
        fprintf(stderr, "grade: no temporary folder in $TMPDIR or /tmp: %s\n", strerror(errno));
        return -1;
    }
    if (janitor_start(&workdir->janitor, folder_clear, workdir) != 0) {
        fprintf(stderr, "grade: no process can be started: %s\n", strerror(errno));
        return -1;
    }
    char path[PATH_MAX];
    path_make(workdir->tree, "%s/tree", workdir->folder);
    int result = make_folder(workdir->folder) | make_folder(workdir->tree);
    path_make(path, "%s/solutions", workdir->tree);
    result |= make_folder(path) | make_mount_points(workdir);
    if (workdir->needs_compiler) {
        result |= copy_matching(workdir, "common/*.h", "common");
    }
    result |= copy_matching(workdir, "kernels/*.h", "kernels");
    result |= copy_matching(workdir, "tests/probes/{*.h,*/jobs_*.h}", "probes");
    return result | copy_probe_kernels(workdir) | copy_earlier_solutions(workdir) |
                   copy_libraries(workdir)
               ? -1
               : 0;
}

SandboxCommand workdir_command(const Workdir *workdir, const char *const *argv,
                               const char *const *environment, SandboxTime time)
{
    return (SandboxCommand){
        .kind = workdir->sandbox,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{workdir->tree, "/work", 0}},
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

void workdir_close(Workdir *workdir)
{
    if (workdir->folder[0] != '\0') {
        folder_clear(workdir);
    }
    workdir->folder[0] = '\0';
    janitor_dismiss(&workdir->janitor);
}

void workdir_job_suffix(int job, char suffix[16])
{
    suffix[0] = '\0';
    if (job > 0) {
        snprintf(suffix, 16, ".%d", job);
    }
}

void workdir_job_path(const Workdir *workdir, int job, char path[PATH_MAX])
{
    char suffix[16];
    workdir_job_suffix(job, suffix);
    path_make(path, "%s/job/job%s", workdir->folder, suffix);
}

// One archive becomes a folder (see unpack_run.h).
//
// The archive and the program that reads it are copied to where the sandbox's user may read them.
// What comes back is a folder like any other, as little to be trusted, and some lines for the
// student.
#include "unpack_run.h"

#include "bytes_write.h"
#include "complain.h"
#include "folder.h"
#include "message.h"
#include "path.h"
#include "sandbox.h"
#include "submission.h"
#include "unpack.h"
#include "unpack_rules.h"
#include "workdir_files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// What unpacking may use, whatever is unpacked. The xz format's own limit on memory is 64 MB.
enum { UNPACK_WALL_SECONDS = 600, UNPACK_MEMORY_MB = 512, UNPACK_PROCESSES = 512 };

// What unpack ends with when the archive is at fault; see unpack_tool.c.
enum { EXIT_ARCHIVE = 1 };

// Where it ended as if the machine were at fault: who is, has to be found out.
enum { UNPACK_FAILED = 2 };

static int machinery_fault(const char *path, int fault)
{
    complain("%s: %s", path, strerror(fault));
    return -1;
}

// A fault of what was handed in, named by the last part of its path: one line to the student.
static int submission_refuse(const char *path, const char *complaint, char **message)
{
    char shown[MESSAGE_SHOWN_BYTES];
    const char *slash = strrchr(path, '/');
    *message = message_new(
        "%s: %s", message_show(slash != NULL ? slash + 1 : path, shown, sizeof shown), complaint);
    return 1;
}

static const UnpackRules *rules_of(const Workdir *workdir)
{
    return workdir->manifest != NULL ? &unpack_rules_student : &unpack_rules_export;
}

// ---- Copies for the sandbox -----------------------------------------------------------------

// Copy at most n_bytes of an open file to a new one. Returns 0, or -1 with errno set.
static int copy_open_file(int from, const char *to, off_t n_bytes)
{
    char block[1 << 16];
    const int out = open(to, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (out < 0) {
        return -1;
    }
    int outcome = fchmod(out, 0644);  // whatever the umask
    while (outcome == 0 && n_bytes > 0) {
        const size_t n_wanted = n_bytes < (off_t)sizeof block ? (size_t)n_bytes : sizeof block;
        const ssize_t n = read(from, block, n_wanted);
        if (n == 0) {
            break;
        }
        if (n > 0) {
            outcome = bytes_write(out, block, (size_t)n);
            n_bytes -= n;
        } else if (errno != EINTR) {
            outcome = -1;
        }
    }
    return close_after(out, outcome);
}

// The archive could not be copied. Where there is room for what every submission may need, it is
// the archive that is too large. Returns 1 with a message, or -1.
static int copy_failed(const UnpackRules *rules, const char *path, const char *to, const char *in,
                       off_t n_bytes, int fault, char **message)
{
    char complaint[160];
    const int folder = open(in, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    unlink(to);
    const int has_room = (fault == ENOSPC || fault == EDQUOT) && folder >= 0 &&
                         room_try(folder, UNPACK_MAX_WRITTEN_MEGABYTES) == 0;
    if (folder >= 0) {
        close(folder);
    }
    if (!has_room) {
        return machinery_fault(to, fault);
    }
    snprintf(complaint, sizeof complaint,
             "its %.1f MB do not fit into the room that this machine has for archives: %s",
             (double)n_bytes / (1 << 20), rules->if_large);
    return submission_refuse(path, complaint, message);
}

// Copy the archive, an open file, into the folder `in`. Returns 0, 1 with a message, or -1.
static int copy_archive(const UnpackRules *rules, const char *path, int from, const char *in,
                        char **message)
{
    char to[PATH_MAX];
    struct stat status;
    if (fstat(from, &status) != 0) {
        return machinery_fault(path, errno);
    }
    if (!S_ISREG(status.st_mode)) {
        return submission_refuse(
            path,
            "neither a folder nor an archive: hand in a folder, or a zip or tar "
            "archive of it",
            message);
    }
    if (status.st_size > (off_t)rules->most_packed_megabytes << 20) {
        char complaint[80];
        snprintf(complaint, sizeof complaint, "larger than the allowed %d MB: %s",
                 rules->most_packed_megabytes, rules->if_large);
        return submission_refuse(path, complaint, message);
    }
    path_make(to, "%s/archive", in);
    return copy_open_file(from, to, status.st_size) == 0
               ? 0
               : copy_failed(rules, path, to, in, status.st_size, errno, message);
}

// ---- Unpacking ------------------------------------------------------------------------------

// The folders of the workdir that unpacking takes: `in`, which the sandbox reads, and `out`, which
// it writes, both closed to all but the run that is given them.
typedef struct Desk {
    const Workdir *workdir;
    char folder[PATH_MAX], in[PATH_MAX], out[PATH_MAX];
} Desk;

// Returns 0, or -1 after one message.
static int folder_make(const char *path, mode_t mode)
{
    return mkdir(path, mode) == 0 && chmod(path, mode) == 0 ? 0 : machinery_fault(path, errno);
}

static int desk_make(const Workdir *workdir, int number, Desk *desk)
{
    desk->workdir = workdir;
    path_make(desk->folder, "%s/unpack-%d", workdir->folder, number);
    path_make(desk->in, "%s/unpack-%d/in", workdir->folder, number);
    path_make(desk->out, "%s/unpack-%d/out", workdir->folder, number);
    return folder_make(desk->folder, 0755) | folder_make(desk->in, 0700);
}

// Start the program over an archive, with an empty folder to write to. NULL after one message.
static SandboxRun *start_unpack(const Desk *desk, const char *archive)
{
    const Manifest *manifest = desk->workdir->manifest;
    const UnpackRules *rules = rules_of(desk->workdir);
    const char *argv[5 + MANIFEST_MAX_FILES] = {"in/unpack", archive, "out"};
    if (folder_remove(desk->out) != 0 && errno != ENOENT) {
        machinery_fault(desk->out, errno);
        return NULL;
    }
    if (folder_make(desk->out, 0700) != 0) {
        return NULL;
    }
    for (int i = 0; manifest != NULL && i < manifest->n_files; i++) {
        argv[3] = manifest->lab;
        argv[4 + i] = manifest->files[i];
    }
    const SandboxCommand command = {
        .kind = desk->workdir->sandbox,
        .argv = argv,
        .folder = "/work",
        .mounts = {{desk->in, "/work/in", 0}, {desk->out, "/work/out", 1}},
        .n_mounts = 2,
        .time = {rules->seconds, rules->seconds, UNPACK_WALL_SECONDS + rules->seconds},
        .memory_mb = UNPACK_MEMORY_MB,
        .file_mb = rules->most_file_megabytes,
        .n_processes = UNPACK_PROCESSES,
    };
    return sandbox_start(&command);
}

// What its end means. Returns 0 with a message or NULL, 1 with one for the student, UNPACK_FAILED,
// or -1.
static int take_unpack(const Desk *desk, const char *path, const SandboxResult *result,
                       char **message)
{
    const UnpackRules *rules = rules_of(desk->workdir);
    char complaint[128];
    char line[512];
    if (result->outcome == SANDBOX_EXITED && result->exit_status == 0) {
        size_t n_bytes = strnlen(result->output, UNPACK_MESSAGE_BYTES);
        n_bytes -= n_bytes > 0 && result->output[n_bytes - 1] == '\n';
        *message = n_bytes > 0 ? message_new("%.*s", (int)n_bytes, result->output) : NULL;
        return 0;
    }
    result->output[strcspn(result->output, "\n")] = '\0';
    message_show(result->output, line, sizeof line);
    if (result->outcome == SANDBOX_FAULT) {
        complain("grade: the sandbox failed: %s", line);
        return -1;
    }
    if (result->outcome == SANDBOX_TIMED_OUT || result->outcome == SANDBOX_ASLEEP ||
        result->outcome == SANDBOX_OVERDUE) {
        snprintf(complaint, sizeof complaint, "not unpacked after %d s of %s: %s", rules->seconds,
                 result->outcome == SANDBOX_TIMED_OUT ? "processor time" : "waiting",
                 rules->if_large);
        return submission_refuse(path, complaint, message);
    }
    if (result->outcome == SANDBOX_STARVED) {
        complain("grade: this machine is too busy: tools/unpack was not done in %.0f s",
                 result->used.wall);
        return -1;
    }
    if (result->outcome != SANDBOX_EXITED) {
        snprintf(complaint, sizeof complaint, "the archive is damaged, reading it crashes: %s",
                 rules->if_damaged);
        return submission_refuse(path, complaint, message);
    }
    if (result->exit_status == EXIT_ARCHIVE) {
        return submission_refuse(path, line, message);
    }
    // Of a class's export it is the disk that is full, or the like: nobody gains by that.
    if (desk->workdir->manifest == NULL) {
        complain("%s: %s", desk->out, line);
        return -1;
    }
    return UNPACK_FAILED;
}

// Can the program work here at all, over what is no archive? It says that it found none, then. An
// archive has no part in it, so what fails here is the machine's fault. Returns 0, or -1 after one
// message.
static int machine_try(const Desk *desk)
{
    char line[512];
    SandboxRun *run = start_unpack(desk, "/dev/null");
    if (run == NULL) {
        return -1;
    }
    const SandboxResult result = sandbox_wait(run);
    const int works = result.outcome == SANDBOX_EXITED && result.exit_status == EXIT_ARCHIVE;
    if (!works) {
        result.output[strcspn(result.output, "\n")] = '\0';
        complain("grade: tools/unpack cannot work here: %s",
                 message_show(result.output, line, sizeof line));
    }
    free(result.output);
    return works ? 0 : -1;
}

// Unpack what is on the desk. Who read the archive is not believed that the machine failed: it is
// asked again, once the machine has shown that it can. Returns 0, 1 with a message, or -1.
static int desk_unpack(const Desk *desk, const char *path, char **message)
{
    for (int i = 0; i < 2; i++) {
        SandboxRun *run = start_unpack(desk, "in/archive");
        if (run == NULL) {
            return -1;
        }
        const SandboxResult result = sandbox_wait(run);
        const int outcome = take_unpack(desk, path, &result, message);
        free(result.output);
        if (outcome != UNPACK_FAILED) {
            return outcome;
        }
        if (machine_try(desk) != 0) {
            return -1;
        }
    }
    char complaint[128];
    snprintf(complaint, sizeof complaint, "the archive is damaged, unpacking it fails: %s",
             rules_of(desk->workdir)->if_damaged);
    return submission_refuse(path, complaint, message);
}

int archive_unpack(const Workdir *workdir, int number, const char *path, int archive,
                   char folder[PATH_MAX], char **message)
{
    Desk desk;
    char tool[PATH_MAX], tool_copy[PATH_MAX];
    if (desk_make(workdir, number, &desk) != 0) {
        return -1;
    }
    path_make(folder, "%s", desk.out);
    // The tool first: there is room for it, whatever the archive then takes.
    path_make(tool, "%s/tools/unpack", workdir->build);
    path_make(tool_copy, "%s/unpack", desk.in);
    if (copy_file(tool, tool_copy) != 0) {
        return -1;
    }
    int outcome = copy_archive(rules_of(workdir), path, archive, desk.in, message);
    outcome = outcome == 0 ? desk_unpack(&desk, path, message) : outcome;
    // Another archive may need its room.
    if (folder_remove(desk.in) != 0) {
        return machinery_fault(desk.in, errno);
    }
    return outcome;
}

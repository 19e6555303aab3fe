// One sandboxed command's supervisor: a process between the grader and bubblewrap.
//
//     grader -> supervisor -> bwrap -> [ bwrap's process 1 -> prlimit -> the command -> ... ]
//
// It reads the command's output to the end and kills it at the deadline whether or not the grader
// waits, so that runs side by side cannot block each other. As the "subreaper" it inherits whatever
// bwrap leaves behind: when it has no children any more, nothing of the run is alive, and all the
// CPU time that was used is known. Read next: bwrap_arguments.c, what is inside the brackets.
#include "sandbox_supervisor.h"

#include "bwrap_arguments.h"

#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// A shell's way to tell of a signal, which bwrap follows: exit code 128 + its number.
#define SIGNAL_EXIT_BASE 128

// A process killed by SIGKILL that used so much of its CPU time was killed for that. Not all of it:
// for the limit the kernel counts whole clock ticks, for getrusage() the time that really ran, and
// on a busy machine the first was seen ahead of the second by a tenth and more.
#define CPU_LIMIT_SHARE 0.5

#define OPEN_FILES_LIMIT 256

typedef struct Watch {
    const SandboxCommand *command;
    SandboxReport *report;
    double deadline;  // on the monotonic clock, seconds
    pid_t bwrap;
    int output;  // read ends of the pipes; -1 when at their end
    int status;
    int end_request;         // readable when the grader has ended, or somebody sent a SIGTERM
    char status_text[1024];  // what bwrap said about itself, JSON
    size_t n_status;
} Watch;

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void fault_set(SandboxReport *report, const char *what)
{
    report->outcome = SANDBOX_FAULT;
    report->n_output =
        (size_t)snprintf(report->output, sizeof report->output, "%s: %s", what, strerror(errno));
}

static void signals_block(int signal_id)
{
    sigset_t blocked;
    sigemptyset(&blocked);
    if (signal_id != 0) {
        sigaddset(&blocked, signal_id);
    }
    sigprocmask(SIG_SETMASK, &blocked, NULL);
}

// ---- In the process that becomes bwrap -------------------------------------------------------

static int limit_set(__rlimit_resource_t resource, rlim_t value)
{
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0) {
        return -1;
    }
    // Where the grader itself runs under a tighter limit, that one stays.
    if (limit.rlim_max == RLIM_INFINITY || value < limit.rlim_max) {
        limit.rlim_max = value;
    }
    limit.rlim_cur = limit.rlim_max;
    return setrlimit(resource, &limit);
}

// All limits but the one on processes (see bwrap_arguments.c).
static int limits_set(const SandboxCommand *command)
{
    const rlim_t megabyte = 1024 * 1024;
    if (command->memory_mb > 0 &&
        limit_set(RLIMIT_AS, (rlim_t)command->memory_mb * megabyte) != 0) {
        return -1;
    }
    // Soft and hard alike: PoCL swallows SIGXCPU, the hard limit's SIGKILL nobody can.
    if (limit_set(RLIMIT_CPU, (rlim_t)command->cpu_seconds) != 0 ||
        limit_set(RLIMIT_FSIZE, (rlim_t)command->file_mb * megabyte) != 0 ||
        limit_set(RLIMIT_NOFILE, OPEN_FILES_LIMIT) != 0 || limit_set(RLIMIT_CORE, 0) != 0) {
        return -1;
    }
    return 0;
}

// Root's rights go before bwrap starts, so that not even a fault in bwrap gives them away.
static int privileges_drop(void)
{
    if (geteuid() != 0) {
        return 0;
    }
    if (setgroups(0, NULL) != 0 || setresgid(SANDBOX_NOBODY, SANDBOX_NOBODY, SANDBOX_NOBODY) != 0 ||
        setresuid(SANDBOX_NOBODY, SANDBOX_NOBODY, SANDBOX_NOBODY) != 0) {
        return -1;
    }
    return 0;
}

static int descriptors_arrange(int output, int status)
{
    if (dup2(output, STDOUT_FILENO) < 0 || dup2(output, STDERR_FILENO) < 0 ||
        dup2(status, BWRAP_STATUS_DESCRIPTOR) < 0) {
        return -1;
    }
    if (close_range(STDERR_FILENO + 1, BWRAP_STATUS_DESCRIPTOR - 1, 0) != 0) {
        return -1;
    }
    return close_range(BWRAP_STATUS_DESCRIPTOR + 1, ~0U, 0);
}

static _Noreturn void bwrap_become(const SandboxCommand *command, char *const *bwrap, int output,
                                   int status)
{
    // bwrap's own environment can be read from inside (/proc/1/environ): the grader's stays out.
    char *const environment[] = {"PATH=/usr/bin:/bin", NULL};
    signals_block(0);
    if (setpgid(0, 0) == 0 && descriptors_arrange(output, status) == 0 && chdir("/") == 0 &&
        limits_set(command) == 0 && privileges_drop() == 0) {
        umask(022);
        execvpe(bwrap[0], bwrap, environment);
        if (errno == ENOENT) {
            dprintf(STDERR_FILENO, "bwrap not found: install bubblewrap\n");
            _exit(127);
        }
    }
    dprintf(STDERR_FILENO, "cannot start bwrap: %s\n", strerror(errno));
    _exit(127);
}

// ---- In the supervisor -----------------------------------------------------------------------

// Leave what was inherited from the grader: its signal handlers, its open files, its process group.
static int inheritance_leave(pid_t grader)
{
    for (int signal_id = 1; signal_id <= SIGRTMAX; signal_id++) {
        signal(signal_id, SIG_DFL);
    }
    // When the grader ends we get a SIGTERM, to be read like the output, and clear up. Dying along
    // with it would not do: bwrap, killed while it starts, can leave its command running. For the
    // same reason we are in a group of our own: "kill the grader's group" shall not mean us.
    signals_block(SIGTERM);
    if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, SIGTERM) != 0 ||
        prctl(PR_SET_CHILD_SUBREAPER, 1) != 0) {
        return -1;
    }
    if (getppid() != grader) {  // it ended before we asked to be told
        _exit(1);
    }

    if (close_range(0, ~0U, 0) != 0) {
        return -1;
    }
    // Descriptors 0, 1 and 2, in this order as the lowest free ones.
    if (open("/dev/null", O_RDWR) != 0 || dup(0) != 1 || dup(0) != 2) {
        return -1;
    }
    return 0;
}

// Returns 0, or -1 with errno set.
static int bwrap_start(Watch *watch, char *const *bwrap)
{
    int output[2], status[2];
    sigset_t termination;
    sigemptyset(&termination);
    sigaddset(&termination, SIGTERM);
    watch->end_request = signalfd(-1, &termination, SFD_CLOEXEC);
    if (watch->end_request < 0 || pipe2(output, O_CLOEXEC) != 0 || pipe2(status, O_CLOEXEC) != 0) {
        return -1;
    }
    watch->bwrap = fork();
    if (watch->bwrap < 0) {
        return -1;
    }
    if (watch->bwrap == 0) {
        bwrap_become(watch->command, bwrap, output[1], status[1]);
    }
    setpgid(watch->bwrap, watch->bwrap);  // whichever of the two comes first
    close(output[1]);
    close(status[1]);
    watch->output = output[0];
    watch->status = status[0];
    return 0;
}

// Read what a pipe holds now. What does not fit is thrown away, but read: a writer is never
// blocked.
static void pipe_read(int *pipe, char *text, size_t n_room, size_t *n_text)
{
    char block[65536];
    ssize_t n = read(*pipe, block, sizeof block);
    if (n < 0 && errno == EINTR) {
        return;
    }
    if (n <= 0) {
        close(*pipe);
        *pipe = -1;
        return;
    }
    size_t n_kept = (size_t)n < n_room - *n_text ? (size_t)n : n_room - *n_text;
    memcpy(text + *n_text, block, n_kept);
    *n_text += n_kept;
}

static void output_read(Watch *watch)
{
    SandboxReport *report = watch->report;
    pipe_read(&watch->output, report->output, sizeof report->output, &report->n_output);
}

static void status_read(Watch *watch)
{
    pipe_read(&watch->status, watch->status_text, sizeof watch->status_text - 1, &watch->n_status);
}

// bwrap holds both pipes open itself, so both at their end means that bwrap has ended. A command
// that closes its output does not look like that.
static void pipes_watch(Watch *watch)
{
    while (watch->output >= 0 || watch->status >= 0) {
        double seconds_left = watch->deadline - seconds_now();
        if (seconds_left <= 0) {
            return;
        }
        struct pollfd pipes[] = {{.fd = watch->output, .events = POLLIN},
                                 {.fd = watch->status, .events = POLLIN},
                                 {.fd = watch->end_request, .events = POLLIN}};
        if (poll(pipes, 3, (int)(seconds_left * 1000) + 1) <= 0) {
            continue;  // the deadline: looked at above
        }
        if (pipes[2].revents != 0) {
            return;
        }
        if (pipes[0].revents != 0) {
            output_read(watch);
        }
        if (pipes[1].revents != 0) {
            status_read(watch);
        }
    }
}

// The number behind "name": in what bwrap said, or -1. Only bwrap can write there.
static int status_number(const Watch *watch, const char *name)
{
    const char *place = strstr(watch->status_text, name);
    const char *colon = place != NULL ? strchr(place, ':') : NULL;
    return colon != NULL ? atoi(colon + 1) : -1;
}

// Kill what is left and wait until there is nothing any more.
static void processes_end(Watch *watch)
{
    kill(-watch->bwrap, SIGKILL);
    while (waitpid(watch->bwrap, NULL, 0) < 0 && errno == EINTR)
        ;
    // With bwrap gone, its process 1 inside is our child and gets killed by the kernel, unless
    // bwrap was killed before it could arrange for that. Process 1 takes the whole sandbox with it.
    while (watch->status >= 0) {
        status_read(watch);
    }
    int first_inside = status_number(watch, "\"child-pid\"");
    siginfo_t unused;
    int is_our_child = first_inside > 0 &&
                       waitid(P_PID, (id_t)first_inside, &unused, WEXITED | WNOHANG | WNOWAIT) == 0;
    if (is_our_child) {
        kill(first_inside, SIGKILL);
    }
    while (wait(NULL) > 0 || errno == EINTR)
        ;
    while (watch->output >= 0) {
        output_read(watch);
    }
}

// CPU time of all the processes that there were.
static double cpu_seconds_used(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static void outcome_judge(Watch *watch)
{
    SandboxReport *report = watch->report;
    // bwrap tells an exit code only if the command was really started.
    int exit_code = status_number(watch, "\"exit-code\"");
    int was_made = status_number(watch, "\"child-pid\"") > 0;
    double cpu_limit = CPU_LIMIT_SHARE * watch->command->cpu_seconds;

    if (exit_code < 0) {
        int is_late = seconds_now() >= watch->deadline;
        report->outcome = is_late && was_made ? SANDBOX_TIMED_OUT : SANDBOX_FAULT;
    } else if (exit_code == SIGNAL_EXIT_BASE + SIGKILL && cpu_seconds_used() >= cpu_limit) {
        report->outcome = SANDBOX_TIMED_OUT;
    } else if (exit_code > SIGNAL_EXIT_BASE && exit_code <= SIGNAL_EXIT_BASE + SIGRTMAX) {
        report->outcome = SANDBOX_CRASHED;
        report->signal = exit_code - SIGNAL_EXIT_BASE;
    } else {
        report->outcome = SANDBOX_EXITED;
        report->exit_status = exit_code;
    }
}

_Noreturn void sandbox_supervise(const SandboxCommand *command, char *const *bwrap, pid_t grader,
                                 SandboxReport *report)
{
    Watch watch = {
        .command = command,
        .report = report,
        .deadline = seconds_now() + command->wall_seconds,
    };
    if (inheritance_leave(grader) != 0 || bwrap_start(&watch, bwrap) != 0) {
        fault_set(report, "cannot start bwrap");
    } else {
        pipes_watch(&watch);
        processes_end(&watch);
        outcome_judge(&watch);
    }
    report->is_complete = 1;
    _exit(0);
}

// One sandboxed command's supervisor: a process between the grader and the command.
//
//     grader -> supervisor -> bwrap -> [ our process 1 -> the command -> ... ]
//     grader -> supervisor -> [ the command -> ... ]                               (others)
//
// It reads the command's output to the end and kills it when its time is used up whether or not the
// grader waits, so that runs side by side cannot block each other. As the "subreaper" it inherits
// whatever the command leaves behind: when it has no children any more, nothing of the run is
// alive, and all the CPU time that was used is known. Read next: sandbox_walls.c, the brackets.
#include "sandbox_supervisor.h"

#include "descriptors.h"
#include "sandbox_clock.h"
#include "sandbox_leader.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// A shell's way to tell of a signal, which bwrap follows: exit code 128 + its number.
#define SIGNAL_EXIT_BASE 128

// A process killed by SIGKILL that used so much of its processor time was killed for that, by the
// kernel, before the supervisor came to look. Not all of it: for the limit the kernel counts whole
// clock ticks, for getrusage() the time that really ran, and on a busy machine the first was seen
// ahead of the second by a tenth and more.
#define CPU_LIMIT_SHARE 0.5

typedef enum WatchEnd {
    WATCH_COMMAND_ENDED,
    WATCH_PROCESSOR,  // its processor time is used up
    WATCH_ASLEEP,     // its time asleep is
    WATCH_WALL,       // its wall time is
    WATCH_LIMIT,      // see the report
    WATCH_STOPPED,    // the grader has ended, or somebody sent a SIGTERM
} WatchEnd;

typedef struct Watch {
    const Walls *walls;
    SandboxReport *report;
    SandboxClock clock;
    pid_t leader;  // bwrap, or the command itself
    int leader_has_ended;
    int leader_status;  // how
    int output;         // read ends of the pipes; -1 when at their end
    int status;
    int signals;             // to be read: children have ended, or we shall (see WATCH_STOPPED)
    char status_text[1024];  // what was said about the command's start and end, JSON
    size_t n_status;
} Watch;

static void fault_set(SandboxReport *report, const char *what)
{
    report->outcome = SANDBOX_FAULT;
    report->n_output =
        (size_t)snprintf(report->output, sizeof report->output, "%s: %s", what, strerror(errno));
}

// What a supervisor hears about by a signal: a child's end, and that it shall end itself.
static sigset_t signals_heard(void)
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGCHLD);
    sigaddset(&signals, SIGTERM);
    return signals;
}

// Leave what was inherited from the grader: its signal handlers, its open files, its process group.
static int inheritance_leave(const Walls *walls, pid_t grader)
{
    for (int signal_id = 1; signal_id <= SIGRTMAX; signal_id++) {
        signal(signal_id, SIG_DFL);
    }
    // When the grader ends we get a SIGTERM, to be read like the output, and clear up. Dying along
    // with it would not do: bwrap, killed while it starts, can leave its command running. For the
    // same reason we are in a group of our own: "kill the grader's group" shall not mean us.
    sigset_t signals = signals_heard();
    sigprocmask(SIG_SETMASK, &signals, NULL);
    if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, SIGTERM) != 0) {
        return -1;
    }
    // gVisor's first years knew no subreapers: there the scan finds who is left by the user.
    if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0 && !sandbox_has_own_user(walls->command.kind)) {
        return -1;
    }
    if (getppid() != grader) {  // it ended before we asked to be told
        _exit(1);
    }

    const int filter = walls->filter;  // above the standard descriptors
    if (descriptors_close(0, filter - 1) != 0 || descriptors_close(filter + 1, INT_MAX) != 0) {
        return -1;
    }
    // Descriptors 0, 1 and 2, in this order as the lowest free ones.
    if (open("/dev/null", O_RDWR) != 0 || dup(0) != 1 || dup(0) != 2) {
        return -1;
    }
    return 0;
}

// Returns 0, or -1 with errno set.
static int leader_start(Watch *watch)
{
    int output[2], status[2];
    sigset_t signals = signals_heard();
    watch->signals = signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
    if (watch->signals < 0 || pipe2(output, O_CLOEXEC) != 0 || pipe2(status, O_CLOEXEC) != 0) {
        return -1;
    }
    watch->leader = fork();
    if (watch->leader < 0) {
        return -1;
    }
    if (watch->leader == 0) {
        leader_become(watch->walls, output[1], status[1]);
    }
    close(output[1]);
    close(status[1]);
    watch->output = output[0];
    watch->status = status[0];
    return 0;
}

// Read what a pipe holds now. What does not fit is thrown away, but read: a writer is never
// blocked. Returns how much there was.
static size_t pipe_read(int *pipe, char *text, size_t n_room, size_t *n_text)
{
    char block[65536];
    ssize_t n = read(*pipe, block, sizeof block);
    if (n < 0 && errno == EINTR) {
        return 0;
    }
    if (n <= 0) {
        close(*pipe);
        *pipe = -1;
        return 0;
    }
    size_t n_kept = (size_t)n < n_room - *n_text ? (size_t)n : n_room - *n_text;
    memcpy(text + *n_text, block, n_kept);
    *n_text += n_kept;
    return (size_t)n;
}

static void output_read(Watch *watch)
{
    SandboxReport *report = watch->report;
    report->n_printed +=
        pipe_read(&watch->output, report->output, sizeof report->output, &report->n_output);
}

static void status_read(Watch *watch)
{
    pipe_read(&watch->status, watch->status_text, sizeof watch->status_text - 1, &watch->n_status);
}

static pid_t outermost(const Watch *watch)
{
    return watch->walls->bwrap != NULL ? watch->leader : -1;
}

// Has a limit on all processes together been passed?
static int scan_take(Watch *watch)
{
    const double begin = seconds_own();
    ProcessScan scan = {0};
    scan_processes(watch->walls, outermost(watch), &scan);
    clock_look(&watch->clock, &scan);
    watch->report->processor_used = watch->clock.used.processor;
    watch->report->asleep_used = watch->clock.used.asleep;
    scan_folders(watch->walls, &scan);
    watch->clock.looking = seconds_own() - begin;
    watch->report->limit = scan_limit(&scan, &watch->walls->command);
    return watch->report->limit != SANDBOX_LIMIT_NONE;
}

// Has it used up one of its times?
static WatchEnd time_check(const Watch *watch)
{
    const SandboxTime *used = &watch->clock.used;
    const SandboxReport *report = watch->report;
    return used->processor >= report->processor_allowed ? WATCH_PROCESSOR
           : used->asleep >= report->asleep_allowed     ? WATCH_ASLEEP
           : used->wall >= report->wall_allowed         ? WATCH_WALL
                                                        : WATCH_COMMAND_ENDED;
}

// Reap what has ended. Returns 0 when there are no children any more.
static int children_reap(Watch *watch)
{
    int status;
    pid_t child;
    while ((child = waitpid(-1, &status, WNOHANG)) > 0 || (child < 0 && errno == EINTR)) {
        if (child == watch->leader) {
            watch->leader_has_ended = 1;
            watch->leader_status = status;
        }
    }
    return child == 0;
}

// Hear of signals. What ends is reaped at once, as whatever waits for that counts as a process.
// Returns 1 when we shall end.
static int signals_read(Watch *watch)
{
    struct signalfd_siginfo heard;
    int is_stopped = 0;
    while (read(watch->signals, &heard, sizeof heard) == sizeof heard) {
        is_stopped |= heard.ssi_signo == SIGTERM;
    }
    children_reap(watch);
    return is_stopped;
}

// Watch until the command ends or has to be ended.
static WatchEnd command_watch(Watch *watch)
{
    double scan_time = clock_next_look(&watch->clock);
    for (;;) {
        double now = seconds_now();
        if (now >= scan_time) {
            if (scan_take(watch)) {
                return WATCH_LIMIT;
            }
            const WatchEnd time_end = time_check(watch);
            if (time_end != WATCH_COMMAND_ENDED) {
                return time_end;
            }
            scan_time = clock_next_look(&watch->clock);
        }
        struct pollfd events[] = {{.fd = watch->output, .events = POLLIN},
                                  {.fd = watch->status, .events = POLLIN},
                                  {.fd = watch->signals, .events = POLLIN}};
        int milliseconds = (int)((scan_time - now) * 1000) + 1;
        if (poll(events, 3, milliseconds > 0 ? milliseconds : 0) <= 0) {
            continue;  // time for the scan
        }
        if (events[0].revents != 0) {
            output_read(watch);
        }
        if (events[1].revents != 0) {
            status_read(watch);
        }
        if (events[2].revents != 0 && signals_read(watch)) {
            return WATCH_STOPPED;
        }
        if (watch->leader_has_ended) {
            return WATCH_COMMAND_ENDED;
        }
    }
}

// The number behind "name": in what was said, or -1. Only the walls can write there.
static int status_number(const Watch *watch, const char *name)
{
    const char *place = strstr(watch->status_text, name);
    const char *colon = place != NULL ? strchr(place, ':') : NULL;
    return colon != NULL ? atoi(colon + 1) : -1;
}

// Kill what is left until there is nothing any more.
static void processes_end(Watch *watch)
{
    const struct timespec pause = {.tv_nsec = 1000000};
    if (!watch->leader_has_ended) {
        kill(watch->leader, SIGKILL);
    }
    // With bwrap gone, its process 1 inside is our child and gets killed by the kernel, unless
    // bwrap was killed before it could arrange for that. Process 1 takes the whole sandbox with it.
    while (children_reap(watch) || scan_has_strays(watch->walls)) {
        scan_kill_children();
        walls_end_user(watch->walls);
        nanosleep(&pause, NULL);
    }
    // Everyone who could write has ended.
    while (watch->status >= 0) {
        status_read(watch);
    }
    while (watch->output >= 0) {
        output_read(watch);
    }
}

// Has the command begun? Until then what goes wrong is the machinery's fault, from then on whatever
// becomes of its sandbox is its own doing.
static int has_started(const Watch *watch)
{
    const char *name = watch->walls->bwrap != NULL ? "\"command-started\"" : "\"child-pid\"";
    return status_number(watch, name) > 0;
}

// The command's exit code as a shell has it, or -1 when it never began.
static int exit_code_find(const Watch *watch)
{
    if (!has_started(watch)) {
        return -1;
    }
    if (watch->walls->bwrap != NULL) {
        // None, or one that no command has: its sandbox did not end as sandboxes do.
        const int exit_code = status_number(watch, "\"exit-code\"");
        return exit_code >= 0 && exit_code <= 255 ? exit_code : SIGNAL_EXIT_BASE + SIGKILL;
    }
    int status = watch->leader_status;
    return WIFSIGNALED(status) ? SIGNAL_EXIT_BASE + WTERMSIG(status) : WEXITSTATUS(status);
}

static void outcome_judge(const Watch *watch, WatchEnd end)
{
    SandboxReport *report = watch->report;
    int exit_code = exit_code_find(watch);
    // Everything has ended by now, so that all of its processor time is known.
    report->used = watch->clock.used;
    if (report->used.processor < clock_ended_children()) {
        report->used.processor = clock_ended_children();
    }
    report->used.wall = seconds_now() - watch->clock.start;
    const double killed_for_time = CPU_LIMIT_SHARE * watch->walls->command.time.processor;

    if (end == WATCH_LIMIT) {
        report->outcome = SANDBOX_EXCEEDED;
    } else if (end != WATCH_COMMAND_ENDED && end != WATCH_STOPPED && !has_started(watch)) {
        report->outcome = SANDBOX_FAULT;
    } else if (end == WATCH_PROCESSOR) {
        report->outcome = SANDBOX_TIMED_OUT;
    } else if (end == WATCH_ASLEEP) {
        report->outcome = SANDBOX_ASLEEP;
    } else if (end == WATCH_WALL) {
        report->outcome = clock_is_starved(&watch->clock) ? SANDBOX_STARVED : SANDBOX_OVERDUE;
    } else if (end == WATCH_STOPPED || exit_code < 0) {
        report->outcome = SANDBOX_FAULT;
    } else if (exit_code == SIGNAL_EXIT_BASE + SIGKILL &&
               report->used.processor >= killed_for_time) {
        report->outcome = SANDBOX_TIMED_OUT;
    } else if (exit_code == SIGNAL_EXIT_BASE + SIGSYS) {
        report->outcome = SANDBOX_FORBIDDEN;
    } else if (exit_code > SIGNAL_EXIT_BASE && exit_code <= SIGNAL_EXIT_BASE + SIGRTMAX) {
        report->outcome = SANDBOX_CRASHED;
        report->signal = exit_code - SIGNAL_EXIT_BASE;
    } else {
        report->outcome = SANDBOX_EXITED;
        report->exit_status = exit_code;
    }
}

// What it left running, and whether it wrote too much since the last look. Returns how it ended.
static WatchEnd last_look_take(Watch *watch)
{
    ProcessScan scan = {0};
    children_reap(watch);
    scan_processes(watch->walls, -1, &scan);
    watch->report->n_left = watch->walls->bwrap == NULL ? scan.n_processes : 0;
    return scan_take(watch) ? WATCH_LIMIT : WATCH_COMMAND_ENDED;
}

// Without mounts a run sees /work at a place of the machine that is another one each time, and
// nobody's business: what it prints names files as it does behind bubblewrap.
static void view_take_out(const char *view, SandboxReport *report)
{
    const size_t length = strlen(view);
    size_t n = 0;
    for (size_t i = 0; i < report->n_output;) {
        if (length > 0 && length <= report->n_output - i &&
            memcmp(report->output + i, view, length) == 0) {
            i += length;
        } else {
            report->output[n++] = report->output[i++];
        }
    }
    report->n_output = n;
}

_Noreturn void sandbox_supervise(Walls *walls, pid_t grader, SandboxReport *report)
{
    Watch watch = {.walls = walls, .report = report};
    clock_start(&watch.clock);
    const char *step = "cannot leave the grader's process";
    if (inheritance_leave(walls, grader) != 0 || walls_make(walls, &step) != 0) {
        fault_set(report, step);
    } else if (leader_start(&watch) != 0) {
        fault_set(report, "cannot start a process");
    } else {
        WatchEnd end = command_watch(&watch);
        if (end == WATCH_COMMAND_ENDED) {
            end = last_look_take(&watch);
        }
        processes_end(&watch);
        outcome_judge(&watch, end);
        view_take_out(walls->view, report);
    }
    walls_take_down(walls);
    report->is_complete = 1;
    _exit(0);
}

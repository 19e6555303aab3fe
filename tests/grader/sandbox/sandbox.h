// Running one command on code that must not be trusted: walls around it, limits on it.
//
// Three kinds of walls (tests/README.md, "The three sandboxes", also for what each cannot stop).
// Bubblewrap gives it a file system, a network and a process list of its own. The others are for
// hosts where that cannot be had, such as most containers, and need a grader that runs as root: the
// command becomes a user that nobody else is, and ends with all that this user runs. Landlock lets
// it open only what is named here. On kernels without that, the rights of files are all there is:
// it can read what every user of the machine can. Behind all stands one filter of system calls
// (sandbox_filter.c). Inside there is /usr (read-only), a private $TMPDIR and the folders asked
// for; no network, no home, no reference and no result of anybody. The parent folders of mounts
// must be passable by other users; while a run has it, a writable mount is closed to all others.
//
// Time: what counts is processor time, which is the same however busy the machine is, and time
// asleep, in which the command did not even ask for a processor. Wall time is a far backstop; where
// it strikes, neither of the two was used up: it was the machine, if the command was kept waiting
// for a processor (sandbox_clock.h).
#ifndef GRADER_SANDBOX_H
#define GRADER_SANDBOX_H

#include <stddef.h>

typedef enum SandboxKind {
    SANDBOX_BUBBLEWRAP,
    SANDBOX_LANDLOCK,
    SANDBOX_USER,  // a user of its own and the filter of system calls, no more
    SANDBOX_NONE,  // limits, but no walls: only when the instructor says so
    SANDBOX_ANY,   // for sandbox_choose(): the first that works here
} SandboxKind;

// "bubblewrap", "landlock", "user", "none" or "any".
const char *sandbox_kind_name(SandboxKind kind);

// Does the command become a user that only this run has?
int sandbox_has_own_user(SandboxKind kind);

// Can the command read and write what every user of this machine can?
int sandbox_is_open(SandboxKind kind);

// What a report has to say of walls that hide less than the others do, or NULL.
const char *sandbox_kind_note(SandboxKind kind);

// The kind of that name. Returns 0, or -1 when there is none.
int sandbox_kind_find(const char *name, SandboxKind *kind);

typedef struct SandboxMount {
    const char *outside;  // a folder or file of the host
    const char *inside;   // absolute path in the sandbox: without bubblewrap, a link to it below
                          // a folder of the run's own
    int writable;         // for one run at a time: given to the user that the command becomes.
                          // A mount that not everybody may read is opened to this user
} SandboxMount;

enum { SANDBOX_MAX_MOUNTS = 8 };

// Seconds of three kinds: what a command may use, or what it has used, all its processes together.
typedef struct SandboxTime {
    double processor;
    double asleep;  // nothing of it ran, or waited for a processor or a disk
    double wall;
} SandboxTime;

typedef struct SandboxCommand {
    SandboxKind kind;                // one that works here, see sandbox_choose()
    const char *const *argv;         // NULL-terminated; argv[0] begins with /usr or is relative
    const char *const *environment;  // NULL-terminated "NAME=value" besides the sandbox's own
    const char *folder;              // working directory inside, "/work"
    SandboxMount mounts[SANDBOX_MAX_MOUNTS];
    int n_mounts;
    SandboxTime time;  // it is killed when it has used up one of the three
    int memory_mb;     // address space of each process; beside a graphics card, whose drivers
                       // reserve far more than they use, its own writable memory. 0 = no limit
    int file_mb;       // the largest file it may write
    // Of all its processes together, at each look (sandbox_processes.h); 0 = no limit.
    int n_processes;      // processes and threads, bubblewrap's own one inside included
    int total_memory_mb;  // in use, not only reserved
    int total_file_mb;    // in writable mounts, in $TMPDIR, and in files removed while open
    int n_files;          // in writable mounts and $TMPDIR
} SandboxCommand;

// What all processes of any command may hold together, beyond its own limits. A look at a run reads
// a line for each mapping of memory and asks after each open file: these bound what a look costs,
// and what the kernel keeps for them, which nobody counts. The most that was seen of solutions,
// compilers and the address sanitizer is 375 mappings and 39 open files. NVIDIA's driver
// has 260 and 40; five hundred processes of a small program have 12 000 and 1500.
enum {
    SANDBOX_MAX_MAPPINGS = 16384,
    SANDBOX_MAX_OPEN_FILES = 4096,
};

typedef enum SandboxOutcome {
    SANDBOX_EXITED,     // by itself; see exit_status (127: argv[0] not found)
    SANDBOX_CRASHED,    // by a signal; see signal (SIGXFSZ: wrote more than file_mb). An exit
                        // code of 129 to 192 counts as one, as in a shell
    SANDBOX_TIMED_OUT,  // it used up its processor time: an endless loop
    SANDBOX_ASLEEP,     // it used up its time asleep: it waits for what never comes
    SANDBOX_STARVED,  // it used up its wall time, kept waiting for a processor: the machine's fault
    SANDBOX_OVERDUE,  // it used up its wall time, and was not
    SANDBOX_FORBIDDEN,  // by the filter of system calls: it asked for what no answer needs
    SANDBOX_EXCEEDED,   // a limit on all its processes together; see limit
    SANDBOX_FAULT,      // the sandbox could not be made: the machinery's fault, never the student's
} SandboxOutcome;

typedef enum SandboxLimit {
    SANDBOX_LIMIT_NONE,
    SANDBOX_LIMIT_PROCESSES,
    SANDBOX_LIMIT_MEMORY,
    SANDBOX_LIMIT_MAPPINGS,
    SANDBOX_LIMIT_OPEN_FILES,
    SANDBOX_LIMIT_BYTES,
    SANDBOX_LIMIT_FILES,
} SandboxLimit;

typedef struct SandboxResult {
    SandboxOutcome outcome;
    int exit_status;
    int signal;
    SandboxLimit limit;
    SandboxTime used;
    int n_left;  // processes that it left running and that were ended. Bubblewrap ends them itself,
                 // uncounted: there it is always 0
    unsigned long long n_printed;  // bytes, those that are not kept included
    // What it wrote to stdout and stderr, the first SANDBOX_MAX_OUTPUT bytes; of a SANDBOX_FAULT,
    // what went wrong. Control characters but newline and tab are replaced by '?', bytes beyond
    // ASCII stay as they were. NUL-terminated; owned, free() it.
    char *output;
} SandboxResult;

#define SANDBOX_MAX_OUTPUT 65536

// See which sandbox works here: the one that is wanted, or of SANDBOX_ANY the first of bubblewrap,
// Landlock and the users, after one line on stderr where it is not bubblewrap. Returns 0, or -1
// after one message on stderr that says why not and what to do.
int sandbox_choose(SandboxKind wanted, SandboxKind *kind);

// Start a command and return at once; NULL after one message on stderr when it could not be
// started. Several may run side by side. The thread that starts one must live until it has waited
// for it: what is inside dies with it.
typedef struct SandboxRun SandboxRun;
SandboxRun *sandbox_start(const SandboxCommand *command);

// Allow it other times than it was started with, also while it runs.
void sandbox_allow(SandboxRun *run, SandboxTime time);

// What it had used when it was looked at last, a moment ago.
SandboxTime sandbox_used(const SandboxRun *run);

// Has it ended, so that waiting for it takes no time?
int sandbox_has_ended(const SandboxRun *run);

// Wait for it; it and everything it started is gone afterwards. Frees `run`.
SandboxResult sandbox_wait(SandboxRun *run);

#endif

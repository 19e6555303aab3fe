// Running one command on code that must not be trusted: bubblewrap around it, limits on it.
//
// Inside there is /usr (read-only), a private /tmp and /proc, the folders asked for, and no
// network, no other process, no home, no reference and no result of anybody. Mounts must be
// readable by sandbox_user(), their parent folders included. Needs bubblewrap 0.8 or newer.
//
// What the limits do not bound: the memory of all its processes together (at most n_processes times
// memory_mb; a bound would need cgroups), and how much a writable mount takes in all.
#ifndef GRADER_SANDBOX_H
#define GRADER_SANDBOX_H

#include <stddef.h>

typedef struct SandboxMount {
    const char *outside;  // a folder or file of the host
    const char *inside;   // absolute path in the sandbox
    int writable;
} SandboxMount;

enum { SANDBOX_MAX_MOUNTS = 8 };

typedef struct SandboxCommand {
    const char *const *argv;         // NULL-terminated; argv[0] is an absolute path inside
    const char *const *environment;  // NULL-terminated "NAME=value" besides the sandbox's own
    const char *folder;              // working directory inside, "/work"
    SandboxMount mounts[SANDBOX_MAX_MOUNTS];
    int n_mounts;
    int wall_seconds;  // killed after that
    int cpu_seconds;   // of each process, a hard limit
    int memory_mb;     // address space of each process; 0 = no limit, as graphics drivers reserve
                       // far more than they use
    int file_mb;       // the largest file it may write
    int n_processes;   // processes and threads inside, bubblewrap's own one included; 0 = no limit.
                       // Linux before 5.14 counts all of sandbox_user()'s on the machine instead
} SandboxCommand;

typedef enum SandboxOutcome {
    SANDBOX_EXITED,     // by itself; see exit_status (127: argv[0] not found)
    SANDBOX_CRASHED,    // by a signal; see signal (SIGXFSZ: wrote more than file_mb). An exit
                        // code of 129 to 192 counts as one, as in a shell
    SANDBOX_TIMED_OUT,  // wall or CPU time
    SANDBOX_FAULT,      // the sandbox could not be made: the machinery's fault, never the student's
} SandboxOutcome;

typedef struct SandboxResult {
    SandboxOutcome outcome;
    int exit_status;
    int signal;
    // What it wrote to stdout and stderr, the first SANDBOX_MAX_OUTPUT bytes; of a SANDBOX_FAULT,
    // what went wrong. Control characters but newline and tab are replaced by '?', bytes beyond
    // ASCII stay as they were. NUL-terminated; owned, free() it.
    char *output;
} SandboxResult;

#define SANDBOX_MAX_OUTPUT 65536

// Can commands be sandboxed here? Returns 0, or -1 after one message on stderr that says why not
// and what to do (bubblewrap missing, user namespaces off).
int sandbox_check(void);

// The user a sandboxed command runs as, so that folders can be handed over with chown: the caller,
// or nobody (65534) where the caller is root.
unsigned sandbox_user(void);

// Start a command and return at once; NULL after one message on stderr when it could not be
// started. Several may run side by side. The thread that starts one must live until it has waited
// for it: what is inside dies with it.
typedef struct SandboxRun SandboxRun;
SandboxRun *sandbox_start(const SandboxCommand *command);

// Wait for it; it and everything it started is gone afterwards. Frees `run`.
SandboxResult sandbox_wait(SandboxRun *run);

#endif

// Which system calls a sandboxed command may not make.
//
// A list of what is denied, not of what is allowed: compilers, PoCL's LLVM and graphics drivers of
// any age and maker use hundreds of calls, and one missing from a list of allowed ones would cost a
// right answer its points. The walls are bubblewrap's namespaces, or the user and Landlock; the
// filter takes away what those leave open: sockets, which Landlock does not close, and the parts of
// the kernel in which most ways out of a sandbox were found. It also takes away what two runs in
// separate sandboxes could tell each other something by: both see the same read-only files, and a
// lock, a watch or a waiter on one of them is felt by the other. Read next: sandbox_walls.c.
//
// A number of 32 bits is compared as one: the kernel drops the rest, so would a caller's tricks.
//
// What only an attack asks for ends the process, so that the report can name it. What libraries try
// and can do without is refused with an error.
#include "sandbox_filter.h"

#include "sandbox_filter_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/close_range.h>
#include <linux/filter.h>
#include <linux/futex.h>
#include <linux/mempolicy.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

// Longer than any filter that is made here: the kernel's own bound.
enum { MAX_INSTRUCTIONS = 4096 };

#define N_ITEMS(array) (sizeof(array) / sizeof *(array))

// What ends a process. Kernels before 4.14, and gVisor, only know how to end one thread, which
// would leave the others waiting: there the call fails with SIGSYS, which ends a process unless it
// handles that signal.
static uint32_t fatal_action(void)
{
    const unsigned first_with_kill_process = 3;
    return seccomp_api_get() >= first_with_kill_process ? SCMP_ACT_KILL_PROCESS : SCMP_ACT_TRAP;
}

// Deny a list of calls. Those unknown to this machine or to an older libseccomp are none to deny.
static int calls_add(scmp_filter_ctx filter, uint32_t action, const char *const *names, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        int call = seccomp_syscall_resolve_name(names[i]);
        int fault = call != __NR_SCMP_ERROR ? seccomp_rule_add(filter, action, call, 0) : 0;
        if (fault != 0) {
            return fault;
        }
    }
    return 0;
}

// ---- Calls with certain arguments ---------------------------------------------------------------

#define NUMBER_MASK 0xffffffffU  // of 32 bits
#define SIGN (1U << 31)
#define FUTEX_MASK (NUMBER_MASK & ~(unsigned)FUTEX_CLOCK_REALTIME)
enum { N_FAMILIES = 64 };          // of sockets: the kernel has fewer
enum { PR_FUTEX_HASH_CALL = 78 };  // PR_FUTEX_HASH, which Linux 6.16 brought

// What a call's argument is, numbered from 0.
#define IS(argument, number) {argument, SCMP_CMP_MASKED_EQ, NUMBER_MASK, (unsigned)(number)}
#define HAS(argument, flags) {argument, SCMP_CMP_MASKED_EQ, flags, flags}
#define IS_NOT_0(argument) {argument, SCMP_CMP_NE, 0, 0}

// Which action is the end of a process depends on the kernel: see fatal_action().
#define FATAL SCMP_ACT_KILL_PROCESS
#define REFUSED(error) SCMP_ACT_ERRNO(error)

typedef struct Rule {
    uint32_t action;
    int call;
    struct scmp_arg_cmp arguments[2];  // all of these; behind the last one zeros
} Rule;

static const Rule rules[] = {
    // Pairs of connected sockets could each keep megabytes in the kernel that no look finds. Of
    // other sockets: sockets_add().
    {REFUSED(EACCES), SCMP_SYS(socketpair), {{0}}},
    {REFUSED(EACCES), SCMP_SYS(socket), {{0, SCMP_CMP_GE, N_FAMILIES, 0}}},

    // Ways to make a process that is in namespaces of its own. clone3's flags stand in memory,
    // where no filter can look; the C library falls back to clone().
    {REFUSED(ENOSYS), SCMP_SYS(clone3), {{0}}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWNS)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWUTS)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWIPC)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWUSER)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWPID)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWNET)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_NEWCGROUP)}},
    // Who waits for its own vfork() looks like who waits for a disk. The scan tells them apart by
    // the child, so that has to be one of its own, and no thread.
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_PARENT)}},
    {FATAL, SCMP_SYS(clone), {HAS(0, CLONE_VFORK | CLONE_THREAD)}},

    // Children whose end is ignored leave no trace of the processor time that they used. Nobody may
    // say what shall become of SIGCHLD: it is left as it is by default, and they are waited for.
    {REFUSED(EPERM), SCMP_SYS(rt_sigaction), {IS(0, SIGCHLD), IS_NOT_0(1)}},

    // A thread has the descriptors of its process and no table of its own: the scan looks at one.
    {REFUSED(EPERM),
     SCMP_SYS(clone),
     {{0, SCMP_CMP_MASKED_EQ, CLONE_THREAD | CLONE_FILES, CLONE_THREAD}}},
    {REFUSED(EPERM), SCMP_SYS(close_range), {HAS(2, CLOSE_RANGE_UNSHARE)}},

    // Locks on a file, leases and watches.
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_GETLK)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_SETLK)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_SETLKW)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_OFD_GETLK)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_OFD_SETLK)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_OFD_SETLKW)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_SETLEASE)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_GETLEASE)}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_NOTIFY)}},

    // Waiting at an address in a file, where a process of another run that maps it can wake us. A
    // wait that is not marked as the process's own ends at once, as if the value had changed: who
    // waits looks again. Of the C library that is only pthread_join(), which then asks on and on.
    {REFUSED(EAGAIN), SCMP_SYS(futex), {{1, SCMP_CMP_MASKED_EQ, FUTEX_MASK, FUTEX_WAIT}}},
    {REFUSED(EAGAIN), SCMP_SYS(futex), {{1, SCMP_CMP_MASKED_EQ, FUTEX_MASK, FUTEX_WAIT_BITSET}}},
    {REFUSED(EAGAIN),
     SCMP_SYS(futex),
     {{1, SCMP_CMP_MASKED_EQ, FUTEX_MASK, FUTEX_WAIT_REQUEUE_PI}}},

    // The processor time of other processes has clocks with negative numbers.
    {REFUSED(EINVAL), SCMP_SYS(clock_gettime), {HAS(0, SIGN)}},
    {REFUSED(EINVAL), SCMP_SYS(clock_getres), {HAS(0, SIGN)}},
    {REFUSED(EINVAL), SCMP_SYS(clock_nanosleep), {HAS(0, SIGN)}},
    {REFUSED(EINVAL), SCMP_SYS(timer_create), {HAS(0, SIGN)}},

    // What these say of a process is asked of oneself by the number 0. The C library lives without
    // the processors of another thread only where there is no such call.
    {REFUSED(ENOSYS), SCMP_SYS(sched_getaffinity), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(sched_getattr), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(sched_getparam), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(sched_getscheduler), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(getpgid), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(getsid), {IS_NOT_0(0)}},
    {REFUSED(ENOSYS), SCMP_SYS(sched_rr_get_interval), {IS_NOT_0(0)}},

    // Filters of the run's own, and a table of futexes for the process: memory of the kernel's that
    // no look finds. Whose call is handed to a listener passes for who waits for a disk.
    {REFUSED(EINVAL), SCMP_SYS(prctl), {IS(0, PR_SET_SECCOMP)}},
    {REFUSED(EINVAL), SCMP_SYS(prctl), {IS(0, PR_FUTEX_HASH_CALL)}},

    // Files each write to which waits. O_DSYNC is a part of O_SYNC; newer kinds of machines have no
    // open(); the flags of openat2() stand in memory, where no filter can look.
    {REFUSED(EPERM), SCMP_SYS(openat), {HAS(2, O_DSYNC)}},
    {REFUSED(EPERM), SCMP_SYS(open), {HAS(1, O_DSYNC)}},
    {REFUSED(EPERM), SCMP_SYS(openat), {HAS(2, O_DIRECT)}},
    {REFUSED(EPERM), SCMP_SYS(open), {HAS(1, O_DIRECT)}},
    {REFUSED(ENOSYS), SCMP_SYS(openat2), {{0}}},
    {REFUSED(EPERM), SCMP_SYS(fcntl), {IS(1, F_SETFL), HAS(2, O_DIRECT)}},

    // Moving pages waits in the kernel as for a disk, again and again for little processor time.
    {REFUSED(EPERM), SCMP_SYS(mbind), {HAS(5, MPOL_MF_MOVE)}},
    {REFUSED(EPERM), SCMP_SYS(mbind), {HAS(5, MPOL_MF_MOVE_ALL)}},
};

// Returns 0, or a negative errno, as all below.
static int rule_add(scmp_filter_ctx filter, const Rule *rule)
{
    unsigned n = 0;
    while (n < N_ITEMS(rule->arguments) && rule->arguments[n].op != 0) {
        n++;
    }
    const uint32_t action = rule->action == FATAL ? fatal_action() : rule->action;
    // A negative number: this machine has no such call.
    return rule->call < 0 ? 0
                          : seccomp_rule_add_array(filter, action, rule->call, n, rule->arguments);
}

// Internet sockets end the process. All others are refused: libraries ask for a local socket to
// talk to a name service, or for netlink, and live without.
static int sockets_add(scmp_filter_ctx filter)
{
    int fault = 0;
    for (unsigned family = 0; fault == 0 && family < N_FAMILIES; family++) {
        const int is_fatal = family == AF_INET || family == AF_INET6 || family == AF_PACKET;
        fault = seccomp_rule_add(filter, is_fatal ? fatal_action() : REFUSED(EACCES),
                                 SCMP_SYS(socket), 1, SCMP_A0(SCMP_CMP_EQ, family));
    }
    return fault;
}

// Calls that Linux 5.16 and later brought, up to where x32's begin, are not known: among them
// cachestat, statmount, listmount and futexes of a new kind. Every library has to do without them
// on the systems of its day.
static int unknown_calls_add(scmp_filter_ctx filter)
{
    enum { FIRST_UNKNOWN_CALL = 449, END_OF_UNKNOWN_CALLS = 512 };
    int fault = 0;
    for (int call = FIRST_UNKNOWN_CALL; fault == 0 && call < END_OF_UNKNOWN_CALLS; call++) {
        fault = seccomp_rule_add(filter, REFUSED(ENOSYS), call, 0);
    }
    return fault;
}

// ---- All ----------------------------------------------------------------------------------------

static int rules_add(scmp_filter_ctx filter)
{
    // 32-bit and x32 calls have other numbers, and no program here is built for them.
    int fault = seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, fatal_action());
    if (fault == 0) {
        fault = calls_add(filter, fatal_action(), fatal_calls, N_ITEMS(fatal_calls));
    }
    if (fault == 0) {
        fault = calls_add(filter, REFUSED(EPERM), refused_calls, N_ITEMS(refused_calls));
    }
    if (fault == 0) {
        fault = calls_add(filter, REFUSED(0), needless_calls, N_ITEMS(needless_calls));
    }
    for (size_t i = 0; fault == 0 && i < N_ITEMS(rules); i++) {
        fault = rule_add(filter, &rules[i]);
    }
    if (fault == 0) {
        fault = sockets_add(filter);
    }
    if (fault == 0) {
        fault = unknown_calls_add(filter);
    }
    return fault;
}

int filter_open(void)
{
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    if (filter == NULL) {
        errno = ENOMEM;
        return -1;
    }
    int descriptor = memfd_create("filter", MFD_CLOEXEC);
    int fault = descriptor < 0 ? -errno : rules_add(filter);
    if (fault == 0) {
        fault = seccomp_export_bpf(filter, descriptor);
    }
    seccomp_release(filter);
    // Out of the way of the standard descriptors, which a grader may have closed.
    int result = fault == 0 && lseek(descriptor, 0, SEEK_SET) == 0
                     ? fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                     : -1;
    if (descriptor >= 0) {
        close(descriptor);
    }
    errno = fault != 0 ? -fault : errno;
    return result;
}

int filter_enter(int descriptor)
{
    static struct sock_filter instructions[MAX_INSTRUCTIONS];
    ssize_t n_bytes = read(descriptor, instructions, sizeof instructions);
    if (n_bytes <= 0 || n_bytes == sizeof instructions) {
        errno = EIO;
        return -1;
    }
    struct sock_fprog program = {
        .len = (unsigned short)((size_t)n_bytes / sizeof *instructions),
        .filter = instructions,
    };
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
}

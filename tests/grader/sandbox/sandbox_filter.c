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

// Flags of open() that make each write wait. O_DSYNC is a part of O_SYNC.
static const unsigned waiting_flags[] = {O_DSYNC, O_DIRECT};

// Ways to make a process that is in namespaces of its own.
static const unsigned namespace_flags[] = {
    CLONE_NEWNS,  CLONE_NEWUTS, CLONE_NEWIPC,    CLONE_NEWUSER,
    CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWCGROUP,
};

// Calls that Linux 5.16 and later brought, up to where x32's begin, are not known: among them
// cachestat, statmount, listmount and futexes of a new kind. Every library has to do without them
// on the systems of its day.
enum { FIRST_UNKNOWN_CALL = 449, END_OF_UNKNOWN_CALLS = 512 };

// fcntl's locks on a file, leases and watches.
static const int file_commands[] = {
    F_GETLK,      F_SETLK,    F_SETLKW,   F_OFD_GETLK, F_OFD_SETLK,
    F_OFD_SETLKW, F_SETLEASE, F_GETLEASE, F_NOTIFY,
};

// Waiting at an address in a file, where a process of another run that maps it can wake us.
static const unsigned shared_waits[] = {FUTEX_WAIT, FUTEX_WAIT_BITSET, FUTEX_WAIT_REQUEUE_PI};

#define NUMBER_MASK 0xffffffffU  // of 32 bits

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

// Internet sockets end the process. All others are refused: libraries ask for a local socket to
// talk to a name service, or for netlink, and live without. Pairs of connected sockets are, too, as
// each could keep megabytes in the kernel that no look finds.
static int sockets_add(scmp_filter_ctx filter)
{
    const unsigned n_families = 64;  // the kernel has fewer
    int fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), SCMP_SYS(socketpair), 0);
    fault = fault != 0 ? fault
                       : seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), SCMP_SYS(socket), 1,
                                          SCMP_A0(SCMP_CMP_GE, n_families));
    for (unsigned family = 0; fault == 0 && family < n_families; family++) {
        int is_fatal = family == AF_INET || family == AF_INET6 || family == AF_PACKET;
        fault = seccomp_rule_add(filter, is_fatal ? fatal_action() : SCMP_ACT_ERRNO(EACCES),
                                 SCMP_SYS(socket), 1, SCMP_A0(SCMP_CMP_EQ, family));
    }
    return fault;
}

static int clone_add(scmp_filter_ctx filter)
{
    // Its flags stand in memory, where no filter can look. The C library falls back to clone().
    int fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
    for (size_t i = 0; fault == 0 && i < N_ITEMS(namespace_flags); i++) {
        fault =
            seccomp_rule_add(filter, fatal_action(), SCMP_SYS(clone), 1,
                             SCMP_A0(SCMP_CMP_MASKED_EQ, namespace_flags[i], namespace_flags[i]));
    }
    // Who waits for its own vfork() looks like who waits for a disk. The census tells them apart by
    // the child, so that has to be one of its own, and no thread.
    const unsigned hidden_waits[] = {CLONE_PARENT, CLONE_VFORK | CLONE_THREAD};
    for (size_t i = 0; fault == 0 && i < N_ITEMS(hidden_waits); i++) {
        fault = seccomp_rule_add(filter, fatal_action(), SCMP_SYS(clone), 1,
                                 SCMP_A0(SCMP_CMP_MASKED_EQ, hidden_waits[i], hidden_waits[i]));
    }
    return fault;
}

// Children whose end is ignored leave no trace of the processor time that they used. Nobody may
// say what shall become of SIGCHLD: it is left as it is by default, and they are waited for.
static int ended_children_add(scmp_filter_ctx filter)
{
    return seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(rt_sigaction), 2,
                            SCMP_A0(SCMP_CMP_MASKED_EQ, NUMBER_MASK, SIGCHLD),
                            SCMP_A1(SCMP_CMP_NE, 0));
}

static int unknown_calls_add(scmp_filter_ctx filter)
{
    int fault = 0;
    for (int call = FIRST_UNKNOWN_CALL; fault == 0 && call < END_OF_UNKNOWN_CALLS; call++) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), call, 0);
    }
    return fault;
}

static int file_commands_add(scmp_filter_ctx filter)
{
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(file_commands); i++) {
        fault =
            seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(fcntl), 1,
                             SCMP_A1(SCMP_CMP_MASKED_EQ, NUMBER_MASK, (unsigned)file_commands[i]));
    }
    return fault;
}

// A wait that is not marked as the process's own ends at once, as if the value had changed: who
// waits looks again. Of the C library that is only pthread_join(), which then asks on and on.
static int shared_waits_add(scmp_filter_ctx filter)
{
    const unsigned mask = NUMBER_MASK & ~(unsigned)FUTEX_CLOCK_REALTIME;
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(shared_waits); i++) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EAGAIN), SCMP_SYS(futex), 1,
                                 SCMP_A1(SCMP_CMP_MASKED_EQ, mask, shared_waits[i]));
    }
    return fault;
}

// A thread has the descriptors of its process and no table of its own: the census looks at one.
static int own_tables_add(scmp_filter_ctx filter)
{
    int fault =
        seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                         SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD | CLONE_FILES, CLONE_THREAD));
    return fault != 0 ? fault
                      : seccomp_rule_add(
                            filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(close_range), 1,
                            SCMP_A2(SCMP_CMP_MASKED_EQ, CLOSE_RANGE_UNSHARE, CLOSE_RANGE_UNSHARE));
}

// The processor time of other processes has clocks with negative numbers.
static int clocks_add(scmp_filter_ctx filter)
{
    const unsigned sign = 1U << 31;
    const int calls[] = {SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(clock_nanosleep),
                         SCMP_SYS(timer_create)};
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(calls); i++) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), calls[i], 1,
                                 SCMP_A0(SCMP_CMP_MASKED_EQ, sign, sign));
    }
    return fault;
}

// What these say of a process is asked of oneself by the number 0. The C library lives without the
// processors of another thread only where there is no such call.
static int questions_add(scmp_filter_ctx filter)
{
    const int calls[] = {
        SCMP_SYS(sched_getaffinity),    SCMP_SYS(sched_getattr), SCMP_SYS(sched_getparam),
        SCMP_SYS(sched_getscheduler),   SCMP_SYS(getpgid),       SCMP_SYS(getsid),
        SCMP_SYS(sched_rr_get_interval)};
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(calls); i++) {
        fault =
            seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), calls[i], 1, SCMP_A0(SCMP_CMP_NE, 0));
    }
    return fault;
}

// Filters of the run's own, and a table of futexes for the process: memory of the kernel's that no
// look finds. Whose call is handed to a listener passes for who waits for a disk.
static int process_options_add(scmp_filter_ctx filter)
{
    const unsigned futex_table = 78;  // PR_FUTEX_HASH, which Linux 6.16 brought
    const unsigned options[] = {PR_SET_SECCOMP, futex_table};
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(options); i++) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1,
                                 SCMP_A0(SCMP_CMP_MASKED_EQ, NUMBER_MASK, options[i]));
    }
    return fault;
}

// Moving pages waits in the kernel as for a disk, again and again for little processor time.
static int page_moves_add(scmp_filter_ctx filter)
{
    const unsigned flags[] = {MPOL_MF_MOVE, MPOL_MF_MOVE_ALL};
    int fault = 0;
    for (size_t i = 0; fault == 0 && i < N_ITEMS(flags); i++) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(mbind), 1,
                                 SCMP_A5(SCMP_CMP_MASKED_EQ, flags[i], flags[i]));
    }
    return fault;
}

static int disk_waits_add(scmp_filter_ctx filter)
{
    int fault = calls_add(filter, SCMP_ACT_ERRNO(0), needless_calls, N_ITEMS(needless_calls));
    for (size_t i = 0; fault == 0 && i < N_ITEMS(waiting_flags); i++) {
        const unsigned flag = waiting_flags[i];
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(openat), 1,
                                 SCMP_A2(SCMP_CMP_MASKED_EQ, flag, flag));
        // Newer kinds of machines have no open().
        if (fault == 0 && SCMP_SYS(open) >= 0) {
            fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(open), 1,
                                     SCMP_A1(SCMP_CMP_MASKED_EQ, flag, flag));
        }
    }
    // Its flags stand in memory, where no filter can look.
    if (fault == 0) {
        fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(openat2), 0);
    }
    return fault != 0 ? fault
                      : seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(fcntl), 2,
                                         SCMP_A1(SCMP_CMP_MASKED_EQ, NUMBER_MASK, F_SETFL),
                                         SCMP_A2(SCMP_CMP_MASKED_EQ, O_DIRECT, O_DIRECT));
}

typedef int RulesAdd(scmp_filter_ctx filter);

// Those that look at a call's arguments, and calls without a name.
static RulesAdd *const special_rules[] = {
    sockets_add,       clone_add,           ended_children_add, own_tables_add,
    unknown_calls_add, file_commands_add,   shared_waits_add,   clocks_add,
    questions_add,     process_options_add, disk_waits_add,     page_moves_add};

// Returns 0, or a negative errno.
static int rules_add(scmp_filter_ctx filter)
{
    // 32-bit and x32 calls have other numbers, and no program here is built for them.
    int fault = seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, fatal_action());
    if (fault == 0) {
        fault = calls_add(filter, fatal_action(), fatal_calls, N_ITEMS(fatal_calls));
    }
    if (fault == 0) {
        fault = calls_add(filter, SCMP_ACT_ERRNO(EPERM), refused_calls, N_ITEMS(refused_calls));
    }
    for (size_t i = 0; fault == 0 && i < N_ITEMS(special_rules); i++) {
        fault = special_rules[i](filter);
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

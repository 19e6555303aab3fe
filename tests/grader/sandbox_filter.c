// Which system calls a sandboxed command may not make.
//
// A list of what is denied, not of what is allowed: compilers, PoCL's LLVM and graphics drivers of
// any age and maker use hundreds of calls, and one missing from a list of allowed ones would cost a
// right answer its points. The walls are bubblewrap's namespaces, or the user and Landlock; the
// filter takes away what those leave open: sockets, which Landlock does not close, and the parts of
// the kernel in which most ways out of a sandbox were found. Read next: sandbox_walls.c.
//
// What only an attack asks for ends the process, so that the report can name it. What libraries try
// and can do without is refused with an error.
#include "sandbox_filter.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <stddef.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

// Longer than any filter that is made here: the kernel's own bound.
enum { MAX_INSTRUCTIONS = 4096 };

static const char *const fatal_calls[] = {
    // Other processes, and the kernel's ways to watch them.
    "ptrace",
    "process_vm_readv",
    "process_vm_writev",
    "pidfd_getfd",
    "perf_event_open",
    "bpf",
    // Namespaces and mounts.
    "unshare",
    "setns",
    "mount",
    "umount2",
    "pivot_root",
    "chroot",
    "open_tree",
    "move_mount",
    "fsopen",
    "fsconfig",
    "fsmount",
    "fspick",
    "mount_setattr",
    "open_by_handle_at",
    // Parts of the kernel that many ways out began in; io_uring also goes around this filter.
    "io_uring_setup",
    "io_uring_enter",
    "io_uring_register",
    "userfaultfd",
    "keyctl",
    "add_key",
    "request_key",
    // The machine.
    "kexec_load",
    "kexec_file_load",
    "init_module",
    "finit_module",
    "delete_module",
    "reboot",
    "swapon",
    "swapoff",
};

static const char *const refused_calls[] = {
    // Memory and messages that would outlive the run.
    "shmget",
    "shmat",
    "shmctl",
    "semget",
    "semop",
    "semtimedop",
    "semctl",
    "msgget",
    "msgsnd",
    "msgrcv",
    "msgctl",
    "mq_open",
    "mq_unlink",
    // Of no use without rights that nobody inside has.
    "personality",
    "acct",
    "quotactl",
    "syslog",
    "ioperm",
    "iopl",
    "settimeofday",
    "clock_settime",
    "vhangup",
    "fanotify_init",
    "lookup_dcookie",
    "kcmp",
    "name_to_handle_at",
    "sethostname",
    "setdomainname",
};

// Ways to make a process that is in namespaces of its own.
static const unsigned namespace_flags[] = {
    CLONE_NEWNS,  CLONE_NEWUTS, CLONE_NEWIPC,    CLONE_NEWUSER,
    CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWCGROUP,
};

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
// talk to a name service, or for netlink, and live without. Pairs of connected sockets are allowed.
static int sockets_add(scmp_filter_ctx filter)
{
    const unsigned n_families = 64;  // the kernel has fewer
    int fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), SCMP_SYS(socket), 1,
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
    return fault;
}

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
    if (fault == 0) {
        fault = sockets_add(filter);
    }
    return fault == 0 ? clone_add(filter) : fault;
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

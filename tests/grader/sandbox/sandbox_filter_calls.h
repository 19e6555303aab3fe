// The system calls that a sandboxed command may not make, whatever their arguments.
#ifndef GRADER_SANDBOX_FILTER_CALLS_H
#define GRADER_SANDBOX_FILTER_CALLS_H

// What only an attack asks for: it ends the process.
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

// What libraries try and can do without: an error.
static const char *const refused_calls[] = {
    // Locks and watches on files that another run sees, too; so do some commands
    // of fcntl's (`rules` in sandbox_filter.c).
    "flock",
    "inotify_init",
    "inotify_init1",
    "inotify_add_watch",
    "fanotify_init",
    "fanotify_mark",
    // What of a file is in memory: another run reads it, or drops it, and this one sees that.
    "mincore",
    "preadv2",
    "pwritev2",
    "readahead",
    "fadvise64",
    // How full a disk is that others write to.
    "statfs",
    "fstatfs",
    "ustat",
    // Other processes, whose numbers are seen where there is no namespace.
    "pidfd_open",
    "pidfd_send_signal",
    "getpriority",
    "setpriority",
    "ioprio_get",
    "ioprio_set",
    "move_pages",
    "migrate_pages",
    "process_madvise",
    "process_mrelease",
    // Files that no look at the run's folders and descriptors finds: in memory without a name, and
    // on the way from one process to another, which is what these two send beyond bytes.
    "memfd_create",
    "memfd_secret",
    "sendmsg",
    "sendmmsg",
    // What puts pages into pipes, where they are nobody's memory any more: of a byte the kernel
    // keeps the page around it, and of a large page all 2 MB.
    "vmsplice",
    "splice",
    "tee",
    "sendfile",
    // Walls of the run's own: a rule keeps a removed file where no look finds it, and each rule
    // and each wall some memory of the kernel's. Ours are up before the filter.
    "landlock_create_ruleset",
    "landlock_add_rule",
    "landlock_restrict_self",
    "seccomp",
    // Waits in the kernel as who waits for a disk does, and costs no processor time.
    "membarrier",
    // Requests to disks that the kernel keeps, of which the machine has one small number for all.
    "io_setup",
    // Names by which sockets of other runs are found, or seen to be there.
    "bind",
    "connect",
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
    "mq_timedsend",
    "mq_timedreceive",
    "mq_notify",
    "mq_getsetattr",
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
    "modify_ldt",
    "lookup_dcookie",
    "kcmp",
    "name_to_handle_at",
    "sethostname",
    "setdomainname",
};

// Waiting for the disk costs neither processor time nor sleep, so a run could wait until the grader
// itself is out of time; and how long it takes tells of what others write. Nothing in a run has to
// outlive the machine. Who chooses to run after all others, or on one processor of many, keeps
// itself waiting, which would pass for the machine's fault. These say that it is done.
static const char *const needless_calls[] = {
    "sync",  "syncfs",        "fsync",          "fdatasync",          "sync_file_range",
    "msync", "sched_setattr", "sched_setparam", "sched_setscheduler", "sched_setaffinity",
};

#endif

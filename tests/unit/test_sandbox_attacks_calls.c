// grader/sandbox: calls that only an attack makes, behind every kind of walls.
#include "sandbox_commands.h"

#include <arpa/inet.h>
#include <linux/sched.h>
#include <sys/file.h>
#include <sys/syscall.h>

TEST_EACH(the_network_is_unreachable_even_on_this_machine)
{
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t n_bytes = sizeof address;
    cr_assert_eq(bind(listener, (struct sockaddr *)&address, n_bytes), 0);
    cr_assert_eq(listen(listener, 4), 0);
    cr_assert_eq(getsockname(listener, (struct sockaddr *)&address, &n_bytes), 0);

    char script[128];
    snprintf(script, sizeof script, "exec bash -c 'exec 3<>/dev/tcp/127.0.0.1/%d'",
             ntohs(address.sin_port));
    cr_assert_eq(exit_status_outside(script), 0);
    expect_forbidden(shell_run(script), "a connection");
    cr_assert_eq(accept4(listener, NULL, NULL, SOCK_CLOEXEC) >= 0, 1);  // the test's own
    cr_assert_eq(fcntl(listener, F_SETFL, O_NONBLOCK), 0);
    cr_expect_lt(accept4(listener, NULL, NULL, SOCK_CLOEXEC), 0, "it was reached from inside");
    close(listener);
}

TEST_EACH(what_only_an_attack_asks_for_ends_it)
{
    const struct {
        const char *name;
        long call, arguments[2];
    } attacks[] = {
        {"socket(AF_INET6)", SYS_socket, {AF_INET6, SOCK_DGRAM}},
        {"socket(AF_PACKET)", SYS_socket, {AF_PACKET, SOCK_RAW}},
        {"ptrace", SYS_ptrace, {0, 0}},
        {"process_vm_readv", SYS_process_vm_readv, {1, 0}},
        {"io_uring_setup", SYS_io_uring_setup, {8, 0}},
        {"unshare(CLONE_NEWUSER)", SYS_unshare, {CLONE_NEWUSER, 0}},
        {"clone(CLONE_NEWUSER)", SYS_clone, {CLONE_NEWUSER | SIGCHLD, 0}},
        {"clone(CLONE_PARENT)", SYS_clone, {CLONE_PARENT | SIGCHLD, 0}},
        {"clone(CLONE_VFORK | CLONE_THREAD)",
         SYS_clone,
         {CLONE_VM | CLONE_SIGHAND | CLONE_FILES | CLONE_VFORK | CLONE_THREAD, 0}},
        {"setns", SYS_setns, {0, 0}},
        {"mount", SYS_mount, {0, 0}},
        {"bpf", SYS_bpf, {0, 0}},
        {"perf_event_open", SYS_perf_event_open, {0, 0}},
        {"userfaultfd", SYS_userfaultfd, {0, 0}},
        {"keyctl", SYS_keyctl, {0, 0}},
        {"open_by_handle_at", SYS_open_by_handle_at, {0, 0}},
        {"kexec_load", SYS_kexec_load, {0, 0}},
        {"init_module", SYS_init_module, {0, 0}},
        {"reboot", SYS_reboot, {0, 0}},  // without its magic numbers: an error outside
        {"swapoff", SYS_swapoff, {0, 0}},
    };
    for (size_t i = 0; i < sizeof attacks / sizeof *attacks; i++) {
        char program[128];
        snprintf(program, sizeof program, "syscall(%ld, %ld, %ld, 0, 0, 0); print 1",
                 attacks[i].call, attacks[i].arguments[0], attacks[i].arguments[1]);
        expect_forbidden(perl_run(program), attacks[i].name);
    }
}

TEST_EACH(what_libraries_can_do_without_is_refused)
{
    const struct {
        const char *name;
        long call, arguments[3];
    } calls[] = {
        {"socket(AF_UNIX)", SYS_socket, {AF_UNIX, SOCK_STREAM, 0}},
        {"socket(AF_NETLINK)", SYS_socket, {AF_NETLINK, SOCK_RAW, 0}},
        {"shmget", SYS_shmget, {0, 4096, 01600}},
        {"msgget", SYS_msgget, {0, 01600, 0}},
        {"clone3", SYS_clone3, {0, 0, 0}},
        {"personality", SYS_personality, {0, 0, 0}},
        // What two runs could tell each other something by. Descriptors 0 to 2 are there.
        {"flock", SYS_flock, {0, LOCK_SH, 0}},
        {"fcntl(F_GETLEASE)", SYS_fcntl, {0, F_GETLEASE, 0}},
        {"fcntl(F_GETLEASE) and junk", SYS_fcntl, {0, F_GETLEASE | 1L << 32, 0}},
        {"inotify_init1", SYS_inotify_init1, {0, 0, 0}},
        {"getpriority", SYS_getpriority, {0, 0, 0}},
        {"clock_gettime of process 1", SYS_clock_gettime, {-14, 0, 0}},
        {"timer_create by the clock of process 1", SYS_timer_create, {-14, 0, 0}},
        {"getsid of process 1", SYS_getsid, {1, 0, 0}},
        {"sched_getscheduler of process 1", SYS_sched_getscheduler, {1, 0, 0}},
        {"futex_waitv", SYS_futex_waitv, {0, 0, 0}},
        // What no look at the run finds.
        {"memfd_create", SYS_memfd_create, {0, 0, 0}},
        {"close_range(CLOSE_RANGE_UNSHARE)", SYS_close_range, {100, 200, 2}},
        {"a thread with descriptors of its own",
         SYS_clone,
         {CLONE_VM | CLONE_SIGHAND | CLONE_THREAD, 0, 0}},
    };
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        char program[128];
        snprintf(program, sizeof program, "exit(syscall(%ld, %ld, %ld, %ld) < 0 ? 7 : 0)",
                 calls[i].call, calls[i].arguments[0], calls[i].arguments[1],
                 calls[i].arguments[2]);
        SandboxResult result = perl_run(program);
        cr_expect_eq(result.exit_status, 7, "%s: outcome %d", calls[i].name, result.outcome);
        free(result.output);
    }
}

// Locks, leases and watches on files that two runs see, what else each could ask about them, and
// what keeps pages or requests in the kernel that are nobody's memory: refused as calls that are
// not there or not allowed, not for what their arguments were.
TEST_EACH(what_two_runs_could_signal_by_or_the_kernel_would_keep_is_refused)
{
    enum { CACHESTAT = 451, STATMOUNT = 457, LISTMOUNT = 458 };  // newer than some headers
    static const long calls[][3] = {
        {SYS_flock, 0, LOCK_SH},
        {SYS_fcntl, 0, F_GETLK},
        {SYS_fcntl, 0, F_SETLK},
        {SYS_fcntl, 0, F_SETLKW},
        {SYS_fcntl, 0, F_OFD_GETLK},
        {SYS_fcntl, 0, F_OFD_SETLK},
        {SYS_fcntl, 0, F_OFD_SETLKW},
        {SYS_fcntl, 0, F_SETLEASE},
        {SYS_fcntl, 0, F_GETLEASE},
        {SYS_fcntl, 0, F_NOTIFY},
        {SYS_bind, 0, 0},
        {SYS_connect, 0, 0},
        {SYS_inotify_init1, 0, 0},
        {SYS_inotify_add_watch, 0, 0},
        {SYS_fanotify_init, 0, 0},
        {SYS_fanotify_mark, 0, 0},
        {SYS_preadv2, 0, 0},
        {SYS_memfd_create, 0, 0},
        {SYS_mincore, 0, 0},
        {SYS_vmsplice, 0, 0},
        {SYS_splice, 0, 0},
        {SYS_tee, 0, 0},
        {SYS_sendfile, 0, 0},
        {SYS_io_setup, 0, 0},
        {CACHESTAT, 0, 0},
        {STATMOUNT, 0, 0},
        {LISTMOUNT, 0, 0},
    };
    char program[2048] = "for (";
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        const size_t length = strlen(program);
        snprintf(program + length, sizeof program - length, "[%ld,%ld,%ld],", calls[i][0],
                 calls[i][1], calls[i][2]);
    }
    // EPERM or ENOSYS.
    strcat(program, ") { $r = syscall($_->[0], $_->[1], $_->[2], 0, 0, 0);"
                    " print qq(@$_: $r, $!;) unless $r < 0 && ($! == 1 || $! == 38) }");
    SandboxResult result = perl_run(program);
    cr_expect_str_eq(result.output, "");
    expect_exit(result, 0);
}

// One socket of a pair could send to a name that another run has, and both keep what is sent.
TEST_EACH(there_are_no_pairs_of_sockets)
{
    expect_exit(perl_run("use Socket; exit(!socketpair(my $a, my $b, AF_UNIX, SOCK_DGRAM, 0) && "
                         "$!{EACCES} ? 7 : 0)"),
                7);
}

// Who stands back behind others, or hides what its children use, would pass for starved.
TEST_EACH(nobody_chooses_to_wait_or_hides_the_time_of_its_children)
{
    char program[160];
    // 5 is SCHED_IDLE: what is said to be done is not.
    snprintf(program, sizeof program,
             "$p = pack('i', 0); exit(syscall(%d, 0, 5, $p) == 0 && syscall(%d, 0) == 0 ? 7 : 0)",
             SYS_sched_setscheduler, SYS_sched_getscheduler);
    expect_exit(perl_run(program), 7);
    expect_exit(perl_run("$SIG{CHLD} = 'IGNORE'; exit(system('true') == 0 ? 7 : 0)"), 7);
    expect_exit(perl_run("open(F, '+<', '/proc/self/autogroup') or exit 7; "
                         "syswrite(F, '19') or exit 7"),
                tested_kind == SANDBOX_USER ? 0 : 7);
}

// A file that each call would have to wait for: who asks for that is told at once that it is done.
TEST_EACH(nobody_waits_for_the_disk)
{
    const long calls[] = {SYS_sync, SYS_syncfs, SYS_fsync, SYS_fdatasync};
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        char program[128];
        // Descriptor 99 is not there: outside of a sandbox most of these calls fail.
        snprintf(program, sizeof program, "exit(syscall(%ld, 99) == 0 ? 7 : 0)", calls[i]);
        SandboxResult result = perl_run(program);
        cr_expect_eq(result.exit_status, 7, "call %ld: outcome %d", calls[i], result.outcome);
        free(result.output);
    }
    // 010000 is O_DSYNC, 01 O_WRONLY.
    SandboxResult result =
        perl_run("exit(sysopen(F, \"/dev/null\", 010001) ? 0 : sysopen(F, \"/dev/null\", 01) "
                 "? 7 : 0)");
    cr_expect_eq(result.exit_status, 7, "O_DSYNC: outcome %d", result.outcome);
    free(result.output);
}

#ifdef __x86_64__
// The same calls by their numbers in other ABIs: getpid as a 32-bit call, and as an x32 one.
TEST_EACH(calls_of_other_abis_end_it)
{
    const char *source =
        "int main(void) { int id; __asm__ volatile(\"int $0x80\" : \"=a\"(id) : \"a\"(20)); "
        "return id < 0; }\n";
    file_write("abi.c", source, strlen(source));
    cr_assert_eq(exit_status_outside("gcc -o abi abi.c && chmod 755 abi"), 0);
    // Some machines take no 32-bit calls at all: a confidential guest is one.
    if (exit_status_outside("./abi") == 0) {
        expect_forbidden(shell_run("exec ./abi"), "a 32-bit call");
    } else {
        expect_crash(shell_run("exec ./abi"), SIGSEGV);
    }
    expect_forbidden(perl_run("syscall(0x40000000 + 39)"), "an x32 call");
}
#endif

// Process 1 of bubblewrap's sandboxes: starts the command, and ends as that does.
//
//     sandbox_init STATUS N_PROCESSES COMMAND ARGUMENT...
//
// STATUS is the descriptor on which it tells that the command has begun; N_PROCESSES limits how
// many processes and threads the command may have, 0 does not. Set inside, that limit counts only
// those inside; set outside it would count all that the user runs on this machine.
//
// When process 1 ends, the kernel ends all that is left inside. Bubblewrap has one of its own, but
// what is inside could rewrite that through /proc/1/mem, and then end in a way that no command can:
// the grader took it for a fault of its own. This one is closed to them. No signal of theirs
// reaches it either, as it handles none. Read next: sandbox_init.c, which holds it.
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// As a shell does.
enum { CANNOT_EXECUTE = 126, NOT_FOUND = 127, SIGNAL_EXIT_BASE = 128 };

// No more descriptors were open in who became bubblewrap.
enum { N_DESCRIPTORS = 64 };

// The standard ones stay, and the one to tell on until the command begins.
static void descriptors_leave(int status)
{
    for (int descriptor = STDERR_FILENO + 1; descriptor < N_DESCRIPTORS; descriptor++) {
        if (descriptor != status) {
            close(descriptor);
        }
    }
    fcntl(status, F_SETFD, FD_CLOEXEC);
}

static _Noreturn void command_become(int status, rlim_t n_processes, char **argv)
{
    const char started[] = "\"command-started\": 1";
    const struct rlimit limit = {n_processes, n_processes};
    if ((n_processes > 0 && setrlimit(RLIMIT_NPROC, &limit) != 0) ||
        write(status, started, strlen(started)) < 0) {
        dprintf(STDERR_FILENO, "sandbox_init: %s\n", strerror(errno));
        _exit(NOT_FOUND);
    }
    execv(argv[0], argv);
    const int exit_code = errno == ENOENT ? NOT_FOUND : CANNOT_EXECUTE;
    dprintf(STDERR_FILENO, "%s: cannot be executed: %s\n", argv[0], strerror(errno));
    _exit(exit_code);
}

// Reap whatever ends, until the command does. Returns its exit code as a shell has it.
static int command_await(pid_t command)
{
    int status = 0;
    pid_t ended;
    do {
        ended = wait(&status);
    } while (ended != command && (ended > 0 || errno == EINTR));
    return ended != command      ? NOT_FOUND
           : WIFSIGNALED(status) ? SIGNAL_EXIT_BASE + WTERMSIG(status)
                                 : WEXITSTATUS(status);
}

int main(int argc, char **argv)
{
    // First of all: nobody inside reads or changes its memory from here on, or sees its files.
    if (prctl(PR_SET_DUMPABLE, 0) != 0 || argc < 4) {
        return NOT_FOUND;
    }
    const int status = atoi(argv[1]);
    descriptors_leave(status);
    const pid_t command = fork();
    if (command < 0) {
        dprintf(STDERR_FILENO, "sandbox_init: %s\n", strerror(errno));
        return NOT_FOUND;
    }
    if (command == 0) {
        command_become(status, strtoull(argv[2], NULL, 10), argv + 3);
    }
    close(status);
    return command_await(command);
}

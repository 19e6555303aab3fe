// A clang that has started once and compiles often. Two thirds of what clang takes for one of our
// kernels is spent before its main(): loading 100 MB of libraries. Preloaded into clang, this
// stands before main() and forks a process for each command that comes:
//
//     LD_PRELOAD=build/native/clang_server.so /usr/bin/clang build/native/kernels
//
// It listens at NATIVE_SERVER in that folder until it is killed. Each message is one command
// (compile.c): the folder to run it in, the file for what it says and its words, each with its
// zero. The answer is the exit status.
#include "command.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

typedef int MainFunction(int, char **, char **);

static MainFunction *clang_main;

// The next of the strings from `at` on, or NULL at the end.
static char *take_string(char **at, const char *end)
{
    char *string = *at;
    char *zero = string < end ? memchr(string, '\0', (size_t)(end - string)) : NULL;
    *at = zero != NULL ? zero + 1 : *at;
    return zero != NULL ? string : NULL;
}

// Be clang with a command's words. Does not return.
static void run_command(char *command, const char *end, char **environment)
{
    char *words[NATIVE_MAX_WORDS + 1] = {NULL};
    int n = 0;
    const char *folder = take_string(&command, end);
    const char *log = take_string(&command, end);
    while (n < NATIVE_MAX_WORDS && (words[n] = take_string(&command, end)) != NULL) {
        n++;
    }
    const int file = log != NULL && n > 0 && chdir(folder) == 0
                         ? open(log, O_WRONLY | O_CREAT | O_APPEND, 0644)
                         : -1;
    if (file < 0 || dup2(file, STDOUT_FILENO) < 0 || dup2(file, STDERR_FILENO) < 0) {
        _exit(127);
    }
    _exit(clang_main(n, words, environment));
}

// Read one command, run it in a process of its own, and tell its exit status.
static void serve(int client, char **environment)
{
    char command[NATIVE_COMMAND_BYTES];
    int status = 0;
    const ssize_t n_bytes = recv(client, command, sizeof command, 0);
    const pid_t child = n_bytes > 0 ? fork() : -1;
    if (child == 0) {
        run_command(command, command + n_bytes, environment);
    }
    if (child > 0 && waitpid(child, &status, 0) == child) {
        const unsigned char answer = WIFEXITED(status) ? (unsigned char)WEXITSTATUS(status) : 127;
        send(client, &answer, 1, MSG_NOSIGNAL);
    }
}

// In the place of clang's main().
static int listen_in(int argc, char **argv, char **environment)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = NATIVE_SERVER};
    const int server = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    // A path may be too long for an address: its last part is not.
    if (argc != 2 || server < 0 || chdir(argv[1]) != 0 ||
        (unlink(NATIVE_SERVER), bind(server, (struct sockaddr *)&address, sizeof address)) != 0 ||
        listen(server, SOMAXCONN) != 0) {
        perror("clang_server");
        return 2;
    }
    signal(SIGCHLD, SIG_IGN);
    for (;;) {
        const int client = accept4(server, NULL, NULL, SOCK_CLOEXEC);
        if (client >= 0 && fork() == 0) {
            signal(SIGCHLD, SIG_DFL);
            serve(client, environment);
            _exit(0);
        }
        close(client);
    }
}

// The C library's, which calls main(): ours hands it another one.
int __libc_start_main(MainFunction *main, int argc, char **argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void *stack_end)
{
    typedef int Start(MainFunction *, int, char **, void (*)(void), void (*)(void), void (*)(void),
                      void *);
    Start *start = (Start *)dlsym(RTLD_NEXT, "__libc_start_main");
    clang_main = main;
    return start(listen_in, argc, argv, init, fini, rtld_fini, stack_end);
}

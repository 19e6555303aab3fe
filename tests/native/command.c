// Running commands of the compiler (see command.h).
#include "command.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

// NATIVE_CACHE is from the makefile: where libraries are kept, and the server's socket is.

void command_add(Command *command, const char *word)
{
    if (command->n < NATIVE_MAX_WORDS - 1) {
        command->words[command->n++] = word;
    }
}

Command command_of(const char *const words[])
{
    Command command = {0};
    for (int i = 0; words[i] != NULL; i++) {
        command_add(&command, words[i]);
    }
    return command;
}

int command_run(const Command *command, const char *log)
{
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        const int file = open(log, O_WRONLY | O_CREAT | O_APPEND, 0644);
        if (file >= 0) {
            dup2(file, STDOUT_FILENO);
            dup2(file, STDERR_FILENO);
            execv(command->words[0], (char *const *)command->words);
        }
        _exit(127);
    }
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// ---- The clang that has started already ---------------------------------------------------------

// Connect to the clang that has started already, if one has. Returns -1 where none has.
static int connect_to_server(void)
{
    // A path may be too long for an address.
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    const int folder = open(NATIVE_CACHE, O_PATH | O_DIRECTORY | O_CLOEXEC);
    const int server = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    snprintf(address.sun_path, sizeof address.sun_path, "/proc/self/fd/%d/" NATIVE_SERVER, folder);
    const int failed = connect(server, (struct sockaddr *)&address, sizeof address) != 0;
    close(folder);
    if (failed) {
        close(server);
    }
    return failed ? -1 : server;
}

static size_t add_string(char message[NATIVE_COMMAND_BYTES], size_t length, const char *string)
{
    const size_t n_bytes = strlen(string) + 1;
    if (length + n_bytes > NATIVE_COMMAND_BYTES) {
        return NATIVE_COMMAND_BYTES + 1;
    }
    memcpy(message + length, string, n_bytes);
    return length + n_bytes;
}

// Have a command of clang's run by the one that has started already. Returns its exit status, or -1
// where there is none or it did not take it.
static int run_by_server(const Command *command, const char *log)
{
    char message[NATIVE_COMMAND_BYTES], folder[PATH_MAX];
    unsigned char status;
    size_t length = add_string(message, 0, getcwd(folder, sizeof folder) != NULL ? folder : "");
    length = add_string(message, length, log);
    for (int i = 0; i < command->n && length <= sizeof message; i++) {
        length = add_string(message, length, command->words[i]);
    }
    const int server = length <= sizeof message ? connect_to_server() : -1;
    const int is_done = server >= 0 && send(server, message, length, MSG_NOSIGNAL) > 0 &&
                        recv(server, &status, 1, 0) == 1;
    if (server >= 0) {
        close(server);
    }
    return is_done ? status : -1;
}

int command_run_clang(const Command *command, const char *log)
{
    const int status = run_by_server(command, log);
    return status >= 0 ? status : command_run(command, log);
}

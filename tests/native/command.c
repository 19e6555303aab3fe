// Running commands of the compiler (see command.h).
#include "command.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

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

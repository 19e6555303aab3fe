// A command of the compiler, and the two ways to run it: as a program, or by a clang that has
// started already (clang_server.c), which takes half of the time.
#ifndef NATIVE_COMMAND_H
#define NATIVE_COMMAND_H

// The server's socket, in the folder of the kernels that are kept.
#define NATIVE_SERVER "server"

enum { NATIVE_MAX_WORDS = 96, NATIVE_COMMAND_BYTES = 1 << 16 };

typedef struct Command {
    const char *words[NATIVE_MAX_WORDS];  // the program's path first, NULL at the end
    int n;
} Command;

// A word more; beyond NATIVE_MAX_WORDS - 1 it is dropped.
void command_add(Command *command, const char *word);

// Of words with NULL at the end.
Command command_of(const char *const words[]);

// Run it. What it says goes to the end of the file `log`. Returns its exit status, or -1.
int command_run(const Command *command, const char *log);

// The same for a command of clang's, by the server where there is one.
int command_run_clang(const Command *command, const char *log);

#endif

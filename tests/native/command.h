// A command of the compiler.
#ifndef NATIVE_COMMAND_H
#define NATIVE_COMMAND_H

enum { NATIVE_MAX_WORDS = 96 };

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

#endif

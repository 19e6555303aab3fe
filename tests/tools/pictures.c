// pictures: `compare` and `crop` for suites that ask for one after another. To load the library for
// pictures takes a third of a second of processor time; here that is done once.
//
//     pictures SAID COMPLAINED
//
// Each request on stdin is a line with a number of words, and then a line for each: a folder, the
// tool's name and its arguments. The tool runs in that folder as a process of its own, with what it
// would print in the files SAID and COMPLAINED; its exit status is a line on stdout. Ends with its
// stdin.
#include "complain.h"
#include "number.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { EXIT_FAULT = 2, MAX_WORDS = 64, MAX_LINE = 4352 };

// The tools' own main functions, under these names (tests.mk).
int compare_main(int argc, char **argv);
int crop_main(int argc, char **argv);

// A line without its end. Returns 0, or -1 where there is none.
static int line_read(char *line)
{
    if (fgets(line, MAX_LINE, stdin) == NULL) {
        return -1;
    }
    char *end = strchr(line, '\n');
    if (end == NULL) {
        return -1;
    }
    *end = '\0';
    return 0;
}

// What the descriptor stands for is this file from here on. Returns 0 or -1.
static int descriptor_lead(int descriptor, const char *path)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    return file < 0 || dup2(file, descriptor) < 0 ? -1 : 0;
}

// In a process of its own: words[0] is the folder, words[1] the tool.
static int tool_run(int n_words, char **words)
{
    if (n_words < 2 || chdir(words[0]) != 0) {
        complain("pictures: found no folder and tool");
        return EXIT_FAULT;
    }
    if (strcmp(words[1], "compare") == 0) {
        return compare_main(n_words - 1, words + 1);
    }
    if (strcmp(words[1], "crop") == 0) {
        return crop_main(n_words - 1, words + 1);
    }
    complain("pictures: found \"%s\", expected compare or crop", words[1]);
    return EXIT_FAULT;
}

// The request's exit status, as a shell would tell it.
static int request_serve(int n_words, char **words, char **files)
{
    const pid_t process = fork();
    if (process == 0) {
        if (descriptor_lead(STDOUT_FILENO, files[0]) != 0 ||
            descriptor_lead(STDERR_FILENO, files[1]) != 0) {
            _exit(EXIT_FAULT);
        }
        const int status = tool_run(n_words, words);
        fflush(NULL);
        // Not exit(): some of the libraries wait there for threads that are the first process's.
        _exit(status);
    }
    int status = 0;
    if (process < 0 || waitpid(process, &status, 0) < 0) {
        return EXIT_FAULT;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int main(int argc, char **argv)
{
    static char lines[MAX_WORDS][MAX_LINE];
    char *words[MAX_WORDS + 1];
    if (argc != 3) {
        complain("usage: pictures SAID COMPLAINED");
        return EXIT_FAULT;
    }
    // Where it cannot be loaded, the tools say so.
    dlopen("libimage_codec.so", RTLD_LAZY | RTLD_LOCAL);
    int64_t n_words = 0;
    while (line_read(lines[0]) == 0 && number_read_integer(lines[0], 1, MAX_WORDS, &n_words) == 0) {
        for (int i = 0; i < n_words; i++) {
            if (line_read(lines[i]) != 0) {
                return EXIT_FAULT;
            }
            words[i] = lines[i];
        }
        words[n_words] = NULL;
        printf("%d\n", request_serve((int)n_words, words, argv + 1));
        fflush(stdout);
    }
    return 0;
}

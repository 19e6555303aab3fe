// Compiling kernels to native code (see compile.h): the preprocessor, clang and the linker.
#include "compile.h"

#include "message.h"
#include "path.h"
#include "text_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// NATIVE_CACHE and NATIVE_HEADER are from the makefile: where libraries are kept, and kernels.h.

// Which clang it is may come from the makefile, too.
#ifndef CLANG
#define CLANG "/usr/bin/clang"
#endif

// gcc's own preprocessor: clang takes longer to begin than this to end.
#define PREPROCESS                                                                                 \
    "/usr/bin/cpp", "-undef", "-nostdinc", "-w", "-D__OPENCL_VERSION__=120",                       \
        "-D__OPENCL_C_VERSION__=120", "-include", NATIVE_HEADER

// What a known answer does not use is no warning's business here. PoCL may fuse a multiplication
// and an addition into one, which rounds once; here none is fused. As functions, kernels have the
// host's calling convention.
#define TRANSLATE                                                                                  \
    CLANG, "-w", "-x", "cl", "-cl-std=CL1.2", "-Xclang", "-fdeclare-opencl-builtins", "-Xclang",   \
        "-finclude-default-header", "-fno-color-diagnostics", "-O1", "-fPIC", "-ffp-contract=off", \
        "-Dkernel=", "-D__kernel="

enum { MAX_WORDS = 96 };

typedef struct Command {
    const char *words[MAX_WORDS];  // the program's path first, NULL at the end
    int n;
} Command;

static void command_add(Command *command, const char *word)
{
    if (command->n < MAX_WORDS - 1) {
        command->words[command->n++] = word;
    }
}

// Add each word of a text, which is changed.
static void command_add_words(Command *command, char *text)
{
    char *rest = NULL;
    for (char *word = strtok_r(text, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) {
        command_add(command, word);
    }
}

static Command command_of(const char *const words[])
{
    Command command = {0};
    for (int i = 0; words[i] != NULL; i++) {
        command_add(&command, words[i]);
    }
    return command;
}

// Run it. What it says goes to the end of the file `log`. Returns its exit status, or -1.
static int command_run(const Command *command, const char *log)
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

// ---- The name of what is kept -------------------------------------------------------------------

// A hash of all that it comes from: FNV-1a.
typedef uint64_t Key;
#define KEY_OF_NOTHING UINT64_C(14695981039346656037)

static void key_add_bytes(Key *key, const void *bytes, size_t n_bytes)
{
    for (size_t i = 0; i < n_bytes; i++) {
        *key = (*key ^ ((const unsigned char *)bytes)[i]) * UINT64_C(1099511628211);
    }
}

static void key_add(Key *key, const char *text)
{
    key_add_bytes(key, text, strlen(text) + 1);
}

// Whoever includes a file may include each beside it.
static void key_add_folder(Key *key, const char *folder)
{
    struct dirent **entries;
    const int n = scandir(folder, &entries, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        char path[PATH_MAX];
        struct stat about;
        path_make(path, "%s/%s", folder, entries[i]->d_name);
        if (stat(path, &about) == 0 && S_ISREG(about.st_mode)) {
            char *text = text_file_read(path);
            key_add(key, entries[i]->d_name);
            key_add(key, text != NULL ? text : "");
            free(text);
        }
        free(entries[i]);
    }
    if (n >= 0) {
        free(entries);
    }
}

// Another compiler makes other code.
static void key_add_compiler(Key *key)
{
    struct stat about;
    if (stat(CLANG, &about) == 0) {
        key_add_bytes(key, &about.st_size, sizeof about.st_size);
        key_add_bytes(key, &about.st_mtim, sizeof about.st_mtim);
    }
}

// What is kept of a text and options: NATIVE_CACHE/KEY, without an ending.
static void path_of(const char *text, const Command *options, char path[PATH_MAX])
{
    static const char *const code[] = {PREPROCESS, TRANSLATE, NULL};
    Key key = KEY_OF_NOTHING;
    key_add_compiler(&key);
    for (int i = 0; code[i] != NULL; i++) {
        key_add(&key, code[i]);
    }
    char *header = text_file_read(NATIVE_HEADER);
    key_add(&key, header != NULL ? header : "");
    free(header);
    key_add(&key, text);
    for (int i = 0; i < options->n; i++) {
        const char *word = options->words[i];
        key_add(&key, word);
        const int is_joined = strncmp(word, "-I", 2) == 0 && word[2] != '\0';
        const int is_parted = i > 0 && strcmp(options->words[i - 1], "-I") == 0;
        if (is_joined || is_parted) {
            key_add_folder(&key, is_joined ? word + 2 : word);
        }
    }
    path_make(path, NATIVE_CACHE "/%016" PRIx64, key);
}

// ---- Compiling ----------------------------------------------------------------------------------

static int write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    const int failed = file == NULL || fputs(text, file) == EOF;
    return (file != NULL && fclose(file) != 0) || failed ? -1 : 0;
}

// Write the entries of the kernels in a preprocessed file to its end.
static int append_entries(const char *path)
{
    char *text = text_file_read(path);
    FILE *file = text != NULL ? fopen(path, "a") : NULL;
    int n = file != NULL ? entries_write(text, file) : -1;
    if (file != NULL && fclose(file) != 0) {
        n = -1;
    }
    free(text);
    return n < 0 ? -1 : 0;
}

// Is it an option of clang's, and not of the preprocessor's?
static int is_of_language(const char *option)
{
    static const char *const begin[] = {"-cl-", "-f", "-g", "-O", "-mllvm", "-msan"};
    size_t i = 0;
    while (i < sizeof begin / sizeof *begin && strncmp(option, begin[i], strlen(begin[i])) != 0) {
        i++;
    }
    return i < sizeof begin / sizeof *begin;
}

// The steps, on files whose names differ in their ending. Returns 0, or -1 where one failed.
static int compile(const char *text, const Command *options, const char *stem, const char *library)
{
    char source[PATH_MAX], whole[PATH_MAX], object[PATH_MAX], log[PATH_MAX];
    path_make(source, "%s.cl", stem);
    path_make(whole, "%s.i.cl", stem);
    path_make(object, "%s.o", stem);
    path_make(log, "%s.log", stem);
    Command preprocess = command_of((const char *[]){PREPROCESS, source, "-o", whole, NULL});
    Command translate = command_of((const char *[]){TRANSLATE, "-c", whole, "-o", object, NULL});
    for (int i = 0; i < options->n; i++) {
        command_add(is_of_language(options->words[i]) ? &translate : &preprocess,
                    options->words[i]);
    }
    const Command link = command_of(
        (const char *[]){"/usr/bin/ld", "-shared", "-Bsymbolic", object, "-o", library, NULL});
    const int result = write_text(source, text) == 0 && command_run(&preprocess, log) == 0 &&
                               append_entries(whole) == 0 && command_run(&translate, log) == 0 &&
                               command_run(&link, log) == 0
                           ? 0
                           : -1;
    remove(source);
    remove(whole);
    remove(object);
    return result;
}

char *compile_kernels(const char *source, const char *options, char **log)
{
    char kept[PATH_MAX], stem[PATH_MAX], library[PATH_MAX], said[PATH_MAX];
    Command words = {0};
    const char *further = getenv(NATIVE_OPTIONS);
    char *copy = message_new("%s %s", options, further != NULL ? further : "");
    command_add_words(&words, copy);
    path_of(source, &words, kept);
    int result = access(kept, R_OK);
    *log = NULL;
    if (result != 0) {
        // Others may be making the same.
        path_make(stem, "%s.%d", kept, (int)getpid());
        path_make(library, "%s.so", stem);
        path_make(said, "%s.log", stem);
        result = compile(source, &words, stem, library) == 0 ? rename(library, kept) : -1;
        *log = text_file_read(said);
        remove(said);
    }
    free(copy);
    return result == 0 ? strdup(kept) : NULL;
}

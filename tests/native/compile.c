// Compiling kernels to native code (see compile.h): the preprocessor, clang and the linker.
#include "compile.h"

#include "message.h"
#include "path.h"
#include "text_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <nettle/sha2.h>
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
        "-D__OPENCL_C_VERSION__=120"

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

static void key_add(struct sha256_ctx *key, const char *text)
{
    sha256_update(key, strlen(text) + 1, (const uint8_t *)text);
}

// Whoever includes a file may include each beside it.
static void key_add_folder(struct sha256_ctx *key, const char *folder)
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
static void key_add_compiler(struct sha256_ctx *key)
{
    struct stat about;
    if (stat(CLANG, &about) == 0) {
        sha256_update(key, sizeof about.st_size, (const uint8_t *)&about.st_size);
        sha256_update(key, sizeof about.st_mtim, (const uint8_t *)&about.st_mtim);
    }
}

// What is kept of a text and options: NATIVE_CACHE/KEY, without an ending.
static void path_of(const char *text, const Command *options, char path[PATH_MAX])
{
    static const char *const code[] = {PREPROCESS, TRANSLATE, NULL};
    struct sha256_ctx key;
    uint8_t digest[SHA256_DIGEST_SIZE];
    char name[2 * SHA256_DIGEST_SIZE + 1];
    sha256_init(&key);
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
    sha256_digest(&key, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++) {
        snprintf(name + 2 * i, 3, "%02x", digest[i]);
    }
    path_make(path, NATIVE_CACHE "/%s", name);
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

static int is_of_language(const char *option)
{
    return strncmp(option, "-cl-", 4) == 0;
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
    char kept[PATH_MAX], stem[PATH_MAX], library[PATH_MAX], said[PATH_MAX], *rest = NULL;
    Command words = {0};
    char *copy = strdup(options);
    char *text = message_new("#include \"" NATIVE_HEADER "\"\n%s", source);
    for (char *word = strtok_r(copy, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) {
        command_add(&words, word);
    }
    path_of(text, &words, kept);
    int result = access(kept, R_OK);
    *log = NULL;
    if (result != 0) {
        // Others may be making the same.
        path_make(stem, "%s.%d", kept, (int)getpid());
        path_make(library, "%s.so", stem);
        path_make(said, "%s.log", stem);
        result = compile(text, &words, stem, library) == 0 ? rename(library, kept) : -1;
        *log = text_file_read(said);
        remove(said);
    }
    free(text);
    free(copy);
    return result == 0 ? strdup(kept) : NULL;
}

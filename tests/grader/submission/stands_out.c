// What no answer needs, found among a source's words (see stands_out.h).
//
// Called by grade.c once a submission is staged. Read next: source_words.h, and extra_files.c for
// what lies beside the answers.
#include "stands_out.h"

#include "extra_files.h"
#include "path.h"
#include "skeleton.h"
#include "source_words.h"
#include "text_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// More notes of one file say nothing new.
enum { MAX_NOTES = 8 };

// Functions that reach beyond the program's own arrays. What a student might call while looking for
// a mistake (printf, assert, getenv) or as an own function's name (read, link) is not among them.
static const char *const calls[] = {
    // processes
    "fork", "vfork", "clone", "execl", "execle", "execlp", "execv", "execve", "execvp", "execvpe",
    "fexecve", "posix_spawn", "posix_spawnp", "system", "popen", "daemon", "setsid", "setpgid",
    "ptrace", "process_vm_readv", "process_vm_writev", "prctl", "setrlimit", "syscall", "unshare",
    "kill", "killpg", "tgkill", "raise", "sigqueue", "signal", "sigaction", "pthread_create",
    // the end of the program
    "_exit", "_Exit", "quick_exit", "atexit", "on_exit", "at_quick_exit",
    // files
    "open", "openat", "creat", "fopen", "fopen64", "freopen", "fdopen", "opendir", "glob", "nftw",
    "mkdir", "mkfifo", "mknod", "symlink", "unlink", "chmod", "chown", "chdir", "chroot", "mount",
    "umount", "mkstemp", "tmpfile",
    // memory of others, code of others
    "mmap", "mprotect", "shm_open", "shmget", "shmat", "msgget", "semget", "mq_open",
    "memfd_create", "dlopen", "dlsym", "setenv", "putenv", "clearenv",
    // the network
    "socket", "socketpair", "connect", "getaddrinfo", "gethostbyname", "sendto",
    // the preprocessor's questions about files
    "__has_include", "__has_include_next", "__has_embed"};

// Attributes that let code run before or after main, or in another function's place.
static const char *const attributes[] = {
    "constructor", "__constructor__", "destructor",  "__destructor__", "ifunc",
    "__ifunc__",   "section",         "__section__", "alias",          "__alias__"};

// Where the counts of work are kept: an answer passes them on and never counts itself.
static const char *const counters[] = {"work", "d_work"};

// How strings begin that name a place outside of the lab.
static const char *const places[] = {"/etc/", "/proc/", "/dev/",  "/sys/", "/root", "/home",
                                     "/var/", "/tmp",   "/run/",  "/usr/", "/work", "../",
                                     "out/",  "job/",   "build/", "LD_"};

// What the headers of the C standard are called that an answer may want, and OpenCL's.
static const char *const headers[] = {
    "assert.h",    "complex.h",       "ctype.h",  "errno.h",  "float.h",    "inttypes.h",
    "iso646.h",    "limits.h",        "math.h",   "memory.h", "stdalign.h", "stdarg.h",
    "stdbool.h",   "stddef.h",        "stdint.h", "stdio.h",  "stdlib.h",   "stdnoreturn.h",
    "string.h",    "strings.h",       "tgmath.h", "time.h",   "values.h",   "CL/cl.h",
    "CL/opencl.h", "CL/cl_platform.h"};

#define IN_LIST(word, list) in_list(word, list, sizeof(list) / sizeof *(list))

static int in_list(const char *word, const char *const *list, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (strcmp(word, list[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

// One look at one file: the last three words, and what was noted.
typedef struct Look {
    const char *name;
    FILE *notes;
    int n_notes;
    char noted[MAX_NOTES][SOURCE_WORD_BYTES + 32];  // each thing once
    SourceWord before_last, last, word;
    int attribute_depth;  // open brackets since __attribute__; 0 outside of one
} Look;

__attribute__((format(printf, 3, 4))) static void note(Look *look, int line, const char *format,
                                                       ...)
{
    char what[sizeof look->noted[0]];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    for (int i = 0; i < look->n_notes; i++) {
        if (strcmp(look->noted[i], what) == 0) {
            return;
        }
    }
    if (look->n_notes < MAX_NOTES) {
        strcpy(look->noted[look->n_notes++], what);
        fprintf(look->notes, "%s:%d: %s: no answer needs it\n", look->name, line, what);
    }
}

// Work name: an answer that counts aside hides what it asks. The kernels that are handed out have
// one, called work.
static void look_at_own_count(Look *look)
{
    if (source_is(&look->last, SOURCE_NAME, "Work") && look->word.kind == SOURCE_NAME &&
        !IN_LIST(look->word.text, counters)) {
        note(look, look->word.line, "a count of its own (Work %s)", look->word.text);
    }
}

// name(  where no structure's member is called.
static void look_at_call(Look *look)
{
    const SourceWord *function = &look->last;
    const int is_member = source_is(&look->before_last, SOURCE_SIGN, ".") ||
                          source_is(&look->before_last, SOURCE_SIGN, "->");
    if (!source_is(&look->word, SOURCE_SIGN, "(") || function->kind != SOURCE_NAME || is_member) {
        return;
    }
    if (IN_LIST(function->text, calls)) {
        note(look, function->line, "%s()", function->text);
    } else if (strcmp(function->text, "main") == 0) {
        note(look, function->line, "a function called main");
    }
}

// exit with status 0: giving up with another one is what a program may do when memory runs out.
static void look_at_exit(Look *look)
{
    if (source_is(&look->before_last, SOURCE_NAME, "exit") &&
        source_is(&look->last, SOURCE_SIGN, "(") &&
        (source_is(&look->word, SOURCE_NUMBER, "0") ||
         source_is(&look->word, SOURCE_NAME, "EXIT_SUCCESS"))) {
        note(look, look->word.line, "exit(0)");
    }
}

static void look_at_word(Look *look)
{
    const SourceWord *word = &look->word;
    if (word->kind != SOURCE_NAME) {
        return;
    }
    if (strcmp(word->text, "asm") == 0 || strcmp(word->text, "__asm") == 0 ||
        strcmp(word->text, "__asm__") == 0) {
        note(look, word->line, "asm");
    } else if (look->attribute_depth > 0 && IN_LIST(word->text, attributes)) {
        note(look, word->line, "the attribute %s", word->text);
    }
}

static void look_at_counter(Look *look)
{
    const int reaches_in = source_is(&look->word, SOURCE_SIGN, "->") ||
                           source_is(&look->word, SOURCE_SIGN, ".") ||
                           source_is(&look->word, SOURCE_SIGN, "[");
    if (reaches_in && look->last.kind == SOURCE_NAME && IN_LIST(look->last.text, counters)) {
        note(look, look->last.line, "a hand on the counted work (%s)", look->last.text);
    }
}

static int ends_with(const char *text, const char *ending)
{
    const size_t length = strlen(text), n = strlen(ending);
    return length >= n && strcmp(text + length - n, ending) == 0;
}

static void look_at_string(Look *look)
{
    const SourceWord *string = &look->word;
    if (string->kind != SOURCE_STRING || source_is(&look->last, SOURCE_NAME, "include")) {
        return;
    }
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        if (strncmp(string->text, places[i], strlen(places[i])) == 0) {
            note(look, string->line, "\"%s\"", string->text);
            return;
        }
    }
    if (strstr(string->text, ".incbin") != NULL || strstr(string->text, ".include") != NULL) {
        note(look, string->line, "\"%s\"", string->text);
    }
}

static int is_given_header(const SourceWord *file)
{
    if (file->kind == SOURCE_HEADER) {
        return IN_LIST(file->text, headers);
    }
    return file->kind == SOURCE_STRING && file->text[0] != '/' &&
           (ends_with(file->text, ".h") || ends_with(file->text, ".cl"));
}

// #include of a header that is not the lab's, #line, #embed, and pragmas that look at files.
static void look_at_directive(Look *look)
{
    const SourceWord *name = &look->last, *argument = &look->word;
    if (!name->in_directive || !source_is(&look->before_last, SOURCE_SIGN, "#") ||
        (name->kind != SOURCE_NAME && name->kind != SOURCE_NUMBER)) {
        return;
    }
    if (strncmp(name->text, "include", strlen("include")) == 0 && !is_given_header(argument)) {
        note(look, name->line, argument->kind == SOURCE_HEADER ? "#%s <%s>" : "#%s \"%s\"",
             name->text, argument->text);
    } else if (name->kind == SOURCE_NUMBER || strcmp(name->text, "line") == 0 ||
               strcmp(name->text, "embed") == 0) {
        note(look, name->line, "#%s", name->text);
    }
}

static void look_at_pragma(Look *look)
{
    const SourceWord *word = &look->word;
    const int in_directive = word->in_directive && source_is(&look->last, SOURCE_NAME, "GCC") &&
                             source_is(&look->before_last, SOURCE_NAME, "pragma") &&
                             source_is(word, SOURCE_NAME, "dependency");
    const int in_operator = source_is(&look->before_last, SOURCE_NAME, "_Pragma") &&
                            word->kind == SOURCE_STRING && strstr(word->text, "dependency");
    if (in_directive || in_operator) {
        note(look, word->line, "the pragma GCC dependency");
    }
}

static void attribute_follow(Look *look)
{
    if (source_is(&look->word, SOURCE_SIGN, "(") &&
        (look->attribute_depth > 0 || source_is(&look->last, SOURCE_NAME, "__attribute__") ||
         source_is(&look->last, SOURCE_NAME, "__attribute"))) {
        look->attribute_depth++;
    } else if (source_is(&look->word, SOURCE_SIGN, ")") && look->attribute_depth > 0) {
        look->attribute_depth--;
    }
}

int stands_out_in_text(const char *name, const char *text, FILE *notes)
{
    Look look = {.name = name, .notes = notes};
    SourceReader reader = source_reader(text);
    do {
        look.before_last = look.last;
        look.last = look.word;
        look.word = source_next(&reader);
        attribute_follow(&look);
        look_at_call(&look);
        look_at_own_count(&look);
        look_at_exit(&look);
        look_at_word(&look);
        look_at_counter(&look);
        look_at_string(&look);
        look_at_directive(&look);
        look_at_pragma(&look);
    } while (look.word.kind != SOURCE_END);
    return look.n_notes;
}

// How many words of a source say that something is to be counted.
static int count_counting(const char *source)
{
    SourceReader reader = source_reader(source);
    int n = 0;
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END;
         word = source_next(&reader)) {
        n += source_is_one_of(&word, "count_test count_node count_leaf count_waiting work_save");
    }
    return n;
}

// Given functions count. Who does so as well can make much work look like little.
static int note_counting(const Manifest *manifest, const char *name, const char *source,
                         FILE *notes)
{
    char *skeleton = skeleton_read(manifest, name);
    const int is_more = skeleton != NULL && count_counting(source) > count_counting(skeleton);
    if (is_more) {
        fprintf(notes,
                "%s: a hand on the counted work: it counts more often than the lab's given "
                "lines do: no answer needs it\n",
                name);
    }
    free(skeleton);
    return is_more;
}

char *stands_out(const Manifest *manifest, const char *staged, const char *submission)
{
    char *text = NULL;
    size_t n_bytes = 0;
    FILE *notes = open_memstream(&text, &n_bytes);
    if (notes == NULL) {
        return NULL;
    }
    int n_notes = 0;
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        path_make(path, "%s/%s", staged, manifest->files[i]);
        // A file that could not be staged is reported elsewhere.
        char *source = access(path, R_OK) == 0 ? text_file_read(path) : NULL;
        if (source != NULL) {
            n_notes += stands_out_in_text(manifest->files[i], source, notes);
            n_notes += note_counting(manifest, manifest->files[i], source, notes);
        }
        free(source);
    }
    if (n_notes > 0) {
        fputs("(A look at the text only: it costs no points, and what was tried need not have "
              "worked.)\n",
              notes);
    }
    n_notes += extra_files_note(manifest, submission, notes);
    if (fclose(notes) != 0 || n_notes == 0) {
        free(text);
        return NULL;
    }
    return text;
}

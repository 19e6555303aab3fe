// What no answer needs, found among a source's words (see stands_out.h).
//
// Called by grade.c once a submission is staged. Read next: source_words.h, and
// stands_out_files.c for what lies beside the answers.
#include "stands_out.h"

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
static const char calls[] =
    // processes
    "fork vfork clone execl execle execlp execv execve execvp execvpe fexecve posix_spawn "
    "posix_spawnp system popen daemon setsid setpgid ptrace process_vm_readv process_vm_writev "
    "prctl setrlimit syscall unshare kill killpg tgkill raise sigqueue signal sigaction "
    "pthread_create "
    // the end of the program
    "_exit _Exit quick_exit atexit on_exit at_quick_exit "
    // files
    "open openat creat fopen fopen64 freopen fdopen opendir glob nftw mkdir mkfifo mknod symlink "
    "unlink chmod chown chdir chroot mount umount mkstemp tmpfile "
    // memory of others, code of others
    "mmap mprotect shm_open shmget shmat msgget semget mq_open memfd_create dlopen dlsym setenv "
    "putenv clearenv "
    // the network
    "socket socketpair connect getaddrinfo gethostbyname sendto "
    // the preprocessor's questions about files
    "__has_include __has_include_next __has_embed";

// Attributes that let code run before or after main, or in another function's place.
static const char attributes[] = "constructor __constructor__ destructor __destructor__ ifunc "
                                 "__ifunc__ section __section__ alias __alias__";

// Where the counts of work are kept: an answer passes them on and never counts itself.
static const char counters[] = "work d_work";

// How strings begin that name a place outside of the lab.
static const char *const places[] = {"/etc/", "/proc/", "/dev/",  "/sys/", "/root", "/home",
                                     "/var/", "/tmp",   "/run/",  "/usr/", "/work", "../",
                                     "out/",  "job/",   "build/", "LD_"};

// What the headers of the C standard are called that an answer may want, and OpenCL's.
static const char headers[] =
    "assert.h complex.h ctype.h errno.h float.h inttypes.h iso646.h limits.h math.h memory.h "
    "stdalign.h stdarg.h stdbool.h stddef.h stdint.h stdio.h stdlib.h stdnoreturn.h string.h "
    "strings.h tgmath.h time.h values.h CL/cl.h CL/opencl.h CL/cl_platform.h";

// Three words in a row.
typedef enum Position { BEFORE_LAST, LAST, WORD, N_POSITIONS } Position;

// What stands out wherever it is: words in a row, each one of a list; NULL for any.
typedef struct Striking {
    const char *words[N_POSITIONS];
    int is_member;     // also where a structure's member is called
    int in_attribute;  // only there
    Position named;    // its line is told, and itself for %s
    const char *says;
} Striking;
static const Striking striking[] = {
    {{NULL, calls, "("}, 0, 0, LAST, "%s()"},
    {{NULL, "main", "("}, 0, 0, LAST, "a function called %s"},
    // Giving up with another status is what a program may do when memory runs out.
    {{"exit", "(", "0 EXIT_SUCCESS"}, 1, 0, WORD, "exit(0)"},
    {{NULL, NULL, "asm __asm __asm__"}, 1, 0, WORD, "asm"},
    {{NULL, NULL, attributes}, 1, 1, WORD, "the attribute %s"},
    {{NULL, counters, "-> . ["}, 1, 0, LAST, "a hand on the counted work (%s)"},
    {{"pragma", "GCC", "dependency"}, 1, 0, WORD, "the pragma GCC dependency"},
};

// One look at one file: the last three words, and what was noted.
typedef struct Look {
    const char *name;
    FILE *notes;
    int n_notes;
    char noted[MAX_NOTES][SOURCE_WORD_BYTES + 32];  // each thing once
    SourceWord words[N_POSITIONS];
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

// Is a text one of a list that single blanks part?
static int is_listed(const char *text, const char *list)
{
    const size_t length = strlen(text);
    for (const char *word = list; *word != '\0'; word += strspn(word, " ")) {
        const size_t n = strcspn(word, " ");
        if (n == length && memcmp(word, text, n) == 0) {
            return 1;
        }
        word += n;
    }
    return 0;
}

// The same of a word of the program itself, and not of what stands between quotes.
static int is_one_of(const SourceWord *word, const char *list)
{
    return (word->kind == SOURCE_NAME || word->kind == SOURCE_NUMBER ||
            word->kind == SOURCE_SIGN) &&
           is_listed(word->text, list);
}

static int is_striking(const Look *look, const Striking *what)
{
    int is_it = (what->is_member || !is_one_of(&look->words[BEFORE_LAST], ". ->")) &&
                (!what->in_attribute || look->attribute_depth > 0);
    for (Position i = 0; i < N_POSITIONS; i++) {
        is_it = is_it && (what->words[i] == NULL || is_one_of(&look->words[i], what->words[i]));
    }
    return is_it;
}

static void look_at_words(Look *look)
{
    for (size_t i = 0; i < sizeof striking / sizeof *striking; i++) {
        if (is_striking(look, &striking[i])) {
            const SourceWord *named = &look->words[striking[i].named];
            note(look, named->line, striking[i].says, named->text);
        }
    }
    // An answer that counts aside hides what it asks. The given kernels have a count called work.
    const SourceWord *word = &look->words[WORD];
    if (is_one_of(&look->words[LAST], "Work") && word->kind == SOURCE_NAME &&
        !is_one_of(word, counters)) {
        note(look, word->line, "a count of its own (Work %s)", word->text);
    }
}

static int ends_with(const char *text, const char *ending)
{
    const size_t length = strlen(text), n = strlen(ending);
    return length >= n && strcmp(text + length - n, ending) == 0;
}

static void look_at_string(Look *look)
{
    const SourceWord *string = &look->words[WORD];
    if (string->kind != SOURCE_STRING || is_one_of(&look->words[LAST], "include")) {
        return;
    }
    int is_place =
        strstr(string->text, ".incbin") != NULL || strstr(string->text, ".include") != NULL;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        is_place |= strncmp(string->text, places[i], strlen(places[i])) == 0;
    }
    if (is_place) {
        note(look, string->line, "\"%s\"", string->text);
    }
    if (is_one_of(&look->words[BEFORE_LAST], "_Pragma") && strstr(string->text, "dependency")) {
        note(look, string->line, "the pragma GCC dependency");
    }
}

static int is_given_header(const SourceWord *file)
{
    if (file->kind == SOURCE_HEADER) {
        return is_listed(file->text, headers);
    }
    return file->kind == SOURCE_STRING && file->text[0] != '/' &&
           (ends_with(file->text, ".h") || ends_with(file->text, ".cl"));
}

// #include of a header that is not the lab's, #line and #embed.
static void look_at_directive(Look *look)
{
    const SourceWord *name = &look->words[LAST], *argument = &look->words[WORD];
    if (!name->in_directive || !is_one_of(&look->words[BEFORE_LAST], "#")) {
        return;
    }
    if (name->kind == SOURCE_NAME && strncmp(name->text, "include", strlen("include")) == 0 &&
        !is_given_header(argument)) {
        note(look, name->line, argument->kind == SOURCE_HEADER ? "#%s <%s>" : "#%s \"%s\"",
             name->text, argument->text);
    } else if (name->kind == SOURCE_NUMBER || is_one_of(name, "line embed")) {
        note(look, name->line, "#%s", name->text);
    }
}

static void attribute_follow(Look *look)
{
    const SourceWord *word = &look->words[WORD];
    if (is_one_of(word, "(") &&
        (look->attribute_depth > 0 || is_one_of(&look->words[LAST], "__attribute__ __attribute"))) {
        look->attribute_depth++;
    } else if (is_one_of(word, ")") && look->attribute_depth > 0) {
        look->attribute_depth--;
    }
}

int stands_out_in_text(const char *name, const char *text, FILE *notes)
{
    Look look = {.name = name, .notes = notes};
    SourceReader reader = source_reader(text);
    do {
        look.words[BEFORE_LAST] = look.words[LAST];
        look.words[LAST] = look.words[WORD];
        look.words[WORD] = source_next(&reader);
        attribute_follow(&look);
        look_at_words(&look);
        look_at_string(&look);
        look_at_directive(&look);
    } while (look.words[WORD].kind != SOURCE_END);
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
    n_notes += stands_out_in_folder(manifest, submission, notes);
    if (fclose(notes) != 0 || n_notes == 0) {
        free(text);
        return NULL;
    }
    return text;
}

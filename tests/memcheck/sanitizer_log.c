// Reading a sanitizer's report (see sanitizer_log.h). These are its lines that matter:
//
//     labs/03-.../KD.cl:41:9: runtime error: index 4 out of bounds for type 'uint[4]'
//     ==7==ERROR: AddressSanitizer: stack-buffer-overflow on address 0x7ffd3c0 ...
//     READ of size 4 at 0x7ffd3c0 thread T0
//         #0 0x7f8e2 in leaf_loop /work/labs/03-.../KD.cl:41
//       This frame has 1 object(s):
//         [32, 48) 'ids' (line 38) <== Memory access at offset 48 overflows this variable
//     ==7==WARNING: MemorySanitizer: use-of-uninitialized-value
//       Uninitialized value was created by an allocation of 'minDepth' in the stack frame ...
//
// and these the place's: "item 3 0", "array circles 4 4" with the entry and how many there are.
#include "sanitizer_log.h"

#include "crash_line.h"
#include "path.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK_INDEX                                                                                \
    "Compare the index with the number of entries before you use it. Does a loop go too far?"
#define SET_FIRST "Give it a value before it is read, on every way through the code."

// A variable's name, cut off where it is longer.
enum { NAME_BYTES = 48, INDEX_BYTES = 48 };
#define LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"

static void say(Finding *finding, const char *to_do, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void say(Finding *finding, const char *to_do, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->says, sizeof finding->says, format, arguments);
    va_end(arguments);
    finding->to_do = to_do;
}

// Is it a read, or a write? Where nothing says so, neither.
static const char *does(const char *report)
{
    return strstr(report, "WRITE of size") || strstr(report, "caused by a WRITE") ? "writes"
           : strstr(report, "READ of size") || strstr(report, "caused by a READ") ? "reads"
                                                                                  : "uses";
}

// The name in quotes behind `begin`, or "".
static void quoted_name(const char *begin, char name[NAME_BYTES])
{
    const char *quote = strchr(begin, '\'');
    const size_t length = quote != NULL ? strspn(quote + 1, LETTERS) : 0;
    snprintf(name, NAME_BYTES, "%.*s", (int)length, quote != NULL ? quote + 1 : "");
}

// An index; one that was a negative `uint` in its program is told as that, too.
static void index_write(long index, char text[INDEX_BYTES])
{
    if (index > INT32_MAX && index <= UINT32_MAX) {
        snprintf(text, INDEX_BYTES, "%ld (%ld as a uint)", index, index - (long)UINT32_MAX - 1);
    } else {
        snprintf(text, INDEX_BYTES, "%ld", index);
    }
}

// ---- What it is ---------------------------------------------------------------------------------

// A memory object's array, by the place.
static int says_array(Finding *finding, const char *report, const char *place)
{
    const char *array = strstr(place, "array ");
    char name[NAME_BYTES], index[INDEX_BYTES];
    long entry, n;
    if (array == NULL || sscanf(array, "array %47[A-Za-z0-9_] %ld %ld", name, &entry, &n) != 3 ||
        n < 1) {
        return 0;
    }
    index_write(entry, index);
    if (n == 1) {
        say(finding, CHECK_INDEX, "%s %s[%s], but `%s` has one entry, %s[0]", does(report), name,
            index, name, name);
    } else {
        say(finding, CHECK_INDEX, "%s %s[%s], but `%s` has %ld entries, 0 to %ld", does(report),
            name, index, name, n, n - 1);
    }
    return 1;
}

// What the undefined sanitizer finds in C files: how its words are known, and ours.
static const char *const undefined[][2] = {
    {"out of bounds for type", "uses an index out of range"},
    {"integer overflow: ", "computes a number that is too large for its type"},
    {"negation of ", "computes a number that is too large for its type"},
    {"division of ", "computes a number that is too large for its type"},
    {"shift", "shifts by too many bits, or a negative number"},
    {"null pointer", "uses a null pointer"},
    {"misaligned address", "uses a pointer to the middle of a number"},
    {"insufficient space", "uses a pointer beyond the end of its object"},
    {"outside the range of representable values",
     "converts a number that the new type cannot hold"},
    {"not a valid value for type", "reads a value that its type does not have"},
    {"end of a value-returning function", "comes to the end of a function without a `return`"},
    {"non-positive value", "declares an array without an entry"},
    {"overflowed to ", "moves a pointer out of all memory"},
};

static const char *undefined_find(const char *error, size_t length)
{
    for (size_t i = 0; i < sizeof undefined / sizeof *undefined; i++) {
        if (memmem(error, length, undefined[i][0], strlen(undefined[i][0])) != NULL) {
            return undefined[i][1];
        }
    }
    return "does what C leaves undefined";
}

// What the undefined sanitizer says.
static int says_undefined(Finding *finding, const char *report)
{
    static const char mark[] = "runtime error: ";
    const char *error = strstr(report, mark);
    char index[INDEX_BYTES];
    long entry, n;
    if (error == NULL) {
        return 0;
    }
    error += strlen(mark);
    if (sscanf(error, "index %ld out of bounds for type '%*[^[][%ld]'", &entry, &n) == 2 && n > 0) {
        index_write(entry, index);
        say(finding, CHECK_INDEX, "uses index %s of an array of %ld entries, 0 to %ld", index, n,
            n - 1);
    } else if (strncmp(error, "division by zero", strlen("division by zero")) == 0) {
        say(finding, "Ask whether the divisor is 0 before you divide.", "divides by zero");
    } else {
        say(finding, NULL, "%s", undefined_find(error, strcspn(error, "\n")));
    }
    return 1;
}

// A private variable that was left, by the address sanitizer's table of its frame.
static int says_variable(Finding *finding, const char *report)
{
    const char *mark = strstr(report, "<== Memory access at offset ");
    char name[NAME_BYTES];
    if (mark == NULL) {
        return 0;
    }
    const char *line = mark;
    while (line > report && line[-1] != '\n') {
        line--;
    }
    quoted_name(line, name);
    const size_t length = strcspn(mark, "\n");
    const int is_before = memmem(mark, length, "underflows", strlen("underflows")) != NULL;
    say(finding, CHECK_INDEX, "%s %s of `%s`", does(report),
        is_before ? "before the beginning" : "beyond the end", name);
    return 1;
}

// A value that was never set, by the memory sanitizer.
static int says_unset(Finding *finding, const char *report)
{
    const char *origin = strstr(report, "created by an allocation of ");
    char name[NAME_BYTES] = "";
    if (strstr(report, "use-of-uninitialized-value") == NULL) {
        return 0;
    }
    if (origin != NULL) {
        quoted_name(origin, name);
    }
    const char *uses = strstr(report, " in write_imagef") ? "draws with" : "uses";
    say(finding, SET_FIRST,
        name[0] != '\0' ? "%s a value that was never set, of `%s`"
                        : "%s a value that was never set",
        uses, name);
    return 1;
}

// ---- Where it is --------------------------------------------------------------------------------

// Where a given file went wrong: the first place of the report in one, above the student's own.
static void given_read(Finding *finding, const char *report, const Manifest *manifest)
{
    static const char *const folders[] = {"/labs/", "/solutions/", "/kernels/"};
    for (const char *frame = strstr(report, "    #0 "); frame != NULL && frame[0] == ' ';
         frame = strchr(frame, '\n'), frame += frame != NULL) {
        char path[PATH_MAX];
        int line;
        if (sscanf(frame, " #%*d 0x%*x in %*s %4000[^:\n]:%9d", path, &line) != 2 || line < 1) {
            continue;
        }
        const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
        if (manifest_file(manifest, name) >= 0) {
            return;
        }
        for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
            const char *given = strstr(path, folders[i]);
            if (given != NULL && strstr(given, "..") == NULL) {
                snprintf(finding->given, sizeof finding->given, "%s", given + 1);
                finding->given_line = line;
                return;
            }
        }
    }
}

int finding_read(const char *report, const char *place, const Manifest *manifest, Finding *finding)
{
    *finding = (Finding){0};
    const char *says;
    size_t x, y;
    finding->line = crash_line_read(report, manifest, &finding->file, &says);
    given_read(finding, report, manifest);
    if (finding->line == 0 && finding->given[0] == '\0') {
        return 0;
    }
    if (!says_array(finding, report, place) && !says_undefined(finding, report) &&
        !says_variable(finding, report) && !says_unset(finding, report)) {
        say(finding, NULL, "%s", says);
    }
    if (sscanf(place, "item %9zu %9zu", &x, &y) == 2) {
        snprintf(finding->work_item, sizeof finding->work_item, "(%zu, %zu)", x, y);
    }
    return 1;
}

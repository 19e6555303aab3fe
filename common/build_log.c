// The compiler's log of an OpenCL program, made readable (see build_log.h).
//
// One pass over the log, line by line; what is understood as a diagnostic is followed by the source
// line it speaks of. Read next: cl_build.c.
#include "build_log.h"

#include "utf8.h"

#include <stdlib.h>
#include <string.h>

#define MAX_FILE_NAME 1024

// One message about one place in a file.
typedef struct Diagnostic {
    char file[MAX_FILE_NAME];
    int line;          // counts from 1
    int column;        // counts from 1, in bytes
    char severity[8];  // "error", "warning", "note"
    const char *text;  // points into the log line
} Diagnostic;

// Take a log line apart. Returns 1, or 0 when it is no diagnostic.
static int diagnostic_read(const char *line, Diagnostic *diagnostic)
{
    static const char *const SEVERITIES[] = {"error", "warning", "note"};
    for (size_t i = 0; i < sizeof SEVERITIES / sizeof SEVERITIES[0]; i++) {
        const char *severity = SEVERITIES[i];
        size_t length = strlen(severity);
        int n_read = 0;
        if (strncmp(line, severity, length) == 0 &&
            sscanf(line + length, ": %1023[^:]:%d:%d%n", diagnostic->file, &diagnostic->line,
                   &diagnostic->column, &n_read) == 3 &&
            n_read > 0) {
            const char *text = line + length + n_read;
            // PoCL's functions are macros: " <Spelling=...>" is their place, not the student's.
            const char *end = strncmp(text, " <Spelling=", 11) == 0 ? strchr(text, '>') : NULL;
            text = end != NULL ? end + 1 : text;
            if (strncmp(text, ": ", 2) != 0) {
                return 0;
            }
            strcpy(diagnostic->severity, severity);
            diagnostic->text = text + 2;
            return 1;
        }
    }
    return 0;
}

// PoCL calls max() _cl_max inside: print a text with the functions' own names.
static void text_print(FILE *out, const char *text)
{
    static const char inner[] = "'_cl_";
    for (const char *found; (found = strstr(text, inner)) != NULL;) {
        fprintf(out, "%.*s'", (int)(found - text), text);
        text = found + sizeof inner - 1;
    }
    fprintf(out, "%s\n", text);
}

// What to write instead, for mistakes whose messages do not say so.
static void advice_print(FILE *out, const char *text)
{
    if (strstr(text, " changes address space of pointer") != NULL) {
        fprintf(out, "note: a pointer's type names the memory that it points into: `global` for "
                     "the arrays that a kernel gets, nothing for a variable of your own. Both "
                     "types must name the same one; or copy the element into a variable\n");
    } else if (strncmp(text, "call to '", 9) == 0 && strstr(text, "' is ambiguous") != NULL) {
        fprintf(out, "note: its arguments are of different types: for a float write 0.0f, not 0\n");
    } else if (strncmp(text, "no matching function for call to '", 34) == 0) {
        fprintf(out, "note: count its arguments, and look at their types: max() has two, so that "
                     "the largest of three is max(a, max(b, c))\n");
    }
}

// Does the driver draw carets itself? Then its log is left as it is.
static int log_has_carets(const char *log)
{
    for (const char *caret = strchr(log, '^'); caret != NULL; caret = strchr(caret + 1, '^')) {
        const char *before = caret;
        while (before > log && (before[-1] == ' ' || before[-1] == '\t' || before[-1] == '~')) {
            before--;
        }
        if (before < caret && (before == log || before[-1] == '\n')) {
            return 1;
        }
    }
    return 0;
}

// What a compiler counts.
static int is_counted(const char *word)
{
    static const char *const WORDS[] = {"error", "errors", "warning", "warnings"};
    for (size_t i = 0; i < sizeof WORDS / sizeof WORDS[0]; i++) {
        if (strcmp(word, WORDS[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

// "1 error generated.", "2 warnings and 1 error generated."
static int line_is_summary(const char *line)
{
    char first[9] = "", second[9] = "error";  // hold "warnings"
    int n_read = 0;
    sscanf(line, "%*u %8[a-z] generated. %n", first, &n_read);
    if (n_read == 0) {
        sscanf(line, "%*u %8[a-z] and %*u %8[a-z] generated. %n", first, second, &n_read);
    }
    return n_read > 0 && line[n_read] == '\0' && is_counted(first) && is_counted(second);
}

// For lines that are no diagnostic.
static int line_is_noise(const char *line)
{
    return line[strspn(line, " \t\r")] == '\0' || line_is_summary(line) ||
           (strncmp(line, "Device ", 7) == 0 && strstr(line, "failed to build") != NULL) ||
           strncmp(line, "Error(s) while linking", 22) == 0 ||
           strstr(line, "so overriding noinline attribute") != NULL;  // NVIDIA, of every kernel
}

// PoCL 7 warns of each vector wider than the processor's registers, also where a pragma turns that
// off: code for another processor would pass them otherwise. All of a kernel's is compiled at once.
static int line_is_of_abi(const char *line)
{
    return strncmp(line, "warning: ", 9) == 0 && strstr(line, " changes the ABI") != NULL;
}

// Was the same line in the log before? PoCL reads a program twice and repeats warnings.
static int line_is_repeated(const char *log, const char *line, size_t length)
{
    for (const char *earlier = log; earlier < line; earlier = strchr(earlier, '\n') + 1) {
        if (strncmp(earlier, line, length) == 0 && earlier[length] == '\n') {
            return 1;
        }
    }
    return 0;
}

// Print line number `line` of a file and a caret under its column; nothing where there is no such
// line.
static void source_line_print(FILE *out, const char *path, int line, int column)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return;
    }
    char *text = NULL;
    size_t capacity = 0;
    ssize_t length = 0;
    for (int i = 0; i < line && length >= 0; i++) {
        length = getline(&text, &capacity, file);
    }
    if (line > 0 && length > 0) {
        text[strcspn(text, "\r\n")] = '\0';
        fprintf(out, "%s\n", text);
        for (int i = 0; i < column - 1 && text[i] != '\0'; i++) {
            // A tab stays one, and a letter of several bytes (UTF-8) is one column wide on screen.
            if (!utf8_goes_on(text[i])) {
                fputc(text[i] == '\t' ? '\t' : ' ', out);
            }
        }
        fprintf(out, "^\n");
    }
    free(text);
    fclose(file);
}

// Call the program's folder what its author calls it.
static void file_rename(char *file, const char *alias, const char *folder)
{
    size_t length = alias == NULL ? 0 : strlen(alias);
    if (length == 0 || strncmp(file, alias, length) != 0 || file[length] != '/') {
        return;
    }
    char renamed[MAX_FILE_NAME];
    if (snprintf(renamed, sizeof renamed, "%s%s", folder, file + length) < (int)sizeof renamed) {
        strcpy(file, renamed);
    }
}

int build_log_print(FILE *out, const char *log, const char *path, const char *alias,
                    const char *folder)
{
    if (log_has_carets(log)) {
        fprintf(out, "%s: the compiler says:\n%s\n", path, log);
        return 1;
    }
    int n_messages = 0;
    for (const char *start = log; *start != '\0';) {
        size_t length = strcspn(start, "\n");
        char *line = strndup(start, length);
        Diagnostic diagnostic;
        if (line == NULL || line_is_of_abi(line) || line_is_repeated(log, start, length)) {
            // Nothing to tell the author.
        } else if (diagnostic_read(line, &diagnostic)) {
            file_rename(diagnostic.file, alias, folder);
            fprintf(out, "%s:%d:%d: %s: ", diagnostic.file, diagnostic.line, diagnostic.column,
                    diagnostic.severity);
            text_print(out, diagnostic.text);
            source_line_print(out, diagnostic.file, diagnostic.line, diagnostic.column);
            advice_print(out, diagnostic.text);
            n_messages++;
        } else if (!line_is_noise(line)) {
            fprintf(out, "%s: %s\n", path, line);
            n_messages++;
        }
        free(line);
        start += length + (start[length] == '\n');
    }
    return n_messages;
}

// Entries of kernels (see compile.h).
#include "compile.h"
#include "native_cl.h"

#include <ctype.h>
#include <string.h>

// A piece of the text: no copy.
typedef struct Words {
    const char *at;
    size_t length;
} Words;

static int is_of_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static const char *skip_blanks(const char *at)
{
    return at + strspn(at, " \t\r\n");
}

// The name that the text begins with, of length 0 where it is none.
static Words name_at(const char *at)
{
    size_t length = 0;
    while (is_of_name(at[length])) {
        length++;
    }
    return (Words){at, length};
}

static int is_word(Words words, const char *word)
{
    return words.length == strlen(word) && memcmp(words.at, word, words.length) == 0;
}

static Words trimmed(Words words)
{
    while (words.length > 0 && isspace((unsigned char)words.at[0])) {
        words.at++;
        words.length--;
    }
    while (words.length > 0 && isspace((unsigned char)words.at[words.length - 1])) {
        words.length--;
    }
    return words;
}

// The type of a parameter: "global const Sphere *" of "global const Sphere *spheres".
static Words type_of(Words parameter)
{
    parameter = trimmed(parameter);
    while (parameter.length > 0 && is_of_name(parameter.at[parameter.length - 1])) {
        parameter.length--;
    }
    return trimmed(parameter);
}

static int kind_of(Words type)
{
    return type.length > 0 && type.at[type.length - 1] == '*' ? PARAMETER_BUFFER
           : is_word(type, "NativeImage")                     ? PARAMETER_IMAGE
                                                              : PARAMETER_VALUE;
}

// Take the types of a kernel's parameters, which end at a ')'. Returns how many, or -1.
static int read_types(const char *at, Words types[MAX_PARAMETERS], const char **end)
{
    int n = 0;
    for (;; at++) {
        const size_t length = strcspn(at, ",()");
        if (at[length] == '\0' || at[length] == '(' || n == MAX_PARAMETERS) {
            return -1;
        }
        types[n++] = type_of((Words){at, length});
        at += length;
        if (*at == ')') {
            *end = at + 1;
            return n;
        }
    }
}

static void write_entry(Words name, const Words types[], int n, FILE *out)
{
    fprintf(out, "\nvoid " KERNEL_ENTRY "%.*s(private void *private *arguments)\n{\n    %.*s(",
            (int)name.length, name.at, (int)name.length, name.at);
    for (int i = 0; i < n; i++) {
        fprintf(out, "%s*(%.*s private *)arguments[%d]", i > 0 ? ", " : "", (int)types[i].length,
                types[i].at, i);
    }
    fprintf(out, ");\n}\nconstant uint " KERNEL_PARAMETERS "%.*s[] = {%d", (int)name.length,
            name.at, n);
    for (int i = 0; i < n; i++) {
        fprintf(out, ", sizeof(%.*s) | %d << %d", (int)types[i].length, types[i].at,
                kind_of(types[i]), PARAMETER_KIND_BIT);
    }
    fprintf(out, "};\n");
}

int entries_write(const char *text, FILE *out)
{
    int n_entries = 0;
    for (const char *at = text; *at != '\0';) {
        const Words word = name_at(at);
        at += word.length > 0 ? word.length : 1;
        if (!is_word(word, "kernel") && !is_word(word, "__kernel")) {
            continue;
        }
        const Words result = name_at(skip_blanks(at));
        const Words name = name_at(skip_blanks(result.at + result.length));
        const char *end = skip_blanks(name.at + name.length);
        Words types[MAX_PARAMETERS];
        const int n = *end == '(' ? read_types(end + 1, types, &end) : -1;
        if (!is_word(result, "void") || n < 0) {
            return -1;
        }
        // A declaration comes again as a definition.
        if (*skip_blanks(end) == '{') {
            write_entry(name, types, n, out);
            n_entries++;
        }
    }
    return n_entries;
}

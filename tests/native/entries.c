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

// "global const Sphere *spheres": the type is what comes before the name.
typedef struct Parameter {
    Words type, name;
} Parameter;

static Parameter parameter_of(Words text)
{
    Words type = trimmed(text);
    const char *end = type.at + type.length;
    while (type.length > 0 && is_of_name(type.at[type.length - 1])) {
        type.length--;
    }
    const char *begin = type.at + type.length;
    return (Parameter){trimmed(type), {begin, (size_t)(end - begin)}};
}

static int kind_of(Words type)
{
    return type.length > 0 && type.at[type.length - 1] == '*' ? PARAMETER_BUFFER
           : is_word(type, "NativeImage")                     ? PARAMETER_IMAGE
                                                              : PARAMETER_VALUE;
}

// Take a kernel's parameters, which end at a ')'. Returns how many, or -1.
static int read_parameters(const char *at, Parameter parameters[MAX_PARAMETERS], const char **end)
{
    int n = 0;
    for (;; at++) {
        const size_t length = strcspn(at, ",()");
        if (at[length] == '\0' || at[length] == '(' || n == MAX_PARAMETERS) {
            return -1;
        }
        parameters[n++] = parameter_of((Words){at, length});
        at += length;
        if (*at == ')') {
            *end = at + 1;
            return n;
        }
    }
}

// A name of ours for each kernel: "NAME_render".
static void write_name(const char *begin, Words name, FILE *out)
{
    fprintf(out, "%s%.*s", begin, (int)name.length, name.at);
}

static void write_entry(Words name, const Parameter parameters[], int n, FILE *out)
{
    // The host's arguments have no marks of the memory sanitizer's.
    write_name("\n__attribute__((no_sanitize(\"memory\"))) void " KERNEL_ENTRY, name, out);
    write_name("(private void *private *arguments)\n{\n    ", name, out);
    for (int i = 0; i < n; i++) {
        fprintf(out, "%s*(%.*s private *)arguments[%d]", i > 0 ? ", " : "(",
                (int)parameters[i].type.length, parameters[i].type.at, i);
    }
    write_name(");\n}\nconstant uint " KERNEL_PARAMETERS, name, out);
    fprintf(out, "[] = {%d", n);
    for (int i = 0; i < n; i++) {
        const Words type = parameters[i].type;
        fprintf(out, ", sizeof(%.*s) | %d << %d", (int)type.length, type.at, kind_of(type),
                PARAMETER_KIND_BIT);
    }
    write_name("};\nconstant uint " KERNEL_ELEMENTS, name, out);
    fprintf(out, "[] = {0");
    for (int i = 0; i < n; i++) {
        const Words type = parameters[i].type;
        if (kind_of(type) == PARAMETER_BUFFER) {
            fprintf(out, ", sizeof(*(%.*s)0)", (int)type.length, type.at);
        } else {
            fprintf(out, ", 0");
        }
    }
    write_name("};\nconstant char " KERNEL_NAMES, name, out);
    fprintf(out, "[] = \"");
    for (int i = 0; i < n; i++) {
        write_name("", parameters[i].name, out);
        fprintf(out, "\\0");
    }
    fprintf(out, "\";\n");
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
        Parameter parameters[MAX_PARAMETERS];
        const int n = *end == '(' ? read_parameters(end + 1, parameters, &end) : -1;
        if (!is_word(result, "void") || n < 0) {
            return -1;
        }
        // A declaration comes again as a definition.
        if (*skip_blanks(end) == '{') {
            write_entry(name, parameters, n, out);
            n_entries++;
        }
    }
    return n_entries;
}

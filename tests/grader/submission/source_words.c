// Reading words as a compiler's first phases do (see source_words.h): trigraphs become what they
// stand for, lines that end in a backslash are joined, comments are blanks, # begins a directive
// where it is the first of its line.
#include "source_words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// ---- Characters ---------------------------------------------------------------------------------

SourceReader source_reader(const char *source)
{
    return (SourceReader){.text = source, .line = 1, .at_line_start = 1};
}

// The character that a text starts with, and how many bytes write it: three are a trigraph.
static char first_character(const char *text, size_t *n_bytes)
{
    static const char third[] = "=/'()!<>-", meant[] = "#\\^[]|{}~";
    const int may_be_one = text[0] == '?' && text[1] == '?' && text[2] != '\0';
    const char *found = may_be_one ? strchr(third, text[2]) : NULL;
    *n_bytes = found ? 3 : 1;
    return found ? meant[found - third] : text[0];
}

// Pass by the backslashes that join lines, so that reader->text stands on a character that counts.
// Blanks between the backslash and the line's end do not count for gcc either.
static void splices_pass(SourceReader *reader)
{
    size_t n_bytes;
    while (first_character(reader->text, &n_bytes) == '\\') {
        n_bytes += strspn(reader->text + n_bytes, " \t\v\f\r");
        if (reader->text[n_bytes] != '\n') {
            return;
        }
        reader->text += n_bytes + 1;
        reader->line++;
    }
}

static char peek(SourceReader *reader)
{
    size_t n_bytes;
    splices_pass(reader);
    return first_character(reader->text, &n_bytes);
}

static char take(SourceReader *reader)
{
    size_t n_bytes;
    splices_pass(reader);
    const char character = first_character(reader->text, &n_bytes);
    if (character != '\0') {
        reader->text += n_bytes;
        reader->line += character == '\n';
    }
    return character;
}

// The character behind the next one.
static char peek_second(const SourceReader *reader)
{
    SourceReader ahead = *reader;
    take(&ahead);
    return peek(&ahead);
}

// ---- Between the words --------------------------------------------------------------------------

static void comment_pass(SourceReader *reader)
{
    take(reader);
    if (take(reader) == '/') {
        while (peek(reader) != '\0' && peek(reader) != '\n') {
            take(reader);
        }
        return;
    }
    while (peek(reader) != '\0' && !(peek(reader) == '*' && peek_second(reader) == '/')) {
        take(reader);
    }
    take(reader);
    take(reader);
}

static void blanks_pass(SourceReader *reader)
{
    for (;;) {
        const char character = peek(reader);
        if (character == '/' && (peek_second(reader) == '/' || peek_second(reader) == '*')) {
            comment_pass(reader);
        } else if (character == '\n') {
            take(reader);
            reader->at_line_start = 1;
            reader->in_directive = 0;
            reader->expects_header = 0;
        } else if (character != '\0' && isspace((unsigned char)character)) {
            take(reader);
        } else {
            return;
        }
    }
}

// ---- Words --------------------------------------------------------------------------------------

static void word_append(SourceWord *word, char character)
{
    const size_t length = strlen(word->text);
    if (length + 1 < sizeof word->text) {
        word->text[length] = character;
        word->text[length + 1] = '\0';
    }
}

// Read up to the closing character, which is not part of the text, or to the line's end.
static void quoted_read(SourceReader *reader, SourceWord *word, char closing)
{
    take(reader);
    while (peek(reader) != '\0' && peek(reader) != '\n') {
        const char character = take(reader);
        if (character == closing) {
            return;
        }
        word_append(word, character);
        if (character == '\\' && closing != '>' && peek(reader) != '\n') {
            word_append(word, take(reader));
        }
    }
}

static int is_in_name(char character)
{
    return isalnum((unsigned char)character) || character == '_' || character == '$' ||
           (unsigned char)character >= 0x80;
}

static void name_read(SourceReader *reader, SourceWord *word)
{
    while (is_in_name(peek(reader))) {
        word_append(word, take(reader));
    }
    reader->expects_header = word->in_directive && (source_is(word, SOURCE_NAME, "include") ||
                                                    source_is(word, SOURCE_NAME, "include_next") ||
                                                    source_is(word, SOURCE_NAME, "embed"));
}

// The exponent's sign belongs to the number: 1e-3, 0x1p-2, but not 0xE-3.
static void number_read(SourceReader *reader, SourceWord *word)
{
    char last = '\0';
    const int is_hexadecimal =
        peek(reader) == '0' && (peek_second(reader) == 'x' || peek_second(reader) == 'X');
    const char *exponent = is_hexadecimal ? "pP" : "eE";
    while (is_in_name(peek(reader)) || peek(reader) == '.' ||
           ((peek(reader) == '+' || peek(reader) == '-') && last != '\0' &&
            strchr(exponent, last) != NULL)) {
        last = take(reader);
        word_append(word, last);
    }
}

static void sign_read(SourceReader *reader, SourceWord *word)
{
    static const char *const signs[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
                                        "<=",  ">=",  "==",  "!=", "&&", "||", "*=", "/=",
                                        "%=",  "+=",  "-=",  "&=", "^=", "|=", "%:"};
    char ahead[4] = "";
    SourceReader look = *reader;
    for (int i = 0; i < 3; i++) {
        ahead[i] = take(&look);
    }
    size_t length = 1;
    for (size_t i = 0; i < sizeof signs / sizeof *signs && length == 1; i++) {
        if (strncmp(ahead, signs[i], strlen(signs[i])) == 0) {
            length = strlen(signs[i]);
        }
    }
    for (size_t i = 0; i < length; i++) {
        word_append(word, take(reader));
    }
    if (strcmp(word->text, "%:") == 0) {
        strcpy(word->text, "#");  // another way to write it
    }
}

static SourceKind kind_of(SourceReader *reader)
{
    const char first = peek(reader);
    if (first == '\0') {
        return SOURCE_END;
    }
    const int starts_number = first == '.' && isdigit((unsigned char)peek_second(reader));
    if (isdigit((unsigned char)first) || starts_number) {
        return SOURCE_NUMBER;
    }
    if (is_in_name(first)) {
        return SOURCE_NAME;
    }
    return first == '"'                             ? SOURCE_STRING
           : first == '\''                          ? SOURCE_CHARACTER
           : first == '<' && reader->expects_header ? SOURCE_HEADER
                                                    : SOURCE_SIGN;
}

SourceWord source_next(SourceReader *reader)
{
    blanks_pass(reader);
    const char first = peek(reader);
    SourceWord word = {.kind = kind_of(reader), .start = reader->text, .line = reader->line};
    if (reader->at_line_start && (first == '#' || (first == '%' && peek_second(reader) == ':'))) {
        reader->in_directive = 1;
        word.begins_directive = 1;
    }
    reader->at_line_start = 0;
    word.in_directive = reader->in_directive;
    switch (word.kind) {
    case SOURCE_NAME:
        name_read(reader, &word);
        break;
    case SOURCE_NUMBER:
        number_read(reader, &word);
        break;
    case SOURCE_STRING:
    case SOURCE_CHARACTER:
        quoted_read(reader, &word, first);
        break;
    case SOURCE_HEADER:
        quoted_read(reader, &word, '>');
        break;
    case SOURCE_SIGN:
        sign_read(reader, &word);
        break;
    case SOURCE_END:
        break;
    }
    word.length = (size_t)(reader->text - word.start);
    return word;
}

// Does `0`, and nothing else, come in the rest of a directive?
static int is_0(SourceReader rest)
{
    const SourceWord number = source_next(&rest);
    return source_is(&number, SOURCE_NUMBER, "0") &&
           (source_next(&rest).begins_directive || !rest.in_directive);
}

// Pass by what no compiler reads behind `#if 0`.
static void dead_lines_pass(SourceReader *reader)
{
    SourceWord word = source_next(reader);
    for (int depth = 1; word.kind != SOURCE_END; word = source_next(reader)) {
        if (word.in_directive && word.kind == SOURCE_NAME) {
            depth += source_is_one_of(&word, "if ifdef ifndef");
            depth -= source_is_one_of(&word, "endif") ||
                     (depth == 1 && source_is_one_of(&word, "else elif"));
        }
        if (depth == 0) {
            return;
        }
    }
}

SourceWord source_next_macro(SourceReader *reader)
{
    SourceWord word = source_next(reader);
    while (word.kind != SOURCE_END) {
        const int is_definition = word.in_directive && source_is(&word, SOURCE_NAME, "define");
        if (word.in_directive && source_is(&word, SOURCE_NAME, "if") && is_0(*reader)) {
            dead_lines_pass(reader);
        }
        word = source_next(reader);
        if (is_definition && word.kind == SOURCE_NAME) {
            break;
        }
    }
    return word;
}

SourceWord *source_words(const char *source, int *n_words)
{
    SourceWord *words = NULL;
    *n_words = 0;
    for (int pass = 0; pass < 2; pass++) {  // first they are only counted
        SourceReader reader = source_reader(source);
        int n = 0;
        for (SourceWord word = source_next(&reader); word.kind != SOURCE_END;
             word = source_next(&reader)) {
            if (words != NULL && !word.in_directive) {
                words[n] = word;
            }
            n += !word.in_directive;
        }
        words = pass == 0 ? malloc(((size_t)n + 1) * sizeof *words) : words;
        if (words == NULL) {
            return NULL;
        }
        *n_words = n;
    }
    return words;
}

int source_is(const SourceWord *word, SourceKind kind, const char *text)
{
    return word->kind == kind && strcmp(word->text, text) == 0;
}

int source_is_one_of(const SourceWord *word, const char *words)
{
    while (*words != '\0') {
        const size_t length = strcspn(words, " ");
        if (length == word->length && memcmp(words, word->start, length) == 0) {
            return 1;
        }
        words += length + (words[length] == ' ');
    }
    return 0;
}

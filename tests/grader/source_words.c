// The words of a source (see source_words.h), read as a compiler's first phases do: lines that end
// in a backslash are joined, comments are blanks, # begins a directive where it is the first of its
// line. Trigraphs, which gcc ignores too, are not known.
//
// Flow: a submission's files -> WORDS -> what stands out. Read next: stands_out.c.
#include "source_words.h"

#include <ctype.h>
#include <string.h>

SourceReader source_reader(const char *source)
{
    return (SourceReader){.text = source, .line = 1};
}

// Pass by the backslashes that join lines, so that reader->text stands on a character that counts.
static void splices_pass(SourceReader *reader)
{
    for (;;) {
        const char *text = reader->text;
        const size_t n = text[0] != '\\'                      ? 0
                         : text[1] == '\n'                    ? 2
                         : text[1] == '\r' && text[2] == '\n' ? 3
                                                              : 0;
        if (n == 0) {
            return;
        }
        reader->text += n;
        reader->line++;
    }
}

static char peek(SourceReader *reader)
{
    splices_pass(reader);
    return *reader->text;
}

static char take(SourceReader *reader)
{
    const char character = peek(reader);
    if (character != '\0') {
        reader->text++;
        reader->line += character == '\n';
    }
    return character;
}

// The character behind the next one.
static char peek_second(SourceReader *reader)
{
    SourceReader ahead = *reader;
    take(&ahead);
    return peek(&ahead);
}

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

// Pass by blanks and comments. Returns whether a line began.
static int blanks_pass(SourceReader *reader)
{
    int is_new_line = 0;
    for (;;) {
        const char character = peek(reader);
        if (character == '/' && (peek_second(reader) == '/' || peek_second(reader) == '*')) {
            comment_pass(reader);
        } else if (character == '\n') {
            take(reader);
            reader->in_directive = 0;
            reader->expects_header = 0;
            is_new_line = 1;
        } else if (character != '\0' && isspace((unsigned char)character)) {
            take(reader);
        } else {
            return is_new_line;
        }
    }
}

static void word_append(SourceWord *word, char character)
{
    const size_t length = strlen(word->text);
    if (length + 1 < sizeof word->text) {
        word->text[length] = character;
        word->text[length + 1] = '\0';
    }
}

// Read up to the closing character, which is not part of the word, or to the line's end.
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

static int is_word_character(char character)
{
    return isalnum((unsigned char)character) || character == '_' || character == '$' ||
           (unsigned char)character >= 0x80;
}

SourceWord source_next(SourceReader *reader)
{
    const int begins_source = reader->line == 1 && !reader->in_directive;
    const int begins_line = blanks_pass(reader) || begins_source;
    SourceWord word = {.line = reader->line};
    const char first = peek(reader);
    if (begins_line && first == '#') {
        reader->in_directive = 1;
    }
    word.in_directive = reader->in_directive;
    if (first == '\0') {
        return word;
    }
    if (is_word_character(first)) {
        word.kind = SOURCE_NAME;
        while (is_word_character(peek(reader))) {
            word_append(&word, take(reader));
        }
        reader->expects_header = word.in_directive && (strcmp(word.text, "include") == 0 ||
                                                       strcmp(word.text, "include_next") == 0 ||
                                                       strcmp(word.text, "embed") == 0);
    } else if (first == '"') {
        word.kind = SOURCE_STRING;
        quoted_read(reader, &word, '"');
    } else if (first == '<' && reader->expects_header) {
        word.kind = SOURCE_HEADER;
        quoted_read(reader, &word, '>');
    } else if (first == '\'') {
        word.kind = SOURCE_SIGN;
        quoted_read(reader, &word, '\'');
        strcpy(word.text, "'");
    } else {
        word.kind = SOURCE_SIGN;
        word_append(&word, take(reader));
        if (first == '-' && peek(reader) == '>') {
            word_append(&word, take(reader));
        }
    }
    return word;
}

int source_is(const SourceWord *word, SourceKind kind, const char *text)
{
    return word->kind == kind && strcmp(word->text, text) == 0;
}

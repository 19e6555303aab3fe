// The words of a source (see source_tokens.h), read as a compiler's first phases do: lines that end
// in a backslash are joined, comments are blanks, # begins a directive where it is the first of its
// line. Trigraphs, which gcc ignores too, are not known.
//
// Flow: a submission's files -> WORDS -> what stands out. Read next: stands_out.c.
#include "source_tokens.h"

#include <ctype.h>
#include <string.h>

TokenReader token_reader(const char *source)
{
    return (TokenReader){.text = source, .line = 1};
}

// Pass by the backslashes that join lines, so that reader->text stands on a character that counts.
static void splices_pass(TokenReader *reader)
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

static char peek(TokenReader *reader)
{
    splices_pass(reader);
    return *reader->text;
}

static char take(TokenReader *reader)
{
    const char character = peek(reader);
    if (character != '\0') {
        reader->text++;
        reader->line += character == '\n';
    }
    return character;
}

// The character behind the next one.
static char peek_second(TokenReader *reader)
{
    TokenReader ahead = *reader;
    take(&ahead);
    return peek(&ahead);
}

static void comment_pass(TokenReader *reader)
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
static int blanks_pass(TokenReader *reader)
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

static void token_append(Token *token, char character)
{
    const size_t length = strlen(token->text);
    if (length + 1 < sizeof token->text) {
        token->text[length] = character;
        token->text[length + 1] = '\0';
    }
}

// Read up to the closing character, which is not part of the token, or to the line's end.
static void quoted_read(TokenReader *reader, Token *token, char closing)
{
    take(reader);
    while (peek(reader) != '\0' && peek(reader) != '\n') {
        const char character = take(reader);
        if (character == closing) {
            return;
        }
        token_append(token, character);
        if (character == '\\' && closing != '>' && peek(reader) != '\n') {
            token_append(token, take(reader));
        }
    }
}

static int is_word_character(char character)
{
    return isalnum((unsigned char)character) || character == '_' || character == '$' ||
           (unsigned char)character >= 0x80;
}

Token token_next(TokenReader *reader)
{
    const int begins_source = reader->line == 1 && !reader->in_directive;
    const int begins_line = blanks_pass(reader) || begins_source;
    Token token = {.line = reader->line};
    const char first = peek(reader);
    if (begins_line && first == '#') {
        reader->in_directive = 1;
    }
    token.in_directive = reader->in_directive;
    if (first == '\0') {
        return token;
    }
    if (is_word_character(first)) {
        token.kind = TOKEN_WORD;
        while (is_word_character(peek(reader))) {
            token_append(&token, take(reader));
        }
        reader->expects_header = token.in_directive && (strcmp(token.text, "include") == 0 ||
                                                        strcmp(token.text, "include_next") == 0 ||
                                                        strcmp(token.text, "embed") == 0);
    } else if (first == '"') {
        token.kind = TOKEN_STRING;
        quoted_read(reader, &token, '"');
    } else if (first == '<' && reader->expects_header) {
        token.kind = TOKEN_HEADER;
        quoted_read(reader, &token, '>');
    } else if (first == '\'') {
        token.kind = TOKEN_SIGN;
        quoted_read(reader, &token, '\'');
        strcpy(token.text, "'");
    } else {
        token.kind = TOKEN_SIGN;
        token_append(&token, take(reader));
        if (first == '-' && peek(reader) == '>') {
            token_append(&token, take(reader));
        }
    }
    return token;
}

int source_token_is(const Token *token, TokenKind kind, const char *text)
{
    return token->kind == kind && strcmp(token->text, text) == 0;
}

// Splitting a text into tokens, the longest first where several fit.
#include "c_tokens.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// How many bytes a comment, a directive or blanks take up at `text`; 0 when a token starts there.
static size_t skipped_length(const char *text, int at_line_start)
{
    if (isspace((unsigned char)*text)) {
        return strspn(text, " \t\r\n\v\f");
    }
    if (strncmp(text, "//", 2) == 0 || (*text == '#' && at_line_start)) {
        size_t length = strcspn(text, "\n");
        // A backslash at its end draws the next line in.
        while (text[length] == '\n' && text[length - 1] == '\\') {
            length += 1 + strcspn(text + length + 1, "\n");
        }
        return length;
    }
    if (strncmp(text, "/*", 2) == 0) {
        const char *end = strstr(text + 2, "*/");
        return end != NULL ? (size_t)(end + 2 - text) : strlen(text);
    }
    return 0;
}

// A string or character constant with its quotes, up to the line's end if the second is missing.
static size_t quoted_length(const char *text)
{
    size_t length = 1;
    while (text[length] != '\0' && text[length] != '\n' && text[length] != text[0]) {
        length += text[length] == '\\' && text[length + 1] != '\0' ? 2 : 1;
    }
    return length + (text[length] == text[0]);
}

// As the C standard's "preprocessing number": 0x1Fu, 1e-3f, .5f.
static size_t number_length(const char *text)
{
    size_t length = 1;
    const int is_hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const char *exponent = is_hexadecimal ? "pP" : "eE";
    while (isalnum((unsigned char)text[length]) || text[length] == '.' ||
           ((text[length] == '+' || text[length] == '-') &&
            strchr(exponent, text[length - 1]) != NULL)) {
        length++;
    }
    return length;
}

static size_t sign_length(const char *text)
{
    static const char *const signs[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
                                        "<=",  ">=",  "==",  "!=", "&&", "||", "*=", "/=",
                                        "%=",  "+=",  "-=",  "&=", "^=", "|="};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (strncmp(text, signs[i], strlen(signs[i])) == 0) {
            return strlen(signs[i]);
        }
    }
    return 1;
}

// The token at the start of `text`, which is neither blank nor empty.
static Token first_token(const char *text)
{
    const unsigned char first = (unsigned char)text[0];
    if (isalpha(first) || first == '_') {
        size_t length = 1;
        while (isalnum((unsigned char)text[length]) || text[length] == '_') {
            length++;
        }
        return (Token){TOKEN_NAME, text, length};
    }
    if (isdigit(first) || (first == '.' && isdigit((unsigned char)text[1]))) {
        return (Token){TOKEN_NUMBER, text, number_length(text)};
    }
    if (first == '"' || first == '\'') {
        return (Token){TOKEN_QUOTED, text, quoted_length(text)};
    }
    return (Token){TOKEN_SIGN, text, sign_length(text)};
}

Token *c_tokens(const char *text, int *n_tokens)
{
    *n_tokens = 0;
    // No token is shorter than a byte.
    Token *tokens = malloc((strlen(text) + 1) * sizeof *tokens);
    const char *line = text;  // the first byte of the line that is neither blank nor comment
    while (tokens != NULL && *text != '\0') {
        const size_t skipped = skipped_length(text, text == line);
        if (skipped > 0) {
            const int still_at_start = text == line || memchr(text, '\n', skipped) != NULL;
            text += skipped;
            line = still_at_start ? text : line;
            continue;
        }
        const Token token = first_token(text);
        tokens[(*n_tokens)++] = token;
        text += token.length;
    }
    return tokens;
}

int token_is(Token token, const char *word)
{
    return strlen(word) == token.length && memcmp(word, token.start, token.length) == 0;
}

int token_is_one_of(Token token, const char *words)
{
    while (*words != '\0') {
        const size_t length = strcspn(words, " ");
        if (length == token.length && memcmp(words, token.start, length) == 0) {
            return 1;
        }
        words += length + (words[length] == ' ');
    }
    return 0;
}

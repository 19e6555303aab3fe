// The words of a C or OpenCL C source, without its comments, for a look at what somebody wrote.
#ifndef GRADER_SOURCE_TOKENS_H
#define GRADER_SOURCE_TOKENS_H

typedef enum TokenKind {
    TOKEN_END,
    TOKEN_WORD,    // a name, a keyword or a number
    TOKEN_STRING,  // what stands between the quotes, escapes as they were written
    TOKEN_HEADER,  // what stands between < and > of an #include
    TOKEN_SIGN,    // one character; "->" is the only one of two
} TokenKind;

enum { TOKEN_BYTES = 96 };

typedef struct Token {
    TokenKind kind;
    char text[TOKEN_BYTES];  // cut off where it is longer
    int line;                // where it begins, from 1
    int in_directive;        // it belongs to a line that begins with #
} Token;

typedef struct TokenReader {
    const char *text;  // the rest of the source
    int line;
    int in_directive;
    int expects_header;  // < opens a header's name
} TokenReader;

// Start with a whole source, NUL-terminated; it must outlive the reader.
TokenReader token_reader(const char *source);

// Read the next token; TOKEN_END at the end, again and again. Broken sources are read somehow: an
// open string ends with its line, an open comment with the source.
Token token_next(TokenReader *reader);

// Is the token this word or sign?
int source_token_is(const Token *token, TokenKind kind, const char *text);

#endif

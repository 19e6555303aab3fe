// Tokens of a C or OpenCL text: what a compiler reads as one word. Not a preprocessor: a line that
// starts with # is skipped like a comment.
//
// Flow: a solution's hole -> TOKENS -> mutations -> session. Read next: mutations.h.
#ifndef GRADER_C_TOKENS_H
#define GRADER_C_TOKENS_H

#include <stddef.h>

typedef enum TokenKind { TOKEN_NAME, TOKEN_NUMBER, TOKEN_QUOTED, TOKEN_SIGN } TokenKind;

typedef struct Token {
    TokenKind kind;
    const char *start;  // in the text
    size_t length;
} Token;

// Split a text. Comments and blanks are left out; an unfinished comment or string goes up to the
// end. Returns the tokens, free() them, and their number in *n_tokens; NULL when memory runs out.
Token *c_tokens(const char *text, int *n_tokens);

// Is the token this word or sign?
int token_is(Token token, const char *word);

// Is it one of these, separated by single blanks?
int token_is_one_of(Token token, const char *words);

#endif

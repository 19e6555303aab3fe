// Is an answer what was handed out? (See untouched.h.)
#include "untouched.h"

#include "skeleton.h"
#include "source_words.h"

#include <stdlib.h>
#include <string.h>

typedef enum Likeness {
    OTHER_WORDS,
    BEGINS_ALIKE,  // the first text has all words of the second, and more behind them
    SAME_WORDS,
} Likeness;

// What have two texts in common for a compiler? Comments and blanks say nothing.
static Likeness words_compare(const char *a, const char *b)
{
    SourceReader own = source_reader(a), handed_out = source_reader(b);
    SourceWord x, y;
    do {
        x = source_next(&own);
        y = source_next(&handed_out);
    } while (x.kind == y.kind && x.length == y.length && memcmp(x.start, y.start, x.length) == 0 &&
             x.kind != SOURCE_END);
    return y.kind != SOURCE_END ? OTHER_WORDS : x.kind != SOURCE_END ? BEGINS_ALIKE : SAME_WORDS;
}

int answer_is_untouched(const Manifest *manifest, const Task *task, const char *answer)
{
    char *placeholder = placeholder_read(manifest, task);
    const int is_same = placeholder != NULL && words_compare(answer, placeholder) == SAME_WORDS;
    free(placeholder);
    return is_same;
}

int answer_returns_as_handed_out(const Manifest *manifest, const Task *task, const char *answer)
{
    char *placeholder = placeholder_read(manifest, task);
    // The lines before it only keep a compiler silent, and may be gone.
    const char *its_return = placeholder != NULL ? strstr(placeholder, "return") : NULL;
    const int returns = its_return != NULL && (words_compare(answer, placeholder) == BEGINS_ALIKE ||
                                               words_compare(answer, its_return) == BEGINS_ALIKE);
    free(placeholder);
    return returns;
}

// The words of a C or OpenCL C source, without its comments: what a compiler reads as one.
//
// Read next: stands_out.h, mutations.h.
#ifndef GRADER_SOURCE_WORDS_H
#define GRADER_SOURCE_WORDS_H

#include <stddef.h>

typedef enum SourceKind {
    SOURCE_END,
    SOURCE_NAME,       // a name or a keyword
    SOURCE_NUMBER,     // with its exponent and suffix: 0x1Fu, 1e-3f, .5f
    SOURCE_STRING,     // what stands between the quotes, escapes as they were written
    SOURCE_CHARACTER,  // the same of 'c'
    SOURCE_HEADER,     // what stands between < and > of an #include
    SOURCE_SIGN,       // the longest that fits: <<= rather than <<
} SourceKind;

enum { SOURCE_WORD_BYTES = 96 };

typedef struct SourceWord {
    SourceKind kind;
    char text[SOURCE_WORD_BYTES];  // cut off where it is longer
    const char *start;             // where it stands in the source, quotes and all
    size_t length;
    int line;              // where it begins, from 1
    int in_directive;      // it belongs to a line that begins with #
    int begins_directive;  // it is that #
} SourceWord;

typedef struct SourceReader {
    const char *text;  // the rest of the source
    int line;
    int at_line_start;
    int in_directive;
    int expects_header;  // < opens a header's name
} SourceReader;

// Start with a whole source, NUL-terminated; it must outlive the reader and its words.
SourceReader source_reader(const char *source);

// Read the next one; SOURCE_END at the end, again and again. Broken sources are read somehow: an
// open string ends with its line, an open comment with the source.
SourceWord source_next(SourceReader *reader);

// The name of the next macro that the source defines, but for those behind #if 0; SOURCE_END where
// there is no more.
SourceWord source_next_macro(SourceReader *reader);

// All words but those of directives: *n_words of them, free() the array. NULL when memory runs out.
SourceWord *source_words(const char *source, int *n_words);

// Is the word of this kind and text?
int source_is(const SourceWord *word, SourceKind kind, const char *text);

// Does one of these, separated by single blanks, stand in the source?
int source_is_one_of(const SourceWord *word, const char *words);

#endif

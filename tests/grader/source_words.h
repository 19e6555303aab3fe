// The words of a C or OpenCL C source, without its comments, for a look at what somebody wrote.
#ifndef GRADER_SOURCE_WORDS_H
#define GRADER_SOURCE_WORDS_H

typedef enum SourceKind {
    SOURCE_END,
    SOURCE_NAME,    // a name, a keyword or a number
    SOURCE_STRING,  // what stands between the quotes, escapes as they were written
    SOURCE_HEADER,  // what stands between < and > of an #include
    SOURCE_SIGN,    // one character; "->" is the only one of two
} SourceKind;

enum { SOURCE_WORD_BYTES = 96 };

typedef struct SourceWord {
    SourceKind kind;
    char text[SOURCE_WORD_BYTES];  // cut off where it is longer
    int line;                      // where it begins, from 1
    int in_directive;              // it belongs to a line that begins with #
} SourceWord;

typedef struct SourceReader {
    const char *text;  // the rest of the source
    int line;
    int in_directive;
    int expects_header;  // < opens a header's name
} SourceReader;

// Start with a whole source, NUL-terminated; it must outlive the reader.
SourceReader source_reader(const char *source);

// Read the next one; SOURCE_END at the end, again and again. Broken sources are read somehow: an
// open string ends with its line, an open comment with the source.
SourceWord source_next(SourceReader *reader);

// Is the word this word or sign?
int source_is(const SourceWord *word, SourceKind kind, const char *text);

#endif

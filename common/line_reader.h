// Text files, line by line, and complaints that name the line: what all readers of scenes share.
//
// Used by scene2d_csv.c, scene3d_nff.c and molecule.c. Read next: number.h.
#ifndef COMMON_LINE_READER_H
#define COMMON_LINE_READER_H

#include "clean_text.h"

#include <stdint.h>
#include <stdio.h>

// A line of a scene needs some 80 characters. What is longer is no scene.
#define LINE_MAX_LENGTH 4096

typedef struct LineReader {
    FILE *file;
    const char *name;                // what messages call the file
    int64_t line;                    // the current line, counts from 1
    int failed;                      // a message was printed
    int64_t unended_line;            // the line in which the file ended; 0 until it did
    char text[LINE_MAX_LENGTH + 1];  // the current line without its end
} LineReader;

// Get ready to read the first line of a file, which stays the caller's to close.
//   name   what messages call the file; must outlive the reader
void line_reader_begin(LineReader *reader, FILE *file, const char *name);

// Read the next line to reader->text. A byte order mark before the first line is left out; of
// "\r\n" the "\r" stays. Returns 1, or 0 when there is none: at the end of the file (reader->line
// is then the number that the next line would have), or after a fault: a line that is too long, a
// NUL byte, a file that cannot be read.
int line_read(LineReader *reader);

// The same for a line of which little is read, such as a comment: what does not fit is passed over.
//   word   must not begin behind what fits: there it is a fault. NULL: all must fit
int line_read_start(LineReader *reader, const char *word);

// Complain about the current line: "name:line: {where}found {found}, expected {expected}". Only the
// first fault is printed, so that a bad file gives one message.
void line_fault(LineReader *reader, const char *where, const char *found, const char *expected);

// What is to be said of a file that could be read, as one warning.
//   warning   or "": then only of a last line without a line end. A file that ends so may have been
//             cut, and nothing but its writer knows; or it lacks no more than that.
void line_warn(const LineReader *reader, const char *warning);

// Text from a file, fit for a message (clean_text.h): in quotes, at most 40 bytes of it. `quoted`
// holds LINE_QUOTE_SIZE bytes. Returns it.
enum { LINE_QUOTE_BYTES = 40, LINE_QUOTE_SIZE = CLEAN_TEXT_GROWTH * LINE_QUOTE_BYTES + 8 };
const char *line_quote(const char *text, char *quoted);

// Cut a line into words at spaces, tabs and "\r", in place.
//   words[max_words]   where they begin; each ends with a NUL
// Returns how many words the line has, which may be more than max_words.
int line_split(char *line, char **words, int max_words);

#endif

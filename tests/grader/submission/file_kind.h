// What a file that is no archive, or no source text, seems to be, for the message to the student
// who handed it in.
#ifndef GRADER_FILE_KIND_H
#define GRADER_FILE_KIND_H

#include <stddef.h>

typedef struct FileKind {
    const char *name;   // "a RAR archive", "a single text file"
    const char *fault;  // what is wrong with it where it is no archive that is read; "" if no
                        // such file is read
    int is_text;
} FileKind;

// By the first bytes of the file, some hundred.
FileKind file_kind(const unsigned char *bytes, size_t n_bytes);

// Is there nothing in a file but blanks, and perhaps the mark of UTF-8?
int file_is_blank(const unsigned char *bytes, size_t n_bytes);

#endif

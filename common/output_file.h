// A file that appears whole or not at all: pictures, statistics and figures are written through it.
//
// It is written under another name in the same folder and renamed when it is complete, so that a
// reader never sees half a file and a failed run leaves the old one as it was.
// Read next: image.h, stats.h.
#ifndef COMMON_OUTPUT_FILE_H
#define COMMON_OUTPUT_FILE_H

#include <stdio.h>

typedef struct OutputFile {
    FILE *file;          // open for writing; binary
    char *path;          // where the file will appear
    char *partial_path;  // where it is being written, in the same folder
    int descriptor;      // of the partial file
    int fault;           // errno of the first write that failed, or 0
} OutputFile;

// Begin a file. `path` itself is not touched before output_file_commit(). What exists there already
// must be a regular file: renaming over a device or a pipe would destroy it.
//   output   stays where it is until the file is committed or given up: the stream points to it
// Returns 0, or -1 after one message on stderr.
int output_file_open(OutputFile *output, const char *path);

// See to it that all that was printed so far is on the disk, under the partial name. For two files
// that are to appear both or neither: store the one, commit the other, then this one.
// Returns 0, or -1 after one message on stderr.
int output_file_store(OutputFile *output);

// Close the file and give it its name, with the access rights of any newly made file.
// Returns 0, or -1 after one message on stderr when something could not be written; the file is
// then gone, and what was at `path` before is still there.
int output_file_commit(OutputFile *output);

// Give the file up: nothing stays behind. A zeroed OutputFile is fine, and so is a committed one.
void output_file_discard(OutputFile *output);

#endif

// What a student has saved: the bytes of the lab's files, seen by looking and not by being told.
//
// Looking forty times a second finds every way in which an editor saves (in place, twice, by
// renaming, through a folder of another system), on every file system; inotify does not hear what
// is written on the other side of a network or of WSL.
#ifndef DESK_SAVED_H
#define DESK_SAVED_H

#include <stdint.h>

enum { SAVED_MAX_FILES = 32 };

typedef struct SavedFiles {
    int n_files;
    char names[SAVED_MAX_FILES][64];
    uint64_t sums[SAVED_MAX_FILES];  // of the bytes
    uint64_t sum;                    // of all names and bytes
} SavedFiles;

// Look at the sources and headers in a folder. Names are in order.
void saved_look(const char *folder, SavedFiles *files);

// Write the names of those that differ into a line: "a.c, b.cl". Returns `line`.
char *saved_changes(const SavedFiles *before, const SavedFiles *now, char *line, int n_bytes);

// What make has to make anew, whatever the files' times say: the C files and headers that differ,
// and main.c where a file is gone or new.
//   names   out: NULL-terminated; they live as long as `now`
void saved_to_make(const SavedFiles *before, const SavedFiles *now,
                   const char *names[SAVED_MAX_FILES + 1]);

#endif

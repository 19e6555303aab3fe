// What is in an entry of a class, as a hash: another hash means that it has to be graded again.
//
// Whoever handed it in may want the class to wait, so only so much of it is looked into. Called by
// gradebook_tool.c. Read next: class_keys.h.
#ifndef CLASS_ENTRY_CONTENT_H
#define CLASS_ENTRY_CONTENT_H

enum {
    CONTENT_HEX = 65,             // bytes of a hash as text
    CONTENT_MOST_FILES = 100000,  // and folders, as in an export that is an archive
    CONTENT_MOST_NAMES_MB = 64,   // of their paths
    CONTENT_MOST_DEPTH = 64,      // folders in each other
    CONTENT_MOST_FILE_MB = 64,    // no larger one is graded (submission.h)
    CONTENT_MOST_MB = 128,  // of all files together, the smallest first: those hold the answers
};

// Hash the names, kinds and sizes of all that is in an entry, and the bytes of its files. No link
// in it is followed.
//   path   the entry: a folder, or a file
// Returns 0; 1 if there is more than the limits allow: then the hash is another one each time, as
// nobody knows what has changed beyond them; or -1 when memory runs out.
int entry_content(const char *path, char hex[CONTENT_HEX]);

#endif

// What an archive holds, for messages where one of the wanted files is not in it.
#ifndef GRADER_CONTENTS_H
#define GRADER_CONTENTS_H

#include "message.h"

#include <stddef.h>

enum { CONTENTS_MAX_SHOWN = 6 };

typedef struct Contents {
    int n_files;
    char shown[CONTENTS_MAX_SHOWN][MESSAGE_SHOWN_BYTES];  // paths of the first ones
    int is_office;   // a document of an office program, which is a zip archive, too
    char inner[64];  // the name of an archive in it, or ""
} Contents;

// Does a file's name end as those of archives do? Returns the length without that ending, or 0.
int archive_stem_length(const char *path);

// Note a file's path. It may be any text.
void contents_note(Contents *contents, const char *path);

// Write a message about an archive with none of the wanted files, where something in it explains
// that. Returns 1, or 0 where nothing does.
int contents_explain(const Contents *contents, char *message, size_t n_bytes);

// Write a line that lists what is in the archive.
void contents_list(const Contents *contents, char *message, size_t n_bytes);

#endif

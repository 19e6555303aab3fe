// A whole text file in memory.
#ifndef COMMON_TEXT_FILE_H
#define COMMON_TEXT_FILE_H

// Read a file. Returns its text, NUL-terminated, free() it; or NULL after one message on stderr that
// names the file and the reason.
char *text_file_read(const char *path);

#endif

// A whole text file in memory.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: cl_build.c, which reads
// programs with it.
#ifndef COMMON_TEXT_FILE_H
#define COMMON_TEXT_FILE_H

// Read a file. Returns its text, NUL-terminated, free() it; or NULL after one message on stderr
// that names the file and the reason. A NUL byte in the file is one: the text would end there.
char *text_file_read(const char *path);

#endif

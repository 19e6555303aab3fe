// Text files: opened to be read, or whole in memory.
//
// Read next: cl_build.c, which reads programs with it, and scene3d.c, which opens scenes.
// image_file.c opens pictures with it first.
#ifndef COMMON_TEXT_FILE_H
#define COMMON_TEXT_FILE_H

#include <stdio.h>

// Open a file for reading. Only a regular file will do, also through a link: a pipe that nobody
// writes to, or a terminal, would be waited for without an end. Returns it, or NULL after one
// message on stderr that names the file and the reason.
FILE *text_file_open(const char *path);

// Read a file. Returns its text, NUL-terminated, free() it; or NULL after one message on stderr
// that names the file and the reason. A NUL byte in the file is one: the text would end there.
char *text_file_read(const char *path);

// Line `number` of a text, from 1, where it stands there; NULL where the text has no such line.
//   length   out: without its newline
const char *text_line(const char *text, int number, size_t *length);

#endif

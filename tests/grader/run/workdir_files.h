// Folders and copies inside the workdir, with one message on stderr where the machine refuses.
#ifndef GRADER_WORKDIR_FILES_H
#define GRADER_WORKDIR_FILES_H

// Make a folder that everybody may read, or use the one that is there. Returns 0, or -1 after one
// message.
int make_folder(const char *path);

// The same, closed to all but the run that is given it: other runs may be as curious as other
// users.
int make_closed_folder(const char *path);

// Write a text to a file that everybody may read. Returns 0, or -1 after one message.
int write_file(const char *path, const char *text);

// Copy one of the instructor's own files; it stays as executable as it was. Returns 0, or -1 after
// one message.
int copy_file(const char *from, const char *to);

#endif

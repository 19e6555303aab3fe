// The folder in which programs are started: the course's top folder.
//
// Kernels, labs and the folder build are found from there. Read next: options.c.
#ifndef COMMON_COURSE_FOLDER_H
#define COMMON_COURSE_FOLDER_H

// Is this the course's top folder, or a handout's? Returns 0, or -1 after one message on stderr
// that says where to go.
//   program   what messages call the program
int course_folder_check(const char *program);

#endif

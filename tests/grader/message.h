// Messages for students, made like printf makes them.
#ifndef GRADER_MESSAGE_H
#define GRADER_MESSAGE_H

// A new message; free() it. Running out of memory ends the program.
__attribute__((format(printf, 1, 2))) char *message_new(const char *format, ...);

#endif

// What else ILIAS writes: names in ASCII, times before files' names, marks of late work.
#ifndef CLASS_ILIAS_H
#define CLASS_ILIAS_H

#include "course_system.h"

// Has a folder's name all four parts of ILIAS', last name, first name, login and number? Of three,
// "lab_ada_2", only the files in it say that it is ILIAS'.
int ilias_name_is_whole(const char *entry);

// Older releases of ILIAS put the time before each file's name, "20261103102233_17_file.cl".
// Returns how long that is, or 0.
size_t ilias_time_length(const char *file);

// Write "Mueller_Joerg" for "Müller_Jörg", "Rene" for "René", "__ukasz" for "Łukasz": umlauts
// become two letters, other letters of Latin-1 and Greek one; every byte of most others becomes an
// underscore, and so does every sign that no file's name may have. What is too long is cut.
void ilias_name_make(const char *name, char *ascii, size_t n_ascii);

// Has ILIAS put "Late Submission - " before a file's name? Or may it have, in another language?
int ilias_is_marked(const char *file);
int ilias_may_be_marked(const char *file);

#endif

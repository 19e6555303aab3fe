// A name as ILIAS makes a folder's name of it: ASCII only.
#ifndef CLASS_ILIAS_NAME_H
#define CLASS_ILIAS_NAME_H

#include <stddef.h>

// Write "Mueller_Joerg" for "Müller_Jörg", "Rene" for "René", "__ukasz" for "Łukasz": umlauts
// become two letters, other letters of Latin-1 and Greek one; every byte of most others becomes an
// underscore, and so does every sign that no file's name may have. What is too long is cut.
void ilias_name_make(const char *name, char *ascii, size_t n_ascii);

#endif

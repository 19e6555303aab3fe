// A name as ILIAS makes a folder's name of it: ASCII only.
#ifndef CLASS_ILIAS_NAME_H
#define CLASS_ILIAS_NAME_H

#include <stddef.h>

// Write "Mueller_Joerg" for "Müller_Jörg", "Rene" for "René", and "__ukasz" for "Łukasz": umlauts
// become two letters, other letters of Latin-1 and Greek one, and every byte of most others, as every
// sign that no file's name may have, an underscore. What is too long is cut.
void ilias_name_make(const char *name, char *ascii, size_t n_ascii);

#endif

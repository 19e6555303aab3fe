// The names that a skeleton declares where a hole begins: parameters, variables, functions.
#ifndef COPIES_SCOPE_H
#define COPIES_SCOPE_H

#include "form_list.h"

// All names of hole `id` that stand before it and in a block around it, or in none; those of blocks
// that ended before are not among them, nor are members. Of a text without the hole there are none.
// name_set_free() them. Running out of memory ends the program.
NameSet scope_names(const char *skeleton, const char *id);

#endif

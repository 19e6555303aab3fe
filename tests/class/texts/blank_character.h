// Characters of which there is nothing to see: blanks of any width, controls, fillers, marks that
// only change others. A name may be full of them, and a spreadsheet may pass over them.
#ifndef CLASS_BLANK_CHARACTER_H
#define CLASS_BLANK_CHARACTER_H

#include <stdint.h>

// Is there nothing to see of it by itself? What Unicode has not assigned counts as such, too.
int character_is_blank(uint32_t code);

#endif

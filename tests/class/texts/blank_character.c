// Looking for characters that are not seen, by Unicode's own properties (see blank_character.h).
//
// Used by name_likeness.c and csv_cell.c.
#include "blank_character.h"

#include <unicode/uchar.h>

int character_is_blank(uint32_t code)
{
    // Of all patterns of Braille this one has no dot; Unicode calls it a symbol.
    enum { BRAILLE_BLANK = 0x2800 };
    const UChar32 character = (UChar32)code;
    return code == BRAILLE_BLANK || u_isUWhiteSpace(character) ||
           u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT) ||
           (U_GET_GC_MASK(character) & (U_GC_C_MASK | U_GC_Z_MASK)) != 0;
}

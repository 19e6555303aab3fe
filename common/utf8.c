// Characters of UTF-8 (see utf8.h).
//
// Read next: clean_text.c.
#include "utf8.h"

int utf8_goes_on(char byte)
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

int utf8_read(const char *text, uint32_t *character)
{
    // The lowest character that needs as many bytes.
    static const uint32_t LOWEST[] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char first = (unsigned char)text[0];
    const int length = first < 0x80             ? 1
                       : (first & 0xE0) == 0xC0 ? 2
                       : (first & 0xF0) == 0xE0 ? 3
                       : (first & 0xF8) == 0xF0 ? 4
                                                : 0;
    uint32_t read = length == 1 ? first : first & (0x7Fu >> length);
    for (int i = 1; i < length; i++) {
        if (!utf8_goes_on(text[i])) {
            return 0;
        }
        read = read << 6 | ((unsigned char)text[i] & 0x3Fu);
    }
    const int is_surrogate = read >= 0xD800 && read <= 0xDFFF;
    if (length == 0 || read < LOWEST[length] || is_surrogate || read > 0x10FFFF) {
        return 0;
    }
    *character = read;
    return length;
}

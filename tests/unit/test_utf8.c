// common/utf8: every character is read as the C library writes it, and nothing else is one.
#include "utf8.h"

#include <criterion/criterion.h>
#include <limits.h>
#include <locale.h>
#include <stdlib.h>
#include <wchar.h>

Test(utf8, every_character_is_read)
{
    cr_assert_not_null(setlocale(LC_CTYPE, "C.UTF-8"));
    for (uint32_t code = 0; code <= 0x10FFFF; code++) {
        char text[MB_LEN_MAX + 1] = "";
        const size_t length = wcrtomb(text, (wchar_t)code, &(mbstate_t){0});
        uint32_t read = 0;
        if (length == (size_t)-1) {
            cr_assert(code >= 0xD800 && code <= 0xDFFF, "U+%04X is no character", code);
            continue;
        }
        cr_assert_eq(utf8_read(text, &read), (int)length, "U+%04X", code);
        cr_assert_eq(read, code);
        for (size_t i = 0; i < length; i++) {
            cr_assert_eq(utf8_goes_on(text[i]), i > 0, "U+%04X, byte %zu", code, i);
        }
    }
}

Test(utf8, what_is_no_character_is_left_alone)
{
    static const char *const texts[] = {
        "\x80",              // goes on with what never began
        "\xC3",              // broken off
        "\xE2\x82",          // broken off
        "\xF0\x9F\x98",      // broken off
        "\xE2\x82x",         // broken off by another character
        "\xC0\xAF",          // longer than needed
        "\xE0\x9F\xBF",      // longer than needed
        "\xF0\x8F\xBF\xBF",  // longer than needed
        "\xED\xA0\x80",      // half of a surrogate pair
        "\xED\xBF\xBF",      // the other half
        "\xF4\x90\x80\x80",  // beyond U+10FFFF
        "\xF8\x88\x80\x80\x80",
        "\xFF",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        uint32_t read = 4711;
        cr_expect_eq(utf8_read(texts[i], &read), 0, "text %zu", i);
        cr_expect_eq(read, 4711, "text %zu", i);
    }
}

// What a name looks like (see name_likeness.h).
//
// The letters here are those that European names are written in, and the ones that are mistaken for
// them; of the Unicode consortium's table of confusables it is a small part, but the part that
// keyboards have. Used by look_alikes.c and owners.c.
#include "name_likeness.h"

#include "clean_text.h"
#include "utf8.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

// The letters U+00C0 to U+017F without their accents.
enum { LATIN_BEGIN = 0xC0, LATIN_END = 0x180 };
static const char latin[] = "aaaaaaaceeeeiiiidnoooooxouuuuypsaaaaaaaceeeeiiiidnooooo/ouuuuypy"
                            "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
                            "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

// Greek and Cyrillic letters that are drawn like Latin ones, a capital and a small one each.
static const struct {
    uint16_t capital, small;
    char letter;
} drawn_alike[] = {
    {0x391, 0x3B1, 'a'}, {0x392, 0x3B2, 'b'},  {0x395, 0x3B5, 'e'}, {0x396, 0x3B6, 'z'},
    {0x397, 0x4BB, 'h'}, {0x399, 0x3B9, 'i'},  {0x39A, 0x3BA, 'k'}, {0x39C, 0x43C, 'm'},
    {0x39D, 0x3B7, 'n'}, {0x39F, 0x3BF, 'o'},  {0x3A1, 0x3C1, 'p'}, {0x3A4, 0x3C4, 't'},
    {0x3A5, 0x443, 'y'}, {0x3A7, 0x3C7, 'x'},  {0x474, 0x3BD, 'v'}, {0x54D, 0x3C5, 'u'},
    {0x410, 0x430, 'a'}, {0x412, 0x432, 'b'},  {0x415, 0x435, 'e'}, {0x401, 0x451, 'e'},
    {0x41A, 0x43A, 'k'}, {0x41C, 0x1D0D, 'm'}, {0x41D, 0x43D, 'h'}, {0x41E, 0x43E, 'o'},
    {0x420, 0x440, 'p'}, {0x421, 0x441, 'c'},  {0x422, 0x442, 't'}, {0x423, 0x4AF, 'y'},
    {0x425, 0x445, 'x'}, {0x405, 0x455, 's'},  {0x406, 0x456, 'i'}, {0x407, 0x457, 'i'},
    {0x408, 0x458, 'j'}, {0x4C0, 0x4CF, 'l'},  {0x500, 0x501, 'd'}, {0x51A, 0x51B, 'q'},
    {0x51C, 0x51D, 'w'}, {0x490, 0x261, 'g'},
};

// The character at *text, which moves behind it. What is not UTF-8 is taken byte by byte.
static uint32_t character_take(const char **text)
{
    uint32_t code = (unsigned char)**text;
    const int length = utf8_read(*text, &code);
    *text += length > 0 ? length : 1;
    return code;
}

// The ASCII character that another one looks like; 0 for none.
static char ascii_of(uint32_t code)
{
    if (code >= LATIN_BEGIN && code < LATIN_END) {
        return latin[code - LATIN_BEGIN];
    }
    if (code >= 0xFF01 && code <= 0xFF5E) {
        return (char)(code - 0xFF01 + '!');  // full width
    }
    if (code >= 0x1D400 && code < 0x1D400 + 13 * 52) {
        return (char)('a' + (code - 0x1D400) % 26);  // bold, italic, script ... of mathematics
    }
    for (size_t i = 0; i < sizeof drawn_alike / sizeof *drawn_alike; i++) {
        if (code == drawn_alike[i].capital || code == drawn_alike[i].small) {
            return drawn_alike[i].letter;
        }
    }
    return 0;
}

// Is there nothing to see of it, or no more than a blank or a stroke? Accents of their own, too:
// some systems write "ü" as "u" and two dots.
static int is_unseen(uint32_t code)
{
    return character_is_unseen(code) || (code >= 0x80 && code < LATIN_BEGIN) ||
           (code >= 0x300 && code < 0x370) || code == 0x115F || code == 0x1160 || code == 0x1680 ||
           (code >= 0x17B4 && code <= 0x17B5) || (code >= 0x180B && code <= 0x180F) ||
           (code >= 0x2000 && code < 0x2070) || code == 0x2212 || code == 0x2800 ||
           code == 0x3000 || code == 0x3164 || (code >= 0xFE00 && code < 0xFE10) ||
           code == 0xFFA0 || (code >= 0xE0100 && code <= 0xE01EF);
}

// "\x0A" stands for a byte that cannot be shown (entry_name.h).
static int is_escape(const char *text)
{
    return text[0] == '\\' && text[1] == 'x' && isxdigit((unsigned char)text[2]) &&
           isxdigit((unsigned char)text[3]);
}

void name_likeness(const char *name, char key[ENTRY_NAME_BYTES])
{
    size_t n = 0;
    while (*name != '\0' && n + 5 < ENTRY_NAME_BYTES) {
        if (is_escape(name)) {
            name += 4;
            continue;
        }
        const char *begin = name;
        const uint32_t code = character_take(&name);
        const char ascii = code < 0x80 ? (char)code : ascii_of(code);
        const char letter = (char)tolower((unsigned char)ascii);
        if (ascii == 0 && !is_unseen(code)) {
            memcpy(key + n, begin, (size_t)(name - begin));
            n += (size_t)(name - begin);
        } else if (isalnum((unsigned char)letter)) {
            key[n++] = letter == '0' ? 'o' : letter == '1' || letter == 'i' ? 'l' : letter;
        }
    }
    key[n] = '\0';
}

int name_stem(const char *name)
{
    const int whole = (int)strlen(name);
    int end = whole;
    while (end > 0 && (name[end - 1] == ' ' || name[end - 1] == '.')) {
        end--;
    }
    const int in_brackets = end > 0 && name[end - 1] == ')';
    int begin = end - in_brackets;
    while (begin > 0 && isdigit((unsigned char)name[begin - 1])) {
        begin--;
    }
    // A year or a student's number is no attempt.
    const int n_digits = end - in_brackets - begin;
    if (n_digits < 1 || n_digits > 2 || begin < 2) {
        return whole;
    }
    const char before = name[begin - 1];
    if (in_brackets ? before != '(' : before != '-' && before != '_' && before != ' ') {
        return whole;
    }
    begin--;
    while (begin > 1 && name[begin - 1] == ' ') {
        begin--;
    }
    return begin;
}

int name_looks_like(const char *name, const char *other)
{
    char keys[2][ENTRY_NAME_BYTES], stem[ENTRY_NAME_BYTES];
    name_likeness(other, keys[1]);
    if (keys[1][0] == '\0') {
        return 0;
    }
    name_likeness(name, keys[0]);
    if (strcmp(keys[0], keys[1]) == 0) {
        return 1;
    }
    snprintf(stem, sizeof stem, "%.*s", name_stem(name), name);
    name_likeness(stem, keys[0]);
    return strcmp(keys[0], keys[1]) == 0;
}

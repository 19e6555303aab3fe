// Writing names as ILIAS does (see ilias_name.h). Its rules are in ilFileUtils::getASCIIFilename().
#include "ilias_name.h"

#include "utf8.h"

#include <string.h>

// PHP knows the letters of Latin-1 and Greek, and some signs, by names such as "eacute" and
// "rsquo", of which the first letter stays.
static const struct {
    uint32_t first;
    const char *letters;
} runs[] = {
    {0xA0, "nicpcybsucolnsrmdpssampmcsorfffi"},
    {0xC0, "AAAAAAACEEEEIIIIENOOOOOtOUUUUYTsaaaaaaaceeeeiiiienooooodouuuuyty"},
    {0x152, "Oo"},
    {0x160, "Ss"},
    {0x391, "ABGDEZETIKLMNXOPR"},
    {0x3A3, "STUPCPO"},
    {0x3B1, "abgdezetiklmnxoprsstupcpo"},
    {0x2018, "lrs"},
    {0x201C, "lrb"},
};
static const struct {
    uint32_t code;
    const char *text;
} others[] = {
    {0xC4, "Ae"}, {0xD6, "Oe"}, {0xDC, "Ue"},  {0xE4, "ae"},  {0xF6, "oe"},  {0xFC, "ue"},
    {0xDF, "ss"}, {0x178, "Y"}, {0x2013, "n"}, {0x2014, "m"}, {0x2026, "h"}, {'&', "a"},
    {'<', "l"},   {'>', "g"},   {':', "_"},    {'\\', "_"},   {'/', "_"},    {'*', "_"},
    {'?', "_"},   {'"', "_"},   {'|', "_"},
};

// What a character becomes: nothing where it has no name.
static void ascii_of(uint32_t code, char text[3])
{
    text[0] = text[1] = text[2] = '\0';
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        if (others[i].code == code) {
            memcpy(text, others[i].text, strlen(others[i].text));
            return;
        }
    }
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
        if (code >= runs[i].first && code - runs[i].first < strlen(runs[i].letters)) {
            text[0] = runs[i].letters[code - runs[i].first];
        }
    }
}

void ilias_name_make(const char *name, char *ascii, size_t n_ascii)
{
    size_t n = 0;
    while (*name != '\0') {
        uint32_t code = 0;
        const int length = utf8_read(name, &code);
        const size_t n_bytes = length > 0 ? (size_t)length : 1;
        char text[8] = "";
        ascii_of(code, text);
        if (text[0] == '\0') {
            memcpy(text, n_bytes == 1 && (unsigned char)*name < 0x7F ? name : "____", n_bytes);
            text[n_bytes] = '\0';
        }
        const size_t n_text = strlen(text);
        if (n + n_text >= n_ascii) {
            break;
        }
        memcpy(ascii + n, text, n_text);
        n += n_text;
        name += n_bytes;
    }
    ascii[n] = '\0';
}

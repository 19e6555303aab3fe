// ILIAS: a folder "Lovelace_Ada_ada_1234" (see ilias.h, course_system.h). How it writes names in
// ASCII is in ilFileUtils::getASCIIFilename().
#include "ilias.h"

#include "utf8.h"

#include <string.h>

// ---- Names -------------------------------------------------------------------------------------

static SystemName read_ilias(const char *entry)
{
    NamePart parts[NAME_PARTS];
    SystemName name = {0};
    if (name_matches("^(.+)_([^_]+)_([0-9]+)$", entry, parts)) {
        name.system = SYSTEM_ILIAS;
        name.name = parts[1], name.login = parts[2], name.number = parts[3];
    }
    return name;
}

int ilias_name_is_whole(const char *entry)
{
    NamePart parts[NAME_PARTS];
    return name_matches("^.+_.*_[^_]+_[0-9]+$", entry, parts);
}

size_t ilias_time_length(const char *file)
{
    NamePart parts[NAME_PARTS];
    return name_matches("^([0-9]{14}_[0-9]+_).", file, parts) ? parts[1].length : 0;
}

// ---- ASCII -------------------------------------------------------------------------------------

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

// ---- Late work ---------------------------------------------------------------------------------

// ILIAS has put "Late Submission - ", in its language, before the name, and made the whole ASCII.
int ilias_is_marked(const char *file)
{
    static const char *const marks[] = {"Late Submission - ", "Verspätete Abgabe - "};
    char ascii[64];
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
        ilias_name_make(marks[i], ascii, sizeof ascii);
        if (strncmp(file, marks[i], strlen(marks[i])) == 0 ||
            strncmp(file, ascii, strlen(ascii)) == 0) {
            return 1;
        }
    }
    return 0;
}

// In other languages the mark is other words, which have no digits.
int ilias_may_be_marked(const char *file)
{
    const char *end = strstr(file, " - ");
    return end != NULL && strcspn(file, "0123456789") > (size_t)(end - file);
}

const CourseSystem ilias_system = {
    .title = "ILIAS",
    .identity = "the name of the student's folder",
    .identity_writer = WRITER_SYSTEM,
    .time = "the time before the name of each file; newer releases write only a mark",
    .time_writer = WRITER_SYSTEM,
    .read = read_ilias,
};

// Which names stand for a wanted file (see file_names.h).
#include "file_names.h"

#include <ctype.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// A part of a name.
typedef struct Part {
    const char *start, *end;
} Part;

static size_t part_length(Part part)
{
    return (size_t)(part.end - part.start);
}

// Drop decimal digits from the end. Returns how many.
static int digits_drop(Part *part)
{
    int n = 0;
    while (part->end > part->start && isdigit((unsigned char)part->end[-1])) {
        part->end--;
        n++;
    }
    return n;
}

// Drop a text from the end. Returns whether it was there.
static int text_drop(Part *part, const char *text)
{
    const size_t n = strlen(text);
    const int is_there = part_length(*part) >= n && memcmp(part->end - n, text, n) == 0;
    part->end -= is_there ? n : 0;
    return is_there;
}

// ---- Names that a system changed ----------------------------------------------------------------

// Moodle, without a folder for each student: "Jane Doe_123456_assignsubmission_file_".
static int is_of_moodle(Part prefix)
{
    return text_drop(&prefix, "_assignsubmission_file_") && part_length(prefix) > 0;
}

// ILIAS: "20261103102233_77_", the time of the upload and a number.
static int is_of_ilias(Part prefix)
{
    enum { TIME_DIGITS = 14 };
    return text_drop(&prefix, "_") && digits_drop(&prefix) > 0 && text_drop(&prefix, "_") &&
           digits_drop(&prefix) == TIME_DIGITS && part_length(prefix) == 0;
}

// Newer releases of ILIAS: "Late Submission - ", or the same in German.
static int is_of_ilias_late(Part prefix)
{
    static const char *const words[] = {"Late Submission - ", "Verspaetete Abgabe - ",
                                        "Verspätete Abgabe - "};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strlen(words[i]) == part_length(prefix) &&
            memcmp(prefix.start, words[i], part_length(prefix)) == 0) {
            return 1;
        }
    }
    return 0;
}

// Canvas: "doejane_12345_678901_", the student, the student's number and the upload's.
static int is_of_canvas(Part prefix)
{
    enum { LEAST_DIGITS = 3 };
    return text_drop(&prefix, "_") && digits_drop(&prefix) >= LEAST_DIGITS &&
           text_drop(&prefix, "_") && digits_drop(&prefix) >= LEAST_DIGITS &&
           text_drop(&prefix, "_") && part_length(prefix) > 0;
}

static int is_system_prefix(Part prefix)
{
    return part_length(prefix) == 0 || is_of_moodle(prefix) || is_of_ilias(prefix) ||
           is_of_ilias_late(prefix) || is_of_canvas(prefix);
}

// How far uploads are counted.
enum { UPLOAD_DIGITS = 3 };

// "-1" is Canvas', for a second upload; " (1)" and "(1)" are browsers', for a second download.
static int is_system_suffix(Part suffix)
{
    if (part_length(suffix) == 0) {
        return 1;
    }
    const int has_bracket = text_drop(&suffix, ")");
    const int n_digits = digits_drop(&suffix);
    if (n_digits < 1 || n_digits > UPLOAD_DIGITS || !text_drop(&suffix, has_bracket ? "(" : "-")) {
        return 0;
    }
    if (has_bracket) {
        text_drop(&suffix, " ");
    }
    return part_length(suffix) == 0;
}

int name_upload_number(const char *name)
{
    const char *ending = strrchr(name, '.');
    Part stem = {name, ending != NULL ? ending : name + strlen(name)};
    const int has_bracket = text_drop(&stem, ")");
    const int n_digits = digits_drop(&stem);
    const char *digits = stem.end;
    const int is_counted =
        n_digits > 0 && n_digits <= UPLOAD_DIGITS && text_drop(&stem, has_bracket ? "(" : "-");
    return is_counted ? atoi(digits) : 0;
}

// ---- Names that a student changed ---------------------------------------------------------------

// Would a student give an answer this ending? Objects, headers and pictures are something else.
static int is_source_ending(const char *ending)
{
    static const char *const endings[] = {"",     ".c",    ".cl",  ".cpp",  ".ocl", ".txt", ".md",
                                          ".doc", ".docx", ".odt", ".html", ".rtf", ".pdf"};
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        if (strcasecmp(ending, endings[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

static int is_word_sign(char sign)
{
    return isalnum((unsigned char)sign) || (unsigned char)sign >= 0x80;
}

// Is the wanted file's stem a whole word of the name, in upper or lower case?
static int is_near(const char *name, const char *stem, size_t n_stem)
{
    const char *ending = strrchr(name, '.');
    // "._gradient.cl" is macOS', ".gradient.cl.swp" an editor's.
    if (name[0] == '.' || !is_source_ending(ending != NULL ? ending : "")) {
        return 0;
    }
    for (const char *at = name; strlen(at) >= n_stem; at++) {
        if (strncasecmp(at, stem, n_stem) == 0 && (at == name || !is_word_sign(at[-1])) &&
            !is_word_sign(at[n_stem])) {
            return 1;
        }
    }
    return 0;
}

// ---- All ----------------------------------------------------------------------------------------

NameMatch name_match(const char *name, const char *wanted)
{
    const char *ending = strrchr(wanted, '.');
    if (ending == NULL || strcmp(name, wanted) == 0) {
        return strcmp(name, wanted) == 0 ? NAME_EXACT : NAME_OTHER;
    }
    const size_t n_stem = (size_t)(ending - wanted);
    Part whole = {name, name + strlen(name)};
    if (text_drop(&whole, ending)) {
        for (const char *at = name; part_length((Part){at, whole.end}) >= n_stem; at++) {
            if (memcmp(at, wanted, n_stem) == 0 && is_system_prefix((Part){name, at}) &&
                is_system_suffix((Part){at + n_stem, whole.end})) {
                return NAME_CHANGED;
            }
        }
    }
    return is_near(name, wanted, n_stem) ? NAME_NEAR : NAME_OTHER;
}

// The lines of a Neutral File Format file (see scene3d_nff.h).
//
// Read next: scene3d_nff.c.
#include "scene3d_nff.h"

#include "number.h"
#include "scene3d.h"

#include <math.h>
#include <string.h>

typedef enum Range {
    ANY_FINITE,
    PLACE,
    RADIUS,
    NOT_NEGATIVE,
    COLOUR,
    OPENING,
    PIXELS,
    COUNT
} Range;

// The larger of the two keeps to what a float counts exactly, 2^24.
#define LARGEST_SIDE 1000000
#define LARGEST_COUNT 10000000

#define LARGEST NUMBER_TEXT(SCENE3D_LARGEST)
#define SMALLEST NUMBER_TEXT(SCENE3D_SMALLEST)

static const char *const EXPECTED[] = {
    [ANY_FINITE] = "a finite number",
    [PLACE] = "a number from -" LARGEST " to " LARGEST,
    [RADIUS] = "a number from " SMALLEST " to " LARGEST ", or its negative",
    [NOT_NEGATIVE] = "a finite number of at least 0",
    [COLOUR] = "a number from 0 to 1",
    [OPENING] = "an angle between 0 and 180 degrees",
    [PIXELS] = "a whole number from 1 to " NUMBER_TEXT(LARGEST_SIDE),
    [COUNT] = "a number of corners from 3 to " NUMBER_TEXT(LARGEST_COUNT),
};

// clang-format off: a row a line
#define XYZ(range) {"x", range}, {"y", range}, {"z", range}
#define RGB(range) {"r", range}, {"g", range}, {"b", range}

static const struct LineForm {
    const char *keyword;
    int n_required;  // numbers: a line has this many, or all
    struct {
        const char *name;
        Range range;
    } numbers[NFF_MAX_NUMBERS + 1];  // the last has no name
} FORMS[] = {
    [BACKGROUND] = {"b", 3, {RGB(COLOUR)}},
    [VIEW] = {"v", 0, {{NULL, ANY_FINITE}}},
    [FROM] = {"from", 3, {XYZ(PLACE)}},
    [AT] = {"at", 3, {XYZ(ANY_FINITE)}},
    [UP] = {"up", 3, {XYZ(ANY_FINITE)}},
    [ANGLE] = {"angle", 1, {{"degrees", OPENING}}},
    [HITHER] = {"hither", 1, {{"distance", NOT_NEGATIVE}}},
    [RESOLUTION] = {"resolution", 2, {{"width", PIXELS}, {"height", PIXELS}}},
    // Some scenes have lights brighter than 1.
    [LIGHT] = {"l", 3, {XYZ(ANY_FINITE), RGB(NOT_NEGATIVE)}},
    // Kd, Ks and T are mostly at most 1, which Haines does not demand. Opaque things may have
    // refraction 0.
    [MATERIAL] = {"f", 8, {RGB(COLOUR), {"Kd", NOT_NEGATIVE}, {"Ks", NOT_NEGATIVE},
                           {"Shine", NOT_NEGATIVE}, {"T", NOT_NEGATIVE},
                           {"refraction", NOT_NEGATIVE}}},
    [SPHERE] = {"s", 4, {XYZ(PLACE), {"radius", RADIUS}}},
    [CONE] = {"c", 0, {{NULL, ANY_FINITE}}},
    [POLYGON] = {"p", 0, {{NULL, ANY_FINITE}}},
    [PATCH] = {"pp", 0, {{NULL, ANY_FINITE}}},
};
// clang-format on

const char *nff_keyword(NffForm form)
{
    return FORMS[form].keyword;
}

NffForm nff_form_find(const char *keyword)
{
    for (NffForm form = 0; form < N_KEYWORDS; form++) {
        if (strcmp(FORMS[form].keyword, keyword) == 0) {
            return form;
        }
    }
    return N_KEYWORDS;
}

// What a line of this form looks like: "s x y z radius". `text` holds FORM_SIZE bytes. Returns it.
#define FORM_SIZE 64
static const char *form_describe(const struct LineForm *form, char *text)
{
    const size_t size = FORM_SIZE;
    int length = snprintf(text, size, "%s", form->keyword);
    int n_names = 0;
    for (; form->numbers[n_names].name != NULL; n_names++) {
        length += snprintf(text + length, size - (size_t)length, "%s%s%s", length > 0 ? " " : "",
                           n_names == form->n_required ? "[" : "", form->numbers[n_names].name);
    }
    if (n_names > form->n_required) {
        snprintf(text + length, size - (size_t)length, "]");
    }
    return text;
}

static int is_in_range(Range range, float value)
{
    switch (range) {
    case PLACE:
        return fabsf(value) <= (float)SCENE3D_LARGEST;
    case RADIUS:
        return fabsf(value) >= (float)SCENE3D_SMALLEST && fabsf(value) <= (float)SCENE3D_LARGEST;
    case NOT_NEGATIVE:
        return value >= 0;
    case COLOUR:
        return value >= 0 && value <= 1;
    case OPENING:
        return value > 0 && value < 180;
    default:
        return 1;
    }
}

// Read a number of a line. Returns 0, or -1 when it is none or out of range.
static int number_read(const char *word, Range range, float *value)
{
    if (range == PIXELS || range == COUNT) {
        int64_t whole;
        if (number_read_integer(word, range == PIXELS ? 1 : 3,
                                range == PIXELS ? LARGEST_SIDE : LARGEST_COUNT, &whole) != 0) {
            return -1;
        }
        *value = (float)whole;
        return 0;
    }
    return number_read_float(word, value) == 0 && is_in_range(range, *value) ? 0 : -1;
}

int nff_numbers_read(LineReader *lines, NffForm id, char **words, int n_words, float *numbers)
{
    const struct LineForm *form = &FORMS[id];
    char where[16], found[LINE_QUOTE_SIZE], expected[FORM_SIZE];
    int n_names = 0;
    while (form->numbers[n_names].name != NULL) {
        n_names++;
    }
    if (n_words != form->n_required && n_words != n_names) {
        snprintf(found, sizeof found, "%s and %d word%s", form->keyword, n_words,
                 n_words == 1 ? "" : "s");
        line_fault(lines, "", found, form_describe(form, expected));
        return -1;
    }
    for (int i = 0; i < n_words; i++) {
        const Range range = form->numbers[i].range;
        if (number_read(words[i], range, &numbers[i]) != 0) {
            snprintf(where, sizeof where, "%s: ", form->numbers[i].name);
            line_fault(lines, where, line_quote(words[i], found), EXPECTED[range]);
            return -1;
        }
    }
    return 0;
}

// ---- Cones, polygons and patches ----------------------------------------------------------------

enum { N_CONE = 8, N_CORNER = 3, N_CORNER_WITH_NORMAL = 6 };  // numbers

NffStream nff_stream_begin(NffForm form)
{
    const int has_count = form != CONE;
    return (NffStream){form, has_count ? 1 : N_CONE, has_count};
}

int nff_stream_read(NffStream *stream, LineReader *lines, const char *word)
{
    char where[16], found[LINE_QUOTE_SIZE], expected[64];
    const Range range = stream->awaits_count ? COUNT : ANY_FINITE;
    float number;
    if (number_read(word, range, &number) != 0) {
        snprintf(where, sizeof where, "%s: ", FORMS[stream->form].keyword);
        snprintf(expected, sizeof expected, "%s", EXPECTED[range]);
        if (!stream->awaits_count) {
            snprintf(expected, sizeof expected, "%s, as %d more belong%s to it", EXPECTED[range],
                     stream->n_left, stream->n_left == 1 ? "s" : "");
        }
        line_fault(lines, where, line_quote(word, found), expected);
        return -1;
    }
    stream->n_left--;
    if (stream->awaits_count) {
        stream->n_left = (int)number * (stream->form == POLYGON ? N_CORNER : N_CORNER_WITH_NORMAL);
        stream->awaits_count = 0;
    }
    return 0;
}

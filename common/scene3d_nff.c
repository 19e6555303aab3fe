// 3D scenes in Haines' Neutral File Format (see scene3d_nff.h).
//
// A line is a keyword and numbers; only cones, polygons and patches, which are skipped, may begin
// and end anywhere. scene3d_nff_lines.c knows which numbers each takes and what they may be; here
// they find their place in the scene. The first fault is reported with its line and ends the
// reading. Read next: line_reader.h.
//
// Source: E. Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics &
// Applications 7(11), 1987, and the file NFF.TXT of his Standard Procedural Databases.
#include "scene3d_nff.h"

#include "scene3d_builder.h"

#include <string.h>

// What objects before the first "f" are made of: white, and dull.
static const Material DEFAULT_MATERIAL = {.color = {1, 1, 1}, .kd = 1, .refraction = 1};

// The colour of a light that has none, until the number of lights is known. No file can say this.
#define NO_COLOUR (-1)

typedef struct NffReader {
    LineReader lines;
    Scene3DBuilder builder;
    unsigned forms_seen;        // bit i: form i was there
    int has_material;           // a line "f" was there, or an object without one
    u32 material_id;            // of the objects that follow
    NffStream skipped;          // the cone, polygon or patch whose numbers come now, if any do
    int n_skipped[N_KEYWORDS];  // how many cones, polygons and patches there were
} NffReader;

static Vec3 vec3_from(const float *numbers)
{
    return (Vec3){numbers[0], numbers[1], numbers[2]};
}

static void material_use(NffReader *reader, const Material *material)
{
    reader->material_id = builder_add_material(&reader->builder, material);
    reader->has_material = 1;
}

static void sphere_use(NffReader *reader, const float *numbers)
{
    if (!reader->has_material) {
        material_use(reader, &DEFAULT_MATERIAL);
    }
    builder_add_sphere(&reader->builder, (Sphere){numbers[0], numbers[1], numbers[2], numbers[3]},
                       reader->material_id);
}

// Put a line's numbers where they belong; there are as many as the form requires, or all.
static void numbers_use(NffReader *reader, NffForm form, const float *numbers, int n_numbers)
{
    Scene3D *scene = &reader->builder.scene;
    switch (form) {
    case BACKGROUND:
        scene->background = vec3_from(numbers);
        break;
    case FROM:
        scene->view.from = vec3_from(numbers);
        break;
    case AT:
        scene->view.at = vec3_from(numbers);
        break;
    case UP:
        scene->view.up = vec3_from(numbers);
        break;
    case ANGLE:
        scene->view.angle = numbers[0];
        break;
    case HITHER:
        scene->view.hither = numbers[0];
        break;
    case RESOLUTION:
        scene->width = (int)numbers[0];
        scene->height = (int)numbers[1];
        break;
    case LIGHT: {
        const Vec3 no_colour = {NO_COLOUR, NO_COLOUR, NO_COLOUR};
        builder_add_light(
            &reader->builder,
            (Light){vec3_from(numbers), n_numbers == 3 ? no_colour : vec3_from(numbers + 3)});
        break;
    }
    case MATERIAL:
        material_use(reader, &(Material){vec3_from(numbers), numbers[3], numbers[4], numbers[5],
                                         numbers[6], numbers[7]});
        break;
    case SPHERE:
        sphere_use(reader, numbers);
        break;
    default:  // VIEW has no numbers, and what is skipped has a stream
        break;
    }
}

static int is_seen(const NffReader *reader, NffForm form)
{
    return (reader->forms_seen >> form & 1) != 0;
}

static int is_view_line(NffForm form)
{
    return form >= FROM && form <= RESOLUTION;
}

// The first line that the view still lacks, or N_KEYWORDS when it is complete.
static NffForm missing_view_line(const NffReader *reader)
{
    for (NffForm form = FROM; form <= RESOLUTION; form++) {
        if (!is_seen(reader, form)) {
            return form;
        }
    }
    return N_KEYWORDS;
}

// May this keyword stand here? The view's lines follow v at once, in any order; there is one view
// and one background. Returns 0, or -1 after a complaint.
static int order_check(NffReader *reader, NffForm form)
{
    char found[LINE_QUOTE_SIZE], expected[64];
    const NffForm missing = missing_view_line(reader);
    const int once = is_view_line(form) || form == VIEW || form == BACKGROUND;
    if (is_view_line(form) && !is_seen(reader, VIEW)) {
        snprintf(expected, sizeof expected, "\"v\" before it");
    } else if (!is_view_line(form) && is_seen(reader, VIEW) && missing != N_KEYWORDS) {
        snprintf(expected, sizeof expected, "the view's line \"%s\"", nff_keyword(missing));
    } else if (once && is_seen(reader, form)) {
        snprintf(expected, sizeof expected, "one line \"%s\"", nff_keyword(form));
    } else {
        reader->forms_seen |= 1u << form;
        return 0;
    }
    line_fault(&reader->lines, "", line_quote(nff_keyword(form), found), expected);
    return -1;
}

static NffForm keyword_find(NffReader *reader, const char *word)
{
    const NffForm form = nff_form_find(word);
    if (form == N_KEYWORDS) {
        char found[LINE_QUOTE_SIZE];
        line_fault(&reader->lines, "", line_quote(word, found), "b, v, l, f, s, c, p, pp or #");
    }
    return form;
}

// A keyword and the numbers that belong to it. Returns how many words these are.
static int keyword_read(NffReader *reader, char **words, int n_words)
{
    float numbers[NFF_MAX_NUMBERS];
    const NffForm form = keyword_find(reader, words[0]);
    if (form == N_KEYWORDS || order_check(reader, form) != 0) {
        return n_words;
    }
    if (form >= CONE) {
        reader->n_skipped[form]++;
        reader->skipped = nff_stream_begin(form);
        return 1;
    }
    if (nff_numbers_read(&reader->lines, form, words + 1, n_words - 1, numbers) != 0) {
        return n_words;
    }
    numbers_use(reader, form, numbers, n_words - 1);
    if (is_view_line(form) && missing_view_line(reader) == N_KEYWORDS) {
        const char *view_fault = scene3d_view_fault(&reader->builder.scene.view);
        if (view_fault != NULL) {
            line_fault(&reader->lines, "view: ", view_fault, "a view that a camera can have");
        }
    }
    return n_words;
}

// How many of a line's words stand before its comment? A comment begins with a word: a # within one
// may as well be a number, as some programs write infinity as 1.#INF, and is a fault.
static int count_before_comment(NffReader *reader, char **words, int n_words)
{
    for (int i = 0; i < n_words; i++) {
        if (words[i][0] == '#') {
            return i;
        }
        if (strchr(words[i], '#') != NULL) {
            char found[LINE_QUOTE_SIZE];
            line_fault(&reader->lines, "", line_quote(words[i], found),
                       "a blank before a comment's #, and no other #");
        }
    }
    return n_words;
}

static void line_use(NffReader *reader)
{
    char *words[LINE_MAX_LENGTH / 2 + 1];  // a word has at least one character, and a blank
    int n_words = line_split(reader->lines.text, words, sizeof words / sizeof words[0]);
    n_words = count_before_comment(reader, words, n_words);
    for (int i = 0; i < n_words && !reader->lines.failed;) {
        if (reader->skipped.n_left > 0) {
            nff_stream_read(&reader->skipped, &reader->lines, words[i++]);
        } else {
            i += keyword_read(reader, words + i, n_words - i);
        }
    }
}

// What can only be said at the end of the file.
static void end_check(NffReader *reader)
{
    char expected[96];
    const int n_left = reader->skipped.n_left;
    const NffForm missing = missing_view_line(reader);
    if (n_left > 0) {
        snprintf(expected, sizeof expected, "%d more number%s of \"%s\"", n_left,
                 n_left == 1 ? "" : "s", nff_keyword(reader->skipped.form));
    } else if (!is_seen(reader, VIEW)) {
        snprintf(expected, sizeof expected, "a view, which begins with \"v\"");
    } else if (missing != N_KEYWORDS) {
        snprintf(expected, sizeof expected, "the view's line \"%s\"", nff_keyword(missing));
    } else {
        return;
    }
    line_fault(&reader->lines, "", "the end of the file", expected);
}

static void lights_finish(Scene3D *scene)
{
    for (int i = 0; i < scene->n_lights; i++) {
        if (scene->lights[i].color.x == NO_COLOUR) {
            scene->lights[i].color = scene3d_light_color(scene->n_lights);
        }
    }
}

static void warn(const NffReader *reader)
{
    const int *n = reader->n_skipped;
    char warning[128] = "";
    if (n[CONE] + n[POLYGON] + n[PATCH] > 0) {
        snprintf(warning, sizeof warning,
                 "skipped what is no sphere: %d c (cones), %d p (polygons), %d pp (patches)",
                 n[CONE], n[POLYGON], n[PATCH]);
    }
    line_warn(&reader->lines, warning);
}

int scene3d_read_nff(FILE *file, const char *name, Scene3D *scene)
{
    NffReader reader = {.has_material = 0};
    reader.builder.reader = &reader.lines;
    line_reader_begin(&reader.lines, file, name);
    while (!reader.lines.failed && line_read(&reader.lines)) {
        line_use(&reader);
    }
    if (!reader.lines.failed) {
        end_check(&reader);
    }
    if (builder_finish(&reader.builder, scene) != 0) {
        return -1;
    }
    lights_finish(scene);
    warn(&reader);
    return 0;
}

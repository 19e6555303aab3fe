// Haines' Neutral File Format: reading a scene, and, for scene3d_nff.c, what each line may hold.
//
// One table in scene3d_nff_lines.c says what every line looks like. Read next: scene3d_nff.c, which
// gives the lines their meaning.
#ifndef COMMON_SCENE3D_NFF_H
#define COMMON_SCENE3D_NFF_H

#include "line_reader.h"
#include "scene3d.h"

#include <stddef.h>

// Read a scene in the Neutral File Format: v (the view: from, at, up, angle, hither and resolution
// on six lines, in any order), b, l, f, s. Cones, polygons and patches (c, p, pp), which this
// course does not draw, are skipped, counted and named in one warning on stderr; their numbers may
// stand on one line or on many, as Haines' own programs and his text do not agree. Everything else
// is an error with its line: unknown lines, lines cut off, text that is no number, NaN and
// infinities, a sphere of radius 0, a view that does not work, is missing or comes twice. Colours
// of b and f go from 0 to 1; lights, kd, ks, shine, transmittance, refraction and hither are at
// least 0; the angle lies between 0 and 180 degrees; a side has 1 to 1 000 000 pixels. Without b
// the background is black; spheres before the first f are white with kd = 1; a light without a
// colour has the brightness 1 / sqrt(number of lights). A negative radius is a sphere seen from
// inside. A comment begins with #, on a line of its own or after a blank; a # within a word is an
// error.
//   name   what messages call the file
// Sets everything, width and height to the file's resolution. Returns 0, or -1 after one message on
// stderr.
int scene3d_read_nff(FILE *file, const char *name, Scene3D *scene);

// The kinds of lines.
typedef enum NffForm {
    BACKGROUND,
    VIEW,
    FROM,  // from here to RESOLUTION: the lines of a view
    AT,
    UP,
    ANGLE,
    HITHER,
    RESOLUTION,
    LIGHT,
    MATERIAL,
    SPHERE,
    CONE,  // from here on: no spheres, skipped
    POLYGON,
    PATCH,
    N_KEYWORDS,
} NffForm;

// The most numbers of a line.
#define NFF_MAX_NUMBERS 8

// The keyword of a form: "from".
const char *nff_keyword(NffForm form);

// The form with this keyword, or N_KEYWORDS.
NffForm nff_form_find(const char *keyword);

// Read the numbers of a line, and check how many they are and what each may be.
//   words[n_words]            what follows the keyword
//   numbers[NFF_MAX_NUMBERS]  n_words of them are set
// Returns 0, or -1 after a complaint.
int nff_numbers_read(LineReader *lines, NffForm form, char **words, int n_words, float *numbers);

// The numbers of a cone, polygon or patch are a stream: a line may break anywhere between them, and
// Haines' own programs break them otherwise than his text.
typedef struct NffStream {
    NffForm form;
    int n_left;        // numbers still to come, as far as is known
    int awaits_count;  // the next one says how many corners there are
} NffStream;

NffStream nff_stream_begin(NffForm form);

// Take the next number. Returns 0, or -1 after a complaint.
int nff_stream_read(NffStream *stream, LineReader *lines, const char *word);

#endif

// The lines of a Neutral File Format file: keywords, and the numbers that belong to them.
//
// One table in scene3d_nff_lines.c says what every line looks like. Read next: scene3d_nff.c, which
// gives the lines their meaning.
#ifndef COMMON_SCENE3D_NFF_LINES_H
#define COMMON_SCENE3D_NFF_LINES_H

#include "line_reader.h"

#include <stddef.h>

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

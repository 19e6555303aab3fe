// Trying out what a wrong picture looks like.
#include "picture_looks.h"

#include "jobs.h"
#include "message.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- Mistakes made by the oracle --------------------------------------------------------------

typedef struct MistakenPicture {
    Cause looks;  // nothing: behind the last mistake
    Image picture;
    float *tolerances;
    int is_empty;  // nothing but background: it says nothing of a picture that is not empty
} MistakenPicture;

struct MistakenPictures {
    DrawMistaken *draw;
    MistakenPicture *pictures;  // [n], of the first mistakes
    int n;
};

void expected_picture_recognise(ExpectedPicture *expected, DrawMistaken *draw, const void *scene)
{
    MistakenPictures *old = expected->mistaken;
    for (int i = 0; old != NULL && i < old->n; i++) {
        image_free(&old->pictures[i].picture);
        free(old->pictures[i].tolerances);
    }
    free(old != NULL ? old->pictures : NULL);
    free(old);
    expected->mistaken = draw != NULL ? calloc(1, sizeof *expected->mistaken) : NULL;
    expected->scene = scene;
    if (expected->mistaken != NULL) {
        *expected->mistaken = (MistakenPictures){.draw = draw};
    }
}

static int is_background(const Image *picture, const float *background)
{
    const size_t n_pixels = (size_t)picture->width * (size_t)picture->height;
    size_t i = 0;
    while (i < n_pixels && is_same_color(picture->pixels + i * IMAGE_CHANNELS, background, 0)) {
        i++;
    }
    return i == n_pixels;
}

// Draw the next mistake and keep it. Returns 0, or -1 without memory.
static int draw_next(const ExpectedPicture *expected)
{
    MistakenPictures *known = expected->mistaken;
    const Image *reference = &expected->reference;
    const size_t n_pixels = (size_t)reference->width * (size_t)reference->height;
    MistakenPicture *pictures =
        realloc(known->pictures, ((size_t)known->n + 1) * sizeof *known->pictures);
    if (pictures == NULL) {
        return -1;
    }
    known->pictures = pictures;
    MistakenPicture *next = &pictures[known->n];
    *next = (MistakenPicture){.tolerances = calloc(n_pixels, sizeof *next->tolerances)};
    if (next->tolerances == NULL ||
        image_create(reference->width, reference->height, &next->picture) != 0) {
        free(next->tolerances);
        return -1;
    }
    next->looks = known->draw(expected->scene, known->n++, &next->picture, next->tolerances);
    next->is_empty = is_background(&next->picture, expected->background);
    return 0;
}

static Tally compare(ProbeImage own, const ExpectedPicture *expected, const MistakenPicture *guess)
{
    Tally tally = {0};
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        tally_add(&tally, pixel_pair(own, expected, i),
                  guess->picture.pixels + (size_t)i * IMAGE_CHANNELS, guess->tolerances[i]);
    }
    return tally;
}

// How much of what should be drawn is lost, where nothing else is wrong? Many a mistake leaves a
// picture of which something is missing, and more of them one of which nearly all is.
typedef enum Lost { LOST_NOTHING, LOST_SOME, LOST_MOST } Lost;

static Lost how_lost(ProbeImage own, const ExpectedPicture *expected)
{
    int n_drawn = 0, n_lost = 0;
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        const int is_background = is_same_color(pixel.own, expected->background, 0);
        const int is_wrong = !is_same_color(pixel.own, pixel.wanted, pixel.tolerance);
        if (is_wrong && !is_background) {
            return LOST_NOTHING;
        }
        n_drawn += !is_same_color(pixel.wanted, expected->background, 0);
        n_lost += is_wrong;
    }
    return n_lost == 0 ? LOST_NOTHING : 10 * n_lost >= 9 * n_drawn ? LOST_MOST : LOST_SOME;
}

// The scene's mistake that the picture looks like: the first that it is to the last pixel, or where
// it is none, the first that it resembles. Where something is lost and nothing else wrong, it is
// not enough to resemble; where nearly all is lost, nothing is known if two mistakes lose the same.
Cause picture_mistaken(ProbeImage own, const ExpectedPicture *expected)
{
    MistakenPictures *known = expected->mistaken;
    Cause looks = {0};
    int is_exact = 0;
    const Lost lost = known != NULL ? how_lost(own, expected) : LOST_NOTHING;
    const int may_be_other = lost == LOST_MOST;
    for (int i = 0; known != NULL && (!is_exact || may_be_other); i++) {
        if ((i == known->n && draw_next(expected) != 0) || known->pictures[i].looks.says == NULL) {
            break;
        }
        const Tally tally = compare(own, expected, &known->pictures[i]);
        const int is_like = !known->pictures[i].is_empty && tally_recognises(&tally);
        const Cause *other = &known->pictures[i].looks;
        const int is_other_exact = is_like && tally.n_agree == tally.n_compared;
        if (is_exact && is_other_exact && strcmp(looks.says, other->says) != 0) {
            return (Cause){0};
        }
        if (!is_exact &&
            (is_other_exact || (lost == LOST_NOTHING && looks.says == NULL && is_like))) {
            looks = *other;
        }
        is_exact |= is_other_exact;
    }
    return looks;
}

int picture_may_look(ProbeImage own, const ExpectedPicture *expected, const char *rule)
{
    MistakenPictures *known = expected->mistaken;
    int is_known = 0;
    for (int i = 0; known != NULL; i++) {
        if ((i == known->n && draw_next(expected) != 0) || known->pictures[i].looks.says == NULL) {
            break;
        }
        if (strcmp(known->pictures[i].looks.says, rule) == 0) {
            is_known = 1;
            if (!compare(own, expected, &known->pictures[i]).misses_first) {
                return 1;
            }
        }
    }
    return !is_known;
}

// ---- Backgrounds ------------------------------------------------------------------------------

// Is every wrong pixel background, and all of the background one other colour?
static int is_other_background(ProbeImage own, const ExpectedPicture *expected)
{
    const float *seen = NULL;
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        const int is_background = is_same_color(pixel.wanted, expected->background, 0);
        if (isinf(pixel.tolerance)) {
            continue;
        }
        if (is_background == is_same_color(pixel.own, pixel.wanted, pixel.tolerance) ||
            (is_background && seen != NULL && !is_same_color(pixel.own, seen, 0))) {
            return 0;
        }
        seen = is_background ? pixel.own : seen;
    }
    return seen != NULL;
}

// Is every pixel background, though not every pixel should be?
int picture_is_empty(ProbeImage own, const ExpectedPicture *expected)
{
    int i = 0;
    while (i < expected_n_pixels(expected) &&
           is_same_color(pixel_pair(own, expected, i).own, expected->background, 0)) {
        i++;
    }
    return i == expected_n_pixels(expected);
}

// Is every pixel of one colour, though not every pixel should be?
static int is_constant(ProbeImage own, const ExpectedPicture *expected)
{
    const PixelPair first = pixel_pair(own, expected, 0);
    int is_varied = 0;
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        if (!is_same_color(pixel.own, first.own, 0)) {
            return 0;
        }
        is_varied |= !is_same_color(pixel.wanted, first.wanted, 0);
    }
    return is_varied;
}

// Does every wrong pixel show the circle behind the end of the array?
static int shows_beyond(ProbeImage own, const ExpectedPicture *expected)
{
    const float beyond[IMAGE_CHANNELS] = {BEYOND_RED, BEYOND_GREEN, BEYOND_BLUE, 1};
    int n_beyond = 0;
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        if (is_same_color(pixel.own, beyond, 0)) {
            n_beyond++;
        } else if (!is_same_color(pixel.own, pixel.wanted, pixel.tolerance)) {
            return 0;
        }
    }
    return n_beyond > 0;
}

// ---- What does it look like? ------------------------------------------------------------------

const char *picture_plain(ProbeImage own, const ExpectedPicture *expected)
{
    if (picture_is_empty(own, expected)) {
        return "empty: nothing but the background";
    }
    // One circle too many may cover all of the picture, and is a mistake of its own.
    return is_constant(own, expected) && !shows_beyond(own, expected) ? "of one colour everywhere"
                                                                      : NULL;
}

Cause picture_known(ProbeImage own, const ExpectedPicture *expected)
{
    if (shows_beyond(own, expected)) {
        return (Cause){.says = "drawn as if one circle too many were asked, the one behind the end "
                               "of the array"};
    }
    if (is_other_background(own, expected)) {
        return (Cause){0};
    }
    const Cause looks = picture_distortion(own, expected);
    return looks.says != NULL ? looks : picture_mistaken(own, expected);
}

Diagnosis picture_looks(ProbeImage own, const ExpectedPicture *expected, char *found)
{
    Diagnosis looks = {.found = found, .evidence = EVIDENCE_PICTURE};
    // One circle too many may cover all of an empty picture.
    if (!shows_beyond(own, expected) && is_other_background(own, expected)) {
        const float *color = expected->background;
        looks.cause = message_new("it looks right but for the background, which is (%g, %g, %g, "
                                  "%g) in all four channels",
                                  color[0], color[1], color[2], color[3]);
        return looks;
    }
    const Cause known = picture_known(own, expected);
    if (known.says != NULL) {
        return diagnosis_seen(found, known, EVIDENCE_PICTURE);
    }
    const Words place = picture_place(own, expected);
    looks.cause = place.text[0] != '\0' ? message_new("it looks %s", place.text) : NULL;
    return looks;
}

// Trying out what a wrong picture looks like.
#include "picture_looks.h"

#include "jobs.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- Mistakes made by the oracle --------------------------------------------------------------

static Tally compare(ProbeImage own, const ExpectedPicture *expected, const Image *guess,
                     const float *guess_tolerances)
{
    Tally tally = {0};
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        tally_add(&tally, pixel_pair(own, expected, i), guess->pixels + (size_t)i * IMAGE_CHANNELS,
                  guess_tolerances[i]);
    }
    return tally;
}

// The scene's mistake that the picture looks like: the first that it is to the last pixel, or where
// it is none, the first that it resembles. Two may resemble it where a picture is sparse.
Cause picture_mistaken(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    const size_t n_pixels = (size_t)expected_n_pixels(expected);
    float *tolerances = calloc(n_pixels, sizeof *tolerances);
    Image guess = {0};
    Cause looks = {0};
    if (tolerances != NULL && expected->draw_mistaken != NULL &&
        image_create(reference->width, reference->height, &guess) == 0) {
        int is_exact = 0;
        for (int mistake = 0; !is_exact; mistake++) {
            memset(tolerances, 0, n_pixels * sizeof *tolerances);
            const Cause next =
                expected->draw_mistaken(expected->scene, mistake, &guess, tolerances);
            if (next.says == NULL) {
                break;
            }
            const Tally tally = compare(own, expected, &guess, tolerances);
            is_exact = tally_recognises(&tally) && tally.n_agree == tally.n_compared;
            looks = is_exact || (looks.says == NULL && tally_recognises(&tally)) ? next : looks;
        }
    }
    image_free(&guess);
    free(tolerances);
    return looks;
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

Diagnosis picture_looks(ProbeImage own, const ExpectedPicture *expected, char *found)
{
    if (shows_beyond(own, expected)) {
        const Cause one_more = {.says =
                                    "drawn as if one circle too many were asked, the one behind "
                                    "the end of the array"};
        return diagnosis_seen(found, one_more, EVIDENCE_PICTURE);
    }
    if (is_other_background(own, expected)) {
        const float *color = expected->background;
        const Words background =
            words("right but for the background, which is (%g, %g, %g, %g) in all four channels",
                  color[0], color[1], color[2], color[3]);
        return diagnosis_seen(found, (Cause){.says = background.text}, EVIDENCE_PICTURE);
    }
    Cause looks = picture_distortion(own, expected);
    if (looks.says == NULL) {
        looks = picture_mistaken(own, expected);
    }
    if (looks.says != NULL) {
        return diagnosis_seen(found, looks, EVIDENCE_PICTURE);
    }
    const Words place = picture_place(own, expected);
    return diagnosis_seen(found, (Cause){.says = place.text[0] != '\0' ? place.text : NULL},
                          EVIDENCE_PICTURE);
}

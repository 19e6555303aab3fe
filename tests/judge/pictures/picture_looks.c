// Trying out what a wrong picture looks like.
#include "picture_looks.h"

#include "jobs.h"
#include "message.h"
#include "picture_distortion.h"
#include "picture_tally.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- Mistakes made by the oracle --------------------------------------------------------------

static int looks_like(ProbeImage own, const ExpectedPicture *expected, const Image *guess,
                      const float *guess_tolerances)
{
    const Image *reference = &expected->reference;
    Tally tally = {0};
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            tally_add(&tally, probe_image_pixel(own, x, y), image_pixel(guess, x, y),
                      guess_tolerances[(size_t)y * reference->width + x],
                      image_pixel(reference, x, y), expected_tolerance(expected, x, y));
        }
    }
    return tally_recognises(&tally);
}

// The scene's mistake that the picture looks like, or NULL.
static const char *looks_mistaken(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    const size_t n_pixels = (size_t)reference->width * (size_t)reference->height;
    float *tolerances = calloc(n_pixels, sizeof *tolerances);
    Image guess = {0};
    const char *looks = NULL;
    if (tolerances != NULL && image_create(reference->width, reference->height, &guess) == 0) {
        int mistake = 0;
        do {
            memset(tolerances, 0, n_pixels * sizeof *tolerances);
            looks = expected->draw_mistaken(expected->scene, mistake++, &guess, tolerances);
        } while (looks != NULL && !looks_like(own, expected, &guess, tolerances));
    }
    image_free(&guess);
    free(tolerances);
    return looks;
}

// ---- Backgrounds ------------------------------------------------------------------------------

// Is every wrong pixel background, and all of the background one other colour?
static int is_other_background(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    const float *seen = NULL;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const float *pixel = probe_image_pixel(own, x, y);
            const float *wanted = image_pixel(reference, x, y);
            const float tolerance = expected_tolerance(expected, x, y);
            const int is_background = is_same_color(wanted, expected->background, 0);
            if (isinf(tolerance)) {
                continue;
            }
            if (is_background == is_same_color(pixel, wanted, tolerance) ||
                (is_background && seen != NULL && !is_same_color(pixel, seen, 0))) {
                return 0;
            }
            seen = is_background ? pixel : seen;
        }
    }
    return seen != NULL;
}

// Is every pixel background, though not every pixel should be?
static int is_empty(ProbeImage own, const ExpectedPicture *expected)
{
    for (int y = 0; y < expected->reference.height; y++) {
        for (int x = 0; x < expected->reference.width; x++) {
            if (!is_same_color(probe_image_pixel(own, x, y), expected->background, 0)) {
                return 0;
            }
        }
    }
    return 1;
}

// Is every pixel of one colour, though not every pixel should be?
static int is_constant(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    int is_varied = 0;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            if (!is_same_color(probe_image_pixel(own, x, y), probe_image_pixel(own, 0, 0), 0)) {
                return 0;
            }
            is_varied |=
                !is_same_color(image_pixel(reference, x, y), image_pixel(reference, 0, 0), 0);
        }
    }
    return is_varied;
}

// Does every wrong pixel show the circle behind the end of the array?
static int shows_beyond(ProbeImage own, const ExpectedPicture *expected)
{
    const float beyond[IMAGE_CHANNELS] = {BEYOND_RED, BEYOND_GREEN, BEYOND_BLUE, 1};
    const Image *reference = &expected->reference;
    int n_beyond = 0;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const float *pixel = probe_image_pixel(own, x, y);
            if (is_same_color(pixel, beyond, 0)) {
                n_beyond++;
            } else if (!is_same_color(pixel, image_pixel(reference, x, y),
                                      expected_tolerance(expected, x, y))) {
                return 0;
            }
        }
    }
    return n_beyond > 0;
}

// ---- What does it look like? ------------------------------------------------------------------

const char *picture_plain(ProbeImage own, const ExpectedPicture *expected)
{
    if (is_empty(own, expected)) {
        return "empty: nothing but the background";
    }
    // One circle too many may cover all of the picture, and is a mistake of its own.
    return is_constant(own, expected) && !shows_beyond(own, expected) ? "of one colour everywhere"
                                                                      : NULL;
}

char *picture_looks(ProbeImage own, const ExpectedPicture *expected)
{
    if (shows_beyond(own, expected)) {
        return message_new("drawn as if one circle too many were asked, the one behind the end of "
                           "the array");
    }
    if (is_other_background(own, expected)) {
        const float *background = expected->background;
        return message_new("right but for the background, which is (%g, %g, %g, %g) in all four "
                           "channels",
                           (double)background[0], (double)background[1], (double)background[2],
                           (double)background[3]);
    }
    const char *looks = picture_distortion(own, expected);
    if (looks == NULL && expected->draw_mistaken != NULL) {
        looks = looks_mistaken(own, expected);
    }
    return looks ? message_new("%s", looks) : NULL;
}

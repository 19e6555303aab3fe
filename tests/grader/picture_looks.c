// Trying out what a wrong picture looks like.
#include "picture_looks.h"

#include "jobs.h"
#include "message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A mistake is named when its picture agrees with the student's in this share of the pixels. The
// rest may be rims: pixels that a shift brings in from outside, or rounding of a half pixel.
#define RECOGNISED_SHARE 0.995

// And it must explain at least this share of what is wrong: most of a sparse picture is background.
#define EXPLAINED_SHARE 0.9

// From fewer wrong pixels than these nothing is concluded: too many mistakes would explain them.
#define MIN_WRONG 6

// ---- Mistakes made to the reference -----------------------------------------------------------

// A wrong way to look up the reference: the student's pixel (x, y) shows its pixel (u, v).
typedef void Lookup(int x, int y, int width, int height, int *u, int *v);

static void mirrored(int x, int y, int width, int height, int *u, int *v)
{
    (void)height;
    *u = width - 1 - x, *v = y;
}
static void flipped(int x, int y, int width, int height, int *u, int *v)
{
    (void)width;
    *u = x, *v = height - 1 - y;
}
static void turned(int x, int y, int width, int height, int *u, int *v)
{
    *u = width - 1 - x, *v = height - 1 - y;
}
static void transposed(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = y, *v = x;
}
static void from_left(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x - 1, *v = y;
}
static void from_right(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x + 1, *v = y;
}
static void from_above(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x, *v = y - 1;
}
static void from_below(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x, *v = y + 1;
}
static void diagonally(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x + 1, *v = y + 1;
}
static void in_place(int x, int y, int width, int height, int *u, int *v)
{
    (void)width, (void)height;
    *u = x, *v = y;
}

// A mistake made to the reference.
typedef struct Distortion {
    const char *looks;
    Lookup *lookup;
    int channels[IMAGE_CHANNELS];  // the student's channel c shows the reference's channels[c]
} Distortion;

static const Distortion distortions[] = {
    {"mirrored left to right", mirrored, {0, 1, 2, 3}},
    {"flipped top to bottom", flipped, {0, 1, 2, 3}},
    {"turned upside down (flipped in x and y)", turned, {0, 1, 2, 3}},
    {"transposed: rows and columns are swapped", transposed, {0, 1, 2, 3}},
    {"shifted by one pixel to the right", from_left, {0, 1, 2, 3}},
    {"shifted by one pixel to the left", from_right, {0, 1, 2, 3}},
    {"shifted by one pixel down", from_above, {0, 1, 2, 3}},
    {"shifted by one pixel up", from_below, {0, 1, 2, 3}},
    {"shifted by one pixel to the left and up", diagonally, {0, 1, 2, 3}},
    {"right with red and blue swapped", in_place, {2, 1, 0, 3}},
    {"right with red and green swapped", in_place, {1, 0, 2, 3}},
    {"right with green and blue swapped", in_place, {0, 2, 1, 3}},
    {"right with its channels rotated (alpha first)", in_place, {3, 0, 1, 2}},
    {"right with its channels reversed (alpha first)", in_place, {3, 2, 1, 0}},
};

// How a guess fares against the student's picture.
typedef struct Tally {
    size_t n_compared;   // pixels the guess says anything about
    size_t n_agree;      // of those, equal to the student's
    size_t n_wrong;      // of those, where the student differs from the reference
    size_t n_explained;  // of those, equal to the student's
} Tally;

// A pixel about which the reference or the guess says nothing, its tolerance INFINITY, is left out.
static void tally_add(Tally *tally, const float *own, const float *guess, float guess_tolerance,
                      const float *reference, float tolerance)
{
    if (isinf(guess_tolerance) || isinf(tolerance)) {
        return;
    }
    const int agrees = is_same_color(own, guess, guess_tolerance);
    const int wrong = !is_same_color(own, reference, tolerance);
    tally->n_compared++;
    tally->n_agree += (size_t)agrees;
    tally->n_wrong += (size_t)wrong;
    tally->n_explained += (size_t)(wrong && agrees);
}

// Is a pixel background, and right? Who changes what is drawn and not what is behind it is
// recognised by the rest.
static int is_right_background(const ExpectedPicture *expected, const float *own, int x, int y)
{
    const float *reference = image_pixel(&expected->reference, x, y);
    return is_same_color(reference, expected->background, 0) &&
           is_same_color(own, reference, expected_tolerance(expected, x, y));
}

static int tally_recognises(const Tally *tally)
{
    return tally->n_wrong >= MIN_WRONG &&
           (double)tally->n_agree >= RECOGNISED_SHARE * (double)tally->n_compared &&
           (double)tally->n_explained >= EXPLAINED_SHARE * (double)tally->n_wrong;
}

static int looks_distorted(ProbeImage own, const ExpectedPicture *expected,
                           const Distortion *distortion)
{
    const Image *reference = &expected->reference;
    Tally tally = {0};
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            int u, v;
            distortion->lookup(x, y, reference->width, reference->height, &u, &v);
            if (u < 0 || v < 0 || u >= reference->width || v >= reference->height ||
                (distortion->lookup == in_place &&
                 is_right_background(expected, probe_image_pixel(own, x, y), x, y))) {
                continue;
            }
            float guess[IMAGE_CHANNELS];
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                guess[channel] = image_pixel(reference, u, v)[distortion->channels[channel]];
            }
            tally_add(&tally, probe_image_pixel(own, x, y), guess,
                      expected_tolerance(expected, u, v), image_pixel(reference, x, y),
                      expected_tolerance(expected, x, y));
        }
    }
    return tally_recognises(&tally);
}

// ---- Gamma ------------------------------------------------------------------------------------

// A curve that a colour's channels, but for alpha, were bent by.
typedef double Curve(double value);

static double power_encoded(double value)
{
    return pow(value, 1 / 2.2);
}
static double power_decoded(double value)
{
    return pow(value, 2.2);
}
// IEC 61966-2-1.
static double srgb_encoded(double value)
{
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055;
}
static double srgb_decoded(double value)
{
    return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

static const struct {
    const char *looks;
    Curve *curve;
} gammas[] = {
    {"right but for gamma: the colours were raised to 1 / 2.2, but pictures here are linear",
     power_encoded},
    {"right but for gamma: the colours were raised to 2.2, but pictures here are linear",
     power_decoded},
    {"right but for gamma: the colours were encoded by the sRGB curve, but pictures here are "
     "linear",
     srgb_encoded},
    {"right but for gamma: the colours were decoded by the sRGB curve, but pictures here are "
     "linear",
     srgb_decoded},
};

// A device's pow() may be off by 16 units in the last place (OpenCL 1.2, 7.4), of values up to 8
// where several bright lights meet; twice that is allowed.
#define POW_ERROR (32 * 8 * 0x1p-23)

// Bend a channel; how far a right value within `tolerance` may come to lie from it is added to
// `error`.
static float channel_bend(Curve *curve, float value, float tolerance, float *error)
{
    const double bent = curve(fmax(value, 0)), low = curve(fmax(value - tolerance, 0)),
                 high = curve(fmax(value + tolerance, 0));
    *error = fmaxf(*error, (float)(fmax(high - bent, bent - low) + POW_ERROR));
    return (float)bent;
}

static int looks_bent(ProbeImage own, const ExpectedPicture *expected, Curve *curve)
{
    const Image *reference = &expected->reference;
    Tally tally = {0};
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            if (is_right_background(expected, probe_image_pixel(own, x, y), x, y)) {
                continue;
            }
            const float *right = image_pixel(reference, x, y);
            const float tolerance = expected_tolerance(expected, x, y);
            float guess[IMAGE_CHANNELS], error = 0;
            memcpy(guess, right, sizeof guess);
            for (int channel = 0; channel < 3; channel++) {
                guess[channel] = channel_bend(curve, right[channel], tolerance, &error);
            }
            tally_add(&tally, probe_image_pixel(own, x, y), guess,
                      isinf(tolerance) ? tolerance : error, right, tolerance);
        }
    }
    return tally_recognises(&tally);
}

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

char *picture_looks(ProbeImage own, const ExpectedPicture *expected)
{
    if (is_empty(own, expected)) {
        return message_new("empty: nothing but the background");
    }
    if (is_constant(own, expected)) {
        return message_new("of one colour everywhere");
    }
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
    for (size_t i = 0; i < sizeof distortions / sizeof *distortions; i++) {
        if (looks_distorted(own, expected, &distortions[i])) {
            return message_new("%s", distortions[i].looks);
        }
    }
    for (size_t i = 0; i < sizeof gammas / sizeof *gammas; i++) {
        if (looks_bent(own, expected, gammas[i].curve)) {
            return message_new("%s", gammas[i].looks);
        }
    }
    const char *looks = expected->draw_mistaken ? looks_mistaken(own, expected) : NULL;
    return looks ? message_new("%s", looks) : NULL;
}

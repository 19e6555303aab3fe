// Trying out distortions of the reference (see picture_distortion.h).
#include "picture_distortion.h"

#include "picture_tally.h"

#include <math.h>
#include <string.h>

// ---- Pixels and channels in other places --------------------------------------------------------

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

// Is a pixel background, and right? Who changes what is drawn and not what is behind it is
// recognised by the rest.
static int is_right_background(const ExpectedPicture *expected, const float *own, int x, int y)
{
    const float *reference = image_pixel(&expected->reference, x, y);
    return is_same_color(reference, expected->background, 0) &&
           is_same_color(own, reference, expected_tolerance(expected, x, y));
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

// ---- All ----------------------------------------------------------------------------------------

const char *picture_distortion(ProbeImage own, const ExpectedPicture *expected)
{
    for (size_t i = 0; i < sizeof distortions / sizeof *distortions; i++) {
        if (looks_distorted(own, expected, &distortions[i])) {
            return distortions[i].looks;
        }
    }
    for (size_t i = 0; i < sizeof gammas / sizeof *gammas; i++) {
        if (looks_bent(own, expected, gammas[i].curve)) {
            return gammas[i].looks;
        }
    }
    return NULL;
}

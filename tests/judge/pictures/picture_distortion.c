// Trying out distortions of the reference (see picture_looks.h).
#include "oracle3d_rounding.h"
#include "picture_looks.h"

#include <math.h>
#include <string.h>

// ---- Pixels and channels in other places --------------------------------------------------------

// A coordinate of the reference's pixel that a student's pixel (x, y) shows.
typedef struct Place {
    int x, y;      // how many times the student's own
    int from_end;  // counted from the picture's last column or row
    int shift;
} Place;

// A mistake made to the reference.
typedef struct Distortion {
    Cause looks;
    Place u, v;
    // The student's channel c shows the reference's channels[c], or that times alpha, or 1.
    int channels[IMAGE_CHANNELS];
} Distortion;

#define AS_IT_IS {.x = 1}, {.y = 1}
#define SAME_CHANNELS {0, 1, 2, 3}
enum { ALPHA = 3, ALWAYS_1 = IMAGE_CHANNELS, TIMES_ALPHA };

static const Distortion distortions[] = {
    {{"mirrored left to right", MISTAKE_MIRRORED_X},
     {.x = -1, .from_end = 1},
     {.y = 1},
     SAME_CHANNELS},
    {{"flipped top to bottom", MISTAKE_FLIPPED_Y},
     {.x = 1},
     {.y = -1, .from_end = 1},
     SAME_CHANNELS},
    {{"turned upside down (flipped in x and y)", MISTAKE_MIRRORED_X},
     {.x = -1, .from_end = 1},
     {.y = -1, .from_end = 1},
     SAME_CHANNELS},
    {{"transposed: rows and columns are swapped", MISTAKE_TRANSPOSED},
     {.y = 1},
     {.x = 1},
     SAME_CHANNELS},
    {{"shifted by one pixel to the right", MISTAKE_SHIFTED_ONE},
     {.x = 1, .shift = -1},
     {.y = 1},
     SAME_CHANNELS},
    {{"shifted by one pixel to the left", MISTAKE_SHIFTED_ONE},
     {.x = 1, .shift = 1},
     {.y = 1},
     SAME_CHANNELS},
    {{"shifted by one pixel down", MISTAKE_SHIFTED_ONE},
     {.x = 1},
     {.y = 1, .shift = -1},
     SAME_CHANNELS},
    {{"shifted by one pixel up", MISTAKE_SHIFTED_ONE},
     {.x = 1},
     {.y = 1, .shift = 1},
     SAME_CHANNELS},
    {{"shifted by one pixel to the left and up", MISTAKE_SHIFTED_ONE},
     {.x = 1, .shift = 1},
     {.y = 1, .shift = 1},
     SAME_CHANNELS},
    {{"right with red and blue swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {2, 1, 0, 3}},
    {{"right with red and green swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {1, 0, 2, 3}},
    {{"right with green and blue swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {0, 2, 1, 3}},
    {{"right with blue and alpha swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {0, 1, 3, 2}},
    {{"right with green and alpha swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {0, 3, 2, 1}},
    {{"right with red and alpha swapped", MISTAKE_CHANNELS_SWAPPED}, AS_IT_IS, {3, 1, 2, 0}},
    {{"right with its channels rotated (alpha first)", MISTAKE_CHANNELS_SWAPPED},
     AS_IT_IS,
     {3, 0, 1, 2}},
    {{"right with its channels reversed (alpha first)", MISTAKE_CHANNELS_SWAPPED},
     AS_IT_IS,
     {3, 2, 1, 0}},
    {{.says = "right but for alpha, which is always 1"}, AS_IT_IS, {0, 1, 2, ALWAYS_1}},
    {{.says = "grey: red is there in all channels"}, AS_IT_IS, {0, 0, 0, 0}},
    {{.says = "grey: red is there in green and blue, too"}, AS_IT_IS, {0, 0, 0, ALPHA}},
    {{.says = "drawn with the column for the row, too"}, {.x = 1}, {.x = 1}, SAME_CHANNELS},
    {{.says = "drawn with the row for the column, too"}, {.y = 1}, {.y = 1}, SAME_CHANNELS},
    {{.says = "right but for its colours, which were multiplied by alpha"},
     AS_IT_IS,
     {TIMES_ALPHA + 0, TIMES_ALPHA + 1, TIMES_ALPHA + 2, ALPHA}},
};

// A coordinate of the pixel that is shown at (x, y).
static int place_at(Place place, int x, int y, int side)
{
    return place.x * x + place.y * y + (place.from_end ? side - 1 : 0) + place.shift;
}

// Is a pixel background, and right? A renderer that changes what is drawn, and not what is behind
// it, is recognised by its other pixels.
static int is_right_background(const ExpectedPicture *expected, PixelPair pixel)
{
    return is_same_color(pixel.wanted, expected->background, 0) &&
           is_same_color(pixel.own, pixel.wanted, pixel.tolerance);
}

static void distort_color(const int channels[IMAGE_CHANNELS], const float *wanted, float *guess)
{
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        const int from = channels[channel];
        guess[channel] = from >= TIMES_ALPHA ? wanted[from - TIMES_ALPHA] * wanted[ALPHA]
                         : from == ALWAYS_1  ? 1
                                             : wanted[from];
    }
}

static int looks_distorted(ProbeImage own, const ExpectedPicture *expected,
                           const Distortion *distortion)
{
    const int width = expected->reference.width, height = expected->reference.height;
    const int same[IMAGE_CHANNELS] = SAME_CHANNELS;
    const int is_of_channels = memcmp(distortion->channels, same, sizeof same) != 0;
    Tally tally = {0};
    for (int i = 0; i < width * height; i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        const int u = place_at(distortion->u, pixel.x, pixel.y, width);
        const int v = place_at(distortion->v, pixel.x, pixel.y, height);
        if (u < 0 || v < 0 || u >= width || v >= height ||
            (is_of_channels && is_right_background(expected, pixel))) {
            continue;
        }
        const PixelPair shown = pixel_pair(own, expected, v * width + u);
        float guess[IMAGE_CHANNELS];
        distort_color(distortion->channels, shown.wanted, guess);
        tally_add(&tally, pixel, guess, shown.tolerance);
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
    Cause looks;
    Curve *curve;
} gammas[] = {
    {{"right but for gamma: the colours were raised to 1 / 2.2, but pictures here are linear",
      MISTAKE_GAMMA},
     power_encoded},
    {{"right but for gamma: the colours were raised to 2.2, but pictures here are linear",
      MISTAKE_GAMMA},
     power_decoded},
    {{"right but for gamma: the colours were encoded by the sRGB curve, but pictures here are "
      "linear",
      MISTAKE_GAMMA},
     srgb_encoded},
    {{"right but for gamma: the colours were decoded by the sRGB curve, but pictures here are "
      "linear",
      MISTAKE_GAMMA},
     srgb_decoded},
};

// Of values up to 8, where several bright lights meet; twice that is allowed.
#define CURVE_ERROR (2 * 8 * POW_ERROR)

// Bend a channel; how far a right value within `tolerance` may come to lie from it is added to
// `error`.
static float channel_bend(Curve *curve, float value, float tolerance, float *error)
{
    const double bent = curve(fmax(value, 0)), low = curve(fmax(value - tolerance, 0)),
                 high = curve(fmax(value + tolerance, 0));
    *error = fmaxf(*error, (float)(fmax(high - bent, bent - low) + CURVE_ERROR));
    return (float)bent;
}

static int looks_bent(ProbeImage own, const ExpectedPicture *expected, Curve *curve)
{
    Tally tally = {0};
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        if (is_right_background(expected, pixel)) {
            continue;
        }
        float guess[IMAGE_CHANNELS], error = 0;
        memcpy(guess, pixel.wanted, sizeof guess);
        for (int channel = 0; channel < 3; channel++) {
            guess[channel] = channel_bend(curve, pixel.wanted[channel], pixel.tolerance, &error);
        }
        tally_add(&tally, pixel, guess, isinf(pixel.tolerance) ? pixel.tolerance : error);
    }
    return tally_recognises(&tally);
}

// ---- All ----------------------------------------------------------------------------------------

Cause picture_distortion(ProbeImage own, const ExpectedPicture *expected)
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
    return (Cause){0};
}

// Comparing pictures pixel by pixel, and recognising common mistakes in a wrong one.
//
// Recognising works by trying: each known mistake is made on purpose, to the reference (flips,
// swaps, shifts) or by the oracle (strict boundary, wrong ties), and the one whose picture equals
// the student's is named. Nothing is guessed from statistics.
#include "picture.h"

#include "jobs.h"
#include "message.h"
#include "oracle2d.h"

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

void expected_picture_free(ExpectedPicture *expected)
{
    image_free(&expected->reference);
    free(expected->ambiguous);
    *expected = (ExpectedPicture){0};
}

static const float *own_pixel(ProbeImage own, int x, int y)
{
    return own.pixels + ((size_t)y * own.image_width + x) * IMAGE_CHANNELS;
}

static const float *image_pixel(const Image *image, int x, int y)
{
    return image->pixels + ((size_t)y * image->width + x) * IMAGE_CHANNELS;
}

static int is_unwritten(const float *pixel)
{
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        if (pixel[channel] != UNWRITTEN) {
            return 0;
        }
    }
    return 1;
}

// Equal within the tolerance; a NaN equals nothing.
static int is_same(const float *a, const float *b, float tolerance)
{
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        if (!(fabsf(a[channel] - b[channel]) <= tolerance)) {
            return 0;
        }
    }
    return 1;
}

// ---- What does it look like? ----------------------------------------------------------------

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

static void tally_add(Tally *tally, const float *own, const float *guess, const float *reference,
                      float tolerance)
{
    const int agrees = is_same(own, guess, tolerance);
    const int wrong = !is_same(own, reference, tolerance);
    tally->n_compared++;
    tally->n_agree += (size_t)agrees;
    tally->n_wrong += (size_t)wrong;
    tally->n_explained += (size_t)(wrong && agrees);
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
            if (u < 0 || v < 0 || u >= reference->width || v >= reference->height) {
                continue;
            }
            float guess[IMAGE_CHANNELS];
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                guess[channel] = image_pixel(reference, u, v)[distortion->channels[channel]];
            }
            tally_add(&tally, own_pixel(own, x, y), guess, image_pixel(reference, x, y),
                      expected->tolerance);
        }
    }
    return tally_recognises(&tally);
}

// A mistake made by the oracle.
static const struct {
    const char *looks;
    OracleRules rules;
} mistakes[] = {
    {"drawn as if the boundary did not belong to the circle (strict where it should not be)",
     {.strict_boundary = 1}},
    {"drawn as if of two equal depths the later circle won", {.later_wins_ties = 1}},
    {"drawn as if depth did not matter: the last circle covers the others", {.ignore_depth = 1}},
    {"drawn as if depth did not matter: the first circle keeps the pixel", {.first_wins = 1}},
    {"drawn as if the farthest circle won: the depth test is inverted", {.farthest_wins = 1}},
    {"drawn as if the first circle were missing", {.skip_first = 1}},
    {"drawn as if the last circle were missing", {.skip_last = 1}},
    {"shifted by half a pixel: the sample point is the integer coordinate", {.sample_offset = 0.5}},
    {"shifted by half a pixel: the sample point is the integer coordinate",
     {.sample_offset = -0.5}},
    {"drawn with half the radius", {.diameter = 1}},
};

static int looks_mistaken(ProbeImage own, const ExpectedPicture *expected, const OracleRules *rules)
{
    const Image *reference = &expected->reference;
    Image guess;
    if (image_create(reference->width, reference->height, &guess) != 0) {
        return 0;
    }
    oracle2d_draw(expected->circles, expected->n_circles, rules, &guess, NULL);
    Tally tally = {0};
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            tally_add(&tally, own_pixel(own, x, y), image_pixel(&guess, x, y),
                      image_pixel(reference, x, y), expected->tolerance);
        }
    }
    image_free(&guess);
    return tally_recognises(&tally);
}

// Is every wrong pixel the same colour, as where a background is not (0, 0, 0, 0)?
static const char *wrong_background(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    const float background[IMAGE_CHANNELS] = {0};
    const float *seen = NULL;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const float *pixel = own_pixel(own, x, y);
            const int is_background = is_same(image_pixel(reference, x, y), background, 0);
            const int is_right = is_same(pixel, image_pixel(reference, x, y), expected->tolerance);
            if (is_background == is_right ||
                (seen != NULL && !is_same(pixel, seen, 0) && !is_right)) {
                return NULL;
            }
            seen = is_background ? pixel : seen;
        }
    }
    return seen ? "right but for the background, which is (0, 0, 0, 0) in all four channels" : NULL;
}

// Is every pixel (0, 0, 0, 0), though not every pixel should be?
static int is_empty(ProbeImage own, const Image *reference)
{
    const float background[IMAGE_CHANNELS] = {0};
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            if (!is_same(own_pixel(own, x, y), background, 0)) {
                return 0;
            }
        }
    }
    return 1;
}

// Does every wrong pixel show the circle behind the end of the array?
static int shows_beyond(ProbeImage own, const ExpectedPicture *expected)
{
    const float beyond[IMAGE_CHANNELS] = {BEYOND_RED, BEYOND_GREEN, BEYOND_BLUE, 1};
    const Image *reference = &expected->reference;
    int n_beyond = 0;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const float *pixel = own_pixel(own, x, y);
            if (is_same(pixel, beyond, 0)) {
                n_beyond++;
            } else if (!is_same(pixel, image_pixel(reference, x, y), expected->tolerance)) {
                return 0;
            }
        }
    }
    return n_beyond > 0;
}

// What a wrong picture looks like, or NULL.
static const char *recognise(ProbeImage own, const ExpectedPicture *expected)
{
    if (is_empty(own, &expected->reference)) {
        return "empty: nothing but the background";
    }
    if (shows_beyond(own, expected)) {
        return "drawn as if one circle too many were asked, the one behind the end of the array";
    }
    const char *background = wrong_background(own, expected);
    if (background != NULL) {
        return background;
    }
    for (size_t i = 0; i < sizeof distortions / sizeof *distortions; i++) {
        if (looks_distorted(own, expected, &distortions[i])) {
            return distortions[i].looks;
        }
    }
    for (size_t i = 0; expected->circles != NULL && i < sizeof mistakes / sizeof *mistakes; i++) {
        if (looks_mistaken(own, expected, &mistakes[i].rules)) {
            return mistakes[i].looks;
        }
    }
    return NULL;
}

// ---- Judging --------------------------------------------------------------------------------

static int is_finite(const float *pixel)
{
    return isfinite(pixel[0]) && isfinite(pixel[1]) && isfinite(pixel[2]) && isfinite(pixel[3]);
}

// May this pixel of the student's differ from the reference's? It must be a colour all the same.
static int may_differ(const ExpectedPicture *expected, int x, int y, const float *pixel)
{
    return expected->ambiguous != NULL &&
           expected->ambiguous[(size_t)y * expected->reference.width + x] && is_finite(pixel) &&
           !is_unwritten(pixel);
}

char *picture_judge(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    size_t n_wrong = 0, n_unwritten = 0, n_not_finite = 0;
    int first_x = -1, first_y = -1;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const float *pixel = own_pixel(own, x, y);
            if (is_same(pixel, image_pixel(reference, x, y), expected->tolerance) ||
                may_differ(expected, x, y, pixel)) {
                continue;
            }
            if (n_wrong++ == 0) {
                first_x = x, first_y = y;
            }
            n_unwritten += (size_t)is_unwritten(pixel);
            n_not_finite += !is_finite(pixel);
        }
    }
    if (n_wrong == 0) {
        return NULL;
    }
    const size_t n_pixels = (size_t)reference->width * (size_t)reference->height;
    if (n_unwritten == n_wrong) {
        return message_new("nobody wrote pixel (%d, %d); %zu of %zu pixels were not written",
                           first_x, first_y, n_unwritten, n_pixels);
    }
    const float *found = own_pixel(own, first_x, first_y);
    const float *wanted = image_pixel(reference, first_x, first_y);
    const char *looks = n_not_finite ? "not a number in places" : recognise(own, expected);
    return message_new(
        "pixel (%d, %d): found (%.4g, %.4g, %.4g, %.4g), expected (%.4g, %.4g, %.4g, "
        "%.4g); %zu of %zu pixels differ%s%s",
        first_x, first_y, (double)found[0], (double)found[1], (double)found[2], (double)found[3],
        (double)wanted[0], (double)wanted[1], (double)wanted[2], (double)wanted[3], n_wrong,
        n_pixels, looks ? "; it looks " : "", looks ? looks : "");
}

char *picture_judge_padding(ProbeImage own, int width, int height)
{
    for (int y = 0; y < own.image_height; y++) {
        for (int x = 0; x < own.image_width; x++) {
            if ((x >= width || y >= height) && !is_unwritten(own_pixel(own, x, y))) {
                return message_new(
                    "the kernel wrote outside the picture: pixel (%d, %d) of a %dx%d "
                    "picture; a guard for the work-items that fill up the last "
                    "work-groups is missing or wrong",
                    x, y, width, height);
            }
        }
    }
    return NULL;
}

char *picture_judge_written(ProbeImage own, int width, int height)
{
    size_t n_unwritten = 0;
    int first_x = 0, first_y = 0;
    for (int y = height - 1; y >= 0; y--) {
        for (int x = width - 1; x >= 0; x--) {
            if (is_unwritten(own_pixel(own, x, y))) {
                n_unwritten++;
                first_x = x, first_y = y;
            }
        }
    }
    if (n_unwritten == 0) {
        return NULL;
    }
    return message_new("nobody wrote pixel (%d, %d) of a %dx%d picture; %zu of its pixels were not "
                       "written",
                       first_x, first_y, width, height, n_unwritten);
}

int picture_copy(ProbeImage own, int width, int height, Image *picture)
{
    if (image_create(width, height, picture) != 0) {
        return -1;
    }
    for (int y = 0; y < height; y++) {
        memcpy(picture->pixels + (size_t)y * width * IMAGE_CHANNELS, own_pixel(own, 0, y),
               (size_t)width * IMAGE_CHANNELS * sizeof *picture->pixels);
    }
    return 0;
}

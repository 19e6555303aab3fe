// Comparing pictures pixel by pixel.
#include "picture.h"

#include "image_size.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "picture_looks.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void expected_picture_free(ExpectedPicture *expected)
{
    expected_picture_recognise(expected, NULL, NULL);
    image_free(&expected->reference);
    free(expected->tolerances);
    *expected = (ExpectedPicture){0};
}

// ---- Pixel by pixel ---------------------------------------------------------------------------

ProbeImage probe_image_find(const Sections *answers, int k, int width, int height)
{
    const int image_width = PROBE_IMAGE_SIDE(width), image_height = PROBE_IMAGE_SIDE(height);
    const size_t n_bytes =
        (size_t)image_width * (size_t)image_height * IMAGE_CHANNELS * sizeof(float);
    return (ProbeImage){job_section_find(answers, "picture", k, n_bytes), image_width,
                        image_height};
}

const float *probe_image_pixel(ProbeImage own, int x, int y)
{
    return own.pixels + ((size_t)y * own.image_width + x) * IMAGE_CHANNELS;
}

const float *image_pixel(const Image *image, int x, int y)
{
    return image->pixels + ((size_t)y * image->width + x) * IMAGE_CHANNELS;
}

int expected_n_pixels(const ExpectedPicture *expected)
{
    return expected->reference.width * expected->reference.height;
}

PixelPair pixel_pair(ProbeImage own, const ExpectedPicture *expected, int i)
{
    const int x = i % expected->reference.width, y = i / expected->reference.width;
    return (PixelPair){x, y, probe_image_pixel(own, x, y), image_pixel(&expected->reference, x, y),
                       expected->tolerances ? expected->tolerances[i] : expected->tolerance};
}

int is_same_color(const float *a, const float *b, float tolerance)
{
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        if (!(fabsf(a[channel] - b[channel]) <= tolerance)) {
            return 0;
        }
    }
    return 1;
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

static int is_finite(const float *pixel)
{
    return isfinite(pixel[0]) && isfinite(pixel[1]) && isfinite(pixel[2]) && isfinite(pixel[3]);
}

static int has_nan(const float *pixel)
{
    return isnan(pixel[0]) || isnan(pixel[1]) || isnan(pixel[2]) || isnan(pixel[3]);
}

// A pixel that may have any colour must be one all the same.
static int is_right(PixelPair pixel)
{
    return is_finite(pixel.own) && !is_unwritten(pixel.own) &&
           is_same_color(pixel.own, pixel.wanted, pixel.tolerance);
}

// ---- Judging ------------------------------------------------------------------------------------

static Words color_words(const float *color)
{
    return words("(%.4g, %.4g, %.4g, %.4g)", color[0], color[1], color[2], color[3]);
}

static Diagnosis describe_unwritten(ProbeImage own, const ExpectedPicture *expected,
                                    PixelPair first, int n_unwritten)
{
    const Words cut = picture_cut(own, expected);
    Diagnosis unwritten =
        diagnosis_new("nobody wrote pixel (%d, %d) of a %dx%d picture: found nothing, expected %s "
                      "(%d of %d pixels were not written)",
                      first.x, first.y, expected->reference.width, expected->reference.height,
                      color_words(first.wanted).text, n_unwritten, expected_n_pixels(expected));
    unwritten.cause = cut.text[0] != '\0' ? message_new("it looks %s", cut.text) : NULL;
    unwritten.mistake = MISTAKE_UNWRITTEN;
    unwritten.evidence = EVIDENCE_PICTURE;
    return unwritten;
}

Diagnosis picture_judge(ProbeImage own, const ExpectedPicture *expected)
{
    int n_wrong = 0, n_unwritten = 0, n_not_finite = 0, n_nan = 0;
    PixelPair first = {0};
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        if (is_right(pixel)) {
            continue;
        }
        first = n_wrong++ == 0 ? pixel : first;
        n_unwritten += is_unwritten(pixel.own);
        n_not_finite += !is_finite(pixel.own);
        n_nan += has_nan(pixel.own);
    }
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    if (n_unwritten == n_wrong) {
        return describe_unwritten(own, expected, first, n_unwritten);
    }
    const char *plain = n_nan          ? "not a number in places"
                        : n_not_finite ? "infinite in places"
                                       : picture_plain(own, expected);
    char *found =
        message_new("pixel (%d, %d): found %s, expected %s (%d of %d pixels differ)%s%s", first.x,
                    first.y, color_words(first.own).text, color_words(first.wanted).text, n_wrong,
                    expected_n_pixels(expected), plain ? ", it looks " : "", plain ? plain : "");
    if (plain == NULL) {
        return picture_looks(own, expected, found);
    }
    // That it holds no numbers says nothing. One colour may be that of a known mistake.
    const int may_be_known = n_not_finite == 0 && !picture_is_empty(own, expected);
    return diagnosis_seen(found, may_be_known ? picture_mistaken(own, expected) : (Cause){0},
                          n_nan ? EVIDENCE_PICTURE : EVIDENCE_PLAIN_PICTURE);
}

int picture_is_right(ProbeImage own, const ExpectedPicture *expected)
{
    int i = 0;
    while (i < expected_n_pixels(expected) && is_right(pixel_pair(own, expected, i))) {
        i++;
    }
    return i == expected_n_pixels(expected);
}

Diagnosis picture_judge_padding(ProbeImage own, const ExpectedPicture *expected)
{
    static const Cause swapped = {.says = "x and y are swapped, or width and height"};
    static const Cause not_own = {.says = "the guard is missing or wrong, or x and y are not the "
                                          "column and row of this work-item"};
    static const Cause no_guard = {.says = "a guard for the work-items that fill up the last "
                                           "work-groups is missing or wrong, or a "
                                           "barrier comes behind it, which these never reach"};
    const int width = expected->reference.width, height = expected->reference.height;
    const int is_swapped = picture_is_swapped(own, expected);
    for (int y = 0; y < own.image_height; y++) {
        for (int x = 0; x < own.image_width; x++) {
            const float *pixel = probe_image_pixel(own, x, y);
            if ((x >= width || y >= height) && pixel[IMAGE_CHANNELS - 1] == DRAWN_AGAIN) {
                return diagnosis_of(message_new("work-item (%d, %d), outside of a %dx%d picture: "
                                                "found that it drew pixel (%g, %g) once more, "
                                                "expected nothing",
                                                x, y, width, height, pixel[0], pixel[1]),
                                    is_swapped ? swapped : not_own);
            }
            if ((x >= width || y >= height) && !is_unwritten(pixel)) {
                return diagnosis_of(message_new("the kernel wrote outside the picture: pixel (%d, "
                                                "%d) of a %dx%d picture",
                                                x, y, width, height),
                                    is_swapped ? swapped : no_guard);
            }
        }
    }
    return NOTHING_WRONG;
}

Diagnosis picture_judge_written(ProbeImage own, const ExpectedPicture *expected)
{
    int n_unwritten = 0;
    PixelPair first = {0};
    for (int i = expected_n_pixels(expected) - 1; i >= 0; i--) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        if (is_unwritten(pixel.own)) {
            n_unwritten++;
            first = pixel;
        }
    }
    return n_unwritten == 0 ? NOTHING_WRONG : describe_unwritten(own, expected, first, n_unwritten);
}

int picture_copy(ProbeImage own, int width, int height, Image *picture)
{
    if (image_create(width, height, picture) != 0) {
        return -1;
    }
    for (int y = 0; y < height; y++) {
        memcpy(picture->pixels + (size_t)y * width * IMAGE_CHANNELS, probe_image_pixel(own, 0, y),
               (size_t)width * IMAGE_CHANNELS * sizeof *picture->pixels);
    }
    return 0;
}

// Comparing pictures pixel by pixel.
#include "picture.h"

#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "picture_looks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void expected_picture_free(ExpectedPicture *expected)
{
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

float expected_tolerance(const ExpectedPicture *expected, int x, int y)
{
    return expected->tolerances ? expected->tolerances[(size_t)y * expected->reference.width + x]
                                : expected->tolerance;
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
static int is_right(ProbeImage own, const ExpectedPicture *expected, int x, int y)
{
    const float *pixel = probe_image_pixel(own, x, y);
    return is_finite(pixel) && !is_unwritten(pixel) &&
           is_same_color(pixel, image_pixel(&expected->reference, x, y),
                         expected_tolerance(expected, x, y));
}

// ---- Judging ----------------------------------------------------------------------------------

static char *describe_unwritten(const ExpectedPicture *expected, int x, int y, size_t n_unwritten)
{
    const Image *reference = &expected->reference;
    const float *wanted = image_pixel(reference, x, y);
    return message_new("nobody wrote pixel (%d, %d) of a %dx%d picture: found nothing, expected "
                       "(%.4g, %.4g, %.4g, %.4g) (%zu of %zu pixels were not written)",
                       x, y, reference->width, reference->height, (double)wanted[0],
                       (double)wanted[1], (double)wanted[2], (double)wanted[3], n_unwritten,
                       (size_t)reference->width * (size_t)reference->height);
}

char *picture_judge(ProbeImage own, const ExpectedPicture *expected)
{
    const Image *reference = &expected->reference;
    size_t n_wrong = 0, n_unwritten = 0, n_not_finite = 0, n_nan = 0;
    int first_x = -1, first_y = -1;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            if (is_right(own, expected, x, y)) {
                continue;
            }
            const float *pixel = probe_image_pixel(own, x, y);
            if (n_wrong++ == 0) {
                first_x = x, first_y = y;
            }
            n_unwritten += (size_t)is_unwritten(pixel);
            n_not_finite += !is_finite(pixel);
            n_nan += (size_t)has_nan(pixel);
        }
    }
    if (n_wrong == 0) {
        return NULL;
    }
    const size_t n_pixels = (size_t)reference->width * (size_t)reference->height;
    if (n_unwritten == n_wrong) {
        return describe_unwritten(expected, first_x, first_y, n_unwritten);
    }
    const float *found = probe_image_pixel(own, first_x, first_y);
    const float *wanted = image_pixel(reference, first_x, first_y);
    const char *plain = n_nan          ? "not a number in places"
                        : n_not_finite ? "infinite in places"
                                       : picture_plain(own, expected);
    char *looks = plain ? NULL : picture_looks(own, expected);
    char *message = message_new(
        "pixel (%d, %d): found (%.4g, %.4g, %.4g, %.4g), expected (%.4g, %.4g, %.4g, "
        "%.4g) (%zu of %zu pixels differ)%s%s%s",
        first_x, first_y, (double)found[0], (double)found[1], (double)found[2], (double)found[3],
        (double)wanted[0], (double)wanted[1], (double)wanted[2], (double)wanted[3], n_wrong,
        n_pixels, plain ? ", it looks " : "", looks ? MESSAGE_CAUSE "it looks " : "",
        plain   ? plain
        : looks ? looks
                : "");
    free(looks);
    return message;
}

int picture_is_right(ProbeImage own, const ExpectedPicture *expected)
{
    for (int y = 0; y < expected->reference.height; y++) {
        for (int x = 0; x < expected->reference.width; x++) {
            if (!is_right(own, expected, x, y)) {
                return 0;
            }
        }
    }
    return 1;
}

char *picture_judge_padding(ProbeImage own, int width, int height)
{
    for (int y = 0; y < own.image_height; y++) {
        for (int x = 0; x < own.image_width; x++) {
            if ((x >= width || y >= height) && !is_unwritten(probe_image_pixel(own, x, y))) {
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

char *picture_judge_written(ProbeImage own, const ExpectedPicture *expected)
{
    size_t n_unwritten = 0;
    int first_x = 0, first_y = 0;
    for (int y = expected->reference.height - 1; y >= 0; y--) {
        for (int x = expected->reference.width - 1; x >= 0; x--) {
            if (is_unwritten(probe_image_pixel(own, x, y))) {
                n_unwritten++;
                first_x = x, first_y = y;
            }
        }
    }
    return n_unwritten == 0 ? NULL : describe_unwritten(expected, first_x, first_y, n_unwritten);
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

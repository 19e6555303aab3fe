// Pictures in memory: made, released and compared, in plain C (see image.h).
//
// Comparing is our own code because those of OpenImageIO let NaNs and smaller pictures pass. Read
// next: image_file.c, for files.
#include "image.h"

#include "complain.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int image_create(int width, int height, Image *image)
{
    *image = (Image){0};
    if (width <= 0 || height <= 0) {
        complain("image: found a size of %dx%d, expected positive numbers", width, height);
        return -1;
    }
    // calloc() multiplies with a check; the pixels of a row always fit in size_t.
    float *pixels = calloc((size_t)height, (size_t)width * IMAGE_CHANNELS * sizeof *pixels);
    if (pixels == NULL) {
        complain("image: no memory for %dx%d pixels", width, height);
        return -1;
    }
    image->width = width;
    image->height = height;
    image->pixels = pixels;
    return 0;
}

void image_free(Image *image)
{
    free(image->pixels);
    *image = (Image){0};
}

size_t image_stem_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash == NULL ? path : slash + 1;
    const char *ending = strrchr(name, '.');
    if (ending == NULL || ending == name ||
        (strcmp(ending, ".exr") != 0 && strcmp(ending, ".png") != 0)) {
        return 0;
    }
    return (size_t)(ending - path);
}

// The largest difference of one channel; NaN when a value of either pixel is not finite.
static float pixel_difference(const float *pixel, const float *reference)
{
    float largest = 0;
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        if (!isfinite(pixel[channel]) || !isfinite(reference[channel])) {
            return NAN;
        }
        largest = fmaxf(largest, fabsf(pixel[channel] - reference[channel]));
    }
    return largest;
}

ImageDifference image_compare(const Image *image, const Image *reference, float tolerance)
{
    ImageDifference result = {.first_x = -1, .first_y = -1};
    result.same_size = image->width == reference->width && image->height == reference->height;
    if (!result.same_size) {
        return result;
    }

    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            size_t offset = ((size_t)y * (size_t)image->width + (size_t)x) * IMAGE_CHANNELS;
            float difference = pixel_difference(image->pixels + offset, reference->pixels + offset);
            if (isnan(difference)) {
                result.n_not_finite++;
            } else {
                result.max_difference = fmaxf(result.max_difference, difference);
            }

            // "Not within" instead of "beyond": a NaN, also as the tolerance, never passes.
            if (!(difference <= tolerance)) {
                if (result.n_different == 0) {
                    result.first_x = x;
                    result.first_y = y;
                }
                result.n_different++;
            }
        }
    }
    return result;
}

// The inferno colour map (Smith and van der Walt, 2015) at nine even steps, straight lines between.
static const float INFERNO[][3] = {
    {0.001462f, 0.000466f, 0.013866f}, {0.122908f, 0.047536f, 0.281624f},
    {0.341500f, 0.062325f, 0.429425f}, {0.556571f, 0.129285f, 0.390781f},
    {0.735683f, 0.215906f, 0.330245f}, {0.886302f, 0.342586f, 0.202968f},
    {0.969680f, 0.512405f, 0.062640f}, {0.981895f, 0.762837f, 0.143729f},
    {0.988362f, 0.998364f, 0.644924f},
};
#define INFERNO_STEPS ((int)(sizeof INFERNO / sizeof INFERNO[0]) - 1)

void image_heat_colour(float value, float *rgb)
{
    float position = fminf(value, 1.0f) * (float)INFERNO_STEPS;
    int step = (int)position < INFERNO_STEPS ? (int)position : INFERNO_STEPS - 1;
    float part = position - (float)step;
    for (int channel = 0; channel < 3; channel++) {
        rgb[channel] = INFERNO[step][channel] * (1 - part) + INFERNO[step + 1][channel] * part;
    }
}

// What is no number has a colour that no difference has: cyan.
static const float NAN_COLOUR[3] = {0, 1, 1};

// Equal to the bit is 0, the brightest colour 1; NAN where either pixel holds what is no number.
static float difference_brightness(const float *pixel, const float *reference)
{
    float sum = 0;
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        sum += fabsf(pixel[channel] - reference[channel]);
    }
    return isnan(sum) ? NAN : fminf(sum / IMAGE_BRIGHTEST_DIFFERENCE, 1.0f);
}

int image_difference_picture(const Image *image, const Image *reference, Image *difference)
{
    *difference = (Image){0};
    if (image->width != reference->width || image->height != reference->height) {
        complain("image: found sizes %dx%d and %dx%d, expected the same", image->width,
                 image->height, reference->width, reference->height);
        return -1;
    }
    if (image_create(image->width, image->height, difference) != 0) {
        return -1;
    }

    size_t n_pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < n_pixels; i++) {
        size_t offset = i * IMAGE_CHANNELS;
        float brightness =
            difference_brightness(image->pixels + offset, reference->pixels + offset);
        float *pixel = difference->pixels + offset;
        pixel[3] = 1;
        if (isnan(brightness)) {
            memcpy(pixel, NAN_COLOUR, sizeof NAN_COLOUR);
        } else if (brightness > 0) {
            image_heat_colour(brightness, pixel);
        }
    }
    return 0;
}

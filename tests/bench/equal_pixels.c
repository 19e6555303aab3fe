// Are two pictures equal to the bit? (See equal_pixels.h.)
#include "equal_pixels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void report(const float *found, const float *expected)
{
    fprintf(stderr, "found (%.9g, %.9g, %.9g, %.9g), expected (%.9g, %.9g, %.9g, %.9g)\n",
            (double)found[0], (double)found[1], (double)found[2], (double)found[3],
            (double)expected[0], (double)expected[1], (double)expected[2], (double)expected[3]);
}

void round_to_bytes(Image *picture)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height * IMAGE_CHANNELS;
    for (size_t i = 0; i < n; i++) {
        const float channel = fminf(fmaxf(picture->pixels[i], 0), 1);
        picture->pixels[i] = floorf(channel * 255 + 0.5f) / 255;
    }
}

int equal_pixels(const Image *picture, const Image *reference, int n_rows, const char *name)
{
    const size_t width = (size_t)picture->width, n_pixels = width * (size_t)n_rows;
    size_t n_different = 0, first = 0;
    for (size_t i = n_pixels; i-- > 0;) {
        const size_t at = i * IMAGE_CHANNELS;
        if (memcmp(picture->pixels + at, reference->pixels + at, IMAGE_CHANNELS * sizeof(float))) {
            n_different++;
            first = i;
        }
    }
    if (n_different == 0) {
        return 0;
    }
    fprintf(stderr, "%s: %zu of %zu pixels differ; the first is (%zu, %zu): ", name, n_different,
            n_pixels, first % width, first / width);
    report(picture->pixels + first * IMAGE_CHANNELS, reference->pixels + first * IMAGE_CHANNELS);
    return -1;
}

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

// How many pixels of two pictures differ in their first n_rows rows?
//   first   out: the number of the first that does, row by row
static size_t count_different(const Image *picture, const Image *reference, int n_rows,
                              size_t *first)
{
    size_t n_different = 0;
    for (size_t i = (size_t)picture->width * (size_t)n_rows; i-- > 0;) {
        const size_t at = i * IMAGE_CHANNELS;
        if (memcmp(picture->pixels + at, reference->pixels + at, IMAGE_CHANNELS * sizeof(float))) {
            n_different++;
            *first = i;
        }
    }
    return n_different;
}

int equal_pixels(const Image *picture, const Image *reference, int n_rows, const char *name)
{
    const size_t width = (size_t)picture->width, n_pixels = width * (size_t)n_rows;
    size_t first = 0;
    const size_t n_different = count_different(picture, reference, n_rows, &first);
    if (n_different == 0) {
        return 0;
    }
    fprintf(stderr, "%s: %zu of %zu pixels differ; the first is (%zu, %zu): ", name, n_different,
            n_pixels, first % width, first / width);
    report(picture->pixels + first * IMAGE_CHANNELS, reference->pixels + first * IMAGE_CHANNELS);
    return -1;
}

int similar_pixels(const Image *picture, const Image *reference, int n_rows, const char *name)
{
    const size_t n_pixels = (size_t)picture->width * (size_t)n_rows;
    size_t first = 0;
    const size_t n_different = count_different(picture, reference, n_rows, &first);
    if ((double)n_different <= SIMILAR_SHARE * (double)n_pixels) {
        return 0;
    }
    fprintf(stderr, "%s: %zu of %zu pixels differ, expected at most %g of them\n", name,
            n_different, n_pixels, SIMILAR_SHARE);
    return -1;
}

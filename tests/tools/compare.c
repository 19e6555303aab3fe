// compare: are two pictures equal, pixel by pixel? For the suites in tests/suites/.
//
//     compare PICTURE REFERENCE [TOLERANCE [N_EXCEPTIONS]]
//
// Prints "WxH: equal", or where they first differ: the pixel in reading order and both values.
// TOLERANCE is the difference that a channel may have, 0 without it; up to N_EXCEPTIONS pixels may
// differ by more, where rounding decides what a ray hits.
// Exit status: 0 equal, 1 different, 2 one could not be read or the words are wrong.
#include "complain.h"
#include "image.h"
#include "number.h"

#include <stdio.h>

enum { EXIT_EQUAL = 0, EXIT_DIFFERENT = 1, EXIT_FAULT = 2 };

static void print_pixel(const Image *image, int x, int y)
{
    const float *pixel = image->pixels + ((size_t)y * image->width + x) * IMAGE_CHANNELS;
    printf("(%.9g, %.9g, %.9g, %.9g)", pixel[0], pixel[1], pixel[2], pixel[3]);
}

static int compare(const Image *image, const Image *reference, float tolerance,
                   int64_t n_exceptions)
{
    const ImageDifference difference = image_compare(image, reference, tolerance);
    if (!difference.same_size) {
        printf("sizes differ: found %dx%d, expected %dx%d\n", image->width, image->height,
               reference->width, reference->height);
        return EXIT_DIFFERENT;
    }
    if (difference.n_different <= n_exceptions && difference.n_not_finite == 0) {
        printf("%dx%d: equal\n", image->width, image->height);
        return EXIT_EQUAL;
    }
    printf("%d pixels differ; the first is (%d, %d): found ", difference.n_different,
           difference.first_x, difference.first_y);
    print_pixel(image, difference.first_x, difference.first_y);
    printf(", expected ");
    print_pixel(reference, difference.first_x, difference.first_y);
    printf("\n");
    return EXIT_DIFFERENT;
}

int main(int argc, char **argv)
{
    Image image = {0}, reference = {0};
    float tolerance = 0;
    int64_t n_exceptions = 0;
    if (argc < 3 || argc > 5 || (argc >= 4 && number_read_float(argv[3], &tolerance) != 0) ||
        (argc == 5 && number_read_integer(argv[4], 0, INT64_MAX, &n_exceptions) != 0)) {
        complain("usage: compare PICTURE REFERENCE [TOLERANCE [N_EXCEPTIONS]]");
        return EXIT_FAULT;
    }
    int status = EXIT_FAULT;
    if (image_load(argv[1], &image) == 0 && image_load(argv[2], &reference) == 0) {
        status = compare(&image, &reference, tolerance, n_exceptions);
    }
    image_free(&image);
    image_free(&reference);
    return status;
}

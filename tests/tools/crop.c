// crop: a part of a picture, or the same part of several, side by side. For tests/suites/view.sh, as
// a window holds more than its picture, and for figures that compare.
//
//     crop PICTURE... X Y WIDTH HEIGHT OUTPUT
//
// Exit status: 0, or 2 after one message where one cannot be read or written, where the part is not
// inside it, or where the words are wrong.
#include "complain.h"
#include "image.h"
#include "number.h"

#include <string.h>

enum { EXIT_FAULT = 2 };

// Between two parts that stand side by side, pixels; they are white.
enum { GAP = 12 };

// A part of a picture.
typedef struct Part {
    int x, y, width, height;
} Part;

// Copy the part into `cropped`, its left side at column `left`. Returns 0, or -1 after one message.
static int part_copy(const Image *image, Part part, Image *cropped, int left)
{
    if (part.x + part.width > image->width || part.y + part.height > image->height) {
        complain("crop: found a picture of %dx%d, expected at least %dx%d", image->width,
                 image->height, part.x + part.width, part.y + part.height);
        return -1;
    }
    for (int row = 0; row < part.height; row++) {
        const size_t from = (size_t)(part.y + row) * (size_t)image->width + (size_t)part.x;
        const size_t to = (size_t)row * (size_t)cropped->width + (size_t)left;
        memcpy(cropped->pixels + to * IMAGE_CHANNELS, image->pixels + from * IMAGE_CHANNELS,
               (size_t)part.width * IMAGE_CHANNELS * sizeof *image->pixels);
    }
    return 0;
}

// Returns 0, or -1 after one message.
static int crop(char **pictures, int n_pictures, Part part, const char *output)
{
    Image cropped;
    if (image_create(n_pictures * (part.width + GAP) - GAP, part.height, &cropped) != 0) {
        return -1;
    }
    const size_t n_values = (size_t)cropped.width * (size_t)cropped.height * IMAGE_CHANNELS;
    for (size_t i = 0; i < n_values; i++) {
        cropped.pixels[i] = 1;
    }
    int result = 0;
    for (int i = 0; i < n_pictures && result == 0; i++) {
        Image image = {0};
        result = image_load(pictures[i], &image) != 0 ||
                         part_copy(&image, part, &cropped, i * (part.width + GAP)) != 0
                     ? -1
                     : 0;
        image_free(&image);
    }
    result = result == 0 ? image_save(&cropped, output) : result;
    image_free(&cropped);
    return result;
}

int main(int argc, char **argv)
{
    enum { X, Y, WIDTH, HEIGHT, N_NUMBERS };
    int64_t n[N_NUMBERS];
    const int n_pictures = argc - 1 - N_NUMBERS - 1;
    int is_right = n_pictures >= 1;
    for (int i = 0; is_right && i < N_NUMBERS; i++) {
        is_right =
            number_read_integer(argv[1 + n_pictures + i], i < WIDTH ? 0 : 1, 100000, &n[i]) == 0;
    }
    if (!is_right) {
        complain("usage: crop PICTURE... X Y WIDTH HEIGHT OUTPUT");
        return EXIT_FAULT;
    }
    const Part part = {(int)n[X], (int)n[Y], (int)n[WIDTH], (int)n[HEIGHT]};
    return crop(argv + 1, n_pictures, part, argv[argc - 1]) == 0 ? 0 : EXIT_FAULT;
}

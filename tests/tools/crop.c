// crop: a part of a picture. For tests/suites/view.sh, as a window holds more than its picture.
//
//     crop PICTURE X Y WIDTH HEIGHT OUTPUT
//
// Exit status: 0, or 2 after one message where it cannot be read or written, where the part is not
// inside it, or where the words are wrong.
#include "complain.h"
#include "image.h"
#include "number.h"

#include <string.h>

enum { EXIT_FAULT = 2 };

// Returns 0, or -1 after one message.
static int crop(const Image *image, int x, int y, Image *part)
{
    if (x + part->width > image->width || y + part->height > image->height) {
        complain("crop: found a picture of %dx%d, expected at least %dx%d", image->width,
                 image->height, x + part->width, y + part->height);
        return -1;
    }
    const size_t row_length = (size_t)part->width * IMAGE_CHANNELS;
    for (int row = 0; row < part->height; row++) {
        const size_t start =
            ((size_t)(y + row) * (size_t)image->width + (size_t)x) * IMAGE_CHANNELS;
        memcpy(part->pixels + (size_t)row * row_length, image->pixels + start,
               row_length * sizeof *image->pixels);
    }
    return 0;
}

int main(int argc, char **argv)
{
    enum { X, Y, WIDTH, HEIGHT, N_NUMBERS };
    int64_t n[N_NUMBERS];
    int is_right = argc == N_NUMBERS + 3;
    for (int i = 0; is_right && i < N_NUMBERS; i++) {
        is_right = number_read_integer(argv[2 + i], i < WIDTH ? 0 : 1, 100000, &n[i]) == 0;
    }
    if (!is_right) {
        complain("usage: crop PICTURE X Y WIDTH HEIGHT OUTPUT");
        return EXIT_FAULT;
    }
    Image image = {0}, part = {0};
    const int result = image_load(argv[1], &image) != 0 ||
                       image_create((int)n[WIDTH], (int)n[HEIGHT], &part) != 0 ||
                       crop(&image, (int)n[X], (int)n[Y], &part) != 0 ||
                       image_save(&part, argv[argc - 1]) != 0;
    image_free(&image);
    image_free(&part);
    return result ? EXIT_FAULT : 0;
}

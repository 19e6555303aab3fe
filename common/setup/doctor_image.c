// What `make doctor` asks of OpenImageIO: can it write a picture and read it again?
//
//     doctor_image FOLDER
//
// Leaves doctor.png and doctor.exr in the folder, and prints one line. Ends with 0, or with 1 after
// one message on stderr, or with 2 without a folder. Read next: doctor.sh, which compiles it.
#include "image.h"

#include <limits.h>
#include <stdio.h>

// Write the picture, read it, compare. Returns 0, or -1 after one message.
static int image_there_and_back(const Image *image, const char *folder, const char *format)
{
    char path[PATH_MAX];
    Image loaded = {0};
    snprintf(path, sizeof path, "%s/doctor.%s", folder, format);
    if (image_save(image, path) != 0 || image_load(path, &loaded) != 0) {
        return -1;
    }
    const ImageDifference difference = image_compare(&loaded, image, 0);
    image_free(&loaded);
    if (!difference.same_size || difference.n_different > 0) {
        fprintf(stderr, "%s: read again, the picture is another one\n", path);
        return -1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: doctor_image FOLDER\n");
        return 2;
    }
    // Values that 8 bits hold exactly: black, white, opaque.
    Image image;
    if (image_create(16, 8, &image) != 0) {
        return 1;
    }
    for (int i = 0; i < image.width * image.height * IMAGE_CHANNELS; i++) {
        const int is_alpha = i % IMAGE_CHANNELS == IMAGE_CHANNELS - 1;
        image.pixels[i] = is_alpha || i % 7 < 3 ? 1.0f : 0.0f;
    }
    const int result = image_there_and_back(&image, argv[1], "png") == 0 &&
                               image_there_and_back(&image, argv[1], "exr") == 0
                           ? 0
                           : 1;
    image_free(&image);
    if (result == 0) {
        puts("PNG and EXR are written and read");
    }
    return result;
}

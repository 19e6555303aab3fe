// Are two pictures the same? (See same_pictures.h.)
#include "same_pictures.h"

#include "complain.h"

#include <math.h>

void round_to_bytes(Image *picture)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height * IMAGE_CHANNELS;
    for (size_t i = 0; i < n; i++) {
        const float channel = fminf(fmaxf(picture->pixels[i], 0), 1);
        picture->pixels[i] = floorf(channel * 255 + 0.5f) / 255;
    }
}

int pictures_compare(const Image *picture, const Image *reference, float tolerance, int most,
                     const char *names)
{
    const ImageDifference difference = image_compare(picture, reference, tolerance);
    if (difference.n_different <= most) {
        return difference.n_different;
    }
    complain("%s: found %d of %d pixels different, the first at (%d, %d), expected at most %d",
             names, difference.n_different, picture->width * picture->height, difference.first_x,
             difference.first_y, most);
    return -1;
}

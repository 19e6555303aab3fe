// Judging pictures of an answer that is tried alone (see alone_picture.h).
#include "alone_picture.h"

#include "jobs.h"
#include "picture.h"
#include "picture_looks.h"

#include <math.h>
#include <string.h>

int alone_picture_is_right(const Sections *answers, int k, int width, int height, float tolerance,
                           ColorAt *color_at, const void *scene)
{
    const ProbeImage own = probe_image_find(answers, k, width, height);
    int is_right = own.pixels != NULL;
    for (int y = 0; is_right && y < height; y++) {
        for (int x = 0; is_right && x < width; x++) {
            float color[IMAGE_CHANNELS] = {0};
            color_at(scene, x, y, color);
            is_right = is_same_color(probe_image_pixel(own, x, y), color, tolerance);
        }
    }
    return is_right;
}

int alone_picture_expect(int width, int height, float tolerance, ColorAt *color_at,
                         const void *scene, ExpectedPicture *expected)
{
    expected->tolerance = tolerance;
    if (image_create(width, height, &expected->reference) != 0) {
        return -1;
    }
    for (int i = 0; i < width * height; i++) {
        color_at(scene, i % width, i / width,
                 expected->reference.pixels + (size_t)i * IMAGE_CHANNELS);
    }
    return 0;
}

// Is every pixel written, with numbers?
static int is_whole(ProbeImage own, const ExpectedPicture *expected)
{
    int i = 0;
    for (; i < expected_n_pixels(expected); i++) {
        const float *p = pixel_pair(own, expected, i).own;
        if (!isfinite(p[0] + p[1] + p[2] + p[3]) || p[0] == UNWRITTEN) {
            break;
        }
    }
    return i == expected_n_pixels(expected);
}

static Cause look(ProbeImage own, const ExpectedPicture *expected)
{
    return is_whole(own, expected) && picture_plain(own, expected) == NULL
               ? picture_known(own, expected)
               : (Cause){0};
}

Cause alone_pictures_look(const void *job, int first, int n, ExpectAlone *expect,
                          const Sections *answers)
{
    Cause looks = {0};
    int result = 0;
    for (int k = first; result == 0 && k < first + n; k++) {
        ExpectedPicture expected = {0};
        result = expect(job, k, &expected);
        const Image *reference = &expected.reference;
        const ProbeImage own = probe_image_find(answers, k, reference->width, reference->height);
        result = result == 0 && own.pixels != NULL ? 0 : -1;
        if (result == 0 && !picture_is_right(own, &expected)) {
            const Cause one = look(own, &expected);
            const int is_other =
                looks.says != NULL && one.says != NULL && strcmp(looks.says, one.says) != 0;
            result = one.says == NULL || is_other ? -1 : 0;
            looks = one;
        }
        expected_picture_free(&expected);
    }
    return result == 0 ? looks : (Cause){0};
}

int alone_picture_keeps_inside(const Sections *answers, int k, int width, int height)
{
    const ProbeImage own = probe_image_find(answers, k, width, height);
    int is_right = own.pixels != NULL;
    for (int y = 0; is_right && y < own.image_height; y++) {
        for (int x = 0; is_right && x < own.image_width; x++) {
            const int is_inside = x < width && y < height;
            is_right = (probe_image_pixel(own, x, y)[0] != UNWRITTEN) == is_inside;
        }
    }
    return is_right;
}

// Judging pictures of an answer that is tried alone (see alone_picture.h).
#include "alone_picture.h"

#include "jobs.h"
#include "picture.h"

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

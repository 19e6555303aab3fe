// compare_mirrors: is a picture with shadows and mirrors what the double-precision oracle draws?
//
//     compare_mirrors SCENE WxH N_BOUNCES PICTURE [TOLERANCE]
//
// Of labs 09 and 10, whose pictures hold no channel above 1 and bytes at best. Prints how many
// pixels are ambiguous, as rounding may decide there what a ray hits, and how many of the others
// are farther off than rounding explains, with the first of them. Exit status: 0 when there are
// none, else 1; 2 when something is missing. TOLERANCE is what a channel may be off besides: 0
// without it.
#include "camera_from_view.h"
#include "complain.h"
#include "image.h"
#include "number.h"
#include "oracle3d_mirrors.h"
#include "scene3d.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// Half a step of a byte, and what float adds to it.
#define BYTE_ERROR (0.5 / 255 + 1e-6)

static double cut(double channel)
{
    return fmin(fmax(channel, 0), 1);
}

// How far a pixel is off in the channel that is off most.
static double distance(const float *found, const float *expected)
{
    double most = 0;
    for (int channel = 0; channel < 3; channel++) {
        const double off = fabs(cut(found[channel]) - cut(expected[channel]));
        // What is no number is off, too.
        most = off <= most ? most : off;
    }
    return most;
}

// Returns the number of pixels that are off.
static int compare(const Image *found, const Image *expected, const float *tolerances,
                   float tolerance)
{
    int n_ambiguous = 0, n_off = 0, first = 0;
    for (int i = 0; i < found->width * found->height; i++) {
        const float *pixels[] = {found->pixels + (size_t)i * IMAGE_CHANNELS,
                                 expected->pixels + (size_t)i * IMAGE_CHANNELS};
        const int is_off =
            !(distance(pixels[0], pixels[1]) <= tolerances[i] + tolerance + BYTE_ERROR);
        n_ambiguous += isinf(tolerances[i]);
        first = is_off && n_off == 0 ? i : first;
        n_off += is_off;
    }
    printf("%dx%d: %d ambiguous, %d off", found->width, found->height, n_ambiguous, n_off);
    if (n_off > 0) {
        const float *is = found->pixels + (size_t)first * IMAGE_CHANNELS;
        const float *should = expected->pixels + (size_t)first * IMAGE_CHANNELS;
        printf("; the first is (%d, %d): found (%g, %g, %g), expected (%g, %g, %g) within %g",
               first % found->width, first / found->width, is[0], is[1], is[2], should[0],
               should[1], should[2], tolerances[first] + tolerance + BYTE_ERROR);
    }
    printf("\n");
    return n_off;
}

int main(int argc, char **argv)
{
    int width, height, n_bounces, status = 2;
    float tolerance = 0;
    Scene3D scene = {0};
    Image found = {0}, expected = {0};
    if (argc < 5 || argc > 6 || sscanf(argv[2], "%dx%d", &width, &height) != 2 ||
        sscanf(argv[3], "%d", &n_bounces) != 1 ||
        (argc == 6 && number_read_float(argv[5], &tolerance) != 0)) {
        complain("usage: compare_mirrors SCENE WxH N_BOUNCES PICTURE [TOLERANCE]");
        return 2;
    }
    float *tolerances = malloc((size_t)width * (size_t)height * sizeof *tolerances);
    if (tolerances == NULL) {
        complain("compare_mirrors: no memory for %dx%d pixels", width, height);
    } else if (scene3d_open(argv[1], width, height, &scene) == 0 &&
               image_load(argv[4], &found) == 0 && image_create(width, height, &expected) == 0) {
        if (found.width == width && found.height == height) {
            const Camera camera = camera_from_view(scene.view, width, height);
            const OracleMirrorRules right = {0};
            oracle3d_draw_mirrors(&scene, &camera, n_bounces, &right, &expected, tolerances);
            status = compare(&found, &expected, tolerances, tolerance) > 0;
        } else {
            complain("compare_mirrors: %s: found %dx%d, expected %s", argv[4], found.width,
                     found.height, argv[2]);
        }
    }
    free(tolerances);
    image_free(&expected);
    image_free(&found);
    scene3d_free(&scene);
    return status;
}

// The random scene (scene2d_random() of scene2d.h).
//
// Everything is drawn as a whole number and divided once, which rounds the same on every machine.
// Read next: random.h.
#include "random.h"
#include "scene2d.h"

#include <math.h>

#define DEPTH_STEPS 4096   // depths are k / 4096, below 1
#define DARKEST_COLOUR 48  // of 255: circles stand out from the black background
#define BRIGHTEST_COLOUR 255

static float random_in_pixels(Random *random, int64_t lowest_step, int64_t highest_step)
{
    return (float)random_integer(random, lowest_step, highest_step) / SCENE2D_STEPS_PER_PIXEL;
}

static float random_colour(Random *random)
{
    return (float)random_integer(random, DARKEST_COLOUR, BRIGHTEST_COLOUR) / BRIGHTEST_COLOUR;
}

int scene2d_random(int n_circles, uint64_t seed, float min_radius, float max_radius, int width,
                   int height, Scene2D *scene)
{
    if (scene2d_create(n_circles, width, height, scene) != 0) {
        return -1;
    }
    Random random = {seed};
    int64_t min_steps = llroundf(min_radius * SCENE2D_STEPS_PER_PIXEL);
    int64_t max_steps = llroundf(max_radius * SCENE2D_STEPS_PER_PIXEL);
    for (int i = 0; i < n_circles; i++) {
        Circle *circle = &scene->circles[i];
        circle->x = random_in_pixels(&random, 0, (int64_t)width * SCENE2D_STEPS_PER_PIXEL);
        circle->y = random_in_pixels(&random, 0, (int64_t)height * SCENE2D_STEPS_PER_PIXEL);
        circle->radius = random_in_pixels(&random, min_steps, max_steps);
        circle->depth = (float)random_integer(&random, 0, DEPTH_STEPS - 1) / DEPTH_STEPS;
        circle->r = random_colour(&random);
        circle->g = random_colour(&random);
        circle->b = random_colour(&random);
        circle->a = 1;
    }
    return 0;
}

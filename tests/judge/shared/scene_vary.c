// Rolling scenes with a name anew for each seed (see scene_vary.h).
#include "scene_vary.h"

#include "random3d.h"
#include "scene2d_edge_cases.h"

#include <assert.h>
#include <string.h>

int side_vary(Random *random, int n)
{
    return n - 2 * (int)random_integer(random, 0, n / 12);
}

// ---- Circles ------------------------------------------------------------------------------------

static void swap_floats(float *a, float *b)
{
    const float c = *a;
    *a = *b;
    *b = c;
}

void scene2d_turn(Scene2D *scene, Random *random)
{
    const int width = scene->width, height = scene->height;
    const int mirror_x = (int)random_integer(random, 0, 1);
    const int mirror_y = (int)random_integer(random, 0, 1);
    const int transpose = (int)random_integer(random, 0, 1);
    for (int i = 0; i < scene->n_circles; i++) {
        Circle *circle = &scene->circles[i];
        // The last pixel is at width - 1, not at width.
        circle->x = mirror_x ? (float)(width - 1) - circle->x : circle->x;
        circle->y = mirror_y ? (float)(height - 1) - circle->y : circle->y;
        if (transpose) {
            swap_floats(&circle->x, &circle->y);
        }
    }
    scene->width = transpose ? height : width;
    scene->height = transpose ? width : height;
}

void scene2d_recolour(Scene2D *scene, Random *random)
{
    for (int i = 0; i < scene->n_circles; i++) {
        float *const channels[] = {&scene->circles[i].r, &scene->circles[i].g, &scene->circles[i].b,
                                   &scene->circles[i].a};
        for (size_t j = 0; j < sizeof channels / sizeof *channels; j++) {
            *channels[j] = (float)random_integer(random, 4, 16) / 16;
        }
    }
}

// Deal the circles out over the array anew, but for the first and the last, which a wrong loop
// leaves out: they stay where they can be seen. Those of one depth stay in their order.
static void shuffle_circles(Scene2D *scene, Random *random)
{
    const int n = scene->n_circles;
    Circle *circles = scene->circles, given[SCENE2D_EDGE_CASE_CIRCLES];
    char is_dealt[SCENE2D_EDGE_CASE_CIRCLES] = {0};
    assert(n <= SCENE2D_EDGE_CASE_CIRCLES);
    for (int i = 0; i < n; i++) {
        given[i] = circles[i];
    }
    for (int i = n - 2; i > 1; i--) {
        swap_floats(&circles[i].depth, &circles[random_integer(random, 1, i)].depth);
    }
    // Which depth goes where is rolled: there goes the first circle of it that is left.
    for (int i = 0; i < n; i++) {
        int from = 0;
        while (is_dealt[from] || given[from].depth != circles[i].depth) {
            from++;
        }
        is_dealt[from] = 1;
        circles[i] = given[from];
    }
}

// Other depths in the same order.
static void redraw_depths(Scene2D *scene, Random *random)
{
    float depths[SCENE2D_EDGE_CASE_CIRCLES] = {0};
    float farthest = -INFINITY, drawn = 0;
    for (int n_left = scene->n_circles; n_left > 0;) {
        // The next depth of all, and a new one behind that of the last round.
        float next = INFINITY;
        for (int i = 0; i < scene->n_circles; i++) {
            const float depth = scene->circles[i].depth;
            next = depth > farthest && depth < next ? depth : next;
        }
        drawn += (float)random_integer(random, 1, 8) / 4096;
        for (int i = 0; i < scene->n_circles; i++) {
            if (scene->circles[i].depth == next) {
                depths[i] = drawn;
                n_left--;
            }
        }
        farthest = next;
    }
    for (int i = 0; i < scene->n_circles; i++) {
        scene->circles[i].depth = depths[i];
    }
}

void scene2d_vary(Scene2D *scene, Random *random)
{
    scene2d_turn(scene, random);
    scene2d_recolour(scene, random);
    shuffle_circles(scene, random);
    redraw_depths(scene, random);
}

// ---- Spheres ------------------------------------------------------------------------------------

// All but the first and the last: see shuffle_circles().
static void shuffle_spheres(Scene3D *scene, Random *random)
{
    for (int i = scene->n_spheres - 2; i > 1; i--) {
        const int j = (int)random_integer(random, 1, i);
        const Sphere sphere = scene->spheres[i];
        const u32 material = scene->material_ids[i];
        scene->spheres[i] = scene->spheres[j];
        scene->material_ids[i] = scene->material_ids[j];
        scene->spheres[j] = sphere;
        scene->material_ids[j] = material;
    }
}

void scene3d_vary(Scene3D *scene, Random *random)
{
    shuffle_spheres(scene, random);
    for (int i = 0; i < scene->n_materials; i++) {
        scene->materials[i].color = random_vector(random, 0.25, 1);
        scene->materials[i].kd = random_number(random, 0.5, 1);
    }
    for (int i = 0; i < scene->n_lights; i++) {
        scene->lights[i].color = random_vector(random, 0.5, 0.75);
    }
    scene->view.angle *= random_number(random, 0.9375, 1);
}

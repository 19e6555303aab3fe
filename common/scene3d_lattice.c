// The lattice: equal spheres in rows, columns and layers, the kindest scene to a kd-tree.
//
// Read next: scene3d_random.c.
#include "scene3d.h"

// Of the spacing: neighbours keep a fifth of it free between them, and one looks far in.
#define RADIUS_SHARE 0.4

// The centre of the i-th of n cells that cut [-1, 1]. A whole number, divided once.
static float cell_centre(int i, int n)
{
    return (float)(2 * i + 1 - n) / (float)n;
}

int scene3d_lattice(int n_per_side, Scene3D *scene)
{
    // Past the rows, not along them: from an axis or the diagonal each sphere hides those behind.
    const Vec3 from = {3.8f, 2.1f, 1.7f};
    const Vec3 lights[] = {{5, -2, 3}, {1, 3, 6}};
    const int n_lights = sizeof lights / sizeof lights[0];
    const int n_spheres = n_per_side * n_per_side * n_per_side;
    if (scene3d_create(n_spheres, n_spheres, n_lights, from, scene) != 0) {
        return -1;
    }
    scene->background = (Vec3){0.04f, 0.06f, 0.16f};
    for (int i = 0; i < n_lights; i++) {
        scene->lights[i] = (Light){lights[i], scene3d_light_color(n_lights)};
    }

    const float radius = (float)(RADIUS_SHARE * 2 / n_per_side);
    for (int i = 0; i < n_spheres; i++) {
        float x = cell_centre(i % n_per_side, n_per_side);
        float y = cell_centre(i / n_per_side % n_per_side, n_per_side);
        float z = cell_centre(i / n_per_side / n_per_side, n_per_side);
        scene->spheres[i] = (Sphere){x, y, z, radius};
        // Colours run with the place: red along x, green along y, blue along z.
        Vec3 color = {(3 + 2 * x) / 5, (3 + 2 * y) / 5, (3 + 2 * z) / 5};
        scene->materials[i] = (Material){color, 0.8f, 0.2f, 30, 0, 1};
    }
    return 0;
}

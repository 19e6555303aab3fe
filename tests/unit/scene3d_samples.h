// Scenes that are made, and how they look from their eye, for the tests of the generators.
#ifndef UNIT_SCENE3D_SAMPLES_H
#define UNIT_SCENE3D_SAMPLES_H

#include "scene3d.h"
#include "surroundings.h"

#include <math.h>

static inline Scene3D scene_open(const char *name)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open(name, 0, 0, &scene), 0, "%s", name);
    return scene;
}

// In double, where differences of these numbers are exact.
static inline double distance_between(const Sphere *a, const Sphere *b)
{
    double dx = (double)a->x - b->x;
    double dy = (double)a->y - b->y;
    double dz = (double)a->z - b->z;
    return sqrt(dx * dx + dy * dy + dz * dz);
}

static inline double distance_from_eye(const Scene3D *scene, int i)
{
    Sphere eye = {scene->view.from.x, scene->view.from.y, scene->view.from.z, 0};
    return distance_between(&scene->spheres[i], &eye);
}

static inline double size_of(const Scene3D *scene, int i)
{
    return fabs((double)scene->spheres[i].radius);
}

static inline int is_multiple(float value, float step)
{
    return value / step == floorf(value / step);
}

// The camera's axes in double, and the ray through pixel (x, y), not of unit length.
typedef struct Axes {
    double forward[3], right[3], up[3];
} Axes;

static inline void cross_normalized(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = a[j] * b[k] - a[k] * b[j];
    }
    double length = sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    for (int i = 0; i < 3; i++) {
        result[i] /= length;
    }
}

static inline Axes axes_of(const View *view)
{
    Axes axes = {.forward = {(double)view->at.x - view->from.x, (double)view->at.y - view->from.y,
                             (double)view->at.z - view->from.z}};
    double up[3] = {view->up.x, view->up.y, view->up.z};
    double length = sqrt(axes.forward[0] * axes.forward[0] + axes.forward[1] * axes.forward[1] +
                         axes.forward[2] * axes.forward[2]);
    for (int i = 0; i < 3; i++) {
        axes.forward[i] /= length;
    }
    cross_normalized(axes.forward, up, axes.right);
    cross_normalized(axes.right, axes.forward, axes.up);
    return axes;
}

static inline void ray_towards(const Axes *axes, double spacing, double pixels_right,
                               double pixels_up, double ray[3])
{
    for (int i = 0; i < 3; i++) {
        ray[i] =
            axes->forward[i] + spacing * (pixels_right * axes->right[i] + pixels_up * axes->up[i]);
    }
}

#endif

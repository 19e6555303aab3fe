// The rays of a square of pixels on the host, and their colours: primary_ray.cl and shade.cl once
// more, so that Embree's side of the bench does the same work around the search. All that can be
// done is done in loops over all rays, which the compiler turns into vectors: lab 10 works so, too.
//
// Used by embree_peer.c, which compiles them once for each size of square: hence a header.
#ifndef BENCH_SQUARE_RAYS_H
#define BENCH_SQUARE_RAYS_H

#include "camera_from_view.h"
#include "embree_peer.h"
#include "image.h"
#include "scene3d.h"

#include <math.h>

// The largest square.
enum { LARGEST_SIDE = 8, MAX_SQUARE = LARGEST_SIDE * LARGEST_SIDE };

typedef struct Square {
    int width, height;  // pixels
} Square;

// ---- Rays -----------------------------------------------------------------------------------

// The rays of a square of pixels, row by row: an array for each number.
typedef struct Rays {
    f32 x[MAX_SQUARE], y[MAX_SQUARE], z[MAX_SQUARE];  // directions, of length 1
    f32 t[MAX_SQUARE];                                // of the first hit
    u32 ids[MAX_SQUARE];                              // of the sphere hit, or NO_SPHERE
} Rays;

// primary_ray() of lab 04, for each pixel of the square with its first one at (x, y).
static inline void rays_create(const Camera *camera, int x, int y, Square square,
                               const Image *image, Rays *rays)
{
    const f32 width = (f32)image->width, height = (f32)image->height;
    const f32 pixel_size = camera->fov / width;
    for (int i = 0; i < square.width * square.height; i++) {
        const f32 column = (f32)(x + i % square.width), row = (f32)(y + i / square.width);
        const f32 right = (column + 0.5f - 0.5f * width) * pixel_size;
        const f32 up = (0.5f * height - (row + 0.5f)) * pixel_size;
        const f32 to_x = camera->right.x * right + camera->up.x * up + camera->forward.x;
        const f32 to_y = camera->right.y * right + camera->up.y * up + camera->forward.y;
        const f32 to_z = camera->right.z * right + camera->up.z * up + camera->forward.z;
        const f32 scale = 1 / sqrtf(to_x * to_x + to_y * to_y + to_z * to_z);
        rays->x[i] = to_x * scale;
        rays->y[i] = to_y * scale;
        rays->z[i] = to_z * scale;
    }
}

// ---- Colours --------------------------------------------------------------------------------

// Points hit, normals towards the eye, and what the materials give back of light.
typedef struct Surface {
    f32 x[MAX_SQUARE], y[MAX_SQUARE], z[MAX_SQUARE];
    f32 normal_x[MAX_SQUARE], normal_y[MAX_SQUARE], normal_z[MAX_SQUARE];
    f32 red[MAX_SQUARE], green[MAX_SQUARE], blue[MAX_SQUARE];
} Surface;

// Rays that hit nothing get the surface of sphere 0, whose colour is not looked at.
static inline void surface_create(const Scene3D *scene, Vec3 eye, const Rays *rays, int n,
                                  Surface *surface)
{
    f32 center_x[MAX_SQUARE], center_y[MAX_SQUARE], center_z[MAX_SQUARE], t[MAX_SQUARE];
    for (int i = 0; i < n; i++) {
        const u32 id = rays->ids[i] == NO_SPHERE ? 0 : rays->ids[i];
        const Sphere sphere = scene->spheres[id];
        const Material material = scene->materials[scene->material_ids[id]];
        center_x[i] = sphere.x;
        center_y[i] = sphere.y;
        center_z[i] = sphere.z;
        t[i] = rays->ids[i] == NO_SPHERE ? 0 : rays->t[i];
        surface->red[i] = material.kd * material.color.x;
        surface->green[i] = material.kd * material.color.y;
        surface->blue[i] = material.kd * material.color.z;
    }
    for (int i = 0; i < n; i++) {
        surface->x[i] = eye.x + rays->x[i] * t[i];
        surface->y[i] = eye.y + rays->y[i] * t[i];
        surface->z[i] = eye.z + rays->z[i] * t[i];
        const f32 to_x = surface->x[i] - center_x[i];
        const f32 to_y = surface->y[i] - center_y[i];
        const f32 to_z = surface->z[i] - center_z[i];
        const f32 length = sqrtf(to_x * to_x + to_y * to_y + to_z * to_z);
        const f32 away = to_x * rays->x[i] + to_y * rays->y[i] + to_z * rays->z[i];
        const f32 scale = (away > 0 ? -1.0f : 1.0f) / length;
        surface->normal_x[i] = to_x * scale;
        surface->normal_y[i] = to_y * scale;
        surface->normal_z[i] = to_z * scale;
    }
}

// The colours of n rays: hit_color() of lab 05, and the background where nothing is hit.
static inline void colors_create(const Scene3D *scene, Vec3 eye, const Rays *rays, int n,
                                 f32 colors[3][MAX_SQUARE])
{
    const Vec3 background = scene->background;
    int n_hits = 0;
    for (int i = 0; i < n; i++) {
        n_hits += rays->ids[i] != NO_SPHERE;
        colors[0][i] = colors[1][i] = colors[2][i] = 0;
    }
    Surface surface;
    if (n_hits > 0) {
        surface_create(scene, eye, rays, n, &surface);
    }
    for (int j = 0; j < scene->n_lights && n_hits > 0; j++) {
        const Light light = scene->lights[j];
        for (int i = 0; i < n; i++) {
            const f32 to_x = light.position.x - surface.x[i];
            const f32 to_y = light.position.y - surface.y[i];
            const f32 to_z = light.position.z - surface.z[i];
            const f32 length = sqrtf(to_x * to_x + to_y * to_y + to_z * to_z);
            const f32 cosine = (to_x * surface.normal_x[i] + to_y * surface.normal_y[i] +
                                to_z * surface.normal_z[i]) /
                               length;
            const f32 lit = cosine > 0 ? cosine : 0;
            colors[0][i] += surface.red[i] * lit * light.color.x;
            colors[1][i] += surface.green[i] * lit * light.color.y;
            colors[2][i] += surface.blue[i] * lit * light.color.z;
        }
    }
    for (int i = 0; i < n; i++) {
        const int is_hit = rays->ids[i] != NO_SPHERE;
        colors[0][i] = is_hit ? colors[0][i] : background.x;
        colors[1][i] = is_hit ? colors[1][i] : background.y;
        colors[2][i] = is_hit ? colors[2][i] : background.z;
    }
}

#endif

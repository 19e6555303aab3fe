// 3D scenes: spheres, what they look like, lights and the view, from a file or from a generator.
// Space is right-handed. SCENES.md lists all scenes.
//
// A lab calls scene3d_open(), scene3d_free() and scene3d_fov(); what is below is for what makes or
// reads scenes. Read next: a 3D lab's main.c.
#ifndef COMMON_SCENE3D_H
#define COMMON_SCENE3D_H

#include "shading.h"
#include "sphere.h"

#include <stdint.h>
#include <stdio.h>

// Where one looks from, as NFF has it. A scene that was opened has a view that works: `at` is not
// `from`, `up` is not zero and not parallel to the view.
typedef struct View {
    Vec3 from;   // the eye
    Vec3 at;     // a point in the middle of the picture
    Vec3 up;     // which way is up; need not be at right angles to the view
    f32 angle;   // degrees, from the centre of the top row to the centre of the bottom row
    f32 hither;  // near plane's distance: read, not used in this course
} View;

typedef struct Scene3D {
    Sphere *spheres;      // [n_spheres], NULL when there is none
    u32 *material_ids;    // [n_spheres], what each sphere is made of: an index into materials
    Material *materials;  // [n_materials]
    Light *lights;        // [n_lights]
    int n_spheres;
    int n_materials;
    int n_lights;
    Vec3 background;  // the colour of a ray that hits nothing
    View view;
    int width;  // the picture it is made for, pixels
    int height;
} Scene3D;

// Load or generate the scene that `name` stands for (SCENES.md): "sphereflake:size=3", "a.nff".
//   width, height   the picture's size; 0, 0 when the user gave none: the scene then chooses
// A scene without a light gets one at the eye. Returns 0, or -1 after one message on stderr that
// names the file and line or the argument, what was found and what was expected. Release with
// scene3d_free().
int scene3d_open(const char *name, int width, int height, Scene3D *scene);

// Release what the scene holds; a zeroed Scene3D is fine.
void scene3d_free(Scene3D *scene);

// The display's width over its distance from the eye, for a picture of this size (Camera's fov).
// The rows' centres span view.angle; pixels are squares.
f32 scene3d_fov(const View *view, int width, int height);

// ---- For what makes or reads a scene ------------------------------------------------------------

// Every name of a scene but the edge cases', for messages.
#define SCENE3D_NAMES                                                                              \
    "FILE.nff, FILE.pdb, FILE.xyz, sphereflake[:size=N], random[:n=N,seed=S,min=R,max=R], "        \
    "lattice[:n=N], clusters[:n=N,seed=S], stadium[:n=N,seed=S]"

// The most spheres, materials and lights of a scene.
#define SCENE3D_MAX_SPHERES 10000000
#define SCENE3D_MAX_LIGHTS 1000

// Files hold spheres of radii from the smallest to the largest. Their centres and the eye are no
// farther from the origin along an axis than the largest. Kernels square distances in float:
// beyond, the square of one that a ray meets, up to 27 times the largest's, is infinite, or 0.
#define SCENE3D_LARGEST 1e18
#define SCENE3D_SMALLEST 1e-18

// The largest sphereflake: 5 380 840 spheres.
#define SCENE3D_MAX_FLAKE_SIZE 7

// The largest lattice: 215^3 = 9 938 375 spheres.
#define SCENE3D_MAX_LATTICE 215

// The radii a random scene can be asked for. A smaller sphere is lost in the rounding of what is
// computed about its centre, 6e-8; a larger one leaves nothing of the cube to see.
#define SCENE3D_MIN_RADIUS 0.000001
#define SCENE3D_MAX_RADIUS 1000

// The picture's size where neither --size nor the scene says one.
#define SCENE3D_DEFAULT_SIZE 512

// The same for those that are made, never a file.
int scene3d_generate(const char *name, int width, int height, Scene3D *scene);

// Make room for a scene of this many spheres, materials and lights, all zero, and give it the
// usual view: seen from `from` towards the origin, z up, 45 degrees. Sphere i is of material
// i % n_materials: its own where there are as many. Spheres need a material.
// Leaves width and height alone. Returns 0, or -1 after one message on stderr (no memory).
int scene3d_create(int n_spheres, int n_materials, int n_lights, Vec3 from, Scene3D *scene);

// The brightness of each of n lights that together are as bright as NFF has it: 1 / sqrt(n).
Vec3 scene3d_light_color(int n_lights);

// Complete a scene: a light at the eye where it has none, the size that the user gave, and a view
// that can be drawn at it.
//   made   0, or -1 where reading or making it has failed, after one message
// Returns 0, or -1 after one message; the scene is then released.
int scene3d_settle(const char *name, int width, int height, int made, Scene3D *scene);

// Is the view one that a camera can be set up from? Returns NULL, or what is wrong with it: "the
// view's direction is zero (from is at)", "up is zero", "up is parallel to the view",
// or that one of them is too short or too long for float (1e-32 to 1e32).
const char *scene3d_view_fault(const View *view);

// The smallest angle of a view, degrees, at which every pixel of a picture this high has a ray of
// its own: below, neighbours get the same direction in float. It depends on where the view looks,
// as float is finer near 0; along an axis it is all but 0.
double scene3d_smallest_angle(const View *view, int height);

// The generators. The same arguments give the same scene on every machine. They set everything but
// width and height. Return 0, or -1 after one message on stderr (no memory).
//   min_radius, max_radius   of scene3d_random(): rounded to whole steps of 2^-24.
//                            SCENE3D_MIN_RADIUS <= min_radius <= max_radius <= SCENE3D_MAX_RADIUS
int scene3d_random(int n_spheres, uint64_t seed, float min_radius, float max_radius,
                   Scene3D *scene);
int scene3d_sphereflake(int size, Scene3D *scene);
int scene3d_lattice(int n_per_side, Scene3D *scene);
int scene3d_clusters(int n_spheres, uint64_t seed, Scene3D *scene);
int scene3d_stadium(int n_spheres, uint64_t seed, Scene3D *scene);

// Radii of a random scene that does not say its own: spheres keep their share of the cube whatever
// their number.
void scene3d_default_radii(int n_spheres, float *min_radius, float *max_radius);

// The edge cases by name, or NULL for the index after the last: for help texts and tests.
const char *scene3d_edge_case(int index);

#endif

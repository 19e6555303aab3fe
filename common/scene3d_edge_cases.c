// The 3D edge cases: small scenes, each made to catch one kind of mistake.
//
// What a scene is for stands above its function. Coordinates and radii are short binary fractions:
// exact in float, and so are the places where spheres touch split planes. Read next:
// scene3d_lattice.c.
#include "scene3d_edge_cases.h"

#include "random.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

// Add a sphere; its material is the next of the twelve. A scene has room for every sphere of its
// case.
static void add_sphere(Scene3D *scene, float x, float y, float z, float radius)
{
    assert(scene->n_spheres < SCENE3D_EDGE_CASE_SPHERES);
    scene->spheres[scene->n_spheres++] = (Sphere){x, y, z, radius};
}

static void look(Scene3D *scene, Vec3 from, Vec3 at)
{
    scene->view.from = from;
    scene->view.at = at;
}

// The eye inside a sphere: every ray ends on its far side, so a solution that knows only the
// nearer root, or drops a sphere when that is behind the eye, has holes. Spheres in the room hide
// the wall, some stand half in it, those outside are never seen. Two have negative radii: they are
// seen from inside only, and a box from x - radius to x + radius would be inside out.
static void place_inside(Scene3D *scene)
{
    look(scene, (Vec3){-2, 0.5f, 0.25f}, (Vec3){4, 0, 0});
    add_sphere(scene, 0, 0, 0, 9);
    add_sphere(scene, 0, 0, 0, -12);    // behind the wall
    add_sphere(scene, 2, 1.5f, 1, -1);  // one looks through its near side onto its far side
    add_sphere(scene, 2.25f, 1.5f, 1, 0.25f);
    for (int i = 0; i < 27; i++) {
        float x = (float)(i / 9 * 3 - 1);
        float y = (float)(i / 3 % 3 * 2 - 2);
        float z = (float)(i % 3 * 2 - 2) - 0.25f;
        add_sphere(scene, x, y, z, 0.25f);
    }
    for (int i = 0; i < 9; i++) {
        float y = (float)(i / 3 * 3 - 3);
        float z = (float)(i % 3 * 3 - 3);
        add_sphere(scene, 8, y, z, 0.75f);   // half in the wall, or nearly
        add_sphere(scene, 14, y, z, 1.25f);  // outside
    }
}

// Everything lies on split planes. The spheres reach to the sides of the box [-1, 1]^3 exactly, so
// halving it gives planes at 0, 1/2, 1/4, ... Spheres are centred on them or touch them, from
// either side; the eye lies on three at once, and in a picture of odd size the middle column and
// row have rays within a plane: (plane - origin) / direction is then 0 / 0. `<` for `<=`, a NaN
// taken for a distance, and a near side chosen by the origin alone lose spheres here.
static void place_planes(Scene3D *scene)
{
    look(scene, (Vec3){0.5f, 0, 0}, (Vec3){-1, 0, 0});
    // Not 90: rays would then graze spheres exactly where these touch a plane, and rounding would
    // decide about pixels.
    scene->view.angle = 80;
    for (int corner = 0; corner < 8; corner++) {
        add_sphere(scene, corner & 1 ? 0.875f : -0.875f, corner & 2 ? 0.875f : -0.875f,
                   corner & 4 ? 0.875f : -0.875f, 0.125f);
    }
    for (int i = 0; i < 27; i++) {
        float x = (float)(i % 3 - 1) / 2;
        float y = (float)(i / 3 % 3 - 1) / 2;
        float z = (float)(i / 9 - 1) / 2;
        if (x != 0.5f || y != 0 || z != 0) {  // the eye's place
            add_sphere(scene, x, y, z, 0.125f);
        }
    }
    // Spheres that touch the planes at -1/2, 0 and 1/2 of an axis from below and from above. On the
    // other two axes they are centred on planes at 1/4.
    for (int i = 0; i < 3 * 3 * 2 * 4; i++) {
        const int axis = i % 3;
        float plane = (float)(i / 3 % 3 - 1) / 2;
        float centre[3];
        centre[axis] = plane + (i / 9 % 2 ? 0.0625f : -0.0625f);
        centre[(axis + 1) % 3] = i / 18 % 2 ? 0.25f : -0.25f;
        centre[(axis + 2) % 3] = i / 36 ? 0.25f : -0.25f;
        add_sphere(scene, centre[0], centre[1], centre[2], 0.0625f);
    }
}

// All spheres but one in a corner some 1/1500 as wide as the box: halving must go some 30 levels
// deep before it separates any, and most of the other children are empty.
static void place_one_cell(Scene3D *scene)
{
    const float step = 1.0f / (1 << 16);
    look(scene, (Vec3){1 + 256 * step, 1 + 192 * step, 1 + 160 * step},
         (Vec3){1 - 64 * step, 1 - 64 * step, 1 - 64 * step});
    add_sphere(scene, -1.75f, -1, -0.75f, 0.5f);  // behind the others, in the picture
    Random random = {5};
    for (int i = 0; i < 250; i++) {
        float x = 1 - (float)random_integer(&random, 0, 128) * step;
        float y = 1 - (float)random_integer(&random, 0, 128) * step;
        float z = 1 - (float)random_integer(&random, 0, 128) * step;
        add_sphere(scene, x, y, z, (float)random_integer(&random, 2, 10) * step);
    }
}

// One sphere: the tree is a leaf, or splits it again and again.
static void place_one(Scene3D *scene)
{
    add_sphere(scene, 0, 0, 0, 1);
}

// No sphere at all: every pixel is background, the scene's box is empty, buffers have no entry.
static void place_none(Scene3D *scene)
{
    (void)scene;
}

// Spheres at one place, which no plane separates: a builder that splits until leaves are small
// never ends. Where the radii are equal too, the lowest index is seen; where they differ, the
// largest sphere; in the third place four spheres of each radius.
static void place_coincident(Scene3D *scene)
{
    for (int i = 0; i < 64; i++) {
        add_sphere(scene, 0, -1, 0, 0.5f);
    }
    for (int i = 0; i < 64; i++) {
        add_sphere(scene, 0, 1, 0, (float)(i * 27 % 64 + 1) / 128);  // in no order
    }
    for (int i = 0; i < 64; i++) {
        add_sphere(scene, 0, 0, 1, (float)(i * 27 % 16 + 1) / 32);
    }
}

// Radii from 1/128 to 100: a large sphere reaches into most leaves, and spheres a pixel wide lie on
// it. Intersections that subtract large squares from each other lose the small ones' edges.
static void place_large_small(Scene3D *scene)
{
    add_sphere(scene, 0, 0, -101, 100);    // the ground, up to z = -1
    add_sphere(scene, -60, -45, 10, 40);   // far behind
    add_sphere(scene, 0, 0, -0.5f, 0.5f);  // of usual size, in the middle
    for (int i = 0; i < 16 * 16; i++) {
        float radius = 1.0f / (float)(16 << i % 4);
        float x = (float)(i % 16 * 2 - 15) / 8;
        float y = (float)(i / 16 * 2 - 15) / 8;
        add_sphere(scene, x, y, (float)(i / 4 % 4) / 4 - 0.75f, radius);
    }
}

// The eye in the midst: spheres on all sides, also straight behind, none around it. Whoever forgets
// that t must be positive sees those behind, upside down and nearer than those in front.
static void place_behind(Scene3D *scene)
{
    look(scene, (Vec3){0, 0, 0}, (Vec3){4, 0.5f, 0.25f});
    for (int i = 0; i < 27; i++) {
        if (i == 13) {  // the eye's place
            continue;
        }
        float x = (float)(i % 3 - 1);
        float y = (float)(i / 3 % 3 - 1);
        float z = (float)(i / 9 - 1);
        add_sphere(scene, 4 * x, 4 * y, 4 * z, 0.75f);
        add_sphere(scene, 8 * x, 3 * y, 3 * z, 0.5f);
    }
    for (int i = 0; i < 9; i++) {  // near behind the eye: nearer than all in front
        float y = (float)(i % 3 - 1) / 4;
        float z = (float)(i / 3 - 1) / 4;
        add_sphere(scene, -1, y, z, 0.125f);
    }
}

const Scene3DEdgeCase SCENE3D_EDGE_CASES[] = {
    {"inside", place_inside, 0, 0},
    {"planes", place_planes, 65, 49},
    {"one-cell", place_one_cell, 0, 0},
    {"one", place_one, 0, 0},
    {"none", place_none, 0, 0},
    {"coincident", place_coincident, 0, 0},
    {"large-small", place_large_small, 0, 0},
    {"behind", place_behind, 0, 0},
    {NULL, NULL, 0, 0},
};

int scene3d_edge_case_open(const Scene3DEdgeCase *edge_case, Scene3D *scene)
{
    static const Vec3 COLORS[] = {
        {0.90f, 0.10f, 0.10f}, {0.10f, 0.60f, 0.10f}, {0.15f, 0.35f, 0.95f}, {1.00f, 0.85f, 0.10f},
        {0.95f, 0.95f, 0.95f}, {0.80f, 0.20f, 0.80f}, {0.10f, 0.80f, 0.80f}, {1.00f, 0.50f, 0.05f},
        {0.55f, 0.35f, 0.20f}, {0.60f, 0.85f, 0.30f}, {0.95f, 0.60f, 0.75f}, {0.50f, 0.50f, 0.60f},
    };
    const int n_colors = sizeof COLORS / sizeof COLORS[0];
    const Vec3 usual_eye = {4, 2.5f, 2};
    if (scene3d_create(SCENE3D_EDGE_CASE_SPHERES, n_colors, 2, usual_eye, scene) != 0) {
        return -1;
    }
    scene->background = (Vec3){0.05f, 0.08f, 0.2f};
    scene->lights[0] = (Light){{5, -3, 6}, scene3d_light_color(2)};
    scene->lights[1] = (Light){{2, 6, 3}, scene3d_light_color(2)};
    for (int i = 0; i < n_colors; i++) {
        scene->materials[i] = (Material){COLORS[i], 0.8f, 0.2f, 30, 0, 1};
    }
    scene->n_spheres = 0;
    edge_case->place(scene);
    if (scene->n_spheres == 0) {
        free(scene->spheres);
        free(scene->material_ids);
        scene->spheres = NULL;
        scene->material_ids = NULL;
    }
    if (edge_case->width > 0) {
        scene->width = edge_case->width;
        scene->height = edge_case->height;
    }
    return 0;
}

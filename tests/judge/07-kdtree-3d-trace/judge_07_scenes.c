// The scenes of lab 07's job: twenty random ones, the edge cases, and a sphereflake.
#include "judge_07.h"

#include "job_scene3d_tree.h"

#include <float.h>
#include <math.h>
#include <string.h>

// Where the eye is.
typedef enum EyePlace { EYE_OUTSIDE, EYE_INSIDE_BOX, EYE_INSIDE_SPHERE } EyePlace;

// A random scene: how many spheres of which radii, in which picture, through which tree, seen from
// where; every nth sphere is seen from inside only.
typedef struct RandomPlan {
    int n_spheres;
    float min_radius, max_radius;
    int width, height;
    KdTreeLimits limits;
    EyePlace eye;
    int every_negative;
} RandomPlan;

static const RandomPlan plans[N_RANDOM] = {
    // Few levels first: a message is then short to follow.
    {20, 0.125f, 0.375f, 48, 32, {1, 1}, EYE_OUTSIDE, 0},
    {20, 0.125f, 0.375f, 48, 32, {2, 1}, EYE_OUTSIDE, 0},
    {40, 0.125f, 0.25f, 48, 36, {3, 2}, EYE_OUTSIDE, 0},
    {40, 0.125f, 0.25f, 49, 37, {5, 1}, EYE_INSIDE_BOX, 0},
    {100, 0.0625f, 0.1875f, 64, 48, {8, 3}, EYE_OUTSIDE, 0},
    {100, 0.0625f, 0.25f, 64, 48, {8, 3}, EYE_INSIDE_BOX, 0},
    {200, 0.03125f, 0.125f, 64, 48, {12, 4}, EYE_OUTSIDE, 0},
    {200, 0.03125f, 0.125f, 64, 48, {12, 4}, EYE_INSIDE_BOX, 0},
    {60, 0.125f, 0.5f, 48, 36, {9, 1}, EYE_INSIDE_SPHERE, 0},
    {60, 0.25f, 0.75f, 48, 36, {6, 2}, EYE_INSIDE_SPHERE, 5},
    {80, 0.0625f, 0.375f, 49, 33, {10, 2}, EYE_OUTSIDE, 3},
    {80, 0.0625f, 0.25f, 33, 49, {10, 1}, EYE_INSIDE_BOX, 4},
    {400, 0.015625f, 0.0625f, 64, 48, {15, 2}, EYE_OUTSIDE, 0},
    {400, 0.015625f, 0.125f, 56, 40, {13, 2}, EYE_INSIDE_BOX, 0},
    {600, 0.015625f, 0.0625f, 64, 48, {18, 1}, EYE_OUTSIDE, 0},
    {300, 0.0078125f, 0.25f, 56, 40, {14, 6}, EYE_OUTSIDE, 0},
    {30, 0.5f, 1, 48, 32, {4, 1}, EYE_OUTSIDE, 0},
    {150, 0.0625f, 0.125f, 48, 36, {7, 1}, EYE_INSIDE_BOX, 7},
    {2, 0.25f, 0.5f, 48, 32, {6, 1}, EYE_OUTSIDE, 0},
    {1500, 0.015625f, 0.0625f, 96, 64, {17, 6}, EYE_OUTSIDE, 0},
};

// Move the eye into the box, or into one of the spheres.
static void move_eye(Random *random, JobScene3D *scene, EyePlace place)
{
    Scene3D *s = &scene->scene;
    const Sphere around = s->spheres[random_integer(random, 0, s->n_spheres - 1)];
    const int is_inside = place == EYE_INSIDE_SPHERE;
    const Vec3 middle = {is_inside ? around.x : 0, is_inside ? around.y : 0,
                         is_inside ? around.z : 0};
    // From a sphere's centre to half way to its surface: three parts of at most r / 4 each.
    const float reach = is_inside ? fabsf(around.radius) / 4 : 0.75f;
    do {
        const float step = reach / 64;
        s->view.from.x = middle.x + step * (float)random_integer(random, -64, 64);
        s->view.from.y = middle.y + step * (float)random_integer(random, -64, 64);
        s->view.from.z = middle.z + step * (float)random_integer(random, -64, 64);
        s->view.angle = 90;  // most of what is around
    } while (scene3d_view_fault(&s->view) != NULL);
    job_scene3d_aim(scene);
}

static int roll_random(Random *random, const RandomPlan *plan, JobScene3D *scene)
{
    if (job_scene3d_random(scene, random, plan->n_spheres, plan->min_radius, plan->max_radius,
                           plan->width, plan->height) != 0) {
        return -1;
    }
    for (int i = 0; plan->every_negative > 0 && i < plan->n_spheres; i += plan->every_negative) {
        scene->scene.spheres[i].radius *= -1;
    }
    if (plan->eye != EYE_OUTSIDE) {
        move_eye(random, scene, plan->eye);
    }
    return job_scene3d_grow_tree(scene, plan->limits);
}

static const struct {
    const char *name;
    int width, height;
    KdTreeLimits limits;
} edges[N_NAMED] = {
    {"inside", 48, 36, {9, 2}},       {"planes", 65, 49, {10, 2}}, {"one-cell", 48, 36, {36, 4}},
    {"one", 48, 36, {9, 1}},          {"none", 16, 16, {9, 1}},    {"coincident", 48, 36, {9, 4}},
    {"large-small", 64, 48, {12, 4}}, {"behind", 48, 36, {12, 1}}, {"lattice:n=4", 64, 48, {10, 1}},
};

// A tree as deep as one may be, and rays that leave a child waiting at nearly every node: the eye
// is in the lowest corner, among spheres at one place that only the limits keep from being halved
// for ever, and looks at spheres around the opposite corner, which come from the stack last.
static int roll_deep(Random *random, JobScene3D *scene)
{
    enum { N_AT_ONE_PLACE = 10, N_SPHERES = 16 };
    const float side = 4;
    // With 40 halvings in turn on three axes, the last cell's sides are at least side / 2^14.
    const float radius = side / (1 << 18);
    if (job_scene3d_random(scene, random, N_SPHERES, 0.25f, 0.5f, 48, 36) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scene \"deep\", 48x36");
    Scene3D *s = &scene->scene;
    for (int i = 0; i < N_SPHERES; i++) {
        Sphere *sphere = &s->spheres[i];
        if (i < N_AT_ONE_PLACE) {
            *sphere = (Sphere){-1 + radius, -1 + radius, -1 + radius, radius};
        } else {
            // From -1 to 1 in each direction; now within 0.5 of (2, 2, 2).
            sphere->x = 2 + sphere->x / 2;
            sphere->y = 2 + sphere->y / 2;
            sphere->z = 2 + sphere->z / 2;
        }
    }
    // Just before them: outside of them by a radius or more, and inside of the last cell.
    s->view.from = (Vec3){-1 + 4 * radius, -1 + 5 * radius, -1 + 6 * radius};
    s->view.at = (Vec3){2, 2, 2};
    s->view.up = (Vec3){0, 0, 1};
    s->view.angle = 40;
    job_scene3d_aim(scene);
    return job_scene3d_grow_tree(scene, (KdTreeLimits){TODO_SIZE + 1, N_AT_ONE_PLACE - 1});
}

// From inside a large sphere one looks exactly at where it touches the scene's box, through so
// narrow an angle that the sphere is the box's side for float: its hits lie before or behind t_max,
// as rounding has it. Who throws away a hit for lying outside the node has pinholes.
static int roll_touching(Random *random, JobScene3D *scene)
{
    const float radius = 100;
    if (job_scene3d_random(scene, random, 2, 0.25f, 0.5f, 48, 36) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scene \"touching\", 48x36");
    Scene3D *s = &scene->scene;
    s->spheres[0] = (Sphere){0, 0, 0, radius};
    s->spheres[1] = (Sphere){radius / 2, radius / 2, radius / 2, 1};
    s->view.from.x = random_grid(random, 20, 40);
    s->view.from.y = random_grid(random, 1, 3);
    s->view.from.z = random_grid(random, 1, 3);
    s->view.at = (Vec3){-radius, 0, 0};
    s->view.up = (Vec3){0, 0, 1};
    s->view.angle = 0.02f;
    job_scene3d_aim(scene);
    return job_scene3d_grow_tree(scene, (KdTreeLimits){3, 1});
}

// One ray, which hits spheres 0 and 1 at a distance that is the same in float, and is just t_max of
// the near leaf: the plane lies there. Sphere 1 touches the plane and is in both leaves, sphere 0
// is a hair smaller and in the far one only. Sphere 2 makes the root's cell symmetrical.
static int roll_tie(Random *random, JobScene3D *scene)
{
    if (job_scene3d_random(scene, random, 3, 0.25f, 0.5f, 1, 1) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scene \"tie\", 1x1");
    Scene3D *s = &scene->scene;
    s->spheres[0] = (Sphere){0, 1, 0, 1 - FLT_EPSILON / 2};
    s->spheres[1] = (Sphere){0, 1, 0, 1};
    s->spheres[2] = (Sphere){0.5f, -1.5f, 0.5f, 0.5f};
    // Nothing that follows may depend on which of the two is drawn.
    s->material_ids[1] = s->material_ids[0];
    s->view.from = (Vec3){0, -1000, 0};
    s->view.at = (Vec3){0, 0, 0};
    s->view.up = (Vec3){0, 0, 1};
    s->view.angle = 45;
    job_scene3d_aim(scene);
    return job_scene3d_grow_tree(scene, (KdTreeLimits){2, 1});
}

// From far away, and through so narrow an angle that it is flat, one looks at the tip of a sphere
// just behind a plane, which only the far leaf lists. Its hits lie behind t_split or before it, as
// rounding has it. Who throws away a hit for lying before the node's part has pinholes.
static int roll_tip(Random *random, JobScene3D *scene)
{
    const float radius = 64, gap = 0x1p-17f, end = 2 * radius + gap;
    if (job_scene3d_random(scene, random, 2, 0.25f, 0.5f, 24, 16) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scene \"tip\", 24x16");
    Scene3D *s = &scene->scene;
    s->spheres[0] = (Sphere){0, radius + gap, 0, radius};
    // At the other end, so that the plane is at y = 0; and out of the way.
    s->spheres[1] = (Sphere){radius / 2, 1 - end, radius / 2, 1};
    s->view.from.x = random_grid(random, -400, -200);
    s->view.from.y = -900;
    s->view.from.z = random_grid(random, -400, -200);
    s->view.at = (Vec3){0, gap, 0};
    s->view.up = (Vec3){0, 0, 1};
    s->view.angle = 0.005f;
    job_scene3d_aim(scene);
    return job_scene3d_grow_tree(scene, (KdTreeLimits){2, 1});
}

static int roll_named(Random *random, JobScene3D *scene, const char *name, int width, int height,
                      KdTreeLimits limits)
{
    return job_scene3d_named(scene, random, name, width, height) != 0
               ? -1
               : job_scene3d_grow_tree(scene, limits);
}

// Add the limits to its title, and what it shows.
static int finish(JobScene3D *scene)
{
    JobPicture *picture = &scene->picture;
    const size_t n_bytes = strlen(picture->title);
    snprintf(picture->title + n_bytes, sizeof picture->title - n_bytes,
             ", maxDepth %d, leaf size %d", scene->limits.maxDepth,
             scene->limits.targetElementsPerNode);
    return job_scene3d_expect(scene);
}

int roll_scenes_07(Random *random, JobScene3D scenes[N_SCENES])
{
    int result = 0;
    for (int i = 0; i < N_RANDOM; i++) {
        result |= roll_random(random, &plans[i], &scenes[RANDOM + i]);
    }
    for (int i = 0; i < N_NAMED; i++) {
        result |= roll_named(random, &scenes[EDGES + i], edges[i].name, edges[i].width,
                             edges[i].height, edges[i].limits);
    }
    result |= roll_deep(random, &scenes[DEEP]);
    result |= roll_touching(random, &scenes[TOUCHING]);
    result |= roll_tie(random, &scenes[TIE]);
    result |= roll_tip(random, &scenes[TIP]);
    result |=
        roll_named(random, &scenes[FLAKE], "sphereflake:size=3", 96, 72, tree3d_limits(0, 0, 820));
    result |= roll_decoys_07(random, &scenes[DECOYS]);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = finish(&scenes[k]);
    }
    if (result == 0) {
        decoys_07_expect(&scenes[DECOYS]);
    }
    return result;
}

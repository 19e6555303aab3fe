// The scenes of lab 09's job: random ones, rooms of mirrors, eyes and lights in strange places.
// What is expected of them: judge_09_pictures.c, judge_09_sent.c.
#include "judge_09.h"

#include "job_scene3d_tree.h"
#include "job_sections.h"
#include "message.h"
#include "random3d.h"

#include <string.h>

// ---- Kinds of scenes ----------------------------------------------------------------------------

// Where lights stand, and the eye.
typedef enum Lights { LIGHTS_OUTSIDE, LIGHTS_AMONG, LIGHTS_IN_SPHERES } Lights;
typedef enum Eye { EYE_OUTSIDE, EYE_IN_MIRROR, EYE_IN_NEGATIVE } Eye;

// A random scene.
typedef struct RandomPlan {
    int n_spheres;
    float min_radius, max_radius;
    float min_ks, max_ks;
    Lights lights;
    Eye eye;
    KdTreeLimits limits;
    i32 max_bounces;
} RandomPlan;

// Six walls, each a sphere this large, around a room of this half width: large mirrors near to each
// other, so that errors grow little from one to the next.
#define WALL_RADIUS 5.0f
#define ROOM 2.0f

// How many mirrors the hall allows: more than anybody would take for enough.
#define HALL_BOUNCES 130

// A room with spheres in it.
typedef struct RoomPlan {
    float wall_ks, ball_ks, small_ks;
    i32 max_bounces;
} RoomPlan;

// ---- Random scenes ------------------------------------------------------------------------------

static void place_lights(Random *random, Lights place, Scene3D *s)
{
    for (int i = 0; place != LIGHTS_OUTSIDE && i < s->n_lights; i++) {
        const Sphere sphere = s->spheres[i];
        const float off = fabsf(sphere.radius) / 4;
        s->lights[i].position = place == LIGHTS_AMONG
                                    ? random_point(random, 1.25)
                                    : (Vec3){sphere.x + off, sphere.y - off, sphere.z};
    }
}

// The first sphere around the eye, which looks to the middle; the others stay where they are.
static void place_eye(Eye eye, Scene3D *s)
{
    if (eye != EYE_OUTSIDE) {
        s->view.angle = 70;
        s->spheres[0] = (Sphere){0, 0, 0, eye == EYE_IN_NEGATIVE ? -8 : 8};
    }
}

static int roll_random(Random *random, const RandomPlan *plan, MirrorScene *scene)
{
    JobScene3D *base = &scene->base;
    if (job_scene3d_random(base, random, plan->n_spheres, plan->min_radius, plan->max_radius, 48,
                           36) != 0) {
        return -1;
    }
    Scene3D *s = &base->scene;
    scene->max_bounces = plan->max_bounces;
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].ks = random_number(random, plan->min_ks, plan->max_ks);
    }
    place_lights(random, plan->lights, s);
    place_eye(plan->eye, s);
    return 0;
}

// ---- Rooms --------------------------------------------------------------------------------------

static void place_walls(Scene3D *s)
{
    for (int i = 0; i < 6; i++) {
        float middle[3] = {0, 0, 0};
        middle[i / 2] = (i % 2 ? 1 : -1) * (WALL_RADIUS + ROOM);
        s->spheres[i] = (Sphere){middle[0], middle[1], middle[2], WALL_RADIUS};
    }
}

// One mirror in the middle, small spheres around it.
static int roll_room(Random *random, const RoomPlan *plan, MirrorScene *scene)
{
    enum { N_WALLS = 6, N_SMALL = 8, N_SPHERES = N_WALLS + 1 + N_SMALL };
    JobScene3D *base = &scene->base;
    if (job_scene3d_random(base, random, N_SPHERES, 0.125f, 0.375f, 48, 36) != 0) {
        return -1;
    }
    snprintf(base->picture.title, sizeof base->picture.title, "room of mirrors, 48x36");
    Scene3D *s = &base->scene;
    scene->max_bounces = plan->max_bounces;
    place_walls(s);
    s->spheres[N_WALLS] = (Sphere){0, 0, 0, 0.5f};
    for (int i = 0; i < N_SPHERES; i++) {
        s->material_ids[i] = (u32)i;
        s->materials[i].ks = i < N_WALLS    ? plan->wall_ks
                             : i == N_WALLS ? plan->ball_ks
                                            : plan->small_ks;
    }
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].position = vec3_scaled(random_point(random, 1), 1.5f);
    }
    s->view.from = (Vec3){1.5f, 1.25f * (float)random_sign(random), 0.75f};
    s->view.at = random_point(random, 0.25);
    s->view.up = (Vec3){0, 0, 1};
    s->view.angle = 60;
    return 0;
}

// Rays to and fro between two mirrors that send all light back: the far sides of two balls, seen
// from where these overlap. They stay so near to the axis through both that z of every normal is 1
// or -1 in float: elsewhere its rounding makes directions a little longer with each mirror, and
// after some thirty of them no right solution keeps its way. The mirrors are as far apart as their
// radius: what is near to the axis stays near to it, and the oracle's bounds grow slowly.
static int roll_hall(Random *random, MirrorScene *scene)
{
    JobScene3D *base = &scene->base;
    if (job_scene3d_random(base, random, 2, 1, 1, 3, 3) != 0) {
        return -1;
    }
    snprintf(base->picture.title, sizeof base->picture.title, "between two mirrors, 3x3");
    Scene3D *s = &base->scene;
    scene->max_bounces = HALL_BOUNCES;
    const Vec3 ahead = {0, 0, (float)random_sign(random)};
    for (int i = 0; i < 2; i++) {
        s->spheres[i] = (Sphere){0, 0, i == 0 ? 4 : -4, 8};
        s->materials[s->material_ids[i]].ks = 1;
    }
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].position = random_point(random, 2);
    }
    s->view = (View){.from = {0, 0, 0}, .at = ahead, .up = {0, 1, 0}, .angle = 0x1p-8f};
    base->limits = (KdTreeLimits){5, 1};
    return 0;
}

// ---- Plans --------------------------------------------------------------------------------------

static const RandomPlan local_plans[] = {
    {24, 0.25f, 0.5f, 0.125f, 0.75f, LIGHTS_OUTSIDE, EYE_OUTSIDE, {6, 3}, 0},
    {40, 0.125f, 0.375f, 0.125f, 0.75f, LIGHTS_AMONG, EYE_OUTSIDE, {8, 2}, 0},
    {40, 0.125f, 0.5f, 0.125f, 0.75f, LIGHTS_IN_SPHERES, EYE_OUTSIDE, {8, 2}, 0},
    {24, 0.25f, 0.5f, 0.5f, 0.75f, LIGHTS_AMONG, EYE_IN_MIRROR, {7, 2}, 0},
};
static const RandomPlan mirror_plans[] = {
    {16, 0.375f, 0.75f, 0.25f, 0.75f, LIGHTS_OUTSIDE, EYE_OUTSIDE, {5, 2}, 1},
    {24, 0.25f, 0.5f, 0.25f, 0.75f, LIGHTS_AMONG, EYE_OUTSIDE, {7, 2}, 2},
    {24, 0.25f, 0.5f, 0.5f, 0.875f, LIGHTS_AMONG, EYE_IN_MIRROR, {7, 2}, 2},
};
static const RoomPlan mirror_room = {0.5f, 0.75f, 0.25f, 2};
static const RandomPlan end_plans[] = {
    {16, 0.375f, 0.75f, 1, 1, LIGHTS_OUTSIDE, EYE_OUTSIDE, {5, 2}, 2},
    {24, 0.25f, 0.5f, 0, 0, LIGHTS_OUTSIDE, EYE_OUTSIDE, {5, 2}, 5},
    {1, 1, 1, 0.75f, 0.875f, LIGHTS_OUTSIDE, EYE_IN_NEGATIVE, {5, 1}, 7},
};
// See set_least_weight().
static const RandomPlan least_plan = {12,          0.375f, 0.75f, 1, 1, LIGHTS_OUTSIDE,
                                      EYE_OUTSIDE, {5, 2}, 2};
static const RoomPlan end_rooms[] = {
    {0.75f, 0.75f, 0.25f, 3},      {0.875f, 1, 0, 4}, {1, 0, 0, 5}, {0.0625f, 0.5f, 0.5f, 5},
    {0.03125f, 0.03125f, 0.5f, 5},
};
static const RandomPlan background_plans[] = {
    {12, 0.375f, 0.75f, 0.25f, 0.75f, LIGHTS_OUTSIDE, EYE_OUTSIDE, {5, 2}, 2},
    {16, 0.25f, 0.5f, 0.25f, 0.75f, LIGHTS_OUTSIDE, EYE_OUTSIDE, {5, 2}, 3},
};

static int roll_each(Random *random, const RandomPlan *plans, int n, MirrorScene *scenes)
{
    int result = 0;
    for (int i = 0; result == 0 && i < n; i++) {
        result = roll_random(random, &plans[i], &scenes[i]);
        scenes[i].base.limits = plans[i].limits;
    }
    return result;
}

static int roll_named(Random *random, MirrorScene *scene, const char *name, i32 max_bounces)
{
    scene->max_bounces = max_bounces;
    const int result = job_scene3d_named(&scene->base, random, name, 48, 32);
    scene->base.limits = (KdTreeLimits){9, 4};
    return result;
}

static int roll_rooms(Random *random, const RoomPlan *plans, int n, MirrorScene *scenes)
{
    int result = 0;
    for (int i = 0; result == 0 && i < n; i++) {
        result = roll_room(random, &plans[i], &scenes[i]);
        scenes[i].base.limits = (KdTreeLimits){7, 3};
    }
    return result;
}

// Let the first light shine from the eye on all that is seen: where light is missing, it shows.
static void light_what_is_seen(Scene3D *s)
{
    s->lights[0].position = s->view.from;
}

// Let sphere i be seen, whatever else there is: a small one before all others.
static void show_sphere(Scene3D *s, int i)
{
    const Vec3 ahead = vec3_scaled(vec3_minus(s->view.at, s->view.from), 0.4f), eye = s->view.from;
    s->spheres[i] =
        (Sphere){eye.x + ahead.x, eye.y + ahead.y, eye.z + ahead.z, (float)vec3_length(ahead) / 8};
}

// Surfaces that scatter nothing, but for every fourth material, before a bright background.
static void empty_light(MirrorScene *scene)
{
    Scene3D *s = &scene->base.scene;
    s->background = (Vec3){0.75f, 0.5f, 0.25f};
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].kd = i % 4 == 0 ? s->materials[i].kd : 0;
    }
    for (int i = 0; i < s->n_spheres; i++) {
        if (s->material_ids[i] % 4 == 0) {
            show_sphere(s, i);
            light_what_is_seen(s);
            break;
        }
    }
}

// Mirrors of the least weight that is followed, before a background that shows in them.
static void set_least_weight(MirrorScene *scene)
{
    Scene3D *s = &scene->base.scene;
    s->background = (Vec3){64, 48, 32};
    // Surfaces are brighter than 1, too: else who cuts at 1 had the background alone wrong.
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].color = vec3_scaled(s->lights[i].color, 16);
    }
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].ks = ORACLE_LEAST_WEIGHT;
    }
}

// Surfaces that scatter a millionth of very bright light: the picture stays as it is.
static void dim_surfaces(MirrorScene *scene)
{
    Scene3D *s = &scene->base.scene;
    char *title = scene->base.picture.title;
    const size_t length = strlen(title);
    snprintf(title + length, sizeof scene->base.picture.title - length, ", kd below a millionth");
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].color = vec3_scaled(s->lights[i].color, 1 / DIM);
    }
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].kd *= DIM;
    }
}

static int roll_all(Random *random, MirrorScene scenes[N_SCENES])
{
    int result = roll_each(random, local_plans, COUNT(local_plans), scenes + LOCAL);
    result |= roll_named(random, &scenes[MIRRORS - 1], "coincident", 0);
    result |= roll_each(random, mirror_plans, COUNT(mirror_plans), scenes + MIRRORS);
    result |= roll_rooms(random, &mirror_room, 1, &scenes[ENDS - 2]);
    result |= roll_named(random, &scenes[ENDS - 1], "sphereflake:size=1", 2);
    result |= roll_each(random, end_plans, COUNT(end_plans), scenes + ENDS);
    result |= roll_rooms(random, end_rooms, COUNT(end_rooms), scenes + ENDS + COUNT(end_plans));
    result |= roll_hall(random, &scenes[BACKGROUNDS - 3]);
    result |= roll_each(random, &least_plan, 1, &scenes[BACKGROUNDS - 2]);
    result |= roll_named(random, &scenes[BACKGROUNDS - 1], "inside", 3);
    result |= roll_each(random, background_plans, COUNT(background_plans), scenes + BACKGROUNDS);
    result |= roll_named(random, &scenes[N_SCENES - 1], "none", 2);
    if (result == 0) {
        // A distance that is small elsewhere is larger than all that is here.
        job_scene3d_scale(&scenes[MIRRORS + COUNT(mirror_plans) - 1].base, 0x1p-24f,
                          "made smaller than a millionth");
        set_least_weight(&scenes[BACKGROUNDS - 2]);
        dim_surfaces(&scenes[MIRRORS + 1]);
        light_what_is_seen(&scenes[MIRRORS + 1].base.scene);
        light_what_is_seen(&scenes[LOCAL].base.scene);
    }
    return result;
}

// ---- All, with their trees ----------------------------------------------------------------------

static void add_bounces_to_title(MirrorScene *scene)
{
    char *title = scene->base.picture.title;
    const size_t length = strlen(title);
    snprintf(title + length, sizeof scene->base.picture.title - length, ", at most %d mirror%s",
             scene->max_bounces, plural((unsigned)scene->max_bounces));
}

// A tree of one leaf, and bounds that hold every eye, light and point: each ray that is sent,
// whichever way, visits this leaf once, so that leaves count rays.
static int grow_leaf(MirrorScene *scene)
{
    JobScene3D *base = &scene->base;
    const int result = job_scene3d_grow_tree(base, (KdTreeLimits){1, base->scene.n_spheres});
    base->tree.bounds = (BBox3D){{-100, -100, -100}, {100, 100, 100}};
    return result;
}

int roll_scenes_09(Random *random, MirrorScene scenes[N_SCENES])
{
    int result = roll_all(random, scenes);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        MirrorScene *scene = &scenes[k];
        if (k >= BACKGROUNDS) {
            empty_light(scene);
        }
        add_bounces_to_title(scene);
        job_scene3d_aim(&scene->base);
        result = sent_09_is_counted(k) ? grow_leaf(scene)
                                       : job_scene3d_grow_tree(&scene->base, scene->base.limits);
        result |= picture_09_expect(scene);
    }
    return result;
}

int scene_09_write(const MirrorScene *scene, int k, FILE *file)
{
    return job_scene3d_write(&scene->base, k, file) |
           job_section_write(file, k, "bounces", &scene->max_bounces, sizeof scene->max_bounces);
}

// The scenes of lab 09's job: random ones, rooms of mirrors, eyes and lights in strange places.
#include "judge_09.h"

#include "complain.h"
#include "job_sections.h"
#include "message.h"
#include "random3d.h"

#include <stdlib.h>
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

static int draw_random(Random *random, const RandomPlan *plan, MirrorScene *scene)
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
static int draw_room(Random *random, const RoomPlan *plan, MirrorScene *scene)
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

// ---- All ----------------------------------------------------------------------------------------

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

static int draw_each(Random *random, const RandomPlan *plans, int n, MirrorScene *scenes)
{
    int result = 0;
    for (int i = 0; result == 0 && i < n; i++) {
        result = draw_random(random, &plans[i], &scenes[i]);
        scenes[i].base.limits = plans[i].limits;
    }
    return result;
}

static int draw_named(Random *random, MirrorScene *scene, const char *name, i32 max_bounces)
{
    scene->max_bounces = max_bounces;
    const int result = job_scene3d_named(&scene->base, random, name, 48, 32);
    scene->base.limits = (KdTreeLimits){9, 4};
    return result;
}

static int draw_rooms(Random *random, const RoomPlan *plans, int n, MirrorScene *scenes)
{
    int result = 0;
    for (int i = 0; result == 0 && i < n; i++) {
        result = draw_room(random, &plans[i], &scenes[i]);
        scenes[i].base.limits = (KdTreeLimits){7, 3};
    }
    return result;
}

// Surfaces that scatter nothing, but for every fourth material, before a bright background.
static void empty_light(MirrorScene *scene)
{
    Scene3D *s = &scene->base.scene;
    s->background = (Vec3){0.75f, 0.5f, 0.25f};
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].kd = i % 4 == 0 ? s->materials[i].kd : 0;
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

static int draw_all(Random *random, MirrorScene scenes[N_SCENES])
{
    int result = draw_each(random, local_plans, COUNT(local_plans), scenes + LOCAL);
    result |= draw_named(random, &scenes[MIRRORS - 1], "coincident", 0);
    result |= draw_each(random, mirror_plans, COUNT(mirror_plans), scenes + MIRRORS);
    result |= draw_rooms(random, &mirror_room, 1, &scenes[ENDS - 2]);
    result |= draw_named(random, &scenes[ENDS - 1], "sphereflake:size=1", 2);
    result |= draw_each(random, end_plans, COUNT(end_plans), scenes + ENDS);
    result |= draw_rooms(random, end_rooms, COUNT(end_rooms), scenes + ENDS + COUNT(end_plans));
    result |= draw_each(random, &least_plan, 1, &scenes[BACKGROUNDS - 2]);
    result |= draw_named(random, &scenes[BACKGROUNDS - 1], "inside", 3);
    result |= draw_each(random, background_plans, COUNT(background_plans), scenes + BACKGROUNDS);
    result |= draw_named(random, &scenes[N_SCENES - 1], "none", 2);
    if (result == 0) {
        // A distance that is small elsewhere is larger than all that is here.
        job_scene3d_scale(&scenes[MIRRORS + COUNT(mirror_plans) - 1].base, 0x1p-24f,
                          "made smaller than a millionth");
        set_least_weight(&scenes[BACKGROUNDS - 2]);
    }
    return result;
}

// ---- What is expected ---------------------------------------------------------------------------

// A mistake made by the oracle.
typedef struct Mistake09 {
    Cause looks;
    OracleMirrorRules rules;
} Mistake09;

#define LESS_FOLLOWED                                                                              \
    "drawn as if the end were above LEAST_WEIGHT: light that counts a little more is followed, "   \
    "too"

static const Mistake09 mistakes[] = {
    {{.says = "drawn without shadows: light is added although something stands between"},
     {.no_shadows = 1}},
    {{.says = "drawn with light where something stands between, and not where nothing does"},
     {.only_shadows = 1}},
    {{.says = "drawn as if what stands behind a light cast a shadow: the ray ends at the light"},
     {.endless_light = 1}},
    {{.says = "lit by the first light only"}, {.first_light_only = 1}},
    {{.says = "drawn as if one light that does not arrive took the others with it"},
     {.one_dark_all_dark = 1}},
    {{.says = "drawn with one mirror more than allowed"}, {.more_bounces = 1}},
    {{.says = "drawn with one mirror less than allowed"}, {.more_bounces = -1}},
    {{.says = "drawn with five mirrors at most: max_bounces may be more"}, {.most_bounces = 5}},
    {{.says = "drawn as if a mirror that no light reaches were the end: it mirrors all the same"},
     {.dark_ends = 1}},
    {{.says = "drawn without the cut-off: light was followed that counts less than LEAST_WEIGHT"},
     {.no_cut_off = 1}},
    // Where weights are just the least both look the same: a larger end shows in scenes before.
    {{.says = "drawn as if a weight of LEAST_WEIGHT itself were the end: it goes on"},
     {.least_ends = 1}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 1.0 / 255}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 0.01}},
    {{.says = LESS_FOLLOWED}, {.least_weight = 0.1}},
    {{.says = "drawn as if mirrored rays hit nothing near: they start at the surface's point, and "
              "t_min stays as it is"},
     {.mirrors_see_nothing = 1}},
    {{.says = "drawn as if the background counted in full, also over mirrors"},
     {.background_unweighted = 1}},
    {{.says = "drawn as if what is not followed any more were the background: the ray ends there"},
     {.rest_is_background = 1}},
    {{.says = "cut at 1: light may be brighter than that"}, {.cut_at_one = 1}},
    {{.says = "drawn as if the background were black in mirrors"}, {.background_missing = 1}},
    {{.says = "drawn without ks: all light over mirrors counts in full"}, {.weight = WEIGHT_ONE}},
    {{.says = "drawn with ks of the last mirror only: over two of them the product counts"},
     {.weight = WEIGHT_LAST_KS}},
    {{.says = "drawn with ks of the first mirror for all of them: each has its own"},
     {.weight = WEIGHT_FIRST_KS}},
    {{.says = "drawn with ks squared: each mirror counts twice"}, {.weight = WEIGHT_KS_SQUARED}},
    {{.says = "drawn with kd in the place of ks"}, {.weight = WEIGHT_KD}},
    {{.says = "drawn as if a surface's own light counted its own ks: only what comes over it does"},
     {.weight = WEIGHT_OWN_KS}},
    {{.says = "drawn as if a surface's own light counted 1 - ks: it counts in full, as NFF has it"},
     {.weight = WEIGHT_SHARED}},
    {{.says = "drawn as if only what is hit first had light of its own"},
     {.weight = WEIGHT_ONLY_FIRST}},
    {{.says = "drawn with the light of surfaces in full, also over mirrors: ks is missing there"},
     {.weight = WEIGHT_LOCAL_ONE}},
};

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    const MirrorScene *scene = pointer;
    if (mistake >= COUNT(mistakes)) {
        return (Cause){0};
    }
    oracle3d_draw_mirrors(&scene->base.scene, &scene->base.camera, scene->max_bounces,
                          &mistakes[mistake].rules, guess, tolerances);
    return mistakes[mistake].looks;
}

static int expect(MirrorScene *scene)
{
    const Scene3D *s = &scene->base.scene;
    const OracleMirrorRules right = {0};
    ExpectedPicture *expected = &scene->base.picture.expected;
    const size_t n_pixels = (size_t)s->width * (size_t)s->height;
    const Vec3 background = s->background;
    expected->tolerances = calloc(n_pixels, sizeof *expected->tolerances);
    if (expected->tolerances == NULL) {
        complain("grade: no memory for a picture");
        return -1;
    }
    if (image_create(s->width, s->height, &expected->reference) != 0) {
        return -1;
    }
    oracle3d_draw_mirrors(s, &scene->base.camera, scene->max_bounces, &right, &expected->reference,
                          expected->tolerances);
    memcpy(expected->background, (float[]){background.x, background.y, background.z, 1},
           sizeof expected->background);
    expected->draw_mistaken = draw_mistaken;
    expected->scene = scene;
    return 0;
}

static void add_bounces_to_title(MirrorScene *scene)
{
    char *title = scene->base.picture.title;
    const size_t length = strlen(title);
    snprintf(title + length, sizeof scene->base.picture.title - length, ", at most %d mirror%s",
             scene->max_bounces, plural((unsigned)scene->max_bounces));
}

int scenes_09_draw(Random *random, MirrorScene scenes[N_SCENES])
{
    int result = draw_all(random, scenes);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        MirrorScene *scene = &scenes[k];
        if (k >= BACKGROUNDS) {
            empty_light(scene);
        }
        add_bounces_to_title(scene);
        job_scene3d_aim(&scene->base);
        result = job_scene3d_grow_tree(&scene->base, scene->base.limits) | expect(scene);
    }
    return result;
}

int scene_09_write(const MirrorScene *scene, int k, FILE *file)
{
    return job_scene3d_write(&scene->base, k, file) |
           job_section_write(file, k, "bounces", &scene->max_bounces, sizeof scene->max_bounces);
}

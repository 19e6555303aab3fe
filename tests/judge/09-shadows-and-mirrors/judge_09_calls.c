// Inputs of lab 09's functions that the kernel sends for whole pictures: see judge_09.h, sent.h.
//
// Some rays are followed from the eye over a few mirrors, as double has it.
#include "judge_09.h"
#include "random3d.h"
#include "sent.h"

#include <math.h>

enum { MOST_HITS = 4 };

// Where the inputs go.
typedef struct Calls {
    Job09 *job;
    Sent starts, mirrors, shadow_rays, lits;
    i32 first_lights[N_SCENES];  // of each scene, in lit_lights
    int n_blocks;
    u32 next_id;  // of their spheres, and where it stands
} Calls;

// A hit, and where new rays start.
typedef struct HitSurface {
    Vec3 point, normal;
    const Material *material;
} HitSurface;

// ---- leaf_blocks --------------------------------------------------------------------------------

// Any leaf of the scene's tree.
static KdNode3 roll_leaf(Random *random, const KdTree3D *tree)
{
    KdNode3 node;
    do {
        node = tree->nodes[random_integer(random, 0, tree->n_nodes - 1)];
    } while (node.split_axis != KD_LEAF);
    return node;
}

// The call for a leaf and a ray, with spheres of its own: their ids and places run against each
// other, and one more before and behind them is in the way.
static void keep_block(Random *random, const JobScene3D *scene, const OracleRay *ray, float t_max,
                       Calls *calls)
{
    Job09 *job = calls->job;
    const KdNode3 leaf = roll_leaf(random, &scene->tree);
    const u32 before = calls->next_id, end = before + leaf.n_spheres + 1;
    if (calls->n_blocks == N_SENT_BLOCKS || end >= (FIRST_LONG_ID & 0xffff)) {
        return;
    }
    const OracleVector middle = vector_plus(ray->origin, vector_scaled(t_max / 2, ray->direction));
    const Vec3 guard = vector_rounded(middle);
    for (u32 at = before; at <= end; at++) {
        const u32 id = before + end - at;
        const int is_guard = at == before || at == end;
        job->block_ids[at] = id;
        job->block_spheres[id] =
            is_guard ? (Sphere){guard.x, guard.y, guard.z, t_max / 8}
                     : scene->scene.spheres[scene->tree.sphere_ids[leaf.first + at - before - 1]];
    }
    job->blocks[calls->n_blocks++] = (BlockJob){{0, KD_LEAF, before + 1, leaf.n_spheres},
                                                vector_rounded(ray->origin),
                                                vector_rounded(ray->direction),
                                                t_max};
    calls->next_id = end + 1;
}

// ---- Lights -------------------------------------------------------------------------------------

// The calls for the lights that a surface of scene k sees.
static void keep_lights(Random *random, int k, const HitSurface *at, Calls *calls)
{
    const JobScene3D *scene = &calls->job->scenes[k].base;
    const Scene3D *s = &scene->scene;
    if (s->n_lights == 0) {
        return;
    }
    const Light light = s->lights[random_integer(random, 0, s->n_lights - 1)];
    const ShadowRayJob job = {at->point, light};
    const OracleVector way = vector_minus(vector_of(light.position), vector_of(at->point));
    const LitJob lit = {.point = at->point,
                        .normal = at->normal,
                        .material = *at->material,
                        .first_light = calls->first_lights[k],
                        .n_lights = s->n_lights,
                        .bounds = calls->job->scenes[LIT_SCENE].base.tree.bounds};
    sent_keep(&calls->shadow_rays, random, &job);
    // Of which side a light is on no rounding decides.
    if (oracle3d_sides(s->lights, s->n_lights, oracle3d_exactly(at->point),
                       oracle3d_exactly(at->normal))
            .n_unsure == 0) {
        sent_keep(&calls->lits, random, &lit);
    }
    const OracleRay ray = oracle3d_given_ray(at->point, vector_rounded(vector_unit(way)), 0);
    keep_block(random, scene, &ray, (float)vector_length(way), calls);
}

// ---- Hits ---------------------------------------------------------------------------------------

// The calls for what a ray of scene k hits; *ray becomes the mirrored one. Returns 0 where it hits
// nothing, or rounding decides what.
static int keep_hit(Random *random, int k, OracleRay *ray, Calls *calls)
{
    static const OracleRules3D right = {0};
    const Scene3D *s = &calls->job->scenes[k].base.scene;
    const OracleHit hit = oracle3d_nearest(s->spheres, (u32)s->n_spheres, ray, &right);
    if (hit.sphere == ORACLE_NO_SPHERE || hit.is_ambiguous) {
        return 0;
    }
    const Sphere sphere = s->spheres[hit.sphere];
    const Vec3 direction = vector_rounded(ray->direction);
    const Vec3 point =
        vector_rounded(vector_plus(ray->origin, vector_scaled(hit.t, ray->direction)));
    const OracleNear normal =
        oracle3d_normal(sphere, oracle3d_exactly(point), oracle3d_exactly(direction), &right);
    if (isinf(normal.error)) {
        return 0;
    }
    const double off = 1.5 * oracle3d_offset(vector_of(point), hit.t, sphere.radius);
    const HitSurface at = {
        vector_rounded(vector_plus(vector_of(point), vector_scaled(off, normal.value))),
        vector_rounded(normal.value), &s->materials[s->material_ids[hit.sphere]]};
    const StartJob start = {point, at.normal, (float)hit.t, sphere.radius};
    const MirrorJob mirror = {direction, at.normal};
    sent_keep(&calls->starts, random, &start);
    sent_keep(&calls->mirrors, random, &mirror);
    keep_lights(random, k, &at, calls);
    const OracleNear turned =
        oracle3d_mirrored(oracle3d_exactly(direction), oracle3d_exactly(at.normal), TURN_RIGHT);
    *ray = oracle3d_given_ray(at.point, vector_rounded(vector_unit(turned.value)), 0);
    return 1;
}

// ---- All ----------------------------------------------------------------------------------------

// Put the scenes' lights behind those that are drawn; a job's lights go on with the next scene's,
// which must not shine.
static void add_lights(Calls *calls)
{
    i32 next = N_LIT_LIGHTS - N_SENT_LIGHTS;
    for (int k = 0; k < N_SCENES; k++) {
        const Scene3D *s = &calls->job->scenes[k].base.scene;
        calls->first_lights[k] = next;
        for (int i = 0; i < s->n_lights && next < N_LIT_LIGHTS - 1; i++) {
            calls->job->lit_lights[next++] = s->lights[i];
        }
    }
    calls->job->lit_lights[next] = calls->job->lit_lights[0];
}

void add_calls_09(Random *random, Job09 *job)
{
    enum { N_RAYS = 1200 };
    Calls calls = {.job = job,
                   .starts = SENT_TO(job->starts, N_SENT_CALLS),
                   .mirrors = SENT_TO(job->mirrors, N_SENT_CALLS),
                   .shadow_rays = SENT_TO(job->shadow_rays, N_SENT_CALLS),
                   .lits = SENT_TO(job->lits + 2 * N_LIT_INPUTS, N_SENT_LITS),
                   .next_id = N_SHORT_BLOCK_IDS};
    add_lights(&calls);
    for (int i = 0; i < N_RAYS; i++) {
        const int k = i % N_SCENES;
        const JobScene3D *scene = &job->scenes[k].base;
        const int n_pixels = scene->scene.width * scene->scene.height;
        OracleRay ray = job_scene3d_ray(scene, (int)random_integer(random, 0, n_pixels - 1));
        for (int n = 0; n < MOST_HITS && keep_hit(random, k, &ray, &calls); n++) {
        }
    }
}

// The sections of lab 09's job, and of the answers: as jobs.h has those of the others. For host and
// device.
#ifndef PROBES_JOBS_09_H
#define PROBES_JOBS_09_H

#include "jobs.h"

// Its scenes are those of lab 07, and "scene.K.bounces", an i32: how many mirrors a ray meets at
// most. Answered by "picture.K" and "work.K", as lab 07's are.

// Section "starts", one call of leave_surface each. Answered by a Vec3.
typedef struct StartJob {
    Vec3 point;
    Vec3 normal;
    f32 t;
    f32 radius;
} StartJob;
LAYOUT_ASSERT(StartJob, 32);

// Section "mirrors", one call of mirrored_direction each. Answered by a Vec3.
typedef struct MirrorJob {
    Vec3 direction;
    Vec3 normal;
} MirrorJob;
LAYOUT_ASSERT(MirrorJob, 24);

// Section "shadow_rays", one call of shadow_ray each.
typedef struct ShadowRayJob {
    Vec3 point;
    Light light;
} ShadowRayJob;
LAYOUT_ASSERT(ShadowRayJob, 36);

typedef struct ShadowRayAnswer {
    Vec3 origin;
    Vec3 direction;
    f32 t_min;
    f32 t_max;
} ShadowRayAnswer;
LAYOUT_ASSERT(ShadowRayAnswer, 32);

// Section "blocks", one call of leaf_blocks each, with the spheres of section "block_spheres" and
// the ids of section "block_ids".
typedef struct BlockJob {
    KdNode3 node;
    Vec3 origin;
    Vec3 direction;
    f32 t_max;
} BlockJob;
LAYOUT_ASSERT(BlockJob, 44);

typedef struct BlockAnswer {
    u32 is_blocked;
    u32 n_tests;  // calls of intersect_sphere
} BlockAnswer;
LAYOUT_ASSERT(BlockAnswer, 8);

// Section "lits", one call of lit_color each, with the spheres and the tree of scene LIT_SCENE. The
// lights are n_lights from first_light on in section "lit_lights"; what follows them must not
// shine.
enum { LIT_SCENE = 0 };
typedef struct LitJob {
    Vec3 point;
    Vec3 normal;
    Material material;
    i32 first_light;
    i32 n_lights;
    BBox3D bounds;  // of the tree
} LitJob;
LAYOUT_ASSERT(LitJob, 88);

typedef struct LitAnswer {
    Vec3 color;
    u32 n_leaves;  // visited for all of its lights
} LitAnswer;
LAYOUT_ASSERT(LitAnswer, 16);

#endif

// The sections of lab 07's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_07_H
#define PROBES_JOBS_07_H

#include "jobs.h"

// Section "clips", one call of clip_to_box each. The ray's own t_min and t_max are the same.
typedef struct ClipJob {
    BBox3D box;
    Vec3 origin;
    Vec3 direction;
    f32 t_min;
    f32 t_max;
} ClipJob;
LAYOUT_ASSERT(ClipJob, 56);

typedef struct ClipAnswer {
    i32 is_met;
    f32 t_min;
    f32 t_max;
} ClipAnswer;
LAYOUT_ASSERT(ClipAnswer, 12);

// Section "sides", one call of near_side each. Answered by a u32.
typedef struct SideJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;  // 1 / direction
} SideJob;
LAYOUT_ASSERT(SideJob, 24);

// Section "planes", one call of children_on_ray each.
typedef struct PlaneJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;
    f32 t_min;
    f32 t_max;
} PlaneJob;
LAYOUT_ASSERT(PlaneJob, 32);

// ONLY_NEAR, ONLY_FAR and BOTH of choose_children.cl, or none of them.
enum { PLANE_ONLY_NEAR, PLANE_ONLY_FAR, PLANE_BOTH, PLANE_UNKNOWN };

typedef struct PlaneAnswer {
    u32 children;
    f32 t_split;
} PlaneAnswer;
LAYOUT_ASSERT(PlaneAnswer, 8);

// Section "leaves", one call of search_leaf each, with the spheres of section "leaf_spheres" and
// the ids of section "leaf_ids".
typedef struct SearchJob {
    KdNode3 node;
    Vec3 origin;
    Vec3 direction;
    f32 t;  // the nearest hit so far
    u32 sphere;
} SearchJob;
LAYOUT_ASSERT(SearchJob, 48);

typedef struct SearchAnswer {
    f32 t;
    u32 sphere;
    u32 n_tests;  // calls of intersect_sphere
} SearchAnswer;
LAYOUT_ASSERT(SearchAnswer, 12);

// Section "next_child", one call of next_child each.
typedef struct NextChildJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;
    f32 t_min;
    f32 t_max;
    StackState todo;
} NextChildJob;
LAYOUT_ASSERT(NextChildJob, 88);

typedef struct NextChildAnswer {
    TodoEntry next;
    StackState todo;
} NextChildAnswer;
LAYOUT_ASSERT(NextChildAnswer, 68);

// Section "next_waiting", one call of next_waiting each.
typedef struct NextWaitingJob {
    f32 t;  // the nearest hit so far
    u32 sphere;
    TodoEntry at;
    StackState todo;
} NextWaitingJob;
LAYOUT_ASSERT(NextWaitingJob, 76);

typedef struct NextWaitingAnswer {
    i32 goes_on;
    TodoEntry at;
    StackState todo;
} NextWaitingAnswer;
LAYOUT_ASSERT(NextWaitingAnswer, 72);

#endif

// The 3D oracle for shadows and mirrors: what oracle3d.h says of a ray, followed from mirror to
// mirror, in double precision and without a tree.
//
// Whatever is decided on the way may be decided otherwise in float: then the colour is ambiguous,
// or, where the decision is about one light, off by no more than this light. How the bounds grow
// stands at the top of oracle3d_mirrors.c.
#ifndef JUDGE_ORACLE3D_MIRRORS_H
#define JUDGE_ORACLE3D_MIRRORS_H

#include "oracle3d.h"

// What a mirror makes of a ray.
typedef enum OracleTurn {
    TURN_RIGHT,
    TURN_ALONG_NORMAL,  // nearly the stub's: see tests/stubs/09-shadows-and-mirrors
    TURN_NONE,          // the ray stays as it is, and so hits the same place again
} OracleTurn;

// What the light of a hit counts.
typedef enum OracleWeight {
    WEIGHT_RIGHT,
    WEIGHT_ONE,         // ks is forgotten
    WEIGHT_LAST_KS,     // ks of the last mirror, not the product
    WEIGHT_FIRST_KS,    // each mirror counts ks of the first one
    WEIGHT_KS_SQUARED,  // ks counts twice for each mirror
    WEIGHT_KD,          // kd for ks
    WEIGHT_OWN_KS,      // a surface's own light counts its own ks as well
    WEIGHT_SHARED,      // and 1 - ks
    WEIGHT_ONLY_FIRST,  // only what is hit first has light of its own
    WEIGHT_LOCAL_ONE,   // light of surfaces counts in full, the background does not
} OracleWeight;

// A way of following. All zeros is the right one.
typedef struct OracleMirrorRules {
    OracleTurn turn;
    OracleWeight weight;
    int from_the_eye;           // mirrored rays start there
    int no_shadows;             // every light arrives
    int only_shadows;           // those arrive that something is before
    int endless_light;          // what stands behind a light casts a shadow, too
    int first_light_only;       // of the lights
    int one_dark_all_dark;      // all lights arrive or none
    int more_bounces;           // 1: one mirror more than allowed; -1: one less
    int last_is_dark;           // what is hit behind the last mirror adds nothing
    int replaces;               // the light of a hit takes the place of what came before it
    int most_bounces;           // no more, whatever is allowed; 0: no such limit
    double least_kd;            // surfaces that scatter less have no light of their own
    int dark_ends;              // the ray ends where no light arrives
    int no_cut_off;             // weights below the least are followed
    double least_weight;        // in the place of the least; 0: the right one
    int least_ends;             // and the least weight itself is not
    int cut_off_late;           // the weight is compared before a hit's ks makes it less
    int mirrors_see_nothing;    // what is near to a mirror is not hit: t_min is too large
    double mirror_t_min;        // of mirrored rays, in the place of 0
    int background_unweighted;  // counts in full over mirrors
    int background_replaces;    // takes the place of what came before it
    int background_missing;     // is not seen in mirrors
    int rest_is_background;     // what is not followed any more is the background
    int cut_at_one;             // no channel of the sum is above 1
    int stubs;                  // as ray_color sees the stubs
    u32 nonce;                  // of those: nonce.h
} OracleMirrorRules;

// Weights below this are not followed: LEAST_WEIGHT of lab 09, a float.
#define ORACLE_LEAST_WEIGHT ((float)(0.5 / 255))

// How far off a surface new rays start, at least; a right solution may go twice as far.
//   t, radius, point   of the hit: see leave_surface.cl of lab 09
double oracle3d_offset(OracleVector point, double t, double radius);

// A direction, mirrored at a surface with this normal.
OracleNear oracle3d_mirrored(OracleNear direction, OracleNear normal, OracleTurn turn);

// ---- Lights (oracle3d_lights.c) -----------------------------------------------------------------

// How many lights a right solution may find before a surface, and of how many rounding decides.
typedef struct OracleSides {
    u32 n_before, n_unsure;
} OracleSides;

OracleSides oracle3d_sides(const Light *lights, int n_lights, OracleNear point, OracleNear normal);

// Does a light before the surface arrive at a point?
typedef enum OracleArrival { LIGHT_ARRIVES, LIGHT_IS_BLOCKED, LIGHT_IS_UNSURE } OracleArrival;

//   leaves   as below
OracleArrival oracle3d_arrival(const Scene3D *scene, OracleNear point, const Light *light,
                               const Sphere *leaves, const OracleMirrorRules *rules);

// The light that arrives at a point and is scattered there.
//   leaves   the sphere that the point is on, NULL for none
OracleNear oracle3d_lit(const Scene3D *scene, OracleNear point, OracleNear normal,
                        const Material *material, const Sphere *leaves,
                        const OracleMirrorRules *rules);

// ---- Whole rays ---------------------------------------------------------------------------------

// How many rays a right solution sends for one from the eye.
typedef struct OracleRayCount {
    u32 n_traced;     // from the eye and from mirrors
    u32 n_hits;       // of those; the last one may hit nothing
    u32 n_to_lights;  // one for each light that may be before the surface of a hit
    u32 n_unsure;     // of how many lights among these rounding decides
    u32 n_needed;  // of the others, those of surfaces that scatter light: something comes of them
} OracleRayCount;

// The colour of a ray from the eye; its error is INFINITY where it is ambiguous.
//   count   out, of no use where the ray is ambiguous; NULL for none
OracleNear oracle3d_follow(const Scene3D *scene, OracleRay ray, int max_bounces,
                           const OracleMirrorRules *rules, OracleRayCount *count);

// Draw a scene as oracle3d_draw() does.
void oracle3d_draw_mirrors(const Scene3D *scene, const Camera *camera, int max_bounces,
                           const OracleMirrorRules *rules, Image *image, float *tolerances);

#endif

// The 3D oracle: an independent brute-force ray tracer in double precision.
//
// It shares no code with the labs. It says what a ray hits and in which colour, how far a right
// solution in float may be from that, and which rays are ambiguous: float may decide otherwise
// there. And it traces wrong on purpose, so that a submission's picture can be recognised.
// How the bounds come about stands at the top of oracle3d.c and of oracle3d_colors.c.
#ifndef JUDGE_ORACLE3D_H
#define JUDGE_ORACLE3D_H

#include "camera.h"
#include "image.h"
#include "oracle_vector.h"
#include "scene3d.h"

// A way of tracing. All zeros is the right one.
typedef struct OracleRules3D {
    // The ray of a pixel.
    double sample_offset;   // added to the pixel's middle: -0.5 for its corner
    int fov_is_height;      // fov taken for the display's height
    int fov_both_ways;      // fov taken for the display's height as well
    int fov_is_angle;       // fov taken for the angle from left to right, radians
    int fov_is_half_width;  // fov taken for half the display's width
    int not_normalised;     // the direction as long as the display's point
    int axes_transposed;    // the view transform's inverse
    // Which root of a sphere.
    int farther_root;            // where the ray leaves, seen from outside, too
    int any_distance;            // t_min ignored: hits behind the eye count
    int inside_is_miss;          // no hit when the ray enters behind the eye
    int radius_sign_ignored;     // a negative radius as a positive one
    int negative_radius_missed;  // a sphere with a negative radius is not there
    // Which sphere.
    int first_wins;       // the first sphere that is hit, however far
    int last_wins;        // the last one
    int farthest_wins;    // the farthest
    int later_wins_ties;  // of equally far ones the last
    int skip_first;       // the first sphere is not asked
    int skip_last;        // nor the last
    int one_sphere_more;  // the one behind the end of the array is asked, too
    // Which colour.
    int normal_not_turned;      // it points away from the centre, seen from inside, too
    int normal_always_turned;   // it points to the centre
    int normal_not_normalised;  // as long as the radius
    int cosine_not_clamped;     // a light behind the surface takes light away
    int cosine_absolute;        // and lights it from behind
    int to_light_not_normalised;
    int first_light_only;
    int last_light_only;
    int cut_at_one;      // no channel is above 1
    int one_light_more;  // the one behind the end of the array shines, too
    int ignore_kd;
    int ignore_color;         // of the material
    int ignore_light_color;   // every light is white
    int ignore_material_ids;  // sphere i is of material i, if there is one
    int background_black;
} OracleRules3D;

// ---- Rays -------------------------------------------------------------------------------------

typedef struct OracleRay {
    OracleVector origin;     // exact from the eye: it comes from floats
    OracleVector direction;  // a unit vector, but for the rule not_normalised
    double t_min;
    double direction_error;  // how far a right solution's direction may be from it
    double origin_error;     // and its origin
    const Sphere *leaves;    // the sphere that it starts on and must not hit there; NULL for none
} OracleRay;

// The camera's axes for a view: right, up and forward.
void oracle3d_axes(const View *view, OracleVector axes[3]);

// Where a pixel stands on the display: see pixel_on_display() of lab 04.
OracleVector oracle3d_display(int x, int y, int width, int height, double fov,
                              const OracleRules3D *rules);

// The ray of a pixel, as a right solution's float may be anywhere near it.
OracleRay oracle3d_primary_ray(const Camera *camera, int x, int y, int width, int height,
                               const OracleRules3D *rules);

// A ray given in float, as a function's input: its direction is a unit vector within rounding.
OracleRay oracle3d_given_ray(Vec3 origin, Vec3 direction, float t_min);

// ---- Hits -------------------------------------------------------------------------------------

#define ORACLE_NO_SPHERE 0xffffffffu  // NO_SPHERE of kernels/ray.h

// How a solution may solve the quadratic equation: see intersect_sphere.cl of lab 05.
typedef enum OracleForm { ORACLE_PROJECTION, ORACLE_TEXTBOOK } OracleForm;

// What of the ray's line lies in a sphere, and where a right solution in float may find that.
typedef struct OracleChord {
    double middle;    // along the ray; behind the eye it is negative
    double error;     // how far the middle may be off
    double half;      // half the chord's length; NAN when the line misses it
    int is_possible;  // a right solution may find that the line meets the sphere,
    int is_certain;   // and must find it
    double shortest;  // half a chord, as short and as long as it may be found; not set when none is
    double longest;   // possible
} OracleChord;

OracleChord oracle3d_chord(Sphere sphere, const OracleRay *ray, OracleForm form);

// What one sphere is to a ray.
typedef struct OracleRoot {
    double t;         // of the hit; INFINITY when there is none
    int is_possible;  // a right solution in float may find a hit,
    int is_certain;   // and must find one
    double t_low;     // where that hit lies; not set when none is possible
    double t_high;
} OracleRoot;

OracleRoot oracle3d_root(Sphere sphere, const OracleRay *ray, OracleForm form,
                         const OracleRules3D *rules);

// What a ray hits first.
typedef struct OracleHit {
    u32 sphere;          // ORACLE_NO_SPHERE when nothing is hit
    double t;            // INFINITY when nothing is hit
    double t_tolerance;  // how far a right solution's t may be from it
    int is_ambiguous;    // a right solution may hit another sphere, or one more or less
} OracleHit;

// Ask spheres[n_spheres]; of two hits at the same distance the lower index wins. Exact copies of a
// sphere behind it do not make its hits ambiguous: float finds the same distance for both.
OracleHit oracle3d_nearest(const Sphere *spheres, u32 n_spheres, const OracleRay *ray,
                           const OracleRules3D *rules);

// ---- Colours ----------------------------------------------------------------------------------

// A vector and how far a right solution's may be from it; the error is INFINITY where float may
// find one that has nothing to do with it.
typedef struct OracleNear {
    OracleVector value;
    double error;
} OracleNear;

// A vector that is given, and so exact.
OracleNear oracle3d_exactly(Vec3 v);

// May a right solution find this for it?
int oracle3d_is_near(Vec3 found, OracleNear expected);

// The unit normal of a sphere at one of its points, on the side the ray comes from.
OracleNear oracle3d_normal(Sphere sphere, OracleNear point, OracleNear direction,
                           const OracleRules3D *rules);

// Lambert's law; the error is of each channel.
OracleNear oracle3d_shade(OracleNear point, OracleNear normal, const Material *material,
                          const Light *lights, int n_lights, const OracleRules3D *rules);

// ---- Pictures ---------------------------------------------------------------------------------

// Draw a scene into an image of its size, with alpha 1. With the rules one_sphere_more and
// one_light_more its arrays must go on: see job_scene3d.h.
//   tolerances   out: [height * width], how far a channel may be off, INFINITY where a pixel is
//                ambiguous; or NULL
//   hits         out: [height * width]; or NULL
void oracle3d_draw(const Scene3D *scene, const Camera *camera, const OracleRules3D *rules,
                   Image *image, float *tolerances, OracleHit *hits);

#endif

// Lab 05: where a ray meets a sphere, solved in two ways. Labs 05 and 07 build on it.
//
// Both move the ray into the sphere's own frame, where its centre is the origin. There a point p is
// on the sphere when p . p = r²; with p = o + t d this is a quadratic equation in t. On paper the
// two functions below are the same; in float they are not.
// Flow: scene -> buffers -> KERNEL -> image. Called by nearest_hit.cl, and by trace.cl of lab 07.
#include "ray.h"
#include "sphere.h"
#include "work.h"

// The hit of a ray and a sphere: the nearer of the roots t_near and t_far that is greater than
// t_min. A sphere with a negative radius is visible from inside only: t_far, or none.
//   b     the middle between the two roots, along the ray
//   disc  the square of half the distance between them; negative when the ray misses
//   radius, t_min   the sphere's and the ray's
// Returns the distance t, or INFINITY when there is no hit.
float nearest_root(float b, float disc, float radius, float t_min)
{
    // TASK nearest_root: no hit when disc is negative. The ray enters the sphere at the root
    // t_near = b - sqrt(disc) and leaves it at t_far = b + sqrt(disc). From inside only t_far is
    // ahead of the eye.
    (void)b, (void)disc, (void)radius, (void)t_min;
    return INFINITY;
    // END nearest_root
}

// Intersect as textbooks do. With o the eye seen from the centre:
//     t² + 2 (o . d) t + (o . o - r²) = 0
// Returns what nearest_root() does. Small or far spheres crumble: if o . o is much larger than the
// square of r, float has no digits left for their difference.
// Source: lecture, slides "Schnittpunktberechnung mit Kugel I" and "II".
float intersect_textbook(Sphere sphere, Ray ray)
{
    // TASK intersect_textbook: the quadratic formula. The direction is a unit vector, so the factor
    // of t² is 1.
    (void)sphere, (void)ray;
    return INFINITY;
    // END intersect_textbook
}

// Intersect by projection: with c the centre seen from the eye, the ray passes nearest to the
// centre at t = c . d, and l = c - (c . d) d is the vector from there to the centre. Pythagoras:
// half the chord's square is r² - l . l, and no number in it is larger than it needs to be.
//   work   what this pixel has cost so far; the call is counted
// Returns what nearest_root() does.
float intersect_sphere(Sphere sphere, Ray ray, Work *work)
{
    count_test(work);
#ifdef TEXTBOOK  // --textbook draws with the other function, to show how it fails
    return intersect_textbook(sphere, ray);
#endif
    // TASK intersect_sphere: subtract the vectors first, then square: that order keeps the digits.
    (void)sphere, (void)ray;
    return INFINITY;
    // END intersect_sphere
}

// Lab 05: the naive search: every ray tests every sphere.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_spheres.cl.
#include "intersect_sphere.cl"
#include "work.h"

// What the ray hits first.
//   spheres[n_spheres]   the scene
//   work                 what this pixel has cost so far: for intersect_sphere()
// Returns the nearest hit. If two have the same distance, the sphere with the lower index wins.
Hit nearest_hit(global const Sphere *spheres, int n_spheres, Ray ray, Work *work)
{
    Hit hit = {INFINITY, NO_SPHERE};
    // TASK nearest_hit: test every sphere, in the order of the array, and keep the nearest hit: its
    // distance and the sphere's index.
    //> (void)spheres, (void)n_spheres, (void)ray, (void)work;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
    // END nearest_hit
    return hit;
}

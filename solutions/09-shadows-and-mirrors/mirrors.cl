// Lab 09: the colour of a ray that mirrors send on.
//
// OpenCL C has no recursion, and none is needed: each ray has one mirrored ray, so a loop follows
// it. One number, the weight, is the factor for the next light.
// Flow: scene -> buffers -> KERNEL -> image. Called by render_mirrors.cl.
#include "leave_surface.cl"
#include "shadows.cl"

// Where a mirror sends a ray: the angle of exit is that of entry.
//   direction, normal   unit vectors; the normal is on the side the ray comes from
// Returns a unit vector within their rounding.
float3 mirrored_direction(float3 direction, float3 normal)
{
    // TASK mirrored_direction: the part of the direction along the normal turns round.
    //> (void)normal;
    //> return direction;
    return direction - 2.0f * dot(direction, normal) * normal;
    // END mirrored_direction
}

// What a ray has hit, as new rays need it.
typedef struct Surface {
    float3 point;   // off the surface already: new rays start here
    float3 normal;  // unit vector, to the side the ray came from
    Material material;
} Surface;

// The surface at a hit, which is one. Nothing to fill in here.
static Surface surface_at(Ray ray, Hit hit, const TracedScene *scene)
{
    const Sphere sphere = scene->spheres[hit.sphere];
    const float3 point = ray.origin + hit.t * ray.direction;
    Surface surface;
    surface.normal = surface_normal(sphere, point, ray.direction);
    surface.point = leave_surface(point, surface.normal, hit.t, sphere.radius);
    surface.material = scene->materials[scene->material_ids[hit.sphere]];
    return surface;
}

// A ray with a smaller weight is not followed: half of one of the 255 steps of a PNG. If no hit is
// brighter than 1, the next hit would add at most that much, and so would each later one. Together
// they would add at most half a step for each mirror that is left, and at most half a step /
// (1 - ks).
#define LEAST_WEIGHT (0.5f / 255.0f)

// The colour of a ray and of what it sees in mirrors.
//   ray           from the eye
//   max_bounces   it is mirrored at most this many times; 0: never
//   work          what this pixel has cost so far
// The sum begins with what is hit first. Light that comes over a mirror counts times the ks of its
// material, over two mirrors times the product, and so on; the background, too.
float3 ray_color(Ray ray, int max_bounces, const TracedScene *scene, Work *work)
{
    float3 color = (float3)(0.0f);
    // TASK ray_color: follow the ray from hit to hit, and add the light of each times its weight.
    // The end: nothing is hit, it was mirrored max_bounces times, or it weighs under LEAST_WEIGHT.
    //> (void)ray, (void)max_bounces, (void)scene, (void)work;
    float weight = 1.0f;
    for (int n_bounces = 0;; n_bounces++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight *= at.material.ks;
        if (n_bounces == max_bounces || weight < LEAST_WEIGHT) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
    // END ray_color
    return color;
}

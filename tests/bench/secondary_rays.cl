// Bench: lab 09's shadow rays and its first mirrored ones. One kernel makes them, the others search
// them alone, with lab 09's functions: what is timed is the search. Started by secondary_rays.c.
#include "mirrors.cl"
#include "primary_ray.cl"
#include "secondary_ray.h"

// ---- Making ---------------------------------------------------------------------------------

// The ray of a pixel that none begins at.
static SecondaryRay no_ray(void)
{
    const SecondaryRay none = {{0.0f, 0.0f, 0.0f}, 0.0f, {0.0f, 0.0f, 0.0f}, 0.0f};
    return none;
}

static SecondaryRay to_shared(Ray ray)
{
    const SecondaryRay shared = {{ray.origin.x, ray.origin.y, ray.origin.z},
                                 ray.t_min,
                                 {ray.direction.x, ray.direction.y, ray.direction.z},
                                 ray.t_max};
    return shared;
}

// To a light, as lit_color() does.
static SecondaryRay ray_to_light(Surface at, Light light)
{
    const Ray ray = shadow_ray(at.point, light);
    return dot(at.normal, ray.direction) > 0.0f ? to_shared(ray) : no_ray();
}

// Into the first mirror, as ray_color() does.
static SecondaryRay ray_of_mirror(Ray ray, Surface at)
{
    if (at.material.ks < LEAST_WEIGHT) {
        return no_ray();
    }
    ray.origin = at.point;
    ray.direction = mirrored_direction(ray.direction, at.normal);
    return to_shared(ray);
}

// Where a pixel's ray stands among all: any 4, 8, 16 or 64 from a multiple of that on are those of
// 2x2, 4x2, 4x4 or 8x8 neighbours (Morton order). Rays that lie close together meet the same nodes.
static uint place_of(uint x, uint y)
{
    uint place = 0;
    for (uint bit = 0; bit < 16; bit++) {
        place |= (x >> bit & 1) << 2 * bit | (y >> bit & 1) << (2 * bit + 1);
    }
    return place;
}

// Make the rays that begin where the primary rays end, one work-item a pixel.
//   spheres ... bounds   as in render_mirrors of lab 09; the image stays as it is
//   width, height        the picture's, pixels: equal, and a power of two
//   light                to which of the lights; n_lights: the mirrored rays
//   rays                 out: one a pixel, in the order of place_of()
kernel void make_rays(global const Sphere *spheres, global const uint *material_ids,
                      global const Material *materials, global const Light *lights, int n_lights,
                      Vec3 background, Camera camera, int width, int height,
                      write_only image2d_t image, global const KdNode3 *nodes,
                      global const uint *sphere_ids, BBox3D bounds, int light,
                      global SecondaryRay *rays)
{
    (void)image;
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    const TracedScene scene = {spheres, material_ids, materials,
                               lights,  n_lights,     to_float3(background),
                               nodes,   sphere_ids,   bounds};
    Work work = {0, 0, 0, 0};
    const Ray ray = primary_ray(x, y, width, height, camera);
    const Hit hit = trace(ray, spheres, nodes, sphere_ids, bounds, &work);
    SecondaryRay made = no_ray();
    if (hit.sphere != NO_SPHERE) {
        const Surface at = surface_at(ray, hit, &scene);
        made = light < n_lights ? ray_to_light(at, lights[light]) : ray_of_mirror(ray, at);
    }
    rays[place_of(x, y)] = made;
}

// ---- Searching ------------------------------------------------------------------------------

static Ray to_ray(SecondaryRay shared)
{
    const Ray ray = {to_float3(shared.origin), to_float3(shared.direction), shared.t_min,
                     shared.t_max};
    return ray;
}

// Does anything stand in the ray's way? One work-item a ray.
//   nodes, sphere_ids, bounds    the tree over the spheres (kdtree3d.h)
//   answers[n_rays]              out: 1, or 0 where nothing does
kernel void search_shadow(global const Sphere *spheres, global const KdNode3 *nodes,
                          global const uint *sphere_ids, BBox3D bounds,
                          global const SecondaryRay *rays, int n_rays, global uint *answers)
{
    const int i = get_global_id(0);
    if (i >= n_rays) {
        return;
    }
    Work work = {0, 0, 0, 0};
    const TracedScene scene = {
        .spheres = spheres, .nodes = nodes, .sphere_ids = sphere_ids, .bounds = bounds};
    answers[i] = is_blocked(to_ray(rays[i]), &scene, &work);
}

// What does the ray hit first? As above, but for
//   answers[n_rays]              out: the sphere, or NO_SPHERE
kernel void search_mirrored(global const Sphere *spheres, global const KdNode3 *nodes,
                            global const uint *sphere_ids, BBox3D bounds,
                            global const SecondaryRay *rays, int n_rays, global uint *answers)
{
    const int i = get_global_id(0);
    if (i >= n_rays) {
        return;
    }
    Work work = {0, 0, 0, 0};
    answers[i] = trace(to_ray(rays[i]), spheres, nodes, sphere_ids, bounds, &work).sphere;
}

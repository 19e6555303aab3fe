// Lab 09: ray tracing with shadows and mirrors. Nothing to fill in here.
//
// Flow: scene -> buffers (the tree of lab 06) -> KERNEL -> image. Started by main.c.
#include "mirrors.cl"
#include "primary_ray.cl"

// Draw the spheres, one work-item a pixel.
//   spheres ... image            as in render_spheres of lab 05
//   nodes, sphere_ids, bounds    the packed tree over the spheres (kdtree3d.h)
//   max_bounces                  a ray is mirrored at most this many times; 0: never
//   d_work                       what each pixel cost; NULL if nothing is counted
kernel void render_mirrors(global const Sphere *spheres, global const uint *material_ids,
                           global const Material *materials, global const Light *lights,
                           int n_lights, Vec3 background, Camera camera, int width, int height,
                           write_only image2d_t image, global const KdNode3 *nodes,
                           global const uint *sphere_ids, BBox3D bounds, int max_bounces,
                           global Work *d_work)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    // Spare work-items are outside the picture.
    if (x >= width || y >= height) {
        return;
    }

    Work work = {0, 0, 0, 0};
    const TracedScene scene = {spheres, material_ids, materials,
                               lights,  n_lights,     to_float3(background),
                               nodes,   sphere_ids,   bounds};
    const Ray ray = primary_ray(x, y, width, height, camera);
    const float3 color = ray_color(ray, max_bounces, &scene, &work);
    write_imagef(image, (int2)(x, y), (float4)(color, 1.0f));
    work_save(work, x, y, width, d_work);
}

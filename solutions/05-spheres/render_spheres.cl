// Lab 05: ray tracing, the naive way: every ray tests every sphere. Nothing to fill in here.
//
// Flow: scene -> buffers -> KERNEL -> image. Started by main.c.
#include "nearest_hit.cl"
#include "primary_ray.cl"
#include "shade.cl"

// Draw the spheres, one work-item a pixel.
//   spheres[n_spheres]                    the scene,
//   material_ids, materials               what its spheres are made of (shading.h),
//   lights[n_lights], background          its lights, and the colour where nothing is hit
//   camera                                where it is seen from
//   width, height                         the picture, pixels; work-items outside it write nothing
//   image                                 RGBA float, at least width x height; row 0 is the top row
//   d_work                                what each pixel cost; NULL if nothing is counted
kernel void render_spheres(global const Sphere *spheres, global const uint *material_ids,
                           global const Material *materials, global const Light *lights,
                           int n_lights, Vec3 background, Camera camera, int width, int height,
                           write_only image2d_t image, int n_spheres, global Work *d_work)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    // Work-items that fill up the last work-groups are outside the picture.
    if (x >= width || y >= height) {
        return;
    }

    Work work = {0, 0, 0, 0};
    const Ray ray = primary_ray(x, y, width, height, camera);
    const Hit hit = nearest_hit(spheres, n_spheres, ray, &work);
    const float3 color =
        hit_color(ray, hit, spheres, material_ids, materials, lights, n_lights, background);
    write_imagef(image, (int2)(x, y), (float4)(color, 1.0f));
    work_save(work, x, y, width, d_work);
}

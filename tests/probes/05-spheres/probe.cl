// Probe of lab 05: the kernel with the student's functions in it, and others that call each of them
// with the job's inputs.
#include "render_spheres.cl"

#include "no_macros.h"

#include "jobs_05.h"

static Vec3 to_vec3(float3 v)
{
    const Vec3 result = {v.x, v.y, v.z};
    return result;
}

kernel void probe_roots(global const RootJob *jobs, global float *answers)
{
    const size_t i = get_global_id(0);
    answers[i] = nearest_root(jobs[i].b, jobs[i].disc, jobs[i].radius, jobs[i].t_min);
}

static Ray ray_of(SphereRayJob job)
{
    Ray ray;
    ray.origin = to_float3(job.origin);
    ray.direction = to_float3(job.direction);
    ray.t_min = job.t_min;
    ray.t_max = INFINITY;
    return ray;
}

kernel void probe_textbook(global const SphereRayJob *jobs, global float *answers)
{
    const size_t i = get_global_id(0);
    answers[i] = intersect_textbook(jobs[i].sphere, ray_of(jobs[i]));
}

kernel void probe_projection(global const SphereRayJob *jobs, global float *answers)
{
    const size_t i = get_global_id(0);
    Work work = {0, 0, 0, 0};
    answers[i] = intersect_sphere(jobs[i].sphere, ray_of(jobs[i]), &work);
}

kernel void probe_normals(global const NormalJob *jobs, global Vec3 *answers)
{
    const size_t i = get_global_id(0);
    const NormalJob job = jobs[i];
    answers[i] =
        to_vec3(surface_normal(job.sphere, to_float3(job.point), to_float3(job.direction)));
}

static Vec3 shade_of(ShadeJob job, global const Light *lights)
{
    return to_vec3(shade(to_float3(job.point), to_float3(job.normal), job.material,
                         lights + job.first_light, job.n_lights));
}

kernel void probe_shades(global const ShadeJob *jobs, global const Light *lights,
                         global Vec3 *answers)
{
    const size_t i = get_global_id(0);
    answers[i] = shade_of(jobs[i], lights);
}

// The same for what whole pictures ask.
kernel void probe_pixel_shades(global const ShadeJob *jobs, global const Light *lights,
                               global Vec3 *answers)
{
    const size_t i = get_global_id(0);
    answers[i] = shade_of(jobs[i], lights);
}

// What each pixel's ray hits, with the camera of lab 04's solution.
kernel void probe_hits(global const Sphere *spheres, int n_spheres, Camera camera, int width,
                       int height, global HitAnswer *answers)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    Work work = {0, 0, 0, 0};
    const Ray ray = primary_ray(x, y, width, height, camera);
    const Hit hit = nearest_hit(spheres, n_spheres, ray, &work);
    answers[y * width + x].t = hit.t;
    answers[y * width + x].sphere = hit.sphere;
}

// What rays along z hit, each from its own pixel: see SQUARES_T_MIN of jobs.h.
kernel void probe_squares(global const Sphere *squares, int n_squares, int width, int height,
                          global HitAnswer *answers, global Work *d_work)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    Work work = {0, 0, 0, 0};
    Ray ray;
    ray.origin = (float3)(x, y, 0.0f);
    ray.direction = (float3)(0.0f, 0.0f, 1.0f);
    ray.t_min = SQUARES_T_MIN;
    ray.t_max = INFINITY;
    const Hit hit = nearest_hit(squares, n_squares, ray, &work);
    answers[y * width + x].t = hit.t;
    answers[y * width + x].sphere = hit.sphere;
    work_save(work, x, y, width, d_work);
}

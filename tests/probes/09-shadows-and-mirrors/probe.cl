// Probe of lab 09: the kernel with the student's functions in it, and others that call each of them
// with the job's inputs.
#include "render_mirrors.cl"

#include "no_macros.h"

#include "jobs_09.h"

static Vec3 to_vec3(float3 v)
{
    const Vec3 result = {v.x, v.y, v.z};
    return result;
}

kernel void probe_starts(global const StartJob *jobs, global Vec3 *answers)
{
    const size_t i = get_global_id(0);
    const StartJob job = jobs[i];
    answers[i] =
        to_vec3(leave_surface(to_float3(job.point), to_float3(job.normal), job.t, job.radius));
}

kernel void probe_mirrors(global const MirrorJob *jobs, global Vec3 *answers)
{
    const size_t i = get_global_id(0);
    answers[i] =
        to_vec3(mirrored_direction(to_float3(jobs[i].direction), to_float3(jobs[i].normal)));
}

kernel void probe_shadow_rays(global const ShadowRayJob *jobs, global ShadowRayAnswer *answers)
{
    const size_t i = get_global_id(0);
    const Ray ray = shadow_ray(to_float3(jobs[i].point), jobs[i].light);
    answers[i].origin = to_vec3(ray.origin);
    answers[i].direction = to_vec3(ray.direction);
    answers[i].t_min = ray.t_min;
    answers[i].t_max = ray.t_max;
}

kernel void probe_blocks(global const BlockJob *jobs, global const uint *sphere_ids,
                         global const Sphere *spheres, global BlockAnswer *answers)
{
    const size_t i = get_global_id(0);
    const BlockJob job = jobs[i];
    const Ray ray = {to_float3(job.origin), to_float3(job.direction), 0.0f, job.t_max};
    Work work = {0, 0, 0, 0};
    answers[i].is_blocked = leaf_blocks(job.node, sphere_ids, spheres, ray, &work) != 0;
    answers[i].n_tests = work.n_tests;
}

kernel void probe_lits(global const LitJob *jobs, global const Sphere *spheres,
                       global const KdNode3 *nodes, global const uint *sphere_ids,
                       global const Light *lights, global LitAnswer *answers)
{
    const size_t i = get_global_id(0);
    const LitJob job = jobs[i];
    TracedScene scene;
    scene.spheres = spheres;
    scene.lights = lights + job.first_light;
    scene.n_lights = job.n_lights;
    scene.nodes = nodes;
    scene.sphere_ids = sphere_ids;
    scene.bounds = job.bounds;
    Work work = {0, 0, 0, 0};
    answers[i].color = to_vec3(
        lit_color(to_float3(job.point), to_float3(job.normal), job.material, &scene, &work));
    answers[i].n_leaves = work.n_leaves_visited;
}

// Probe of lab 07: the kernel with the student's functions in it, and others that call each of them
// with the job's inputs.
#include "render_kdtree.cl"

#include "no_macros.h"

#include "jobs_07.h"
#include "probe_stack.h"

static Ray ray_of(Vec3 origin, Vec3 direction, float t_min, float t_max)
{
    Ray ray;
    ray.origin = to_float3(origin);
    ray.direction = to_float3(direction);
    ray.t_min = t_min;
    ray.t_max = t_max;
    return ray;
}

kernel void probe_clips(global const ClipJob *jobs, global ClipAnswer *answers)
{
    const size_t i = get_global_id(0);
    const ClipJob job = jobs[i];
    float t_min = job.t_min;
    float t_max = job.t_max;
    const Ray ray = ray_of(job.origin, job.direction, t_min, t_max);
    answers[i].is_met = clip_to_box(job.box, ray, &t_min, &t_max);
    answers[i].t_min = t_min;
    answers[i].t_max = t_max;
}

kernel void probe_sides(global const SideJob *jobs, global uint *answers)
{
    const size_t i = get_global_id(0);
    answers[i] = near_side(jobs[i].node, jobs[i].origin, jobs[i].inverse);
}

kernel void probe_planes(global const PlaneJob *jobs, global PlaneAnswer *answers)
{
    const size_t i = get_global_id(0);
    const PlaneJob job = jobs[i];
    float t_split = UNWRITTEN;
    const int children =
        children_on_ray(job.node, job.origin, job.inverse, job.t_min, job.t_max, &t_split);
    answers[i].children = children == ONLY_NEAR  ? PLANE_ONLY_NEAR
                          : children == ONLY_FAR ? PLANE_ONLY_FAR
                          : children == BOTH     ? PLANE_BOTH
                                                 : PLANE_UNKNOWN;
    answers[i].t_split = t_split;
}

kernel void probe_leaves(global const SearchJob *jobs, global const uint *sphere_ids,
                         global const Sphere *spheres, global SearchAnswer *answers)
{
    const size_t i = get_global_id(0);
    const SearchJob job = jobs[i];
    Hit hit = {job.t, job.sphere};
    Work work = {0, 0, 0, 0};
    search_leaf(job.node, sphere_ids, spheres, ray_of(job.origin, job.direction, 0.0f, INFINITY),
                &hit, &work);
    answers[i].t = hit.t;
    answers[i].sphere = hit.sphere;
    answers[i].n_tests = work.n_tests;
}

kernel void probe_next_child(global const NextChildJob *jobs, global NextChildAnswer *answers)
{
    const size_t i = get_global_id(0);
    const NextChildJob job = jobs[i];
    RoomyTodo roomy;
    fill_stack(job.todo, &roomy.todo);
    answers[i].next =
        next_child(job.node, job.origin, job.inverse, job.t_min, job.t_max, &roomy.todo);
    answers[i].todo = look_at_stack(job.todo.n_lower, &roomy.todo);
}

kernel void probe_next_waiting(global const NextWaitingJob *jobs, global NextWaitingAnswer *answers)
{
    const size_t i = get_global_id(0);
    const NextWaitingJob job = jobs[i];
    const Hit hit = {job.t, job.sphere};
    TodoEntry at = job.at;
    RoomyTodo roomy;
    fill_stack(job.todo, &roomy.todo);
    answers[i].goes_on = next_waiting(hit, &roomy.todo, &at);
    answers[i].at = at;
    answers[i].todo = look_at_stack(job.todo.n_lower, &roomy.todo);
}

// What each pixel's ray hits, with the camera of lab 04's solution.
kernel void probe_hits(global const Sphere *spheres, global const KdNode3 *nodes,
                       global const uint *sphere_ids, BBox3D bounds, Camera camera, int width,
                       int height, global HitAnswer *answers)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    Work work = {0, 0, 0, 0};
    const Ray ray = primary_ray(x, y, width, height, camera);
    const Hit hit = trace(ray, spheres, nodes, sphere_ids, bounds, &work);
    answers[y * width + x].t = hit.t;
    answers[y * width + x].sphere = hit.sphere;
}

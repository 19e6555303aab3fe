// Probe of lab 04: the student's kernel, and one that calls pixel_on_display and primary_ray with
// the job's inputs.
#include "image_size.h"

#include "draw_directions.cl"

#include "no_macros.h"

#include "jobs_04.h"

kernel void probe_pixels(global const PixelJob *jobs, global PixelAnswer *answers)
{
    const size_t i = get_global_id(0);
    const PixelJob job = jobs[i];
    const float3 p = pixel_on_display(job.x, job.y, job.width, job.height, job.camera.fov);
    const Ray ray = primary_ray(job.x, job.y, job.width, job.height, job.camera);
    PixelAnswer answer = {{p.x, p.y, p.z},
                          {ray.origin.x, ray.origin.y, ray.origin.z},
                          {ray.direction.x, ray.direction.y, ray.direction.z},
                          ray.t_min,
                          ray.t_max};
    answers[i] = answer;
}

// What the steps of a ray among spheres are: shared by the kernels of labs 05 and 07.
//
// Read next: 07-kdtree-3d-trace.cl.
#ifndef FOLLOW_STEPS_SPHERES_H
#define FOLLOW_STEPS_SPHERES_H

#include "ray.h"
#include "recording.h"
#include "sphere.h"

float intersect_sphere(Sphere sphere, Ray ray, Work *work);

// In intersect_sphere(): the sphere that is asked.
#define count_test(work) step_sphere(work, sphere)
static inline void step_sphere(Work *work, Sphere sphere)
{
    const Step step = {.kind = STEP_TEST, .element = {sphere.x, sphere.y, sphere.z, sphere.radius}};
    step_add(work, step);
}

static Sphere step_asks(Step step)
{
    return (Sphere){step.element[0], step.element[1], step.element[2], step.element[3]};
}

// At the end of the kernel: the ray, and what it has hit.
static void steps_save(Work *work, Ray ray, Hit hit, global Work *d_steps)
{
    ANSWER_ALL(work, intersect_sphere(step_asks(step), ray, work));
    const Step end = {.kind = STEP_END, .id = hit.sphere, .nearest = hit.t};
    step_add(work, end);
    vstore3(ray.origin, 0, work->origin);
    vstore3(ray.direction, 0, work->direction);
    *d_steps = *work;
}

#endif

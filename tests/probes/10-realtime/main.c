// Probe of lab 10: each of the student's functions on the job's inputs, tiles of circles painted
// whole, then scenes of spheres with their trees: what each ray hits, the picture, and the work of
// each pixel's tile ("work.K").
#include "jobs_10.h"
#include "probe.h"

#include "cl_memory.h"
#include "work.h"

#include <stdlib.h>

static void answer_functions(const Probe *probe, cl_program program)
{
    static const char *const circle_tree[] = {"circle_nodes", "leaf_circles"};
    probe_call(probe, program, "tile_planes", sizeof(TilePlaneJob), sizeof(TilePlaneAnswer), NULL,
               0);
    probe_call(probe, program, "tile_children", sizeof(TileChildJob), sizeof(NextChildAnswer), NULL,
               0);
    probe_call(probe, program, "tile_waiting", sizeof(TileWaitingJob), sizeof(NextWaitingAnswer),
               NULL, 0);
    probe_call(probe, program, "cones", sizeof(ConeJob), sizeof(cl_int), NULL, 0);
    probe_call(probe, program, "circle_rows", sizeof(CircleRowJob), sizeof(CircleRowAnswer), NULL,
               0);
    // What goes through the trees of Part A.
    probe_call_with(probe, program, "tile_leaves", sizeof(CircleTileJob), sizeof(TileLeafAnswer),
                    circle_tree, 1);
    probe_call_with(probe, program, "circle_tiles", sizeof(CircleTileJob), sizeof(CircleTileAnswer),
                    circle_tree, 2);
}

// One work-item a tile, each in a group of its own: see tile_buffers.c.
static void launch_tiles(const Probe *probe, cl_kernel kernel, const SceneJob3D *job)
{
    const size_t group[2] = {1, 1};
    const size_t tiles[2] = {((size_t)job->width + TILE_SIDE - 1) / TILE_SIDE,
                             ((size_t)job->height + TILE_SIDE - 1) / TILE_SIDE};
    CL_CHECK(clEnqueueNDRangeKernel(probe->cl.queue, kernel, 2, NULL, tiles, group, 0, NULL, NULL));
}

// Set an argument, a buffer, and go on to the next.
static void set_next(cl_kernel kernel, cl_uint *argument, cl_mem d_buffer)
{
    CL_CHECK(clSetKernelArg(kernel, (*argument)++, sizeof d_buffer, &d_buffer));
}

static void answer_scene(const Probe *probe, int k, const SceneJob3D *job, cl_kernel kernel)
{
    Scene3DBuffers buffers = probe_scene3d_buffers(probe, k, job);
    const cl_mem d_tree[] = {probe_part_create(probe, k, "nodes"),
                             probe_part_create(probe, k, "sphere_ids"),
                             probe_part_create(probe, k, "leaf_spheres")};
    const size_t n_pixels = (size_t)job->width * (size_t)job->height;
    const size_t n_items =
        (size_t)PROBE_IMAGE_SIDE(job->width) * (size_t)PROBE_IMAGE_SIDE(job->height);
    cl_mem d_hits = probe_buffer(probe, n_pixels * sizeof(HitAnswer));
    cl_mem d_work = probe_buffer(probe, n_items * sizeof(Work));
    cl_uint argument = N_SCENE3D_ARGUMENTS;
    probe_scene3d_set(&buffers, job, kernel);
    set_next(kernel, &argument, d_tree[0]);
    set_next(kernel, &argument, d_tree[1]);
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof job->bounds, &job->bounds));
    set_next(kernel, &argument, d_tree[2]);
    set_next(kernel, &argument, d_hits);
    set_next(kernel, &argument, d_work);
    probe_note(probe, "picture", (uint32_t)k);
    launch_tiles(probe, kernel, job);
    probe_answer_image(probe, k, buffers.d_image, job->width, job->height);
    probe_answer_buffer(probe, "hits", k, d_hits, n_pixels * sizeof(HitAnswer));
    probe_answer_buffer(probe, "work", k, d_work, n_items * sizeof(Work));
    probe_scene3d_release(&buffers);
    cl_memory_release(d_tree, sizeof d_tree / sizeof *d_tree);
}

int main(void)
{
    Probe probe;
    cl_program program = probe_open_program(&probe, PROBE_PROGRAM, PROBE_COUNTING);
    answer_functions(&probe, program);
    cl_kernel kernel = probe_kernel(program, "probe_tiles");
    const SceneJob3D *job;
    for (int k = 0; (job = probe_scene3d(&probe, k)) != NULL; k++) {
        answer_scene(&probe, k, job, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}

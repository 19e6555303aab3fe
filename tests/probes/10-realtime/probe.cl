// Probe of lab 10: the kernel's parts with the student's functions in them, and kernels that call
// each of these with the job's inputs.
#include "render_circles.cl"
#include "render_tiles.cl"

#include "no_macros.h"

#include "jobs_10.h"
#include "probe_stack.h"

kernel void probe_tile_planes(global const TilePlaneJob *jobs, global TilePlaneAnswer *answers)
{
    const size_t i = get_global_id(0);
    const TilePlaneJob job = jobs[i];
    const Interval direction = {job.low, job.high};
    const Interval found = plane_interval(job.plane, job.eye, direction);
    answers[i].low = found.low;
    answers[i].high = found.high;
}

kernel void probe_tile_children(global const TileChildJob *jobs, global NextChildAnswer *answers)
{
    const size_t i = get_global_id(0);
    const TileChildJob job = jobs[i];
    const Interval t_split = {job.split_low, job.split_high};
    RoomyTodo roomy;
    fill_stack(job.todo, &roomy.todo);
    answers[i].next = next_tile_child(job.node, job.eye, t_split, job.at, &roomy.todo);
    answers[i].todo = look_at_stack(job.todo.n_lower, &roomy.todo);
}

kernel void probe_tile_waiting(global const TileWaitingJob *jobs, global NextWaitingAnswer *answers)
{
    const size_t i = get_global_id(0);
    const TileWaitingJob job = jobs[i];
    TodoEntry at = job.at;
    RoomyTodo roomy;
    fill_stack(job.todo, &roomy.todo);
    for (uint k = 0; k < job.n_behind; k++) {
        todo_push(&roomy.todo, WAITS_NODE, WAITS_FROM, WAITS_TO);
    }
    answers[i].goes_on = next_tile_waiting(job.farthest, &roomy.todo, &at);
    answers[i].at = at;
    answers[i].todo = look_at_stack(job.todo.n_lower, &roomy.todo);
}

kernel void probe_cones(global const ConeJob *jobs, global int *answers)
{
    const size_t i = get_global_id(0);
    const ConeJob job = jobs[i];
    Cone cone;
    cone.axis = to_float3(job.axis);
    cone.cosine = job.cosine;
    cone.sine = job.sine;
    answers[i] = cone_misses_sphere(cone, to_float3(job.centre), job.radius) != 0;
}

// Write one block's hits and colours, but for pixels beside the picture.
static void save_probed(const TileHits *hits, LaneColors colors, int x, int y, int block, int width,
                        int height, global HitAnswer *answers, write_only image2d_t image)
{
    float lanes[4][LANES];
    uint spheres[LANES];
    JOIN(vstore, LANES)(colors.r, 0, lanes[0]);
    JOIN(vstore, LANES)(colors.g, 0, lanes[1]);
    JOIN(vstore, LANES)(colors.b, 0, lanes[2]);
    JOIN(vstore, LANES)(hits->t[block], 0, lanes[3]);
    JOIN(vstore, LANES)(hits->sphere[block], 0, spheres);
    for (int lane = 0; lane < LANES; lane++) {
        const int number = block * LANES + lane;
        const int to_x = x + number % TILE_WIDTH, to_y = y + number / TILE_WIDTH;
        if (to_x < width && to_y < height) {
            answers[to_y * width + to_x].t = lanes[3][lane];
            answers[to_y * width + to_x].sphere = spheres[lane];
            write_imagef(image, (int2)(to_x, to_y),
                         (float4)(lanes[0][lane], lanes[1][lane], lanes[2][lane], 1.0f));
        }
    }
}

// As render_tiles, with colours that are not rounded to bytes, and with the hits.
kernel void probe_tiles(global const Sphere *spheres, global const uint *material_ids,
                        global const Material *materials, global const Light *lights, int n_lights,
                        Vec3 background, Camera camera, int width, int height,
                        write_only image2d_t image, global const KdNode3 *nodes,
                        global const uint *sphere_ids, BBox3D bounds,
                        global const Sphere *leaf_spheres, global HitAnswer *answers,
                        global Work *d_work)
{
    const int x = get_global_id(0) * TILE_WIDTH;
    const int y = get_global_id(1) * TILE_HEIGHT;
    const Shading shading = {spheres, material_ids, materials, lights, n_lights, background};
    Tile tile;
    TileHits hits;
    Work work = {0, 0, 0, 0};
    tile_create(x, y, width, height, camera, &tile);
    trace_tile(&tile, nodes, sphere_ids, leaf_spheres, bounds, &hits, &work);
    for (int block = 0; block < N_BLOCKS; block++) {
        const LaneColors colors = shade_block(&tile, block, &hits, &shading);
        save_probed(&hits, colors, x, y, block, width, height, answers, image);
    }
    save_work(work, x, y, width, height, d_work);
}

// ---- Part A -------------------------------------------------------------------------------------

kernel void probe_circle_rows(global const CircleRowJob *jobs, global CircleRowAnswer *answers)
{
    const size_t i = get_global_id(0);
    const CircleRowJob job = jobs[i];
    LaneInts open = JOIN(vload, LANES)(0, job.open);
    LaneUints colors = JOIN(vload, LANES)(0, job.colors);
    paint_row(JOIN(vload, LANES)(0, job.dx_squared), job.dy, job.radius_squared, job.color, &open,
              &colors);
    JOIN(vstore, LANES)(open, 0, answers[i].open);
    JOIN(vstore, LANES)(colors, 0, answers[i].colors);
}

kernel void probe_tile_leaves(global const CircleTileJob *jobs, global const TileNode *nodes,
                              global TileLeafAnswer *answers)
{
    const size_t i = get_global_id(0);
    const CircleTileJob job = jobs[i];
    Work work = {0, 0, 0, 0};
    answers[i].leaf = tile_leaf(job.x, job.y, nodes + job.first_node, &work);
    answers[i].n_steps = work.n_nodes_visited;
}

kernel void probe_circle_tiles(global const CircleTileJob *jobs, global const TileNode *nodes,
                               global const TileCircle *leaf_circles,
                               global CircleTileAnswer *answers)
{
    const size_t i = get_global_id(0);
    const CircleTileJob job = jobs[i];
    Work work = {0, 0, 0, 0};
    const CircleTile tile =
        draw_tile(job.x, job.y, nodes + job.first_node, leaf_circles + job.first_circle, &work);
    for (int row = 0; row < LANES; row++) {
        JOIN(vstore, LANES)(tile.colors[row], row, answers[i].colors);
    }
    answers[i].n_tests = work.n_tests;
}

// Inputs of lab 08's surface_area and split_cost that the building of the scenes' trees sends: see
// judge_08.h, sent.h.
#include "judge_08.h"
#include "sent.h"

// Spheres of a scene in a cell, with those that only touch it.
static u32 count_in(const Scene3D *scene, BBox3D cell)
{
    u32 n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += tree3d_judge_sphere(scene->spheres[i], cell) != SPHERE_OUTSIDE;
    }
    return n;
}

// The calls for an inner node: for its own plane, or for any other candidate.
static void keep_node(Random *random, const Scene3D *scene, BBox3D cell, KdNode3 node, Sent *areas,
                      Sent *costs)
{
    const int is_own = random_integer(random, 0, 1) == 0;
    const u32 axis = is_own ? node.split_axis : (u32)random_integer(random, 0, 2);
    const int number = (int)random_integer(random, 1, SAH_BINS - 1);
    CostJob job = {.box = cell,
                   .axis = axis,
                   .pos = is_own ? node.split_pos : sah_plane_at(cell, axis, number)};
    const BBox3D lower = sah_lower(job), higher = sah_higher(job);
    job.n_lower = count_in(scene, lower);
    job.n_higher = count_in(scene, higher);
    sent_keep(areas, random, &cell);
    sent_keep(areas, random, &lower);
    if (sah_area(cell) > 0) {
        sent_keep(costs, random, &job);
    }
}

// Follow the expected tree down from a node.
static void keep_nodes(Random *random, const TreeScene3D *scene, u32 id, BBox3D cell, Sent *areas,
                       Sent *costs)
{
    const KdNode3 node = scene->tree.nodes[id];
    if (node.split_axis == KD_LEAF) {
        return;
    }
    keep_node(random, &scene->scene, cell, node, areas, costs);
    BBox3D lower = cell, higher = cell;
    lower.max[node.split_axis] = higher.min[node.split_axis] = node.split_pos;
    keep_nodes(random, scene, node.first, lower, areas, costs);
    keep_nodes(random, scene, node.first + 1, higher, areas, costs);
}

void add_sent_08(Random *random, Job08 *job)
{
    Sent areas = SENT_TO(job->areas, N_SENT), costs = SENT_TO(job->costs, N_SENT);
    for (int k = 0; k < N_TREES; k++) {
        keep_nodes(random, &job->scenes[k], 0, job->scenes[k].tree.bounds, &areas, &costs);
    }
}

// Lab 10: what the rays of a tile hit first: one search through the tree for all of them. Nothing
// to fill in here; lay it beside trace.cl of lab 07.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_tiles.cl and tile_light.cl.
#include "cone.cl"
#include "intervals.cl"
#include "ray.h"
#include "sphere.h"
#include "work.h"

// Test a sphere for LANES rays at once: intersect_sphere() of lab 05 and the leaf's rule of lab 07,
// without a branch. Not even where all lanes miss: that was measured to take longer than the root
// that it saves.
//   centre       seen from the eye
//   radius, id   the sphere's; the radius may be negative
static void intersect_block(const Tile *tile, int block, float3 centre, float radius, uint id,
                            TileHits *hits)
{
    const Lanes b =
        centre.x * tile->x[block] + centre.y * tile->y[block] + centre.z * tile->z[block];
    const Lanes x = centre.x - b * tile->x[block];
    const Lanes y = centre.y - b * tile->y[block];
    const Lanes z = centre.z - b * tile->z[block];
    const Lanes disc = radius * radius - (x * x + y * y + z * z);
    const Lanes half_chord = sqrt(disc);  // NaN where the ray misses: every comparison then fails
    const Lanes t_near = radius > 0.0f ? b - half_chord : -1.0f;
    const Lanes t_far = b + half_chord;
    const Lanes t = select(t_far, t_near, t_near > 0.0f);
    const Lanes best = hits->t[block];
    const LaneInts wins = (t > 0.0f) & ((t < best) | ((t == best) & (id < hits->sphere[block])));
    hits->t[block] = select(best, t, wins);
    hits->sphere[block] = select(hits->sphere[block], (LaneUints)id, wins);
}

// Test the spheres of a leaf, except for those that the whole tile misses.
//   leaf_spheres   one for each entry of sphere_ids: what a leaf tests is side by side in memory
//   work           what the tile has cost so far
static void search_tile_leaf(const Tile *tile, KdNode3 node, global const uint *sphere_ids,
                             global const Sphere *leaf_spheres, TileHits *hits, Work *work)
{
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const Sphere sphere = leaf_spheres[i];
        const float3 centre = (float3)(sphere.x, sphere.y, sphere.z) - tile->eye;
        if (cone_misses_sphere(tile->cone, centre, sphere.radius)) {
            continue;
        }
        count_test(work);
        for (int block = 0; block < N_BLOCKS; block++) {
            intersect_block(tile, block, centre, sphere.radius, sphere_ids[i], hits);
        }
    }
}

// The farthest of a tile's hits; INFINITY as long as a ray has none.
static float farthest_hit(const TileHits *hits)
{
    Lanes farthest = hits->t[0];
    for (int block = 1; block < N_BLOCKS; block++) {
        farthest = fmax(farthest, hits->t[block]);
    }
    return largest_lane(farthest);
}

// The part of the rays that lies inside the scene's box: from the last of the first entries to the
// first of the last exits. Returns 1, or 0 when no ray meets the box.
static int clip_tile_to_box(BBox3D box, const float *eye, const Interval *directions, TodoEntry *at)
{
    for (uint axis = 0; axis < 3; axis++) {
        const Interval to_min = plane_interval(box.min[axis], eye[axis], directions[axis]);
        const Interval to_max = plane_interval(box.max[axis], eye[axis], directions[axis]);
        // An eye on a plane counts to its lower side, as in plane_interval().
        if (eye[axis] <= box.min[axis]) {
            at->t_min = fmax(at->t_min, to_min.low);
            at->t_max = fmin(at->t_max, to_max.high);
        } else if (eye[axis] > box.max[axis]) {
            at->t_min = fmax(at->t_min, to_max.low);
            at->t_max = fmin(at->t_max, to_min.high);
        } else {
            // The eye is between them: a ray meets one of the two, and the other at INFINITY.
            at->t_max = fmin(at->t_max, fmin(to_min.high, to_max.high));
        }
    }
    // Where nothing is met, both are INFINITY.
    return at->t_min <= at->t_max && at->t_min < INFINITY;
}

// Go down to the next leaf that some ray meets.
//   eye, directions   of the tile's rays, on each axis
//   at                in: a node, and the part of the rays inside it; out: the leaf, likewise
//   todo              out: where both children were met, the far ones on top
// Returns the leaf.
static KdNode3 descend_to_leaf(global const KdNode3 *nodes, const float *eye,
                               const Interval *directions, TodoEntry *at, Todo *todo, Work *work)
{
    KdNode3 node = nodes[at->node];
    while (node.split_axis != KD_LEAF) {
        const uint axis = node.split_axis;
        count_node(work);
        const Interval t_split = plane_interval(node.split_pos, eye[axis], directions[axis]);
        *at = next_tile_child(node, eye[axis], t_split, *at, todo);
        count_waiting(work, todo->n);
        node = nodes[at->node];
    }
    count_leaf(work);
    return node;
}

// What the rays of a tile hit first.
//   nodes, sphere_ids, bounds   the scene's kd-tree (kdtree3d.h); node 0 is the root
//   leaf_spheres                see search_tile_leaf()
//   hits                        out: as trace() of lab 07 finds it for each ray
//   work                        what the tile has cost so far
static void trace_tile(const Tile *tile, global const KdNode3 *nodes, global const uint *sphere_ids,
                       global const Sphere *leaf_spheres, BBox3D bounds, TileHits *hits, Work *work)
{
    for (int block = 0; block < N_BLOCKS; block++) {
        hits->t[block] = INFINITY;
        hits->sphere[block] = NO_SPHERE;
    }
    const float eye[3] = {tile->eye.x, tile->eye.y, tile->eye.z};
    TodoEntry at = {0, 0.0f, INFINITY};
    if (!clip_tile_to_box(bounds, eye, tile->directions, &at)) {
        return;
    }
    Todo todo;
    todo.n = 0;
    for (;;) {
        const KdNode3 node = descend_to_leaf(nodes, eye, tile->directions, &at, &todo, work);
        search_tile_leaf(tile, node, sphere_ids, leaf_spheres, hits, work);
        if (!next_tile_waiting(farthest_hit(hits), &todo, &at)) {
            return;
        }
    }
}

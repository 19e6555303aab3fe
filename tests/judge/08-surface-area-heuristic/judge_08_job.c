// Rolling lab 08's job from the seed: see judge_08.h.
//
// The functions' inputs are on coarse grids: sides are multiples of 4, so that planes are multiples
// of 1/8, and so are the spheres' ranges. Whether a range begins before a plane, at it or behind it
// is exact in float. Behind those that are rolled stand the edges, which no seed may miss.
#include "judge_08.h"

#include "random3d.h"

#include <float.h>
#include <math.h>

// A cell whose candidate planes are on the grid.
static BBox3D roll_cell(Random *random)
{
    BBox3D cell;
    for (int axis = 0; axis < 3; axis++) {
        cell.min[axis] = (float)random_integer(random, -40, 40);
        cell.max[axis] = cell.min[axis] + 4 * (float)random_integer(random, 1, 16);
    }
    return cell;
}

// ---- surface_area -------------------------------------------------------------------------------

// A point, lines, a face; tiny and large boxes; one far from 0; two that overflow in float: the one
// in its area, the other in a side already.
static const BBox3D odd_boxes[] = {
    {{3, 4, 5}, {3, 4, 5}},
    {{0, 0, 0}, {0, 0, 7}},
    {{0, 0, 0}, {5, 0, 0}},
    {{1, 2, 3}, {1, 4, 8}},
    {{1, 2, 3}, {4, 2, 8}},
    {{1, 2, 3}, {4, 8, 3}},
    {{0, 0, 0}, {0x1p-20f, 0x1p-21f, 0x1p-22f}},
    {{0, 0, 0}, {0x1p20f, 0x1p19f, 0x1p18f}},
    {{0x1p20f, -0x1p20f, 0}, {0x1p20f + 2, -0x1p20f + 3, 4}},
    {{0, 0, 0}, {0x1p70f, 0x1p69f, 0x1p68f}},
    {{-0x1.8p127f, 1, 2}, {0x1.8p127f, 2, 4}},
};

static BBox3D roll_box(Random *random, int i)
{
    const int edge = edge_of(i, N_AREAS, COUNT(odd_boxes));
    if (edge >= 0) {
        return odd_boxes[edge];
    }
    BBox3D box;
    for (int axis = 0; axis < 3; axis++) {
        box.min[axis] = random_eighth(random, -50, 50);
        box.max[axis] = box.min[axis] + random_eighth(random, 1, 40);
    }
    if (i >= N_BOXES) {
        const int flat = i % 3;
        box.max[flat] = box.min[flat];
    }
    return box;
}

// ---- split_cost ---------------------------------------------------------------------------------

// The same, as if each unit were 256.
static BBox3D smaller_cell(BBox3D cell)
{
    for (int axis = 0; axis < 3; axis++) {
        cell.min[axis] /= 256;
        cell.max[axis] /= 256;
    }
    return cell;
}

static CostJob roll_cost(Random *random, int i)
{
    if (i == N_COSTS - 1) {  // more than an int holds, but the sum is a u32 still
        return (CostJob){{{0, 0, 0}, {64, 32, 32}}, 0, 16, 3000000000, 1000000000};
    }
    if (i == N_COSTS - 2) {  // none at all: the step to a child is paid all the same
        return (CostJob){{{0, 0, 0}, {64, 32, 32}}, 0, 16, 0, 0};
    }
    CostJob job = {.box = roll_cell(random)};
    if (i < N_PLANES && i % 3 == 0) {  // areas that are no whole numbers
        job.box = smaller_cell(job.box);
    }
    job.axis = (u32)random_integer(random, 0, 2);
    job.n_lower = (u32)random_integer(random, 1, 60);
    job.n_higher = (u32)random_integer(random, 1, 60);
    int number = (int)random_integer(random, 1, SAH_BINS - 1);
    switch (i < N_PLANES ? -1 : i % 5) {
    case 0:  // on the border
        number = random_integer(random, 0, 1) ? 0 : SAH_BINS;
        break;
    case 1:
        job.n_lower = 0;
        break;
    case 2:
        job.n_higher = 0;
        break;
    case 3:  // a flat cell, split across a side with a length or across the one without
        job.box.max[(job.axis + (u32)i) % 3] = job.box.min[(job.axis + (u32)i) % 3];
        break;
    case 4:  // more spheres than a short or a float holds one by one
        job.n_lower = 3000000 + (u32)random_integer(random, 0, 10000);
        job.n_higher = (u32)random_integer(random, 0, 70000);
        break;
    default:
        break;
    }
    const float side = job.box.max[job.axis] - job.box.min[job.axis];
    job.pos = job.box.min[job.axis] + side * (float)number / SAH_BINS;
    return job;
}

// ---- find_best_split ----------------------------------------------------------------------------

// The spheres of input number i stand in every second place from here on.
static u32 first_sphere(int i)
{
    return 2 * MOST_IDS * (u32)i;
}

// Give a node one sphere more.
static void add_sphere(Job08 *job, int i, const float centre[3], float radius)
{
    BestJob *node = &job->bests[i];
    const u32 at = first_sphere(i) + 2 * node->n_ids + 1;
    job->best_ids[node->first_id + node->n_ids++] = at;
    job->best_spheres[at] = (Sphere){centre[0], centre[1], centre[2], radius};
}

static void begin_node(Job08 *job, int i, BBox3D cell)
{
    job->bests[i] = (BestJob){cell, MOST_IDS * (u32)i, 0};
    // Whom its ids leave out: larger than the cell, so that it would count everywhere.
    const u32 most_ids = i == MANY_NODE ? N_MANY_IDS : MOST_IDS;
    for (u32 j = 0; j < 2 * most_ids; j += 2) {
        job->best_spheres[first_sphere(i) + j] = (Sphere){cell.min[0], cell.min[1], 0, 512};
    }
}

// Spheres of any size within the cell or over its border. In every third cell they stand together
// in a corner; in the second half some radii are negative.
static void roll_node(Random *random, Job08 *job, int i)
{
    const BBox3D cell = roll_cell(random);
    begin_node(job, i, cell);
    const int n = (int)random_integer(random, 2, i % 4 == 1 ? MOST_IDS : 40);
    const int share = i % 3 == 0 ? 4 : 1;
    const int max_radius = (int)random_integer(random, 1, 6);
    for (int j = 0; j < n; j++) {
        float centre[3];
        for (int axis = 0; axis < 3; axis++) {
            const int side = (int)(cell.max[axis] - cell.min[axis]);
            centre[axis] = cell.min[axis] + random_eighth(random, 0, side / share);
        }
        const int sign = i > N_CELLS / 2 && j % 4 == 0 ? -1 : 1;
        add_sphere(job, i, centre, random_eighth(random, 0, max_radius) * (float)sign);
    }
}

// Add a sphere and its mirror images in the three planes through the cell's middle.
static void add_mirrored(Job08 *job, int i, const float middle[3], const float offset[3],
                         float radius)
{
    for (int image = 0; image < 8; image++) {
        float centre[3];
        for (int axis = 0; axis < 3; axis++) {
            centre[axis] = middle[axis] + (image >> axis & 1 ? -offset[axis] : offset[axis]);
        }
        add_sphere(job, i, centre, radius);
    }
}

// A few spheres around the middle of a cell, all of which reach over it: the best there is to do is
// to cut off what is empty. That costs the same on both sides, and on all axes where the cell is
// longest: on all three, on y and z, on z alone, on x and y.
static void roll_tie(Random *random, Job08 *job, int i)
{
    static const float shares[4][3] = {
        {1, 1, 1}, {0.125f, 1, 1}, {0.25f, 0.25f, 1}, {1, 1, 0.125f}};
    const float side = 8 * (float)random_integer(random, 4, 8);
    BBox3D cell;
    float middle[3];
    for (int axis = 0; axis < 3; axis++) {
        cell.min[axis] = (float)random_integer(random, -20, 20);
        cell.max[axis] = cell.min[axis] + side * shares[i % 4][axis];
        middle[axis] = (cell.min[axis] + cell.max[axis]) / 2;
    }
    begin_node(job, i, cell);
    const int n = (int)random_integer(random, 1, 3);
    for (int j = 0; j < n; j++) {
        const float radius = random_eighth(random, 1, 2);
        const float distance = (float)random_integer(random, 0, 8) / 8;
        const float offset[3] = {distance, distance, distance};
        add_mirrored(job, i, middle, offset, radius);
    }
}

// ---- Cells of their own kind: in every job, with other axes, sides and sizes --------------------

// How an odd cell is made.
typedef struct OddCell {
    float sides[3];
    int n;
    float at[3];    // of the first sphere, from the cell's lowest corner
    float step[3];  // to the next one
    float radius;
} OddCell;

static const OddCell odd_cells[] = {
    {{32, 64, 16}, 0, {0}, {0}, 0},                                 // no sphere
    {{32, 64, 16}, 1, {5, 50, 3}, {0}, 2},                          // one
    {{64, 32, 32}, 1, {4, 4, 4}, {0}, 0},                           // a point
    {{64, 64, 64}, 20, {1, 1, 1}, {0.125f, 0.125f, 0.125f}, 0.5f},  // all in one bin
    {{64, 64, 64}, 20, {63, 63, 63}, {-0.125f, -0.125f, 0}, 0.5f},
    {{32, 32, 64}, 12, {8, 8, 40}, {0}, 3},          // at one place
    {{32, 32, 64}, 12, {8, 8, 40}, {0}, -3},         // seen from inside
    {{64, 32, 16}, 12, {2, 2, 2}, {5, 2, 1}, 0},     // points, some on planes
    {{64, 32, 16}, 9, {32, 16, 8}, {0, 0, 0}, 128},  // through all of the cell
    {{64, 32, 16}, 12, {4, 4, 4}, {4, 0, 0}, 2},     // touching planes from both sides
    {{0, 32, 64}, 8, {0, 3, 3}, {0, 3, 8}, 1},       // flat cells
    {{32, 0, 64}, 8, {3, 0, 3}, {3, 0, 8}, 1},
    {{32, 64, 0}, 8, {3, 3, 0}, {3, 8, 0}, 1},
    {{64, 0, 0}, 6, {4, 0, 0}, {8, 0, 0}, 0},  // a line and a point: no area
    {{0, 0, 0}, 3, {0, 0, 0}, {0, 0, 0}, 0},
    {{64, 64, 64}, 2, {0, 32, 32}, {64, 0, 0}, 1},  // at both ends: the middle is empty
    {{64, 64, 64}, 2, {32, 32, 0}, {0, 0, 64}, 1},
    {{0x1p15f, 0x1p15f, 0x1p14f}, 10, {1, 1, 1}, {1024, 2048, 512}, 256},
    {{64, 16, 16}, 4, {33, 8, 8}, {0}, 30},  // only the first bin is empty, only the last one
    {{64, 16, 16}, 4, {31, 8, 8}, {0}, 30},
    // One sphere before the last plane and one behind it: the best one whatever stub weighs.
    {{64, 16, 16}, 2, {31, 8, 8}, {61.5f, 0, 0}, 30},
    // The longest side's plane is cheaper than the next one's, by little: some 1e-4 and 1e-5.
    {{64, 64.125f, 64.25f}, 1, {32, 32, 32}, {0}, 1},
    {{64, 64.015625f, 64.03125f}, 1, {32, 32, 32}, {0}, 1},
};

// Each of them comes in three turns, so that what it has along x is along y and z, too: first as it
// is here, then mirrored, then mirrored at random. At random it is larger or smaller by a power of
// two, which moves no range across a plane.
static void roll_odd_cell(Random *random, Job08 *job, int i)
{
    const int k = i - N_CELLS - N_TIES, turn = k / (int)COUNT(odd_cells);
    const OddCell *odd = &odd_cells[k % (int)COUNT(odd_cells)];
    const float scale = ldexpf(1, (int)random_integer(random, -1, 2));
    BBox3D cell;
    float centre[3], step[3];
    for (int axis = 0; axis < 3; axis++) {
        const int from = (axis + turn) % 3;
        const int is_mirrored = turn < 2 ? turn : (int)random_integer(random, 0, 1);
        const float at = is_mirrored ? odd->sides[from] - odd->at[from] : odd->at[from];
        cell.min[axis] = scale * (float)random_integer(random, -20, 20);
        cell.max[axis] = cell.min[axis] + scale * odd->sides[from];
        centre[axis] = cell.min[axis] + scale * at;
        step[axis] = scale * (is_mirrored ? -odd->step[from] : odd->step[from]);
    }
    begin_node(job, i, cell);
    for (int j = 0; j < odd->n; j++) {
        add_sphere(job, i, centre, scale * odd->radius);
        for (int axis = 0; axis < 3; axis++) {
            centre[axis] += step[axis];
        }
    }
}

// In one bin more spheres than 8 or 16 bits count; what these hold of them is too few.
static void roll_many(Job08 *job)
{
    const BBox3D cell = {{-32, -32, -32}, {32, 32, 32}};
    const float centre[3] = {-31, -31, -31};
    begin_node(job, MANY_NODE, cell);
    for (int j = 0; j < N_MANY_IDS; j++) {
        add_sphere(job, MANY_NODE, centre, 0.5f);
    }
}

static void roll_best(Random *random, Job08 *job, int i)
{
    if (i == MANY_NODE) {
        roll_many(job);
    } else if (i < N_CELLS) {
        roll_node(random, job, i);
    } else if (i < N_CELLS + N_TIES) {
        roll_tie(random, job, i);
    } else {
        roll_odd_cell(random, job, i);
    }
}

// ---- is_leaf_by_cost ----------------------------------------------------------------------------

// No spheres, one, many, more than 31 bits count; a split that costs nothing, one that costs a bit
// more than the leaf, and one that is none.
static const LeafCostJob odd_nodes[] = {
    {1, 0, 0, 20, 1},
    {1, 1, 0, 20, 1},
    {1, 2, 1, 20, 1},
    {1, 2, 0.875, 20, 1},
    {1, 2, 1.5, 20, 1},
    {1, 4000000, 1999999, 20, 1},
    {1, 4000000, 2000000, 20, 1},
    {1, 4000000, 2000001, 20, 1},
    {1, 3000000000, 1000000, 20, 1},
    {1, 50, INFINITY, 20, 1},
    {20, 50, 1, 20, 1},
    {19, 50, 1, 20, 1},
    {21, 50, 1, 20, 1},
    {1, 50, 1, 1, 1},
    {3, 8, 1, 20, 8},
    {3, 9, 1, 20, 8},
    {3, 7, 1, 20, 8},
};

static LeafCostJob roll_decision(Random *random, int i)
{
    const int edge = edge_of(i, N_DECISIONS, COUNT(odd_nodes));
    if (edge >= 0) {
        return odd_nodes[edge];
    }
    const int max_depth = (int)random_integer(random, 2, 40);
    const int target = (int)random_integer(random, 1, 9);
    const u32 n_spheres = (u32)target + (u32)random_integer(random, 4, 200);
    LeafCostJob job = {(i32)random_integer(random, 1, max_depth - 1), n_spheres,
                       SAH_TEST * n_spheres, max_depth, target};
    if (i < N_BY_COST && i % 4 == 0) {
        // Far from the leaf's cost; or a leaf by its level, whatever it costs.
        job.best_cost *= (double)random_integer(random, 1, 24) / 8;
        job.level = i % 16 == 0 ? max_depth : job.level;
        return job;
    }
    if (i < N_BY_COST) {
        // As much as the leaf, or by an eighth to some steps more or less.
        job.best_cost += (double)random_integer(random, -1, 1) *
                         (double)random_integer(random, 1, i % 2 == 0 ? 8 : 16) / 8;
        return job;
    }
    job.best_cost = 1;
    if (i % 2 == 0) {
        job.level = max_depth + (int)random_integer(random, -1, 1);
        job.level = job.level < 1 ? 1 : job.level;
    } else {
        job.n_spheres = (u32)(target + (int)random_integer(random, -1, 1));
        job.best_cost = 0.25 * job.n_spheres;
    }
    return job;
}

// ---- The job ------------------------------------------------------------------------------------

int roll_job_08(void *pointer, Random *random)
{
    Job08 *job = pointer;
    for (int i = 0; i < N_AREAS; i++) {
        job->areas[i] = roll_box(random, i);
    }
    for (int i = 0; i < N_COSTS; i++) {
        job->costs[i] = roll_cost(random, i);
    }
    for (int i = 0; i < N_BESTS; i++) {
        roll_best(random, job, i);
    }
    for (int i = 0; i < N_DECISIONS; i++) {
        job->decisions[i] = roll_decision(random, i);
    }
    if (roll_scenes_08(random, job) != 0) {
        return -1;
    }
    add_sent_08(random, job);
    return 0;
}

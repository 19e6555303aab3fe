// Rolling the inputs of lab 02's functions from the seed: see judge_02.h. What is rolled is on a
// grid of 1/16 pixel, so that no right answer depends on rounding.
//
// Behind it stand the edges, which no seed may miss: inputs that show a rare mistake. They come
// last, so that any other mistake is shown without them. On them, too, double decides exactly.
#include "judge_02.h"

#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "packed_list.h"

static BBox2D roll_box(Random *random)
{
    BBox2D box = {0};
    box.minX = random_grid(random, -100, 100);
    box.minY = random_grid(random, -100, 100);
    box.maxX = box.minX + random_grid(random, 1, 120);
    box.maxY = box.minY + random_grid(random, 1, 120);
    return box;
}

// Counts and limits that are others in 8 or 16 bits, or in 32, with a sign or without.
static const struct {
    u32 n_circles;
    i32 targetElementsPerNode;
} counts[] = {{0, 1},     {200, 4},   {256, 4},   {259, 4},   {299, 300},     {300, 300},
              {301, 300}, {40000, 4}, {65536, 8}, {65540, 8}, {3000000000, 8}};

// The last inputs of each of the three kinds. About the depth: the root alone, and levels that are
// others in 8 bits; about failed splits: more of them than there can be reasons to count. In each
// kind, too, where two reasons hold, or all: the answer is 1 all the same.
enum { N_LEAF_EDGES = 11 };
static const LeafJob leaf_edges[3][N_LEAF_EDGES] = {
    {
        {.level = 1, .maxDepth = 1, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 1, .maxDepth = 2, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 127, .maxDepth = 128, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 128, .maxDepth = 128, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 255, .maxDepth = 256, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 256, .maxDepth = 256, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 300, .maxDepth = 70000, .n_circles = 9, .targetElementsPerNode = 8},
        {.level = 4, .maxDepth = 4, .n_circles = 1, .targetElementsPerNode = 1},
        {.level = 5, .maxDepth = 4, .n_circles = 0, .targetElementsPerNode = 1},
        {4, 1, 4, 1, MAX_FAILED_SPLITS},
        {.level = 4, .maxDepth = 5, .n_circles = 2, .targetElementsPerNode = 1},
    },
    {
        {.level = 1, .maxDepth = 9, .n_circles = 0, .targetElementsPerNode = 1},
        {.level = 1, .maxDepth = 9, .n_circles = 1, .targetElementsPerNode = 1},
        {.level = 1, .maxDepth = 9, .n_circles = 2, .targetElementsPerNode = 1},
        {.level = 2, .maxDepth = 9, .n_circles = 65535, .targetElementsPerNode = 65536},
        {.level = 2, .maxDepth = 9, .n_circles = 65537, .targetElementsPerNode = 65536},
        {.level = 9, .maxDepth = 9, .n_circles = 8, .targetElementsPerNode = 8},
        {.level = 10, .maxDepth = 9, .n_circles = 7, .targetElementsPerNode = 8},
        {.level = 9, .maxDepth = 9, .n_circles = 0, .targetElementsPerNode = 8},
        {6, 8, 9, 8, MAX_FAILED_SPLITS},
        {9, 8, 9, 8, MAX_FAILED_SPLITS},
        {.level = 2, .maxDepth = 9, .n_circles = 3000000000, .targetElementsPerNode = 8},
    },
    {
        {9, 9, 14, 8, MAX_FAILED_SPLITS - 1},
        {9, 9, 14, 8, MAX_FAILED_SPLITS},
        {9, 9, 14, 8, MAX_FAILED_SPLITS + 1},
        {13, 9, 14, 8, 8},
        {13, 9, 14, 8, 12},
        {300, 9, 400, 8, 256},
        {14, 9, 14, 8, MAX_FAILED_SPLITS},
        {15, 9, 14, 8, MAX_FAILED_SPLITS + 1},
        {9, 8, 14, 8, MAX_FAILED_SPLITS},
        {14, 8, 14, 8, MAX_FAILED_SPLITS},
        {13, 9, 14, 8, MAX_FAILED_SPLITS - 1},
    },
};

// Of three inputs one is about the depth, one about the count and one about failed splits.
static LeafJob roll_leaf(Random *random, int i)
{
    const int last = edge_of(i / 3, N_LEAVES / 3, N_LEAF_EDGES);
    if (last >= 0) {
        return leaf_edges[i % 3][last];
    }
    const int edge = edge_of(i / 3, N_LEAVES / 3 - N_LEAF_EDGES, COUNT(counts));
    LeafJob job = {.maxDepth = (i32)random_integer(random, 1, 14)};
    job.targetElementsPerNode = (i32)random_integer(random, 1, 20);
    if (i % 3 == 0) {
        job.level = job.maxDepth + (i32)random_integer(random, -1, 1);
        job.n_circles = (u32)job.targetElementsPerNode + (u32)random_integer(random, 1, 50);
    } else if (i % 3 == 1) {
        job.maxDepth += 2;
        job.level = (i32)random_integer(random, 1, job.maxDepth - 1);
        job.n_circles = (u32)(job.targetElementsPerNode + random_integer(random, -1, 1));
        if (edge >= 0) {
            job.targetElementsPerNode = counts[edge].targetElementsPerNode;
            job.n_circles = counts[edge].n_circles;
        }
    } else {
        job.maxDepth += MAX_FAILED_SPLITS + 2;
        job.n_failed = (i32)random_integer(random, 0, MAX_FAILED_SPLITS + 1);
        job.level = (i32)random_integer(random, job.n_failed + 1, job.maxDepth - 1);
        job.n_circles = (u32)job.targetElementsPerNode + (u32)random_integer(random, 1, 50);
    }
    return job;
}

// The next float above 1 is 1 + STEP.
#define STEP 0x1p-23f

// Sides that are nearly equal: by less than a pixel, by a step of float, and by next to nothing in
// small cells; and a cell without a width, or a height.
static const BBox2D nearly_square[] = {
    {0, 10.25f, 0, 10.75f},
    {0.75f, 11, 0.25f, 11},
    {0, 10.4375f, 0, 10.5f},
    {-3.5f, 7, -3.75f, 7},
    {5, 5, 7, 9},
    {5, 9, 7, 7},
    {0, 1, 0, 1 + 0x1p-12f},
    {0, 1 + 0x1p-12f, 0, 1},
    {0, 1, 0, 1 + STEP},
    {0, 1 + STEP, 0, 1},
    {0, 4096, 0, 4096 + 0x1p-11f},
    {-1, 0, -1 - STEP, 0},
    {0, 0x1p-20f, 0, 0x1p-20f + 0x1p-30f},
    {0, 0x1p-20f + 0x1p-30f, 0, 0x1p-20f},
};

static BBox2D roll_split(Random *random, int i)
{
    const int edge = edge_of(i, N_SPLITS, COUNT(nearly_square));
    if (edge >= 0) {
        return nearly_square[edge];
    }
    BBox2D box = roll_box(random);
    if (i % 4 == 0) {
        box.maxY = box.minY + (box.maxX - box.minX);
    }
    return box;
}

// How near to touching a rolled circle of overlap-inside may be: that is for the other checks.
#define CLEARLY 0.25

// Does a circle touch the box, or nearly?
static int nearly_touches(BoxOverlapJob job)
{
    BoxOverlapJob smaller = job, larger = job;
    smaller.circle.radius -= CLEARLY;
    larger.circle.radius += CLEARLY;
    return oracle2d_overlaps_box(smaller.circle, job.box) !=
           oracle2d_overlaps_box(larger.circle, job.box);
}

// Large circles across thin cells, which hold neither their centres nor their tips, while they
// cover no corner; cells deep in a circle, circles deep in a cell; a cell before which a circle
// ends that is as large.
static const BoxOverlapJob across[] = {
    {{.x = 50, .y = 0, .radius = 10}, {0, 100, 5, 6}},
    {{.x = 50, .y = 0, .radius = 10}, {0, 100, -6, -5}},
    {{.x = 0, .y = 50, .radius = 10}, {5, 6, 0, 100}},
    {{.x = 0, .y = 50, .radius = 10}, {-6, -5, 0, 100}},
    {{.x = 50, .y = 0, .radius = 40}, {0, 100, 5, 6}},
    {{.x = 0, .y = 50, .radius = 40}, {-6, -5, 0, 100}},
    {{.x = 50, .y = 0, .radius = 4}, {0, 100, 5, 6}},
    {{.x = 0, .y = 50, .radius = 4}, {5, 6, 0, 100}},
    {{.x = 7, .y = -9, .radius = 500}, {20, 21, 30, 31}},
    {{.x = 40, .y = 60, .radius = 1}, {-1000, 1000, -2000, 1000}},
    {{.x = -990, .y = 60, .radius = 5}, {-1000, 1000, -2000, 1000}},
    {{.x = 100, .y = 100, .radius = 99}, {0, 1, 0, 1}},
};

// Circles of any place beside, in and around the box, its size or smaller.
static BoxOverlapJob roll_inside(Random *random, int i)
{
    const int edge = edge_of(i, N_INSIDE, COUNT(across));
    if (edge >= 0) {
        return across[edge];
    }
    BoxOverlapJob job = {.box = roll_box(random)};
    do {
        job.circle.x = random_grid(random, -150, 250);
        job.circle.y = random_grid(random, -150, 250);
        job.circle.radius = random_grid(random, 1, 100);
    } while (nearly_touches(job));
    return job;
}

// So small that every epsilon is larger, and its square still one of double's normal numbers. The
// cell beside it is as small: else the way over the cell's middle, right as it is, would round.
#define TINY 0x1p-70f
#define TINY_CELL {-8 * TINY, 0, -8 * TINY, 0}
// Two floats whose difference no float holds: 2^23 + 2^-4.
#define FAR 0x1p23f
#define BIT 0x1p-4f

// Circles of radius 0, which are points: within the box, on its border, in its corner, and beside
// it. Beside a side: large circles whose squared radius float would round down and up, and one that
// misses by a step of float; such whose distance float would round, down and up; tiny circles, one
// that misses by a fifth, and one that touches a corner.
static const BoxOverlapJob beside[] = {
    {{.x = 4, .y = 4}, {0, 8, 0, 8}},
    {{.x = 0, .y = 4}, {0, 8, 0, 8}},
    {{.x = 4, .y = 0}, {0, 8, 0, 8}},
    {{.x = 4, .y = 8}, {0, 8, 0, 8}},
    {{.x = 0, .y = 0}, {0, 8, 0, 8}},
    {{.x = TINY, .y = -4 * TINY}, TINY_CELL},
    {{.x = 8, .y = 4}, {0, 8, 0, 8}},
    {{.x = 8, .y = 8}, {0, 8, 0, 8}},
    {{.x = 8.0625f, .y = 4}, {0, 8, 0, 8}},
    {{.x = 8, .y = -0.0625f}, {0, 8, 0, 8}},
    {{.x = 64 + 4097, .y = 32, .radius = 4097}, {0, 64, 0, 64}},
    {{.x = 32, .y = -4099, .radius = 4099}, {0, 64, 0, 64}},
    {{.x = 64 + 4097 + 0x1p-11f, .y = 32, .radius = 4097}, {0, 64, 0, 64}},
    {{.x = -FAR, .y = 0, .radius = FAR}, {BIT, 1, -1, 1}},
    {{.x = 0, .y = FAR, .radius = FAR}, {-1, 1, -1, -BIT}},
    {{.x = 0, .y = -FAR, .radius = FAR}, {-1, 1, BIT, 1}},
    {{.x = FAR, .y = 0, .radius = FAR}, {-1, -BIT, -1, 1}},
    {{.x = -FAR, .y = 0, .radius = FAR}, {0, 1, -1, 1}},
    {{.x = 1 - FAR, .y = 0, .radius = FAR}, {1 + 3 * BIT, 2, -1, 1}},
    {{.x = 5 * TINY, .y = -4 * TINY, .radius = 5 * TINY}, TINY_CELL},
    {{.x = 6 * TINY, .y = -4 * TINY, .radius = 5 * TINY}, TINY_CELL},
    {{.x = -4 * TINY, .y = 6 * TINY, .radius = 5 * TINY}, TINY_CELL},
    {{.x = 3 * TINY, .y = 4 * TINY, .radius = 5 * TINY}, TINY_CELL},
};

// A circle that touches a side from outside, or a corner by a Pythagorean triple; or misses it by a
// sixteenth of a pixel.
static BoxOverlapJob roll_boundary(Random *random, int i)
{
    const int edge = edge_of(i, N_BOUNDARY, COUNT(beside));
    if (edge >= 0) {
        return beside[edge];
    }
    static const int triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}};
    BoxOverlapJob job = {.box = roll_box(random)};
    const BBox2D box = job.box;
    const int high_x = (int)random_integer(random, 0, 1),
              high_y = (int)random_integer(random, 0, 1);
    const int kind = (int)random_integer(random, 0, 2);
    const int *triple = triples[random_integer(random, 0, 3)];
    const float miss = random_integer(random, 0, 3) == 0 ? 0.0625f : 0;
    job.circle.radius = (float)triple[2];
    const float dx = kind == 0 ? (float)triple[0] : (float)triple[2];
    const float dy = kind == 0 ? (float)triple[1] : (float)triple[2];
    job.circle.x = high_x ? box.maxX + dx + miss : box.minX - dx - miss;
    job.circle.y = high_y ? box.maxY + dy + miss : box.minY - dy - miss;
    if (kind == 1) {
        job.circle.y = (box.minY + box.maxY) / 2;
    } else if (kind == 2) {
        job.circle.x = (box.minX + box.maxX) / 2;
    }
    return job;
}

// Beyond a corner: whole numbers with a² + b² = c² + 1, too large for float, which takes both
// sides for equal; the same, small and tiny; and 1 + 2^-52, which double holds, and whose root it
// rounds to 1, and 1 + 2^-50, of which it does not.
static const BoxOverlapJob beyond[] = {
    {{.x = 64 + 738, .y = 64 + 4031, .radius = 4098}, {0, 64, 0, 64}},
    {{.x = -1576, .y = 64 + 3785, .radius = 4100}, {0, 64, 0, 64}},
    {{.x = 64 + 2782, .y = -3009, .radius = 4098}, {0, 64, 0, 64}},
    {{.x = 0.25f, .y = 0.4375f, .radius = 0.5f}, {-1, 0, -1, 0}},
    {{.x = 0, .y = 0, .radius = 1}, {1, 2, 0x1p-26f, 1}},
    {{.x = 0, .y = 0, .radius = 1}, {-1, -0x1p-26f, -2, -1}},
    {{.x = 0, .y = 0, .radius = 1}, {1, 2, 0x1p-25f, 1}},
    {{.x = 0, .y = 0, .radius = 0x1p20f}, {0x1p20f, 0x1p21f, 0x1p-6f, 1}},
    {{.x = 4 * TINY, .y = 7 * TINY, .radius = 8 * TINY}, TINY_CELL},
};

// A circle beyond a corner, nearer than its radius on each axis: the square overlaps, the circle
// may not.
static BoxOverlapJob roll_corner(Random *random, int i)
{
    const int edge = edge_of(i, N_CORNER, COUNT(beyond));
    if (edge >= 0) {
        return beyond[edge];
    }
    BoxOverlapJob job = {.box = roll_box(random)};
    const BBox2D box = job.box;
    job.circle.radius = random_grid(random, 4, 60);
    const float dx = job.circle.radius * (float)random_integer(random, 8, 15) / 16;
    const float dy = job.circle.radius * (float)random_integer(random, 2, 15) / 16;
    job.circle.x = random_integer(random, 0, 1) ? box.maxX + dx : box.minX - dx;
    job.circle.y = random_integer(random, 0, 1) ? box.maxY + dy : box.minY - dy;
    return job;
}

// Long lists: all circles of the scene in one cell, some of them, and none; a list of one; and an
// empty one, though ids[0] is a circle that overlaps the cell.
static DistributeJob list_of_many(int edge, const Scene2D *scene)
{
    const BBox2D all = oracle2d_root(scene);
    const BBox2D cells[] = {all, {0, 100, 0, 75}, {all.maxX + 1, all.maxX + 9, 0, 8}, all, all};
    const u32 n_ids[] = {DISTRIBUTE_MAX_IDS, DISTRIBUTE_MAX_IDS, DISTRIBUTE_MAX_IDS, 1, 0};
    DistributeJob job = {.child = cells[edge], .n_ids = n_ids[edge]};
    for (u32 i = 0; i < job.n_ids; i++) {
        job.ids[i] = i;
    }
    return job;
}

// Some of the scene's circles, ascending with gaps, and a cell.
static DistributeJob roll_distribute(Random *random, int i, const Scene2D *scene)
{
    enum { N_EDGES = 5, MOST_IDS = 48 };
    const int edge = edge_of(i, N_DISTRIBUTES, N_EDGES);
    if (edge >= 0) {
        return list_of_many(edge, scene);
    }
    DistributeJob job = {0};
    for (u32 id = 1; id < (u32)scene->n_circles && job.n_ids < MOST_IDS; id++) {
        if (random_integer(random, 0, 2) == 0) {
            job.ids[job.n_ids++] = id;
        }
    }
    job.child.minX = random_grid(random, 0, scene->width - 20);
    job.child.minY = random_grid(random, 0, scene->height - 20);
    job.child.maxX = job.child.minX + random_grid(random, 10, 80);
    job.child.maxY = job.child.minY + random_grid(random, 10, 80);
    return job;
}

void roll_inputs_02(Random *random, Job02 *job)
{
    for (int i = 0; i < N_LEAVES; i++) {
        job->leaves[i] = roll_leaf(random, i);
    }
    for (int i = 0; i < N_SPLITS; i++) {
        job->splits[i] = roll_split(random, i);
    }
    for (int i = 0; i < N_OVERLAPS; i++) {
        const int j = i - N_INSIDE;
        job->overlaps[i] = j < 0            ? roll_inside(random, i)
                           : j < N_BOUNDARY ? roll_boundary(random, j)
                                            : roll_corner(random, j - N_BOUNDARY);
    }
    for (int i = 0; i < N_DISTRIBUTES; i++) {
        job->distributes[i] = roll_distribute(random, i, &job->scenes[DISTRIBUTE_SCENE].scene);
    }
    for (int i = 0; i < N_PACKS; i++) {
        job->packs[i] = pack_roll(random, edge_of(i, N_PACKS, N_PACK_EDGES), 1);
    }
}

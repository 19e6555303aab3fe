// Drawing lab 02's job from the seed: see judge_02.h. What is drawn is on a grid of 1/16 pixel, so
// that no right answer depends on rounding.
//
// Behind it stand the edges, which no seed may miss: inputs that show a rare mistake. They come
// last, so that any other mistake is shown without them. On them, too, double decides exactly.
#include "judge_02.h"

#include "oracle2d.h"
#include "oracle2d_tree.h"

static BBox2D draw_box(Random *random)
{
    BBox2D box = {0};
    box.minX = random_grid(random, -100, 100);
    box.minY = random_grid(random, -100, 100);
    box.maxX = box.minX + random_grid(random, 1, 120);
    box.maxY = box.minY + random_grid(random, 1, 120);
    return box;
}

// Counts and limits that are others in 8 or 16 bits, with a sign or without.
static const struct {
    u32 n_circles;
    i32 targetElementsPerNode;
} counts[] = {{0, 1},     {200, 4},   {256, 4},   {259, 4},   {299, 300},
              {300, 300}, {301, 300}, {40000, 4}, {65536, 8}, {65540, 8}};

// Of three inputs one is about the depth, one about the count and one about failed splits.
static LeafJob draw_leaf(Random *random, int i)
{
    const int edge = edge_of(i / 3, N_LEAVES / 3, COUNT(counts));
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

// Sides that are nearly equal: by a step of float, and by next to nothing in small cells.
static const BBox2D nearly_square[] = {
    {0, 1, 0, 1 + 0x1p-12f},
    {0, 1 + 0x1p-12f, 0, 1},
    {0, 1, 0, 1 + STEP},
    {0, 1 + STEP, 0, 1},
    {0, 4096, 0, 4096 + 0x1p-11f},
    {-1, 0, -1 - STEP, 0},
    {0, 0x1p-20f, 0, 0x1p-20f + 0x1p-30f},
    {0, 0x1p-20f + 0x1p-30f, 0, 0x1p-20f},
};

static BBox2D draw_split(Random *random, int i)
{
    const int edge = edge_of(i, N_SPLITS, COUNT(nearly_square));
    if (edge >= 0) {
        return nearly_square[edge];
    }
    BBox2D box = draw_box(random);
    if (i % 4 == 0) {
        box.maxY = box.minY + (box.maxX - box.minX);
    }
    return box;
}

// How near to touching a drawn circle of overlap-inside may be: that is for the other checks.
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

// Circles of any place beside, in and around the box, its size or smaller.
static BoxOverlapJob draw_inside(Random *random)
{
    BoxOverlapJob job = {.box = draw_box(random)};
    do {
        job.circle.x = random_grid(random, -150, 250);
        job.circle.y = random_grid(random, -150, 250);
        job.circle.radius = random_grid(random, 1, 100);
    } while (nearly_touches(job));
    return job;
}

// So small that every epsilon is larger.
#define TINY 0x1p-30f

// Circles of radius 0, which are points: within the box, on its border, in its corner, and beside
// it. Beside a side: large circles whose squared radius float would round down and up, and one that
// misses by a step of float; tiny circles, one that misses by a fifth, and one that
// touches a corner.
static const BoxOverlapJob beside[] = {
    {{.x = 4, .y = 4}, {0, 8, 0, 8}},
    {{.x = 8, .y = 4}, {0, 8, 0, 8}},
    {{.x = 8, .y = 8}, {0, 8, 0, 8}},
    {{.x = 8.0625f, .y = 4}, {0, 8, 0, 8}},
    {{.x = 8, .y = -0.0625f}, {0, 8, 0, 8}},
    {{.x = 64 + 4097, .y = 32, .radius = 4097}, {0, 64, 0, 64}},
    {{.x = 32, .y = -4099, .radius = 4099}, {0, 64, 0, 64}},
    {{.x = 64 + 4097 + 0x1p-11f, .y = 32, .radius = 4097}, {0, 64, 0, 64}},
    {{.x = 5 * TINY, .y = -0.5f, .radius = 5 * TINY}, {-1, 0, -1, 0}},
    {{.x = 6 * TINY, .y = -0.5f, .radius = 5 * TINY}, {-1, 0, -1, 0}},
    {{.x = -0.5f, .y = 6 * TINY, .radius = 5 * TINY}, {-1, 0, -1, 0}},
    {{.x = 3 * TINY, .y = 4 * TINY, .radius = 5 * TINY}, {-1, 0, -1, 0}},
};

// A circle that touches a side from outside, or a corner by a Pythagorean triple; or misses it by a
// sixteenth of a pixel.
static BoxOverlapJob draw_boundary(Random *random, int i)
{
    const int edge = edge_of(i, N_BOUNDARY, COUNT(beside));
    if (edge >= 0) {
        return beside[edge];
    }
    static const int triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}};
    BoxOverlapJob job = {.box = draw_box(random)};
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
// sides for equal; and the same, small and tiny.
static const BoxOverlapJob beyond[] = {
    {{.x = 64 + 738, .y = 64 + 4031, .radius = 4098}, {0, 64, 0, 64}},
    {{.x = -1576, .y = 64 + 3785, .radius = 4100}, {0, 64, 0, 64}},
    {{.x = 64 + 2782, .y = -3009, .radius = 4098}, {0, 64, 0, 64}},
    {{.x = 0.25f, .y = 0.4375f, .radius = 0.5f}, {-1, 0, -1, 0}},
    {{.x = 4 * TINY, .y = 7 * TINY, .radius = 8 * TINY}, {-1, 0, -1, 0}},
};

// A circle beyond a corner, nearer than its radius on each axis: the square overlaps, the circle
// may not.
static BoxOverlapJob draw_corner(Random *random, int i)
{
    const int edge = edge_of(i, N_CORNER, COUNT(beyond));
    if (edge >= 0) {
        return beyond[edge];
    }
    BoxOverlapJob job = {.box = draw_box(random)};
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
static DistributeJob draw_distribute(Random *random, int i, const Scene2D *scene)
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

// Empty leaves and the first one of a tree; then long lists, before the leaf and in it. Their ids
// are too large for 16 bits.
static const struct {
    u32 n_map, n_ids;
} leaves[] = {{5, 0}, {9, 0}, {0, 2}, {0, 0}, {PACK_MAX_IDS, 3}, {7, PACK_MAX_IDS}};

static PackJob draw_pack(Random *random, int i)
{
    enum { MOST_IDS = 24 };
    const int edge = edge_of(i, N_PACKS, COUNT(leaves));
    PackJob job = {.id = (u32)random_integer(random, 1, PACK_NODES - 1)};
    job.n_map = (u32)random_integer(random, 1, 20);
    job.n_ids = (u32)random_integer(random, 0, MOST_IDS);
    u32 id = (u32)random_integer(random, 0, 5);
    if (edge >= 0) {
        job.n_map = leaves[edge].n_map;
        job.n_ids = leaves[edge].n_ids;
        id += 90000;
    }
    for (u32 j = 0; j < job.n_ids; j++) {
        job.ids[j] = id;
        id += (u32)random_integer(random, 1, 90);
    }
    return job;
}

// Let some circles of a scene lie one upon another in its middle: no split parts them.
static void pile_up(Scene2D *scene)
{
    for (int i = 20; i < 32; i++) {
        scene->circles[i].x = (float)(scene->width / 2);
        scene->circles[i].y = (float)(scene->height / 2);
        scene->circles[i].radius = 16;
    }
}

// How many leaves of the scene's tree are empty? Returns -1 after one message.
static int count_empty_leaves(const Scene2D *scene, KdTreeLimits limits)
{
    Growth growth = {0};
    KdTree2D tree = {0};
    int n = oracle2d_tree(scene, 0, limits, &growth, &tree);
    for (u32 id = 0; n >= 0 && id < tree.n_nodes; id++) {
        n += tree.nodes_flag[id] == LEAF &&
             tree.mapNode2Circles[tree.nodes_Relations[id].circleMapOffset] == 0;
    }
    tree2d_free(&tree);
    growth_free(&growth);
    return n;
}

// A scene whose tree has two empty leaves, each with a list of its own. Not in all of its sizes has
// it so many.
static int draw_with_gaps(Random *random, JobScene *scene, KdTreeLimits limits)
{
    int n_empty = 0;
    do {
        job_scene_free(scene);
        if (job_scene_named(scene, random, "tiny", 64, 48) != 0) {
            return -1;
        }
        n_empty = count_empty_leaves(&scene->scene, limits);
    } while (n_empty == 0 || n_empty == 1);
    return n_empty < 0 ? -1 : 0;
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES], Growth *growth)
{
    static const KdTreeLimits limits[N_SCENES] = {{7, 4}, {4, 1}, {16, 6}, {6, 2},
                                                  {9, 1}, {4, 1}, {1, 3}};
    int result = job_scene_random(&scenes[0], random, 150, 14, 200, 150);
    result |= job_scene_named(&scenes[1], random, "example", 10, 10);
    result |= job_scene_random(&scenes[2], random, 300, 10, 120, 240);
    result |= job_scene_named(&scenes[3], random, "touching", 64, 48);
    result |= draw_with_gaps(random, &scenes[4], limits[4]);
    result |= job_scene_named(&scenes[5], random, "none", 64, 48);
    result |= job_scene_random(&scenes[DISTRIBUTE_SCENE], random, DISTRIBUTE_MAX_IDS, 10, 200, 150);
    if (result == 0) {
        Circle *circles = scenes[DISTRIBUTE_SCENE].scene.circles;
        // Circles that are equal are two all the same.
        circles[1] = circles[0];
        circles[DISTRIBUTE_MAX_IDS - 1] = circles[2];
        pile_up(&scenes[2].scene);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        scenes[k].limits = limits[k];
        result = oracle2d_tree(&scenes[k].scene, (u32)k, limits[k], growth, &scenes[k].tree);
    }
    return result;
}

static void draw_inputs(Random *random, Job02 *job)
{
    for (int i = 0; i < N_LEAVES; i++) {
        job->leaves[i] = draw_leaf(random, i);
    }
    for (int i = 0; i < N_SPLITS; i++) {
        job->splits[i] = draw_split(random, i);
    }
    for (int i = 0; i < N_OVERLAPS; i++) {
        const int j = i - N_INSIDE;
        job->overlaps[i] = j < 0            ? draw_inside(random)
                           : j < N_BOUNDARY ? draw_boundary(random, j)
                                            : draw_corner(random, j - N_BOUNDARY);
    }
    for (int i = 0; i < N_DISTRIBUTES; i++) {
        job->distributes[i] = draw_distribute(random, i, &job->scenes[DISTRIBUTE_SCENE].scene);
    }
    for (int i = 0; i < N_PACKS; i++) {
        job->packs[i] = draw_pack(random, i);
    }
}

int job_02_draw(void *pointer, Random *random)
{
    Job02 *job = pointer;
    const int result = draw_scenes(random, job->scenes, &job->job.growth);
    if (result == 0) {
        draw_inputs(random, job);
    }
    return result;
}

void job_02_release(void *pointer)
{
    Job02 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
}

int job_02_write_scene(const void *pointer, int k, FILE *file)
{
    JobScene scene = ((const Job02 *)pointer)->scenes[k];
    scene.tree = (KdTree2D){0};  // the probe shall not see what is expected
    return job_scene_write(&scene, k, file);
}

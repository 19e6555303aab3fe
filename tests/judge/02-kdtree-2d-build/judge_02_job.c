// Drawing lab 02's job from the seed: see judge_02.h. All coordinates are on a grid of 1/16 pixel,
// so that no right answer depends on rounding.
#include "judge_02.h"

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

// Of three inputs one is about the depth, one about the count and one about failed splits.
static LeafJob draw_leaf(Random *random, int i)
{
    LeafJob job = {.maxDepth = (i32)random_integer(random, 1, 14)};
    job.targetElementsPerNode = (i32)random_integer(random, 1, 20);
    if (i % 3 == 0) {
        job.level = job.maxDepth + (i32)random_integer(random, -1, 1);
        job.n_circles = (u32)job.targetElementsPerNode + (u32)random_integer(random, 1, 50);
    } else if (i % 3 == 1) {
        job.maxDepth += 2;
        job.level = (i32)random_integer(random, 1, job.maxDepth - 1);
        job.n_circles = (u32)(job.targetElementsPerNode + random_integer(random, -1, 1));
    } else {
        job.maxDepth += MAX_FAILED_SPLITS + 2;
        job.n_failed = (i32)random_integer(random, 0, MAX_FAILED_SPLITS + 1);
        job.level = (i32)random_integer(random, job.n_failed + 1, job.maxDepth - 1);
        job.n_circles = (u32)job.targetElementsPerNode + (u32)random_integer(random, 1, 50);
    }
    return job;
}

static BBox2D draw_split(Random *random, int i)
{
    BBox2D box = draw_box(random);
    if (i % 4 == 0) {
        box.maxY = box.minY + (box.maxX - box.minX);
    }
    return box;
}

// Circles of any place beside, in and around the box, its size or smaller.
static BoxOverlapJob draw_inside(Random *random)
{
    BoxOverlapJob job = {.box = draw_box(random)};
    job.circle.x = random_grid(random, -150, 250);
    job.circle.y = random_grid(random, -150, 250);
    job.circle.radius = random_grid(random, 1, 100);
    return job;
}

// A circle that touches a side from outside, or a corner by a Pythagorean triple; or misses it by a
// sixteenth of a pixel.
static BoxOverlapJob draw_boundary(Random *random)
{
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

// A circle beyond a corner, nearer than its radius on each axis: the square overlaps, the circle
// may not.
static BoxOverlapJob draw_corner(Random *random)
{
    BoxOverlapJob job = {.box = draw_box(random)};
    const BBox2D box = job.box;
    job.circle.radius = random_grid(random, 4, 60);
    const float dx = job.circle.radius * (float)random_integer(random, 8, 15) / 16;
    const float dy = job.circle.radius * (float)random_integer(random, 2, 15) / 16;
    job.circle.x = random_integer(random, 0, 1) ? box.maxX + dx : box.minX - dx;
    job.circle.y = random_integer(random, 0, 1) ? box.maxY + dy : box.minY - dy;
    return job;
}

// Some of scene 0's circles, ascending with gaps, and a cell.
static DistributeJob draw_distribute(Random *random, const Scene2D *scene)
{
    DistributeJob job = {0};
    for (u32 id = 1; id < (u32)scene->n_circles && job.n_ids < DISTRIBUTE_MAX_IDS; id++) {
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

static PackJob draw_pack(Random *random)
{
    PackJob job = {.id = (u32)random_integer(random, 1, PACK_NODES - 1)};
    job.n_map = (u32)random_integer(random, 1, 20);
    job.n_ids = (u32)random_integer(random, 0, PACK_MAX_IDS);
    u32 id = (u32)random_integer(random, 0, 5);
    for (u32 i = 0; i < job.n_ids; i++) {
        job.ids[i] = id;
        id += (u32)random_integer(random, 1, 90);
    }
    return job;
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES], Growth *growth)
{
    static const KdTreeLimits limits[N_SCENES] = {{7, 4}, {4, 1}, {9, 6}, {6, 2},
                                                  {5, 1}, {4, 1}, {1, 3}};
    int result = job_scene_random(&scenes[0], random, 150, 14, 200, 150);
    result |= job_scene_named(&scenes[1], "example", 10, 10);
    result |= job_scene_random(&scenes[2], random, 300, 10, 120, 240);
    result |= job_scene_named(&scenes[3], "touching", 64, 48);
    result |= job_scene_named(&scenes[4], "tiny", 64, 48);
    result |= job_scene_named(&scenes[5], "none", 64, 48);
    result |= job_scene_random(&scenes[6], random, 20, 10, 64, 64);
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
        job->overlaps[i] = i < N_INSIDE                ? draw_inside(random)
                           : i < N_INSIDE + N_BOUNDARY ? draw_boundary(random)
                                                       : draw_corner(random);
    }
    for (int i = 0; i < N_DISTRIBUTES; i++) {
        job->distributes[i] = draw_distribute(random, &job->scenes[0].scene);
    }
    for (int i = 0; i < N_PACKS; i++) {
        job->packs[i] = draw_pack(random);
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

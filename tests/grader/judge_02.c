// Judge of lab 02: each function on chosen inputs, and whole trees by their invariants.
#include "judge.h"

#include "job_scene.h"
#include "jobs.h"
#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

#include <stdlib.h>

enum {
    IS_LEAF_DEPTH,
    IS_LEAF_COUNT,
    TREE_LIMITS,
    SPLIT_LONGER,
    SPLIT_MIDDLE,
    TREE_CELLS,
    OVERLAP_INSIDE,
    OVERLAP_BOUNDARY,
    OVERLAP_CORNER,
    TREE_OVERLAP,
    DISTRIBUTE_LIST,
    TREE_LISTS,
    PACK_COUNT,
    PACK_OFFSET,
    PACK_REST,
    TREE_PACKING,
};

static const Check checks[] = {
    [IS_LEAF_DEPTH] = {"is_leaf-depth", "The last level is leaves", "is_leaf", 5},
    [IS_LEAF_COUNT] = {"is_leaf-count", "Few circles make a leaf", "is_leaf", 5},
    [TREE_LIMITS] = {"tree-limits", "Whole trees: leaves where the limits say so", "is_leaf", 5},
    [SPLIT_LONGER] = {"split-longer", "The longer side is split, x where equal", "split_box", 8},
    [SPLIT_MIDDLE] = {"split-middle", "In the middle, and nothing else moves", "split_box", 7},
    [TREE_CELLS] = {"tree-cells", "Whole trees: children tile their parent", "split_box", 5},
    [OVERLAP_INSIDE] = {"overlap-inside", "Circles clearly in and clearly out",
                        "circle_overlaps_box", 8},
    [OVERLAP_BOUNDARY] = {"overlap-boundary", "Touching counts", "circle_overlaps_box", 6},
    [OVERLAP_CORNER] = {"overlap-corner", "Exact at the corners", "circle_overlaps_box", 6},
    [TREE_OVERLAP] = {"tree-overlap", "Whole trees: each leaf has its circles",
                      "circle_overlaps_box", 5},
    [DISTRIBUTE_LIST] = {"distribute-list", "The right ids, in order, and how many", "distribute",
                         15},
    [TREE_LISTS] = {"tree-lists", "Whole trees: lists ascend", "distribute", 5},
    [PACK_COUNT] = {"pack-count", "The list starts with its count", "pack_leaf", 6},
    [PACK_OFFSET] = {"pack-offset", "circleMapOffset points at the count", "pack_leaf", 6},
    [PACK_REST] = {"pack-rest", "Ids, flag and n_map; nothing else moves", "pack_leaf", 3},
    [TREE_PACKING] = {"tree-packing", "Whole trees: packed without gaps", "pack_leaf", 5},
};

enum { N_LEAVES = 400, N_SPLITS = 400, N_DISTRIBUTES = 60, N_PACKS = 60, N_SCENES = 7 };
// Inputs of circle_overlaps_box: a range for each check.
enum { N_INSIDE = 1000, N_BOUNDARY = 500, N_CORNER = 500 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_CORNER };

typedef struct Job {
    LeafJob leaves[N_LEAVES];
    BBox2D splits[N_SPLITS];
    BoxOverlapJob overlaps[N_OVERLAPS];
    DistributeJob distributes[N_DISTRIBUTES];
    PackJob packs[N_PACKS];
    JobScene scenes[N_SCENES];
} Job;

// ---- Drawing the job --------------------------------------------------------------------------

static BBox2D draw_box(Random *random)
{
    BBox2D box = {.minX = random_grid(random, -100, 100), .minY = random_grid(random, -100, 100)};
    box.maxX = box.minX + random_grid(random, 1, 120);
    box.maxY = box.minY + random_grid(random, 1, 120);
    return box;
}

// Even inputs are about the depth, odd ones about the count.
static LeafJob draw_leaf(Random *random, int i)
{
    LeafJob job = {.maxDepth = (i32)random_integer(random, 1, 14),
                   .targetElementsPerNode = (i32)random_integer(random, 1, 20)};
    if (i % 2 == 0) {
        job.level = job.maxDepth + (i32)random_integer(random, -1, 1);
        job.n_circles = (u32)job.targetElementsPerNode + (u32)random_integer(random, 1, 50);
    } else {
        job.maxDepth += 2;
        job.level = (i32)random_integer(random, 1, job.maxDepth - 1);
        job.n_circles = (u32)(job.targetElementsPerNode + random_integer(random, -1, 1));
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
    PackJob job = {.id = (u32)random_integer(random, 1, PACK_NODES - 1),
                   .n_map = (u32)random_integer(random, 1, 20),
                   .n_ids = (u32)random_integer(random, 0, PACK_MAX_IDS)};
    u32 id = (u32)random_integer(random, 0, 5);
    for (u32 i = 0; i < job.n_ids; i++) {
        job.ids[i] = id;
        id += (u32)random_integer(random, 1, 90);
    }
    return job;
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES])
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
        result = oracle2d_tree(&scenes[k].scene, limits[k], &scenes[k].tree);
    }
    return result;
}

static void draw_inputs(Random *random, Job *job)
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

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
    free(job);
}

// A scene without the expected tree: the probe shall not see it.
static int write_scene(JobScene *scene, int k, FILE *file)
{
    const KdTree2D tree = scene->tree;
    scene->tree = (KdTree2D){0};
    const int result = job_scene_write(scene, k, file);
    scene->tree = tree;
    return result;
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    int result = draw_scenes(&random, job->scenes);
    if (result == 0) {
        draw_inputs(&random, job);
        result |= section_write(file, "leaves", job->leaves, sizeof job->leaves);
        result |= section_write(file, "splits", job->splits, sizeof job->splits);
        result |= section_write(file, "overlaps", job->overlaps, sizeof job->overlaps);
        result |= section_write(file, "distribute", job->distributes, sizeof job->distributes);
        result |= section_write(file, "pack", job->packs, sizeof job->packs);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = write_scene(&job->scenes[k], k, file);
    }
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

// ---- Judging the functions --------------------------------------------------------------------

static Verdict judge_is_leaf(const Job *job, int first, const Sections *answers)
{
    const i32 *found = sections_find(answers, "leaves", N_LEAVES * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = first; i < N_LEAVES; i += 2) {
        const LeafJob in = job->leaves[i];
        const int expected =
            in.level >= in.maxDepth || (int64_t)in.n_circles <= in.targetElementsPerNode;
        if ((found[i] != 0) != expected) {
            return verdict_of(message_new(
                "level %d, %u circles, maxDepth %d, targetElementsPerNode "
                "%d: found %d, expected %d",
                in.level, in.n_circles, in.maxDepth, in.targetElementsPerNode, found[i], expected));
        }
    }
    return verdict_of(NULL);
}

static char *describe_split(BBox2D box, const BBox2D found[2], const BBox2D expected[2],
                            const char *why)
{
    return message_new(
        "box x [%g, %g] y [%g, %g]: found left x [%g, %g] y [%g, %g] and right x [%g, "
        "%g] y [%g, %g], expected left x [%g, %g] y [%g, %g]%s",
        (double)box.minX, (double)box.maxX, (double)box.minY, (double)box.maxY,
        (double)found[0].minX, (double)found[0].maxX, (double)found[0].minY, (double)found[0].maxY,
        (double)found[1].minX, (double)found[1].maxX, (double)found[1].minY, (double)found[1].maxY,
        (double)expected[0].minX, (double)expected[0].maxX, (double)expected[0].minY,
        (double)expected[0].maxY, why);
}

static int is_box(BBox2D a, BBox2D b)
{
    return a.minX == b.minX && a.maxX == b.maxX && a.minY == b.minY && a.maxY == b.maxY;
}

// Which side was split: 'x', 'y', or '?' when neither was, or both.
static int split_side(const BBox2D found[2])
{
    const int x = found[0].minX != found[1].minX || found[0].maxX != found[1].maxX;
    const int y = found[0].minY != found[1].minY || found[0].maxY != found[1].maxY;
    return x && !y ? 'x' : y && !x ? 'y' : '?';
}

static Verdict judge_split(const Job *job, int check, const Sections *answers)
{
    const BBox2D *found = sections_find(answers, "splits", 2 * N_SPLITS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_SPLITS; i++) {
        const BBox2D box = job->splits[i];
        const double width = (double)box.maxX - box.minX, height = (double)box.maxY - box.minY;
        const int longer = width >= height ? 'x' : 'y';
        const int side = split_side(found + 2 * i);
        BBox2D expected[2] = {box, box};
        // Which side is the one check, where along it the other: that one follows the student's
        // side.
        if ((check == SPLIT_LONGER || side == '?' ? longer : side) == 'x') {
            expected[0].maxX = expected[1].minX = (float)(box.minX + width / 2);
        } else {
            expected[0].maxY = expected[1].minY = (float)(box.minY + height / 2);
        }
        if (check == SPLIT_LONGER && side != longer) {
            return verdict_of(describe_split(box, found + 2 * i, expected,
                                             side == '?' ? "; nothing was split, or both sides"
                                             : width == height
                                                 ? "; where both sides are equal, x is split"
                                                 : "; the shorter side was split"));
        }
        if (check == SPLIT_MIDDLE &&
            (!is_box(found[2 * i], expected[0]) || !is_box(found[2 * i + 1], expected[1]))) {
            const int swapped =
                is_box(found[2 * i], expected[1]) && is_box(found[2 * i + 1], expected[0]);
            return verdict_of(describe_split(box, found + 2 * i, expected,
                                             swapped ? "; left and right are swapped" : ""));
        }
    }
    return verdict_of(NULL);
}

// Do circle and box touch, and no more? On the inputs' grid one that is this much smaller is
// outside then.
static int is_touching(BoxOverlapJob in)
{
    Circle smaller = in.circle;
    smaller.radius -= 1e-3f;
    return oracle2d_overlaps_box(in.circle, in.box) && !oracle2d_overlaps_box(smaller, in.box);
}

// Is all that is wrong, in any check, that touching does not count?
static int is_strict(const Job *job, const i32 *found)
{
    for (int i = 0; i < N_OVERLAPS; i++) {
        const BoxOverlapJob in = job->overlaps[i];
        const int expected = oracle2d_overlaps_box(in.circle, in.box);
        if ((found[i] != 0) != expected && !(expected && is_touching(in))) {
            return 0;
        }
    }
    return 1;
}

static const char *explain_overlap(const Job *job, int i, const i32 *found)
{
    const BBox2D box = job->overlaps[i].box;
    const Circle c = job->overlaps[i].circle;
    if (!found[i]) {
        return is_strict(job, found)
                   ? "; they touch, and touching counts: both have their boundaries"
                   : "";
    }
    const int square = c.x + c.radius >= box.minX && c.x - c.radius <= box.maxX &&
                       c.y + c.radius >= box.minY && c.y - c.radius <= box.maxY;
    return square ? "; the circle's bounding square overlaps, the circle does not" : "";
}

static Verdict judge_overlaps(const Job *job, int first, int n, const Sections *answers)
{
    const i32 *found = sections_find(answers, "overlaps", N_OVERLAPS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = first; i < first + n; i++) {
        const BoxOverlapJob in = job->overlaps[i];
        const int expected = oracle2d_overlaps_box(in.circle, in.box);
        if ((found[i] != 0) != expected) {
            return verdict_of(message_new(
                "circle at (%g, %g) radius %g, box x [%g, %g] y [%g, %g]: found %d, expected %d%s",
                (double)in.circle.x, (double)in.circle.y, (double)in.circle.radius,
                (double)in.box.minX, (double)in.box.maxX, (double)in.box.minY, (double)in.box.maxY,
                found[i], expected, explain_overlap(job, i, found)));
        }
    }
    return verdict_of(NULL);
}

// Says that an id that belongs into a child's list is nowhere in it; "" when it is.
static const char *explain_missing(const DistributeJob *in, const u32 *list, u32 id)
{
    for (u32 i = 0; i < in->n_ids; i++) {
        if (list[i] == id) {
            return "";
        }
    }
    return "; that circle overlaps the cell and is missing in its list";
}

static Verdict judge_distribute(const Job *job, const Sections *answers)
{
    const u32 *found =
        sections_find(answers, "distribute", N_DISTRIBUTES * DISTRIBUTE_ROOM * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_DISTRIBUTES; i++, found += DISTRIBUTE_ROOM) {
        const DistributeJob *in = &job->distributes[i];
        u32 n = 0;
        for (u32 j = 0; j < in->n_ids; j++) {
            const u32 id = in->ids[j];
            if (!oracle2d_overlaps_box(job->scenes[0].scene.circles[id], in->child)) {
                continue;
            }
            if (found[1 + n] == UNTOUCHED) {
                return verdict_of(
                    message_new("node with %u circles from id %u on: child_ids[%u] was not "
                                "written, expected %u%s",
                                in->n_ids, in->ids[0], n, id, explain_missing(in, found + 1, id)));
            }
            if (found[1 + n] != id) {
                return verdict_of(
                    message_new("node with %u circles from id %u on: child_ids[%u] is "
                                "%u, expected %u%s",
                                in->n_ids, in->ids[0], n, found[1 + n], id,
                                found[1 + n] == j ? "; that is its position in ids[]"
                                                  : explain_missing(in, found + 1, id)));
            }
            n++;
        }
        if (found[0] != n) {
            return verdict_of(
                message_new("node with %u circles from id %u on: returned %u, expected "
                            "%u: the number of ids written",
                            in->n_ids, in->ids[0], found[0], n));
        }
        if (found[1 + in->n_ids] != UNTOUCHED) {
            return verdict_of(message_new("child_ids[%u] was written, but there is room for %u",
                                          in->n_ids, in->n_ids));
        }
    }
    return verdict_of(NULL);
}

static char *judge_pack_offset(const PackJob *in, const PackAnswer *out)
{
    const u32 offset = out->relations[in->id].circleMapOffset;
    return offset == in->n_map
               ? NULL
               : message_new(
                     "leaf with %u circles, map of %u entries: circleMapOffset is %u, expected "
                     "%u, the place of the count",
                     in->n_ids, in->n_map, offset, in->n_map);
}

static char *judge_pack_count(const PackJob *in, const PackAnswer *out)
{
    const u32 count = out->map[in->n_map];
    if (count == UNTOUCHED) {
        return message_new("leaf with %u circles, map of %u entries: mapNode2Circles[%u] was not "
                           "written, expected the count",
                           in->n_ids, in->n_map, in->n_map);
    }
    return count == in->n_ids
               ? NULL
               : message_new("leaf with %u circles, map of %u entries: the count at %u "
                             "is %u, expected %u",
                             in->n_ids, in->n_map, in->n_map, count, in->n_ids);
}

static char *judge_pack_rest(const PackJob *in, const PackAnswer *out)
{
    if (out->flags[in->id] != LEAF) {
        return message_new("nodes_flag[%u] is %u, expected LEAF", in->id, out->flags[in->id]);
    }
    for (u32 i = 0; i < in->n_ids; i++) {
        if (out->map[in->n_map + 1 + i] != in->ids[i]) {
            return message_new("leaf with %u circles: id number %u is %u, expected %u", in->n_ids,
                               i, out->map[in->n_map + 1 + i], in->ids[i]);
        }
    }
    if (out->n_map != in->n_map + 1 + in->n_ids) {
        return message_new(
            "leaf with %u circles, map of %u entries: n_map is %u afterwards, expected "
            "%u",
            in->n_ids, in->n_map, out->n_map, in->n_map + 1 + in->n_ids);
    }
    for (u32 i = 0; i < PACK_MAP_ROOM; i++) {
        const int is_list = i >= in->n_map && i < in->n_map + 1 + in->n_ids;
        if (!is_list && out->map[i] != UNTOUCHED) {
            return message_new("mapNode2Circles[%u] was written, but the list goes from %u to %u",
                               i, in->n_map, in->n_map + in->n_ids);
        }
    }
    for (u32 id = 0; id < PACK_NODES; id++) {
        const NodeRel node = out->relations[id];
        if (node.id != id || node.lChild != 0 || node.rChild != 0 ||
            (id != in->id && (node.circleMapOffset != 0 || out->flags[id] != INNER))) {
            return message_new("packing leaf %u changed node %u otherwise than it should", in->id,
                               id);
        }
    }
    return NULL;
}

static Verdict judge_pack(const Job *job, const Sections *answers,
                          char *(*judge_one)(const PackJob *, const PackAnswer *))
{
    const PackAnswer *found = sections_find(answers, "pack", N_PACKS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_PACKS; i++) {
        char *message = judge_one(&job->packs[i], &found[i]);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

// Why there is no tree: the builder gave up, or the probe ended before.
static Verdict tree_refused(const JobScene *scene, int k, const Sections *answers)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "tree.%d.refused", k);
    size_t n_bytes;
    if (sections_find_any(answers, name, &n_bytes) == NULL) {
        return verdict_missing;
    }
    return verdict_of(message_new("%s: kdtree2d_build gave up, as the tree grew too large: does "
                                  "splitting ever end?",
                                  scene->picture.title));
}

static Verdict judge_trees(const Job *job, const Sections *answers,
                           char *(*judge_one)(const JobScene *, const KdTree2D *))
{
    for (int k = 0; k < N_SCENES; k++) {
        KdTree2D own;
        if (!tree_judge_answer(k, answers, &own)) {
            return tree_refused(&job->scenes[k], k, answers);
        }
        char *message = judge_one(&job->scenes[k], &own);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case IS_LEAF_DEPTH:
        return judge_is_leaf(job, 0, answers);
    case IS_LEAF_COUNT:
        return judge_is_leaf(job, 1, answers);
    case TREE_LIMITS:
        return judge_trees(job, answers, tree_judge_limits);
    case SPLIT_LONGER:
    case SPLIT_MIDDLE:
        return judge_split(job, check, answers);
    case TREE_CELLS:
        return judge_trees(job, answers, tree_judge_cells);
    case OVERLAP_INSIDE:
        return judge_overlaps(job, 0, N_INSIDE, answers);
    case OVERLAP_BOUNDARY:
        return judge_overlaps(job, N_INSIDE, N_BOUNDARY, answers);
    case OVERLAP_CORNER:
        return judge_overlaps(job, N_INSIDE + N_BOUNDARY, N_CORNER, answers);
    case TREE_OVERLAP:
        return judge_trees(job, answers, tree_judge_overlap);
    case DISTRIBUTE_LIST:
        return judge_distribute(job, answers);
    case TREE_LISTS:
        return judge_trees(job, answers, tree_judge_lists);
    case PACK_COUNT:
        return judge_pack(job, answers, judge_pack_count);
    case PACK_OFFSET:
        return judge_pack(job, answers, judge_pack_offset);
    case PACK_REST:
        return judge_pack(job, answers, judge_pack_rest);
    default:
        return judge_trees(job, answers, tree_judge_packing);
    }
}

static void adopt(void *pointer, const Sections *answers)
{
    // The oracle's trees stay the reference; nothing is drawn on the device.
    (void)pointer, (void)answers;
}

// A tree as SVG text, or NULL.
static char *svg_of(const Scene2D *scene, const KdTree2D *tree)
{
    char *text = NULL;
    size_t n_bytes = 0;
    FILE *file = open_memstream(&text, &n_bytes);
    if (file == NULL) {
        return NULL;
    }
    const int result = tree2d_write_svg(file, scene, tree);
    fclose(file);
    if (result != 0) {
        free(text);
        return NULL;
    }
    return text;
}

// A submission's tree may have more nodes than these, but a report of many megabytes helps nobody.
enum { MAX_DRAWN_NODES = 20000 };

// The example's tree and the first random one.
static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    for (int k = 1; k >= 0 && result->n_pictures < RESULT_MAX_PICTURES; k--) {
        PictureResult *picture = &result->pictures[result->n_pictures++];
        KdTree2D own;
        snprintf(picture->title, sizeof picture->title, "tree over %s",
                 job->scenes[k].picture.title);
        picture->svg_reference = svg_of(&job->scenes[k].scene, &job->scenes[k].tree);
        if (tree_judge_answer(k, answers, &own) && own.n_nodes <= MAX_DRAWN_NODES) {
            picture->svg_own = svg_of(&job->scenes[k].scene, &own);
        }
    }
}

const Judge judge_02 = {
    "02-kdtree-2d-build", checks, sizeof checks / sizeof *checks, job_new, job_free, judge, adopt,
    add_pictures,
};

// Lab 02's solution, the judges of trees and the drawing: good trees pass, each fault is found by
// the judges that look at it and by no other, and no tree of a submission does harm.
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "random.h"
#include "surroundings.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

#include <math.h>

// The builder and its neighbours are compiled in here with limits that are reached within
// milliseconds, and with memory that runs out when a test wants it to.
#undef TREE2D_MAX_ENTRIES
#undef TREE2D_MAX_NODES
#define TREE2D_MAX_ENTRIES (1u << 16)
#define TREE2D_MAX_NODES (1u << 14)

static int n_allocations_left = -1;  // negative: as many as one likes

static int may_allocate(void)
{
    if (n_allocations_left == 0) {
        return 0;
    }
    n_allocations_left -= n_allocations_left > 0;
    return 1;
}

#define malloc(n_bytes) (may_allocate() ? malloc(n_bytes) : NULL)
#define realloc(old, n_bytes) (may_allocate() ? realloc(old, n_bytes) : NULL)
#define calloc(n, n_bytes) (may_allocate() ? calloc(n, n_bytes) : NULL)
#include "kdtree2d_build.c"
#include "tree2d.c"
#include "tree2d_draw.c"
#undef malloc
#undef calloc
#undef realloc

TestSuite(tree2d);

// ---- The judges ---------------------------------------------------------------------------------

enum {
    LIMITS = 1,
    CELLS = 2,
    OVERLAP = 4,
    LISTS = 8,
    PACKING = 16,
    CHECK = 32,  // tree2d_check(): may ids, offsets and counts be followed?
};

static const struct {
    int bit;
    const char *name;
    char *(*judge)(const JobScene *, const KdTree2D *);
} judges[] = {{LIMITS, "limits", tree_judge_limits},
              {CELLS, "cells", tree_judge_cells},
              {OVERLAP, "overlap", tree_judge_overlap},
              {LISTS, "lists", tree_judge_lists},
              {PACKING, "packing", tree_judge_packing}};

// Which judges object. Messages are one line each.
static int judges_against(const JobScene *scene, const KdTree2D *tree)
{
    int against = 0;
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        char *message = judges[i].judge(scene, tree);
        if (message != NULL) {
            against |= judges[i].bit;
            cr_expect(strchr(message, '\n') == NULL &&
                          strstr(message, scene->picture.title) == message,
                      "%s", message);
            free(message);
        }
    }
    capture_begin(2);
    if (tree2d_check(tree, (u32)scene->scene.n_circles) != 0) {
        against |= CHECK;
        expect_one_message(capture_end(2), "tree: ");
    } else {
        cr_expect_str_eq(capture_end(2), "");
    }
    return against;
}

// The same in words.
static const char *names_of(int against)
{
    static char names[128];
    names[0] = '\0';
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        if (against & judges[i].bit) {
            strcat(strcat(names, judges[i].name), " ");
        }
    }
    return strcat(names, against & CHECK ? "check" : "");
}

static JobScene scene_of(const char *name, int width, int height, KdTreeLimits limits)
{
    JobScene scene;
    cr_assert_eq(job_scene_named(&scene, name, width, height), 0);
    cr_assert_eq(job_scene_grow_tree(&scene, limits), 0);
    return scene;
}

// ---- Building -----------------------------------------------------------------------------------

static void expect_good(const JobScene *scene)
{
    const int against = judges_against(scene, &scene->tree);
    cr_expect_eq(against, 0, "%s, maxDepth %d, targetElementsPerNode %d: %s", scene->picture.title,
                 scene->limits.maxDepth, scene->limits.targetElementsPerNode, names_of(against));
    // A leaf's place in the tree is no secret: as deep as allowed or with few enough circles.
    const KdTree2D *tree = &scene->tree;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        if (tree->nodes_flag[id] == LEAF) {
            cr_expect(node.lChild == 0 && node.rChild == 0);
        } else {
            cr_expect_eq(tree->nodes_flag[id], INNER);
            cr_expect_eq(node.circleMapOffset, 0);
        }
    }
}

// Whole corners, every circle inside, nothing to spare.
static void expect_bounds(const JobScene *scene)
{
    const BBox2D box = scene->tree.nodes_BBox[0];
    double min_x = INFINITY, max_x = -INFINITY, min_y = INFINITY, max_y = -INFINITY;
    for (int i = 0; i < scene->scene.n_circles; i++) {
        const Circle c = scene->scene.circles[i];
        min_x = fmin(min_x, (double)c.x - c.radius), max_x = fmax(max_x, (double)c.x + c.radius);
        min_y = fmin(min_y, (double)c.y - c.radius), max_y = fmax(max_y, (double)c.y + c.radius);
    }
    cr_expect(box.minX <= min_x && min_x < box.minX + 1.0 && box.minX == floor(box.minX));
    cr_expect(box.minY <= min_y && min_y < box.minY + 1.0 && box.minY == floor(box.minY));
    cr_expect(max_x < box.maxX && box.maxX <= max_x + 1.0 && box.maxX == floor(box.maxX));
    cr_expect(max_y < box.maxY && box.maxY <= max_y + 1.0 && box.maxY == floor(box.maxY));
}

Test(tree2d, random_scenes_give_good_trees)
{
    Random random = {1};
    for (int round = 0; round < 200; round++) {
        JobScene scene;
        cr_assert_eq(job_scene_random(&scene, &random, (int)random_integer(&random, 1, 120),
                                      (int)random_integer(&random, 2, round % 4 ? 12 : 200),
                                      (int)random_integer(&random, 1, 300),
                                      (int)random_integer(&random, 1, 300)),
                     0);
        const KdTreeLimits limits = {(int)random_integer(&random, 1, 8),
                                     (int)random_integer(&random, 1, 12)};
        cr_assert_eq(job_scene_grow_tree(&scene, limits), 0);
        expect_good(&scene);
        expect_bounds(&scene);
        job_scene_free(&scene);
    }
}

Test(tree2d, edge_cases_give_good_trees)
{
    for (int i = 0; scene2d_edge_case(i) != NULL; i++) {
        JobScene scene = scene_of(scene2d_edge_case(i), 64, 48, (KdTreeLimits){6, 2});
        expect_good(&scene);
        job_scene_free(&scene);
    }
}

Test(tree2d, the_worked_example_comes_out_as_in_the_lecture)
{
    JobScene scene = scene_of("example", 10, 10, (KdTreeLimits){4, 1});
    const KdTree2D *tree = &scene.tree;
    expect_good(&scene);
    cr_assert_eq(tree->n_nodes, 15);
    for (u32 id = 0; id < 15; id++) {
        cr_expect_eq(tree->nodes_Relations[id].id, id);
        cr_expect_eq(tree->nodes_flag[id], id < 7 ? INNER : LEAF);
        cr_expect_eq(tree->nodes_Relations[id].lChild, id < 7 ? 2 * id + 1 : 0);
        cr_expect_eq(tree->nodes_Relations[id].rChild, id < 7 ? 2 * id + 2 : 0);
    }
    const BBox2D root = tree->nodes_BBox[0], box = tree->nodes_BBox[13];
    cr_expect(root.minX == 0 && root.maxX == 10 && root.minY == 0 && root.maxY == 10);
    cr_expect(box.minX == 5 && box.maxX == 7.5f && box.minY == 5 && box.maxY == 10);
    const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[13].circleMapOffset;
    cr_expect(list[0] == 2 && list[1] == 2 && list[2] == 4, "C and E");
    job_scene_free(&scene);
}

Test(tree2d, no_circle_and_one_circle_are_one_leaf)
{
    JobScene scene = scene_of("none", 64, 48, (KdTreeLimits){9, 1});
    cr_expect(scene.tree.n_nodes == 1 && scene.tree.n_map == 1);
    cr_expect(scene.tree.nodes_flag[0] == LEAF && scene.tree.mapNode2Circles[0] == 0);
    const BBox2D box = scene.tree.nodes_BBox[0];
    cr_expect(box.minX == 0 && box.maxX == 0 && box.minY == 0 && box.maxY == 0);
    expect_good(&scene);
    job_scene_free(&scene);

    scene = scene_of("random:n=1", 64, 48, (KdTreeLimits){9, 1});
    cr_expect(scene.tree.n_nodes == 1 && scene.tree.n_map == 2);
    cr_expect(scene.tree.mapNode2Circles[0] == 1 && scene.tree.mapNode2Circles[1] == 0);
    expect_good(&scene);
    job_scene_free(&scene);
}

Test(tree2d, one_level_holds_everything)
{
    JobScene scene = scene_of("random:n=50", 64, 48, (KdTreeLimits){1, 1});
    cr_expect(scene.tree.n_nodes == 1 && scene.tree.n_map == 51);
    expect_good(&scene);
    job_scene_free(&scene);
}

Test(tree2d, coincident_circles_end_at_the_last_level)
{
    JobScene scene = {.picture.title = "coincident",
                      .scene = {.n_circles = 5, .width = 64, .height = 48}};
    scene.scene.circles = calloc(5, sizeof *scene.scene.circles);
    for (int i = 0; i < 5; i++) {
        scene.scene.circles[i] = (Circle){.x = 20, .y = 20, .radius = 3};
    }
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){5, 4}), 0);
    expect_good(&scene);
    cr_expect_gt(scene.tree.n_nodes, 15);
    cr_expect_leq(scene.tree.n_nodes, 31);
    job_scene_free(&scene);
}

// A job's scene of n circles: `circle` again and again, each `step` farther to the right and
// `growth` larger than the one before.
static JobScene row_of(int n, Circle circle, float step, float growth)
{
    JobScene scene = {.picture.title = "row", .scene = {.n_circles = n, .width = 64, .height = 48}};
    scene.scene.circles = calloc((size_t)n, sizeof *scene.scene.circles);
    for (int i = 0; i < n; i++) {
        scene.scene.circles[i] = circle;
        scene.scene.circles[i].x += (float)i * step;
        scene.scene.circles[i].radius += (float)i * growth;
    }
    return scene;
}

Test(tree2d, a_split_fails_when_both_children_keep_nearly_all)
{
    cr_expect(split_failed(10, 9, 9) && split_failed(10, 10, 8) && split_failed(1, 1, 1));
    cr_expect(!split_failed(10, 9, 8) && !split_failed(10, 10, 7) && !split_failed(3, 3, 2));
    cr_expect(split_failed(UINT32_MAX, UINT32_MAX, UINT32_MAX), "no sum wraps round");
    for (u32 n = 1; n < 60; n++) {
        for (u32 n_both = 0; n_both <= 2 * n; n_both++) {
            const u32 n_left = n_both < n ? n_both : n;
            cr_assert_eq(split_failed(n, n_left, n_both - n_left),
                         oracle_split_fails(n, n_left, n_both - n_left));
        }
    }
}

Test(tree2d, coincident_circles_end_after_failed_splits)
{
    JobScene scene = row_of(2000, (Circle){.x = 20, .y = 20, .radius = 3.5f}, 0, 0);
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){16, 8}), 0);
    expect_good(&scene);
    cr_expect_eq(scene.tree.n_nodes, 31, "four levels of failed splits above 16 leaves");
    cr_expect_eq(scene.tree.n_map, 16 * 2001);
    job_scene_free(&scene);
}

Test(tree2d, concentric_circles_are_no_more_entries_than_the_cells_need)
{
    JobScene scene = row_of(500, (Circle){.x = 300, .y = 300, .radius = 1}, 0, 0.5f);
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){16, 8}), 0);
    expect_good(&scene);
    job_scene_free(&scene);
}

// One large circle makes the root's cell square, and all others lie on the plane that halves it.
Test(tree2d, splits_go_on_after_one_that_failed)
{
    JobScene scene = row_of(200, (Circle){.x = 100, .y = 100, .radius = 0.5f}, 0, 0);
    for (int i = 1; i < 200; i++) {
        scene.scene.circles[i].y = (float)i;
    }
    scene.scene.circles[0].radius = 100;
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){16, 8}), 0);
    expect_good(&scene);
    for (u32 id = 0; id < scene.tree.n_nodes; id++) {
        const u32 offset = scene.tree.nodes_Relations[id].circleMapOffset;
        cr_expect(scene.tree.nodes_flag[id] == INNER || scene.tree.mapNode2Circles[offset] <= 8);
    }
    job_scene_free(&scene);
}

Test(tree2d, circles_overlap_boxes_as_the_oracle_says)
{
    Random random = {7};
    for (int i = 0; i < 50000; i++) {
        BBox2D box = {.minX = (float)random_integer(&random, -500, 500) / 16,
                      .minY = (float)random_integer(&random, -500, 500) / 16};
        box.maxX = box.minX + (float)random_integer(&random, 0, 500) / 16;
        box.maxY = box.minY + (float)random_integer(&random, 0, 500) / 16;
        const Circle circle = {.x = (float)random_integer(&random, -999, 999) / 16,
                               .y = (float)random_integer(&random, -999, 999) / 16,
                               .radius = (float)random_integer(&random, 0, 600) / 16};
        cr_assert_eq(circle_overlaps_box(circle, box), oracle2d_overlaps_box(circle, box));
    }
}

// ---- Refused ------------------------------------------------------------------------------------

static void expect_refused(JobScene scene, KdTreeLimits limits, const char *part)
{
    KdTree2D tree;
    memset(&tree, 0x5a, sizeof tree);
    const KdTree2D untouched = tree;
    capture_begin(2);
    const int result =
        kdtree2d_build(scene.scene.circles, (u32)scene.scene.n_circles, limits, &tree);
    expect_one_message(capture_end(2), part);
    cr_expect_eq(result, -1);
    cr_expect_eq(memcmp(&tree, &untouched, sizeof tree), 0);
    job_scene_free(&scene);
}

Test(tree2d, too_many_nodes_are_refused)
{
    expect_refused(row_of(9000, (Circle){.radius = 0.25f}, 1, 0), (KdTreeLimits){40, 1},
                   "too many nodes");
}

Test(tree2d, too_many_entries_are_refused)
{
    expect_refused(row_of(5000, (Circle){.radius = 1}, 0, 0), (KdTreeLimits){40, 1},
                   "the leaves would hold too many circles");
}

Test(tree2d, memory_that_runs_out_is_told_wherever_it_does)
{
    Scene2D scene;
    cr_assert_eq(scene2d_random(300, 1, 2, 20, 400, 300, &scene), 0);
    int result = -1;
    for (int n = 0; result != 0; n++) {
        KdTree2D tree = {0};
        capture_begin(2);
        n_allocations_left = n;
        result = kdtree2d_build(scene.circles, 300, (KdTreeLimits){10, 2}, &tree);
        n_allocations_left = -1;
        const char *message = capture_end(2);
        if (result != 0) {
            expect_one_message(message, "kdtree2d_build: no memory");
            cr_assert_lt(n, 5000);
        } else {
            cr_expect_str_eq(message, "");
            cr_expect_gt(n, 6, "at least the arrays");
        }
        tree2d_free(&tree);
    }
    scene2d_free(&scene);
}

// ---- Corrupted trees ----------------------------------------------------------------------------

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static void *copy_of(const void *bytes, size_t n_bytes)
{
    void *copy = malloc(n_bytes);
    memcpy(copy, bytes, n_bytes);
    return copy;
}

static KdTree2D tree_copy(const KdTree2D *tree)
{
    KdTree2D copy = *tree;
    copy.nodes_Relations = copy_of(tree->nodes_Relations, tree->n_nodes * sizeof(NodeRel));
    copy.nodes_flag = copy_of(tree->nodes_flag, tree->n_nodes);
    copy.nodes_BBox = copy_of(tree->nodes_BBox, tree->n_nodes * sizeof(BBox2D));
    copy.mapNode2Circles = copy_of(tree->mapNode2Circles, tree->n_map * sizeof(u32));
    return copy;
}

// The subject: 31 nodes, all levels full, leaves 15 to 30; leaf 20 and the last one have several
// circles.
enum { LAST_INNER = 14, A_LEAF = 20, LAST_LEAF = 30 };

static JobScene subject_open(void)
{
    JobScene scene = scene_of("random:n=60,seed=4,min=8", 64, 48, (KdTreeLimits){5, 2});
    cr_assert_eq(scene.tree.n_nodes, LAST_LEAF + 1);
    expect_good(&scene);
    return scene;
}

// A leaf's list, from its count on.
static u32 *list_of(const KdTree2D *tree, u32 id)
{
    return tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
}

// Put an entry into the map, or take one out; the leaves behind it follow.
static void map_edit(KdTree2D *tree, u32 leaf, int change, u32 at, u32 value)
{
    const u32 place = tree->nodes_Relations[leaf].circleMapOffset + at;
    u32 *map = calloc(tree->n_map + 1, sizeof *map);
    memcpy(map, tree->mapNode2Circles, place * sizeof *map);
    map[place] = value;
    memcpy(map + place + (change > 0), tree->mapNode2Circles + place + (change < 0),
           (tree->n_map - place - (change < 0)) * sizeof *map);
    tree->n_map += (u32)change;
    map[tree->nodes_Relations[leaf].circleMapOffset] += (u32)change;
    free(tree->mapNode2Circles);
    tree->mapNode2Circles = copy_of(map, tree->n_map * sizeof *map);
    free(map);
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == LEAF &&
            tree->nodes_Relations[id].circleMapOffset > place - at) {
            tree->nodes_Relations[id].circleMapOffset += (u32)change;
        }
    }
}

static void swap(u32 *a, u32 *b)
{
    const u32 value = *a;
    *a = *b, *b = value;
}

// A circle that leaf A_LEAF does not list, larger than all it does.
static u32 stranger(const KdTree2D *tree)
{
    const u32 *list = list_of(tree, A_LEAF);
    cr_assert_lt(list[list[0]], 59);
    return list[list[0]] + 1;
}

static void child_is_no_node(KdTree2D *t)
{
    t->nodes_Relations[LAST_INNER].rChild = t->n_nodes;
}
static void child_is_far_out(KdTree2D *t)
{
    t->nodes_Relations[3].lChild = 0xffffffff;
}
static void child_is_its_own_parent(KdTree2D *t)
{
    t->nodes_Relations[3].lChild = 3;
}
static void child_is_its_grandparent(KdTree2D *t)
{
    t->nodes_Relations[3].rChild = 0;
}
static void children_are_swapped(KdTree2D *t)
{
    swap(&t->nodes_Relations[3].lChild, &t->nodes_Relations[3].rChild);
}
static void children_are_one(KdTree2D *t)
{
    t->nodes_Relations[3].rChild = t->nodes_Relations[3].lChild;
}
static void children_of_others(KdTree2D *t)
{
    const NodeRel node = t->nodes_Relations[3];
    t->nodes_Relations[3].lChild = t->nodes_Relations[4].lChild;
    t->nodes_Relations[3].rChild = t->nodes_Relations[4].rChild;
    t->nodes_Relations[4].lChild = node.lChild;
    t->nodes_Relations[4].rChild = node.rChild;
}
static void ids_are_permuted(KdTree2D *t)
{
    swap(&t->nodes_Relations[8].id, &t->nodes_Relations[9].id);
}
static void ids_start_at_1(KdTree2D *t)
{
    for (u32 id = 0; id < t->n_nodes; id++) {
        t->nodes_Relations[id].id++;
    }
}
static void leaf_has_children(KdTree2D *t)
{
    t->nodes_Relations[A_LEAF].lChild = 29;
}
static void offset_at_the_first_id(KdTree2D *t)
{
    for (u32 id = LAST_INNER + 1; id < t->n_nodes; id++) {
        t->nodes_Relations[id].circleMapOffset++;
    }
}
static void offset_at_the_end(KdTree2D *t)
{
    t->nodes_Relations[A_LEAF].circleMapOffset = t->n_map;
}
static void offset_is_far_out(KdTree2D *t)
{
    t->nodes_Relations[A_LEAF].circleMapOffset = 0xffffffff;
}
static void offsets_are_swapped(KdTree2D *t)
{
    swap(&t->nodes_Relations[LAST_INNER + 1].circleMapOffset,
         &t->nodes_Relations[LAST_LEAF].circleMapOffset);
}
static void lists_are_permuted(KdTree2D *t)
{
    // The last leaf's list goes first, everything moves: right but not packed in order.
    const u32 n = list_of(t, LAST_LEAF)[0] + 1;
    u32 *map = malloc(t->n_map * sizeof *map);
    memcpy(map, list_of(t, LAST_LEAF), n * sizeof *map);
    memcpy(map + n, t->mapNode2Circles, (t->n_map - n) * sizeof *map);
    free(t->mapNode2Circles);
    t->mapNode2Circles = map;
    for (u32 id = LAST_INNER + 1; id < LAST_LEAF; id++) {
        t->nodes_Relations[id].circleMapOffset += n;
    }
    t->nodes_Relations[LAST_LEAF].circleMapOffset = 0;
}
static void count_is_one_more(KdTree2D *t)
{
    list_of(t, A_LEAF)[0]++;
}
static void count_is_one_less(KdTree2D *t)
{
    list_of(t, A_LEAF)[0]--;
}
static void last_count_is_one_more(KdTree2D *t)
{
    list_of(t, LAST_LEAF)[0]++;
}
static void count_is_far_out(KdTree2D *t)
{
    list_of(t, A_LEAF)[0] = 0xffffffff;
}
static void list_is_unsorted(KdTree2D *t)
{
    swap(&list_of(t, A_LEAF)[1], &list_of(t, A_LEAF)[2]);
}
static void circle_is_listed_twice(KdTree2D *t)
{
    map_edit(t, A_LEAF, 1, 2, list_of(t, A_LEAF)[1]);
}
static void circle_hides_another(KdTree2D *t)
{
    list_of(t, A_LEAF)[2] = list_of(t, A_LEAF)[1];
}
static void circle_is_missing(KdTree2D *t)
{
    map_edit(t, A_LEAF, -1, 2, 0);
}
static void circle_is_additional(KdTree2D *t)
{
    const u32 *list = list_of(t, A_LEAF);
    map_edit(t, A_LEAF, 1, list[0] + 1, stranger(t));
}
static void circle_is_another(KdTree2D *t)
{
    u32 *list = list_of(t, A_LEAF);
    list[list[0]] = stranger(t);
}
static void circle_is_none(KdTree2D *t)
{
    u32 *list = list_of(t, A_LEAF);
    list[list[0]] = 60;
}
static void circle_is_none_at_all(KdTree2D *t)
{
    u32 *list = list_of(t, A_LEAF);
    map_edit(t, A_LEAF, 1, list[0] + 1, 0xffffffff);
}
static void leaf_box_is_shifted(KdTree2D *t)
{
    t->nodes_BBox[A_LEAF].minX += 0.5f;
}
static void leaf_box_is_not_a_number(KdTree2D *t)
{
    t->nodes_BBox[A_LEAF].maxY = NAN;
}
static void inner_box_is_shifted(KdTree2D *t)
{
    t->nodes_BBox[3].maxX += 0.0625f;
}
static void root_is_the_picture(KdTree2D *t)
{
    t->nodes_BBox[0] = (BBox2D){0, 64, 0, 48};
}
static void inner_node_is_a_leaf(KdTree2D *t)
{
    t->nodes_flag[LAST_INNER] = LEAF;
}
static void leaf_is_an_inner_node(KdTree2D *t)
{
    t->nodes_flag[A_LEAF] = INNER;
}
static void flag_is_neither(KdTree2D *t)
{
    t->nodes_flag[3] = 7;
}
static void map_has_a_tail(KdTree2D *t)
{
    t->mapNode2Circles = realloc(t->mapNode2Circles, (t->n_map + 1) * sizeof(u32));
    t->mapNode2Circles[t->n_map++] = 0;
}
static void map_is_cut_off(KdTree2D *t)
{
    t->mapNode2Circles = realloc(t->mapNode2Circles, --t->n_map * sizeof(u32));
}
static void nodes_have_a_tail(KdTree2D *t)
{
    const u32 n = t->n_nodes;
    t->nodes_Relations = realloc(t->nodes_Relations, (n + 1) * sizeof(NodeRel));
    t->nodes_flag = realloc(t->nodes_flag, n + 1);
    t->nodes_BBox = realloc(t->nodes_BBox, (n + 1) * sizeof(BBox2D));
    t->nodes_Relations[n] = t->nodes_Relations[n - 1];
    t->nodes_Relations[n].id = n;
    t->nodes_flag[n] = LEAF;
    t->nodes_BBox[n] = t->nodes_BBox[n - 1];
    t->n_nodes = n + 1;
}
static void nodes_are_cut_off(KdTree2D *t)
{
    t->n_nodes--;
}
static void there_is_only_a_root(KdTree2D *t)
{
    t->n_nodes = t->n_map = 1;
    t->nodes_flag[0] = LEAF;
    t->mapNode2Circles[0] = 0;
}

// Who must object, and that nobody else does: a mistake in one task costs that task only, as far as
// the others can still be judged. (A node that is nobody's child has no level, so limits object.)
static const struct {
    void (*corrupt)(KdTree2D *tree);
    const char *what;
    int against;
} corruptions[] = {
#define CORRUPTION(name, against) {name, #name, against}
    CORRUPTION(child_is_no_node, LIMITS | CELLS | PACKING | CHECK),
    CORRUPTION(child_is_far_out, LIMITS | CELLS | PACKING | CHECK),
    CORRUPTION(child_is_its_own_parent, LIMITS | CELLS | PACKING | CHECK),
    CORRUPTION(child_is_its_grandparent, LIMITS | CELLS | PACKING | CHECK),
    CORRUPTION(children_are_swapped, CELLS | PACKING),
    CORRUPTION(children_are_one, LIMITS | CELLS | PACKING),
    CORRUPTION(children_of_others, CELLS | PACKING),
    CORRUPTION(ids_are_permuted, PACKING),
    CORRUPTION(ids_start_at_1, PACKING),
    CORRUPTION(leaf_has_children, PACKING),
    CORRUPTION(offset_at_the_first_id, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(offset_at_the_end, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(offset_is_far_out, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(offsets_are_swapped, OVERLAP | PACKING),
    CORRUPTION(lists_are_permuted, PACKING),
    CORRUPTION(count_is_one_more, OVERLAP | LISTS | PACKING),
    CORRUPTION(count_is_one_less, OVERLAP | PACKING),
    CORRUPTION(last_count_is_one_more, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(count_is_far_out, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(list_is_unsorted, LISTS),
    CORRUPTION(circle_is_listed_twice, LISTS | PACKING),
    CORRUPTION(circle_hides_another, OVERLAP | LISTS),
    CORRUPTION(circle_is_missing, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_additional, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_another, OVERLAP),
    CORRUPTION(circle_is_none, OVERLAP | LISTS | CHECK),
    CORRUPTION(circle_is_none_at_all, LISTS | PACKING | CHECK),
    CORRUPTION(leaf_box_is_shifted, CELLS | OVERLAP),
    CORRUPTION(leaf_box_is_not_a_number, CELLS | OVERLAP),
    CORRUPTION(inner_box_is_shifted, CELLS | OVERLAP),
    CORRUPTION(root_is_the_picture, CELLS | OVERLAP),
    CORRUPTION(inner_node_is_a_leaf, LIMITS | OVERLAP | LISTS | PACKING),
    CORRUPTION(leaf_is_an_inner_node, LIMITS | CELLS | LISTS | PACKING | CHECK),
    CORRUPTION(flag_is_neither, LIMITS | LISTS),
    CORRUPTION(map_has_a_tail, LISTS | PACKING),
    CORRUPTION(map_is_cut_off, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(nodes_have_a_tail, LIMITS | CELLS | OVERLAP | LISTS | PACKING),
    CORRUPTION(nodes_are_cut_off, LIMITS | CELLS | OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(there_is_only_a_root, LIMITS | CELLS | OVERLAP | LISTS | PACKING),
#undef CORRUPTION
};

Test(tree2d, each_fault_is_found_by_its_judges_alone)
{
    JobScene scene = subject_open();
    for (size_t i = 0; i < sizeof corruptions / sizeof *corruptions; i++) {
        KdTree2D tree = tree_copy(&scene.tree);
        corruptions[i].corrupt(&tree);
        const int against = judges_against(&scene, &tree);
        cr_expect_eq(against, corruptions[i].against, "%s: found by %s", corruptions[i].what,
                     names_of(against));
        tree2d_free(&tree);
    }
    job_scene_free(&scene);
}

// The first fault is named, with what was found and what was expected.
static const struct {
    void (*corrupt)(KdTree2D *tree);
    int judge;
    const char *says;
} messages[] = {
    {child_is_far_out, CELLS,
     "node 3 is an inner node, but its children are 4294967295 and 8 of 31"},
    {children_are_swapped, PACKING, "node 3's children are 8 and 7, expected 7 and 8"},
    {ids_are_permuted, PACKING, "the node at position 8 has id 9"},
    {lists_are_permuted, PACKING, "expected 0, behind the list"},
    {offset_is_far_out, OVERLAP, "leaf 20: circleMapOffset is 4294967295, but mapNode2Circles has"},
    {count_is_far_out, LISTS, "where the count would be 4294967295"},
    {list_is_unsorted, LISTS, "the ids must ascend"},
    {circle_is_missing, OVERLAP, "overlaps its cell, but the leaf does not list it"},
    {circle_is_additional, OVERLAP, "does not overlap it, but the leaf lists it"},
    {circle_is_none, LISTS, "lists circle 60, but the scene has 60"},
    {leaf_box_is_shifted, CELLS, "node 9's child 20: found x ["},
    {inner_node_is_a_leaf, LIMITS, "is a leaf, expected it to be split"},
    {leaf_is_an_inner_node, LIMITS, "node 20 on level 5 with"},
    {leaf_is_an_inner_node, LIMITS, "is split, expected a leaf"},
    {map_has_a_tail, PACKING, "31 nodes and"},
    {there_is_only_a_root, CELLS, "the tree has 1 node, expected 31"},
};

Test(tree2d, each_fault_is_named)
{
    JobScene scene = subject_open();
    for (size_t i = 0; i < sizeof messages / sizeof *messages; i++) {
        KdTree2D tree = tree_copy(&scene.tree);
        messages[i].corrupt(&tree);
        for (size_t j = 0; j < sizeof judges / sizeof *judges; j++) {
            if (judges[j].bit == messages[i].judge) {
                char *message = judges[j].judge(&scene, &tree);
                cr_expect(message != NULL && strstr(message, messages[i].says) != NULL,
                          "found \"%s\", expected \"%s\"", message ? message : "(nothing)",
                          messages[i].says);
                free(message);
            }
        }
        tree2d_free(&tree);
    }
    job_scene_free(&scene);
}

// The first thing that a student sees: nothing is packed yet.
Test(tree2d, an_inner_node_without_children_is_told_as_what_it_mostly_is)
{
    NodeRel root = {0};
    u8 flag = INNER;
    BBox2D box = {0, 1, 0, 1};
    const KdTree2D tree = {
        .nodes_Relations = &root, .nodes_flag = &flag, .nodes_BBox = &box, .n_nodes = 1};
    capture_begin(2);
    const int result = tree2d_check(&tree, 0);
    expect_one_message(capture_end(2), "tree: node 0: marked INNER, but it has no children: was it "
                                       "packed as a leaf (pack_leaf)?");
    cr_expect_eq(result, -1);
}

Test(tree2d, the_depth_counts_levels)
{
    static const int DEPTHS[] = {1, 2, 5};
    for (size_t i = 0; i < sizeof DEPTHS / sizeof *DEPTHS; i++) {
        JobScene scene = scene_of("random:n=60,seed=3", 256, 200, (KdTreeLimits){DEPTHS[i], 1});
        cr_expect_eq(tree2d_depth(&scene.tree), DEPTHS[i]);
        job_scene_free(&scene);
    }
    const KdTree2D empty = {0};
    cr_expect_eq(tree2d_depth(&empty), 0);
}

Test(tree2d, memory_that_runs_out_beside_the_builder_is_told_once)
{
    JobScene scene = subject_open();
    capture_begin(2);
    n_allocations_left = 0;
    const int depth = tree2d_depth(&scene.tree);
    n_allocations_left = -1;
    expect_one_message(capture_end(2), "tree: no memory for the levels of 31 nodes");
    cr_expect_eq(depth, -1);

    FILE *file = tmpfile();
    capture_begin(2);
    n_allocations_left = 0;
    const int written = tree2d_write_svg(file, &scene.scene, &scene.tree);
    n_allocations_left = -1;
    expect_one_message(capture_end(2), "tree2d_write_svg: no memory for 60 circles");
    cr_expect_eq(written, -1);
    cr_expect_eq(ferror(file), 0, "the stream is as good as before");
    fclose(file);
    job_scene_free(&scene);
}

// A tree of another shape, consistent in itself: only the limits say which one was asked for.
static void expect_against_tree_of(const JobScene *scene, KdTreeLimits limits)
{
    KdTree2D tree;
    cr_assert_eq(kdtree2d_build(scene->scene.circles, (u32)scene->scene.n_circles, limits, &tree),
                 0);
    cr_assert_neq(tree.n_nodes, scene->tree.n_nodes);
    cr_expect_eq(tree2d_check(&tree, (u32)scene->scene.n_circles), 0);
    char *message = tree_judge_limits(scene, &tree);
    cr_expect_not_null(message, "maxDepth %d, targetElementsPerNode %d", limits.maxDepth,
                       limits.targetElementsPerNode);
    cr_expect_not_null(strstr(message ? message : "", "node "), "no node is named: %s", message);
    free(message);
    tree2d_free(&tree);
}

Test(tree2d, leaves_too_early_or_too_late_are_found)
{
    JobScene scene = subject_open();
    expect_against_tree_of(&scene, (KdTreeLimits){4, 2});
    expect_against_tree_of(&scene, (KdTreeLimits){6, 2});
    expect_against_tree_of(&scene, (KdTreeLimits){1, 2});
    job_scene_free(&scene);
    scene = scene_of("random:n=60,seed=3", 256, 200, (KdTreeLimits){9, 4});
    expect_against_tree_of(&scene, (KdTreeLimits){9, 3});
    expect_against_tree_of(&scene, (KdTreeLimits){9, 5});
    job_scene_free(&scene);
}

// ---- Trees made to do harm ----------------------------------------------------------------------

// Judge and write as SVG; what is found does not matter here, the sanitizers' silence does.
static void survive(const JobScene *scene, const KdTree2D *tree)
{
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        free(judges[i].judge(scene, tree));
    }
    (void)tree2d_check(tree, (u32)scene->scene.n_circles);
    char *svg = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&svg, &n_bytes);
    cr_expect_eq(tree2d_write_svg(file, &scene->scene, tree), 0);
    fclose(file);
    cr_expect(strstr(svg, "nan") == NULL && strstr(svg, "inf") == NULL, "not a number in an SVG");
    cr_expect_str_eq(svg + n_bytes - strlen("</svg>\n"), "</svg>\n");
    free(svg);
}

static const u32 hostile_numbers[] = {
    0, 1, 14, 15, 30, 31, 59, 60, 0x7fffffff, 0x80000000, 0xfffffff0, 0xfffffffe, 0xffffffff};
enum { N_HOSTILE = sizeof hostile_numbers / sizeof *hostile_numbers };

Test(tree2d, any_number_anywhere_is_survived)
{
    JobScene scene = subject_open();
    KdTree2D tree = tree_copy(&scene.tree);
    u32 *const arrays[] = {(u32 *)tree.nodes_Relations, tree.mapNode2Circles};
    const size_t lengths[] = {4 * tree.n_nodes, tree.n_map};
    for (int a = 0; a < 2; a++) {
        for (size_t i = 0; i < lengths[a]; i++) {
            const u32 was = arrays[a][i];
            for (int j = 0; j < N_HOSTILE; j++) {
                arrays[a][i] = hostile_numbers[j];
                for (size_t k = 0; k < sizeof judges / sizeof *judges; k++) {
                    free(judges[k].judge(&scene, &tree));
                }
            }
            arrays[a][i] = was;
        }
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

Test(tree2d, all_bits_set_and_random_bits_are_survived)
{
    JobScene scene = subject_open();
    Random random = {2};
    capture_begin(2);
    for (int round = 0; round < 400; round++) {
        KdTree2D tree = tree_copy(&scene.tree);
        void *const arrays[] = {tree.nodes_Relations, tree.nodes_flag, tree.nodes_BBox,
                                tree.mapNode2Circles};
        const size_t lengths[] = {tree.n_nodes * sizeof(NodeRel), tree.n_nodes,
                                  tree.n_nodes * sizeof(BBox2D), tree.n_map * sizeof(u32)};
        for (int a = 0; a < 4; a++) {
            // Each array in turn, and all at once; all ones first, then hostile and random numbers.
            if (round % 16 != 0 && (round % 16 & 1 << a) == 0) {
                continue;
            }
            memset(arrays[a], 0xff, lengths[a]);
            for (size_t i = 0; round >= 16 && i < lengths[a] / sizeof(u32); i++) {
                const u32 number = random_integer(&random, 0, 1)
                                       ? hostile_numbers[random_integer(&random, 0, N_HOSTILE - 1)]
                                       : (u32)random_bits(&random);
                memcpy((u32 *)arrays[a] + i, &number, sizeof number);
            }
        }
        survive(&scene, &tree);
        tree2d_free(&tree);
    }
    capture_end(2);
    job_scene_free(&scene);
}

// As many leaves as an answer may hold share one list of n_listed ids.
static void expect_judged(u32 n_listed)
{
    enum { N_NODES = 1 << 19, N_MAP = 1 << 22 };
    JobScene scene = scene_of("random:n=1000,seed=4,max=4", 200, 200, (KdTreeLimits){8, 2});
    KdTree2D tree = {calloc(N_NODES, sizeof(NodeRel)),
                     calloc(N_NODES, 1),
                     calloc(N_NODES, sizeof(BBox2D)),
                     calloc(N_MAP, sizeof(u32)),
                     N_NODES,
                     N_MAP};
    // Far from all circles, and with none of them in the list, each leaf is right by itself.
    for (u32 id = 0; id < N_NODES; id++) {
        tree.nodes_BBox[id] = (BBox2D){-9000, -8999, -9000, -8999};
    }
    memset(tree.mapNode2Circles, 0x7f, N_MAP * sizeof(u32));
    tree.mapNode2Circles[0] = n_listed;
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        char *message = judges[i].judge(&scene, &tree);
        cr_expect_not_null(message, "%s", judges[i].name);
        free(message);
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

// Without a bound on what is looked at, these would keep the grader busy for hours.
Test(tree2d, leaves_that_share_an_endless_list_are_judged_in_no_time)
{
    expect_judged((1 << 22) - 1);
}

Test(tree2d, leaves_without_end_are_judged_in_no_time)
{
    expect_judged(1000);
}

Test(tree2d, an_empty_tree_is_survived)
{
    JobScene scene = subject_open();
    KdTree2D empty = {0};
    survive(&scene, &empty);
    cr_expect_neq(judges_against(&scene, &empty) & (LIMITS | CELLS | OVERLAP | LISTS | PACKING), 0);
    tree2d_free(&empty);
    job_scene_free(&scene);
}

// ---- Drawing ------------------------------------------------------------------------------------

Test(tree2d, any_box_is_drawn_or_left_out)
{
    static const float numbers[] = {NAN,    -NAN, INFINITY, -INFINITY,     3e38f, -3e38f,
                                    1e-40f, 1e9f, -1e9f,    2147483648.0f, 0,     12.5f};
    enum { N_NUMBERS = sizeof numbers / sizeof *numbers };
    JobScene scene = subject_open();
    Random random = {3};
    KdTree2D tree = tree_copy(&scene.tree);
    for (int round = 0; round < 20; round++) {
        float *values = (float *)tree.nodes_BBox;
        for (size_t i = 0; i < 4 * tree.n_nodes; i++) {
            values[i] = numbers[random_integer(&random, 0, N_NUMBERS - 1)];
        }
        survive(&scene, &tree);
        Image image;
        cr_assert_eq(tree2d_draw(&scene.scene, &tree, &image), 0);
        cr_expect(image.width == 640 && image.height == 480);
        for (int i = 0; i < 640 * 480 * IMAGE_CHANNELS; i++) {
            cr_assert(image.pixels[i] >= 0 && image.pixels[i] <= 1);
        }
        image_free(&image);
    }
    tree2d_free(&tree);
    job_scene_free(&scene);
}

// How many pixels of the drawing have a cell border's colour.
static int count_border_pixels(const Scene2D *scene, const KdTree2D *tree)
{
    Image image;
    cr_assert_eq(tree2d_draw(scene, tree, &image), 0);
    int n = 0;
    for (int i = 0; i < image.width * image.height; i++) {
        n += image.pixels[IMAGE_CHANNELS * i + 2] == 0.92f;
    }
    image_free(&image);
    return n;
}

Test(tree2d, cells_are_drawn_where_they_are)
{
    // The example's root is the picture, 64 times magnified: eight cells on the last level, 2.5 by
    // 5.
    JobScene scene = scene_of("example", 10, 10, (KdTreeLimits){4, 1});
    cr_expect_eq(count_border_pixels(&scene.scene, &scene.tree), 4 * 640 + 2 * 640 - 4 * 2,
                 "four vertical lines cross two horizontal ones");
    char *svg = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&svg, &n_bytes);
    cr_assert_eq(tree2d_write_svg(file, &scene.scene, &scene.tree), 0);
    fclose(file);
    cr_expect_not_null(strstr(svg, "<rect x=\"320\" y=\"320\" width=\"160\" height=\"320\"/>"),
                       "node 13's cell");
    cr_expect_not_null(strstr(svg, ">13</text>"));
    cr_expect_null(strstr(svg, ">6</text>"), "an inner node has no cell of its own");
    free(svg);
    job_scene_free(&scene);
}

Test(tree2d, an_svg_that_cannot_be_written_is_told)
{
    JobScene scene = subject_open();
    FILE *full = fopen("/dev/full", "w");
    cr_assert_not_null(full);
    setvbuf(full, NULL, _IONBF, 0);
    cr_expect_eq(tree2d_write_svg(full, &scene.scene, &scene.tree), -1);
    fclose(full);
    job_scene_free(&scene);
}

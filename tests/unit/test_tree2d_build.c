// Lab 02's solution: good trees for every scene, and a message where there can be none.
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "random.h"
#include "tree2d_subject.h"

#include <math.h>

// The builder and the tree are compiled in here with limits that are reached within milliseconds,
// and with memory that runs out when a test wants it to.
#undef TREE2D_MAX_ENTRIES
#undef TREE2D_MAX_NODES
#define TREE2D_MAX_ENTRIES (1u << 16)
#define TREE2D_MAX_NODES (1u << 14)
#include "scarce_memory.h"

#include "kdtree2d_build.c"
#include "tree2d.c"
#include "tree2d_grow.c"
#undef malloc
#undef calloc
#undef realloc

TestSuite(tree2d_build);

// ---- Building -----------------------------------------------------------------------------------

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

Test(tree2d_build, random_scenes_give_good_trees)
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

Test(tree2d_build, edge_cases_give_good_trees)
{
    for (int i = 0; scene2d_edge_case(i) != NULL; i++) {
        JobScene scene = scene_of(scene2d_edge_case(i), 64, 48, (KdTreeLimits){6, 2});
        expect_good(&scene);
        job_scene_free(&scene);
    }
}

Test(tree2d_build, the_worked_example_comes_out_as_in_the_lecture)
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

Test(tree2d_build, no_circle_and_one_circle_are_one_leaf)
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

Test(tree2d_build, one_level_holds_everything)
{
    JobScene scene = scene_of("random:n=50", 64, 48, (KdTreeLimits){1, 1});
    cr_expect(scene.tree.n_nodes == 1 && scene.tree.n_map == 51);
    expect_good(&scene);
    job_scene_free(&scene);
}

Test(tree2d_build, coincident_circles_end_at_the_last_level)
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

Test(tree2d_build, a_split_fails_when_both_children_keep_nearly_all)
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

Test(tree2d_build, coincident_circles_end_after_failed_splits)
{
    JobScene scene = row_of(2000, (Circle){.x = 20, .y = 20, .radius = 3.5f}, 0, 0);
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){16, 8}), 0);
    expect_good(&scene);
    cr_expect_eq(scene.tree.n_nodes, 31, "four levels of failed splits above 16 leaves");
    cr_expect_eq(scene.tree.n_map, 16 * 2001);
    job_scene_free(&scene);
}

Test(tree2d_build, concentric_circles_are_no_more_entries_than_the_cells_need)
{
    JobScene scene = row_of(500, (Circle){.x = 300, .y = 300, .radius = 1}, 0, 0.5f);
    cr_assert_eq(job_scene_grow_tree(&scene, (KdTreeLimits){16, 8}), 0);
    expect_good(&scene);
    job_scene_free(&scene);
}

// One large circle makes the root's cell square, and all others lie on the plane that halves it.
Test(tree2d_build, splits_go_on_after_one_that_failed)
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

Test(tree2d_build, circles_overlap_boxes_as_the_oracle_says)
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

static void expect_refused(JobScene scene, KdTreeLimits limits, KdFault fault, const char *part)
{
    KdTree2D tree;
    memset(&tree, 0x5a, sizeof tree);
    const KdTree2D untouched = tree;
    cr_expect_eq(WITH_MESSAGE(part, kdtree2d_build(scene.scene.circles, (u32)scene.scene.n_circles,
                                                   limits, &tree)),
                 (int)fault);
    cr_expect_eq(memcmp(&tree, &untouched, sizeof tree), 0);
    job_scene_free(&scene);
}

Test(tree2d_build, too_many_nodes_are_refused)
{
    expect_refused(row_of(9000, (Circle){.radius = 0.25f}, 1, 0), (KdTreeLimits){40, 1},
                   KD_TOO_MANY_NODES, "too many nodes");
}

Test(tree2d_build, too_many_entries_are_refused)
{
    expect_refused(row_of(5000, (Circle){.radius = 1}, 0, 0), (KdTreeLimits){40, 1},
                   KD_TOO_MANY_CIRCLES, "the leaves would hold too many circles");
}

Test(tree2d_build, memory_that_runs_out_is_told_wherever_it_does)
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
            cr_expect_eq(result, KD_NO_MEMORY);
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

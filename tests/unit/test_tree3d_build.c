// Lab 06's solution: it builds what it should, refuses what it must and says so. What is in a tree
// is test_tree3d_judge.c's matter.
#include "random.h"
#include "scene3d.h"
#include "surroundings.h"
#include "tree3d.h"

#include <math.h>
#include <stdint.h>

// The builder and the tree are compiled in here with limits that are reached within milliseconds,
// and with memory that runs out when a test wants it to.
#undef TREE3D_MAX_SPHERE_IDS
#undef TREE3D_MAX_NODES
#define TREE3D_MAX_SPHERE_IDS (1u << 16)
#define TREE3D_MAX_NODES (1u << 14)
#include "scarce_memory.h"

#include "kdtree3d_build.c"
#include "tree3d.c"
#include "tree3d_grow.c"
#undef malloc
#undef calloc
#undef realloc

TestSuite(tree3d_build);

// ---- Building -----------------------------------------------------------------------------------

// What holds for every tree, seen from the root: walk down with cells, and count.
static void expect_sound(const KdTree3D *tree, const Sphere *spheres, u32 n_spheres)
{
    cr_assert_eq(tree3d_check(tree, n_spheres), 0);
    BBox3D *cells = calloc(tree->n_nodes, sizeof *cells);
    cells[0] = tree->bounds;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        const BBox3D cell = cells[id];
        for (int axis = 0; axis < 3; axis++) {
            cr_assert(isfinite(cell.min[axis]) && isfinite(cell.max[axis]));
            cr_assert_leq(cell.min[axis], cell.max[axis]);
        }
        if (node.split_axis != KD_LEAF) {
            cells[node.first] = cells[node.first + 1] = cell;
            cells[node.first].max[node.split_axis] = node.split_pos;
            cells[node.first + 1].min[node.split_axis] = node.split_pos;
            cr_assert_eq(node.n_spheres, 0);
            continue;
        }
        for (u32 i = 0; i < node.n_spheres; i++) {
            cr_assert(sphere_overlaps_box(spheres[tree->sphere_ids[node.first + i]], cell));
        }
    }
    free(cells);
}

static KdTree3D build(const Sphere *spheres, u32 n_spheres, KdTreeLimits limits)
{
    KdTree3D tree;
    cr_assert_eq(kdtree3d_build(spheres, n_spheres, limits, &tree), 0);
    expect_sound(&tree, spheres, n_spheres);
    return tree;
}

Test(tree3d_build, no_sphere_is_one_empty_leaf_at_the_origin)
{
    KdTree3D tree = build(NULL, 0, (KdTreeLimits){9, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 0);
    cr_expect(tree.nodes[0].split_axis == KD_LEAF && tree.nodes[0].n_spheres == 0);
    for (int axis = 0; axis < 3; axis++) {
        cr_expect(tree.bounds.min[axis] == 0 && tree.bounds.max[axis] == 0);
    }
    tree3d_free(&tree);
}

Test(tree3d_build, one_sphere_is_one_leaf)
{
    const Sphere sphere = {1, -2, 3, -0.5f};
    KdTree3D tree = build(&sphere, 1, (KdTreeLimits){9, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 1 && tree.sphere_ids[0] == 0);
    cr_expect(tree.bounds.min[0] == 0.5f && tree.bounds.max[0] == 1.5f);
    cr_expect(tree.bounds.min[1] == -2.5f && tree.bounds.max[1] == -1.5f);
    cr_expect(tree.bounds.min[2] == 2.5f && tree.bounds.max[2] == 3.5f);
    tree3d_free(&tree);
}

Test(tree3d_build, two_spheres_are_separated)
{
    const Sphere spheres[] = {{4, 0, 0, 1}, {-4, 0, 0, 1}};
    KdTree3D tree = build(spheres, 2, (KdTreeLimits){9, 1});
    cr_assert(tree.n_nodes == 3 && tree.n_sphere_ids == 2);
    cr_expect(tree.nodes[0].split_axis == 0 && tree.nodes[0].split_pos == 0);
    cr_expect(tree.nodes[0].first == 1 && tree.nodes[0].n_spheres == 0);
    cr_expect(tree.sphere_ids[tree.nodes[1].first] == 1, "the lower child holds the second sphere");
    cr_expect(tree.sphere_ids[tree.nodes[2].first] == 0);
    tree3d_free(&tree);
}

Test(tree3d_build, a_sphere_that_touches_the_plane_is_on_both_sides)
{
    const Sphere spheres[] = {{-3, 0, 0, 1}, {1, 0, 0, 1}, {3, 0, 0, 1}};
    KdTree3D tree = build(spheres, 3, (KdTreeLimits){2, 1});
    cr_assert(tree.n_nodes == 3 && tree.nodes[0].split_pos == 0);
    cr_expect(tree.nodes[1].n_spheres == 2 && tree.nodes[2].n_spheres == 2);
    tree3d_free(&tree);
}

Test(tree3d_build, one_level_holds_everything)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open("random:n=50", 0, 0, &scene), 0);
    KdTree3D tree = build(scene.spheres, 50, (KdTreeLimits){1, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 50);
    tree3d_free(&tree);
    scene3d_free(&scene);
}

Test(tree3d_build, coincident_spheres_end_at_the_last_level)
{
    Sphere spheres[5];
    for (int i = 0; i < 5; i++) {
        spheres[i] = (Sphere){7, 7, 7, 1};
    }
    KdTree3D tree = build(spheres, 5, (KdTreeLimits){4, 4});
    TreeFigures3D figures;
    cr_assert_eq(tree3d_figures(&tree, &figures), 0);
    cr_expect_eq(figures.depth, 4);
    tree3d_free(&tree);
}

Test(tree3d_build, coincident_spheres_end_after_failed_splits)
{
    Sphere spheres[2000];
    for (int i = 0; i < 2000; i++) {
        spheres[i] = (Sphere){7, 7, 7, 1};
    }
    KdTree3D tree = build(spheres, 2000, tree3d_limits(0, 0, 2000));
    cr_expect_eq(tree.n_nodes, 31, "four levels of failed splits above 16 leaves");
    cr_expect_eq(tree.n_sphere_ids, 16 * 2000);
    tree3d_free(&tree);
}

// Concentric spheres: cells outside of the smaller ones still lose them.
Test(tree3d_build, splits_that_help_go_on_after_some_that_failed)
{
    Sphere spheres[300];
    for (int i = 0; i < 300; i++) {
        spheres[i] = (Sphere){0, 0, 0, (float)(i + 1)};
    }
    KdTree3D tree = build(spheres, 300, tree3d_limits(0, 0, 300));
    TreeFigures3D figures;
    cr_assert_eq(tree3d_figures(&tree, &figures), 0);
    cr_expect_gt(figures.n_leaves, 100);
    cr_expect_lt(tree.n_sphere_ids, figures.n_leaves * 300 / 4);
    tree3d_free(&tree);
}

// A negative radius counts as its absolute value: the same tree comes out.
Test(tree3d_build, the_sign_of_a_radius_changes_nothing)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open("random:n=200,seed=3", 0, 0, &scene), 0);
    KdTree3D tree = build(scene.spheres, 200, (KdTreeLimits){10, 3});
    for (int i = 0; i < 200; i += 3) {
        scene.spheres[i].radius *= -1;
    }
    KdTree3D same = build(scene.spheres, 200, (KdTreeLimits){10, 3});
    cr_assert(same.n_nodes == tree.n_nodes && same.n_sphere_ids == tree.n_sphere_ids);
    cr_expect_eq(memcmp(&same.bounds, &tree.bounds, sizeof tree.bounds), 0);
    cr_expect_eq(memcmp(same.nodes, tree.nodes, tree.n_nodes * sizeof *tree.nodes), 0);
    cr_expect_eq(memcmp(same.sphere_ids, tree.sphere_ids, tree.n_sphere_ids * sizeof(u32)), 0);
    tree3d_free(&same);
    tree3d_free(&tree);
    scene3d_free(&scene);
}

// Very large, very small, very flat and very far scenes: every cell stays a box of numbers.
Test(tree3d_build, no_cell_is_ever_infinite_or_inside_out)
{
    static const float scales[] = {1e-30f, 1e-6f, 1, 1e6f, 1e18f, 1e37f};
    Random random = {5};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        Sphere spheres[40];
        for (int kind = 0; kind < 3; kind++) {
            for (int j = 0; j < 40; j++) {
                const float s = scales[i];
                spheres[j].x = s * random_grid(&random, -2, 2) + (kind == 1 ? 1000 * s : 0);
                spheres[j].y = kind == 2 ? s : s * random_grid(&random, -2, 2);
                spheres[j].z = s * random_grid(&random, -2, 2);
                spheres[j].radius = s / (float)(1 << random_integer(&random, 0, 12));
            }
            if (i < 5 || kind != 1) {
                KdTree3D tree = build(spheres, 40, (KdTreeLimits){12, 2});
                tree3d_free(&tree);
            }
        }
    }
}

// ---- Refused ------------------------------------------------------------------------------------

static void expect_refused(const Sphere *spheres, u32 n_spheres, KdTreeLimits limits,
                           const char *part)
{
    KdTree3D tree;
    memset(&tree, 0x5a, sizeof tree);
    const KdTree3D untouched = tree;
    cr_expect_eq(WITH_MESSAGE(part, kdtree3d_build(spheres, n_spheres, limits, &tree)), -1);
    cr_expect_eq(memcmp(&tree, &untouched, sizeof tree), 0, "nothing half-written");
}

Test(tree3d_build, a_tree_too_deep_for_the_todo_stack_is_refused)
{
    const float tiny = 1.0f / (1 << 18);
    const Sphere spheres[] = {
        {0.3f, 0.4f, 0.45f, tiny}, {0.3f, 0.4f, 0.45f, tiny}, {-1, -1, -1, 0.25f}};
    KdTree3D tree = build(spheres, 3, (KdTreeLimits){TODO_SIZE + 1, 1});
    TreeFigures3D figures;
    cr_assert_eq(tree3d_figures(&tree, &figures), 0);
    cr_expect_eq(figures.depth, TODO_SIZE + 1);
    tree3d_free(&tree);
    expect_refused(spheres, 3, (KdTreeLimits){TODO_SIZE + 2, 1}, "too deep for the todo stack");
    // The limit alone does not matter: one sphere is a leaf at once.
    tree = build(spheres, 1, (KdTreeLimits){TODO_SIZE + 2, 1});
    tree3d_free(&tree);
}

Test(tree3d_build, too_many_nodes_are_refused)
{
    Sphere spheres[9000];
    for (int i = 0; i < 9000; i++) {
        spheres[i] = (Sphere){(float)i, 0, 0, 0.25f};
    }
    expect_refused(spheres, 9000, (KdTreeLimits){TODO_SIZE + 1, 1}, "too many nodes");
}

Test(tree3d_build, too_many_spheres_in_leaves_are_refused)
{
    Sphere spheres[5000];
    for (int i = 0; i < 5000; i++) {
        spheres[i] = (Sphere){0, 0, 0, 1};
    }
    expect_refused(spheres, 5000, (KdTreeLimits){TODO_SIZE + 1, 1},
                   "the leaves would hold too many spheres");
}

Test(tree3d_build, memory_that_runs_out_is_told_wherever_it_does)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open("random:n=300", 0, 0, &scene), 0);
    int result = -1;
    for (int n = 0; result != 0; n++) {
        KdTree3D tree = {0};
        capture_begin(2);
        n_allocations_left = n;
        result = kdtree3d_build(scene.spheres, 300, (KdTreeLimits){12, 2}, &tree);
        n_allocations_left = -1;
        const char *message = capture_end(2);
        if (result != 0) {
            expect_one_message(message, "kdtree3d_build: no memory");
            cr_assert_lt(n, 5000);
        } else {
            cr_expect_str_eq(message, "");
            cr_expect_gt(n, 4, "at least the arrays");
        }
        tree3d_free(&tree);
    }
    scene3d_free(&scene);
}

// The 3D tree on the host: tree3d_check() names each kind of fault, figures and limits are right,
// and lab 06's solution builds what it should, refuses what it must and says so. What is in a tree
// is test_tree3d_judge.c's matter.
#include "random.h"
#include "scene3d.h"
#include "surroundings.h"

#include <math.h>
#include <stdint.h>

// The builder and the checks are compiled in here with limits that are reached within milliseconds,
// and with memory that runs out when a test wants it to.
#include "tree3d.h"
#undef TREE3D_MAX_SPHERE_IDS
#undef TREE3D_MAX_NODES
#define TREE3D_MAX_SPHERE_IDS (1u << 16)
#define TREE3D_MAX_NODES (1u << 14)

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
#include "kdtree3d_build.c"
#include "tree3d.c"
#undef malloc
#undef calloc
#undef realloc

TestSuite(tree3d);

// ---- tree3d_check() -----------------------------------------------------------------------------

// The subject: 5 nodes over 4 spheres. 0 is split at x, its child 2 at y; 1, 3 and 4 are leaves.
typedef struct Subject {
    KdNode3 nodes[5];
    u32 sphere_ids[5];
    KdTree3D tree;
} Subject;

static Subject *subject_open(void)
{
    static Subject subject;
    subject = (Subject){.nodes = {{0, 0, 1, 0},
                                  {0, KD_LEAF, 0, 2},
                                  {0.5f, 1, 3, 0},
                                  {0, KD_LEAF, 2, 0},
                                  {0, KD_LEAF, 2, 3}},
                        .sphere_ids = {0, 2, 1, 2, 3}};
    subject.tree = (KdTree3D){.bounds = {{-1, -1, -1}, {1, 1, 1}},
                              .nodes = subject.nodes,
                              .sphere_ids = subject.sphere_ids,
                              .n_nodes = 5,
                              .n_sphere_ids = 5};
    return &subject;
}

static void expect_fault(const KdTree3D *tree, u32 n_spheres, const char *part)
{
    capture_begin(2);
    const int result = tree3d_check(tree, n_spheres);
    expect_one_message(capture_end(2), part);
    cr_expect_eq(result, -1, "%s", part);
}

Test(tree3d, a_good_tree_passes_without_a_word)
{
    capture_begin(2);
    const int result = tree3d_check(&subject_open()->tree, 4);
    cr_expect_str_eq(capture_end(2), "");
    cr_expect_eq(result, 0);
}

static void axis_is_none(Subject *s)
{
    s->nodes[2].split_axis = 4;
}

static void axis_is_far_out(Subject *s)
{
    s->nodes[2].split_axis = 0xffffffff;
}

static void child_is_itself(Subject *s)
{
    s->nodes[2].first = 2;
}

static void child_is_its_parent(Subject *s)
{
    s->nodes[2].first = 0;
}

static void second_child_is_missing(Subject *s)
{
    s->nodes[2].first = 4;
}

static void children_are_far_out(Subject *s)
{
    s->nodes[2].first = 0xffffffff;
}

static void range_is_too_long(Subject *s)
{
    s->nodes[4].n_spheres = 4;
}

static void range_begins_behind_the_end(Subject *s)
{
    s->nodes[1].first = 6;
}

static void range_wraps_around(Subject *s)
{
    s->nodes[1].first = 2;
    s->nodes[1].n_spheres = 0xffffffff;
}

static void sphere_is_none(Subject *s)
{
    s->sphere_ids[4] = 4;
}

static void leaf_is_not_marked(Subject *s)
{
    s->nodes[4].split_axis = 0;
    s->nodes[4].first = 0;
}

static const struct {
    void (*break_it)(Subject *s);
    const char *says;
} faults[] = {
    {axis_is_none, "tree: node 2: found split_axis 4, expected 0, 1, 2 or 3 (KD_LEAF)"},
    {axis_is_far_out, "tree: node 2: found split_axis 4294967295"},
    {child_is_itself, "tree: node 2: found its children at 2 and 3, expected ids from 3 to 4"},
    {child_is_its_parent, "tree: node 2: found its children at 0"},
    {second_child_is_missing, "tree: node 2: found its children at 4"},
    {children_are_far_out, "tree: node 2: found its children at 4294967295"},
    {range_is_too_long, "tree: leaf 4: "},
    {range_begins_behind_the_end, "tree: leaf 1: "},
    {range_wraps_around, "tree: leaf 1: "},
    {sphere_is_none, "tree: leaf 4: found sphere id 4, but the scene has 4 spheres"},
    {leaf_is_not_marked, "tree: node 4: found its children at 0"},
};

Test(tree3d, each_fault_is_named)
{
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        Subject *subject = subject_open();
        faults[i].break_it(subject);
        expect_fault(&subject->tree, 4, faults[i].says);
    }
}

// A chain: each inner node has a leaf and the next inner node. n_levels in all.
static KdTree3D chain_open(int n_levels)
{
    const u32 n_nodes = 2 * (u32)n_levels - 1;
    KdTree3D tree = {.nodes = calloc(n_nodes, sizeof *tree.nodes), .n_nodes = n_nodes};
    for (u32 id = 0; id < n_nodes; id++) {
        const int is_inner = id % 2 == 0 && id + 2 < n_nodes;
        tree.nodes[id] = is_inner ? (KdNode3){.first = id + 1} : (KdNode3){.split_axis = KD_LEAF};
    }
    return tree;
}

Test(tree3d, a_tree_may_be_as_deep_as_the_todo_stack_allows)
{
    KdTree3D tree = chain_open(TODO_SIZE + 1);
    TreeFigures3D figures;
    cr_expect_eq(tree3d_check(&tree, 0), 0);
    cr_assert_eq(tree3d_figures(&tree, &figures), 0);
    cr_expect_eq(figures.depth, TODO_SIZE + 1);
    tree3d_free(&tree);
    tree = chain_open(TODO_SIZE + 2);
    char message[96];
    snprintf(message, sizeof message, "split on level %d, but the todo stack has %d places",
             TODO_SIZE + 1, TODO_SIZE);
    expect_fault(&tree, 0, message);
    tree3d_free(&tree);
}

Test(tree3d, any_number_anywhere_is_survived)
{
    static const u32 numbers[] = {0, 1,          2,          3,          4,         5,
                                  6, 0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff};
    capture_begin(2);
    for (size_t word = 0; word < sizeof(KdNode3) / 4 * 5 + 5; word++) {
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            Subject *subject = subject_open();
            char *place = word < 20 ? (char *)subject->nodes + 4 * word
                                    : (char *)(subject->sphere_ids + (word - 20));
            memcpy(place, &numbers[i], sizeof numbers[i]);
            TreeFigures3D figures;
            if (tree3d_check(&subject->tree, 4) == 0) {
                cr_expect_eq(tree3d_figures(&subject->tree, &figures), 0);
            }
        }
    }
    capture_end(2);
}

Test(tree3d, an_empty_tree_is_survived)
{
    KdTree3D tree = {0};
    TreeFigures3D figures;
    (void)tree3d_check(&tree, 0);
    cr_expect_eq(tree3d_figures(&tree, &figures), 0);
    cr_expect_eq(figures.depth, 0);
    tree3d_free(&tree);
}

// ---- Figures and limits -------------------------------------------------------------------------

Test(tree3d, figures_count)
{
    TreeFigures3D figures;
    cr_assert_eq(tree3d_figures(&subject_open()->tree, &figures), 0);
    cr_expect_eq(figures.depth, 3);
    cr_expect_eq(figures.n_leaves, 3);
    cr_expect_eq(figures.n_empty, 1);
    cr_expect_eq(figures.largest_leaf, 3);
}

Test(tree3d, memory_that_runs_out_beside_the_builder_is_told_once)
{
    const KdTree3D *tree = &subject_open()->tree;
    TreeFigures3D figures;
    n_allocations_left = 0;
    expect_fault(tree, 4, "tree: no memory for the levels of 5 nodes");
    capture_begin(2);
    const int result = tree3d_figures(tree, &figures);
    n_allocations_left = -1;
    expect_one_message(capture_end(2), "tree: no memory for the levels of 5 nodes");
    cr_expect_eq(result, -1);
}

Test(tree3d, limits_are_the_users_or_fit_the_scene)
{
    KdTreeLimits limits = tree3d_limits(7, 3, 1000);
    cr_expect(limits.maxDepth == 7 && limits.targetElementsPerNode == 3);
    limits = tree3d_limits(0, 3, 1000);
    cr_expect(limits.maxDepth > 0 && limits.targetElementsPerNode == 3);
    limits = tree3d_limits(7, 0, 1000);
    cr_expect(limits.maxDepth == 7 && limits.targetElementsPerNode > 0);
    int previous = 0;
    for (u32 n = 0; n < 32; n++) {
        const u32 n_spheres = n < 31 ? 1u << n : UINT32_MAX;
        limits = tree3d_limits(0, 0, n_spheres);
        cr_expect_geq(limits.maxDepth, previous, "more spheres, no fewer levels");
        cr_expect_leq(limits.maxDepth, TODO_SIZE + 1, "%u spheres: never refused for its depth",
                      n_spheres);
        previous = limits.maxDepth;
    }
    cr_expect_gt(tree3d_limits(0, 0, 0).maxDepth, 0);
}

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

Test(tree3d, no_sphere_is_one_empty_leaf_at_the_origin)
{
    KdTree3D tree = build(NULL, 0, (KdTreeLimits){9, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 0);
    cr_expect(tree.nodes[0].split_axis == KD_LEAF && tree.nodes[0].n_spheres == 0);
    for (int axis = 0; axis < 3; axis++) {
        cr_expect(tree.bounds.min[axis] == 0 && tree.bounds.max[axis] == 0);
    }
    tree3d_free(&tree);
}

Test(tree3d, one_sphere_is_one_leaf)
{
    const Sphere sphere = {1, -2, 3, -0.5f};
    KdTree3D tree = build(&sphere, 1, (KdTreeLimits){9, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 1 && tree.sphere_ids[0] == 0);
    cr_expect(tree.bounds.min[0] == 0.5f && tree.bounds.max[0] == 1.5f);
    cr_expect(tree.bounds.min[1] == -2.5f && tree.bounds.max[1] == -1.5f);
    cr_expect(tree.bounds.min[2] == 2.5f && tree.bounds.max[2] == 3.5f);
    tree3d_free(&tree);
}

Test(tree3d, two_spheres_are_separated)
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

Test(tree3d, a_sphere_that_touches_the_plane_is_on_both_sides)
{
    const Sphere spheres[] = {{-3, 0, 0, 1}, {1, 0, 0, 1}, {3, 0, 0, 1}};
    KdTree3D tree = build(spheres, 3, (KdTreeLimits){2, 1});
    cr_assert(tree.n_nodes == 3 && tree.nodes[0].split_pos == 0);
    cr_expect(tree.nodes[1].n_spheres == 2 && tree.nodes[2].n_spheres == 2);
    tree3d_free(&tree);
}

Test(tree3d, one_level_holds_everything)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open("random:n=50", 0, 0, &scene), 0);
    KdTree3D tree = build(scene.spheres, 50, (KdTreeLimits){1, 1});
    cr_expect(tree.n_nodes == 1 && tree.n_sphere_ids == 50);
    tree3d_free(&tree);
    scene3d_free(&scene);
}

Test(tree3d, coincident_spheres_end_at_the_last_level)
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

Test(tree3d, coincident_spheres_end_after_failed_splits)
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
Test(tree3d, splits_that_help_go_on_after_some_that_failed)
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
Test(tree3d, the_sign_of_a_radius_changes_nothing)
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
Test(tree3d, no_cell_is_ever_infinite_or_inside_out)
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
    capture_begin(2);
    const int result = kdtree3d_build(spheres, n_spheres, limits, &tree);
    expect_one_message(capture_end(2), part);
    cr_expect_eq(result, -1);
    cr_expect_eq(memcmp(&tree, &untouched, sizeof tree), 0, "nothing half-written");
}

Test(tree3d, a_tree_too_deep_for_the_todo_stack_is_refused)
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

Test(tree3d, too_many_nodes_are_refused)
{
    Sphere spheres[9000];
    for (int i = 0; i < 9000; i++) {
        spheres[i] = (Sphere){(float)i, 0, 0, 0.25f};
    }
    expect_refused(spheres, 9000, (KdTreeLimits){TODO_SIZE + 1, 1}, "too many nodes");
}

Test(tree3d, too_many_spheres_in_leaves_are_refused)
{
    Sphere spheres[5000];
    for (int i = 0; i < 5000; i++) {
        spheres[i] = (Sphere){0, 0, 0, 1};
    }
    expect_refused(spheres, 5000, (KdTreeLimits){TODO_SIZE + 1, 1},
                   "the leaves would hold too many spheres");
}

Test(tree3d, memory_that_runs_out_is_told_wherever_it_does)
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

// common/tree3d: tree3d_check() names each kind of fault, figures and limits are right. What is in
// a tree is test_tree3d_judge.c's matter.
#include "surroundings.h"
#include "tree3d.h"

#include <stdint.h>

// The tree is compiled in here with memory that runs out when a test wants it to.
#include "scarce_memory.h"

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
    cr_expect_eq(WITH_MESSAGE(part, tree3d_check(tree, n_spheres)), -1, "%s", part);
}

Test(tree3d, a_good_tree_passes_without_a_word)
{
    capture_begin(2);
    const int result = tree3d_check(&subject_open()->tree, 4);
    cr_expect_str_eq(capture_end(2), "");
    cr_expect_eq(result, 0);
}

// What a node becomes.
static const struct {
    u32 id;
    KdNode3 node;
    const char *says;
} faults[] = {
    {2, {0.5f, 4, 3, 0}, "tree: node 2: found split_axis 4, expected 0, 1, 2 or 3 (KD_LEAF)"},
    {2, {0.5f, 0xffffffff, 3, 0}, "tree: node 2: found split_axis 4294967295"},
    {2, {0.5f, 1, 2, 0}, "tree: node 2: found its children at 2 and 3, expected ids from 3 to 4"},
    {2, {0.5f, 1, 0, 0}, "tree: node 2: found its children at 0"},
    {2, {0.5f, 1, 4, 0}, "tree: node 2: found its children at 4"},
    {2, {0.5f, 1, 0xffffffff, 0}, "tree: node 2: found its children at 4294967295"},
    {4, {0, KD_LEAF, 2, 4}, "tree: leaf 4: "},
    {1, {0, KD_LEAF, 6, 2}, "tree: leaf 1: "},
    {1, {0, KD_LEAF, 2, 0xffffffff}, "tree: leaf 1: "},
    {4, {0, 0, 0, 3}, "tree: node 4: found its children at 0"},
};

Test(tree3d, each_fault_is_named)
{
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        Subject *subject = subject_open();
        subject->nodes[faults[i].id] = faults[i].node;
        expect_fault(&subject->tree, 4, faults[i].says);
    }
    Subject *subject = subject_open();
    subject->sphere_ids[4] = 4;
    expect_fault(&subject->tree, 4, "tree: leaf 4: found sphere id 4, but the scene has 4 spheres");
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

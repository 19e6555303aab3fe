// The judges of 3D trees: each fault is found by the judges that look at it and by no other, and is
// named.
#include "kdtree3d_build.h"
#include "tree3d_subject.h"

#include <math.h>

TestSuite(tree3d_faults);

static u32 *list_of(const KdTree3D *tree, u32 id)
{
    return tree->sphere_ids + tree->nodes[id].first;
}

static void bounds_are_too_wide(KdTree3D *t)
{
    t->bounds.max[1] += 0.125f;
}
static void bounds_are_one_step_off(KdTree3D *t)
{
    t->bounds.min[0] = nextafterf(t->bounds.min[0], -2);
}
static void bounds_are_not_numbers(KdTree3D *t)
{
    t->bounds.min[2] = NAN;
}
static void last_plane_is_moved(KdTree3D *t)
{
    t->nodes[N_INNER - 1].split_pos += 0.25f;
}
static void last_plane_is_moved_by_a_hair(KdTree3D *t)
{
    t->nodes[N_INNER - 1].split_pos += 1e-6f;
}
static void last_axis_is_another(KdTree3D *t)
{
    t->nodes[N_INNER - 1].split_axis = (t->nodes[N_INNER - 1].split_axis + 1) % 3;
}
static void ranges_are_swapped(KdTree3D *t)
{
    const u32 first = t->nodes[A_LEAF].first;
    t->nodes[A_LEAF].first = t->nodes[A_LEAF + 1].first;
    t->nodes[A_LEAF + 1].first = first;
}
static void count_is_one_less(KdTree3D *t)
{
    t->nodes[A_LEAF].n_spheres--;
}
static void last_count_is_one_more(KdTree3D *t)
{
    t->nodes[N_NODES - 1].n_spheres++;
}
static void list_is_unsorted(KdTree3D *t)
{
    u32 *list = list_of(t, A_LEAF);
    const u32 id = list[0];
    list[0] = list[1];
    list[1] = id;
}
static void sphere_is_listed_twice(KdTree3D *t)
{
    list_of(t, A_LEAF)[1] = list_of(t, A_LEAF)[0];
}
static void sphere_is_another(KdTree3D *t)
{
    // The leaf's last may be 59 already: then the one before it is free.
    u32 *last = &list_of(t, A_LEAF)[t->nodes[A_LEAF].n_spheres - 1];
    *last = *last < 59 ? *last + 1 : 58;
}
static void sphere_is_none(KdTree3D *t)
{
    list_of(t, A_LEAF)[t->nodes[A_LEAF].n_spheres - 1] = 60;
}
static void ids_have_a_tail(KdTree3D *t)
{
    t->sphere_ids = realloc(t->sphere_ids, (t->n_sphere_ids + 1) * sizeof *t->sphere_ids);
    t->sphere_ids[t->n_sphere_ids++] = 0;
}
static void ids_are_cut_off(KdTree3D *t)
{
    t->n_sphere_ids--;
}
static void nodes_have_a_tail(KdTree3D *t)
{
    t->nodes = realloc(t->nodes, (t->n_nodes + 2) * sizeof *t->nodes);
    t->nodes[t->n_nodes++] = (KdNode3){0, KD_LEAF, t->n_sphere_ids, 0};
    t->nodes[t->n_nodes++] = (KdNode3){0, KD_LEAF, t->n_sphere_ids, 0};
}
static void nodes_are_cut_off(KdTree3D *t)
{
    t->n_nodes -= 2;
}

#define NODE(id, member, number)                                                                   \
    {offsetof(KdTree3D, nodes), (id) * sizeof(KdNode3) + offsetof(KdNode3, member), sizeof(u32),   \
     number}

static const Fault faults[] = {
    // Moving the box or a plane moves cells, and what is in them.
    {"bounds are too wide", BOUNDS | SPLITS, BOUNDS, "bounds: found x [",
     .spoil = bounds_are_too_wide},
    {"bounds are one step off", BOUNDS, BOUNDS, "bounds: found x [",
     .spoil = bounds_are_one_step_off},
    {"bounds are not numbers", BOUNDS | SPLITS, BOUNDS, "nan", .spoil = bounds_are_not_numbers},
    {"last plane is moved", SPLITS | OVERLAP, SPLITS, "node 14: cell from",
     .spoil = last_plane_is_moved},
    {"last plane is moved by a hair", SPLITS, SPLITS, "node 14: cell from",
     .spoil = last_plane_is_moved_by_a_hair},
    {"last axis is another", SPLITS | OVERLAP, SPLITS, "node 14: cell x [",
     .spoil = last_axis_is_another},
    {"axis is none", SPLITS | OVERLAP | PACKING, SPLITS, "there are axes 0, 1 and 2",
     .edits = {NODE(N_INNER - 1, split_axis, 7)}},
    {"children are swapped with the neighbours", OVERLAP | PACKING, PACKING,
     "node 13's children are 29 and 30, expected 27 and 28 (breadth-first)",
     .edits = {NODE(13, first, 29), NODE(14, first, 27)}},
    {"child is far out", SPLITS | OVERLAP | PACKING, SPLITS, "node 3: an inner node, but",
     .edits = {NODE(3, first, 0xffffffff)}},
    {"child is the root", SPLITS | OVERLAP | PACKING, PACKING, "not marked KD_LEAF?",
     .edits = {NODE(3, first, 0)}},
    {"inner node has spheres", PACKING, PACKING, "node 3: split_axis is",
     .edits = {NODE(3, n_spheres, 1)}},
    {"range is far out", OVERLAP | LISTS | PACKING, LISTS, "leaf 20: first is 4294967295",
     .edits = {NODE(A_LEAF, first, 0xffffffff)}},
    {"ranges are swapped", OVERLAP | LISTS | PACKING, PACKING, "leaf 20: first is",
     .spoil = ranges_are_swapped},
    {"count is one less", OVERLAP | PACKING, OVERLAP, "overlaps its cell, but the leaf",
     .spoil = count_is_one_less},
    {"last count is one more", OVERLAP | LISTS | PACKING, LISTS, "but sphere_ids has",
     .spoil = last_count_is_one_more},
    {"list is unsorted", LISTS | PACKING, PACKING, "the ids must ascend",
     .spoil = list_is_unsorted},
    {"sphere is listed twice", OVERLAP | LISTS | PACKING, LISTS, "the ids must ascend",
     .spoil = sphere_is_listed_twice},
    {"sphere is another", OVERLAP, OVERLAP, "leaf 20, x [", .spoil = sphere_is_another},
    {"sphere is none", OVERLAP | LISTS, LISTS, "lists sphere 60, but the scene has 60",
     .spoil = sphere_is_none},
    {"inner node is a leaf", LISTS | OVERLAP | PACKING, LISTS, "is a leaf, expected it to be split",
     .edits = {NODE(N_INNER - 1, split_axis, KD_LEAF)}},
    {"leaf is not marked", SPLITS | OVERLAP | LISTS | PACKING, LISTS, "is split, expected a leaf",
     .edits = {NODE(A_LEAF, split_pos, 0), NODE(A_LEAF, split_axis, 0), NODE(A_LEAF, first, 0),
               NODE(A_LEAF, n_spheres, 0)}},
    {"ids have a tail", PACKING, PACKING, "but its arrays hold", .spoil = ids_have_a_tail},
    {"ids are cut off", OVERLAP | LISTS | PACKING, LISTS, "but sphere_ids has",
     .spoil = ids_are_cut_off},
    {"nodes have a tail", PACKING, PACKING, "31 nodes and", .spoil = nodes_have_a_tail},
    {"nodes are cut off", SPLITS | OVERLAP | PACKING, PACKING, "nodes and",
     .spoil = nodes_are_cut_off},
};

Test(tree3d_faults, each_fault_is_found_by_its_judges_alone_and_named)
{
    TreeScene3D scene = subject_open();
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        expect_found_by_its_judges_alone(&scene, &faults[i]);
    }
    scene_close(&scene);
}

// Another tree that is consistent in itself: only the limits say which one was asked for.
Test(tree3d_faults, leaves_too_early_or_too_late_are_found)
{
    static const KdTreeLimits others[] = {{4, 1}, {6, 1}, {1, 1}, {5, 40}};
    TreeScene3D scene = subject_open();
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        KdTree3D tree;
        cr_assert_eq(kdtree3d_build(scene.scene.spheres, 60, others[i], &tree), 0);
        // A tree of another size is wrong in these, too.
        const int against = judges_against(&scene, &tree) & ~(PACKING | SPLITS | DEPTH);
        cr_expect_eq(against, LISTS, "found by %s", names_of(against));
        tree3d_free(&tree);
    }
    scene_close(&scene);
}

// A sphere more or less on a plane that it touches exactly.
Test(tree3d_faults, exact_trees_must_be_equal)
{
    TreeScene3D scene = scene_of("planes", (KdTreeLimits){7, 3});
    KdTree3D tree = tree_copy(&scene.tree);
    cr_assert(scene.is_exact);
    tree.nodes[0].split_pos = nextafterf(tree.nodes[0].split_pos, 1);
    expect_says(tree3d_judge_packing(&scene, &tree), "node 0: found split_axis 0, split_pos");
    tree3d_free(&tree);
    scene_close(&scene);
}

// A tree of n_levels levels, with two nodes on each but the first.
static KdTree3D chain_of(u32 n_levels, KdNode3 *nodes)
{
    const KdTree3D tree = {.nodes = nodes, .n_nodes = 2 * n_levels - 1};
    for (u32 id = 0; id < tree.n_nodes; id++) {
        nodes[id] = id % 2 == 0 && id + 2 < tree.n_nodes ? (KdNode3){.first = id + 1}
                                                         : (KdNode3){.split_axis = KD_LEAF};
    }
    return tree;
}

Test(tree3d_faults, a_tree_too_deep_for_the_todo_stack_is_found)
{
    KdNode3 expected[2 * TODO_SIZE + 3], nodes[2 * TODO_SIZE + 3];
    const TreeScene3D scene = {.title = "chain", .tree = chain_of(TODO_SIZE + 1, expected)};
    const KdTree3D fits = chain_of(TODO_SIZE + 1, nodes);
    expect_says(tree3d_judge_depth(&scene, &fits), NULL);
    const KdTree3D too_deep = chain_of(TODO_SIZE + 2, nodes);
    expect_says(tree3d_judge_depth(&scene, &too_deep), "levels, so");
}

// Of a tree that ends too soon nothing is wrong in itself, and nothing is shown.
Test(tree3d_faults, a_tree_of_one_leaf_shows_neither_splits_nor_depth)
{
    TreeScene3D scene = scene_of("planes", (KdTreeLimits){7, 3}), refused = scene;
    KdTree3D tree = tree_copy(&scene.tree);
    tree.nodes[0] = (KdNode3){.split_axis = KD_LEAF};
    expect_says(tree3d_judge_splits(&scene, &tree), "found 0 nodes with children");
    expect_says(tree3d_judge_depth(&scene, &tree), "found a tree of 1 level, expected one of 7");
    refused.tree = (KdTree3D){0};
    expect_says(tree3d_judge_depth(&refused, &tree), "to give up");
    tree3d_free(&tree);
    scene_close(&scene);
}

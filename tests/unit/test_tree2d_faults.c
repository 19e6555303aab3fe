// The judges of 2D trees: each fault is found by the judges that look at it and by no other, and is
// named.
#include "kdtree2d_build.h"
#include "tree2d_subject.h"

#include <math.h>

TestSuite(tree2d_faults);

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
static u32 decoy(const KdTree2D *tree)
{
    const u32 *list = list_of(tree, A_LEAF);
    cr_assert_lt(list[list[0]], 59);
    return list[list[0]] + 1;
}

static void ids_start_at_1(KdTree2D *t)
{
    for (u32 id = 0; id < t->n_nodes; id++) {
        t->nodes_Relations[id].id++;
    }
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
    map_edit(t, A_LEAF, 1, list[0] + 1, decoy(t));
}
static void circle_is_another(KdTree2D *t)
{
    u32 *list = list_of(t, A_LEAF);
    list[list[0]] = decoy(t);
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
static void inner_box_is_shifted(KdTree2D *t)
{
    t->nodes_BBox[3].maxX += 0.0625f;
}
static void root_is_the_picture(KdTree2D *t)
{
    t->nodes_BBox[0] = (BBox2D){0, 64, 0, 48};
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

#define NODE(id, member, number)                                                                   \
    {offsetof(KdTree2D, nodes_Relations), (id) * sizeof(NodeRel) + offsetof(NodeRel, member),      \
     sizeof(u32), number}
#define BOX(id, member, bits)                                                                      \
    {offsetof(KdTree2D, nodes_BBox), (id) * sizeof(BBox2D) + offsetof(BBox2D, member),             \
     sizeof(u32), bits}
#define FLAG(id, flag) {offsetof(KdTree2D, nodes_flag), id, sizeof(u8), flag}

// (A node that is nobody's child has no level, so limits object.)
static const Fault faults[] = {
    {"child is no node", LIMITS | CELLS | PACKING | CHECK,
     .edits = {NODE(LAST_INNER, rChild, LAST_LEAF + 1)}},
    {"child is far out", LIMITS | CELLS | PACKING | CHECK, CELLS,
     "node 3 is an inner node, but its children are 4294967295 and 8 of 31",
     .edits = {NODE(3, lChild, 0xffffffff)}},
    {"child is its own parent", LIMITS | CELLS | PACKING | CHECK, .edits = {NODE(3, lChild, 3)}},
    {"child is its grandparent", LIMITS | CELLS | PACKING | CHECK, .edits = {NODE(3, rChild, 0)}},
    {"children are swapped", CELLS | PACKING, PACKING,
     "node 3's children are 8 and 7, expected 7 and 8",
     .edits = {NODE(3, lChild, 8), NODE(3, rChild, 7)}},
    {"children are one", LIMITS | CELLS | PACKING, .edits = {NODE(3, rChild, 7)}},
    {"children of others", CELLS | PACKING,
     .edits = {NODE(3, lChild, 9), NODE(3, rChild, 10), NODE(4, lChild, 7), NODE(4, rChild, 8)}},
    {"ids are permuted", PACKING, PACKING, "the node at position 8 has id 9",
     .edits = {NODE(8, id, 9), NODE(9, id, 8)}},
    {"ids start at 1", PACKING, .spoil = ids_start_at_1},
    {"leaf has children", PACKING, .edits = {NODE(A_LEAF, lChild, 29)}},
    {"offset at the first id", OVERLAP | LISTS | PACKING | CHECK, .spoil = offset_at_the_first_id},
    {"offset at the end", OVERLAP | LISTS | PACKING | CHECK, .spoil = offset_at_the_end},
    {"offset is far out", OVERLAP | LISTS | PACKING | CHECK, OVERLAP,
     "leaf 20: circleMapOffset is 4294967295, but mapNode2Circles has",
     .edits = {NODE(A_LEAF, circleMapOffset, 0xffffffff)}},
    {"offsets are swapped", OVERLAP | PACKING, .spoil = offsets_are_swapped},
    {"lists are permuted", LISTS | PACKING, PACKING, "expected 0, behind the list",
     .spoil = lists_are_permuted},
    {"count is one more", OVERLAP | LISTS | PACKING, .spoil = count_is_one_more},
    {"count is one less", OVERLAP | LISTS | PACKING, .spoil = count_is_one_less},
    {"last count is one more", OVERLAP | LISTS | PACKING | CHECK, .spoil = last_count_is_one_more},
    {"count is far out", OVERLAP | LISTS | PACKING | CHECK, LISTS,
     "where the count would be 4294967295", .spoil = count_is_far_out},
    {"list is unsorted", LISTS | PACKING, LISTS, "the ids must ascend", .spoil = list_is_unsorted},
    {"circle is listed twice", LISTS | PACKING, .spoil = circle_is_listed_twice},
    {"circle hides another", OVERLAP | LISTS | PACKING, .spoil = circle_hides_another},
    {"circle is missing", OVERLAP | LISTS | PACKING, OVERLAP,
     "overlaps its cell, but the leaf does not list it", .spoil = circle_is_missing},
    {"circle is additional", OVERLAP | LISTS | PACKING, OVERLAP,
     "does not overlap it, but the leaf lists it", .spoil = circle_is_additional},
    {"circle is another", OVERLAP | LISTS | PACKING, .spoil = circle_is_another},
    {"circle is none", OVERLAP | LISTS | PACKING | CHECK, LISTS,
     "lists circle 60, but the scene has 60", .spoil = circle_is_none},
    {"circle is none at all", LISTS | PACKING | CHECK, .spoil = circle_is_none_at_all},
    {"leaf box is shifted", CELLS | OVERLAP, CELLS, "node 9's child 20: found x [",
     .spoil = leaf_box_is_shifted},
    {"leaf box is not a number", CELLS | OVERLAP, .edits = {BOX(A_LEAF, maxY, 0x7fc00000)}},
    {"inner box is shifted", CELLS | OVERLAP, .spoil = inner_box_is_shifted},
    {"root is the picture", CELLS | OVERLAP, .spoil = root_is_the_picture},
    {"inner node is a leaf", LIMITS | OVERLAP | LISTS | PACKING, LIMITS,
     "is a leaf, expected it to be split", .edits = {FLAG(LAST_INNER, LEAF)}},
    {"leaf is an inner node", LIMITS | CELLS | LISTS | PACKING | CHECK, LIMITS,
     "node 20 on level 5 with 12 circles, below 0 failed splits, is split, expected a leaf",
     .edits = {FLAG(A_LEAF, INNER)}},
    {"flag is neither", LIMITS | LISTS, .edits = {FLAG(3, 7)}},
    {"map has a tail", LISTS | PACKING, PACKING, "31 nodes and", .spoil = map_has_a_tail},
    {"map is cut off", OVERLAP | LISTS | PACKING | CHECK, .spoil = map_is_cut_off},
    {"nodes have a tail", LIMITS | CELLS | OVERLAP | LISTS | PACKING, .spoil = nodes_have_a_tail},
    {"nodes are cut off", LIMITS | CELLS | OVERLAP | LISTS | PACKING | CHECK,
     .spoil = nodes_are_cut_off},
    {"there is only a root", LIMITS | CELLS | OVERLAP | LISTS | PACKING, CELLS,
     "the tree has 1 node, expected 31", .spoil = there_is_only_a_root},
};

Test(tree2d_faults, each_fault_is_found_by_its_judges_alone_and_named)
{
    JobScene scene = subject_open();
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        expect_found_by_its_judges_alone(&scene, &faults[i]);
    }
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
    char *message = told(tree_judge_limits(scene, &tree));
    cr_expect_not_null(message, "maxDepth %d, targetElementsPerNode %d", limits.maxDepth,
                       limits.targetElementsPerNode);
    cr_expect_not_null(strstr(message ? message : "", "node "), "no node is named: %s", message);
    free(message);
    tree2d_free(&tree);
}

Test(tree2d_faults, leaves_too_early_or_too_late_are_found)
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

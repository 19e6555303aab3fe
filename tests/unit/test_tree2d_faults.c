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
    CORRUPTION(lists_are_permuted, LISTS | PACKING),
    CORRUPTION(count_is_one_more, OVERLAP | LISTS | PACKING),
    CORRUPTION(count_is_one_less, OVERLAP | LISTS | PACKING),
    CORRUPTION(last_count_is_one_more, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(count_is_far_out, OVERLAP | LISTS | PACKING | CHECK),
    CORRUPTION(list_is_unsorted, LISTS | PACKING),
    CORRUPTION(circle_is_listed_twice, LISTS | PACKING),
    CORRUPTION(circle_hides_another, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_missing, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_additional, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_another, OVERLAP | LISTS | PACKING),
    CORRUPTION(circle_is_none, OVERLAP | LISTS | PACKING | CHECK),
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

Test(tree2d_faults, each_fault_is_found_by_its_judges_alone)
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

Test(tree2d_faults, each_fault_is_named)
{
    JobScene scene = subject_open();
    for (size_t i = 0; i < sizeof messages / sizeof *messages; i++) {
        KdTree2D tree = tree_copy(&scene.tree);
        messages[i].corrupt(&tree);
        for (size_t j = 0; j < sizeof judges / sizeof *judges; j++) {
            if (judges[j].bit == messages[i].judge) {
                char *message = told(judges[j].judge(&scene, &tree));
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

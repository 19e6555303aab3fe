// The judge of 3D trees: lab 06's solution passes it on every scene, each fault is found by the
// judges that look at it and by no other, and no tree of a submission does harm.
#include "kdtree3d_build.h"
#include "tree3d_judge.h"

#include "kdtree3d_build.h"
#include "message.h"
#include "random.h"
#include "surroundings.h"
#include "told.h"

#include <math.h>

TestSuite(tree3d_judge);

enum { BOUNDS = 1, SPLITS = 2, OVERLAP = 4, LISTS = 8, PACKING = 16, DEPTH = 32 };

static const struct {
    int bit;
    const char *name;
    Diagnosis (*judge)(const TreeScene3D *, const KdTree3D *);
} judges[] = {
    {BOUNDS, "bounds", tree3d_judge_bounds},    {SPLITS, "splits", tree3d_judge_splits},
    {OVERLAP, "overlap", tree3d_judge_overlap}, {LISTS, "lists", tree3d_judge_lists},
    {PACKING, "packing", tree3d_judge_packing}, {DEPTH, "depth", tree3d_judge_depth},
};

// Which judges object. Messages are one line each and begin with the scene.
static int judges_against(const TreeScene3D *scene, const KdTree3D *tree)
{
    int against = 0;
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        char *message = told(judges[i].judge(scene, tree));
        if (message != NULL) {
            against |= judges[i].bit;
            cr_expect(strchr(message, '\n') == NULL && strstr(message, scene->title) == message,
                      "%s", message);
            free(message);
        }
    }
    return against;
}

// The same in words.
static const char *names_of(int against)
{
    static char names[64];
    names[0] = '\0';
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        if (against & judges[i].bit) {
            strcat(strcat(names, judges[i].name), " ");
        }
    }
    return names;
}

static void grow(TreeScene3D *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    cr_assert_eq(
        kdtree3d_build(scene->scene.spheres, (u32)scene->scene.n_spheres, limits, &scene->tree), 0);
    scene->is_exact = tree3d_judge_is_exact(scene);
}

static TreeScene3D scene_of(const char *name, KdTreeLimits limits)
{
    TreeScene3D scene = {0};
    snprintf(scene.title, sizeof scene.title, "%s", name);
    cr_assert_eq(scene3d_open(name, 64, 48, &scene.scene), 0);
    grow(&scene, limits);
    return scene;
}

static void scene_close(TreeScene3D *scene)
{
    tree3d_free(&scene->tree);
    scene3d_free(&scene->scene);
}

static void expect_good(const TreeScene3D *scene)
{
    const int against = judges_against(scene, &scene->tree);
    cr_expect_eq(against, 0, "%s, maxDepth %d, targetElementsPerNode %d: %s", scene->title,
                 scene->limits.maxDepth, scene->limits.targetElementsPerNode, names_of(against));
}

// ---- Good trees ---------------------------------------------------------------------------------

Test(tree3d_judge, random_scenes_give_good_trees)
{
    Random random = {1};
    for (int round = 0; round < 100; round++) {
        char name[96];
        const int n_spheres = (int)random_integer(&random, 0, 150);
        const double radius = ldexp(1, -(int)random_integer(&random, 0, 10));
        snprintf(name, sizeof name, "random:n=%d,seed=%d,min=%g,max=%g", n_spheres, round,
                 radius / 4, radius);
        const int max_depth = (int)random_integer(&random, 1, 10);
        TreeScene3D scene =
            scene_of(name, (KdTreeLimits){max_depth, (int)random_integer(&random, 1, 12)});
        expect_good(&scene);
        scene_close(&scene);
    }
}

Test(tree3d_judge, edge_cases_give_good_trees)
{
    for (int i = 0; scene3d_edge_case(i) != NULL; i++) {
        TreeScene3D scene = scene_of(scene3d_edge_case(i), (KdTreeLimits){8, 6});
        expect_good(&scene);
        scene_close(&scene);
    }
    TreeScene3D scene = scene_of("sphereflake:size=2", (KdTreeLimits){10, 3});
    expect_good(&scene);
    scene_close(&scene);
    scene = scene_of("lattice:n=5", (KdTreeLimits){9, 2});
    expect_good(&scene);
    scene_close(&scene);
}

Test(tree3d_judge, exact_is_what_lies_on_a_coarse_grid)
{
    static const struct {
        const char *name;
        int is_exact;
    } scenes[] = {{"planes", 1}, {"one", 1}, {"none", 1}, {"inside", 1}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        TreeScene3D scene = scene_of(scenes[i].name, (KdTreeLimits){7, 3});
        cr_expect_eq(scene.is_exact, scenes[i].is_exact, "%s", scenes[i].name);
        scene_close(&scene);
    }
}

// The expected tree shares no code with lab 06; where rounding decides nothing, both are equal.
static int expect_as_solution(const char *name, KdTreeLimits limits)
{
    TreeScene3D scene = scene_of(name, limits);
    TreeScene3D expected = scene;
    Growth growth = {0};
    cr_assert_eq(tree3d_expect(&expected, 0, &growth), 0);
    growth_free(&growth);
    expect_good(&expected);
    cr_expect_eq(expected.is_exact, scene.is_exact, "%s", name);
    const KdTree3D *own = &scene.tree, *tree = &expected.tree;
    const int is_exact = expected.is_exact;
    if (is_exact) {
        cr_expect_eq(memcmp(&own->bounds, &tree->bounds, sizeof own->bounds), 0, "%s", name);
        cr_assert_eq(own->n_nodes, tree->n_nodes, "%s", name);
        cr_assert_eq(own->n_sphere_ids, tree->n_sphere_ids, "%s", name);
        cr_expect_eq(memcmp(own->nodes, tree->nodes, own->n_nodes * sizeof *own->nodes), 0, "%s",
                     name);
        for (u32 i = 0; i < own->n_sphere_ids; i++) {
            cr_expect_eq(own->sphere_ids[i], tree->sphere_ids[i], "%s: id %u", name, i);
        }
    }
    tree3d_free(&expected.tree);
    scene_close(&scene);
    return is_exact;
}

Test(tree3d_judge, the_expected_tree_is_the_solutions)
{
    int n_exact = 0;
    for (int i = 0; scene3d_edge_case(i) != NULL; i++) {
        n_exact += expect_as_solution(scene3d_edge_case(i), (KdTreeLimits){8, 3});
    }
    cr_expect_geq(n_exact, 4, "found %d", n_exact);
    for (int seed = 0; seed < 20; seed++) {
        char name[64];
        snprintf(name, sizeof name, "random:n=100,seed=%d", seed);
        expect_as_solution(name, (KdTreeLimits){1 + seed % 12, 1 + seed % 5});
    }
}

// ---- One call -----------------------------------------------------------------------------------

Test(tree3d_judge, touching_is_inside_where_double_is_exact)
{
    const BBox3D cell = {{0, 0, 0}, {8, 8, 8}};
    cr_expect_eq(tree3d_judge_sphere((Sphere){-3, 4, 4, 3}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-3, 12, 4, -5}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-2, 11, 14, 7}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-2, 11, 14, 6.875f}, cell), SPHERE_OUTSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){4, 4, 4, 100}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){4, 4, 4, 0.125f}, cell), SPHERE_INSIDE);
}

Test(tree3d_judge, either_is_right_where_double_rounds)
{
    const BBox3D cell = {{0, 0, 0}, {8, 8, 8}};
    // The squared distance is 1 + 2^-60.
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, 1}, cell), SPHERE_EITHER);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, nextafterf(1, 2)}, cell),
                 SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, nextafterf(1, 0)}, cell),
                 SPHERE_OUTSIDE);
}

// Does the sphere overlap the cell as double has it: squares compared, roots, or what is left of
// one square after the others? And as float has it?
static int overlaps_in_double(Sphere s, BBox3D cell, int way)
{
    const double centre[3] = {s.x, s.y, s.z}, radius = fabs((double)s.radius);
    double distance2 = 0, left_over = radius * radius;
    for (int axis = 0; axis < 3; axis++) {
        const double nearest = fmin(fmax(centre[axis], cell.min[axis]), cell.max[axis]);
        distance2 += (centre[axis] - nearest) * (centre[axis] - nearest);
        left_over -= (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return way == 0   ? distance2 <= radius * radius
           : way == 1 ? sqrt(distance2) <= radius
                      : left_over >= 0;
}

static int overlaps_in_float(Sphere s, BBox3D cell)
{
    const float centre[3] = {s.x, s.y, s.z};
    float distance2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        const float nearest = fminf(fmaxf(centre[axis], cell.min[axis]), cell.max[axis]);
        distance2 += (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return distance2 <= s.radius * s.radius;
}

// Spheres that nearly touch: whatever double says must be allowed, and what float says is not.
Test(tree3d_judge, no_answer_of_double_is_blamed_and_float_is)
{
    Random random = {9};
    int n_blamed = 0;
    for (int i = 0; i < 200000; i++) {
        const BBox3D cell = {{0, 0, 0}, {1.0f / 3, 0.7f, 0.9f}};
        float centre[3];
        double distance2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            const float distance = (float)random_integer(&random, 0, 1 << 24) / (1 << 24);
            centre[axis] = i >> axis & 1 ? -distance : cell.max[axis] + distance;
            const double d = i >> axis & 1 ? distance : (double)centre[axis] - cell.max[axis];
            distance2 += d * d;
        }
        Sphere sphere = {centre[0], centre[1], centre[2], (float)sqrt(distance2)};
        for (int step = random_integer(&random, -2, 2); step != 0; step -= step > 0 ? 1 : -1) {
            sphere.radius = nextafterf(sphere.radius, step > 0 ? 9 : 0);
        }
        const SphereInCell is = tree3d_judge_sphere(sphere, cell);
        for (int way = 0; way < 3; way++) {
            cr_assert(is == SPHERE_EITHER ||
                      overlaps_in_double(sphere, cell, way) == (is == SPHERE_INSIDE));
        }
        n_blamed += is != SPHERE_EITHER && overlaps_in_float(sphere, cell) != (is == SPHERE_INSIDE);
    }
    cr_expect_gt(n_blamed, 1000, "float and double agree: nothing was tested");
}

// The message of a judge about one call must hold `says`; NULL: there must be none.
static void expect_says(Diagnosis diagnosis, const char *says)
{
    char *message = told(diagnosis);
    if (says == NULL) {
        cr_expect_null(message, "%s", message);
    } else {
        cr_expect(message != NULL && strstr(message, says) != NULL, "found \"%s\", expected \"%s\"",
                  message ? message : "(nothing)", says);
    }
    free(message);
}

Test(tree3d_judge, axes_and_middles_are_judged_as_float_has_them)
{
    const BBox3D cube = {{1, 1, 1}, {3, 3, 3}}, tall = {{1, 1, 1}, {2, 3, 6}};
    expect_says(tree3d_judge_axis("call", cube, 0), NULL);
    expect_says(tree3d_judge_axis("call", cube, 1), "of equal sides the first");
    expect_says(tree3d_judge_axis("call", tall, 2), NULL);
    expect_says(tree3d_judge_axis("call", tall, 1), "not the longest");
    expect_says(tree3d_judge_axis("call", tall, 0), "the shortest");
    expect_says(tree3d_judge_axis("call", tall, 3), "axes 0, 1 and 2");
    expect_says(tree3d_judge_axis("call", tall, 0xffffffff), "axes 0, 1 and 2");
    // y is longer by less than float sees.
    const BBox3D nearly = {{-1, -1e-9f, 0}, {0, 1, 0}};
    expect_says(tree3d_judge_axis("call", nearly, 0), NULL);
    expect_says(tree3d_judge_axis("call", nearly, 1), NULL);
    expect_says(tree3d_judge_axis("call", nearly, 2), "the shortest");
    expect_says(tree3d_judge_middle("call", tall, 2, 3.5f), NULL);
    expect_says(tree3d_judge_middle("call", tall, 2, 2.5f), "began at 0");
    expect_says(tree3d_judge_middle("call", tall, 2, 3.50001f), "expected 3.5");
    expect_says(tree3d_judge_middle("call", tall, 2, NAN), "expected 3.5");
    const BBox3D rounded = {{0.1f, 0, 0}, {0.8f, 0, 0}};
    expect_says(tree3d_judge_middle("call", rounded, 0, (0.1f + 0.8f) / 2), NULL);
    expect_says(tree3d_judge_middle("call", rounded, 0, 0.1f + (0.8f - 0.1f) / 2), NULL);
}

// ---- Broken trees -------------------------------------------------------------------------------

// The subject: all inner nodes come first, so that what is done to one leaf shifts no other.
enum { N_INNER = 15, N_NODES = 31, A_LEAF = 20 };

static TreeScene3D subject_open(void)
{
    TreeScene3D scene = scene_of("random:n=60,seed=4,min=0.25,max=0.375", (KdTreeLimits){5, 1});
    cr_assert_eq(scene.tree.n_nodes, N_NODES);
    for (u32 id = 0; id < N_NODES; id++) {
        cr_assert_eq(scene.tree.nodes[id].split_axis == KD_LEAF, id >= N_INNER);
        cr_assert(id < N_INNER || scene.tree.nodes[id].n_spheres >= 3);
    }
    expect_good(&scene);
    return scene;
}

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static KdTree3D tree_copy(const KdTree3D *tree)
{
    KdTree3D copy = *tree;
    copy.nodes = malloc(tree->n_nodes * sizeof *copy.nodes);
    copy.sphere_ids = malloc(tree->n_sphere_ids * sizeof *copy.sphere_ids);
    memcpy(copy.nodes, tree->nodes, tree->n_nodes * sizeof *copy.nodes);
    memcpy(copy.sphere_ids, tree->sphere_ids, tree->n_sphere_ids * sizeof *copy.sphere_ids);
    return copy;
}

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

static void axis_is_none(KdTree3D *t)
{
    t->nodes[N_INNER - 1].split_axis = 7;
}

static void children_are_swapped_with_the_neighbours(KdTree3D *t)
{
    t->nodes[13].first += 2;
    t->nodes[14].first -= 2;
}

static void child_is_far_out(KdTree3D *t)
{
    t->nodes[3].first = 0xffffffff;
}

static void child_is_the_root(KdTree3D *t)
{
    t->nodes[3].first = 0;
}

static void inner_node_has_spheres(KdTree3D *t)
{
    t->nodes[3].n_spheres = 1;
}

static void range_is_far_out(KdTree3D *t)
{
    t->nodes[A_LEAF].first = 0xffffffff;
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

static void inner_node_is_a_leaf(KdTree3D *t)
{
    t->nodes[N_INNER - 1].split_axis = KD_LEAF;
}

static void leaf_is_not_marked(KdTree3D *t)
{
    t->nodes[A_LEAF] = (KdNode3){.first = 0};
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

static const struct {
    const char *what;
    void (*corrupt)(KdTree3D *tree);
    int against;
    int judge;         // one of them,
    const char *says;  // and a part of its message
} corruptions[] = {
#define CORRUPTION(corrupt, ...) {#corrupt, corrupt, __VA_ARGS__}
    // Moving the box or a plane moves cells, and what is in them.
    CORRUPTION(bounds_are_too_wide, BOUNDS | SPLITS, BOUNDS, "bounds: found x ["),
    CORRUPTION(bounds_are_one_step_off, BOUNDS, BOUNDS, "bounds: found x ["),
    CORRUPTION(bounds_are_not_numbers, BOUNDS | SPLITS, BOUNDS, "nan"),
    CORRUPTION(last_plane_is_moved, SPLITS | OVERLAP, SPLITS, "node 14: cell from"),
    CORRUPTION(last_plane_is_moved_by_a_hair, SPLITS, SPLITS, "node 14: cell from"),
    CORRUPTION(last_axis_is_another, SPLITS | OVERLAP, SPLITS, "node 14: cell x ["),
    CORRUPTION(axis_is_none, SPLITS | OVERLAP | PACKING, SPLITS, "there are axes 0, 1 and 2"),
    CORRUPTION(children_are_swapped_with_the_neighbours, OVERLAP | PACKING, PACKING,
               "node 13's children are 29 and 30, expected 27 and 28 (breadth-first)"),
    CORRUPTION(child_is_far_out, SPLITS | OVERLAP | PACKING, SPLITS, "node 3: an inner node, but"),
    CORRUPTION(child_is_the_root, SPLITS | OVERLAP | PACKING, PACKING, "not marked KD_LEAF?"),
    CORRUPTION(inner_node_has_spheres, PACKING, PACKING, "node 3: split_axis is"),
    CORRUPTION(range_is_far_out, OVERLAP | LISTS | PACKING, LISTS, "leaf 20: first is 4294967295"),
    CORRUPTION(ranges_are_swapped, OVERLAP | LISTS | PACKING, PACKING, "leaf 20: first is"),
    CORRUPTION(count_is_one_less, OVERLAP | PACKING, OVERLAP, "overlaps its cell, but the leaf"),
    CORRUPTION(last_count_is_one_more, OVERLAP | LISTS | PACKING, LISTS, "but sphere_ids has"),
    CORRUPTION(list_is_unsorted, LISTS | PACKING, PACKING, "the ids must ascend"),
    CORRUPTION(sphere_is_listed_twice, OVERLAP | LISTS | PACKING, LISTS, "the ids must ascend"),
    CORRUPTION(sphere_is_another, OVERLAP, OVERLAP, "leaf 20, x ["),
    CORRUPTION(sphere_is_none, OVERLAP | LISTS, LISTS, "lists sphere 60, but the scene has 60"),
    CORRUPTION(inner_node_is_a_leaf, LISTS | OVERLAP | PACKING, LISTS,
               "is a leaf, expected it to be split"),
    CORRUPTION(leaf_is_not_marked, SPLITS | OVERLAP | LISTS | PACKING, LISTS,
               "is split, expected a leaf"),
    CORRUPTION(ids_have_a_tail, PACKING, PACKING, "but its arrays hold"),
    CORRUPTION(ids_are_cut_off, OVERLAP | LISTS | PACKING, LISTS, "but sphere_ids has"),
    CORRUPTION(nodes_have_a_tail, PACKING, PACKING, "31 nodes and"),
    CORRUPTION(nodes_are_cut_off, SPLITS | OVERLAP | PACKING, PACKING, "nodes and"),
#undef CORRUPTION
};

Test(tree3d_judge, each_fault_is_found_by_its_judges_alone)
{
    TreeScene3D scene = subject_open();
    for (size_t i = 0; i < sizeof corruptions / sizeof *corruptions; i++) {
        KdTree3D tree = tree_copy(&scene.tree);
        corruptions[i].corrupt(&tree);
        const int against = judges_against(&scene, &tree);
        cr_expect_eq(against, corruptions[i].against, "%s: found by %s", corruptions[i].what,
                     names_of(against));
        for (size_t j = 0; j < sizeof judges / sizeof *judges; j++) {
            if (judges[j].bit == corruptions[i].judge) {
                expect_says(judges[j].judge(&scene, &tree), corruptions[i].says);
            }
        }
        tree3d_free(&tree);
    }
    scene_close(&scene);
}

// Another tree that is consistent in itself: only the limits say which one was asked for.
Test(tree3d_judge, leaves_too_early_or_too_late_are_found)
{
    static const KdTreeLimits others[] = {{4, 1}, {6, 1}, {1, 1}, {5, 40}};
    TreeScene3D scene = subject_open();
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        KdTree3D tree;
        cr_assert_eq(kdtree3d_build(scene.scene.spheres, 60, others[i], &tree), 0);
        const int against = judges_against(&scene, &tree) & ~PACKING;
        cr_expect_eq(against, LISTS, "found by %s", names_of(against));
        tree3d_free(&tree);
    }
    scene_close(&scene);
}

// A sphere more or less on a plane that it touches exactly.
Test(tree3d_judge, exact_trees_must_be_equal)
{
    TreeScene3D scene = scene_of("planes", (KdTreeLimits){7, 3});
    KdTree3D tree = tree_copy(&scene.tree);
    cr_assert(scene.is_exact);
    tree.nodes[0].split_pos = nextafterf(tree.nodes[0].split_pos, 1);
    expect_says(tree3d_judge_packing(&scene, &tree), "node 0: found split_axis 0, split_pos");
    tree3d_free(&tree);
    scene_close(&scene);
}

Test(tree3d_judge, a_tree_too_deep_for_the_todo_stack_is_found)
{
    TreeScene3D scene = {.title = "chain"};
    KdNode3 nodes[2 * TODO_SIZE + 3];
    KdTree3D tree = {.nodes = nodes};
    for (int n_levels = TODO_SIZE + 1; n_levels <= TODO_SIZE + 2; n_levels++) {
        tree.n_nodes = 2 * (u32)n_levels - 1;
        for (u32 id = 0; id < tree.n_nodes; id++) {
            nodes[id] = id % 2 == 0 && id + 2 < tree.n_nodes ? (KdNode3){.first = id + 1}
                                                             : (KdNode3){.split_axis = KD_LEAF};
        }
        expect_says(tree3d_judge_depth(&scene, &tree),
                    n_levels > TODO_SIZE + 1 ? "levels, so" : NULL);
    }
}

// ---- Trees made to do harm ----------------------------------------------------------------------

Test(tree3d_judge, any_number_anywhere_is_survived)
{
    static const u32 numbers[] = {0,  1,  2,  3,  4,          14,         15,         30,
                                  31, 59, 60, 61, 0x7fc00000, 0x7f800000, 0x80000000, 0xfffffffe};
    TreeScene3D scene = subject_open();
    KdTree3D tree = tree_copy(&scene.tree);
    u32 *const arrays[] = {(u32 *)tree.nodes, tree.sphere_ids};
    const size_t lengths[] = {4 * (size_t)tree.n_nodes, tree.n_sphere_ids};
    for (int a = 0; a < 2; a++) {
        for (size_t i = 0; i < lengths[a]; i++) {
            const u32 was = arrays[a][i];
            for (size_t j = 0; j < sizeof numbers / sizeof *numbers; j++) {
                arrays[a][i] = numbers[j];
                (void)judges_against(&scene, &tree);
            }
            arrays[a][i] = was;
        }
    }
    tree3d_free(&tree);
    scene_close(&scene);
}

Test(tree3d_judge, random_bits_are_survived)
{
    TreeScene3D scene = subject_open();
    Random random = {2};
    for (int round = 0; round < 400; round++) {
        KdTree3D tree = tree_copy(&scene.tree);
        u32 *words = (u32 *)tree.nodes;
        for (u32 i = 0; i < 4 * tree.n_nodes; i++) {
            if (random_integer(&random, 0, 3) == 0) {
                words[i] = random_integer(&random, 0, 1) ? (u32)random_integer(&random, 0, 40)
                                                         : (u32)random_bits(&random);
            }
        }
        (void)judges_against(&scene, &tree);
        tree3d_free(&tree);
    }
    scene_close(&scene);
}

// As many leaves as an answer may hold share one long list: without a bound on what is looked at,
// this would keep the grader busy for hours.
Test(tree3d_judge, leaves_without_end_are_judged_in_no_time)
{
    enum { N_MANY = 1 << 20, N_LISTED = 1000 };
    TreeScene3D scene = scene_of("random:n=1000,seed=4", (KdTreeLimits){8, 2});
    KdTree3D tree = {.bounds = scene.tree.bounds,
                     .nodes = calloc(N_MANY, sizeof *tree.nodes),
                     .sphere_ids = calloc(N_LISTED, sizeof *tree.sphere_ids),
                     .n_nodes = N_MANY,
                     .n_sphere_ids = N_LISTED};
    for (u32 id = 0; id < N_MANY; id++) {
        tree.nodes[id] = (KdNode3){0, KD_LEAF, 0, N_LISTED};
    }
    for (u32 i = 0; i < N_LISTED; i++) {
        tree.sphere_ids[i] = i;
    }
    const int against = judges_against(&scene, &tree);
    cr_expect_eq(against & (LISTS | PACKING), LISTS | PACKING);
    tree3d_free(&tree);
    scene_close(&scene);
}

Test(tree3d_judge, an_empty_tree_is_survived)
{
    TreeScene3D scene = subject_open();
    const KdTree3D empty = {0};
    cr_expect_neq(judges_against(&scene, &empty), 0);
    scene_close(&scene);
}

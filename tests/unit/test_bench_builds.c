// The bench of builds: what a builder hands on, the memory that is counted, and how both grow.
#include "case_build.h"
#include "counted_memory.h"
#include "handed_on.h"
#include "kdtree2d_build.h"
#include "kdtree3d_build.h"

#include <criterion/criterion.h>
#include <math.h>

// ---- What is handed on --------------------------------------------------------------------------

Test(bench_builds, circles_of_all_nodes_are_those_that_overlap_them)
{
    Scene2D scene;
    KdTree2D tree;
    cr_assert_eq(scene2d_random(300, 1, 5, 80, 1024, 1024, &scene), 0);
    cr_assert_eq(kdtree2d_build(scene.circles, 300, (KdTreeLimits){9, 4}, &tree), 0);
    int n_overlapping = 300;  // the root has all
    for (u32 id = 1; id < tree.n_nodes; id++) {
        for (int i = 0; i < scene.n_circles; i++) {
            n_overlapping += circle_overlaps_box(scene.circles[i], tree.nodes_BBox[id]);
        }
    }
    cr_expect_gt(tree.n_nodes, 100);
    cr_expect_float_eq(handed_on_2d(&tree, 300), n_overlapping, 0);
    tree2d_free(&tree);
    scene2d_free(&scene);
}

// The spheres that overlap the cells of a node and of all below it.
static int overlapping_below(const Scene3D *scene, const KdTree3D *tree, u32 id, BBox3D box)
{
    int n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += sphere_overlaps_box(scene->spheres[i], box);
    }
    const KdNode3 node = tree->nodes[id];
    if (node.split_axis == KD_LEAF) {
        return n;
    }
    BBox3D lower = box, higher = box;
    lower.max[node.split_axis] = higher.min[node.split_axis] = node.split_pos;
    return n + overlapping_below(scene, tree, node.first, lower) +
           overlapping_below(scene, tree, node.first + 1, higher);
}

Test(bench_builds, spheres_of_all_nodes_are_those_that_overlap_them)
{
    Scene3D scene;
    KdTree3D tree;
    cr_assert_eq(scene3d_open("random:n=300", 0, 0, &scene), 0);
    cr_assert_eq(kdtree3d_build(scene.spheres, 300, (KdTreeLimits){9, 4}, &tree), 0);
    cr_expect_gt(tree.n_nodes, 100);
    cr_expect_float_eq(handed_on_3d(&tree, 300), overlapping_below(&scene, &tree, 0, tree.bounds),
                       0);
    tree3d_free(&tree);
    scene3d_free(&scene);
}

// ---- Memory -------------------------------------------------------------------------------------

Test(bench_builds, the_most_memory_in_use_is_counted)
{
    // volatile: else the compiler leaves out what nobody uses.
    void *volatile before = malloc(5000);
    memory_count_begin();
    void *volatile first = malloc(100);
    first = realloc(first, 300);
    void *volatile second = calloc(20, 10);
    free(before);  // not one of those that are counted
    free(first);
    first = malloc(250);
    cr_expect_eq(memory_count_end(), 500);
    free(first);
    free(second);
    memory_count_begin();
    cr_expect_eq(memory_count_end(), 0);
}

Test(bench_builds, a_builds_memory_holds_its_tree)
{
    enum { N_SPHERES = SMALLEST_SCENE * SCENE_FACTOR };
    BuildScene scene = {0};
    cr_assert_eq(build_scene_create(N_SPHERES, &scene), 0);
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        BuildCase build_case = {.builder = builder, .n_elements = N_SPHERES};
        const char *name = BUILDERS[builder].name;
        cr_assert_geq(case_build_time(&build_case, &scene), 0);
        const double n_peak_bytes = build_case.n_peak_bytes;
        cr_expect_gt(n_peak_bytes, build_case.size.n_bytes, "%s", name);
        if (builder == MIDDLE_3D) {
            // As slides-notes/notes-3d.md says.
            cr_expect_gt(n_peak_bytes, 4 * build_case.size.n_bytes);
            cr_expect_lt(n_peak_bytes, 5 * build_case.size.n_bytes);
        }
        cr_assert_geq(case_build_time(&build_case, &scene), 0);
        cr_expect_float_eq(build_case.n_peak_bytes, n_peak_bytes, 0, "%s: not the same again",
                           name);
    }
    build_scene_free(&scene);
}

// ---- Growth -------------------------------------------------------------------------------------

// Counted, so the same on every machine: as slides-notes/notes-2d.md and tests/bench/README.md say.
Test(bench_builds, builders_grow_by_their_laws)
{
    enum { N_SMALL_SCENES = 4 };
    double handed_on[N_BUILDERS][N_SMALL_SCENES], listed[N_BUILDERS][N_SMALL_SCENES];
    int n = SMALLEST_SCENE;
    for (int i = 0; i < N_SMALL_SCENES; i++, n *= SCENE_FACTOR) {
        BuildScene scene = {0};
        cr_assert_eq(build_scene_create(n, &scene), 0);
        for (int builder = 0; builder < N_BUILDERS; builder++) {
            BuildCase build_case = {.builder = builder, .n_elements = n};
            cr_assert_geq(case_build_time(&build_case, &scene), 0);
            handed_on[builder][i] = build_case.size.n_handed_on / n;
            listed[builder][i] = build_case.size.n_listed / build_case.size.n_leaves;
        }
        build_scene_free(&scene);
    }
    const double n_doublings = (N_SMALL_SCENES - 1) * log2(SCENE_FACTOR);
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        const char *name = BUILDERS[builder].name;
        const double *an_element = handed_on[builder];
        const double a_doubling = (an_element[N_SMALL_SCENES - 1] - an_element[0]) / n_doublings;
        const double leaves_grow = listed[builder][N_SMALL_SCENES - 1] / listed[builder][0];
        if (builder == MIDDLE_2D_FIXED || builder == MIDDLE_3D_FIXED) {
            // N. Not quite linear: in small scenes more elements lie on both sides of a split.
            cr_expect(a_doubling > -1 && a_doubling < 0.1, "%s: %g", name, a_doubling);
            cr_expect_gt(leaves_grow, 20, "%s: %g", name, leaves_grow);
        } else {
            // N log N. Where all leaves are alike each doubling adds a level, and a little more
            // than one node an element, as some lie on both sides of a split.
            cr_expect(a_doubling > 1 && a_doubling < 3, "%s: %g", name, a_doubling);
            cr_expect_lt(leaves_grow, 1.1, "%s: %g", name, leaves_grow);
        }
    }
}

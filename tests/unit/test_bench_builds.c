// The bench of builds: laws of growth that are fitted, what a builder hands on, the memory that is
// counted, and the tables.
#include "case_build.h"
#include "counted_memory.h"
#include "handed_on.h"
#include "kdtree2d_build.h"
#include "kdtree3d_build.h"
#include "report_builds.h"

#include "csv_file.h"
#include "surroundings.h"

#include <math.h>

TestSuite(bench_builds, .init = folder_enter, .fini = folder_leave);

// ---- Laws ---------------------------------------------------------------------------------------

enum { N_POINTS = 6 };
static const double elements[N_POINTS] = {1024, 4096, 16384, 65536, 262144, 1048576};

// Points of a N log2 N + b N, each moved by a share of itself, up and down in turn.
static void points_make(double a, double b, double moved, double *quantities)
{
    for (int i = 0; i < N_POINTS; i++) {
        quantities[i] = elements[i] * (a * log2(elements[i]) + b) * (1 + (i % 2 ? moved : -moved));
    }
}

Test(bench_builds, known_points_give_the_known_factors)
{
    double quantities[N_POINTS];
    points_make(3, 20, 0, quantities);
    const Growth growth = growth_fit(N_LOG_N, elements, quantities, N_POINTS);
    // Sums of some ten doubles.
    cr_expect_float_eq(growth.a, 3, 1e-9);
    cr_expect_float_eq(growth.b, 20, 1e-9);
    cr_expect_lt(growth.deviation, 1e-9);
    cr_expect_float_eq(growth_at(growth, 1 << 10), 50 * 1024, 1e-6);
}

Test(bench_builds, what_is_linear_has_no_part_that_grows)
{
    double quantities[N_POINTS];
    points_make(0, 7, 0, quantities);
    const Growth n_log_n = growth_fit(N_LOG_N, elements, quantities, N_POINTS);
    const Growth linear = growth_fit(LINEAR, elements, quantities, N_POINTS);
    cr_expect_float_eq(n_log_n.a, 0, 1e-9);
    cr_expect_float_eq(linear.a, 0, 0);
    cr_expect_float_eq(linear.b, 7, 1e-9);
    cr_expect_lt(linear.deviation, 1e-9);
}

Test(bench_builds, a_wrong_law_stays_far_off)
{
    double quantities[N_POINTS];
    // From 2^10 to 2^20 an element's share doubles: no level is less than a third off both ends.
    points_make(1, 0, 0, quantities);
    cr_expect_gt(growth_fit(LINEAR, elements, quantities, N_POINTS).deviation, 0.33);
    for (int i = 0; i < N_POINTS; i++) {
        quantities[i] = elements[i] * elements[i];
    }
    cr_expect_gt(growth_fit(N_LOG_N, elements, quantities, N_POINTS).deviation, 0.9);
    cr_expect_gt(growth_fit(LINEAR, elements, quantities, N_POINTS).deviation, 0.9);
}

Test(bench_builds, noise_shows_as_deviation)
{
    double quantities[N_POINTS];
    points_make(3, 20, 0.1, quantities);
    const Growth growth = growth_fit(N_LOG_N, elements, quantities, N_POINTS);
    // A tenth to either side, of which the fit takes away a part.
    cr_expect_gt(growth.deviation, 0.05);
    cr_expect_lt(growth.deviation, 0.15);
}

Test(bench_builds, small_quantities_count_as_much_as_large_ones)
{
    double quantities[N_POINTS];
    points_make(0, 10, 0, quantities);
    quantities[0] *= 2;
    const Growth growth = growth_fit(LINEAR, elements, quantities, N_POINTS);
    // Shares of 1/20 and five of 1/10: (0.05 + 0.5) / (0.0025 + 0.05). Without weights it is 10.
    cr_expect_float_eq(growth.b, 0.55 / 0.0525, 1e-9);
}

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

// ---- The laws of our builders -------------------------------------------------------------------

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
            handed_on[builder][i] = build_case.size.n_handed_on;
            listed[builder][i] = build_case.size.n_listed / build_case.size.n_leaves;
        }
        build_scene_free(&scene);
    }
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        const char *name = BUILDERS[builder].name;
        const Growth growth =
            growth_fit(BUILDERS[builder].law, elements, handed_on[builder], N_SMALL_SCENES);
        const double leaves_grow = listed[builder][N_SMALL_SCENES - 1] / listed[builder][0];
        if (BUILDERS[builder].law == N_LOG_N) {
            // Where all leaves are alike each doubling adds a level, and a little more than one
            // node an element, as some lie on both sides of a split.
            cr_expect(growth.a > 1 && growth.a < 3, "%s: %g", name, growth.a);
            cr_expect_lt(growth.deviation, 0.05, "%s: %g", name, growth.deviation);
            cr_expect_lt(leaves_grow, 1.1, "%s: %g", name, leaves_grow);
        } else {
            // Not quite linear: in small scenes more elements lie on both sides of a split.
            cr_expect_lt(growth.deviation, 0.3, "%s: %g", name, growth.deviation);
            cr_expect_gt(leaves_grow, 20, "%s: %g", name, leaves_grow);
        }
    }
}

// ---- Tables -------------------------------------------------------------------------------------

enum { N_SHOWN = 3, N_CASES = N_BUILDERS * N_SHOWN };
static BuildCase cases[N_CASES];

// Every builder takes 2 N log2 N + 10 N nanoseconds, lab 06's one that gets slower 100 N.
static void cases_make(void)
{
    for (int i = 0; i < N_CASES; i++) {
        BuildCase *build_case = &cases[i];
        const double n = elements[i % N_SHOWN];
        *build_case = (BuildCase){.builder = i / N_SHOWN,
                                  .n_elements = (int)n,
                                  .size = {n / 8, 2 * n, 40 * n, 9 * n},
                                  .n_peak_bytes = 90 * n};
        const double ns = BUILDERS[build_case->builder].law == LINEAR ? 100 : 2 * log2(n) + 10;
        const double factors[] = {1, 0.5, 2};
        for (int round = 0; round < 3; round++) {
            series_add(&build_case->builds, factors[round] * ns * n / 1e6);
            series_end_round(&build_case->builds);
        }
    }
}

static void expect_in_report(const char *part)
{
    capture_begin(1);
    report_builds_print(cases, N_CASES);
    const char *report = capture_end(1);
    cr_expect_not_null(strstr(report, part), "%s\nis not in\n%s", part, report);
}

Test(bench_builds, a_case_is_told_in_shares_of_an_element)
{
    cases_make();
    expect_in_report("  lab 08, by cost\n"
                     "       1024       0.03  (0.02 to 0.06)             30        9.0      16.0  "
                     "   40.0     90.0\n");
}

Test(bench_builds, both_laws_are_told_with_what_they_are_off_by)
{
    cases_make();
    // 30, 34 and 38 ns an element: (1/30 + 1/34 + 1/38) / (1/30^2 + 1/34^2 + 1/38^2) = 33.37, and
    // 38 is off by 12 % of itself.
    expect_in_report("  lab 06, 6 levels more than log2 N       2.00             10.00       0 %  "
                     "     33.37      12 %\n");
    expect_in_report("            100.00       0 %      100.00       0 %\n"
                     "  lab 06, 6 levels");
}

Test(bench_builds, the_file_has_a_row_a_case)
{
    cases_make();
    capture_begin(1);
    cr_assert_eq(report_builds_write_csv(cases, N_CASES, "."), 0);
    capture_end(1);
    char text[CSV_TEXT_BYTES];
    const int n_rows = csv_file_read("bench_builds.csv", 11, text);
    cr_expect_eq(n_rows, N_CASES, "%s", text);
    cr_expect_not_null(strstr(text, "\nmiddle3d-fixed,4096,0.4096,0.2048,0.8192,0.4096,36864,36864,"
                                    "16.00,40.00,90.00\n"),
                       "%s", text);
}

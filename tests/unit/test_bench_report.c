// The bench's reports: a ratio and the spread beside it are of one kind, so that it lies within.
#include "report.h"

#include "options.h"
#include "surroundings.h"

enum { N_ROUNDS = 3 };

const char *const CASE2D_NAMES[N_CASE2D_KINDS] = {"fill",  "naive",   "kdtree",
                                                  "tiles", "painter", "cairo"};

// A kernel that is ten times as fast as the naive one in every round, though 1 is the ratio of the
// medians of all frames: half of them were drawn while the machine was slow.
static void rounds_make(Series *naive, Series *kdtree)
{
    static const double naive_ms[N_ROUNDS] = {100, 10, 10};
    static const double kdtree_ms[N_ROUNDS][3] = {{10, 10, 10}, {1, 1, 10}, {1, 1, 10}};
    for (int round = 0; round < N_ROUNDS; round++) {
        series_add(naive, naive_ms[round]);
        series_end_round(naive);
        for (int i = 0; i < 3; i++) {
            series_add(kdtree, kdtree_ms[round][i]);
        }
        series_end_round(kdtree);
    }
}

Test(bench_report, a_ratio_is_the_median_of_the_rounds)
{
    static Case2D cases[4];
    static const Scene2D scene = {
        .n_circles = SCENE2D_DEFAULT_CIRCLES, .width = 1024, .height = 1024};
    cases[0] = (Case2D){.kind = NAIVE, .scene = &scene, .n_rows = 1024};
    cases[1] = (Case2D){.kind = KDTREE, .scene = &scene, .n_rows = 1024};
    cases[1].limits = (KdTreeLimits){OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};
    cases[2] = (Case2D){.kind = TILES, .scene = &scene, .n_rows = 1024};
    cases[0].radii = cases[1].radii = cases[2].radii = "2 to 20";
    cases[3] = (Case2D){.kind = FILL, .scene = &scene, .n_rows = 1024};
    rounds_make(&cases[0].frames, &cases[1].frames);
    rounds_make(&cases[3].frames, &cases[1].builds);
    rounds_make(&cases[2].mapped, &cases[2].frames);  // tiles as fast as the kd-tree
    capture_begin(1);
    report_print(cases, 4, "a device");
    const char *report = capture_end(1);
    cr_expect_not_null(strstr(report, "    10  (single rounds: 10 to 10)\n"), "%s", report);
    // And in the tables, which tell no spread.
    cr_expect_not_null(strstr(report, "    10  the labs' own  fastest\n"), "%s", report);
    cr_expect_not_null(strstr(report, "     10.00       10.00     10.0\n"), "%s", report);
    cr_expect_not_null(strstr(report, "10             1.0  (single rounds: 1.0 to 1.0)\n"), "%s",
                       report);
    // Ten times as long until the host has the picture, and no peer there.
    cr_expect_not_null(strstr(report, "          0.10\n"), "%s", report);
    cr_expect_not_null(strstr(report, "cairo took no part"), "%s", report);
}

Test(bench_report, a_peer_is_compared_with_the_tiles_of_its_scene)
{
    static Case2D cases[6];
    static const Scene2D scene = {
        .n_circles = SCENE2D_DEFAULT_CIRCLES, .width = 1024, .height = 1024};
    const Case2DKind kinds[] = {NAIVE, KDTREE, TILES, PAINTER, CAIRO, FILL};
    for (int i = 0; i < 6; i++) {
        cases[i] = (Case2D){
            .kind = kinds[i], .scene = &scene, .n_rows = 1024, .radii = "2 to 20", .n_threads = 7};
    }
    cases[1].limits = (KdTreeLimits){OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};
    rounds_make(&cases[0].frames, &cases[1].frames);
    rounds_make(&cases[3].frames, &cases[2].frames);  // the painter takes ten times as long
    rounds_make(&cases[2].mapped, &cases[4].frames);  // cairo as long as the tiles
    rounds_make(&cases[5].frames, &cases[1].builds);
    capture_begin(1);
    report_print(cases, 6, "a device");
    const char *report = capture_end(1);
    cr_expect_not_null(strstr(report, "10.0 (10.0 to 10.0)"), "%s", report);
    cr_expect_not_null(strstr(report, "1.0 (1.0 to 1.0)"), "%s", report);
    cr_expect_not_null(strstr(report, "threads: 7; cairo: arc"), "%s", report);
}

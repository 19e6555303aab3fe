// The bench's report of moving scenes: where the curves cross, and what they are made of.
#include "report_moving.h"

#include "csv_file.h"
#include "surroundings.h"

TestSuite(bench_report_moving, .init = folder_enter, .fini = folder_leave);

// In the last round the naive kernel takes twice as long.
enum { N_ROUNDS = 3, MAX_CASES = 5 };

// Milliseconds of a moving frame: the naive kernel's, and those of a tree.
typedef struct Times {
    double naive, build, copy, draw;
} Times;

static Case3D cases[MAX_CASES];
static int n_cases;

// A median of `ms` in each round, between others.
static void rounds_make(Series *series, double ms, double in_last_round)
{
    for (int round = 0; round < N_ROUNDS; round++) {
        const double here = round == N_ROUNDS - 1 ? in_last_round : ms;
        series_add(series, here / 10);
        series_add(series, here);
        series_add(series, here * 10);
        series_end_round(series);
    }
}

// All trees take the same times.
static void case_add(const char *scene_name, int n_spheres, Times times)
{
    Case3D *bench_case = &cases[n_cases++];
    *bench_case = (Case3D){.scene_name = scene_name, .scene.n_spheres = n_spheres};
    rounds_make(&bench_case->frames[NAIVE], times.naive, 2 * times.naive);
    for (int i = KDTREE; i <= TILES; i++) {
        rounds_make(&bench_case->builds[i], times.build, times.build);
        rounds_make(&bench_case->copies[i], times.copy, times.copy);
        rounds_make(&bench_case->frames[i], times.draw, times.draw);
    }
}

// From a tree that takes 12 ms however many spheres there are; a naive frame takes 1 ms for each.
static void steady_tree_make(void)
{
    const Times flake = {1000, 1, 1, 1};
    case_add("sphereflake", 10, flake);
    const int numbers[] = {1, 4, 25, 100};
    for (int i = 0; i < 4; i++) {
        case_add("random", numbers[i], (Times){numbers[i], 2, 3, 7});
    }
}

static void expect_in_report(const char *part)
{
    capture_begin(1);
    report_moving_print(cases, n_cases);
    const char *report = capture_end(1);
    cr_expect_not_null(strstr(report, part), "%s\nis not in\n%s", part, report);
}

Test(bench_report_moving, a_tree_pays_where_the_curves_cross)
{
    steady_tree_make();
    // Where both axes are logarithmic these curves are straight lines, so nothing is guessed. In
    // the last round it is 6.
    expect_in_report("  lab 06's tree and lab 07's kernel are quicker than the naive kernel: "
                     "from 12  (single rounds: 6 to 12)\n");
    expect_in_report("  lab 10's tiles are quicker than the naive kernel: from 12  ");
}

Test(bench_report_moving, a_frame_is_building_copying_and_drawing)
{
    steady_tree_make();
    expect_in_report("         25       25.00       2.000       3.000        7.00       12.00  "
                     "             2.08  (2.08 to 4.17)\n");
}

Test(bench_report_moving, a_tree_may_pay_for_few_spheres_only)
{
    // As on a device that draws so fast that the host cannot build beside it.
    case_add("random", 1, (Times){12, 0.5, 0.25, 0.25});
    case_add("random", 100, (Times){12, 50, 25, 25});
    expect_in_report("lab 07's kernel are quicker than the naive kernel: from 1  (single rounds: "
                     "1 to 1) to 12  (single rounds: 12 to 24)\n");
}

Test(bench_report_moving, times_that_hardly_differ_make_no_crossing)
{
    const Times tree = {0, 1, 1, 8};
    const int numbers[] = {1, 10, 1000, 10000, 100000};
    const double naive[] = {5, 20, 20, 9.99, 10.01};
    for (int i = 0; i < 5; i++) {
        case_add("random", numbers[i], (Times){naive[i], tree.build, tree.copy, tree.draw});
    }
    // From the root of 10 to nearly 10000; once more from where 9.99 becomes 10.01, which is short.
    expect_in_report("lab 07's kernel are quicker than the naive kernel: from 3.2  (single rounds: "
                     "1 to 3.2) to 10000  (single rounds: 10000 to the end)\n");
}

Test(bench_report_moving, a_tree_may_never_pay)
{
    case_add("random", 1, (Times){1, 1, 1, 1});
    case_add("random", 100, (Times){10, 10, 10, 10});
    expect_in_report("lab 07's kernel are quicker than the naive kernel: with no number that was "
                     "measured\n");
}

Test(bench_report_moving, building_alone_is_held_against_a_frames_budget)
{
    case_add("random", 1000, (Times){1, 1, 100, 100});
    case_add("random", 10000, (Times){1, 10, 100, 100});
    case_add("random", 100000, (Times){1, 100, 100, 100});
    // A thousandth of a millisecond for each sphere.
    expect_in_report("building lab 06's tree takes longer than 1/60 s: from 17000  (single "
                     "rounds: 17000 to 17000)\n");
    expect_in_report("building lab 08's tree takes longer than 1/15 s: from 67000  ");
}

Test(bench_report_moving, the_file_has_a_row_a_way_and_random_scene)
{
    steady_tree_make();
    capture_begin(1);
    cr_assert_eq(report_moving_write_csv(cases, n_cases, "."), 0);
    capture_end(1);
    char text[CSV_TEXT_BYTES];
    const int n_rows = csv_file_read("bench3d-moving.csv", 11, text);
    cr_expect_eq(n_rows, 4 * 4, "%s", text);
    cr_expect_not_null(strstr(text, "\nnaive,25,,,25.0000,25.0000,25.0000,50.0000,1,1,1\n"), "%s",
                       text);
    cr_expect_not_null(strstr(text, "\ntiles,4,2.0000,3.0000,7.0000,12.0000,12.0000,12.0000,"
                                    "0.333333,0.333333,0.666667\n"),
                       "%s", text);
}

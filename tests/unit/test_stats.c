// common/stats: figures in their order, as text and as JSON.
#include "stats.h"
#include "surroundings.h"

#include <jansson.h>
#include <math.h>

TestSuite(stats, .init = folder_enter, .fini = folder_leave);

static json_t *report_to_json(const Stats *stats)
{
    cr_assert_eq(stats_report(stats, "stats.json"), 0);
    cr_expect_eq(folder_count(), 1, "a partial file stayed behind");
    json_t *figures = json_load_file("stats.json", 0, NULL);
    cr_assert_not_null(figures);
    return figures;
}

Test(stats, every_kind_is_written)
{
    Stats stats = {0};
    stats_text(&stats, "device", "a \"quoted\" name");
    stats_integer(&stats, "n_nodes", INT64_MAX);
    stats_number(&stats, "ratio", 0.1);
    json_t *figures = report_to_json(&stats);
    cr_expect_str_eq(json_string_value(json_object_get(figures, "device")), "a \"quoted\" name");
    cr_expect_eq(json_integer_value(json_object_get(figures, "n_nodes")), INT64_MAX);
    cr_expect_eq(json_real_value(json_object_get(figures, "ratio")), 0.1);
    json_decref(figures);
    stats_free(&stats);
    cr_expect_null(stats.values);
    stats_free(&stats);
}

Test(stats, what_is_not_finite_is_null)
{
    Stats stats = {0};
    stats_number(&stats, "nan", NAN);
    stats_number(&stats, "infinity", -INFINITY);
    json_t *figures = report_to_json(&stats);
    cr_expect(json_is_null(json_object_get(figures, "nan")));
    cr_expect(json_is_null(json_object_get(figures, "infinity")));
    json_decref(figures);
    stats_free(&stats);
}

Test(stats, the_later_value_holds)
{
    Stats stats = {0};
    stats_integer(&stats, "n", 1);
    stats_text(&stats, "n", "two");
    json_t *figures = report_to_json(&stats);
    cr_expect_eq(json_object_size(figures), 1);
    cr_expect_str_eq(json_string_value(json_object_get(figures, "n")), "two");
    json_decref(figures);
    stats_free(&stats);
}

Test(stats, are_printed_in_their_order)
{
    Stats stats = {0};
    stats_integer(&stats, "second", 2);
    stats_number(&stats, "first", 0.5);
    capture_begin(1);
    cr_expect_eq(stats_report(&stats, NULL), 0);
    cr_expect_str_eq(capture_end(1), "second  2\nfirst   0.5\n");
    cr_expect_eq(folder_count(), 0, "without a path no file is written");
    stats_free(&stats);
}

Test(stats, no_figures_are_an_empty_object)
{
    Stats stats = {0};
    json_t *figures = report_to_json(&stats);
    cr_expect_eq(json_object_size(figures), 0);
    json_decref(figures);
}

Test(stats, milliseconds_give_min_median_max)
{
    Stats stats = {0};
    double odd[] = {3, 1, 2};
    double even[] = {4, 1, 2, 8};
    stats_milliseconds(&stats, "odd", odd, 3);
    stats_milliseconds(&stats, "even", even, 4);
    stats_milliseconds(&stats, "none", NULL, 0);
    json_t *figures = report_to_json(&stats);
    cr_expect_eq(json_object_size(figures), 6);
    cr_expect_eq(json_real_value(json_object_get(figures, "odd.min_ms")), 1);
    cr_expect_eq(json_real_value(json_object_get(figures, "odd.median_ms")), 2);
    cr_expect_eq(json_real_value(json_object_get(figures, "odd.max_ms")), 3);
    cr_expect_eq(json_real_value(json_object_get(figures, "even.median_ms")), 3);
    cr_expect_eq(odd[0], 1.0, "the array is sorted");
    json_decref(figures);
    stats_free(&stats);
}

Test(stats, the_median_sorts)
{
    double odd[] = {3, 1, 2};
    double even[] = {8, 1, 2, 4};
    double one[] = {5};
    cr_expect_eq(stats_median(odd, 3), 2);
    cr_expect_eq(stats_median(even, 4), 3);
    cr_expect_eq(stats_median(one, 1), 5);
    cr_expect(even[0] == 1 && even[3] == 8, "found %g and %g at the ends", even[0], even[3]);
}

// A file name of the user's need not be UTF-8, but JSON must be.
Test(stats, broken_text_is_mended)
{
    Stats stats = {0};
    stats_text(&stats, "scene", "caf\xe9.csv");
    json_t *figures = report_to_json(&stats);
    cr_expect_str_eq(json_string_value(json_object_get(figures, "scene")), "caf\\xE9.csv");
    json_decref(figures);
    stats_free(&stats);
}

Test(stats, a_place_that_cannot_be_written)
{
    Stats stats = {0};
    stats_integer(&stats, "n", 1);
    cr_expect_eq(WITH_MESSAGE("nowhere/stats.json", stats_report(&stats, "nowhere/stats.json")),
                 -1);
    cr_expect_eq(folder_count(), 0);
    stats_free(&stats);
}

Test(stats, the_clock_counts_milliseconds)
{
    double start = stats_clock_ms();
    usleep(20 * 1000);
    double elapsed = stats_clock_ms() - start;
    cr_expect(elapsed >= 20 && elapsed < 5000, "%g ms", elapsed);
}

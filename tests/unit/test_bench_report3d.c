// The 3D bench's report: which of Embree's calls it calls the best, and the ratios to it; of
// frames, and of shadow and mirrored rays; and lab 10's tiles beside lab 09.
#include "report_lit.h"
#include "report_secondary.h"

#include "surroundings.h"

TestSuite(bench_report3d, .init = folder_enter, .fini = folder_leave);

enum { N_ROUNDS = 3, N_FRAMES = 3 };

// What the report asks of the bench's other parts.
const char *embree_peer_version(void)
{
    return "3.13.5";
}

int case3d_share_pixels(const Case3D *bench_case)
{
    (void)bench_case;
    return CASE3D_SIDE * CASE3D_SIDE;
}

// Frames of as many milliseconds, but for a quick one and a slow one; twice that in the last round,
// in which the machine is slow.
static void frames_make(Series *frames, double ms)
{
    for (int round = 0; round < N_ROUNDS; round++) {
        const double here = round == N_ROUNDS - 1 ? 2 * ms : ms;
        series_add(frames, here / 10);
        series_add(frames, here);
        series_add(frames, here * 10);
        series_end_round(frames);
    }
}

// The sphereflake as all have drawn it, but for Embree's streams: Embree 4 has none.
static Case3D *flake_make(void)
{
    static const double frame_ms[N_RENDERERS] = {
        [NAIVE] = 8000,
        [KDTREE] = 80,
        [BY_COST] = 75,
        [TILES] = 10,
        [EMBREE] = 60,
        [EMBREE + EMBREE_4] = 40,
        [EMBREE + EMBREE_8] = 20,
        [EMBREE + EMBREE_16] = 30,
    };
    static Case3D flake;
    flake = (Case3D){.scene_name = "sphereflake"};
    for (int i = 0; i < N_RENDERERS; i++) {
        if (frame_ms[i] > 0) {
            frames_make(&flake.frames[i], frame_ms[i]);
        }
    }
    // The smallest of all times is not what makes a call the best.
    flake.frames[EMBREE + EMBREE_16].ms[0] = 0.5;
    for (int i = KDTREE; i < N_TREES; i++) {
        frames_make(&flake.builds[i], i);
    }
    frames_make(&flake.parallel_builds[KDTREE], 2);
    frames_make(&flake.parallel_builds[BY_COST], 5);
    frames_make(&flake.parallel_builds[EMBREE], 1);
    flake.differences[EMBREE + EMBREE_4].n_different = 5;
    flake.differences[EMBREE + EMBREE_8].n_different = 7;
    flake.differences[TILES].n_different = 3;
    return &flake;
}

static const char *report_of(const Case3D *flake, ReportContext context)
{
    capture_begin(1);
    report3d_print(flake, 1, context);
    return capture_end(1);
}

static int count_of(const char *text, const char *part)
{
    int n = 0;
    for (const char *at = strstr(text, part); at != NULL; at = strstr(at + 1, part)) {
        n++;
    }
    return n;
}

static void expect_in(const char *report, const char *part)
{
    cr_expect_not_null(strstr(report, part), "%s\nis not in\n%s", part, report);
}

static int begins_with(const char *line, const char *beginning)
{
    return beginning != NULL && strncmp(line, beginning, strlen(beginning)) == 0;
}

// A CSV file has n_rows rows besides its head, all of the same length, and marks those as the best
// that begin with one text or the other.
static void expect_best_in_file(const char *name, int n_rows, const char *best,
                                const char *other_best)
{
    char line[512];
    FILE *file = fopen(name, "r");
    cr_assert_not_null(file);
    cr_assert_not_null(fgets(line, sizeof line, file));
    const int n_commas = count_of(line, ",");
    int n_found = 0;
    for (; fgets(line, sizeof line, file) != NULL; n_found++) {
        const int is_best = strstr(line, ",1\n") != NULL;
        cr_expect_eq(count_of(line, ","), n_commas, "%s", line);
        cr_expect_eq(is_best, begins_with(line, best) || begins_with(line, other_best), "%s", line);
    }
    fclose(file);
    cr_expect_eq(n_found, n_rows);
}

Test(bench_report3d, the_best_of_embrees_calls_has_the_smallest_median)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "  rtcIntersect8          20.00  (2.00 to 400.00, 9 frames)  52.43 Mray/s, "
                      "2 CPU threads: Embree's best\n");
    cr_expect_eq(count_of(report, "Embree's best\n"), 1, "%s", report);
    // Compared with lab 10's tiles, in one line: 104.86 and 52.43 million rays a second.
    expect_in(report,
              "sphereflake         104.86     52.43    2.00  (single rounds: 2.00 to 2.00)  "
              "rtcIntersect8\n");
    // And lab 07's kernel with one ray at a time, with either tree.
    expect_in(report, "sphereflake       kd-tree (lab 07)     13.11     17.48    0.75  (single "
                      "rounds: 0.75 to 0.75)\n");
    expect_in(report, "sphereflake       by cost (lab 08)     13.98     17.48    0.80  (single "
                      "rounds: 0.80 to 0.80)\n");
}

Test(bench_report3d, tiles_are_compared_with_lab_07)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "  tiles (lab 10)         10.00  (1.00 to 200.00, 9 frames)  104.9 Mray/s\n");
    expect_in(report,
              "sphereflake         104.86     13.11    8.00  (single rounds: 8.00 to 8.00)\n");
}

Test(bench_report3d, trees_on_threads_are_compared_with_embrees)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "  sphereflake: Embree's 1.00\n"
                      "    lab 06 on 2 threads      2.00    2.00  (single rounds: 2.00 to 2.00)\n"
                      "    lab 08 on 2 threads      5.00    5.00  (single rounds: 5.00 to 5.00)\n");
}

// 20 nodes, 5 leaves and 10 spheres of 16 bytes, and the spheres' ids; 13.1 million rays a second.
Test(bench_report3d, what_a_ray_reads_and_computes)
{
    Case3D *flake = flake_make();
    flake->work = (WorkOfRay){20, 5, 10, 42};
    const char *report = report_of(flake, (ReportContext){"a device", 1, 2});
    expect_in(report,
              "  sphereflake          600         420     7.86     5.51    35.0         42.0\n");
}

Test(bench_report3d, a_call_that_is_not_there_is_not_listed)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 1, 2});
    cr_expect_null(strstr(report, "rtcIntersect1M"), "%s", report);
}

Test(bench_report3d, without_embree_there_are_its_rates_and_rows_no_more)
{
    Case3D *flake = flake_make();
    for (int i = EMBREE; i < N_RENDERERS; i++) {
        flake->frames[i] = (Series){0};
    }
    flake->builds[EMBREE] = (Series){0};
    memset(flake->parallel_builds, 0, sizeof flake->parallel_builds);
    const char *report = report_of(flake, (ReportContext){"a device", 1, 0});
    cr_expect_null(strstr(report, "rtcIntersect"), "%s", report);
    expect_in(report, "tiles (lab 10) and kd-tree (lab 07)\n");
    expect_in(report, "Embree took no part");
    cr_expect_null(strstr(report, "on 0 threads"), "%s", report);
}

Test(bench_report3d, the_most_different_picture_of_embrees_counts)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "       3 of  1048576         7 of  1048576");
}

Test(bench_report3d, rates_beside_a_gpu_are_not_compared_with_embree)
{
    const char *report = report_of(flake_make(), (ReportContext){"a device", 0, 2});
    cr_expect_null(strstr(report, "the best of Embree's calls"), "%s", report);
    expect_in(report, "tiles (lab 10) and kd-tree (lab 07)\n");
}

Test(bench_report3d, the_file_marks_the_best_call)
{
    capture_begin(1);
    cr_assert_eq(report3d_write_csv(flake_make(), 1, "."), 0);
    capture_end(1);
    expect_best_in_file("bench3d.csv", 8, "embree8,", NULL);
}

// ---- Shadow and mirrored rays ---------------------------------------------------------------

// A million shadow rays and half as many mirrored ones, without Embree's streams.
static SecondaryRays *rays_make(void)
{
    static const double ms[N_RAY_KINDS][N_SEARCHERS] = {
        [SHADOW_RAYS] = {100, 25, 80, 60, 40, 50},
        [MIRRORED_RAYS] = {50, 0, 20, 25, 30, 40},
    };
    static SecondaryRays rays;
    rays = (SecondaryRays){0};
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        RayList *list = &rays.lists[kind];
        list->n_rays = kind == SHADOW_RAYS ? 1000000 : 500000;
        for (int i = 0; i < N_SEARCHERS; i++) {
            if (ms[kind][i] > 0) {
                frames_make(&list->times[i], ms[kind][i]);
            }
        }
    }
    rays.lists[SHADOW_RAYS].n_different[EMBREE_SEARCHES + EMBREE_8] = 3;
    rays.lists[SHADOW_RAYS].n_different[LAB_10] = 2;
    return &rays;
}

static const char *report_of_rays(const SecondaryRays *rays, ReportContext context)
{
    capture_begin(1);
    report_secondary_print(rays, "sphereflake", context);
    return capture_end(1);
}

Test(bench_report3d, each_kind_of_rays_has_its_own_best_call)
{
    const char *report = report_of_rays(rays_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "  1000000 shadow rays\n  kd-tree (lab 09)      100.00  (10.00 to 2000.00, "
                      "9 times)  10 Mray/s\n");
    expect_in(report, "  rtcOccluded8           40.00  (4.00 to 800.00, 9 times)  25 Mray/s, 2 CPU "
                      "threads: Embree's best; 3 other answers\n");
    expect_in(report, "  rtcIntersect1          20.00  (2.00 to 400.00, 9 times)  25 Mray/s, 2 CPU "
                      "threads: Embree's best; 0 other answers\n");
    cr_expect_eq(count_of(report, "Embree's best"), 2, "%s", report);
    expect_in(report, "  shadow    kd-tree (lab 09)     10.00     25.00    0.40  (single rounds: "
                      "0.40 to 0.40)  rtcOccluded8\n");
    expect_in(report, "  mirrored  kd-tree (lab 09)     10.00     25.00    0.40  (single rounds: "
                      "0.40 to 0.40)  rtcIntersect1\n");
    cr_expect_null(strstr(report, "1M"), "%s", report);
}

Test(bench_report3d, tiles_of_shadow_rays_are_compared_with_lab_09_and_with_embree)
{
    const char *report = report_of_rays(rays_make(), (ReportContext){"a device", 1, 2});
    expect_in(report, "  tiles (lab 10)         25.00  (2.50 to 500.00, 9 times)  40 Mray/s; 2 "
                      "other answers\n");
    expect_in(report, "  kd-tree / tiles: 4.00  (single rounds: 4.00 to 4.00)\n");
    expect_in(report, "  shadow    tiles (lab 10)       40.00     25.00    1.60  (single rounds: "
                      "1.60 to 1.60)  rtcOccluded8\n");
    // Mirrored rays go by themselves in lab 10, too.
    cr_expect_eq(count_of(report, "tiles (lab 10)"), 2, "%s", report);
}

Test(bench_report3d, without_embree_there_are_the_rows_of_labs_09_and_10)
{
    SecondaryRays *rays = rays_make();
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        for (int i = EMBREE_SEARCHES; i < N_SEARCHERS; i++) {
            rays->lists[kind].times[i] = (Series){0};
        }
    }
    const char *report = report_of_rays(rays, (ReportContext){"a device", 1, 0});
    cr_expect_eq(count_of(report, "kd-tree (lab 09)"), 2, "%s", report);
    cr_expect_eq(count_of(report, "tiles (lab 10)"), 1, "%s", report);
    cr_expect_null(strstr(report, "Embree"), "%s", report);
}

Test(bench_report3d, rays_of_a_gpu_are_not_compared_with_embree)
{
    const char *report = report_of_rays(rays_make(), (ReportContext){"a device", 0, 2});
    cr_expect_null(strstr(report, "the best of Embree's calls"), "%s", report);
    expect_in(report, "rtcOccluded8");
}

Test(bench_report3d, the_file_of_rays_marks_the_best_call_of_each_kind)
{
    capture_begin(1);
    cr_assert_eq(report_secondary_write_csv(rays_make(), "sphereflake", "."), 0);
    capture_end(1);
    expect_best_in_file("bench3d-secondary.csv", 11, "shadow,sphereflake,embree8,",
                        "mirrored,sphereflake,embree1,");
}

// ---- Frames with shadows --------------------------------------------------------------------

// Frames of the same times, but for those without mirrors: five times as quick by tiles, in one
// round only half of that.
static LitFrame *lit_make(void)
{
    static LitFrame frames[N_LIT_FRAMES];
    memset(frames, 0, sizeof frames);
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        frames[i].side = i < N_MIRROR_NUMBERS ? 1024 : 512;
        frames[i].n_mirrors = i % N_MIRROR_NUMBERS;
        frames_make(&frames[i].times[LIT_RAYS], 200);
        frames_make(&frames[i].times[LIT_TILES], frames[i].n_mirrors == 0 ? 40 : 200);
    }
    frames[0].times[LIT_TILES].round_median_ms[N_ROUNDS - 1] *= 2;
    frames[2].n_different = 180;
    return frames;
}

Test(bench_report3d, frames_with_shadows_are_compared)
{
    capture_begin(1);
    report_lit_print(lit_make(), "sphereflake");
    const char *report = capture_end(1);
    expect_in(report, "  1024x1024 pixels, mirrors: 0\n"
                      "  kd-tree (lab 09)      200.00  (20.00 to 4000.00, 9 frames)\n"
                      "  tiles (lab 10)         40.00  (4.00 to 800.00, 9 frames); 0 of 1048576 "
                      "pixels differ\n");
    expect_in(report, "; 180 of 1048576 pixels differ\n  512x512 pixels, mirrors: 0\n");
    expect_in(report, "  1024x1024        0     25.00      5.00    5.00  (single rounds: 2.50 to "
                      "5.00)\n");
    expect_in(report, "   512x512         2      5.00      5.00    1.00  (single rounds: 1.00 to "
                      "1.00)\n");
}

Test(bench_report3d, the_file_of_frames_with_shadows_has_all_of_them)
{
    static const char *const lines[] = {
        "renderer,scene,side,mirrors,median_ms,min_ms,max_ms,fps,ratio,min_ratio,max_ratio,"
        "different_pixels\n",
        "kdtree,sphereflake,1024,0,200.0000,20.0000,4000.0000,5,,,,\n",
        "tiles,sphereflake,1024,0,40.0000,4.0000,800.0000,25,5,2.5,5,0\n",
        "kdtree,sphereflake,1024,1,200.0000,20.0000,4000.0000,5,,,,\n",
        "tiles,sphereflake,1024,1,200.0000,20.0000,4000.0000,5,1,1,1,0\n",
        "kdtree,sphereflake,1024,2,200.0000,20.0000,4000.0000,5,,,,\n",
        "tiles,sphereflake,1024,2,200.0000,20.0000,4000.0000,5,1,1,1,180\n",
    };
    capture_begin(1);
    cr_assert_eq(report_lit_write_csv(lit_make(), "sphereflake", "."), 0);
    capture_end(1);
    char line[512];
    int n_lines = 0;
    FILE *file = fopen("bench3d-lit.csv", "r");
    cr_assert_not_null(file);
    for (; fgets(line, sizeof line, file) != NULL; n_lines++) {
        if (n_lines < (int)(sizeof lines / sizeof *lines)) {
            cr_expect_str_eq(line, lines[n_lines]);
        }
    }
    fclose(file);
    cr_expect_eq(n_lines, 1 + N_LIT_RENDERERS * N_LIT_FRAMES);
}

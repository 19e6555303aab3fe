// What the 3D bench tells (see report3d.h).
//
// Read next: bench3d.gnuplot.
#include "report3d.h"

#include "embree_peer.h"
#include "output_file.h"
#include "path.h"
#include "report_trees.h"
#include "roofline.h"

#include <stdio.h>
#include <string.h>

const char *const RENDERER3D_TITLES[N_RENDERERS] = {
    [NAIVE] = "naive (lab 05)",
    [KDTREE] = "kd-tree (lab 07)",
    [BY_COST] = "by cost (lab 08)",
    [TILES] = "tiles (lab 10)",
    [EMBREE + EMBREE_1] = "rtcIntersect1",
    [EMBREE + EMBREE_4] = "rtcIntersect4",
    [EMBREE + EMBREE_8] = "rtcIntersect8",
    [EMBREE + EMBREE_16] = "rtcIntersect16",
    [EMBREE + EMBREE_STREAM] = "rtcIntersect1M",
};

// In the CSV file.
static const char *const RENDERER_NAMES[N_RENDERERS] = {
    "naive", "kdtree", "bycost", "tiles", "embree1", "embree4", "embree8", "embree16", "embree1M"};

// The scenes of thousands of spheres.
static const char *const COMPARED[] = {"sphereflake", "random:n=100000", "random:n=1000000"};
enum { N_COMPARED = sizeof COMPARED / sizeof *COMPARED };

int report3d_compares(const Case3D *bench_case)
{
    for (int i = 0; i < N_COMPARED; i++) {
        if (strcmp(COMPARED[i], bench_case->scene_name) == 0) {
            return 1;
        }
    }
    return 0;
}

static Spread spread(const Series *series)
{
    return spread_of(series->ms, series->n);
}

static double mray_s(const Series *frames)
{
    return (double)CASE3D_SIDE * CASE3D_SIDE / 1e3 / series_median(frames);
}

static double drawn_share(const Case3D *bench_case, Renderer renderer)
{
    return renderer == NAIVE
               ? (double)case3d_share_pixels(bench_case) / ((double)CASE3D_SIDE * CASE3D_SIDE)
               : 1;
}

// The call of Embree with the smallest median, where it took part.
static Renderer best_of_embree(const Case3D *bench_case)
{
    return EMBREE + series_quickest(&bench_case->frames[EMBREE], N_EMBREE_CALLS);
}

// ---- For people -----------------------------------------------------------------------------

void report3d_print_ratio(const Series *dividend, const Series *divisor)
{
    const Spread ratio = series_ratio(dividend, divisor);
    printf("  %6.2f  (single rounds: %.2f to %.2f)", ratio.median, ratio.min, ratio.max);
}

// All renderers.
static void print_comparison(const Case3D *bench_case, ReportContext context)
{
    const Spread ratio = series_ratio(&bench_case->frames[NAIVE], &bench_case->frames[KDTREE]);
    printf("\n%s, %d spheres: milliseconds a frame, median (smallest to largest)\n",
           bench_case->scene_name, bench_case->scene.n_spheres);
    for (int i = 0; i < N_RENDERERS; i++) {
        const Series *frames = &bench_case->frames[i];
        if (frames->n == 0) {
            continue;
        }
        const Spread ms = spread(frames);
        printf("  %-16s  %10.2f  (%.2f to %.2f, %d %s)  %.4g Mray/s", RENDERER3D_TITLES[i],
               ms.median, ms.min, ms.max, frames->n, frames->n == 1 ? "frame" : "frames",
               mray_s(frames));
        if (drawn_share(bench_case, i) < 1) {
            printf(", %.2g%% of the picture, scaled", 100 * drawn_share(bench_case, i));
        }
        if (i >= EMBREE) {
            printf(", %d CPU threads%s", context.n_threads,
                   i == (int)best_of_embree(bench_case) ? ": Embree's best" : "");
        }
        printf("\n");
    }
    printf("  naive / kd-tree: %.0f  (single rounds: %.0f to %.0f)\n", ratio.median, ratio.min,
           ratio.max);
}

static void print_work(const Case3D *cases, int n_cases)
{
    printf("\nWork of a ray in the tree, on average; the naive kernel asks every sphere\n");
    printf("  %-16s  %8s  %11s  %6s  %14s\n", "scene", "spheres", "inner nodes", "leaves",
           "spheres asked");
    for (int i = 0; i < n_cases; i++) {
        const WorkOfRay work = cases[i].work;
        printf("  %-16s  %8d  %11.2f  %6.2f  %14.2f\n", cases[i].scene_name,
               cases[i].scene.n_spheres, work.n_nodes, work.n_leaves, work.n_tests);
    }
}

static void print_growth(const Case3D *cases, int n_cases, ReportContext context)
{
    printf("\nGrowth: random spheres; milliseconds a frame, of Embree with its best call, and to "
           "build the tree on\none thread\n");
    printf("  %9s  %12s  %9s  %9s  %9s", "spheres", "naive", "kd-tree", "ratio", "tiles");
    if (context.n_threads > 0) {
        printf("  %9s", "Embree");
    }
    printf("  %10s", "build");
    if (context.n_threads > 0) {
        printf("  %10s", "Embree's");
    }
    printf("\n");
    for (int i = 0; i < n_cases; i++) {
        const Case3D *bench_case = &cases[i];
        if (!case3d_is_random(bench_case)) {
            continue;
        }
        const Series *naive = &bench_case->frames[NAIVE], *kdtree = &bench_case->frames[KDTREE];
        printf("  %9d  %12.2f  %9.2f  %9.3g  %9.2f", bench_case->scene.n_spheres,
               series_median(naive), series_median(kdtree), series_ratio(naive, kdtree).median,
               series_median(&bench_case->frames[TILES]));
        if (context.n_threads > 0) {
            printf("  %9.2f", series_median(&bench_case->frames[best_of_embree(bench_case)]));
        }
        printf("  %10.3f", series_median(&bench_case->builds[KDTREE]));
        if (context.n_threads > 0) {
            printf("  %10.3f", series_median(&bench_case->builds[EMBREE]));
        }
        if (drawn_share(bench_case, NAIVE) < 1) {
            printf("  naive: %.2g%% of the picture, scaled", 100 * drawn_share(bench_case, NAIVE));
        }
        printf("\n");
    }
}

// Of one ray at a time: lab 07's kernel with either tree against Embree.
static void print_rates(const Case3D *cases, int n_cases, ReportContext context)
{
    static const Renderer ours[] = {KDTREE, BY_COST};
    printf(
        "\nMillion rays a second, one ray at a time: lab 07's kernel with lab 06's tree and with "
        "lab 08's, and\nEmbree %s, %d threads; target: as many\n",
        embree_peer_version(), context.n_threads);
    printf("  %-16s  %-16s  %8s  %8s  %6s\n", "scene", "tree", "kernel", "Embree", "ratio");
    for (int i = 0; i < n_cases; i++) {
        const Series *embree = &cases[i].frames[EMBREE];
        for (int k = 0; k < 2 && report3d_compares(&cases[i]); k++) {
            const Series *frames = &cases[i].frames[ours[k]];
            printf("  %-16s  %-16s  %8.2f  %8.2f", cases[i].scene_name, RENDERER3D_TITLES[ours[k]],
                   mray_s(frames), mray_s(embree));
            report3d_print_ratio(embree, frames);
            printf("\n");
        }
    }
}

// Those of lab 10 against lab 07's, or against Embree's best call.
static void print_tile_rates(const Case3D *cases, int n_cases, int against_embree)
{
    printf("\nMillion rays a second: tiles (lab 10) and %s\n",
           against_embree ? "the best of Embree's calls" : RENDERER3D_TITLES[KDTREE]);
    printf("  %-16s  %8s  %8s  %6s\n", "scene", "tiles", against_embree ? "Embree" : "kd-tree",
           "ratio");
    for (int i = 0; i < n_cases; i++) {
        if (report3d_compares(&cases[i])) {
            const Renderer other = against_embree ? best_of_embree(&cases[i]) : KDTREE;
            const Series *tiles = &cases[i].frames[TILES], *frames = &cases[i].frames[other];
            printf("  %-16s  %8.2f  %8.2f", cases[i].scene_name, mray_s(tiles), mray_s(frames));
            report3d_print_ratio(frames, tiles);
            printf("%s%s\n", against_embree ? "  " : "",
                   against_embree ? RENDERER3D_TITLES[other] : "");
        }
    }
}

// The most pixels that differ from a picture of Embree's.
static int most_different(const Case3D *bench_case)
{
    int most = 0;
    for (int i = EMBREE; i < N_RENDERERS; i++) {
        const int n_different = bench_case->differences[i].n_different;
        most = n_different > most ? n_different : most;
    }
    return most;
}

static void print_pictures(const Case3D *cases, int n_cases, ReportContext context)
{
    const int n_pixels = CASE3D_SIDE * CASE3D_SIDE;
    printf(
        "\nPixels of the kd-tree's picture that differ by more than half a step of 255; from the "
        "tiles' bytes\nby more than one step; from Embree's: the most of a call\n");
    printf("  %-16s  %20s  %20s", "scene", "from the naive one", "from the tiles'");
    if (context.n_threads > 0) {
        printf("  %20s", "from Embree's");
    }
    printf("\n");
    for (int i = 0; i < n_cases; i++) {
        const ImageDifference *differences = cases[i].differences;
        printf("  %-16s  %8d of %8d  %8d of %8d", cases[i].scene_name,
               differences[NAIVE].n_different, case3d_share_pixels(&cases[i]),
               differences[TILES].n_different, n_pixels);
        if (context.n_threads > 0) {
            printf("  %8d of %8d", most_different(&cases[i]), n_pixels);
        }
        printf("%s\n",
               differences[NAIVE].max_difference == 0 ? "  equal to the naive one to the bit" : "");
    }
}

void report3d_print(const Case3D *cases, int n_cases, ReportContext context)
{
    for (int i = 0; i < n_cases; i++) {
        if (report3d_compares(&cases[i])) {
            print_comparison(&cases[i], context);
        }
    }
    if (context.n_threads == 0) {
        printf(
            "\nEmbree took no part: install the package libembree-dev and build the bench again\n");
    } else if (context.device_is_cpu) {
        print_rates(cases, n_cases, context);
        print_tile_rates(cases, n_cases, 1);
    }
    print_tile_rates(cases, n_cases, 0);
    report_trees_print(cases, n_cases, context);
    print_work(cases, n_cases);
    roofline_print(cases, n_cases);
    print_growth(cases, n_cases, context);
    print_pictures(cases, n_cases, context);
}

// ---- For the plot ---------------------------------------------------------------------------

static void write_builds(FILE *file, const Case3D *bench_case, Renderer renderer)
{
    if (renderer == NAIVE) {
        fprintf(file, ",,,,");
        return;
    }
    // Embree's calls share a tree.
    const int builder = renderer < EMBREE ? (int)renderer : EMBREE;
    const Spread ms = spread(&bench_case->builds[builder]);
    fprintf(file, ",%.4f,%.4f,%.4f,", ms.median, ms.min, ms.max);
    if (bench_case->parallel_builds[builder].n > 0) {
        fprintf(file, "%.4f", series_median(&bench_case->parallel_builds[builder]));
    }
}

static void write_tree(FILE *file, const Case3D *bench_case)
{
    const WorkOfRay work = bench_case->work;
    fprintf(file, ",%u,%u,%u,%d,%.4f,%.4f,%.4f,,\n", bench_case->n_nodes,
            bench_case->figures.n_leaves, bench_case->n_sphere_ids, bench_case->figures.depth,
            work.n_nodes, work.n_leaves, work.n_tests);
}

static void write_row(FILE *file, const Case3D *bench_case, Renderer renderer)
{
    const Series *frames = &bench_case->frames[renderer];
    const Spread ms = spread(frames);
    fprintf(file, "%s,%s,%d,%.4f,%.4f,%.4f,%.6g,%.6f", RENDERER_NAMES[renderer],
            bench_case->scene_name, bench_case->scene.n_spheres, ms.median, ms.min, ms.max,
            mray_s(frames), drawn_share(bench_case, renderer));
    write_builds(file, bench_case, renderer);
    const int n_different = bench_case->differences[renderer].n_different;
    switch (renderer) {
    case KDTREE:
        write_tree(file, bench_case);
        break;
    case NAIVE:
        fprintf(file, ",,,,,,,%d,%d,\n", bench_case->scene.n_spheres, n_different);
        break;
    default:
        fprintf(file, ",,,,,,,,%d,%d\n", n_different, renderer == best_of_embree(bench_case));
    }
}

int report3d_write_csv(const Case3D *cases, int n_cases, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench3d.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file,
            "renderer,scene,n_spheres,median_ms,min_ms,max_ms,mray_s,share,build_median_ms,"
            "build_min_ms,build_max_ms,build_parallel_ms,n_nodes,n_leaves,n_sphere_ids,depth,"
            "nodes_a_ray,leaves_a_ray,tests_a_ray,different_pixels,is_best\n");
    for (int i = 0; i < n_cases; i++) {
        for (int renderer = 0; renderer < N_RENDERERS; renderer++) {
            if (cases[i].frames[renderer].n > 0) {
                write_row(output.file, &cases[i], (Renderer)renderer);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("\nAll figures: %s\n", path);
    return 0;
}

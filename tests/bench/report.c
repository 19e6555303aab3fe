// What the bench tells (see report.h).
#include "report.h"

#include "options.h"
#include "output_file.h"
#include "path.h"

#include <stdio.h>
#include <string.h>

// The lecture's figures: 8192 circles on a GTX 470, frames a second.
#define LECTURE_NAIVE_FPS 2.5
#define LECTURE_KDTREE_FPS 311.0
#define LECTURE_RATIO 124.0

// What bench2d.c calls the lecture's scene.
#define LECTURE_RADII "2 to 20"

static Spread frame_ms(const Case2D *bench_case)
{
    return spread_of(bench_case->frames.ms, bench_case->frames.n);
}

static double fps(const Case2D *bench_case)
{
    return 1e3 / frame_ms(bench_case).median;
}

static int has_usual_limits(const Case2D *bench_case)
{
    return bench_case->limits.maxDepth == OPTIONS_DEFAULT_MAX_DEPTH &&
           bench_case->limits.targetElementsPerNode == OPTIONS_DEFAULT_LEAF_SIZE;
}

// The case of a kind over a scene; a kd-tree of usual limits.
static const Case2D *find(const Case2D *cases, Case2DKind kind, const Scene2D *scene)
{
    const Case2D *bench_case = cases;
    while (bench_case->kind != kind || bench_case->scene != scene ||
           (kind == KDTREE && !has_usual_limits(bench_case))) {
        bench_case++;
    }
    return bench_case;
}

// The case of a kind over a scene, or over any where it is NULL; NULL where there is none.
static const Case2D *find_peer(const Case2D *cases, int n_cases, Case2DKind kind,
                               const Scene2D *scene)
{
    for (int i = 0; i < n_cases; i++) {
        if (cases[i].kind == kind && (scene == NULL || cases[i].scene == scene)) {
            return &cases[i];
        }
    }
    return NULL;
}

// ---- For people -----------------------------------------------------------------------------

static void print_spread(const Case2D *bench_case)
{
    const Spread ms = frame_ms(bench_case);
    printf("  %9.2f  (%.2f to %.2f, %d %s)\n", ms.median, ms.min, ms.max, bench_case->frames.n,
           bench_case->frames.n == 1 ? "frame" : "frames");
}

// The lecture's comparison; every ratio that is printed is the median of the single rounds' ratios.
static void print_comparison(const Case2D *naive, const Case2D *kdtree, const char *device_name)
{
    const Spread ratio = series_ratio(&naive->frames, &kdtree->frames);
    printf("\nFrames a second, %d circles, radius 2 to 20 px\n", naive->scene->n_circles);
    printf("  %-32s  %8s  %8s  %6s\n", "", "naive", "kd-tree", "ratio");
    printf("  %-32.32s  %8.3g  %8.3g  %6.0f  (single rounds: %.0f to %.0f)\n", device_name,
           fps(naive), fps(kdtree), ratio.median, ratio.min, ratio.max);
    printf("  %-32s  %8.3g  %8.3g  %6.0f\n", "GTX 470, the lecture's figures", LECTURE_NAIVE_FPS,
           LECTURE_KDTREE_FPS, LECTURE_RATIO);
}

static void print_milliseconds(const Case2D *naive, const Case2D *kdtree, const Case2D *fill)
{
    printf("\nMilliseconds a frame: median (smallest to largest)\n");
    printf("  naive             ");
    print_spread(naive);
    printf("  kd-tree           ");
    print_spread(kdtree);
    printf("  writing pixels    ");
    print_spread(fill);
    printf("  Writing pixels is the floor: a kernel that does nothing else.\n");
}

// How deep is best? All limits for the lecture's scene.
static void print_trees(const Case2D *cases, int n_cases, const Case2D *naive)
{
    const Case2D *best = NULL;
    for (int i = 0; i < n_cases; i++) {
        if (cases[i].kind == KDTREE && cases[i].scene == naive->scene &&
            (best == NULL || fps(&cases[i]) > fps(best))) {
            best = &cases[i];
        }
    }
    printf("\nHow deep is best? The same scene with other limits\n");
    printf("  %9s  %9s  %6s  %8s  %10s  %8s  %8s  %6s\n", "max-depth", "leaf-size", "levels",
           "nodes", "references", "build ms", "frame ms", "ratio");
    for (int i = 0; i < n_cases; i++) {
        const Case2D *bench_case = &cases[i];
        if (bench_case->kind == KDTREE && bench_case->scene == naive->scene) {
            printf("  %9d  %9d  %6d  %8u  %10u  %8.2f  %8.2f  %6.0f%s%s\n",
                   bench_case->limits.maxDepth, bench_case->limits.targetElementsPerNode,
                   bench_case->depth, bench_case->n_nodes, bench_case->n_references,
                   spread_of(bench_case->builds.ms, bench_case->builds.n).median,
                   frame_ms(bench_case).median,
                   series_ratio(&naive->frames, &bench_case->frames).median,
                   has_usual_limits(bench_case) ? "  the labs' own" : "",
                   bench_case == best ? "  fastest" : "");
        }
    }
    printf(
        "  A reference is a circle's id in a leaf's list. Too shallow: long lists. Too deep: many\n"
        "  steps down, and memory that no cache holds, for lists that hardly get shorter.\n");
}

// Lab 10's kernel over the lecture's number of circles, small and large.
static void print_tiles(const Case2D *cases, int n_cases)
{
    printf(
        "\nTiles of 16 x 16 pixels (lab 10): milliseconds a frame, and how many times the others' "
        "that is\n");
    printf("  %9s  %10s  %10s  %8s  %14s  %14s\n", "radii, px", "naive", "kd-tree", "tiles",
           "naive/tiles", "kd-tree/tiles");
    for (int i = 0; i < n_cases; i++) {
        if (cases[i].kind == TILES) {
            const Case2D *tiles = &cases[i];
            const Case2D *naive = find(cases, NAIVE, tiles->scene);
            const Case2D *kdtree = find(cases, KDTREE, tiles->scene);
            const Spread ratio = series_ratio(&kdtree->frames, &tiles->frames);
            printf("  %9s  %10.2f  %10.2f  %8.3f  %14.0f  %14.1f  (single rounds: %.1f to %.1f)\n",
                   tiles->radii, frame_ms(naive).median, frame_ms(kdtree).median,
                   frame_ms(tiles).median, series_ratio(&naive->frames, &tiles->frames).median,
                   ratio.median, ratio.min, ratio.max);
        }
    }
}

// What a peer's frame is to that of the tiles, or nothing where the peer is not there.
static void print_peer(const Case2D *peer, const Case2D *tiles)
{
    if (peer == NULL) {
        printf("  %8s  %22s", "-", "-");
        return;
    }
    const Spread ratio = series_ratio(&peer->frames, &tiles->frames);
    char spread[64];
    snprintf(spread, sizeof spread, "%.1f (%.1f to %.1f)", ratio.median, ratio.min, ratio.max);
    printf("  %8.3f  %22s", frame_ms(peer).median, spread);
}

// Programs that draw the same circles without OpenCL, and the tiles until the host has the picture,
// as it has the peers'.
static void print_peers(const Case2D *cases, int n_cases)
{
    printf("\nThe same circles without OpenCL: milliseconds a frame, and how many times the tiles' "
           "that "
           "is\n");
    printf("  %9s  %8s  %8s  %22s  %8s  %22s  %8s  %12s\n", "radii, px", "tiles", "painter",
           "painter/tiles", "cairo", "cairo/tiles", "mapped", "tiles/mapped");
    for (int i = 0; i < n_cases; i++) {
        const Case2D *tiles = &cases[i];
        if (tiles->kind == TILES) {
            printf("  %9s  %8.3f", tiles->radii, frame_ms(tiles).median);
            print_peer(find_peer(cases, n_cases, PAINTER, tiles->scene), tiles);
            print_peer(find_peer(cases, n_cases, CAIRO, tiles->scene), tiles);
            printf("  %8.3f  %12.2f\n", spread_of(tiles->mapped.ms, tiles->mapped.n).median,
                   series_ratio(&tiles->frames, &tiles->mapped).median);
        }
    }
    const Case2D *painter = find_peer(cases, n_cases, PAINTER, NULL);
    if (painter != NULL) {
        printf("  painter: row by row in C, threads: %d; ", painter->n_threads);
    }
    const Case2D *cairo = find_peer(cases, n_cases, CAIRO, NULL);
    if (cairo != NULL) {
        printf("cairo: arc and fill, no smooth borders, one thread;\n");
    } else {
        printf("cairo took no part: install the\n  package libcairo2-dev and build the bench "
               "again;\n");
    }
    printf("  mapped: until the host can read the picture\n");
}

// Is it of the growth table: of the lecture's number of circles only the lecture's scene is.
static int is_of_growth(const Case2D *bench_case)
{
    return bench_case->radii == NULL || strcmp(bench_case->radii, LECTURE_RADII) == 0;
}

static void print_growth(const Case2D *cases, int n_cases)
{
    printf(
        "\nGrowth: milliseconds a frame; the more circles the smaller, covering the same area\n");
    printf("  %9s  %10s  %10s  %7s\n", "circles", "naive", "kd-tree", "ratio");
    for (int i = 0; i < n_cases; i++) {
        if (cases[i].kind == NAIVE && is_of_growth(&cases[i])) {
            const Case2D *naive = &cases[i];
            const Case2D *kdtree = find(cases, KDTREE, naive->scene);
            printf("  %9d  %10.2f  %10.2f  %7.1f", naive->scene->n_circles, frame_ms(naive).median,
                   frame_ms(kdtree).median, series_ratio(&naive->frames, &kdtree->frames).median);
            if (naive->n_rows < naive->scene->height) {
                printf("  naive: %d of %d rows, scaled", naive->n_rows, naive->scene->height);
            }
            printf("\n");
        }
    }
}

void report_print(const Case2D *cases, int n_cases, const char *device_name)
{
    const Case2D *naive = cases;
    while (naive->radii == NULL || !is_of_growth(naive)) {
        naive++;
    }
    const Case2D *kdtree = find(cases, KDTREE, naive->scene);
    print_comparison(naive, kdtree, device_name);
    print_milliseconds(naive, kdtree, &cases[n_cases - 1]);
    print_tiles(cases, n_cases);
    print_peers(cases, n_cases);
    print_trees(cases, n_cases, naive);
    print_growth(cases, n_cases);
}

// ---- For the plot ---------------------------------------------------------------------------

static void write_row(FILE *file, const Case2D *bench_case)
{
    const Spread ms = frame_ms(bench_case);
    // Of the growth's curves are only those that are called by the kernel's name alone.
    fprintf(file, "%s", CASE2D_NAMES[bench_case->kind]);
    if (bench_case->kind >= TILES || !is_of_growth(bench_case)) {
        fprintf(file, " %s px", bench_case->radii);
    }
    fprintf(file, ",");
    if (bench_case->kind != FILL) {
        fprintf(file, "%d", bench_case->scene->n_circles);
    }
    if (bench_case->kind == KDTREE) {
        fprintf(file, ",%d,%d", bench_case->limits.maxDepth,
                bench_case->limits.targetElementsPerNode);
    } else {
        fprintf(file, ",,");
    }
    fprintf(file, ",%.4f,%.4f,%.4f,%.4f\n", ms.median, ms.min, ms.max, fps(bench_case));
}

// The order of the rows: a kd-tree of other limits belongs to no curve.
enum RowGroup { NAIVE_ROWS, USUAL_KDTREE_ROWS, OTHER_ROWS, N_ROW_GROUPS };

static enum RowGroup row_group(const Case2D *bench_case)
{
    if (!is_of_growth(bench_case)) {
        return OTHER_ROWS;
    }
    if (bench_case->kind == NAIVE) {
        return NAIVE_ROWS;
    }
    return bench_case->kind == KDTREE && has_usual_limits(bench_case) ? USUAL_KDTREE_ROWS
                                                                      : OTHER_ROWS;
}

int report_write_csv(const Case2D *cases, int n_cases, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench2d.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "variant,n_circles,max_depth,leaf_size,median_ms,min_ms,max_ms,fps\n");
    for (int group = 0; group < N_ROW_GROUPS; group++) {
        for (int i = 0; i < n_cases; i++) {
            if ((int)row_group(&cases[i]) == group) {
                write_row(output.file, &cases[i]);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("\nAll figures: %s\n", path);
    return 0;
}

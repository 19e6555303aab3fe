// What the bench tells (see report.h).
#include "report.h"

#include "options.h"
#include "output_file.h"
#include "path.h"

#include <stdio.h>

// The lecture's figures: 8192 circles on a GTX 470, frames a second.
#define LECTURE_NAIVE_FPS 2.5
#define LECTURE_KDTREE_FPS 311.0
#define LECTURE_RATIO 124.0

static Spread frame_ms(const Variant *variant)
{
    return spread_of(variant->frames.ms, variant->frames.n);
}

static double fps(const Variant *variant)
{
    return 1e3 / frame_ms(variant).median;
}

static int has_usual_limits(const Variant *variant)
{
    return variant->limits.maxDepth == OPTIONS_DEFAULT_MAX_DEPTH &&
           variant->limits.targetElementsPerNode == OPTIONS_DEFAULT_LEAF_SIZE;
}

// The first variant of a kind and number of circles; a kd-tree of usual limits.
static const Variant *find(const Variant *variants, VariantKind kind, int n_circles)
{
    const Variant *variant = variants;
    while (variant->kind != kind || variant->scene->n_circles != n_circles ||
           (kind == KDTREE && !has_usual_limits(variant))) {
        variant++;
    }
    return variant;
}

// ---- For people -----------------------------------------------------------------------------

static void print_spread(const Variant *variant)
{
    const Spread ms = frame_ms(variant);
    printf("  %9.2f  (%.2f to %.2f, %d %s)\n", ms.median, ms.min, ms.max, variant->frames.n,
           variant->frames.n == 1 ? "frame" : "frames");
}

// The lecture's comparison; every ratio that is printed is the median of the single rounds' ratios.
static void print_comparison(const Variant *naive, const Variant *kdtree, const char *device_name)
{
    const Spread ratio = series_ratio(&naive->frames, &kdtree->frames);
    printf("\nFrames a second, %d circles, radius 2 to 20 px\n", naive->scene->n_circles);
    printf("  %-32s  %8s  %8s  %6s\n", "", "naive", "kd-tree", "ratio");
    printf("  %-32.32s  %8.3g  %8.3g  %6.0f  (single rounds: %.0f to %.0f)\n", device_name,
           fps(naive), fps(kdtree), ratio.median, ratio.min, ratio.max);
    printf("  %-32s  %8.3g  %8.3g  %6.0f\n", "GTX 470, the lecture's figures", LECTURE_NAIVE_FPS,
           LECTURE_KDTREE_FPS, LECTURE_RATIO);
}

static void print_milliseconds(const Variant *naive, const Variant *kdtree, const Variant *fill)
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
static void print_trees(const Variant *variants, int n_variants, const Variant *naive)
{
    const Variant *best = NULL;
    for (int i = 0; i < n_variants; i++) {
        if (variants[i].kind == KDTREE && variants[i].scene == naive->scene &&
            (best == NULL || fps(&variants[i]) > fps(best))) {
            best = &variants[i];
        }
    }
    printf("\nHow deep is best? The same scene with other limits\n");
    printf("  %9s  %9s  %6s  %8s  %10s  %8s  %8s  %6s\n", "max-depth", "leaf-size", "levels",
           "nodes", "references", "build ms", "frame ms", "ratio");
    for (int i = 0; i < n_variants; i++) {
        const Variant *variant = &variants[i];
        if (variant->kind == KDTREE && variant->scene == naive->scene) {
            printf("  %9d  %9d  %6d  %8u  %10u  %8.2f  %8.2f  %6.0f%s%s\n",
                   variant->limits.maxDepth, variant->limits.targetElementsPerNode, variant->depth,
                   variant->n_nodes, variant->n_references,
                   spread_of(variant->builds.ms, variant->builds.n).median,
                   frame_ms(variant).median, series_ratio(&naive->frames, &variant->frames).median,
                   has_usual_limits(variant) ? "  the labs' own" : "",
                   variant == best ? "  fastest" : "");
        }
    }
    printf(
        "  A reference is a circle's id in a leaf's list. Too shallow: long lists. Too deep: many\n"
        "  steps down, and memory that no cache holds, for lists that hardly get shorter.\n");
}

static void print_growth(const Variant *variants, int n_variants)
{
    printf(
        "\nGrowth: milliseconds a frame; the more circles the smaller, covering the same area\n");
    printf("  %9s  %10s  %10s  %7s\n", "circles", "naive", "kd-tree", "ratio");
    for (int i = 0; i < n_variants; i++) {
        if (variants[i].kind == NAIVE) {
            const Variant *naive = &variants[i];
            const Variant *kdtree = find(variants, KDTREE, naive->scene->n_circles);
            printf("  %9d  %10.2f  %10.2f  %7.1f", naive->scene->n_circles, frame_ms(naive).median,
                   frame_ms(kdtree).median, series_ratio(&naive->frames, &kdtree->frames).median);
            if (naive->n_rows < naive->scene->height) {
                printf("  naive: %d of %d rows, scaled", naive->n_rows, naive->scene->height);
            }
            printf("\n");
        }
    }
}

void report_print(const Variant *variants, int n_variants, const char *device_name)
{
    const Variant *naive = find(variants, NAIVE, SCENE2D_DEFAULT_CIRCLES);
    const Variant *kdtree = find(variants, KDTREE, SCENE2D_DEFAULT_CIRCLES);
    print_comparison(naive, kdtree, device_name);
    print_milliseconds(naive, kdtree, &variants[n_variants - 1]);
    print_trees(variants, n_variants, naive);
    print_growth(variants, n_variants);
}

// ---- For the plot ---------------------------------------------------------------------------

static void write_row(FILE *file, const Variant *variant)
{
    const Spread ms = frame_ms(variant);
    fprintf(file, "%s,", VARIANT_NAMES[variant->kind]);
    if (variant->kind != FILL) {
        fprintf(file, "%d", variant->scene->n_circles);
    }
    if (variant->kind == KDTREE) {
        fprintf(file, ",%d,%d", variant->limits.maxDepth, variant->limits.targetElementsPerNode);
    } else {
        fprintf(file, ",,");
    }
    fprintf(file, ",%.4f,%.4f,%.4f,%.4f\n", ms.median, ms.min, ms.max, fps(variant));
}

// The order of the rows: a kd-tree of other limits belongs to no curve.
enum RowGroup { NAIVE_ROWS, USUAL_KDTREE_ROWS, OTHER_ROWS, N_ROW_GROUPS };

static enum RowGroup row_group(const Variant *variant)
{
    if (variant->kind == NAIVE) {
        return NAIVE_ROWS;
    }
    return variant->kind == KDTREE && has_usual_limits(variant) ? USUAL_KDTREE_ROWS : OTHER_ROWS;
}

int report_write_csv(const Variant *variants, int n_variants, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench2d.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "variant,n_circles,max_depth,leaf_size,median_ms,min_ms,max_ms,fps\n");
    for (int group = 0; group < N_ROW_GROUPS; group++) {
        for (int i = 0; i < n_variants; i++) {
            if ((int)row_group(&variants[i]) == group) {
                write_row(output.file, &variants[i]);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("\nAll figures: %s\n", path);
    return 0;
}

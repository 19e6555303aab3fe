// Tables of trees (see report_trees.h).
#include "report_trees.h"

#include <stdio.h>
#include <string.h>

// How many times Embree's time on all threads a tree shall take at most; 0 where nothing is set.
typedef struct Target {
    const char *scene_name;
    double build;            // of lab 06 on one thread
    double parallel_middle;  // of lab 06 on as many threads as Embree
    double parallel_cost;    // the same of lab 08
} Target;
static const Target TARGETS[] = {{"random:n=100000", 3, 0, 0}, {"random:n=1000000", 0, 1.5, 3}};
enum { N_TARGETS = sizeof TARGETS / sizeof *TARGETS };

static const Target *target_of(const Case3D *bench_case)
{
    static const Target none = {0};
    for (int i = 0; i < N_TARGETS; i++) {
        if (strcmp(TARGETS[i].scene_name, bench_case->scene_name) == 0) {
            return &TARGETS[i];
        }
    }
    return &none;
}

static void print_trees(const Case3D *cases, int n_cases, ReportContext context)
{
    const int has_embree = context.n_threads > 0;
    printf(
        "\nTrees of lab 06, and milliseconds to build them, those of lab 08, and those of lab 10's "
        "tiles, on one\nthread");
    if (has_embree) {
        printf("; parallel: Embree's on %d threads; ratios: of lab 06 to Embree",
               context.n_threads);
    }
    printf("\n");
    printf("  %-16s  %8s  %8s  %8s  %5s  %8s  %8s  %8s  %8s", "scene", "nodes", "leaves", "ids",
           "depth", "ids/leaf", "tiles", "lab 08", "lab 06");
    if (has_embree) {
        printf("  %8s  %5s  %8s  %5s", "Embree", "ratio", "parallel", "ratio");
    }
    printf("\n");
    for (int i = 0; i < n_cases; i++) {
        const Case3D *bench_case = &cases[i];
        printf("  %-16s  %8u  %8u  %8u  %5d  %8.2f  %8.2f  %8.2f  %8.2f", bench_case->scene_name,
               bench_case->n_nodes, bench_case->figures.n_leaves, bench_case->n_sphere_ids,
               bench_case->figures.depth,
               (double)bench_case->n_sphere_ids / bench_case->figures.n_leaves,
               series_median(&bench_case->builds[TILES]),
               series_median(&bench_case->builds[BY_COST]),
               series_median(&bench_case->builds[KDTREE]));
        if (has_embree) {
            const Series *embree = &bench_case->builds[EMBREE];
            const Series *parallel = &bench_case->parallel_builds[EMBREE];
            const Target *target = target_of(bench_case);
            printf("  %8.2f  %5.2f  %8.2f  %5.2f", series_median(embree),
                   series_ratio(&bench_case->builds[KDTREE], embree).median,
                   series_median(parallel),
                   series_ratio(&bench_case->builds[KDTREE], parallel).median);
            if (target->build > 0) {
                printf("  target: at most %g times the parallel one", target->build);
            }
        }
        printf("\n");
    }
}

static void print_parallel_tree(const char *name, int n_threads, const Series *builds,
                                const Series *embree, double target)
{
    printf("    %s on %d threads  %8.2f", name, n_threads, series_median(builds));
    report3d_print_ratio(builds, embree);
    if (target > 0) {
        printf("  target: at most %g", target);
    }
    printf("\n");
}

// Trees on all threads against Embree's.
static void print_parallel_trees(const Case3D *cases, int n_cases, ReportContext context)
{
    printf("\nTrees built on %d threads: milliseconds, and times Embree's on as many\n",
           context.n_threads);
    for (int i = 0; i < n_cases; i++) {
        if (report3d_compares(&cases[i])) {
            const Target *target = target_of(&cases[i]);
            const Series *builds = cases[i].parallel_builds;
            printf("  %s: Embree's %.2f\n", cases[i].scene_name, series_median(&builds[EMBREE]));
            print_parallel_tree("lab 06", context.n_threads, &builds[KDTREE], &builds[EMBREE],
                                target->parallel_middle);
            print_parallel_tree("lab 08", context.n_threads, &builds[BY_COST], &builds[EMBREE],
                                target->parallel_cost);
        }
    }
}

void report_trees_print(const Case3D *cases, int n_cases, ReportContext context)
{
    print_trees(cases, n_cases, context);
    if (context.n_threads > 0) {
        print_parallel_trees(cases, n_cases, context);
    }
}

// What the 3D bench tells of shadow and mirrored rays (see report_secondary.h).
//
// Read next: secondary_rays.c.
#include "report_secondary.h"

#include "output_file.h"
#include "path.h"

#include <stdio.h>

const char *const RAY_KIND_NAMES[N_RAY_KINDS] = {
    [SHADOW_RAYS] = "shadow",
    [MIRRORED_RAYS] = "mirrored",
};

const char *const SEARCHER_TITLES[N_RAY_KINDS][N_SEARCHERS] = {
    [SHADOW_RAYS] = {"kd-tree (lab 09)", "tiles (lab 10)", "rtcOccluded1", "rtcOccluded4",
                     "rtcOccluded8", "rtcOccluded16", "rtcOccluded1M"},
    [MIRRORED_RAYS] = {"kd-tree (lab 09)", NULL, "rtcIntersect1", "rtcIntersect4", "rtcIntersect8",
                       "rtcIntersect16", "rtcIntersect1M"},
};

// In the CSV file.
static const char *const SEARCHER_NAMES[N_SEARCHERS] = {"kdtree",  "tiles",    "embree1", "embree4",
                                                        "embree8", "embree16", "embree1M"};

static double mray_s(const RayList *list, Searcher searcher)
{
    return list->n_rays / 1e3 / series_median(&list->times[searcher]);
}

// The call of Embree with the smallest median, where it took part.
static Searcher best_of_embree(const RayList *list)
{
    return EMBREE_SEARCHES + series_quickest(&list->times[EMBREE_SEARCHES], N_EMBREE_CALLS);
}

// ---- For people -----------------------------------------------------------------------------

// All that searched the rays of one kind.
static void print_searchers(const RayList *list, RayKind kind, ReportContext context)
{
    printf("  %d %s rays\n", list->n_rays, RAY_KIND_NAMES[kind]);
    for (int i = 0; i < N_SEARCHERS; i++) {
        const Series *times = &list->times[i];
        if (times->n == 0) {
            continue;
        }
        const Spread ms = spread_of(times->ms, times->n);
        printf("  %-16s  %10.2f  (%.2f to %.2f, %d times)  %.4g Mray/s", SEARCHER_TITLES[kind][i],
               ms.median, ms.min, ms.max, times->n, mray_s(list, i));
        if (i >= EMBREE_SEARCHES) {
            printf(", %d CPU threads%s", context.n_threads,
                   i == (int)best_of_embree(list) ? ": Embree's best" : "");
        }
        if (i != LAB_09) {
            printf("; %d other answers", list->n_different[i]);
        }
        printf("\n");
    }
    if (list->times[LAB_10].n > 0) {
        const Spread ratio = series_ratio(&list->times[LAB_09], &list->times[LAB_10]);
        printf("  kd-tree / tiles: %.2f  (single rounds: %.2f to %.2f)\n", ratio.median, ratio.min,
               ratio.max);
    }
}

// Labs 09 and 10 against Embree's best.
static void print_rates(const SecondaryRays *secondary)
{
    printf("\nMillion such rays a second: labs 09 and 10, and the best of Embree's calls\n");
    printf("  %-8s  %-16s  %8s  %8s  %6s\n", "rays", "searcher", "labs", "Embree", "ratio");
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        const RayList *list = &secondary->lists[kind];
        const Searcher best = best_of_embree(list);
        for (int i = LAB_09; i <= LAB_10; i++) {
            if (list->times[i].n > 0) {
                printf("  %-8s  %-16s  %8.2f  %8.2f", RAY_KIND_NAMES[kind],
                       SEARCHER_TITLES[kind][i], mray_s(list, i), mray_s(list, best));
                report3d_print_ratio(&list->times[best], &list->times[i]);
                printf("  %s\n", SEARCHER_TITLES[kind][best]);
            }
        }
    }
}

void report_secondary_print(const SecondaryRays *secondary, const char *scene_name,
                            ReportContext context)
{
    printf("\nShadow rays and first mirrored rays of the %s, %dx%d pixels, the search alone;\n"
           "milliseconds, median (smallest to largest)\n",
           scene_name, CASE3D_SIDE, CASE3D_SIDE);
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        print_searchers(&secondary->lists[kind], kind, context);
    }
    if (context.n_threads > 0 && context.device_is_cpu) {
        print_rates(secondary);
    }
}

// ---- For programs ---------------------------------------------------------------------------

static void write_row(FILE *file, const RayList *list, RayKind kind, const char *scene_name,
                      Searcher searcher)
{
    const Series *times = &list->times[searcher];
    const Spread ms = spread_of(times->ms, times->n);
    fprintf(file, "%s,%s,%s,%d,%.4f,%.4f,%.4f,%.6g,", RAY_KIND_NAMES[kind], scene_name,
            SEARCHER_NAMES[searcher], list->n_rays, ms.median, ms.min, ms.max,
            mray_s(list, searcher));
    if (searcher == LAB_09) {
        fprintf(file, ",\n");
    } else {
        fprintf(file, "%d,%d\n", list->n_different[searcher], searcher == best_of_embree(list));
    }
}

int report_secondary_write_csv(const SecondaryRays *secondary, const char *scene_name,
                               const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench3d-secondary.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "rays,scene,searcher,n_rays,median_ms,min_ms,max_ms,mray_s,"
                         "different_answers,is_best\n");
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        const RayList *list = &secondary->lists[kind];
        for (int i = 0; i < N_SEARCHERS; i++) {
            if (list->times[i].n > 0) {
                write_row(output.file, list, kind, scene_name, i);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("Those of shadow and mirrored rays: %s\n", path);
    return 0;
}

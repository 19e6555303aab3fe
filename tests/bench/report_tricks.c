// What the bench of tricks tells (see report_tricks.h).
//
// Read next: trick.c, where tricks and their titles are.
#include "report_tricks.h"

#include "output_file.h"
#include "path.h"

#include <stdio.h>

static const char *const PART_NAMES[N_PARTS] = {"circles", "spheres"};

static void print_row(const TrickCase *cases, Part part, int trick)
{
    printf("  %-52s", PART_TRICKS[part].tricks[trick].title);
    for (int i = 0; i < N_TRICK_SCENES; i++) {
        const Series *frames = cases[i].frames;
        char spread[32];
        if (trick == 0) {
            const Spread ms = spread_of(frames[0].ms, frames[0].n);
            snprintf(spread, sizeof spread, "(%.2f to %.2f)", ms.min, ms.max);
            printf("  %6.2f %-17s", ms.median, spread);
        } else {
            const Spread ratio = series_ratio(&frames[trick], &frames[0]);
            snprintf(spread, sizeof spread, "(%.2f to %.2f)", ratio.min, ratio.max);
            printf("  %6.2f %-17s", ratio.median, spread);
        }
    }
    printf("\n");
}

void report_tricks_print(const TrickCase *cases, Part part)
{
    printf("\nLab 10's %s: milliseconds a frame with all tricks (smallest to largest), and how "
           "many times as long it\ntakes without one (single rounds)\n  %-52s",
           PART_NAMES[part], "");
    for (int i = 0; i < N_TRICK_SCENES; i++) {
        printf("  %-24s", cases[i].scene_name);
    }
    printf("\n");
    for (int trick = 0; trick < PART_TRICKS[part].n_tricks; trick++) {
        print_row(cases, part, trick);
    }
}

static void write_row(FILE *file, const TrickCase *trick_case, int trick)
{
    const Series *frames = &trick_case->frames[trick];
    const Spread ms = spread_of(frames->ms, frames->n);
    const Spread ratio = series_ratio(frames, &trick_case->frames[0]);
    fprintf(file, "%s,%s,\"%s\",%.4f,%.4f,%.4f,%.6g,%.6g,%.6g\n", PART_NAMES[trick_case->part],
            PART_TRICKS[trick_case->part].tricks[trick].name, trick_case->scene_name, ms.median,
            ms.min, ms.max, ratio.median, ratio.min, ratio.max);
}

int report_tricks_write_csv(TrickCase cases[N_PARTS][N_TRICK_SCENES], const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench_tricks.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "part,without,scene,median_ms,min_ms,max_ms,ratio,min_ratio,max_ratio\n");
    for (int part = 0; part < N_PARTS; part++) {
        for (int trick = 0; trick < PART_TRICKS[part].n_tricks; trick++) {
            for (int i = 0; i < N_TRICK_SCENES; i++) {
                write_row(output.file, &cases[part][i], trick);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("\nThe figures: %s\nThe kernels without a trick: %s/tricks\n", path, folder);
    return 0;
}

// What the 3D bench tells of frames with shadows and mirrors (see report_lit.h).
//
// Read next: lit_frames.c.
#include "report_lit.h"

#include "output_file.h"
#include "path.h"
#include "report3d.h"

#include <stdio.h>

const char *const LIT_TITLES[N_LIT_RENDERERS] = {
    [LIT_RAYS] = "kd-tree (lab 09)",
    [LIT_TILES] = "tiles (lab 10)",
};

// In the CSV file.
static const char *const LIT_NAMES[N_LIT_RENDERERS] = {"kdtree", "tiles"};

static double frames_s(const LitFrame *frame, LitRenderer renderer)
{
    return 1e3 / series_median(&frame->times[renderer]);
}

// ---- For people -----------------------------------------------------------------------------

static void print_frame(const LitFrame *frame)
{
    printf("  %dx%d pixels, mirrors: %d\n", frame->side, frame->side, frame->n_mirrors);
    for (int i = 0; i < N_LIT_RENDERERS; i++) {
        const Series *times = &frame->times[i];
        const Spread ms = spread_of(times->ms, times->n);
        printf("  %-16s  %10.2f  (%.2f to %.2f, %d frames)", LIT_TITLES[i], ms.median, ms.min,
               ms.max, times->n);
        if (i == LIT_TILES) {
            printf("; %d of %d pixels differ", frame->n_different, frame->side * frame->side);
        }
        printf("\n");
    }
}

static void print_rates(const LitFrame *frames)
{
    printf("\nSuch frames a second: tiles (lab 10) and kd-tree (lab 09)\n");
    printf("  %-9s  %7s  %8s  %8s  %6s\n", "pixels", "mirrors", "tiles", "kd-tree", "ratio");
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        const LitFrame *frame = &frames[i];
        printf("  %4dx%-4d  %7d  %8.2f  %8.2f", frame->side, frame->side, frame->n_mirrors,
               frames_s(frame, LIT_TILES), frames_s(frame, LIT_RAYS));
        report3d_print_ratio(&frame->times[LIT_RAYS], &frame->times[LIT_TILES]);
        printf("\n");
    }
}

void report_lit_print(const LitFrame frames[N_LIT_FRAMES], const char *scene_name)
{
    printf("\nWhole frames of the %s with shadows, and with rays that are mirrored so often at "
           "most;\nmilliseconds, median (smallest to largest); pixels that differ by more than one "
           "step of 255\n",
           scene_name);
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        print_frame(&frames[i]);
    }
    print_rates(frames);
}

// ---- For programs ---------------------------------------------------------------------------

static void write_row(FILE *file, const LitFrame *frame, const char *scene_name,
                      LitRenderer renderer)
{
    const Series *times = &frame->times[renderer];
    const Spread ms = spread_of(times->ms, times->n);
    fprintf(file, "%s,%s,%d,%d,%.4f,%.4f,%.4f,%.6g,", LIT_NAMES[renderer], scene_name, frame->side,
            frame->n_mirrors, ms.median, ms.min, ms.max, frames_s(frame, renderer));
    if (renderer == LIT_RAYS) {
        fprintf(file, ",,,\n");
        return;
    }
    const Spread ratio = series_ratio(&frame->times[LIT_RAYS], times);
    fprintf(file, "%.6g,%.6g,%.6g,%d\n", ratio.median, ratio.min, ratio.max, frame->n_different);
}

int report_lit_write_csv(const LitFrame frames[N_LIT_FRAMES], const char *scene_name,
                         const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench3d-lit.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "renderer,scene,side,mirrors,median_ms,min_ms,max_ms,fps,ratio,min_ratio,"
                         "max_ratio,different_pixels\n");
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        for (int renderer = 0; renderer < N_LIT_RENDERERS; renderer++) {
            write_row(output.file, &frames[i], scene_name, renderer);
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("Those of frames with shadows: %s\n", path);
    return 0;
}

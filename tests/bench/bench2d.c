// The 2D bench: the naive kernel of lab 01 against the kd-tree kernel of lab 03, the tile kernel of
// lab 10 and two programs without OpenCL, in one run.
//
//     build/tools/bench2d [--device D] [--rounds N] [--output FOLDER]       or: make bench
//
// Cases are drawn in turn within each round, so that what else the machine does falls on all of
// them: trust the ratios more than the milliseconds. In the first round every other picture is
// compared with the naive one of the same scene, bit by bit, those of the tile kernel and the
// painter with their colours as bytes; where one differs there is no file. Cairo's may differ
// at borders.
// Read next: case2d.h, tables.sql.
#include "bench.h"
#include "case2d.h"
#include "cl_memory.h"
#include "image.h"
#include "launch.h"
#include "peers2d.h"
#include "same_pictures.h"

#include <stdio.h>

#define SIDE 1024  // the picture's, pixels
#define SEED 1

// ---- What is measured -----------------------------------------------------------------------

// The more circles the smaller, so that they cover the same area together and a pixel lies in as
// many of them: radii shrink with the root of the number. The lecture's scene is among them, and is
// always drawn whole.
static const struct SceneRow {
    int n_circles;
    float min_radius, max_radius;
    int n_cpu_rows;  // what the naive kernel draws on a CPU, where whole frames would take minutes
    int has_tiles;   // drawn by the tile kernel and the peers, too
} SCENES[] = {
    {64, 22.625f, 226.25f, SIDE, 0},
    {512, 8, 80, SIDE, 0},
    {4096, 2.8125f, 28.3125f, SIDE / 4, 0},
    {SCENE2D_DEFAULT_CIRCLES, 2, 20, SIDE, 1},
    {32768, 1, 10, SIDE / 32, 0},
    // The same number of circles, small and large.
    {SCENE2D_DEFAULT_CIRCLES, 1, 4, SIDE / 16, 1},
    {SCENE2D_DEFAULT_CIRCLES, 10, 60, SIDE / 16, 1},
};
enum { N_SCENES = sizeof SCENES / sizeof *SCENES, MAX_CASES = N_CASE2D_KINDS * N_SCENES };

typedef struct Bench {
    ClSetup cl;
    cl_program programs[N_CASE2D_KINDS];
    cl_mem d_image;
    Image picture, naive_picture;  // read back for the comparison
    int n_naive_rows;              // of naive_picture that are drawn
    Scene2D scenes[N_SCENES];
    Case2D cases[MAX_CASES];
    int n_cases;
} Bench;

// Frames a round.
static const int N_FRAMES[N_CASE2D_KINDS] = {
    [NAIVE] = 1, [KDTREE] = 10, [TILES] = 20, [PAINTER] = 20, [CAIRO] = 3};

// The list of cases. A scene's naive one comes right before those that are compared with it.
static void list_cases(Bench *bench)
{
    for (int i = 0; i < N_SCENES; i++) {
        const struct SceneRow *row = &SCENES[i];
        for (int kind = 0; kind < (row->has_tiles ? N_CASE2D_KINDS : TILES); kind++) {
            if (kind == CAIRO && cairo_peer_version() == NULL) {
                continue;
            }
            Case2D *bench_case = &bench->cases[bench->n_cases++];
            bench_case->kind = kind;
            bench_case->scene = &bench->scenes[i];
            bench_case->n_rows =
                kind == NAIVE && device_is_cpu(&bench->cl) ? row->n_cpu_rows : SIDE;
            snprintf(bench_case->scene_name, sizeof bench_case->scene_name,
                     "%d circles, radius %g to %g", row->n_circles, (double)row->min_radius,
                     (double)row->max_radius);
        }
    }
}

static int bench_prepare(void *shared, const BenchOptions *options)
{
    Bench *bench = shared;
    if (cl_setup_open(options->device, &bench->cl) != 0 ||
        programs2d_build(&bench->cl, bench->programs) != 0) {
        return -1;
    }
    if (cl_image_create(&bench->cl, SIDE, SIDE, &bench->d_image) != 0 ||
        image_create(SIDE, SIDE, &bench->picture) != 0 ||
        image_create(SIDE, SIDE, &bench->naive_picture) != 0) {
        return -1;
    }
    for (int i = 0; i < N_SCENES; i++) {
        if (scene2d_random(SCENES[i].n_circles, SEED, SCENES[i].min_radius, SCENES[i].max_radius,
                           SIDE, SIDE, &bench->scenes[i]) != 0) {
            return -1;
        }
    }
    list_cases(bench);
    for (int i = 0; i < bench->n_cases; i++) {
        if (case2d_prepare(&bench->cases[i], &bench->cl, bench->programs, bench->d_image) != 0) {
            return -1;
        }
    }
    printf("%s: %dx%d pixels\n", bench->cl.device_name, SIDE, SIDE);
    return 0;
}

static void bench_free(void *shared)
{
    Bench *bench = shared;
    for (int i = 0; i < bench->n_cases; i++) {
        case2d_free(&bench->cases[i]);
    }
    for (int i = 0; i < N_SCENES; i++) {
        scene2d_free(&bench->scenes[i]);
    }
    image_free(&bench->picture);
    image_free(&bench->naive_picture);
    if (bench->d_image != NULL) {
        CL_CHECK(clReleaseMemObject(bench->d_image));
    }
    programs_free(bench->programs, N_CASE2D_KINDS);
    cl_setup_close(&bench->cl);
}

// ---- Equal pixels ---------------------------------------------------------------------------

// Compare what a case has just drawn with the naive picture of its scene, or with as much of it as
// was drawn; a naive case's picture becomes that. Pictures of bytes are compared with the naive one
// rounded to bytes: their cases are the last ones of a scene. Returns 0, or -1 after one message.
static int check_picture(Bench *bench, const Case2D *bench_case)
{
    if (bench_case->kind == NAIVE) {
        read_image(&bench->cl, bench->d_image, &bench->naive_picture);
        bench->n_naive_rows = bench_case->n_rows;
        return 0;
    }
    if (bench_case->kind == KDTREE) {
        read_image(&bench->cl, bench->d_image, &bench->picture);
    } else {
        case2d_read_bytes(bench_case, &bench->cl, &bench->picture);
        round_to_bytes(&bench->naive_picture);
    }
    Image drawn = bench->picture, naive = bench->naive_picture;
    drawn.height = naive.height = bench->n_naive_rows;
    const double share = bench_case->kind == CAIRO ? SIMILAR_SHARE : 0;
    char names[128];
    snprintf(names, sizeof names, "bench2d: %s, %s beside naive", bench_case->scene_name,
             CASE2D_NAMES[bench_case->kind]);
    return pictures_compare(&drawn, &naive, 0, (int)(share * SIDE * drawn.height), names) >= 0 ? 0
                                                                                               : -1;
}

// ---- Rounds ---------------------------------------------------------------------------------

// One case's part of a round. Returns 0, or -1 after one message.
static int measure(Bench *bench, const Case2D *bench_case, Measurements *measurements)
{
    const char *what = CASE2D_NAMES[bench_case->kind];
    const int is_first = measurements->round == 0;
    if (is_first) {
        spoil_image(&bench->cl, bench->d_image, SIDE, SIDE);
        measurements_add(measurements, bench_case->scene_name, what, "elements",
                         bench_case->scene->n_circles);
    }
    for (int i = 0; i < N_FRAMES[bench_case->kind]; i++) {
        measurements_add(measurements, bench_case->scene_name, what, "frame",
                         case2d_draw(bench_case, &bench->cl));
        if (is_first && i == 0 && check_picture(bench, bench_case) != 0) {
            return -1;
        }
    }
    return 0;
}

static int measure_round(void *shared, Measurements *measurements)
{
    Bench *bench = shared;
    for (int i = 0; i < bench->n_cases; i++) {
        if (measure(bench, &bench->cases[i], measurements) != 0) {
            return -1;
        }
    }
    return 0;
}

static const BenchKind BENCH = {
    .name = "bench2d",
    .what =
        "measures the naive kernel of lab 01, the kd-tree kernel of lab 03 and the tiles of lab 10",
    .longest_seconds = 140,
    .first_is_done = "; all pictures are equal, but for cairo's borders",
    .prepare = bench_prepare,
    .measure_round = measure_round,
    .free = bench_free,
};

int main(int argc, char **argv)
{
    static Bench bench;  // large, for the stack
    return bench_run(&BENCH, argc, argv, &bench);
}

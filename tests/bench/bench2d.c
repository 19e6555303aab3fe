// The 2D bench: the naive kernel of lab 01 against the kd-tree kernel of lab 03, the tile kernel of
// lab 10 and two programs without OpenCL, in one run.
//
//     build/tools/bench2d [--device D] [--rounds N] [--output FOLDER]       or: make bench
//
// Cases are drawn in turn within each round, so that what else the machine does falls on all of
// them: trust the ratios more than the milliseconds. In the first round every other picture is
// compared with the naive one of the same scene, bit by bit, those of the tile kernel and the
// painter with their colours as bytes; where one differs there are no figures. Cairo's may differ
// at borders.
// Read next: case2d.h, report.c.
#include "bench_options.h"
#include "case2d.h"
#include "cl_memory.h"
#include "equal_pixels.h"
#include "image.h"
#include "launch.h"
#include "options.h"
#include "peers2d.h"
#include "report.h"
#include "rounds.h"

#include <stdio.h>
#include <stdlib.h>

#define SIDE 1024  // the picture's, pixels
#define SEED 1

// No further round begins that would end later: the naive kernel may take long on other machines.
#define LONGEST_SECONDS 140

// ---- What is measured -----------------------------------------------------------------------

// Scenes of the growth table. The more circles the smaller, so that they cover the same area
// together and a pixel lies in as many of them: radii shrink with the root of the number. The
// lecture's scene is among them, and is always drawn whole.
static const struct SceneRow {
    int n_circles;
    float min_radius, max_radius;
    int n_cpu_rows;  // what the naive kernel draws on a CPU, where whole frames would take minutes
    const char *radii;  // where the tile kernel draws it, too; without one for the growth alone
} SCENES[] = {
    {64, 22.625f, 226.25f, SIDE, NULL},
    {512, 8, 80, SIDE, NULL},
    {4096, 2.8125f, 28.3125f, SIDE / 4, NULL},
    {SCENE2D_DEFAULT_CIRCLES, 2, 20, SIDE, "2 to 20"},
    {32768, 1, 10, SIDE / 32, NULL},
    // Not of the growth table: the same number of circles, small and large.
    {SCENE2D_DEFAULT_CIRCLES, 1, 4, SIDE / 16, "1 to 4"},
    {SCENE2D_DEFAULT_CIRCLES, 10, 60, SIDE / 16, "10 to 60"},
};
enum { N_SCENES = sizeof SCENES / sizeof *SCENES, LECTURES_SCENE = 3 };

// How deep is best? For the lecture's scene, besides the usual limits.
static const KdTreeLimits LIMITS[] = {{8, 8},   {10, 8},  {12, 8}, {14, 8}, {18, 8},
                                      {16, 32}, {16, 16}, {16, 4}, {20, 4}};
enum { N_LIMITS = sizeof LIMITS / sizeof *LIMITS };

enum { MAX_CASES = 1 + 5 * N_SCENES + N_LIMITS };

static const KdTreeLimits USUAL_LIMITS = {OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};

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

static void add_case(Bench *bench, Case2D bench_case)
{
    bench->cases[bench->n_cases++] = bench_case;
}

// The list of cases. A scene's naive one comes right before those that are compared with it.
static void list_cases(Bench *bench)
{
    for (int i = 0; i < N_SCENES; i++) {
        const Scene2D *scene = &bench->scenes[i];
        Case2D naive = {.kind = NAIVE, .scene = scene, .radii = SCENES[i].radii, .n_frames = 1};
        naive.n_rows = device_is_cpu(&bench->cl) ? SCENES[i].n_cpu_rows : SIDE;
        add_case(bench, naive);
        Case2D kdtree = naive;
        kdtree.kind = KDTREE;
        kdtree.n_frames = 10;
        kdtree.n_rows = SIDE;
        kdtree.limits = USUAL_LIMITS;
        add_case(bench, kdtree);
        for (int j = 0; j < N_LIMITS && i == LECTURES_SCENE; j++) {
            kdtree.n_frames = 5;
            kdtree.limits = LIMITS[j];
            add_case(bench, kdtree);
        }
        if (SCENES[i].radii != NULL) {
            Case2D tiles = kdtree;
            tiles.kind = TILES;
            tiles.n_frames = 20;
            add_case(bench, tiles);
            Case2D peer = tiles;
            peer.kind = PAINTER;
            add_case(bench, peer);
            peer.kind = CAIRO;
            peer.n_frames = 3;
            if (cairo_peer_version() != NULL) {
                add_case(bench, peer);
            }
        }
    }
    Case2D fill = {.kind = FILL, .scene = &bench->scenes[0], .n_frames = 10, .n_rows = SIDE};
    add_case(bench, fill);
}

// Everything up to the first frame. Returns 0, or -1 after one message.
static int bench_prepare(Bench *bench, const char *device)
{
    if (cl_setup_open(device, &bench->cl) != 0 ||
        programs_build(&bench->cl, bench->programs) != 0) {
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
    return 0;
}

static void bench_free(Bench *bench)
{
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
    programs_free(bench->programs);
    cl_setup_close(&bench->cl);
}

// ---- Equal pixels ---------------------------------------------------------------------------

// Compare a picture of bytes with the naive one, rounded: those cases are the last ones of a scene.
// Returns 0, or -1 after one message.
static int check_bytes(Bench *bench, const Case2D *bench_case)
{
    char name[32];
    snprintf(name, sizeof name, "bench2d: %s", CASE2D_NAMES[bench_case->kind]);
    round_to_bytes(&bench->naive_picture);
    case2d_read_bytes(bench_case, &bench->cl, &bench->picture);
    return (bench_case->kind == CAIRO ? similar_pixels : equal_pixels)(
        &bench->picture, &bench->naive_picture, bench->n_naive_rows, name);
}

// Compare what a kd-tree case has just drawn with the naive picture of its scene; a naive
// case's picture becomes that. Returns 0, or -1 after one message.
static int check_picture(Bench *bench, const Case2D *bench_case)
{
    if (bench_case->kind == FILL) {
        return 0;
    }
    Image *picture = bench_case->kind == NAIVE ? &bench->naive_picture : &bench->picture;
    if (bench_case->kind >= TILES) {
        return check_bytes(bench, bench_case);
    }
    read_image(&bench->cl, bench->d_image, picture);
    if (bench_case->kind == NAIVE) {
        bench->n_naive_rows = bench_case->n_rows;
        return 0;
    }
    char name[128];
    snprintf(name, sizeof name, "bench2d: kd-tree, %d circles, --max-depth %d --leaf-size %d",
             bench_case->scene->n_circles, bench_case->limits.maxDepth,
             bench_case->limits.targetElementsPerNode);
    return equal_pixels(picture, &bench->naive_picture, bench->n_naive_rows, name);
}

// ---- Rounds ---------------------------------------------------------------------------------

// One case's part of a round. Returns 0, or -1 after one message.
static int measure(Bench *bench, Case2D *bench_case, int round)
{
    if (round == 0) {
        spoil_image(&bench->cl, bench->d_image, SIDE, SIDE);
    }
    for (int i = 0; i < bench_case->n_frames; i++) {
        series_add(&bench_case->frames, case2d_draw(bench_case, &bench->cl));
        if (round == 0 && i == 0 && check_picture(bench, bench_case) != 0) {
            return -1;
        }
    }
    series_end_round(&bench_case->frames);
    for (int i = 0; i < bench_case->n_frames && bench_case->kind == TILES; i++) {
        series_add(&bench_case->mapped, case2d_draw_mapped(bench_case, &bench->cl));
    }
    series_end_round(&bench_case->mapped);
    if (bench_case->kind == KDTREE) {
        const double ms = case2d_time_build(bench_case);
        if (ms < 0) {
            return -1;
        }
        series_add(&bench_case->builds, ms);
        series_end_round(&bench_case->builds);
    }
    return 0;
}

static int measure_round(void *shared, int round)
{
    Bench *bench = shared;
    for (int i = 0; i < bench->n_cases; i++) {
        if (measure(bench, &bench->cases[i], round) != 0) {
            return -1;
        }
    }
    return 0;
}

int main(int argc, char **argv)
{
    const BenchOptions options =
        bench_options_read(argc, argv, "bench2d",
                           "measures the naive kernel of lab 01, the kd-tree kernel of lab 03 and "
                           "the tiles of lab 10");
    static Bench bench;  // large, for the stack
    int result = bench_prepare(&bench, options.device);
    if (result == 0) {
        printf("%s: %dx%d pixels\n", bench.cl.device_name, SIDE, SIDE);
        result = rounds_run(measure_round, &bench, options.n_rounds, LONGEST_SECONDS,
                            "; all pictures are equal, but for cairo's borders");
    }
    if (result == 0) {
        report_print(bench.cases, bench.n_cases, bench.cl.device_name);
        result = report_write_csv(bench.cases, bench.n_cases, options.folder);
    }
    bench_free(&bench);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// The 2D bench: the naive kernel of lab 01 against the kd-tree kernel of lab 03, in one run.
//
//     build/tools/bench2d [--device D] [--rounds N] [--output FOLDER]       or: make bench
//
// Variants are drawn in turn within each round, so that what else the machine does falls on all of
// them: trust the ratios more than the milliseconds. In the first round every kd-tree picture is
// compared with the naive one of the same scene, bit by bit; where one differs there are no
// figures.
// Flow: scene -> buffers -> kernel -> image -> COMPARISON. Read next: variant.h, report.c.
#include "cl_memory.h"
#include "equal_pixels.h"
#include "image.h"
#include "number.h"
#include "options.h"
#include "report.h"
#include "stats.h"
#include "variant.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
} SCENES[] = {
    {64, 22.625f, 226.25f, SIDE},        {512, 8, 80, SIDE},
    {4096, 2.8125f, 28.3125f, SIDE / 4}, {SCENE2D_DEFAULT_CIRCLES, 2, 20, SIDE},
    {32768, 1, 10, SIDE / 32},
};
enum { N_SCENES = sizeof SCENES / sizeof *SCENES };

// How deep is best? For the lecture's scene, besides the usual limits.
static const KdTreeLimits LIMITS[] = {{8, 8},   {10, 8},  {12, 8}, {14, 8}, {18, 8},
                                      {16, 32}, {16, 16}, {16, 4}, {20, 4}};
enum { N_LIMITS = sizeof LIMITS / sizeof *LIMITS };

enum { MAX_VARIANTS = 1 + 2 * N_SCENES + N_LIMITS };

static const KdTreeLimits USUAL_LIMITS = {OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};

typedef struct Bench {
    ClSetup cl;
    cl_program programs[N_VARIANT_KINDS];
    cl_mem d_image;
    Image picture, naive_picture;  // read back for the comparison
    int n_naive_rows;              // of naive_picture that are drawn
    Scene2D scenes[N_SCENES];
    Variant variants[MAX_VARIANTS];
    int n_variants;
} Bench;

static void add_variant(Bench *bench, Variant variant)
{
    bench->variants[bench->n_variants++] = variant;
}

// A GPU is fast enough for whole frames, and needs them to be busy.
static int device_is_cpu(const ClSetup *cl)
{
    cl_device_type type;
    CL_CHECK(clGetDeviceInfo(cl->device, CL_DEVICE_TYPE, sizeof type, &type, NULL));
    return (type & CL_DEVICE_TYPE_CPU) != 0;
}

// The list of variants. A scene's naive one comes right before those that are compared with it.
static void list_variants(Bench *bench)
{
    for (int i = 0; i < N_SCENES; i++) {
        const Scene2D *scene = &bench->scenes[i];
        Variant naive = {.kind = NAIVE, .scene = scene, .n_frames = 1};
        naive.n_rows = device_is_cpu(&bench->cl) ? SCENES[i].n_cpu_rows : SIDE;
        add_variant(bench, naive);
        Variant kdtree = {.kind = KDTREE, .scene = scene, .n_frames = 10, .n_rows = SIDE};
        kdtree.limits = USUAL_LIMITS;
        add_variant(bench, kdtree);
        for (int j = 0; j < N_LIMITS && scene->n_circles == SCENE2D_DEFAULT_CIRCLES; j++) {
            kdtree.n_frames = 5;
            kdtree.limits = LIMITS[j];
            add_variant(bench, kdtree);
        }
    }
    Variant fill = {.kind = FILL, .scene = &bench->scenes[0], .n_frames = 10, .n_rows = SIDE};
    add_variant(bench, fill);
}

// Everything up to the first frame. Returns 0, or -1 after one message.
static int bench_prepare(Bench *bench, const char *device)
{
    if (cl_setup_open(device, &bench->cl) != 0 ||
        programs_build(&bench->cl, bench->programs) != 0) {
        return -1;
    }
    bench->d_image = cl_image_create(&bench->cl, SIDE, SIDE);
    if (bench->d_image == NULL || image_create(SIDE, SIDE, &bench->picture) != 0 ||
        image_create(SIDE, SIDE, &bench->naive_picture) != 0) {
        return -1;
    }
    for (int i = 0; i < N_SCENES; i++) {
        if (scene2d_random(SCENES[i].n_circles, SEED, SCENES[i].min_radius, SCENES[i].max_radius,
                           SIDE, SIDE, &bench->scenes[i]) != 0) {
            return -1;
        }
    }
    list_variants(bench);
    for (int i = 0; i < bench->n_variants; i++) {
        if (variant_prepare(&bench->variants[i], &bench->cl, bench->programs, bench->d_image) !=
            0) {
            return -1;
        }
    }
    return 0;
}

static void bench_free(Bench *bench)
{
    for (int i = 0; i < bench->n_variants; i++) {
        variant_free(&bench->variants[i]);
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

static const size_t ORIGIN[3] = {0, 0, 0};
static const size_t REGION[3] = {SIDE, SIDE, 1};

// Make every pixel what no kernel draws, so that one that draws nothing does not show the picture
// of the one before.
static void spoil_image(const Bench *bench)
{
    const float never_drawn[IMAGE_CHANNELS] = {-1, -1, -1, -1};
    CL_CHECK(clEnqueueFillImage(bench->cl.queue, bench->d_image, never_drawn, ORIGIN, REGION, 0,
                                NULL, NULL));
    CL_CHECK(clFinish(bench->cl.queue));
}

// Compare what a kd-tree variant has just drawn with the naive picture of its scene; a naive
// variant's picture becomes that. Returns 0, or -1 after one message.
static int check_picture(Bench *bench, const Variant *variant)
{
    if (variant->kind == FILL) {
        return 0;
    }
    Image *picture = variant->kind == NAIVE ? &bench->naive_picture : &bench->picture;
    CL_CHECK(clEnqueueReadImage(bench->cl.queue, bench->d_image, CL_TRUE, ORIGIN, REGION, 0, 0,
                                picture->pixels, 0, NULL, NULL));
    if (variant->kind == NAIVE) {
        bench->n_naive_rows = variant->n_rows;
        return 0;
    }
    char name[128];
    snprintf(name, sizeof name, "bench2d: kd-tree, %d circles, --max-depth %d --leaf-size %d",
             variant->scene->n_circles, variant->limits.maxDepth,
             variant->limits.targetElementsPerNode);
    return equal_pixels(picture, &bench->naive_picture, bench->n_naive_rows, name);
}

// ---- Rounds ---------------------------------------------------------------------------------

// One variant's part of a round. Returns 0, or -1 after one message.
static int measure(Bench *bench, Variant *variant, int round)
{
    if (round == 0) {
        spoil_image(bench);
    }
    for (int i = 0; i < variant->n_frames; i++) {
        series_add(&variant->frames, variant_draw(variant, &bench->cl));
        if (round == 0 && i == 0 && check_picture(bench, variant) != 0) {
            return -1;
        }
    }
    series_end_round(&variant->frames);
    if (variant->kind == KDTREE) {
        const double ms = variant_time_build(variant);
        if (ms < 0) {
            return -1;
        }
        series_add(&variant->builds, ms);
        series_end_round(&variant->builds);
    }
    return 0;
}

// Returns 0, or -1 after one message.
static int bench_run(Bench *bench, int n_rounds)
{
    const double start = stats_clock_ms();
    double seconds = 0;
    for (int round = 0; round < n_rounds; round++) {
        const double seconds_before = seconds;
        for (int i = 0; i < bench->n_variants; i++) {
            if (measure(bench, &bench->variants[i], round) != 0) {
                return -1;
            }
        }
        seconds = (stats_clock_ms() - start) / 1e3;
        printf("round %d of %d done after %.0f s%s\n", round + 1, n_rounds, seconds,
               round == 0 ? "; all pictures are equal, to the bit" : "");
        fflush(stdout);
        if (round + 1 < n_rounds && 2 * seconds - seconds_before > LONGEST_SECONDS) {
            printf("no further round: this machine would take too long\n");
            break;
        }
    }
    return 0;
}

// ---- Command line ---------------------------------------------------------------------------

typedef struct BenchOptions {
    const char *device;  // or NULL
    const char *folder;
    int n_rounds;
} BenchOptions;

static const char HELP[] =
    "bench2d: measures the naive kernel of lab 01 and the kd-tree kernel of lab 03.\n\n"
    "Options (and what holds without them):\n"
    "  --device D       number or part of a name ($" CL_DEVICE_VARIABLE ", or the first)\n"
    "  --rounds N       how often everything is measured, at most 100 (5)\n"
    "  --output FOLDER  where bench2d.csv goes; made where it is missing (build/bench)\n"
    "  --help           show this and end\n"
    "Run it in the top folder of the course, where the kernels are found.\n";

// Returns OPTIONS_RUN, OPTIONS_DONE, or OPTIONS_BAD after one message.
static OptionsResult read_options(int argc, char **argv, BenchOptions *options)
{
    static const struct option known[] = {{"device", required_argument, NULL, 'd'},
                                          {"rounds", required_argument, NULL, 'r'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"help", no_argument, NULL, 'h'},
                                          {NULL, 0, NULL, 0}};
    int64_t n_rounds = 5;
    *options = (BenchOptions){.folder = "build/bench"};
    for (int id; (id = getopt_long(argc, argv, "", known, NULL)) != -1;) {
        switch (id) {
        case 'd':
            options->device = optarg;
            break;
        case 'o':
            options->folder = optarg;
            break;
        case 'r':
            if (number_read_integer(optarg, 1, SERIES_MAX_ROUNDS, &n_rounds) != 0) {
                fprintf(stderr,
                        "bench2d: --rounds: found \"%s\", expected a whole number from 1 to %d\n",
                        optarg, SERIES_MAX_ROUNDS);
                return OPTIONS_BAD;
            }
            break;
        case 'h':
            fputs(HELP, stdout);
            return OPTIONS_DONE;
        default:
            return OPTIONS_BAD;
        }
    }
    if (optind < argc) {
        fprintf(stderr, "bench2d: found the stray word \"%s\" (try --help)\n", argv[optind]);
        return OPTIONS_BAD;
    }
    options->n_rounds = (int)n_rounds;
    return OPTIONS_RUN;
}

int main(int argc, char **argv)
{
    BenchOptions options;
    switch (read_options(argc, argv, &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }
    static Bench bench;  // large, for the stack
    // The folder is made first: a place that cannot be written is found out before the work.
    int result = report_make_folder(options.folder);
    if (result == 0) {
        result = bench_prepare(&bench, options.device);
    }
    if (result == 0) {
        printf("%s: %dx%d pixels\n", bench.cl.device_name, SIDE, SIDE);
        result = bench_run(&bench, options.n_rounds);
    }
    if (result == 0) {
        report_print(bench.variants, bench.n_variants, bench.cl.device_name);
        result = report_write_csv(bench.variants, bench.n_variants, options.folder);
    }
    bench_free(&bench);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

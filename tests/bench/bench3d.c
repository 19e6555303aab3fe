// The 3D bench: the naive kernel of lab 05, the kd-tree kernel of lab 07 with the trees of labs 06
// and 08, the tiles of lab 10 and Embree, in one run; standing scenes, and moving ones, whose trees
// are built anew for each frame; and of one scene lab 09's shadow rays and mirrored ones, and whole
// frames with them by labs 09 and 10.
//
//     build/tools/bench3d [--device D] [--rounds N] [--output FOLDER]       or: make bench
//
// All are drawn and all trees built in turn within each round (bench.h). In the first round the
// pictures of a scene are compared, and what the rays hit; where they differ there is no file.
// Embree takes part if its package is installed (embree_peer.h) and the OpenCL device is a CPU,
// with as many threads as that has compute units.
// Read next: case3d.h, pictures3d.h, secondary_rays.h, lit_frames.h, tables.sql.
#include "bench.h"
#include "embree_peer.h"
#include "launch.h"
#include "lit_frames.h"
#include "pictures3d.h"
#include "secondary_rays.h"
#include "stats.h"

#include <omp.h>
#include <stdio.h>

// The scenes. Random ones, from few spheres to many, show how times grow. Few stand close together:
// among them a tree begins to pay.
static const char *const SCENE_NAMES[] = {
    "sphereflake",    "random:n=1",      "random:n=5",       "random:n=10",
    "random:n=20",    "random:n=50",     "random:n=100",     "random:n=1000",
    "random:n=10000", "random:n=100000", "random:n=1000000",
};
enum { N_CASES = sizeof SCENE_NAMES / sizeof *SCENE_NAMES };

// The one whose shadow rays and mirrored rays are searched, and drawn: the sphereflake.
enum { SECONDARY_CASE = 0 };

enum { N_FRAMES = 5 };  // a round, of all but long ones
// A naive frame of more spheres than this is drawn once a round: each takes long enough.
enum { MANY_SPHERES = 100 };

typedef struct Bench {
    ClSetup cl;
    cl_program programs[N_PROGRAMS];
    Pictures3D pictures;
    int n_threads;  // of Embree, and of trees built beside its; 0 when it does not take part
    Case3D cases[N_CASES];
    SecondaryRays secondary;     // of SECONDARY_CASE
    LitFrame lit[N_LIT_FRAMES];  // of the same
} Bench;

// Build a first tree that is not timed: it starts Embree's threads. Returns 0, or -1 after one
// message.
static int start_embree(const Bench *bench)
{
    double ms;
    EmbreePeer *peer = embree_peer_new(&bench->cases[0].scene, bench->n_threads, &ms);
    embree_peer_free(peer);
    return peer != NULL ? 0 : -1;
}

static int bench_prepare(void *shared, const BenchOptions *options)
{
    Bench *bench = shared;
    if (cl_setup_open(options->device, &bench->cl) != 0 ||
        programs3d_build(&bench->cl, bench->programs) != 0 ||
        pictures3d_create(&bench->pictures) != 0) {
        return -1;
    }
    if (embree_peer_version() != NULL && device_is_cpu(&bench->cl)) {
        bench->pictures.has_embree = 1;
        bench->n_threads = device_units(&bench->cl);
    }
    for (int i = 0; i < N_CASES; i++) {
        bench->cases[i].scene_name = SCENE_NAMES[i];
        if (case3d_prepare(&bench->cases[i], &bench->cl, bench->programs) != 0) {
            return -1;
        }
    }
    const Case3D *secondary = &bench->cases[SECONDARY_CASE];
    if (secondary_rays_prepare(&bench->secondary, &bench->cl, secondary) != 0 ||
        lit_frames_prepare(bench->lit, &bench->cl, secondary) != 0) {
        return -1;
    }
    printf("%s: %dx%d pixels; Embree's threads: %d\n", bench->cl.device_name, CASE3D_SIDE,
           CASE3D_SIDE, bench->n_threads);
    return bench->n_threads > 0 ? start_embree(bench) : 0;
}

static void bench_free(void *shared)
{
    Bench *bench = shared;
    lit_frames_free(bench->lit);
    secondary_rays_free(&bench->secondary);
    for (int i = 0; i < N_CASES; i++) {
        case3d_free(&bench->cases[i]);
    }
    pictures3d_free(&bench->pictures);
    programs_free(bench->programs, N_PROGRAMS);
    cl_setup_close(&bench->cl);
}

// ---- Measuring ------------------------------------------------------------------------------

// Keep the picture that a kernel has drawn.
static void read_picture(Bench *bench, const Case3D *bench_case, Renderer renderer)
{
    Image *picture = &bench->pictures.images[renderer];
    if (renderer == TILES) {
        pixels_read(bench->cl.queue, bench_case->tiles.d_pixels, picture);
    } else {
        read_image(&bench->cl, bench_case->buffers.d_image, picture);
    }
}

// A kernel's frames of a round; the first round's picture is kept. The tiles need no spoilt one:
// theirs is new, and nobody else draws there.
static void measure_kernel(Bench *bench, const Case3D *bench_case, Renderer renderer,
                           Measurements *measurements)
{
    const int is_long = renderer == NAIVE && bench_case->scene.n_spheres > MANY_SPHERES;
    const int is_first = measurements->round == 0;
    if (is_first && renderer != TILES) {
        spoil_image(&bench->cl, bench_case->buffers.d_image, CASE3D_SIDE, CASE3D_SIDE);
    }
    for (int i = 0; i < (is_long ? 1 : N_FRAMES); i++) {
        measurements_add(measurements, bench_case->scene_name, RENDERER_NAMES[renderer], "frame",
                         case3d_draw(bench_case, &bench->cl, renderer));
    }
    if (is_first) {
        read_picture(bench, bench_case, renderer);
    }
}

// Embree's part of a round. Its tree is built twice: on one thread, as the course's is, and on all.
// The first is released before the second begins: of all that there are at once, Embree takes the
// largest number of threads for each. Returns 0, or -1 after one message.
static int measure_embree(Bench *bench, const Case3D *bench_case, Measurements *measurements)
{
    const char *scene = bench_case->scene_name;
    double ms;
    EmbreePeer *peer = embree_peer_new(&bench_case->scene, 1, &ms);
    if (peer == NULL) {
        return -1;
    }
    embree_peer_free(peer);
    measurements_add(measurements, scene, "Embree", "build", ms);
    peer = embree_peer_new(&bench_case->scene, bench->n_threads, &ms);
    if (peer == NULL) {
        return -1;
    }
    measurements_add(measurements, scene, "Embree", "build on all threads", ms);
    for (int call = 0; call < N_EMBREE_CALLS; call++) {
        for (int i = 0; i < N_FRAMES && embree_peer_has(call); i++) {
            const double start = stats_clock_ms();
            embree_peer_draw(peer, call, &bench->pictures.images[EMBREE + call]);
            measurements_add(measurements, scene, RENDERER_NAMES[EMBREE + call], "frame",
                             stats_clock_ms() - start);
        }
    }
    embree_peer_free(peer);
    return 0;
}

// The trees of labs 06 and 08 on as many threads as Embree's. Returns 0, or -1 after one message.
static int measure_parallel_builds(const Bench *bench, const Case3D *bench_case,
                                   Measurements *measurements)
{
    int result = 0;
    omp_set_num_threads(bench->n_threads);
    for (int builder = KDTREE; result == 0 && builder <= BY_COST; builder++) {
        TreeTimes ms;
        result = case3d_time_tree(bench_case, &bench->cl, builder, &ms);
        if (result == 0) {
            measurements_add(measurements, bench_case->scene_name, RENDERER_NAMES[builder],
                             "build on all threads", ms.build);
        }
    }
    omp_set_num_threads(1);
    return result;
}

// What is known of a scene without measuring: how much it is, and the work of its rays.
static void add_counts(const Case3D *bench_case, Measurements *measurements)
{
    const struct {
        const char *quantity;
        double value;
    } counts[] = {
        {"elements", bench_case->scene.n_spheres},
        {"rays", CASE3D_SIDE * CASE3D_SIDE},
        {"inner nodes", bench_case->work.n_nodes},
        {"leaves", bench_case->work.n_leaves},
        {"spheres asked", bench_case->work.n_tests},
        {"steps of the slowest", bench_case->work.n_slowest_steps},
    };
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        measurements_add(measurements, bench_case->scene_name, "", counts[i].quantity,
                         counts[i].value);
    }
}

// A scene's part of a round. Returns 0, or -1 after one message.
static int measure(Bench *bench, const Case3D *bench_case, Measurements *measurements)
{
    if (measurements->round == 0) {
        add_counts(bench_case, measurements);
    }
    for (int kernel = 0; kernel < N_KERNELS; kernel++) {
        measure_kernel(bench, bench_case, kernel, measurements);
    }
    for (int builder = KDTREE; builder <= TILES; builder++) {
        const char *name = RENDERER_NAMES[builder];
        TreeTimes ms;
        if (case3d_time_tree(bench_case, &bench->cl, builder, &ms) != 0) {
            return -1;
        }
        measurements_add(measurements, bench_case->scene_name, name, "build", ms.build);
        measurements_add(measurements, bench_case->scene_name, name, "copy", ms.copy);
    }
    if (bench->n_threads > 0 && (measure_parallel_builds(bench, bench_case, measurements) != 0 ||
                                 measure_embree(bench, bench_case, measurements) != 0)) {
        return -1;
    }
    return measurements->round == 0 ? pictures3d_check(&bench->pictures, bench_case, measurements)
                                    : 0;
}

static int measure_round(void *shared, Measurements *measurements)
{
    Bench *bench = shared;
    for (int i = 0; i < N_CASES; i++) {
        if (measure(bench, &bench->cases[i], measurements) != 0) {
            return -1;
        }
    }
    const Case3D *secondary = &bench->cases[SECONDARY_CASE];
    if (secondary_rays_measure(&bench->secondary, &bench->cl, secondary, bench->n_threads,
                               measurements) != 0) {
        return -1;
    }
    return lit_frames_measure(bench->lit, &bench->cl, secondary, measurements);
}

static const BenchKind BENCH = {
    .name = "bench3d",
    .what = "measures the naive kernel of lab 05, the kd-tree kernel of lab 07, the tiles of lab "
            "10 and Embree, and shadows and mirrors",
    .longest_seconds = 400,
    .first_is_done = "; the pictures of each scene are equal, but for rounding",
    .prepare = bench_prepare,
    .measure_round = measure_round,
    .free = bench_free,
};

int main(int argc, char **argv)
{
    static Bench bench;  // large, for the stack
    omp_set_num_threads(1);
    return bench_run(&BENCH, argc, argv, &bench);
}

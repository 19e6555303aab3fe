// The bench of builds: how the time for a tree grows with the number of elements, and the memory
// that it takes: the builders of labs 02, 06 and 08, at the depth that fits the scene and at a
// fixed one.
//
//     build/tools/bench_builds [--rounds N] [--output FOLDER]       or: make bench
//
// The lecture's slide says that building is linear. So it is at a fixed depth, where the leaves
// grow instead; where depth grows with the scene it is N log N. Both laws are fitted
// (tables.sql). All trees are built in turn within each round (bench.h), by one thread of the
// host.
// Read next: case_build.h, tables.sql.
#include "bench.h"
#include "case_build.h"

#include <stdio.h>

// Trees over this many elements or fewer are built so often a round: one takes next to no time.
enum { FEW_ELEMENTS = 1 << 14, N_QUICK_BUILDS = 5 };

typedef struct Bench {
    BuildScene scenes[N_SCENES];  // from the smallest on
    BuildCase cases[N_BUILDERS][N_SCENES];
} Bench;

// The scenes, and each builder over each.
static int bench_prepare(void *shared, const BenchOptions *options)
{
    Bench *bench = shared;
    (void)options;
    int n = SMALLEST_SCENE;
    for (int i = 0; i < N_SCENES; i++, n *= SCENE_FACTOR) {
        if (build_scene_create(n, &bench->scenes[i]) != 0) {
            return -1;
        }
        for (int builder = 0; builder < N_BUILDERS; builder++) {
            bench->cases[builder][i] = (BuildCase){.builder = builder, .n_elements = n};
        }
    }
    return 0;
}

static void bench_free(void *shared)
{
    Bench *bench = shared;
    for (int i = 0; i < N_SCENES; i++) {
        build_scene_free(&bench->scenes[i]);
    }
}

// What was counted of a case that is built.
static void add_counts(const BuildCase *build_case, const char *scene, Measurements *measurements)
{
    const char *name = BUILDERS[build_case->builder].name;
    const TreeSize size = build_case->size;
    measurements_add(measurements, scene, name, "elements", build_case->n_elements);
    measurements_add(measurements, scene, name, "handed on", size.n_handed_on);
    measurements_add(measurements, scene, name, "per leaf", size.n_listed / size.n_leaves);
    measurements_add(measurements, scene, name, "tree bytes", size.n_bytes);
    measurements_add(measurements, scene, name, "peak bytes", build_case->n_peak_bytes);
}

// A case's part of a round. Returns 0, or -1 after one message.
static int measure(BuildCase *build_case, const BuildScene *scene, Measurements *measurements)
{
    char name[32];
    snprintf(name, sizeof name, "%d elements", build_case->n_elements);
    const int n_builds = build_case->n_elements <= FEW_ELEMENTS ? N_QUICK_BUILDS : 1;
    for (int i = 0; i < n_builds; i++) {
        const double ms = case_build_time(build_case, scene);
        if (ms < 0) {
            return -1;
        }
        measurements_add(measurements, name, BUILDERS[build_case->builder].name, "build", ms);
    }
    if (measurements->round == 0) {
        add_counts(build_case, name, measurements);
    }
    return 0;
}

// Each builder's scenes, up to its largest.
static int measure_round(void *shared, Measurements *measurements)
{
    Bench *bench = shared;
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        BuildCase *cases = bench->cases[builder];
        for (int i = 0; i < N_SCENES && cases[i].n_elements <= BUILDERS[builder].largest; i++) {
            if (measure(&cases[i], &bench->scenes[i], measurements) != 0) {
                return -1;
            }
        }
    }
    return 0;
}

static const BenchKind BENCH = {
    .name = "bench_builds",
    .what = "measures how long labs 02, 06 and 08 build, and the memory it takes; on the host, "
            "whatever the device",
    .longest_seconds = 60,
    .first_is_done = "; all trees hold together",
    .prepare = bench_prepare,
    .measure_round = measure_round,
    .free = bench_free,
};

int main(int argc, char **argv)
{
    static Bench bench;  // large, for the stack
    return bench_run(&BENCH, argc, argv, &bench);
}

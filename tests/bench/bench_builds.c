// The bench of builds: how the time for a tree grows with the number of elements, and the memory
// that it takes: the builders of labs 02, 06 and 08, at the depth that fits the scene and at a
// fixed one.
//
//     build/tools/bench_builds [--rounds N] [--output FOLDER]       or: make bench
//
// The lecture's slide says that building is linear. So it is at a fixed depth, where the leaves
// grow instead; where depth grows with the scene it is N log N. A fit shows which of the two it is
// (growth.h). All trees are built in turn within each round (rounds.h), by one thread of the host.
// Read next: case_build.h, report_builds.c.
#include "bench_options.h"
#include "case_build.h"
#include "report_builds.h"
#include "rounds.h"

#include <stdio.h>
#include <stdlib.h>

// No further round begins that would end later.
#define LONGEST_SECONDS 60

// Trees over this many elements or fewer are built so often a round: one takes next to no time.
enum { FEW_ELEMENTS = 1 << 14, N_QUICK_BUILDS = 5 };

typedef struct Bench {
    BuildScene scenes[N_SCENES];  // from the smallest on
    BuildCase cases[N_BUILDERS * N_SCENES];
    int n_cases;
} Bench;

// Which scene a case builds over: they are listed as the scenes are.
static const BuildScene *scene_of(const Bench *bench, const BuildCase *build_case)
{
    int scene = 0;
    for (int n = SMALLEST_SCENE; n < build_case->n_elements; n *= SCENE_FACTOR) {
        scene++;
    }
    return &bench->scenes[scene];
}

// The scenes and the list of cases, builder by builder. Returns 0, or -1 after one message.
static int bench_prepare(Bench *bench)
{
    int n = SMALLEST_SCENE;
    for (int i = 0; i < N_SCENES; i++, n *= SCENE_FACTOR) {
        if (build_scene_create(n, &bench->scenes[i]) != 0) {
            return -1;
        }
    }
    for (int builder = 0; builder < N_BUILDERS; builder++) {
        for (n = SMALLEST_SCENE; n <= BUILDERS[builder].largest; n *= SCENE_FACTOR) {
            bench->cases[bench->n_cases++] = (BuildCase){.builder = builder, .n_elements = n};
        }
    }
    return 0;
}

static void bench_free(Bench *bench)
{
    for (int i = 0; i < N_SCENES; i++) {
        build_scene_free(&bench->scenes[i]);
    }
}

static int measure_round(void *shared, int round)
{
    (void)round;
    Bench *bench = shared;
    for (int i = 0; i < bench->n_cases; i++) {
        BuildCase *build_case = &bench->cases[i];
        const int n_builds = build_case->n_elements <= FEW_ELEMENTS ? N_QUICK_BUILDS : 1;
        for (int j = 0; j < n_builds; j++) {
            const double ms = case_build_time(build_case, scene_of(bench, build_case));
            if (ms < 0) {
                return -1;
            }
            series_add(&build_case->builds, ms);
        }
        series_end_round(&build_case->builds);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const BenchOptions options =
        bench_options_read(argc, argv, "bench_builds",
                           "measures how long labs 02, 06 and 08 build, and the memory it "
                           "takes; on the host, whatever the device");
    static Bench bench;  // large, for the stack
    int result = bench_prepare(&bench);
    if (result == 0) {
        result = rounds_run(measure_round, &bench, options.n_rounds, LONGEST_SECONDS,
                            "; all trees hold together");
    }
    if (result == 0) {
        report_builds_print(bench.cases, bench.n_cases);
        result = report_builds_write_csv(bench.cases, bench.n_cases, options.folder);
    }
    bench_free(&bench);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

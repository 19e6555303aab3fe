// The bench of tricks: what each trick of lab 10 brings. Its kernels are drawn with all of them and
// without one at a time, in one run.
//
//     build/tools/bench_tricks [--device D] [--rounds N] [--output FOLDER]       or: make bench
//
// In the first round each picture is compared with that of the kernel with all tricks; where they
// differ there is no file.
// Read next: trick.c, tables.sql.
#include "bench.h"
#include "launch.h"
#include "same_pictures.h"
#include "trick_case.h"

#include <stdio.h>

enum { N_FRAMES = 8 };  // a round

typedef struct Bench {
    ClSetup cl;
    cl_program programs[N_PARTS][MAX_TRICKS];
    TrickCase cases[N_PARTS][N_TRICK_SCENES];
    Image picture, usual_picture;
} Bench;

static int bench_prepare(void *shared, const BenchOptions *options)
{
    Bench *bench = shared;
    if (cl_setup_open(options->device, &bench->cl) != 0 ||
        image_create(TRICK_SIDE, TRICK_SIDE, &bench->picture) != 0 ||
        image_create(TRICK_SIDE, TRICK_SIDE, &bench->usual_picture) != 0) {
        return -1;
    }
    for (int part = 0; part < N_PARTS; part++) {
        for (int i = 0; i < PART_TRICKS[part].n_tricks; i++) {
            bench->programs[part][i] =
                trick_build(&bench->cl, part, &PART_TRICKS[part].tricks[i], options->folder);
            if (bench->programs[part][i] == NULL) {
                return -1;
            }
        }
        for (int i = 0; i < N_TRICK_SCENES; i++) {
            if (trick_case_prepare(&bench->cases[part][i], &bench->cl, part, i,
                                   bench->programs[part]) != 0) {
                return -1;
            }
        }
    }
    printf("%s: %dx%d pixels\n", bench->cl.device_name, TRICK_SIDE, TRICK_SIDE);
    return 0;
}

static void bench_free(void *shared)
{
    Bench *bench = shared;
    for (int part = 0; part < N_PARTS; part++) {
        for (int i = 0; i < N_TRICK_SCENES; i++) {
            trick_case_free(&bench->cases[part][i]);
        }
        programs_free(bench->programs[part], MAX_TRICKS);
    }
    image_free(&bench->picture);
    image_free(&bench->usual_picture);
    cl_setup_close(&bench->cl);
}

// Compare what a kernel has just drawn with the picture of the one with all tricks: the first of a
// case. Circles are equal to the bit. Returns 0, or -1 after one message.
static int check_picture(Bench *bench, const TrickCase *trick_case, int trick)
{
    Image *picture = trick == 0 ? &bench->usual_picture : &bench->picture;
    trick_case_read(trick_case, &bench->cl, trick, picture);
    if (trick == 0) {
        return 0;
    }
    const int is_exact = trick_case->part == CIRCLES;
    if (is_exact) {
        round_to_bytes(picture);  // that of an image has floats
    }
    char names[128];
    snprintf(names, sizeof names, "bench_tricks: %s, %s", trick_case->scene_name,
             PART_TRICKS[trick_case->part].tricks[trick].name);
    const int most = is_exact ? 0 : (int)(MAX_AMBIGUOUS_SHARE * TRICK_SIDE * TRICK_SIDE);
    const int n_different = pictures_compare(picture, &bench->usual_picture,
                                             is_exact ? 0 : BYTE_TOLERANCE, most, names);
    return n_different >= 0 ? 0 : -1;
}

// All of a scene's kernels in turn. Returns 0, or -1 after one message.
static int measure(Bench *bench, const TrickCase *trick_case, Measurements *measurements)
{
    const int is_first = measurements->round == 0;
    for (int trick = 0; trick < PART_TRICKS[trick_case->part].n_tricks; trick++) {
        if (is_first) {
            trick_case_spoil(trick_case, &bench->cl, trick);
        }
        for (int i = 0; i < N_FRAMES; i++) {
            measurements_add(measurements, trick_case->scene_name,
                             PART_TRICKS[trick_case->part].tricks[trick].title, "frame",
                             trick_case_draw(trick_case, &bench->cl, trick));
        }
        if (is_first && check_picture(bench, trick_case, trick) != 0) {
            return -1;
        }
    }
    return 0;
}

static int measure_round(void *shared, Measurements *measurements)
{
    Bench *bench = shared;
    for (int part = 0; part < N_PARTS; part++) {
        for (int i = 0; i < N_TRICK_SCENES; i++) {
            if (measure(bench, &bench->cases[part][i], measurements) != 0) {
                return -1;
            }
        }
    }
    return 0;
}

static const BenchKind BENCH = {
    .name = "bench_tricks",
    .what = "measures lab 10's kernels with all their tricks, and without one at a time",
    .longest_seconds = 100,
    .first_is_done = "; without any trick the picture is the same",
    .prepare = bench_prepare,
    .measure_round = measure_round,
    .free = bench_free,
};

int main(int argc, char **argv)
{
    static Bench bench;  // large, for the stack
    return bench_run(&BENCH, argc, argv, &bench);
}

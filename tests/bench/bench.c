// What all benches share (see bench.h).
//
// Read next: tables.sql.
#include "bench.h"

#include "cl_setup.h"
#include "complain.h"
#include "option_table.h"
#include "path.h"
#include "stats.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define PLACE(member) offsetof(BenchOptions, member)

static const OptionRow ROWS[] = {
    {"device", "D", OPTION_TEXT, PLACE(device),
     .meaning = "number or part of a name ($" CL_DEVICE_VARIABLE ", or the first)"},
    {"rounds", "N", OPTION_NUMBER, PLACE(n_rounds), 1, 100,
     .meaning = "how often everything is measured (5)"},
    {"output", "FOLDER", OPTION_TEXT, PLACE(folder),
     .meaning = "where the CSV file goes; made where it is missing\n(build/bench)"},
    {"help", NULL, OPTION_ANSWER, PLACE(help), .meaning = "show this and end"},
};
enum { N_ROWS = sizeof ROWS / sizeof *ROWS };

// Ends the program after the help, or with EXIT_FAILURE after one message.
static BenchOptions options_read(const BenchKind *kind, int argc, char **argv)
{
    const OptionTable table = {.program = kind->name, .rows = ROWS, .n_rows = N_ROWS};
    BenchOptions options = {.folder = "build/bench", .n_rounds = 5};
    const OptionsResult result = option_table_read(&table, argc, argv, &options, NULL);
    if (result == OPTIONS_DONE) {
        printf("%s: %s.\n\nOptions (and what holds without them):\n", kind->name, kind->what);
        for (int i = 0; i < N_ROWS; i++) {
            option_row_print(&ROWS[i]);
            printf("\n");
        }
        printf("Run it in the top folder of the course, where the kernels are found.\n");
        exit(EXIT_SUCCESS);
    }
    if (result == OPTIONS_BAD) {
        exit(EXIT_FAILURE);
    }
    if (mkdir(options.folder, 0777) != 0 && errno != EEXIST) {
        complain("%s: --output: cannot make the folder %s: %s", kind->name, options.folder,
                 strerror(errno));
        exit(EXIT_FAILURE);
    }
    return options;
}

void measurements_add(Measurements *measurements, const char *scene, const char *what,
                      const char *quantity, double value)
{
    fprintf(measurements->output.file, "\"%s\",\"%s\",\"%s\",%d,%.9g\n", scene, what, quantity,
            measurements->round, value);
}

// Returns 0, or -1 after one message.
static int rounds_run(const BenchKind *kind, void *bench, const BenchOptions *options,
                      Measurements *measurements)
{
    const double start = stats_clock_ms();
    double seconds = 0;
    for (int round = 0; round < options->n_rounds; round++) {
        const double seconds_before = seconds;
        measurements->round = round;
        if (kind->measure_round(bench, measurements) != 0) {
            return -1;
        }
        seconds = (stats_clock_ms() - start) / 1e3;
        printf("round %d of %d done after %.0f s%s\n", round + 1, options->n_rounds, seconds,
               round == 0 ? kind->first_is_done : "");
        fflush(stdout);
        if (round + 1 < options->n_rounds && 2 * seconds - seconds_before > kind->longest_seconds) {
            printf("no further round: this machine would take too long\n");
            break;
        }
    }
    return 0;
}

int bench_run(const BenchKind *kind, int argc, char **argv, void *bench)
{
    const BenchOptions options = options_read(kind, argc, argv);
    Measurements measurements = {0};
    char path[PATH_MAX];
    path_make(path, "%s/%s.csv", options.folder, kind->name);
    int result = kind->prepare(bench, &options);
    if (result == 0 && output_file_open(&measurements.output, path) == 0) {
        fprintf(measurements.output.file, "scene,what,quantity,round,value\n");
        result = rounds_run(kind, bench, &options, &measurements);
        if (result == 0) {
            result = output_file_commit(&measurements.output);
        } else {
            output_file_discard(&measurements.output);
        }
    } else {
        result = -1;
    }
    kind->free(bench);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

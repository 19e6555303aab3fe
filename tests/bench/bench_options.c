// The command line of the benches (see bench_options.h).
//
// Read next: rounds.c.
#include "bench_options.h"

#include "cl_setup.h"
#include "complain.h"
#include "option_table.h"

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
#define N_ROWS ((int)(sizeof ROWS / sizeof ROWS[0]))

static void print_help(const char *name, const char *what)
{
    printf("%s: %s.\n\nOptions (and what holds without them):\n", name, what);
    for (int i = 0; i < N_ROWS; i++) {
        option_row_print(&ROWS[i]);
        printf("\n");
    }
    printf("Run it in the top folder of the course, where the kernels are found.\n");
}

BenchOptions bench_options_read(int argc, char **argv, const char *name, const char *what)
{
    const OptionTable table = {.program = name, .rows = ROWS, .n_rows = N_ROWS};
    BenchOptions options = {.bench = name, .folder = "build/bench", .n_rounds = 5};
    const OptionsResult result = option_table_read(&table, argc, argv, &options, NULL);
    if (result == OPTIONS_DONE) {
        print_help(name, what);
        exit(EXIT_SUCCESS);
    }
    if (result == OPTIONS_BAD) {
        exit(EXIT_FAILURE);
    }
    if (mkdir(options.folder, 0777) != 0 && errno != EEXIST) {
        complain("%s: --output: cannot make the folder %s: %s", name, options.folder,
                 strerror(errno));
        exit(EXIT_FAILURE);
    }
    return options;
}

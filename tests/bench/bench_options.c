// The command line of the benches (see bench_options.h).
//
// Read next: rounds.c.
#include "bench_options.h"

#include "cl_setup.h"
#include "complain.h"
#include "number.h"
#include "series.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void print_help(const char *name, const char *what)
{
    printf("%s: %s.\n\n"
           "Options (and what holds without them):\n"
           "  --device D       number or part of a name ($" CL_DEVICE_VARIABLE ", or the first)\n"
           "  --rounds N       how often everything is measured, at most %d (5)\n"
           "  --output FOLDER  where %s.csv goes; made where it is missing (build/bench)\n"
           "  --help           show this and end\n"
           "Run it in the top folder of the course, where the kernels are found.\n",
           name, what, SERIES_MAX_ROUNDS, name);
}

// Make a folder and those above it, and see whether files can be made there. Returns 0, or -1
// after one message.
static int make_folder(const char *name, const char *folder)
{
    char path[4096];
    if (snprintf(path, sizeof path, "%s/", folder) >= (int)sizeof path) {
        complain("%s: --output: expected a shorter path", name);
        return -1;
    }
    for (char *slash = strchr(path + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST) {
            complain("%s: --output: cannot make the folder %s: %s", name, path, strerror(errno));
            return -1;
        }
        *slash = '/';
    }
    if (access(path, W_OK | X_OK) != 0) {
        complain("%s: --output: %s cannot be written: %s", name, folder, strerror(errno));
        return -1;
    }
    return 0;
}

OptionsResult bench_options_read(int argc, char **argv, const char *name, const char *what,
                                 BenchOptions *options)
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
                complain("%s: --rounds: found \"%s\", expected a whole number from 1 to %d", name,
                         optarg, SERIES_MAX_ROUNDS);
                return OPTIONS_BAD;
            }
            break;
        case 'h':
            print_help(name, what);
            return OPTIONS_DONE;
        default:
            return OPTIONS_BAD;
        }
    }
    if (optind < argc) {
        complain("%s: found the stray word \"%s\" (try --help)", name, argv[optind]);
        return OPTIONS_BAD;
    }
    options->n_rounds = (int)n_rounds;
    return make_folder(name, options->folder) == 0 ? OPTIONS_RUN : OPTIONS_BAD;
}

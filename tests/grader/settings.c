// Reading the command line of grade; every fault is one message.
#include "settings.h"

#include <errno.h>
#include <getopt.h>
#include <glob.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

// How long a submission may run; the solution takes about a second.
enum { DEFAULT_TIME_LIMIT = 10 };

static void usage(FILE *out)
{
    fprintf(out,
            "usage: grade --lab NN [options]\n"
            "  --lab NN             which lab: its number or its name\n"
            "  --submission FOLDER  what to grade (default: labs/NN-name)\n"
            "  --output FOLDER      where the reports go (default: build/grade/NN)\n"
            "  --seed N             the hidden scenes' seed (default: a new one)\n"
            "  --device D           OpenCL device by number or name\n"
            "  --time-limit S       seconds a submission may run (default: %d)\n"
            "  --build FOLDER       where probes and libraries are (default: build)\n"
            "  --list-checks        print the lab's checks: id, task, points\n",
            DEFAULT_TIME_LIMIT);
}

// "03", "3" or "03-kdtree-2d-render" to the folder's name under labs/. Returns 0, or -1 after one
// message.
static int find_lab(const char *wanted, char lab[64])
{
    char pattern[SETTINGS_PATH_BYTES];
    glob_t found;
    const int is_number = wanted[0] != '\0' && strspn(wanted, "0123456789") == strlen(wanted);
    if (is_number) {
        snprintf(pattern, sizeof pattern, "labs/%02d-*", atoi(wanted));
    } else {
        snprintf(pattern, sizeof pattern, "labs/%s", wanted);
    }
    if (wanted[0] == '\0' || strpbrk(wanted, "/*?[]\\") != NULL ||
        glob(pattern, GLOB_ONLYDIR, NULL, &found) != 0) {
        fprintf(stderr,
                "grade: --lab: found \"%s\", expected the number or name of a folder in labs/\n",
                wanted);
        return -1;
    }
    snprintf(lab, 64, "%s", found.gl_pathv[0] + strlen("labs/"));
    globfree(&found);
    return 0;
}

// A number from `lowest` on, or -1 after one message.
static int parse_number(const char *option, const char *text, uint64_t lowest, uint64_t highest,
                        uint64_t *number)
{
    char *end;
    errno = 0;
    *number = strtoull(text, &end, 0);
    if (errno != 0 || end == text || *end != '\0' || text[0] == '-' || *number < lowest ||
        *number > highest) {
        fprintf(stderr,
                "grade: %s: found \"%s\", expected a whole number from %" PRIu64 " to %" PRIu64
                "\n",
                option, text, lowest, highest);
        return -1;
    }
    return 0;
}

int settings_parse(int argc, char **argv, Settings *settings)
{
    static const struct option options[] = {
        {"lab", required_argument, NULL, 'l'},    {"submission", required_argument, NULL, 's'},
        {"output", required_argument, NULL, 'o'}, {"seed", required_argument, NULL, 'r'},
        {"device", required_argument, NULL, 'd'}, {"time-limit", required_argument, NULL, 't'},
        {"build", required_argument, NULL, 'b'},  {"list-checks", no_argument, NULL, 'c'},
        {"help", no_argument, NULL, 'h'},         {0},
    };
    const char *lab = NULL, *submission = NULL, *output = NULL;
    uint64_t seconds = DEFAULT_TIME_LIMIT;
    *settings = (Settings){.build = "build", .device = ""};
    if (getrandom(&settings->seed, sizeof settings->seed, 0) < 0) {
        settings->seed = (uint64_t)getpid();
    }
    settings->seed >>= 32;  // short enough to be typed again
    int letter, failed = 0;
    while (!failed && (letter = getopt_long(argc, argv, "", options, NULL)) != -1) {
        switch (letter) {
        case 'l':
            lab = optarg;
            break;
        case 's':
            submission = optarg;
            break;
        case 'o':
            output = optarg;
            break;
        case 'r':
            failed = parse_number("--seed", optarg, 0, UINT64_MAX, &settings->seed);
            break;
        case 'd':
            settings->device = optarg;
            break;
        case 't':
            failed = parse_number("--time-limit", optarg, 1, 3600, &seconds);
            break;
        case 'b':
            settings->build = optarg;
            break;
        case 'c':
            settings->list_checks = 1;
            break;
        case 'h':
            usage(stdout);
            return 1;
        default:
            return -1;
        }
    }
    settings->time_limit = (int)seconds;
    if (!failed && (lab == NULL || optind < argc)) {
        fprintf(stderr, "grade: %s (try --help)\n",
                lab == NULL ? "--lab is missing" : "words that are no option");
        return -1;
    }
    if (failed || find_lab(lab, settings->lab) != 0) {
        return -1;
    }
    const int n_submission =
        snprintf(settings->submission, SETTINGS_PATH_BYTES, "%s%s",
                 submission ? submission : "labs/", submission ? "" : settings->lab);
    const int n_output = snprintf(settings->output, SETTINGS_PATH_BYTES, "%s%.2s",
                                  output ? output : "build/grade/", output ? "" : settings->lab);
    if (n_submission >= SETTINGS_PATH_BYTES || n_output >= SETTINGS_PATH_BYTES) {
        fprintf(stderr, "grade: a path of over %d bytes\n", SETTINGS_PATH_BYTES - 1);
        return -1;
    }
    return 0;
}

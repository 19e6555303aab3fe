// Reading the command line of grade; every fault is one message.
#include "settings.h"

#include "complain.h"
#include "course_folder.h"
#include "number.h"

#include <getopt.h>
#include <glob.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

#define SANDBOX_VARIABLE "COURSE_SANDBOX"

static void usage(FILE *out)
{
    fprintf(
        out,
        "usage: grade --lab NN [options]\n"
        "  --lab NN             which lab: its number or its name\n"
        "  --submission PATH    what to grade: a folder, a zip or a tar archive (default: "
        "labs/NN-name)\n"
        "  --output FOLDER      where the reports go (default: grade/NN in the build folder)\n"
        "  --seed N             the hidden scenes' seed (default: a new one)\n"
        "  --device D           OpenCL device by number or name\n"
        "  --time-limit S       seconds of processor time that a submission may use (default: 8\n"
        "                       times what the solution uses here, 10 at least)\n"
        "  --deadline S         be done S seconds from now: what a submission has not done by "
        "then,\n"
        "                       and had the machine for, it has not done\n"
        "  --sandbox KIND       bubblewrap; as root landlock, user or user-unfiltered; none; or\n"
        "                       any, the first of these but none: the default, $" SANDBOX_VARIABLE
        " sets another\n"
        "  --build FOLDER       where probes and libraries are (default: build)\n"
        "  --answers FOLDER     keep the solution's answers there, for one lab and one device\n"
        "  --list-checks        print the lab's checks: id, task, points\n"
        "  --time-solution      print the seconds of processor time that the solution uses\n");
}

// Is `wanted` the name or the number of the lab?
static int is_lab(const char *wanted, const char *name)
{
    uint64_t number;
    return number_read_unsigned(wanted, 0, 99, &number) == 0 ? strtoul(name, NULL, 10) == number
                                                             : strcmp(wanted, name) == 0;
}

// "03", "3" or "03-kdtree-2d-render" to the lab's name. Returns 0, or -1 after one message.
static int find_lab(const char *wanted, char lab[64])
{
    glob_t found;
    char labs[512] = "none";
    size_t length = 0;
    lab[0] = '\0';
    if (glob("labs/[0-9][0-9]-*", GLOB_ONLYDIR, NULL, &found) != 0) {
        found.gl_pathc = 0;
    }
    for (size_t i = 0; i < found.gl_pathc && length < sizeof labs; i++) {
        const char *name = strchr(found.gl_pathv[i], '/') + 1;
        length +=
            (size_t)snprintf(labs + length, sizeof labs - length, "%s%s", i ? ", " : "", name);
        if (is_lab(wanted, name)) {
            snprintf(lab, 64, "%s", name);
        }
    }
    globfree(&found);
    if (lab[0] != '\0') {
        return 0;
    }
    complain("grade: --lab: found \"%s\", expected the number or name of a lab; here %s %s", wanted,
             strchr(labs, ',') != NULL ? "are" : "is only", labs);
    return -1;
}

// A number from `lowest` to `highest`. Returns 0, or -1 after one message.
static int read_number(const char *option, const char *text, uint64_t lowest, uint64_t highest,
                       uint64_t *number)
{
    if (number_read_unsigned(text, lowest, highest, number) == 0) {
        return 0;
    }
    complain("grade: %s: found \"%s\", expected a whole number from %" PRIu64 " to %" PRIu64,
             option, text, lowest, highest);
    return -1;
}

// Returns 0, or -1 after one message.
static int read_sandbox(const char *option, const char *text, SandboxKind *kind)
{
    if (sandbox_kind_find(text, kind) == 0) {
        return 0;
    }
    complain("grade: %s: found \"%s\", expected bubblewrap, landlock, user, user-unfiltered, none "
             "or any",
             option, text);
    return -1;
}

// A seed that nobody can foresee, yet short enough to be typed again.
static uint64_t draw_seed(void)
{
    uint64_t seed;
    if (getrandom(&seed, sizeof seed, 0) < 0) {
        return (uint64_t)getpid();
    }
    return seed >> 32;
}

// Options of which others follow; NULL where they are not given.
typedef struct GivenOptions {
    const char *lab, *submission, *output;
} GivenOptions;

// Go through the words. Returns as settings_parse() does.
static int read_options(int argc, char **argv, Settings *settings, GivenOptions *given)
{
    static const struct option options[] = {
        {"lab", required_argument, NULL, 'l'},      {"submission", required_argument, NULL, 's'},
        {"output", required_argument, NULL, 'o'},   {"seed", required_argument, NULL, 'r'},
        {"device", required_argument, NULL, 'd'},   {"time-limit", required_argument, NULL, 't'},
        {"deadline", required_argument, NULL, 'e'}, {"build", required_argument, NULL, 'b'},
        {"list-checks", no_argument, NULL, 'c'},    {"time-solution", no_argument, NULL, 'u'},
        {"answers", required_argument, NULL, 'a'},  {"sandbox", required_argument, NULL, 'x'},
        {"help", no_argument, NULL, 'h'},           {0},
    };
    uint64_t seconds = 0, deadline = 0;
    int letter, failed = 0;
    while (!failed && (letter = getopt_long(argc, argv, "", options, NULL)) != -1) {
        switch (letter) {
        case 'l':
            given->lab = optarg;
            break;
        case 's':
            given->submission = optarg;
            break;
        case 'o':
            given->output = optarg;
            break;
        case 'r':
            failed = read_number("--seed", optarg, 0, UINT64_MAX, &settings->seed);
            break;
        case 'd':
            settings->device = optarg;
            if (optarg[0] == '\0') {
                complain("grade: --device: found \"\", expected a number or a part of a name");
                failed = -1;
            }
            break;
        case 't':
            failed = read_number("--time-limit", optarg, 1, 3600, &seconds);
            break;
        case 'e':
            failed = read_number("--deadline", optarg, 1, 86400, &deadline);
            break;
        case 'b':
            settings->build = optarg;
            break;
        case 'a':
            settings->kept_answers = optarg;
            break;
        case 'x':
            failed = read_sandbox("--sandbox", optarg, &settings->sandbox);
            break;
        case 'c':
            settings->list_checks = 1;
            break;
        case 'u':
            settings->time_solution = 1;
            break;
        case 'h':
            usage(stdout);
            return 1;
        default:
            return -1;
        }
    }
    settings->time_limit = (int)seconds;
    settings->deadline = (int)deadline;
    return failed;
}

// What is graded and where the reports go. Returns 0, or -1 after one message.
static int set_folders(const GivenOptions *given, Settings *settings)
{
    const int n_submission =
        given->submission ? snprintf(settings->submission, PATH_MAX, "%s", given->submission)
                          : snprintf(settings->submission, PATH_MAX, "labs/%s", settings->lab);
    const int n_output = given->output ? snprintf(settings->output, PATH_MAX, "%s", given->output)
                                       : snprintf(settings->output, PATH_MAX, "%s/grade/%.2s",
                                                  settings->build, settings->lab);
    if (n_submission >= PATH_MAX || n_output >= PATH_MAX) {
        fprintf(stderr, "grade: a path of over %d bytes\n", PATH_MAX - 1);
        return -1;
    }
    return 0;
}

int settings_parse(int argc, char **argv, Settings *settings)
{
    GivenOptions given = {0};
    *settings = (Settings){
        .build = "build",
        .device = "",
        .seed = draw_seed(),
        .sandbox = SANDBOX_ANY,
    };
    const char *sandbox = getenv(SANDBOX_VARIABLE);
    if (sandbox != NULL && sandbox[0] != '\0' &&
        read_sandbox("$" SANDBOX_VARIABLE, sandbox, &settings->sandbox) != 0) {
        return -1;
    }
    const int answered = read_options(argc, argv, settings, &given);
    if (answered != 0) {
        return answered;
    }
    if (given.lab == NULL || optind < argc) {
        complain("grade: %s (try --help)",
                 given.lab == NULL ? "--lab is missing" : "words that are no option");
        return -1;
    }
    if (course_folder_check("grade") != 0 || find_lab(given.lab, settings->lab) != 0) {
        return -1;
    }
    return set_folders(&given, settings);
}

// Reading the command line of grade; every fault is one message.
#include "settings.h"

#include "complain.h"
#include "course_folder.h"
#include "manifest.h"
#include "number.h"
#include "option_table.h"
#include "standard_streams.h"

#include <getopt.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

#define SANDBOX_VARIABLE "COURSE_SANDBOX"

#define PLACE(member) offsetof(GivenSettings, member)

// Settings, and what others of them follow from; NULL where it is not given.
typedef struct GivenSettings {
    Settings settings;
    const char *lab, *submission, *output, *sandbox;
    int reads_seed;
    int help;
} GivenSettings;

enum { SEED_ROW = 6 };
static const OptionRow ROWS[] = {
    {"lab", "NN", OPTION_TEXT, PLACE(lab), .meaning = "which lab: its number or its name"},
    {"submission", "PATH", OPTION_TEXT, PLACE(submission),
     .meaning = "what to grade: a folder, a zip or a tar archive, or one\nof the lab's files "
                "(default: labs/NN-name)"},
    {"student", "NAME", OPTION_TEXT, PLACE(settings.student),
     .meaning = "whose it is, for the reports (default: the submission's path,\n"
                "of one from the root its last part)"},
    {"output", "FOLDER", OPTION_TEXT, PLACE(output),
     .meaning = "where the reports go (default: grade/NN in the build folder)"},
    {"task", "NAME", OPTION_TEXT, PLACE(settings.task),
     .meaning = "tell all of this task, and of the others a line each"},
    {"first", NULL, OPTION_FLAG, PLACE(settings.tells_first),
     .meaning = "the same of the first task that failed"},
    [SEED_ROW] = {"seed", "N", OPTION_SEED, PLACE(settings.seed),
                  .meaning = "the hidden scenes' seed (default: a new one)"},
    {"read-seed", NULL, OPTION_FLAG, PLACE(reads_seed),
     .meaning = "read it from stdin: others can see command lines"},
    {"manifest", "FILE", OPTION_TEXT, PLACE(settings.manifest),
     .meaning = "a lab.json with points of your own (tools/points makes it)"},
    {"device", "D", OPTION_TEXT, PLACE(settings.device),
     .meaning = "OpenCL device by number or name"},
    {"time-limit", "S", OPTION_NUMBER, PLACE(settings.time_limit), 1, 3600,
     .meaning = "seconds of processor time that a submission may use\n"
                "(default: 6 times what the solution uses here, 5 at least)"},
    {"deadline", "S", OPTION_NUMBER, PLACE(settings.deadline), 1, 86400,
     .meaning = "be done S seconds from now: what a submission has not done\n"
                "by then, and had the machine for, it has not done"},
    {"sandbox", "KIND", OPTION_TEXT, PLACE(sandbox),
     .meaning = "bubblewrap; as root landlock or user; none;\n"
                "or any, the first of these but none: the default,\n"
                "$" SANDBOX_VARIABLE " sets another"},
    {"build", "FOLDER", OPTION_TEXT, PLACE(settings.build),
     .meaning = "where probes and libraries are (default: build)"},
    {"verdict-only", NULL, OPTION_FLAG, PLACE(settings.has_no_report),
     .meaning = "write results.json only: no report, no pictures, no race"},
    {"answers", "FOLDER", OPTION_TEXT, PLACE(settings.kept_answers),
     .meaning = "keep the solution's answers there, for one lab and one device"},
    {"list-checks", NULL, OPTION_FLAG, PLACE(settings.list_checks),
     .meaning = "print the lab's checks: id, task, points"},
    {"help", NULL, OPTION_ANSWER, PLACE(help), .meaning = "show this and end"},
};
#define N_ROWS ((int)(sizeof ROWS / sizeof ROWS[0]))

static const OptionTable TABLE = {.program = "grade", .rows = ROWS, .n_rows = N_ROWS};

// Returns as settings_parse() does.
static int print_help(void)
{
    printf("usage: grade --lab NN [options]\n");
    for (int i = 0; i < N_ROWS; i++) {
        option_row_print(&ROWS[i]);
        printf("\n");
    }
    return standard_output_check() == 0 ? 1 : -1;
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

// Returns 0, or -1 after one message.
static int read_sandbox(const char *option, const char *text, SandboxKind *kind)
{
    if (sandbox_kind_find(text, kind) == 0) {
        return 0;
    }
    complain("grade: %s: found \"%s\", expected bubblewrap, landlock, user, none or any", option,
             text);
    return -1;
}

// A seed that nobody can foresee. Returns 0, or -1 after one message.
static int draw_seed(uint64_t *seed)
{
    if (getrandom(seed, sizeof *seed, 0) != sizeof *seed) {
        complain("grade: the kernel gives no random bytes for a seed");
        return -1;
    }
    return 0;
}

// The first line of standard input. Returns 0, or -1 after one message.
static int read_seed(uint64_t *seed)
{
    char line[32] = "";
    if (fgets(line, sizeof line, stdin) != NULL) {
        line[strcspn(line, "\n")] = '\0';
    }
    if (number_read_unsigned(line, 0, UINT64_MAX, seed) != 0) {
        complain("grade: --read-seed: found \"%s\", expected a whole number", line);
        return -1;
    }
    return 0;
}

// The time limit and the seed of an instructor's own points, where the command line has none.
// Returns 0, or -1 after one message.
static int take_own(Settings *settings, int *has_seed)
{
    Manifest manifest;
    if (manifest_load_file(settings->manifest, settings->lab, &manifest) != 0) {
        return -1;
    }
    if (settings->time_limit == 0) {
        settings->time_limit = manifest.time_limit;
    }
    if (!*has_seed && manifest.has_seed) {
        settings->seed = manifest.seed;
        *has_seed = 1;
    }
    manifest_free(&manifest);
    return 0;
}

// What is graded and where the reports go. Returns 0, or -1 after one message.
static int set_folders(const GivenSettings *given, Settings *settings)
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

int settings_find_sandbox(const char *given, SandboxKind *kind)
{
    const char *variable = getenv(SANDBOX_VARIABLE);
    if (given != NULL) {
        return read_sandbox("--sandbox", given, kind);
    }
    if (variable != NULL && variable[0] != '\0') {
        return read_sandbox("$" SANDBOX_VARIABLE, variable, kind);
    }
    *kind = SANDBOX_ANY;
    return 0;
}

int settings_parse(int argc, char **argv, Settings *settings)
{
    GivenSettings given = {.settings = {.build = "build"}};
    int is_given[N_ROWS];
    const OptionsResult result = option_table_read(&TABLE, argc, argv, &given, is_given);
    if (result != OPTIONS_RUN) {
        return result == OPTIONS_DONE ? print_help() : -1;
    }
    if (given.reads_seed && read_seed(&given.settings.seed) != 0) {
        return -1;
    }
    *settings = given.settings;
    if (given.lab == NULL) {
        complain("grade: --lab is missing (try --help)");
        return -1;
    }
    if (settings->device != NULL && settings->device[0] == '\0') {
        option_table_refuse(&TABLE, "device", "", "a number or a part of a name");
        return -1;
    }
    if (settings->device == NULL) {
        settings->device = "";
    }
    if (settings_find_sandbox(given.sandbox, &settings->sandbox) != 0 ||
        course_folder_check("grade") != 0 || find_lab(given.lab, settings->lab) != 0) {
        return -1;
    }
    int has_seed = is_given[SEED_ROW];
    if (settings->manifest != NULL && take_own(settings, &has_seed) != 0) {
        return -1;
    }
    if (!has_seed && !given.reads_seed && draw_seed(&settings->seed) != 0) {
        return -1;
    }
    return set_folders(&given, settings);
}

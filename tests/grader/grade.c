// grade: judge one submission of one lab.
//
//     grade --lab 03 [--submission FOLDER] [--output FOLDER] [--seed N] [--device D]
//
// The solution and the submission do the same job in the sandbox; for each task with a failed check
// the student's answer to it is then tried with our solution of all others, so that one mistake costs
// one task. Read next: judge.h (what is asked), workshop.h (how it is run), report.h (what comes out).
// Exit status: 0 full marks, 1 below, 2 when the grader itself could not work.
#include "holes.h"
#include "judge.h"
#include "message.h"
#include "report.h"
#include "sandbox.h"
#include "stage.h"
#include "stats.h"
#include "text_file.h"
#include "workshop.h"

#include <errno.h>
#include <getopt.h>
#include <glob.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_FULL_MARKS = 0, EXIT_BELOW = 1, EXIT_FAULT = 2, PATH_BYTES = 512 };

// How long a submission may run; the solution takes about a second.
enum { DEFAULT_TIME_LIMIT = 10 };

typedef struct Settings {
    char lab[64];            // "03-kdtree-2d-render"
    const char *submission;  // a folder
    const char *output;      // a folder for the reports
    const char *build;       // where the probes are
    const char *device;      // "" for the first
    uint64_t seed;
    int time_limit;  // seconds
    int list_checks;
} Settings;

// All that one grading holds.
typedef struct Grading {
    const Settings *settings;
    const Judge *judge;
    Manifest manifest;
    Workshop workshop;
    void *job;
    Variant solution, whole, alone[MANIFEST_MAX_TASKS];
    int has_alone[MANIFEST_MAX_TASKS];  // the task's variant was made and run
    Result result;
} Grading;

// ---- Options ------------------------------------------------------------------------------------

static void usage(FILE *out)
{
    fprintf(out, "usage: grade --lab NN [options]\n"
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
    char pattern[PATH_BYTES];
    glob_t found;
    const int is_number = wanted[0] != '\0' && strspn(wanted, "0123456789") == strlen(wanted);
    if (is_number) {
        snprintf(pattern, sizeof pattern, "labs/%02d-*", atoi(wanted));
    } else {
        snprintf(pattern, sizeof pattern, "labs/%s", wanted);
    }
    if (strpbrk(wanted, "/*?[]\\") != NULL || glob(pattern, GLOB_ONLYDIR, NULL, &found) != 0) {
        fprintf(stderr, "grade: --lab: found \"%s\", expected the number or name of a folder in labs/\n",
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
        fprintf(stderr, "grade: %s: found \"%s\", expected a whole number from %" PRIu64 " to %" PRIu64
                        "\n",
                option, text, lowest, highest);
        return -1;
    }
    return 0;
}

// Returns 0, 1 when --help was answered, or -1 after one message.
static int parse_settings(int argc, char **argv, Settings *settings)
{
    static const struct option options[] = {
        {"lab", required_argument, NULL, 'l'},        {"submission", required_argument, NULL, 's'},
        {"output", required_argument, NULL, 'o'},     {"seed", required_argument, NULL, 'r'},
        {"device", required_argument, NULL, 'd'},     {"time-limit", required_argument, NULL, 't'},
        {"build", required_argument, NULL, 'b'},      {"list-checks", no_argument, NULL, 'c'},
        {"help", no_argument, NULL, 'h'},             {0},
    };
    const char *lab = NULL;
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
            settings->submission = optarg;
            break;
        case 'o':
            settings->output = optarg;
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
    return failed ? -1 : find_lab(lab, settings->lab);
}

// ---- Variants -----------------------------------------------------------------------------------

// Put a text into a variant's folder as file `name`. Returns 0, or -1 after one message.
static int write_text(const char *folder, const char *name, const char *text)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (file == NULL || fputs(text, file) == EOF || fclose(file) != 0 || chmod(path, 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be written: %s\n", path, strerror(errno));
        return -1;
    }
    return 0;
}

// The text of one of the lab's files: the solution's, or a staged one of the submission.
static char *read_solution(const Grading *grading, const char *name)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "solutions/%s/%s", grading->manifest.lab, name);
    return text_file_read(path);
}

static char *read_staged(const Grading *grading, const char *name)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/variant-whole/lab/%s", grading->workshop.folder, name);
    return text_file_read(path);
}

static int open_solution(Grading *grading)
{
    char folder[PATH_BYTES];
    int result =
        variant_open(&grading->workshop, "solution", &grading->solution, folder, sizeof folder);
    for (int i = 0; result == 0 && i < grading->manifest.n_files; i++) {
        char *text = read_solution(grading, grading->manifest.files[i]);
        result = text == NULL ? -1 : write_text(folder, grading->manifest.files[i], text);
        free(text);
    }
    return result;
}

// A variant in which only the answer to one task is the student's. Returns 1 when it was made, 0 when
// the student's file has lost its markers, -1 after one message.
static int open_alone(Grading *grading, int t)
{
    const Task *task = &grading->manifest.tasks[t];
    char *staged = read_staged(grading, task->file);
    char *answer = staged ? hole_read(staged, task->id) : NULL;
    free(staged);
    if (answer == NULL) {
        return 0;
    }
    char folder[PATH_BYTES];
    int result = variant_open(&grading->workshop, task->id, &grading->alone[t], folder, sizeof folder);
    for (int i = 0; result == 0 && i < grading->manifest.n_files; i++) {
        const char *name = grading->manifest.files[i];
        char *text = read_solution(grading, name);
        char *filled = text == NULL                      ? NULL
                       : strcmp(name, task->file) == 0 ? hole_fill(text, task->id, answer)
                                                         : strdup(text);
        result = filled == NULL ? -1 : write_text(folder, name, filled);
        free(text);
        free(filled);
    }
    free(answer);
    return result == 0 ? 1 : -1;
}

// ---- Judging ------------------------------------------------------------------------------------

static Verdict judge_check(const Grading *grading, int check, const Variant *variant)
{
    return grading->judge->judge(grading->job, check, &variant->answers);
}

// The solution must pass every check on this device, judged by the oracle: else nothing that is said
// about a submission can be trusted. Returns 0, or -1 after one message.
static int trust_solution(Grading *grading)
{
    const Variant *solution = &grading->solution;
    if (solution->build_log != NULL || solution->trouble != NULL) {
        fprintf(stderr, "grade: the solution itself does not run here: %s\n%s\n",
                solution->build_log ? "it does not compile" : solution->trouble,
                solution->build_log ? solution->build_log : solution->run_output);
        return -1;
    }
    for (int i = 0; i < grading->judge->n_checks; i++) {
        Verdict verdict = judge_check(grading, i, solution);
        if (verdict.kind != VERDICT_PASSED) {
            fprintf(stderr, "grade: the solution itself fails %s on this device: %s\n",
                    grading->judge->checks[i].id, verdict.message ? verdict.message : "no answer");
            free(verdict.message);
            return -1;
        }
    }
    size_t n_bytes;
    const char *device = sections_find_any(&solution->answers, "device", &n_bytes);
    snprintf(grading->result.device, sizeof grading->result.device, "%.*s",
             device ? (int)strnlen(device, n_bytes) : 4, device ? device : "host");
    grading->judge->adopt(grading->job, &solution->answers);
    return 0;
}

// Why a check got no answer from a variant.
static char *describe_missing(const Variant *variant)
{
    if (variant->build_log != NULL) {
        return message_new("not tried: it does not compile");
    }
    return message_new("no answer: %s",
                       variant->trouble ? variant->trouble : "the program said nothing about it");
}

// Note what a check earned with a variant; keeps the better of two.
static void note_verdict(CheckResult *result, Verdict verdict, const Variant *variant)
{
    free(result->message);
    if (verdict.kind == VERDICT_PASSED) {
        result->status = CHECK_PASSED;
        result->points = result->max_points;
        result->message = strdup("");
    } else if (verdict.kind == VERDICT_FAILED) {
        result->status = CHECK_FAILED;
        result->message = verdict.message;
    } else {
        result->status = CHECK_NOT_RUN;
        result->message = describe_missing(variant);
    }
}

static void judge_all(Grading *grading, const Variant *variant, const char *only_task)
{
    for (int i = 0; i < grading->judge->n_checks; i++) {
        CheckResult *result = &grading->result.checks[i];
        if (result->status != CHECK_PASSED &&
            (only_task == NULL || strcmp(result->task, only_task) == 0)) {
            note_verdict(result, judge_check(grading, i, variant), variant);
        }
    }
}

static int task_has_failed(const Grading *grading, const char *task)
{
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        if (strcmp(check->task, task) == 0 && check->status != CHECK_PASSED) {
            return 1;
        }
    }
    return 0;
}

static void add_stage(Result *result, const char *title, CheckStatus status, const char *message)
{
    StageResult *stage = &result->stages[result->n_stages++];
    *stage = (StageResult){title, status, strdup(message)};
}

// Tell how the whole submission compiled and ran.
static void add_run_stages(Grading *grading)
{
    Result *result = &grading->result;
    const Variant *whole = &grading->whole;
    if (whole->build_log != NULL) {
        add_stage(result, "Compiling", CHECK_FAILED, whole->build_log);
        add_stage(result, "Running", CHECK_NOT_RUN, "");
        return;
    }
    add_stage(result, "Compiling", CHECK_PASSED, "");
    if (whole->trouble != NULL) {
        char *message = message_new("%s\n%s", whole->trouble, whole->run_output);
        add_stage(result, "Running", CHECK_FAILED, message);
        free(message);
    } else {
        add_stage(result, "Running", CHECK_PASSED, "");
    }
}

// Try the failed tasks one by one, two at a time. Returns 0, or -1 after one message.
static int judge_alone(Grading *grading)
{
    Variant *pair[2];
    int tasks[2], n = 0;
    for (int t = 0; t < grading->manifest.n_tasks; t++) {
        if (task_has_failed(grading, grading->manifest.tasks[t].id)) {
            const int opened = open_alone(grading, t);
            if (opened < 0) {
                return -1;
            }
            grading->has_alone[t] = opened;
            if (opened) {
                tasks[n] = t;
                pair[n++] = &grading->alone[t];
            }
        }
        if (n == 2 || (n == 1 && t == grading->manifest.n_tasks - 1)) {
            if (variants_run(&grading->workshop, pair, n, grading->settings->time_limit) != 0) {
                return -1;
            }
            for (int i = 0; i < n; i++) {
                judge_all(grading, pair[i], grading->manifest.tasks[tasks[i]].id);
            }
            n = 0;
        }
    }
    return 0;
}

// Name the tasks whose markers are gone; the staging stage carries it.
static void note_lost_markers(Grading *grading)
{
    for (int t = 0; t < grading->manifest.n_tasks; t++) {
        const Task *task = &grading->manifest.tasks[t];
        if (!grading->has_alone[t] && task_has_failed(grading, task->id)) {
            StageResult *staging = &grading->result.stages[0];
            char *message = message_new("%s%s%s: the lines \"// TASK %s\" and \"// END %s\" are not "
                                        "there once each, so this task was only judged together "
                                        "with the others",
                                        staging->message, staging->message[0] ? "\n" : "",
                                        task->file, task->id, task->id);
            free(staging->message);
            staging->message = message;
        }
    }
}

// ---- Grading ------------------------------------------------------------------------------------

static void start_result(Grading *grading)
{
    Result *result = &grading->result;
    result->lab = grading->manifest.lab;
    result->title = grading->manifest.title;
    result->seed = grading->settings->seed;
    snprintf(result->submission, sizeof result->submission, "%s", grading->settings->submission);
    result->n_checks = grading->judge->n_checks;
    for (int i = 0; i < result->n_checks; i++) {
        const Check *check = &grading->judge->checks[i];
        result->checks[i] = (CheckResult){.id = check->id,
                                          .title = check->title,
                                          .task = check->task,
                                          .max_points = check->points,
                                          .status = CHECK_NOT_RUN,
                                          .message = strdup("")};
        result->max_score += check->points;
    }
}

static int write_job(Grading *grading)
{
    char path[PATH_BYTES];
    workshop_job_path(&grading->workshop, path, sizeof path);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        fprintf(stderr, "grade: %s: cannot be written: %s\n", path, strerror(errno));
        return -1;
    }
    grading->job = grading->judge->job_new(grading->settings->seed, file);
    const int closed = fclose(file);
    return grading->job == NULL || closed != 0 || chmod(path, 0644) != 0 ? -1 : 0;
}

// Stage, run, judge. Returns 0 when there is a result, or -1 after one message.
static int grade(Grading *grading)
{
    char folder[PATH_BYTES];
    char *staging = NULL;
    start_result(grading);
    if (workshop_open(&grading->workshop, &grading->manifest, grading->settings->build,
                      grading->settings->device) != 0 ||
        write_job(grading) != 0 || open_solution(grading) != 0 ||
        variant_open(&grading->workshop, "whole", &grading->whole, folder, sizeof folder) != 0) {
        return -1;
    }
    const int staged =
        stage_submission(&grading->manifest, grading->settings->submission, folder, &staging);
    if (staged < 0) {
        return -1;
    }
    add_stage(&grading->result, "Staging", staged == 0 ? CHECK_PASSED : CHECK_FAILED,
              staging ? staging : "");
    free(staging);

    Variant *variants[] = {&grading->solution, &grading->whole};
    if (variants_run(&grading->workshop, variants, staged == 0 ? 2 : 1,
                     grading->settings->time_limit) != 0 ||
        trust_solution(grading) != 0) {
        return -1;
    }
    if (staged != 0) {
        return 0;
    }
    add_run_stages(grading);
    judge_all(grading, &grading->whole, NULL);
    if (judge_alone(grading) != 0) {
        return -1;
    }
    note_lost_markers(grading);
    grading->judge->add_pictures(grading->job, &grading->whole.answers, &grading->result);
    return 0;
}

// Make a folder and its parents. Returns 0, or -1 after one message.
static int make_folders(const char *path)
{
    char part[PATH_BYTES];
    snprintf(part, sizeof part, "%s/", path);
    for (char *slash = strchr(part + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST) {
            fprintf(stderr, "grade: %s: cannot be made: %s\n", part, strerror(errno));
            return -1;
        }
        *slash = '/';
    }
    return 0;
}

static int write_reports(const Grading *grading)
{
    char path[PATH_BYTES];
    const char *output = grading->settings->output;
    if (make_folders(output) != 0) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/results.json", output);
    int result = report_json(path, &grading->manifest, &grading->result);
    snprintf(path, sizeof path, "%s/report.html", output);
    result |= report_html(path, &grading->manifest, &grading->result);
    result |= report_text(stdout, &grading->manifest, &grading->result, isatty(STDOUT_FILENO));
    printf("Report: %s/report.html\n", output);
    return result;
}

static void grading_free(Grading *grading)
{
    for (int t = 0; t < MANIFEST_MAX_TASKS; t++) {
        variant_free(&grading->alone[t]);
    }
    variant_free(&grading->whole);
    variant_free(&grading->solution);
    if (grading->job != NULL) {
        grading->judge->job_free(grading->job);
    }
    workshop_close(&grading->workshop);
    result_free(&grading->result);
    manifest_free(&grading->manifest);
}

static int list_checks(const Judge *judge)
{
    for (int i = 0; i < judge->n_checks; i++) {
        printf("%s\t%s\t%d\n", judge->checks[i].id, judge->checks[i].task, judge->checks[i].points);
    }
    return EXIT_FULL_MARKS;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = parse_settings(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? EXIT_FULL_MARKS : EXIT_FAULT;
    }
    static Grading grading;
    grading.settings = &settings;
    grading.judge = judge_of(settings.lab);
    if (grading.judge == NULL) {
        fprintf(stderr, "grade: %s: this lab has no judge\n", settings.lab);
        return EXIT_FAULT;
    }
    if (settings.list_checks) {
        return list_checks(grading.judge);
    }
    char submission[PATH_BYTES], output[PATH_BYTES];
    snprintf(submission, sizeof submission, "labs/%s", settings.lab);
    snprintf(output, sizeof output, "build/grade/%.2s", settings.lab);
    settings.submission = settings.submission ? settings.submission : submission;
    settings.output = settings.output ? settings.output : output;
    if (manifest_load("labs", settings.lab, &grading.manifest) != 0 || sandbox_check() != 0) {
        return EXIT_FAULT;
    }
    const double start = stats_clock_ms();
    int result = grade(&grading);
    grading.result.seconds = (stats_clock_ms() - start) / 1000;
    for (int i = 0; i < grading.result.n_checks; i++) {
        grading.result.score += grading.result.checks[i].points;
    }
    if (result == 0) {
        result = write_reports(&grading);
    }
    const int full_marks = grading.result.score == grading.result.max_score;
    grading_free(&grading);
    return result != 0 ? EXIT_FAULT : full_marks ? EXIT_FULL_MARKS : EXIT_BELOW;
}

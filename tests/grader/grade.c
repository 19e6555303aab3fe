// grade: judge one submission of one lab.
//
//     grade --lab 03 [--submission FOLDER] [--output FOLDER] [--seed N] [--device D]
//
// The solution and the submission do the same job in the sandbox; for each task with a failed check
// the student's answer to it is then tried with our solution of all others, so that one mistake
// costs one task. In a handout, which has no solution of its lab, the oracle alone judges the
// submission as a whole. Read next: session.h (how it is run), judge.h (what is asked), report.h
// (what comes out). Exit status: 0 full marks, 1 below, 2 when the grader itself could not work.
#include "blame.h"
#include "borrowing.h"
#include "complain.h"
#include "holes.h"
#include "memcheck_advice.h"
#include "message.h"
#include "output_file.h"
#include "report.h"
#include "report_systems.h"
#include "session.h"
#include "settings.h"
#include "stands_out.h"
#include "stats.h"
#include "submission.h"
#include "text_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define NO_ANSWER "no answer: "

enum { EXIT_FULL_MARKS = 0, EXIT_BELOW = 1, EXIT_FAULT = 2, PATH_BYTES = 600 };

// All that one grading holds.
typedef struct Grading {
    Session session;
    Variant whole;                         // the submission as it is
    Variant kernels;                       // its kernels with our host files
    Variant alone[MANIFEST_MAX_TASKS];     // one answer of it in the solution of the other tasks
    int is_untouched[MANIFEST_MAX_TASKS];  // its task stands as it was handed out
    int has_line;                          // it is told at which line of a host file it crashed
    Result result;
} Grading;

// ---- The result -----------------------------------------------------------------------------

static void start_result(Grading *grading, const Settings *settings)
{
    Result *result = &grading->result;
    result->lab = grading->session.manifest.lab;
    result->title = grading->session.manifest.title;
    result->seed = settings->seed;
    result->sandbox = sandbox_kind_name(grading->session.workshop.sandbox);
    snprintf(result->submission, sizeof result->submission, "%s", settings->submission);
    result->n_checks = grading->session.judge->n_checks;
    for (int i = 0; i < result->n_checks; i++) {
        const Check *check = &grading->session.judge->checks[i];
        result->checks[i] = (CheckResult){.id = check->id,
                                          .title = check->title,
                                          .task = check->task,
                                          .max_points = check->points,
                                          .status = CHECK_NOT_RUN,
                                          .message = message_new("%s", "")};
        result->max_score += check->points;
    }
}

static void add_stage(Result *result, const char *title, CheckStatus status, const char *message)
{
    StageResult *stage = &result->stages[result->n_stages++];
    *stage = (StageResult){title, status, message_new("%s", message)};
}

// How the whole submission ended before its end, and where. Owned by the caller.
static char *describe_end(Grading *grading)
{
    const Variant *whole = &grading->whole;
    const RunPlace *place = &whole->place;
    char *line = whole->has_crashed ? session_find_line(&grading->session, whole) : NULL;
    grading->has_line = line != NULL;
    char *message =
        message_new("%s\n%s%s%s%s%s%s%s%s%s", whole->trouble, place->where ? "where: " : "",
                    place->where ? place->where : "", place->with[0] ? ", " : "", place->with,
                    place->where ? "\n" : "", line ? line : "", whole->habits,
                    whole->habits[0] ? "\n" : "", whole->run_output);
    free(line);
    return message;
}

// Tell how the whole submission compiled and ran.
static void add_run_stages(Grading *grading)
{
    Result *result = &grading->result;
    Variant *whole = &grading->whole;
    if (whole->build_log != NULL) {
        add_stage(result, "Compiling", CHECK_FAILED, whole->build_log);
        add_stage(result, "Running", CHECK_NOT_RUN, "");
        return;
    }
    add_stage(result, "Compiling", CHECK_PASSED, "");
    if (whole->trouble != NULL) {
        char *message = describe_end(grading);
        add_stage(result, "Running", CHECK_FAILED, message);
        free(message);
        whole->is_told = 1;
    } else {
        add_stage(result, "Running", CHECK_PASSED, whole->habits);
    }
}

// ---- Judging --------------------------------------------------------------------------------

// Did two variants end in the same way at the same place?
static int ended_alike(const Variant *one, const Variant *other)
{
    const RunPlace *a = &one->place, *b = &other->place;
    return one->trouble != NULL && other->trouble != NULL &&
           strcmp(one->trouble, other->trouble) == 0 && a->where == b->where &&
           strcmp(a->with, b->with) == 0;
}

// Judge the checks that have not passed yet, of one task or of all (NULL). An end before its time
// is told once: for the whole under "Running", for an answer alone with its first check.
static void judge_open_checks(Grading *grading, Variant *variant, const char *task)
{
    variant->is_told |= ended_alike(variant, &grading->whole);
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status != CHECK_PASSED && (task == NULL || strcmp(check->task, task) == 0)) {
            session_judge(&grading->session, i, variant, check);
            variant->is_told |= strncmp(check->message, NO_ANSWER, strlen(NO_ANSWER)) == 0;
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

// The student's answer to a task: what stands in its hole, or NULL when the markers are gone.
static char *read_answer(const Grading *grading, const Task *task)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/variant-whole/lab/%s", grading->session.workshop.folder,
             task->file);
    return hole_load(path, task->id);
}

// Add a line to what the staging stage says.
static void note_in_staging(Grading *grading, char *note)
{
    StageResult *staging = &grading->result.stages[0];
    char *message = message_new("%s%s%s", staging->message, staging->message[0] ? "\n" : "", note);
    free(note);
    free(staging->message);
    staging->message = message;
}

// What is wrong with the tasks' markers, a line each; "" when nothing is. Owned by the caller.
static char *describe_markers(const Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    char *faults = message_new("%s", "");
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char path[PATH_BYTES];
        snprintf(path, sizeof path, "%s/variant-whole/lab/%s", grading->session.workshop.folder,
                 task->file);
        char *text = text_file_read(path);
        char *fault = text != NULL ? hole_fault(text, task->id) : NULL;
        if (fault != NULL) {
            char *longer =
                message_new("%s%s%s: %s", faults, faults[0] ? "\n" : "", task->file, fault);
            free(faults);
            faults = longer;
        }
        free(fault);
        free(text);
    }
    return faults;
}

// The graders of courses try each answer alone, between its markers: who has lost one is told.
static void add_marker_stage(Grading *grading)
{
    char *faults = describe_markers(grading);
    if (faults[0] != '\0') {
        add_stage(&grading->result, "Markers", CHECK_FAILED, faults);
    }
    free(faults);
}

// The answer to a failed task when it can be tried alone, else NULL. Notes why it cannot.
static char *answer_for_alone(Grading *grading, const Task *task)
{
    if (!task_has_failed(grading, task->id)) {
        return NULL;
    }
    char *answer = read_answer(grading, task);
    if (answer == NULL) {
        note_in_staging(grading,
                        message_new("%s: the lines \"// TASK %s\" and \"// END %s\" are not "
                                    "there once each, so this task was only judged together "
                                    "with the others",
                                    task->file, task->id, task->id));
        return NULL;
    }
    const Task *borrowed = borrowed_task(&grading->session.manifest, task, answer);
    if (borrowed != NULL) {
        note_in_staging(grading, message_new("%s: %s calls %s, the answer to another task, so it "
                                             "was only judged together with your own",
                                             task->file, task->id, borrowed->id));
        free(answer);
        answer = NULL;
    }
    return answer;
}

// Does the same answer stand in our solution, or (cut) in what is cut from it to be handed out? The
// folder labs/ is not asked: a student may be at work there.
static int is_ours(const Grading *grading, const Task *task, const char *answer, int cut)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "solutions/%s/%s", grading->session.manifest.lab, task->file);
    char *text = text_file_read(path);
    char *skeleton = text != NULL && cut ? holes_cut(text, path) : NULL;
    const char *whole = cut ? skeleton : text;
    char *other = whole != NULL ? hole_read(whole, task->id) : NULL;
    const int is_same = other != NULL && strcmp(answer, other) == 0;
    free(other);
    free(skeleton);
    free(text);
    return is_same;
}

static void fail_check(CheckResult *check, const char *message)
{
    check->status = CHECK_FAILED;
    check->points = 0;
    free(check->message);
    check->message = message_new("%s", message);
}

// Where the whole did not run to its end, nothing else is to be said about a task that stands as it
// was handed out.
static void note_unanswered(Grading *grading, const char *task)
{
    const int has_failed = grading->whole.build_log != NULL || grading->whole.trouble != NULL;
    for (int i = 0; i < grading->result.n_checks && has_failed; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status != CHECK_PASSED && strcmp(check->task, task) == 0) {
            free(check->message);
            check->message = message_new("not answered yet: it stands as it was handed out");
        }
    }
}

// A task that stands as it was handed out earns nothing, whatever another task's answer does for
// it.
static void refuse_unanswered(Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char *answer = read_answer(grading, task);
        grading->is_untouched[t] = answer != NULL && is_ours(grading, task, answer, 1);
        for (int i = 0; i < grading->result.n_checks && grading->is_untouched[t]; i++) {
            CheckResult *check = &grading->result.checks[i];
            if (check->status == CHECK_PASSED && strcmp(check->task, task->id) == 0) {
                fail_check(check,
                           "not answered yet: it stands as it was handed out, and what passed "
                           "here is the work of another task's answer");
            }
        }
        free(answer);
    }
}

static int is_of_kernel(const Grading *grading, const CheckResult *check)
{
    return !manifest_is_host_file(manifest_task(&grading->session.manifest, check->task)->file);
}

// Are there points for a kernel in a lab of which host files are handed in, too?
static int kernels_have_points(const Grading *grading)
{
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        if (check->status == CHECK_PASSED && is_of_kernel(grading, check)) {
            return manifest_has_host_files(&grading->session.manifest);
        }
    }
    return 0;
}

// What a kernel earns it has to earn with our host files, too: those that were handed in could do
// its work themselves. Returns 0, or -1 after one message.
static int confirm_kernels(Grading *grading)
{
    char folder[PATH_BYTES];
    Variant *const variants[] = {&grading->kernels};
    snprintf(folder, sizeof folder, "%s/variant-whole/lab", grading->session.workshop.folder);
    if (!kernels_have_points(grading)) {
        return 0;
    }
    if (session_fill_kernels(&grading->session, "kernels", folder, &grading->kernels) != 0 ||
        session_run(&grading->session, variants, 1) != 0) {
        return -1;
    }
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status == CHECK_PASSED && is_of_kernel(grading, check)) {
            check->points = 0;
            session_judge(&grading->session, i, &grading->kernels, check);
        }
    }
    return 0;
}

// What need not be tried: an answer that is not there yet earns nothing, and beside our solution of
// the others our own answer is our solution. Returns whether it was one of them.
static int judge_known(Grading *grading, const Task *task, const char *answer)
{
    if (grading->is_untouched[task - grading->session.manifest.tasks]) {
        note_unanswered(grading, task->id);
        return 1;
    }
    if (is_ours(grading, task, answer, 0)) {
        judge_open_checks(grading, &grading->session.solution, task->id);
        return 1;
    }
    return 0;
}

// Try the answers of the failed tasks alone, in the solution of the others, two at a time. Returns
// 0, or -1 after one message.
static int judge_alone(Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    Variant *pair[2];
    const char *tasks[2];
    int n = 0;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const char *id = manifest->tasks[t].id;
        char *answer = answer_for_alone(grading, &manifest->tasks[t]);
        if (answer != NULL && judge_known(grading, &manifest->tasks[t], answer)) {
            free(answer);
        } else if (answer != NULL) {
            const int filled = session_fill(&grading->session, id, id, answer, &grading->alone[t]);
            free(answer);
            if (filled != 0) {
                return -1;
            }
            tasks[n] = id;
            pair[n++] = &grading->alone[t];
        }
        if (n == 2 || (n == 1 && t == manifest->n_tasks - 1)) {
            if (session_run(&grading->session, pair, n) != 0) {
                return -1;
            }
            for (int i = 0; i < n; i++) {
                judge_open_checks(grading, pair[i], tasks[i]);
            }
            n = 0;
        }
    }
    return 0;
}

// ---- Grading --------------------------------------------------------------------------------

// Stage, run, judge. Returns 0 when there is a result, or -1 after one message.
static int grade(Grading *grading, const Settings *settings)
{
    Session *session = &grading->session;
    char folder[PATH_BYTES];
    char *staging = NULL;
    if (session_open(session, settings) != 0 ||
        variant_open(&session->workshop, "whole", &grading->whole, folder, sizeof folder) != 0) {
        return -1;
    }
    start_result(grading, settings);
    const int staged = submission_stage(&session->workshop, settings->submission, folder, &staging);
    if (staged < 0) {
        return -1;
    }
    add_stage(&grading->result, "Staging", staged == 0 ? CHECK_PASSED : CHECK_FAILED,
              staging ? staging : "");
    free(staging);

    char *notes = stands_out(&session->manifest, folder, settings->submission);
    if (notes != NULL) {
        add_stage(&grading->result, "What stands out", CHECK_PASSED, notes);
        free(notes);
    }
    const char *sandbox = sandbox_kind_note(session->workshop.sandbox);
    if (sandbox != NULL) {
        add_stage(&grading->result, "Sandbox", CHECK_PASSED, sandbox);
    }

    Variant *variants[2];
    int n_variants = 0;
    if (session->has_solution) {
        variants[n_variants++] = &session->solution;
    }
    if (staged == 0) {
        variants[n_variants++] = &grading->whole;
    }
    if (session_run(session, variants, n_variants) != 0 || session_trust_solution(session) != 0) {
        return -1;
    }
    session_device_name(session->has_solution ? &session->solution : &grading->whole,
                        grading->result.device, sizeof grading->result.device);
    if (staged != 0) {
        return 0;
    }
    add_run_stages(grading);
    add_marker_stage(grading);
    judge_open_checks(grading, &grading->whole, NULL);
    if (!session->has_solution) {
        blame_others(session->judge, &grading->result);
        add_stage(&grading->result, "Each task by itself", CHECK_NOT_RUN,
                  "judged without the solution: one mistake can cost more than one task here");
    } else {
        refuse_unanswered(grading);
        if (confirm_kernels(grading) != 0 || judge_alone(grading) != 0) {
            return -1;
        }
    }
    // What ended for a reason that is told already needs no Oclgrind to find one.
    const int crashed = grading->whole.has_crashed && !grading->has_line;
    if (grading->whole.trouble == NULL || crashed) {
        memcheck_advise(&session->manifest, crashed, grading->is_untouched, &grading->result);
    }
    session->judge->add_pictures(session->job, &grading->whole.answers, &grading->result);
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
            complain("grade: %s: cannot be made: %s", part, strerror(errno));
            return -1;
        }
        *slash = '/';
    }
    return 0;
}

// The largest of the student's pictures, or the first drawing; NULL where there is none.
static const PictureResult *telling_picture(const Result *result)
{
    const PictureResult *telling = NULL;
    for (int i = 0; i < result->n_pictures; i++) {
        const PictureResult *picture = &result->pictures[i];
        if (picture->svg_own != NULL) {
            return picture;
        }
        const int n_pixels = picture->own.width * picture->own.height;
        if (n_pixels > (telling ? telling->own.width * telling->own.height : 0)) {
            telling = picture;
        }
    }
    return telling;
}

// One picture in a file beside the report, for pages that show many. Returns 0, or -1 after one
// message.
static int write_picture(const Result *result, const char *output)
{
    char png[PATH_BYTES], svg[PATH_BYTES];
    snprintf(png, sizeof png, "%s/picture.png", output);
    snprintf(svg, sizeof svg, "%s/picture.svg", output);
    unlink(png), unlink(svg);  // of an earlier grading
    const PictureResult *picture = telling_picture(result);
    if (picture == NULL || picture->svg_own == NULL) {
        return picture == NULL ? 0 : image_save(&picture->own, png);
    }
    OutputFile file;
    if (output_file_open(&file, svg) != 0) {
        return -1;
    }
    fputs(picture->svg_own, file.file);
    return output_file_commit(&file);
}

static int write_reports(const Grading *grading, const char *output, FormatSet formats)
{
    char path[PATH_BYTES];
    const Manifest *manifest = &grading->session.manifest;
    if (make_folders(output) != 0) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/results.json", output);
    if (report_json(path, manifest, &grading->result) != 0) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/report.html", output);
    if (formats_write(output, formats, manifest, &grading->result) != 0 ||
        report_html(path, manifest, &grading->result) != 0 ||
        write_picture(&grading->result, output) != 0 ||
        report_text(stdout, manifest, &grading->result, isatty(STDOUT_FILENO)) != 0) {
        return -1;
    }
    printf("Report: %s\n", path);
    return 0;
}

static void grading_free(Grading *grading)
{
    for (int t = 0; t < MANIFEST_MAX_TASKS; t++) {
        variant_free(&grading->alone[t]);
    }
    variant_free(&grading->whole);
    variant_free(&grading->kernels);
    result_free(&grading->result);
    session_close(&grading->session);
}

// Print a lab's checks: id, task, points.
static int list_checks(const char *lab)
{
    const Judge *judge = judge_of(lab);
    if (judge == NULL) {
        complain("grade: %s: this lab has no judge", lab);
        return EXIT_FAULT;
    }
    for (int i = 0; i < judge->n_checks; i++) {
        printf("%s\t%s\t%d\n", judge->checks[i].id, judge->checks[i].task, judge->checks[i].points);
    }
    return EXIT_FULL_MARKS;
}

// Print what the solution's slower step uses. Handouts are packed with it.
static int time_solution(const Settings *settings)
{
    static Session session;
    Variant *solution[] = {&session.solution};
    int failed = session_open(&session, settings);
    if (failed == 0 && !session.has_solution) {
        fprintf(stderr, "grade: --time-solution: solutions/%s is not here\n", settings->lab);
        failed = -1;
    }
    failed = failed != 0 || session_run(&session, solution, 1) != 0 ||
             session_trust_solution(&session) != 0;
    if (!failed) {
        const SandboxTime *used = session.allowance.solution;
        const double compiling = used[STEP_COMPILING].processor;
        const double running = used[STEP_RUNNING].processor;
        printf("%.2f\n", compiling > running ? compiling : running);
    }
    session_close(&session);
    return failed ? EXIT_FAULT : EXIT_FULL_MARKS;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? EXIT_FULL_MARKS : EXIT_FAULT;
    }
    if (settings.list_checks) {
        return list_checks(settings.lab);
    }
    if (settings.time_solution) {
        return time_solution(&settings);
    }
    static Grading grading;
    const double start = stats_clock_ms();
    int result = grade(&grading, &settings);
    grading.result.seconds = (stats_clock_ms() - start) / 1000;
    for (int i = 0; i < grading.result.n_checks; i++) {
        grading.result.score += grading.result.checks[i].points;
    }
    if (result == 0) {
        result = write_reports(&grading, settings.output, settings.formats);
    }
    if (result != 0 && settings.formats != 0 && make_folders(settings.output) == 0) {
        formats_write_fault(settings.output, settings.formats, settings.lab);
    }
    const int full_marks = grading.result.score == grading.result.max_score;
    grading_free(&grading);
    return result != 0 ? EXIT_FAULT : full_marks ? EXIT_FULL_MARKS : EXIT_BELOW;
}

// grade: judge one submission of one lab.
//
//     grade --lab 03 [--submission FOLDER] [--output FOLDER] [--seed N] [--device D]
//
// The solution, where there is one, and the submission do the same job in the sandbox; for each
// task with a failed check the student's answer to it is then tried alone, so that one mistake
// costs one task. Read next: session.h (how it is run), grading.h (how it is judged and written
// down). Exit status: 0 full marks, 1 below, 2 when the grader itself could not work.
#include "advice.h"
#include "complain.h"
#include "device.h"
#include "grading.h"
#include "message.h"
#include "path.h"
#include "settings.h"
#include "stats.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_FULL_MARKS = 0, EXIT_BELOW = 1, EXIT_FAULT = 2 };

// ---- The result -----------------------------------------------------------------------------

// What reports call the submission. Students get them, so no path of this machine is in them.
static const char *shown_submission(const Settings *settings)
{
    const char *slash = strrchr(settings->submission, '/');
    const int is_from_root = settings->submission[0] == '/';
    return settings->student != NULL       ? settings->student
           : is_from_root && slash[1] != 0 ? slash + 1
                                           : settings->submission;
}

static void start_result(Grading *grading, const Settings *settings)
{
    Result *result = &grading->result;
    result->lab = grading->session.manifest.lab;
    result->title = grading->session.manifest.title;
    result->seed = settings->seed;
    result->sandbox = sandbox_kind_name(grading->session.workdir.sandbox);
    result->submission = shown_submission(settings);
    grading_list_checks(grading);
    if (grading->session.manifest.changed != NULL) {
        result_add_stage(result, "Points", CHECK_PASSED, grading->session.manifest.changed);
    }
}

// How the whole submission ended before its end, and where. Owned by the caller.
static char *describe_end(Grading *grading)
{
    const Variant *whole = &grading->whole;
    const RunPlace *place = &whole->place;
    const char *task = NULL;
    char *line = whole->has_crashed ? session_find_line(&grading->session, whole, &task) : NULL;
    grading->has_line = line != NULL;
    grading->end_task = line != NULL ? task : place->task[0] != '\0' ? place->task : NULL;
    grading->session.allowance.is_endless = whole->is_endless;
    grading->session.allowance.endless_task = grading->end_task;
    char *message = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&message, &length);
    if (text == NULL) {
        free(line);
        return message_new("%s", whole->trouble);
    }
    fprintf(text, "%s\n", whole->trouble);
    if (place->where[0] != '\0') {
        fprintf(text, "where: %s", place->where);
        fprintf(text, place->with[0] != '\0' ? ", %s\n" : "%s\n", place->with);
    }
    if (whole->has_crashed && place->suspect[0] != '\0') {
        fprintf(text, "%s\n", place->suspect);
    }
    fprintf(text, "%s", line != NULL ? line : "");
    fprintf(text, whole->habits[0] != '\0' ? "%s\n" : "%s", whole->habits);
    fprintf(text, "%s", whole->run_output);
    fclose(text);
    free(line);
    return message;
}

// Tell how the whole submission compiled and ran.
static void add_run_stages(Grading *grading)
{
    Variant *whole = &grading->whole;
    if (whole->build_log != NULL) {
        result_add_stage(&grading->result, "Compiling", CHECK_FAILED, whole->build_log);
        result_add_stage(&grading->result, "Running", CHECK_NOT_RUN, "");
        return;
    }
    result_add_stage(&grading->result, "Compiling",
                     grading->build_log ? CHECK_FAILED : CHECK_PASSED,
                     grading->build_log ? grading->build_log
                     : whole->warnings  ? whole->warnings
                                        : "");
    if (whole->trouble != NULL) {
        char *message = describe_end(grading);
        result_add_stage(&grading->result, "Running", CHECK_FAILED, message);
        free(message);
        whole->is_told = 1;
    } else {
        result_add_stage(&grading->result, "Running", CHECK_PASSED, whole->habits);
    }
}

// Is a mistake named already, of what crashed or by a check?
static int is_named(const Grading *grading)
{
    int is_named = grading->whole.place.suspect[0] != '\0';
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        is_named |= check->status == CHECK_FAILED && check->diagnosis.cause != NULL;
    }
    return is_named;
}

// Advice on wrong pixels; NULL where there is none. Owned by the caller.
static char *advise_on_pixels(const Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    char *answers[MANIFEST_MAX_TASKS] = {NULL};
    for (int t = 0; t < manifest->n_tasks; t++) {
        answers[t] = grading->is_untouched[t] ? NULL : grading_answer(grading, &manifest->tasks[t]);
    }
    char *advice = advice_on_pixels(manifest, (const char *const *)answers, &grading->result);
    for (int t = 0; t < manifest->n_tasks; t++) {
        free(answers[t]);
    }
    return advice;
}

// Say what to try next. What ended for a reason that is reported already needs nothing to find one.
static void add_advice(Grading *grading)
{
    const Variant *whole = &grading->whole;
    const Manifest *manifest = &grading->session.manifest;
    char *advice = NULL;
    if (whole->has_crashed && !grading->has_line && !is_named(grading)) {
        advice = advice_after_crash(manifest);
    } else if (whole->trouble == NULL) {
        char folder[PATH_MAX];
        path_make(folder, "%s/lab", whole->folder);
        advice = advice_on_local(manifest, folder);
    }
    if (advice == NULL && whole->trouble == NULL) {
        advice = advise_on_pixels(grading);
    }
    if (advice != NULL) {
        result_add_stage(&grading->result, "What to try next", CHECK_PASSED, advice);
    }
    free(advice);
}

// ---- The leaderboard ------------------------------------------------------------------------

static void add_up_score(Result *result)
{
    for (int i = 0; i < result->n_checks; i++) {
        result->score += result->checks[i].points;
    }
}

static int has_full_marks(const Grading *grading)
{
    return grading->result.score == grading->result.max_score;
}

// Let a submission draw beside a reference where it has earned every point as it was handed in: of
// a wrong one nobody needs to know how fast it is. Whatever becomes of that, nothing else of the
// result changes.
static void run_race(Grading *grading)
{
    Session *session = &grading->session;
    if (!session->settings->has_no_report && session->manifest.leaderboard != NULL &&
        has_full_marks(grading) && grading->build_log == NULL && grading->whole.trouble == NULL &&
        !grading->is_saved_beside && allowance_left(&session->allowance) > 0) {
        grading->result.leaderboard = session_race(session, &grading->whole);
    }
}

// ---- Grading --------------------------------------------------------------------------------

// Where our solution runs, it tells whether there is a device. In a handout nothing of ours does.
// Returns 0, or -1 after one message.
static int find_device(const Session *session)
{
    const int is_asked = !session->has_solution && manifest_has_kernels(&session->manifest);
    return is_asked ? device_find(&session->workdir) : 0;
}

// Run our solution, where there is one, and beside it the submission, where there is one. What is
// run after them (grading_judge.c) is compiled now: waiting for a sandbox of its own would take
// longer. Returns 0, or -1 after one message.
static int run_whole(Grading *grading, int is_staged)
{
    Session *session = &grading->session;
    const Manifest *manifest = &session->manifest;
    Variant *variants[3];
    int n = 0;
    if (session->has_solution) {
        variants[n++] = &session->solution;
    }
    if (is_staged) {
        variants[n++] = &grading->whole;
    }
    const int n_runs = n;
    if (is_staged && manifest_has_kernels(manifest) && manifest_has_host_files(manifest)) {
        variants[n++] = &grading->kernels;
        if (session_open_kernels(session, "kernels", &grading->kernels) != 0) {
            return -1;
        }
    }
    if (session_compile(session, variants, n) != 0 || session_run(session, variants, n_runs) != 0) {
        return -1;
    }
    return n_runs > 1 ? session_run_apart(session, variants, n_runs) : 0;
}

// Is the task that is to be told one of the lab's? Returns 0, or -1 after one message.
static int check_task(const Manifest *manifest, const char *task)
{
    char ids[1024] = "";
    size_t length = 0;
    if (task == NULL || manifest_task(manifest, task) != NULL) {
        return 0;
    }
    for (int t = 0; t < manifest->n_tasks && length < sizeof ids; t++) {
        length += (size_t)snprintf(ids + length, sizeof ids - length, "%s%s", t > 0 ? ", " : "",
                                   manifest->tasks[t].id);
    }
    complain("grade: --task: found \"%s\", expected a task of lab %s: %s", task, manifest->lab,
             ids);
    return -1;
}

// Stage, run, judge. Returns 0 when there is a result, or -1 after one message.
static int grade(Grading *grading, const Settings *settings)
{
    Session *session = &grading->session;
    if (session_open(session, settings) != 0 ||
        check_task(&session->manifest, settings->task) != 0 || find_device(session) != 0) {
        return -1;
    }
    start_result(grading, settings);
    const int is_staged = grading_stage(grading, settings->submission);
    if (is_staged < 0) {
        return -1;
    }
    if (run_whole(grading, is_staged) != 0 || session_trust_solution(session) != 0) {
        return -1;
    }
    session->allowance.is_for_one = 1;
    session_device_name(session, session->has_solution ? &session->solution : &grading->whole,
                        grading->result.device, sizeof grading->result.device);
    if (!is_staged) {
        result_drop_off(&grading->result);
        return 0;
    }
    if (grading_retry(grading) != 0) {
        return -1;
    }
    add_run_stages(grading);
    if (grading_judge(grading) != 0) {
        return -1;
    }
    result_drop_off(&grading->result);
    add_up_score(&grading->result);
    add_advice(grading);
    if (settings->has_no_report) {
        return 0;
    }
    const int result =
        judge_add_pictures(&session->judge, variant_answers(&grading->whole), &grading->result);
    result_hide_pictures(&grading->result);
    return result;
}

static void grading_free(Grading *grading)
{
    for (int t = 0; t < MANIFEST_MAX_TASKS; t++) {
        variant_free(&grading->alone[t]);
    }
    free(grading->build_log);
    variant_free(&grading->whole);
    variant_free(&grading->kernels);
    result_free(&grading->result);
    session_close(&grading->session);
}

// Print a lab's checks: id, task, points.
static int list_checks(const Settings *settings)
{
    static JudgeProcess judge;
    Manifest manifest;
    if (manifest_load_file(settings->manifest, settings->lab, &manifest) != 0) {
        return EXIT_FAULT;
    }
    const int started = judge_start(&judge, settings->build, &manifest, settings->seed);
    for (int i = 0; started == 0 && i < judge.n_checks; i++) {
        const Check *check = &judge.checks[i];
        printf("%s\t%s\t%d\n", check->id, check->task, check->points);
    }
    judge_stop(&judge);
    manifest_free(&manifest);
    return started == 0 ? EXIT_FULL_MARKS : EXIT_FAULT;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? EXIT_FULL_MARKS : EXIT_FAULT;
    }
    if (settings.list_checks) {
        return list_checks(&settings);
    }
    static Grading grading;
    const double start = stats_clock_ms();
    int result = grade(&grading, &settings);
    grading.result.seconds = (stats_clock_ms() - start) / 1000;
    if (result == 0) {
        result = grading_tell(&grading, settings.output,
                              (ReportTold){.is_all = settings.task == NULL && !settings.tells_first,
                                           .task = settings.task});
    }
    if (result == 0) {
        run_race(&grading);  // takes longer than the verdict, for which nobody waits
        result = grading_write(&grading, settings.output);
    }
    const int full_marks = has_full_marks(&grading);
    grading_free(&grading);
    return result != 0 ? EXIT_FAULT : full_marks ? EXIT_FULL_MARKS : EXIT_BELOW;
}

// Opening a session, trusting its solution, judging variants.
#include "session.h"

#include "holes.h"
#include "host_limits.h"
#include "jobs.h"
#include "kept_answers.h"
#include "path.h"
#include "sandbox.h"
#include "sandbox_clock.h"
#include "secrets.h"
#include "skeleton.h"
#include "text_file.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// One of the solution's files, with the answers to its tasks in their holes. NULL after one
// message.
static char *solution_text(const Session *session, const char *name, const HoleAnswer answers[],
                           int n)
{
    char path[PATH_MAX];
    path_make(path, "solutions/%s/%s", session->manifest.lab, name);
    char *text = text_file_read(path);
    for (int i = 0; text != NULL && i < n; i++) {
        const Task *task = answers[i].task;
        if (strcmp(task->file, name) == 0) {
            char *filled = hole_fill(text, task->id, answers[i].text);
            if (filled == NULL) {
                fprintf(stderr, "grade: %s: no hole for task %s\n", path, task->id);
            }
            free(text);
            text = filled;
        }
    }
    return text;
}

int session_fill(const Session *session, const char *name, const HoleAnswer answers[], int n,
                 Variant *variant)
{
    int result = variant_open(&session->workdir, name, variant);
    variant->task = n == 1 ? answers[0].task->id : NULL;
    for (int i = 0; result == 0 && i < session->manifest.n_files; i++) {
        const char *file = session->manifest.files[i];
        result = variant_put(variant, file, solution_text(session, file, answers, n));
    }
    return result;
}

// Make a variant of the lab's files as they are handed out; with the kernels left out where others
// take their place. Returns 0, or -1 after one message.
static int open_handed_out(const Session *session, const char *name, int has_kernels,
                           Variant *variant)
{
    const Manifest *manifest = &session->manifest;
    int result = variant_open(&session->workdir, name, variant);
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        if (has_kernels || manifest_is_host_file(manifest->files[i])) {
            result = variant_put(variant, manifest->files[i],
                                 skeleton_read(manifest, manifest->files[i]));
        }
    }
    return result;
}

int session_open_kernels(const Session *session, const char *name, Variant *variant)
{
    const int result = open_handed_out(session, name, 0, variant);
    variant->has_only_kernels = 1;
    return result;
}

int session_take_kernels(const Session *session, const Variant *from, const Variant *variant)
{
    int result = 0;
    for (int i = 0; result == 0 && i < session->manifest.n_files; i++) {
        const char *file = session->manifest.files[i];
        if (!manifest_is_host_file(file)) {
            char path[PATH_MAX];
            variant_file(from, file, path);
            result = variant_put(variant, file, text_file_read(path));
        }
    }
    return result;
}

int session_write_job(JudgeProcess *judge, const char *task, const char *path)
{
    FILE *file = fopen(path, "wb");
    int failed =
        file == NULL || (task != NULL && section_write(file, PROBE_ALONE, task, strlen(task)) != 0);
    if (!failed && judge_job(judge, task, file) != 0) {
        fclose(file);
        return -1;
    }
    failed |= file != NULL && fclose(file) != 0;
    if (failed || chmod(path, 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be written: %s\n", path, strerror(errno));
        return -1;
    }
    return 0;
}

// Write a judge's job as the workdir's job of this number. Returns 0, or -1 after one message.
static int write_job(const Session *session, JudgeProcess *judge, int job)
{
    char path[PATH_MAX];
    workdir_job_path(&session->workdir, job, path);
    return session_write_job(judge, NULL, path);
}

int session_open(Session *session, const Settings *settings)
{
    *session =
        (Session){.settings = settings, .allowance = {.given_seconds = settings->time_limit}};
    if (settings->deadline > 0) {
        session->allowance.deadline = seconds_now() + settings->deadline;
    }
    SandboxKind sandbox;
    session->has_solution = manifest_has_solution(settings->lab);
    if (host_limits_raise() != 0 ||
        manifest_load_file(settings->manifest, settings->lab, &session->manifest) != 0 ||
        sandbox_choose(settings->sandbox, &sandbox) != 0 ||
        // In a handout all is the student's own.
        (sandbox_is_open(sandbox) && session->has_solution && secrets_check(settings) != 0) ||
        workdir_open(&session->workdir, &session->manifest, settings->build, settings->device,
                     sandbox) != 0 ||
        judge_start(&session->judge, settings->build, &session->manifest, settings->seed) != 0 ||
        write_job(session, &session->judge, 0) != 0) {
        return -1;
    }
    const int result = session->has_solution
                           ? session_fill(session, "solution", NULL, 0, &session->solution)
                           : open_handed_out(session, "solution", 1, &session->solution);
    session->solution.purpose = VARIANT_SOLUTION;
    session->allowance.yardstick = session->has_solution ? NULL : &session->solution;
    session->has_kept_answers =
        session->has_solution && settings->kept_answers != NULL &&
        kept_answers_load(settings->kept_answers, settings->seed, &session->solution.answers,
                          &session->allowance) == 0;
    return result;
}

int session_add_seeds(Session *session, int n)
{
    const Settings *settings = session->settings;
    for (int k = 0; k < n; k++) {
        if (judge_start(&session->further[k], settings->build, &session->manifest,
                        settings->seed + 1 + (uint64_t)k) != 0 ||
            write_job(session, &session->further[k], 1 + k) != 0) {
            return -1;
        }
        session->workdir.n_further_jobs = 1 + k;
    }
    return 0;
}

void session_close(Session *session)
{
    variant_free(&session->solution);
    judge_stop(&session->judge);
    for (int k = 0; k < session->workdir.n_further_jobs; k++) {
        judge_stop(&session->further[k]);
    }
    workdir_close(&session->workdir);
    manifest_free(&session->manifest);
}

// Is the first of them the solution, of which the answers are there already?
static int is_first_known(const Session *session, Variant *const variants[], int n)
{
    return session->has_kept_answers && n > 0 && variants[0] == &session->solution;
}

int session_compile(Session *session, Variant *const variants[], int n)
{
    const int known = is_first_known(session, variants, n);
    return variants_compile(&session->workdir, variants + known, n - known, &session->allowance);
}

int session_run(Session *session, Variant *const variants[], int n)
{
    const int known = is_first_known(session, variants, n);
    // Answers over which the judge ended took its time, which counts as theirs.
    session->allowance.spent += session->judge.lost_seconds;
    session->judge.lost_seconds = 0;
    const int result =
        variants_run(&session->workdir, variants + known, n - known, &session->allowance);
    for (int i = known; i < n; i++) {
        if (variants[i]->trouble != NULL && variants[i]->place.where[0] == '\0') {
            variants[i]->place = judge_place(&session->judge, &variants[i]->note);
        }
    }
    return result;
}

int session_run_apart(Session *session, Variant *const variants[], int n)
{
    const Variant *solution = &session->solution;
    int result = 0;
    if (solution->build_log == NULL && solution->trouble == NULL) {
        return 0;
    }
    for (int i = 0; result == 0 && i < n; i++) {
        if (variants[i]->build_log != NULL || variants[i]->trouble != NULL) {
            result = variant_reset(variants[i]);
            result = result == 0 ? session_run(session, &variants[i], 1) : -1;
        }
    }
    return result;
}

static JudgeProcess *judge_of_job(Session *session, int k)
{
    return k == 0 ? &session->judge : &session->further[k - 1];
}

// What a variant answered to job number k.
static Answers answers_to(const Variant *variant, int k)
{
    return (Answers){variant->number, k == 0 ? &variant->answers : &variant->further[k - 1]};
}

Answers variant_answers(const Variant *variant)
{
    return answers_to(variant, 0);
}

// The solution's answers to a judge's job must pass; then its pictures are what is compared with.
// Returns 0, or -1 after one message.
static int trust_answers(JudgeProcess *judge, Answers answers)
{
    for (int i = 0; i < judge->n_checks; i++) {
        Verdict verdict = judge_verdict(judge, answers, i);
        if (verdict.kind != VERDICT_PASSED) {
            char *message = diagnosis_text(&verdict.diagnosis);
            fprintf(stderr,
                    "grade: the solution itself fails %s on this device (seed %" PRIu64 "): %s\n",
                    judge->checks[i].id, judge->seed, message[0] != '\0' ? message : "no answer");
            free(message);
            diagnosis_free(&verdict.diagnosis);
            return -1;
        }
    }
    return judge_adopt(judge, answers);
}

int session_trust_solution(Session *session)
{
    const Variant *solution = &session->solution;
    if (!session->has_solution) {
        return 0;
    }
    if (solution->build_log != NULL || solution->trouble != NULL) {
        fprintf(stderr, "grade: the solution itself does not run here: %s\n%s\n",
                solution->build_log ? "it does not compile" : solution->trouble,
                solution->build_log ? solution->build_log : solution->run_output);
        return -1;
    }
    for (int k = 0; k <= session->workdir.n_further_jobs; k++) {
        if (trust_answers(judge_of_job(session, k), answers_to(solution, k)) != 0) {
            return -1;
        }
    }
    if (session->settings->kept_answers == NULL || session->has_kept_answers) {
        return 0;
    }
    return kept_answers_save(session->settings->kept_answers, session->settings->seed,
                             &solution->answers, &session->allowance);
}

void session_device_name(const Session *session, const Variant *variant, char *name, size_t n_bytes)
{
    size_t length;
    const char *device = sections_find_any(&variant->answers, "device", &length);
    if (device != NULL) {
        snprintf(name, n_bytes, "%.*s", (int)strnlen(device, length), device);
    } else {
        snprintf(name, n_bytes, "%s", manifest_has_kernels(&session->manifest) ? "none" : "host");
    }
}

char *session_find_line(Session *session, const Variant *variant, const char **task)
{
    return variant_find_line(&session->workdir, variant, &session->allowance, task);
}

double session_race(Session *session, const Variant *variant)
{
    return variant_race(&session->workdir, variant, &session->allowance);
}

// Did a submission end in the function of another task? Then nothing is known about this one.
static int ended_elsewhere(const Variant *variant, const char *task)
{
    return variant->task == NULL && variant->place.task[0] != '\0' &&
           strcmp(variant->place.task, task) != 0;
}

// Why a check got no answer from a variant.
static Diagnosis describe_missing(const Variant *variant, const char *task)
{
    const RunPlace *place = &variant->place;
    const char *beside =
        variant->has_only_kernels ? " beside the host files that are handed out" : "";
    if (variant->build_log != NULL) {
        return diagnosis_silent(SILENCE_UNTRIED, "not tried: it does not compile%s", beside);
    }
    if (variant->trouble == NULL) {
        return diagnosis_new("no answer: the program said nothing about it");
    }
    if (!variant->is_told) {
        return diagnosis_new("no answer%s: %s%s%s%s%s%s", beside, variant->trouble,
                             place->where[0] ? " (" : "", place->where, place->with[0] ? ", " : "",
                             place->with, place->where[0] ? ")" : "");
    }
    return diagnosis_silent(SILENCE_ENDED, "%s: the program had ended%s%s",
                            ended_elsewhere(variant, task) ? "not reached" : "no answer",
                            place->where[0] ? " " : " before", place->where);
}

// Note what a verdict says about the task of a check.
static void take_verdict(const Variant *variant, const char *task, Verdict verdict,
                         CheckResult *result)
{
    result->is_explained = verdict.kind == VERDICT_MISSING || verdict.diagnosis.cause != NULL;
    if (verdict.kind == VERDICT_PASSED) {
        check_pass(result);
    } else if (verdict.kind == VERDICT_FAILED) {
        result->status = CHECK_FAILED;
        check_tell(result, verdict.diagnosis);
    } else {
        // A crash or an endless loop is the answer's own fault; what does not compile was not
        // tried, nor what comes behind the crash of another task's answer.
        result->status = variant->trouble != NULL && !ended_elsewhere(variant, task)
                             ? CHECK_FAILED
                             : CHECK_NOT_RUN;
        check_tell(result, describe_missing(variant, task));
    }
}

void session_judge(Session *session, int k, int i, const Variant *variant, CheckResult *result)
{
    const Verdict verdict = judge_verdict(judge_of_job(session, k), answers_to(variant, k), i);
    take_verdict(variant, session->judge.checks[i].task, verdict, result);
}

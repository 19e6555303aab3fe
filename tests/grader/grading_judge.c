// Judging a submission that has run: as a whole, then each answer that failed alone (see
// grading.h).
//
// Called by grade.c. Read next: session.h, alone.h, blame.h.
#include "grading.h"

#include "blame.h"
#include "holes.h"
#include "message.h"
#include "text_file.h"
#include "untouched.h"

#include <stdlib.h>
#include <string.h>

// ---- The whole ----------------------------------------------------------------------------------

void grading_list_checks(Grading *grading)
{
    Result *result = &grading->result;
    result->n_checks = grading->session.judge.n_checks;
    for (int i = 0; i < result->n_checks; i++) {
        const Check *check = &grading->session.judge.checks[i];
        const TaskCheck *own = manifest_check(&grading->session.manifest, check->id);
        result->checks[i] = (CheckResult){.id = check->id,
                                          .title = check->title,
                                          .task = check->task,
                                          .max_points = check->points,
                                          .is_hidden = own != NULL && own->is_hidden,
                                          .status = CHECK_NOT_RUN};
        check_tell(&result->checks[i], NOTHING_WRONG);
        result->max_score += check->points;
    }
}

static void judge_whole(Grading *grading)
{
    for (int i = 0; i < grading->result.n_checks; i++) {
        session_judge(&grading->session, 0, i, &grading->whole, &grading->result.checks[i]);
    }
}

int grading_is_of(const Grading *grading, int i, int t)
{
    return strcmp(grading->result.checks[i].task, grading->session.manifest.tasks[t].id) == 0;
}

int grading_is_finished(const Grading *grading)
{
    return grading->whole.build_log == NULL && grading->whole.trouble == NULL;
}

char *grading_answer(const Grading *grading, const Task *task)
{
    char path[PATH_MAX];
    grading_own_path(grading, task->file, path);
    return hole_load(path, task->id);
}

// ---- Markers ------------------------------------------------------------------------------------

// What is wrong with the tasks' markers, a line each; "" when nothing is. Owned by the caller.
static char *describe_markers(const Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    char *faults = message_new("%s", "");
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char path[PATH_MAX];
        grading_own_path(grading, task->file, path);
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

// Each answer is tried alone by what stands between its markers: who has lost one reads so.
static void add_marker_stage(Grading *grading)
{
    char *faults = describe_markers(grading);
    if (faults[0] != '\0') {
        result_add_stage(&grading->result, "Markers", CHECK_FAILED, faults);
    }
    free(faults);
}

// ---- Answers that are not there -------------------------------------------------------------

// Why the answer to a task could not be tried, or NULL. Owned by the caller.
static char *describe_untried(const Grading *grading, const Task *task, const char *answer)
{
    if (grading_is_replaced(grading, task->file)) {
        return message_new("not tried: %s could not be used, see Staging", task->file);
    }
    // What ran then was put together from what stands between the markers.
    if (grading->build_log != NULL && answer == NULL) {
        return message_new("not tried: %s does not compile, and without its markers the answer "
                           "cannot be taken out of it, see Compiling and Markers",
                           task->file);
    }
    return NULL;
}

// Let a check fail as its task was not tried, or not answered: what it found is no news then.
static void note_unanswered(CheckResult *check, const char *untried)
{
    static const char unanswered[] = "not answered yet: it stands as it was handed out";
    if (untried != NULL) {
        check_fail(check, diagnosis_silent(SILENCE_UNTRIED, "%s", untried));
    } else if (check->status == CHECK_PASSED) {
        check_fail(check, diagnosis_silent(SILENCE_UNANSWERED,
                                           "%s, and what is right here was given, or is another "
                                           "answer's work",
                                           unanswered));
    } else {
        check_tell(check, diagnosis_silent(SILENCE_UNANSWERED, "%s", unanswered));
    }
    check->is_explained = untried != NULL;
}

// A task that stands as it was handed out earns nothing, whatever another task's answer does for
// it.
static void refuse_unanswered(Grading *grading)
{
    const Manifest *manifest = &grading->session.manifest;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char *answer = grading_answer(grading, task);
        char *untried = describe_untried(grading, task, answer);
        grading->is_untouched[t] =
            untried != NULL || (answer != NULL && answer_is_untouched(manifest, task, answer));
        for (int i = 0; i < grading->result.n_checks && grading->is_untouched[t]; i++) {
            if (grading_is_of(grading, i, t)) {
                note_unanswered(&grading->result.checks[i], untried);
            }
        }
        free(untried);
        free(answer);
    }
}

// Name the cause where a task's answer stands below the placeholder's `return`.
static void explain_returns(Grading *grading)
{
    static const Cause cause = {.says = "the answer still begins with the `return` that was handed "
                                        "out, and nothing below it runs: take that line out"};
    const Manifest *manifest = &grading->session.manifest;
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status != CHECK_FAILED || check->diagnosis.found == NULL) {
            continue;
        }
        const Task *task = manifest_task(manifest, check->task);
        char *answer = grading_answer(grading, task);
        if (answer != NULL && answer_returns_as_handed_out(manifest, task, answer)) {
            check_fail(check, diagnosis_of(message_new("%s", check->diagnosis.found), cause));
            check->is_explained = 1;
        }
        free(answer);
    }
}

// ---- Kernels ------------------------------------------------------------------------------------

static int is_of_kernel(const Grading *grading, const CheckResult *check)
{
    return !manifest_is_host_file(manifest_task(&grading->session.manifest, check->task)->file);
}

static int kernels_have_points(const Grading *grading)
{
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        if (check->status == CHECK_PASSED && is_of_kernel(grading, check)) {
            return 1;
        }
    }
    return 0;
}

// Nobody knows whether the kernels would pass beside other host files.
static void leave_kernels(Grading *grading)
{
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status == CHECK_PASSED && is_of_kernel(grading, check)) {
            check->status = CHECK_NOT_RUN;
            check->points = 0;
            check_tell(check, diagnosis_silent(SILENCE_UNTRIED,
                                               "not tried beside the host files that are handed "
                                               "out: there was no time left"));
        }
    }
}

// What a kernel earns it has to earn beside the host files that are handed out, too: those that
// were handed in could do its work themselves. Only a lab with both has such a variant. Returns 0,
// or -1 after one message.
static int confirm_kernels(Grading *grading)
{
    Variant *const variants[] = {&grading->kernels};
    if (!grading->kernels.has_only_kernels || !kernels_have_points(grading)) {
        return 0;
    }
    if (allowance_left(&grading->session.allowance) <= 0) {
        grading->has_no_time = 1;
        leave_kernels(grading);
        return 0;
    }
    if (session_take_kernels(&grading->session, &grading->whole, &grading->kernels) != 0 ||
        session_run(&grading->session, variants, 1) != 0) {
        return -1;
    }
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (check->status == CHECK_PASSED && is_of_kernel(grading, check)) {
            check->points = 0;
            session_judge(&grading->session, 0, i, &grading->kernels, check);
        }
    }
    return 0;
}

int grading_judge(Grading *grading)
{
    add_marker_stage(grading);
    judge_whole(grading);
    refuse_unanswered(grading);
    if (confirm_kernels(grading) != 0 || grading_try_alone(grading) != 0) {
        return -1;
    }
    explain_returns(grading);
    if (grading->has_no_time) {
        result_add_stage(&grading->result, "Trying answers alone", CHECK_FAILED,
                         "what is left was not tried alone: all runs together had used up the "
                         "time that a submission has; do answers wait, or never end?");
    }
    blame_others(grading->session.judge.checks, &grading->result);
    return 0;
}

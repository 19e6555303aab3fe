// Releasing a Result and summing it up (see result.h).
//
// Read next: report.h.
#include "result.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

static void pictures_free(Result *result)
{
    for (int i = 0; i < result->n_pictures; i++) {
        PictureResult *picture = &result->pictures[i];
        image_free(&picture->reference);
        image_free(&picture->own);
        free(picture->svg_reference);
        free(picture->svg_own);
    }
    result->n_pictures = 0;
}

void result_free(Result *result)
{
    for (int i = 0; i < result->n_stages; i++) {
        free(result->stages[i].message);
    }
    for (int i = 0; i < result->n_checks; i++) {
        check_free(&result->checks[i]);
    }
    pictures_free(result);
    *result = (Result){0};
}

void result_add_stage(Result *result, const char *title, CheckStatus status, const char *message)
{
    if (result->n_stages == RESULT_MAX_STAGES) {
        abort();  // each title is added once, and there is room for all
    }
    StageResult *stage = &result->stages[result->n_stages++];
    *stage = (StageResult){title, status, message_new("%s", message)};
}

void check_tell(CheckResult *check, Diagnosis diagnosis)
{
    check_free(check);
    check->diagnosis = diagnosis;
    check->message = diagnosis_text(&diagnosis);
}

void check_pass(CheckResult *check)
{
    check->status = CHECK_PASSED;
    check->points = check->max_points;
    check_tell(check, NOTHING_WRONG);
}

void check_fail(CheckResult *check, Diagnosis diagnosis)
{
    check->status = CHECK_FAILED;
    check->points = 0;
    check_tell(check, diagnosis);
}

void check_free(CheckResult *check)
{
    diagnosis_free(&check->diagnosis);
    free(check->message);
    check->message = NULL;
}

const char *check_status_name(CheckStatus status)
{
    return status == CHECK_PASSED ? "passed" : status == CHECK_FAILED ? "failed" : "not-run";
}

int check_is_unanswered(const CheckResult *check)
{
    return check->diagnosis.silence == SILENCE_UNANSWERED ||
           check->diagnosis.silence == SILENCE_UNTRIED;
}

int check_is_of_pixels(const CheckResult *check)
{
    return check->diagnosis.evidence == EVIDENCE_PICTURE ||
           check->diagnosis.evidence == EVIDENCE_PLAIN_PICTURE;
}

CheckStatus check_status_shown(const CheckResult *check)
{
    return check_is_unanswered(check) ? CHECK_NOT_RUN : check->status;
}

int check_shows(const CheckResult *check)
{
    return !check->is_hidden || check->status == CHECK_PASSED || check_is_unanswered(check);
}

const char *check_message_shown(const CheckResult *check)
{
    return check_shows(check) ? check->message : "what it found is not shown";
}

void result_hide_pictures(Result *result)
{
    int n_hidden = 0;
    for (int i = 0; i < result->n_checks; i++) {
        n_hidden += !check_shows(&result->checks[i]);
    }
    if (n_hidden > 0) {
        pictures_free(result);
    }
}

void result_drop_off(Result *result)
{
    int n = 0;
    for (int i = 0; i < result->n_checks; i++) {
        if (result->checks[i].max_points > 0) {
            result->checks[n++] = result->checks[i];
        } else {
            check_free(&result->checks[i]);
        }
    }
    result->n_checks = n;
}

TaskPoints result_task_points(const Result *result, const char *task)
{
    TaskPoints sum = {0};
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        if (strcmp(check->task, task) != 0) {
            continue;
        }
        sum.points += check->points;
        sum.max_points += check->max_points;
        sum.n_failed += check->status == CHECK_FAILED;
        sum.n_not_run += check->status == CHECK_NOT_RUN;
    }
    return sum;
}

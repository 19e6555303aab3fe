// Any bytes as results.json: what is taken has sums that agree and numbers within their limits, and
// what is refused gets one message.
#include "fuzz.h"

#include "graded.h"
#include "race.h"

static void check_graded(const Graded *graded)
{
    int points = 0;
    int max_points = 0;
    MUST_HOLD(graded->n_tasks >= 1 && graded->n_tasks <= MANIFEST_MAX_TASKS);
    MUST_HOLD(graded->n_checks >= 0 && graded->n_checks <= RESULT_MAX_CHECKS);
    for (int i = 0; i < graded->n_tasks; i++) {
        const Column *task = &graded->tasks[i];
        MUST_HOLD(strlen(task->id) + strlen(task->title) < 1 << 20);
        MUST_HOLD(task->points >= 0 && task->points <= task->max_points);
        points += task->points;
        max_points += task->max_points;
    }
    MUST_HOLD(points == graded->score && max_points == graded->max_score);
    for (int i = 0; i < graded->n_checks; i++) {
        const Column *check = &graded->checks[i];
        MUST_HOLD(strlen(check->id) + strlen(check->title) + strlen(check->message) < 1 << 20);
        MUST_HOLD(check->status >= CHECK_PASSED && check->status <= CHECK_NOT_RUN);
    }
    MUST_HOLD((graded->failed_stage == NULL) == (graded->stage_message == NULL));
    MUST_HOLD((graded->leaderboard == 0) == (graded->leaderboard_title == NULL));
    MUST_HOLD(graded->leaderboard == 0 ||
              (race_is_figure(graded->leaderboard) && graded->score == graded->max_score));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n_bytes)
{
    InputFile input;
    input_file_make(bytes, n_bytes, &input);
    Graded graded;
    Messages messages;
    messages_begin(&messages);
    const int result = graded_load(input.path, &graded);
    messages_end(&messages);
    MUST_HOLD(result == (messages.length == 0 ? 0 : -1));
    MUST_HOLD((result == 0) == (graded.json != NULL));
    free(messages.text);
    if (result == 0) {
        check_graded(&graded);
    }
    graded_free(&graded);
    input_file_remove(&input);
    return 0;
}

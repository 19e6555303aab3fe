// Trying answers alone, and what a task may have of it (see grading.h).
//
// Called by grading_judge.c. Read next: alone.h, grading_told.c.
//
// The whole decides wherever it can. A check counts as passed by what an answer does alone only
// where another answer is wrong for certain and has a part in the check, or where the whole did not
// come to its end; and a task gets all its checks from one run, the better one: else two wrong
// answers, of which each run sees one, would make a right one.
#include "alone.h"
#include "blame.h"
#include "grading.h"

#include <stdlib.h>
#include <string.h>

// ---- Trying -------------------------------------------------------------------------------------

static const Task *task_of(const Grading *grading, int t)
{
    return &grading->session.manifest.tasks[t];
}

// Is there a check of the task that neither passes nor is known to pass alone?
static int is_open(const Grading *grading, int t)
{
    int n_open = 0;
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        n_open += grading_is_of(grading, i, t) && check->status != CHECK_PASSED &&
                  !grading->verdicts[t].passes[i];
    }
    return n_open > 0;
}

// Keep what came out where it is the best yet.
static void note_verdicts(Grading *grading, int t)
{
    AloneVerdicts found = {.was_tried = 1};
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        if (grading_is_of(grading, i, t)) {
            found.passes[i] =
                judge_passes_alone(&grading->session.judge, variant_answers(&grading->alone[t]), i);
            found.points += found.passes[i] ? check->max_points : 0;
        }
    }
    if (!grading->verdicts[t].was_tried || found.points > grading->verdicts[t].points) {
        grading->verdicts[t] = found;
    }
}

// Must the answer to a task be tried in these files? See try_in().
static int is_due(const Grading *grading, int t, const char *own)
{
    return is_open(grading, t) && !grading->is_untouched[t] &&
           (own != NULL || grading->alone[t].is_changed);
}

// Make the variant in which a task's answer is tried alone. Returns 1, 0 where there is no answer,
// or -1 after one message.
static int fill(Grading *grading, int t, const char *own)
{
    const Task *task = task_of(grading, t);
    Variant *alone = &grading->alone[t];
    char *answer = grading_answer(grading, task);
    if (answer == NULL) {
        return 0;
    }
    variant_free(alone);
    const int filled = alone_fill(&grading->session, task->id, task, answer, own, alone);
    free(answer);
    return filled == 0 ? 1 : -1;
}

// The tasks in the order in which they are tried: first the one in which the whole ended. If it has
// an endless loop, the others are tried beside it.
static void order_tasks(const Grading *grading, int order[])
{
    const int n_tasks = grading->session.manifest.n_tasks;
    int n = 0;
    for (int is_other = 0; is_other < 2; is_other++) {
        for (int t = 0; t < n_tasks; t++) {
            const char *end = grading->end_task;
            if (is_other == (end == NULL || strcmp(task_of(grading, t)->id, end) != 0)) {
                order[n++] = t;
            }
        }
    }
}

// Try answers alone.
//   own   the folder of the student's files, or NULL: those that are handed out, where the
//         student's may have been in the way
// Returns 0, or -1 after one message.
static int try_in(Grading *grading, const char *own)
{
    Variant *variants[MANIFEST_MAX_TASKS];
    int order[MANIFEST_MAX_TASKS], tasks[MANIFEST_MAX_TASKS], n = 0;
    order_tasks(grading, order);
    for (int i = 0; i < grading->session.manifest.n_tasks; i++) {
        const int t = order[i];
        if (!is_due(grading, t, own)) {
            continue;
        }
        if (allowance_left(&grading->session.allowance) <= 0) {
            grading->has_no_time = 1;
            break;
        }
        const int filled = fill(grading, t, own);
        if (filled < 0) {
            return -1;
        }
        if (filled > 0) {
            tasks[n] = t;
            variants[n++] = &grading->alone[t];
        }
    }
    if (n > 0 && session_run(&grading->session, variants, n) != 0) {
        return -1;
    }
    for (int i = 0; i < n; i++) {
        if (variants[i]->is_left_out) {
            grading->has_no_time = 1;
        } else {
            note_verdicts(grading, tasks[i]);
        }
    }
    return 0;
}

// ---- What it counts -----------------------------------------------------------------------------

// Is the answer to a task wrong for certain, or not there?
static int is_wrong(const Grading *grading, int t)
{
    const AloneVerdicts *alone = &grading->verdicts[t];
    for (int i = 0; i < grading->result.n_checks && !grading->is_untouched[t]; i++) {
        const CheckResult *check = &grading->result.checks[i];
        const Check *asked = &grading->session.judge.checks[i];
        if (grading_is_of(grading, i, t) && check->status != CHECK_PASSED &&
            (alone->was_tried ? !alone->passes[i]
                              : check->status == CHECK_FAILED && !check_needs_others(asked))) {
            return 1;
        }
    }
    return grading->is_untouched[t];
}

// Did the whole end by this task's answer? Then the others count by what they do alone, also where
// it is only among them that this one fails: the memory it spoils may be theirs.
static int has_ended_whole(const Grading *grading, int t)
{
    const char *task = grading->end_task;
    return !grading_is_finished(grading) && task != NULL &&
           strcmp(task, task_of(grading, t)->id) == 0;
}

// Is task t to blame for what a check found, as one of its own checks failed in the whole, and none
// of the answers which that check needs is wrong? It may pass alone all the same, where it gets
// other inputs. No two tasks excuse each other: the task that asks is none of those.
static int is_to_blame(const Grading *grading, int t, const char *asking, const int is_task_wrong[])
{
    const Manifest *manifest = &grading->session.manifest;
    int is_found = 0;
    for (int i = 0; i < grading->result.n_checks; i++) {
        const Check *check = &grading->session.judge.checks[i];
        int is_excused = check_needs(check, "*") || check_needs(check, asking);
        for (int other = 0; other < manifest->n_tasks; other++) {
            is_excused |= is_task_wrong[other] && check_needs(check, manifest->tasks[other].id);
        }
        is_found |= grading_is_of(grading, i, t) && !is_excused &&
                    grading->result.checks[i].status == CHECK_FAILED;
    }
    return is_found;
}

// May a check that did not pass in the whole count as passed by what its answer does alone?
static int may_count(const Grading *grading, int i, const int is_task_wrong[])
{
    const Check *check = &grading->session.judge.checks[i];
    const int finished = grading_is_finished(grading);
    int is_others = !finished && !check_needs_others(check);
    for (int t = 0; t < grading->session.manifest.n_tasks; t++) {
        const char *other = task_of(grading, t)->id;
        is_others |=
            strcmp(other, check->task) != 0 && (!finished || check_needs(check, other)) &&
            (is_task_wrong[t] || (finished && is_to_blame(grading, t, check->task, is_task_wrong)));
    }
    return is_others;
}

// Is it about whole scenes, in which every answer has a part, or more than one other?
static int is_of_whole(const Grading *grading, int i)
{
    const Check *check = &grading->session.judge.checks[i];
    return check_needs_others(check) &&
           (strcmp(check->needs, "*") == 0 ||
            (check->is_of_scenes && strchr(check->needs, ' ') != NULL));
}

// Where a task passes whole scenes and nothing else, that may be the work of what stands elsewhere:
// of another answer, or of a given function that was changed.
static void void_borrowed(Grading *grading, int t)
{
    int n_own = 0, n_passed = 0;
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        const int is_own = grading_is_of(grading, i, t) && !is_of_whole(grading, i);
        n_own += is_own;
        n_passed += is_own && (check->status == CHECK_PASSED || grading->verdicts[t].passes[i]);
    }
    for (int i = 0; i < grading->result.n_checks && n_own > 0 && n_passed == 0; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (grading_is_of(grading, i, t) && check->status == CHECK_PASSED) {
            check_fail(check,
                       diagnosis_new("what it looks at comes out right, but counts only where "
                                     "another check of this task passes"));
        }
    }
}

// ---- What stands beside the answers -------------------------------------------------------------

// May check number i count by what its answer does alone?
static int counts_alone(const Grading *grading, int i, const int is_task_wrong[])
{
    return grading->passes_beside[i] || may_count(grading, i, is_task_wrong);
}

// Is there a check that its answer passes alone, but not in the whole, and no other answer to
// blame? Then it is what stands beside the answers, or a macro that one of them defines.
static int is_nobodys(const Grading *grading, const int is_task_wrong[])
{
    int n_found = 0;
    for (int t = 0; t < grading->session.manifest.n_tasks; t++) {
        for (int i = 0; i < grading->result.n_checks; i++) {
            n_found += grading->verdicts[t].passes[i] &&
                       grading->result.checks[i].status != CHECK_PASSED &&
                       !may_count(grading, i, is_task_wrong);
        }
    }
    return n_found > 0;
}

// Give a task the checks of the better run.
static void settle(Grading *grading, int t, const int is_task_wrong[])
{
    const AloneVerdicts *alone = &grading->verdicts[t];
    int counts[RESULT_MAX_CHECKS] = {0}, points = 0, whole_points = 0;
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        const int passed = check->status == CHECK_PASSED;
        counts[i] = alone->passes[i] && (passed || counts_alone(grading, i, is_task_wrong));
        points += counts[i] ? check->max_points : 0;
        whole_points += grading_is_of(grading, i, t) && passed ? check->max_points : 0;
    }
    for (int i = 0; i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (!grading_is_of(grading, i, t)) {
            continue;
        }
        if (points > whole_points && counts[i]) {
            check_pass(check);
        } else if (points > whole_points && check->status == CHECK_PASSED) {
            check_fail(check, diagnosis_new("it passes together with your other answers, but not "
                                            "alone, where the task earned more"));
        } else if (check->status != CHECK_PASSED) {
            grading_tell_alone(grading, t, i,
                               !grading_is_finished(grading) ||
                                   counts_alone(grading, i, is_task_wrong));
        }
    }
}

int grading_try_alone(Grading *grading)
{
    char folder[PATH_MAX];
    int is_task_wrong[MANIFEST_MAX_TASKS];
    grading_own_path(grading, "", folder);
    if (try_in(grading, folder) != 0 || try_in(grading, NULL) != 0) {
        return -1;
    }
    for (int t = 0; t < grading->session.manifest.n_tasks; t++) {
        is_task_wrong[t] = is_wrong(grading, t) || has_ended_whole(grading, t);
    }
    if (is_nobodys(grading, is_task_wrong) && allowance_left(&grading->session.allowance) > 0 &&
        grading_try_together(grading) != 0) {
        return -1;
    }
    for (int t = 0; t < grading->session.manifest.n_tasks; t++) {
        void_borrowed(grading, t);
        if (grading->verdicts[t].was_tried) {
            settle(grading, t, is_task_wrong);
        }
    }
    return 0;
}

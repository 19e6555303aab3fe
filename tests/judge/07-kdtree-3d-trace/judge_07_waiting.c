// Lab 07's next_waiting: its inputs, and what must come out.
#include "job_stack.h"
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

static NextWaitingJob roll_waiting(Random *random)
{
    NextWaitingJob job = {.t = INFINITY, .sphere = UNTOUCHED};
    job.at.node = (u32)random_integer(random, 3, 1000);
    job.at.t_min = random_quarters(random, 1, 16);
    job.at.t_max = job.at.t_min + random_quarters(random, 1, 16);
    const float t_min = job.at.t_min, t_max = job.at.t_max;
    const float hits[] = {INFINITY,
                          t_min - 0.25f,
                          (t_min + t_max) / 2,
                          nextafterf(t_max, 0),
                          t_max,
                          nextafterf(t_max, INFINITY),
                          t_max + random_quarters(random, 1, 16)};
    job.t = hits[random_integer(random, 0, COUNT(hits) - 1)];
    job.sphere = job.t < INFINITY ? (u32)random_integer(random, 0, 99) : ORACLE_NO_SPHERE;
    const int is_empty = random_integer(random, 0, 3) == 0;
    job.todo =
        random_stack(random, 0, is_empty ? 0 : (u32)random_integer(random, 1, STACK_ENTRIES));
    stack_begin_at(&job.todo, t_max);
    return job;
}

void roll_waiting_inputs_07(Random *random, Inputs07 *inputs)
{
    for (int i = 0; i < COUNT(inputs->waiting); i++) {
        inputs->waiting[i] = roll_waiting(random);
    }
}

enum {
    WAITING_ANY_HIT = 1,
    WAITING_NEVER_ENDS,
    WAITING_INVERTED,
    WAITING_SWAPPED,
    WAITING_AT_T_MAX,
    WAITING_AT_T_MIN,
    WAITING_BEFORE_T_MIN,
    WAITING_HAIR,
    WAITING_PART_KEPT,
    WAITING_T_MAX_KEPT,
    WAITING_T_MIN_KEPT,
    WAITING_OLDEST,
    WAITING_STAYS,
    WAITING_ONE_LEFT,
    WAITING_ABOVE_TOP,
};
static const Cause waiting_mistakes[] = {
    [WAITING_ANY_HIT] = {.says = "that is as if the search ended at any hit, also at one beyond "
                                 "t_max, which another sphere may hide"},
    [WAITING_NEVER_ENDS] = {.says =
                                "that is as if the search did not end before the stack is empty"},
    [WAITING_INVERTED] = {.says = "that is as if the search went on where it has found a hit, and "
                                  "ended where it has not: the comparison with t_max is inverted"},
    [WAITING_SWAPPED] = {.says = "1 and 0 are swapped: 0 is the end"},
    [WAITING_AT_T_MAX] = {.says = "a hit exactly at t_max must not end the search: a sphere that "
                                  "only the next leaf lists may be just as far away"},
    [WAITING_AT_T_MIN] =
        {.says = "that is as if the hit were compared with the leaf's t_min: its t_max counts"},
    [WAITING_BEFORE_T_MIN] = {.says = "a hit before t_min ends the search, too: it is in this leaf "
                                      "or before it, and all that waits is farther away"},
    [WAITING_HAIR] =
        {.says = "only hits a hair before or beyond t_max are wrong: compare without an epsilon"},
    [WAITING_PART_KEPT] =
        {.says = "that is as if t_min and t_max were not taken from the stack with the node"},
    [WAITING_T_MAX_KEPT] = {.says =
                                "that is as if t_max were not taken from the stack with the node"},
    [WAITING_T_MIN_KEPT] = {.says =
                                "that is as if t_min were not taken from the stack with the node"},
    [WAITING_OLDEST] = {.says =
                            "that is as if the node that waits longest came from the stack first"},
    [WAITING_STAYS] = {.says = "the node is not taken off the stack: it waits still"},
    [WAITING_ONE_LEFT] = {.says = "the search ended while one node was still waiting"},
    [WAITING_ABOVE_TOP] = {.says = "what was taken is none of the entries that wait: the top one "
                                   "is todo->entries[todo->n - 1]"},
};

static TodoEntry pop(StackState *todo, int mistake)
{
    const u32 last = todo->n - 1;
    const TodoEntry next = todo->upper[mistake == WAITING_OLDEST ? 0 : last];
    for (u32 i = 0; mistake == WAITING_OLDEST && i < last; i++) {
        todo->upper[i] = todo->upper[i + 1];
    }
    todo->n -= mistake != WAITING_STAYS;
    return next;
}

static NextWaitingAnswer expected_waiting(const NextWaitingJob *job, int mistake)
{
    NextWaitingAnswer answer = {.at = job->at, .todo = job->todo};
    const int is_in_part = job->t < job->at.t_max;
    const int is_hit = mistake == WAITING_ANY_HIT        ? job->t < INFINITY
                       : mistake == WAITING_AT_T_MAX     ? job->t <= job->at.t_max
                       : mistake == WAITING_AT_T_MIN     ? job->t < job->at.t_min
                       : mistake == WAITING_BEFORE_T_MIN ? job->t >= job->at.t_min && is_in_part
                                                         : is_in_part;
    const int is_end = mistake == WAITING_NEVER_ENDS ? 0
                       : mistake == WAITING_INVERTED ? !is_hit
                                                     : is_hit;
    answer.goes_on = !is_end && job->todo.n > (mistake == WAITING_ONE_LEFT ? 1 : 0);
    if (answer.goes_on) {
        answer.at = pop(&answer.todo, mistake);
        const int keeps_part = mistake == WAITING_PART_KEPT;
        answer.at.t_min =
            keeps_part || mistake == WAITING_T_MIN_KEPT ? job->at.t_min : answer.at.t_min;
        answer.at.t_max =
            keeps_part || mistake == WAITING_T_MAX_KEPT ? job->at.t_max : answer.at.t_max;
    }
    answer.goes_on ^= mistake == WAITING_SWAPPED;
    return answer;
}

static int end_agrees(const void *job, int i, const void *answers, int mistake)
{
    const NextWaitingJob *waiting = &((const Job07 *)job)->inputs.waiting[i];
    const NextWaitingAnswer expected = expected_waiting(waiting, mistake);
    const int is_hair = mistake == WAITING_HAIR && fabsf(waiting->t - waiting->at.t_max) < HAIR;
    return is_hair || (((const NextWaitingAnswer *)answers)[i].goes_on != 0) == expected.goes_on;
}

static int is_waiting(const StackState *todo, TodoEntry entry)
{
    u32 i = 0;
    while (i < todo->n && !same_entry(todo->upper[i], entry)) {
        i++;
    }
    return i < todo->n;
}

// Where the search is over, at and the stack do not matter.
static int next_agrees(const void *job, int i, const void *answers, int mistake)
{
    const NextWaitingAnswer *found = &((const NextWaitingAnswer *)answers)[i];
    const NextWaitingAnswer expected =
        expected_waiting(&((const Job07 *)job)->inputs.waiting[i], mistake);
    if (mistake == WAITING_ABOVE_TOP && expected.goes_on) {
        return found->goes_on && found->todo.n == expected.todo.n &&
               !is_waiting(&((const Job07 *)job)->inputs.waiting[i].todo, found->at);
    }
    if (mistake != 0 && !expected.goes_on) {
        return !found->goes_on;
    }
    return !expected.goes_on || (found->goes_on && same_entry(found->at, expected.at) &&
                                 same_stack(&found->todo, &expected.todo));
}

static char *describe_waiting(const void *pointer, int i, const void *answers)
{
    const NextWaitingJob *job = &((const Job07 *)pointer)->inputs.waiting[i];
    const NextWaitingAnswer expected = expected_waiting(job, 0);
    return message_new("the nearest hit is at %.9g, the leaf's part [%g, %g], and %u node%s "
                       "waiting: found %s, expected %s",
                       job->t, job->at.t_min, job->at.t_max, job->todo.n,
                       job->todo.n == 1 ? " is" : "s are",
                       next_waiting_words((const NextWaitingAnswer *)answers + i).text,
                       next_waiting_words(&expected).text);
}

const Function waiting_end_07 = {"next_waiting", N_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                                 COMPARED(end_agrees, describe_waiting, waiting_mistakes)};
const Function waiting_next_07 = {"next_waiting", N_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                                  COMPARED(next_agrees, describe_waiting, waiting_mistakes)};

// Lab 07's next_waiting: its inputs, and what must come out.
#include "job_stack.h"
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

static NextWaitingJob roll_waiting(Random *random)
{
    NextWaitingJob job = {.t = INFINITY, .sphere = UNTOUCHED};
    job.at.node = (u32)random_integer(random, 3, 100000);
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
    // Scenes are of any size: a power of two rounds nothing.
    const float factor =
        random_integer(random, 0, 1) == 0 ? 1 : ldexpf(1, (int)random_integer(random, -6, 12));
    job.t *= factor;
    job.at.t_min *= factor;
    job.at.t_max *= factor;
    stack_scale(&job.todo, factor);
    return job;
}

void roll_waiting_inputs_07(Random *random, Inputs07 *inputs)
{
    for (int i = 0; i < COUNT(inputs->waiting); i++) {
        inputs->waiting[i] = roll_waiting(random);
    }
}

const char *suspect_waiting_07(const void *input)
{
    const NextWaitingJob *in = input;
    return in->todo.n == 0 ? TAKEN_FROM_EMPTY : NULL;
}

#define GIVEN                                                                                      \
    const NextWaitingJob *in = &((const Job07 *)job)->inputs.waiting[i];                           \
    const NextWaitingAnswer *found = (const NextWaitingAnswer *)answers + i
#define IS_FOUND(expected) same_waiting(found, expected)

// ---- Right --------------------------------------------------------------------------------------

// The search goes on with entry number `at` of the stack, unless it is at its end.
static NextWaitingAnswer taken(const NextWaitingJob *in, int is_end, u32 at)
{
    NextWaitingAnswer answer = {!is_end && in->todo.n > 0, in->at, in->todo};
    if (answer.goes_on) {
        answer.at = in->todo.upper[at];
        answer.todo.n--;
        for (u32 i = at; i < answer.todo.n; i++) {
            answer.todo.upper[i] = in->todo.upper[i + 1];
        }
    }
    return answer;
}

static NextWaitingAnswer ended_if(const NextWaitingJob *in, int is_end)
{
    return taken(in, is_end, in->todo.n - 1);
}

static NextWaitingAnswer waiting(const NextWaitingJob *in)
{
    return ended_if(in, in->t < in->at.t_max);
}

RIGHT(is_right_end, (found->goes_on != 0) == waiting(in).goes_on)
// Where the search is over, at and the stack do not matter.
RIGHT(is_right_next, !waiting(in).goes_on || IS_FOUND(waiting(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// After it was taken from the stack.
static int ends_in_next(const NextWaitingJob *in)
{
    return in->todo.n > 0 && in->t < in->todo.upper[in->todo.n - 1].t_max;
}

static NextWaitingAnswer with_at(NextWaitingAnswer answer, TodoEntry at)
{
    answer.at = at;
    return answer;
}

static int is_waiting(const StackState *todo, u32 node)
{
    u32 i = 0;
    while (i < todo->n && todo->upper[i].node != node) {
        i++;
    }
    return i < todo->n;
}

KNOWN_LIST(known)
{
    GIVEN;
    const int is_end = in->t < in->at.t_max;
    const NextWaitingAnswer right = waiting(in);

    // By where the search ends.
    ANSWERS(any_hit, ended_if(in, in->t < INFINITY),
            "that is as if the search ended at any hit, also at one beyond t_max, which another "
            "sphere may hide");
    ANSWERS(never_ends, ended_if(in, 0),
            "that is as if the search did not end before the stack is empty");
    ANY(inverted, 2, IS_FOUND(ended_if(in, way ? in->t > in->at.t_max : !is_end)),
        "that is as if the search went on where it has found a hit, and ended where it has not: "
        "the comparison with t_max is inverted");
    ANSWERS(at_t_max, ended_if(in, in->t <= in->at.t_max),
            "a hit exactly at t_max must not end the search: a sphere that only the next leaf "
            "lists may be just as far away");
    ANY(at_t_min, 2, IS_FOUND(ended_if(in, way ? in->t <= in->at.t_min : in->t < in->at.t_min)),
        "that is as if the hit were compared with the leaf's t_min: its t_max counts");

    ANSWERS(by_next, ended_if(in, ends_in_next(in)),
            "the hit was compared with the t_max of the node from the stack: the leaf's is asked "
            "before *at becomes that node");
    ANSWERS(before_t_min, ended_if(in, in->t >= in->at.t_min && is_end),
            "a hit before t_min ends the search, too: it is in this leaf or before it, and all "
            "that waits is farther away");
    ANSWERS(one_left, ended_if(in, is_end || in->todo.n == 1),
            "the search ended while one node was still waiting");
    // Which node such an answer hands on is not defined.
    EACH(swapped, (found->goes_on != 0) != right.goes_on, "1 and 0 are swapped: 0 is the end");
    ONLY(hair, fabsf(in->t - in->at.t_max) < HAIR,
         "only hits a hair before or beyond t_max are wrong: compare without an epsilon");

    ANSWERS(part_kept, with_part(right, in->at.t_min, in->at.t_max),
            "that is as if t_min and t_max were not taken from the stack with the node");
    ANSWERS(t_max_kept, with_part(right, right.at.t_min, in->at.t_max),
            "that is as if t_max were not taken from the stack with the node");
    ANSWERS(t_min_kept, with_part(right, in->at.t_min, right.at.t_max),
            "that is as if t_min were not taken from the stack with the node");
    ANSWERS(oldest, taken(in, is_end, 0),
            "that is as if the node that waits longest came from the stack first");
    ANSWERS(
        not_handed_on, with_at(right, in->at),
        "what was taken from the stack did not become *at: the search goes on with the same leaf");
    ANSWERS(nothing_taken, ((NextWaitingAnswer){right.goes_on, in->at, in->todo}),
            "nothing was taken from the stack: the search goes on with the same leaf");
    ANSWERS(stays, with_one_more(right), "the node is not taken off the stack: it waits still");
    EACH(above_top,
         right.goes_on ? found->goes_on && found->todo.n == right.todo.n &&
                             found->at.node != in->at.node && !is_waiting(&in->todo, found->at.node)
                       : !found->goes_on,
         "what was taken is none of the entries that wait: the top one is todo->entries[todo->n - "
         "1]");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const NextWaitingAnswer expected = waiting(in);
    return message_new("the nearest hit is at %.9g, the leaf's part [%g, %g], and %u node%s "
                       "waiting: your code %s, expected: it %s",
                       in->t, in->at.t_min, in->at.t_max, in->todo.n,
                       in->todo.n == 1 ? " is" : "s are", next_waiting_words(found).text,
                       next_waiting_words(&expected).text);
}

const Function waiting_end_07 = {"next_waiting", N_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                                 KNOWING(is_right_end, describe, known)};
const Function waiting_next_07 = {"next_waiting", N_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                                  KNOWING(is_right_next, describe, known)};

// Lab 07's next_child: its inputs, and what must come out. It is tried alone beside stand-ins of
// near_side and children_on_ray, which depend on their arguments and on nothing else.
#include "job_stack.h"
#include "judge_07.h"
#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Inputs -----------------------------------------------------------------------------------

// Where the plane is met: inside the part; or before it, beyond it, behind the eye.
static float roll_t_split(Random *random, float t_min, float t_max, int is_inside)
{
    if (is_inside) {
        return t_min > 0 && one_in(random, 8) ? t_min
               : one_in(random, 8)            ? t_max
                                   : t_min + random_quarters(random, 1, (int)(4 * (t_max - t_min)));
    }
    switch (random_integer(random, t_min > 0.25f ? 0 : 1, 2)) {
    case 0:
        return random_quarters(random, 1, (int)(4 * t_min) - 1);
    case 1:
        return t_max + random_quarters(random, 1, 16);
    default:
        return -random_quarters(random, 1, 16);
    }
}

static NextChildJob roll_child(Random *random, int meets_both)
{
    NextChildJob job = {.origin = random_quarters(random, -16, 16)};
    job.t_min = one_in(random, 4) ? 0 : random_quarters(random, 1, 16);
    job.t_max = job.t_min + random_quarters(random, 1, 16);
    job.inverse = (float)(1 << random_integer(random, 0, 2));
    job.inverse *= one_in(random, 2) ? -1 : 1;
    const float t_split = roll_t_split(random, job.t_min, job.t_max, meets_both);
    job.node.split_pos = job.origin + t_split / job.inverse;
    job.node.split_axis = (u32)random_integer(random, 0, 2);
    job.node.first = (u32)random_integer(random, 3, 1000);
    job.todo = random_stack_with_room(random);
    stack_begin_at(&job.todo, job.t_max);
    return job;
}

void roll_child_inputs_07(Random *random, Inputs07 *inputs)
{
    for (int i = 0; i < COUNT(inputs->children); i++) {
        inputs->children[i] = roll_child(random, i >= N_CHILD_INPUTS);
    }
}

// ---- Judging ----------------------------------------------------------------------------------

static void push(StackState *todo, TodoEntry entry)
{
    todo->upper[todo->n++ - todo->n_lower] = entry;
}

enum {
    CHILD_SWAPPED = 1,
    CHILD_FAR_IS_NEAR,
    CHILD_FAR_DROPPED,
    CHILD_NEAR_WAITS,
    CHILD_NEAR_KEEPS_T_MAX,
    CHILD_FAR_KEEPS_T_MIN,
    CHILD_FAR_ALWAYS_WAITS,
    CHILD_NEAR_NEVER_SKIPPED,
    CHILD_IS_SIDE,
    CHILD_BY_DIRECTION,
    CHILD_LOWER_IS_NEAR,
    CHILD_XOR,
    CHILD_ONLY_NEAR_CUT,
    CHILD_ONLY_FAR_CUT,
    CHILD_NO_POINTS,
    CHILD_LAST_PLACE,
    CHILD_HAIR,
};
static const Cause child_mistakes[] = {
    [CHILD_SWAPPED] = {.says = "that is as if near and far child were swapped"},
    [CHILD_FAR_IS_NEAR] =
        {.says = "that is as if the search went to the near child where only the far one is met"},
    [CHILD_FAR_DROPPED] =
        {"that is as if the far child were never visited where both are met: it does not wait",
         MISTAKE_FAR_CHILD},
    [CHILD_NEAR_WAITS] = {.says = "the near child waits, and the far one is visited first"},
    [CHILD_NEAR_KEEPS_T_MAX] =
        {.says = "that is as if t_max did not become t_split for the near child"},
    [CHILD_FAR_KEEPS_T_MIN] = {.says = "that is as if t_min did not become t_split for the far "
                                       "child, which begins at t_split"},
    [CHILD_FAR_ALWAYS_WAITS] =
        {.says = "that is as if the far child waited also where only the near one is met"},
    [CHILD_NEAR_NEVER_SKIPPED] =
        {.says = "that is as if the near child were visited also where only the far one is met"},
    [CHILD_IS_SIDE] =
        {.says = "0 and 1 are sides: the children's ids are node.first and node.first + 1"},
    [CHILD_BY_DIRECTION] = {.says = "that is as if the direction decided which child is near: the "
                                    "eye's side does, which near_side() tells"},
    [CHILD_LOWER_IS_NEAR] = {.says = "the lower child was taken for the near one, wherever the eye "
                                     "is"},
    [CHILD_XOR] = {.says = "the other child's id is not the near one's with its lowest bit turned: "
                           "node.first may be odd"},
    [CHILD_ONLY_NEAR_CUT] =
        {.says = "where only the near child is met the part stays as it is: t_split is not in it"},
    [CHILD_ONLY_FAR_CUT] =
        {.says = "where only the far child is met the part stays as it is: t_split is before it"},
    [CHILD_NO_POINTS] = {.says = "a part that is a point was left out: BOTH is both, and hits on "
                                 "the plane are in either"},
    [CHILD_LAST_PLACE] = {.says = "only where one place is left on the stack is it wrong: that is "
                                  "enough, as the near child takes none"},
    [CHILD_HAIR] = {.says =
                        "only the ends of the parts are wrong, by a hair: no epsilon is needed"},
};

// What near_side and children_on_ray say.
typedef struct Met {
    u32 side;
    int children;  // PLANE_ONLY_NEAR, PLANE_ONLY_FAR or PLANE_BOTH
    float t_split;
} Met;

static Met met_by_ray(const NextChildJob *job)
{
    const float t_split = (job->node.split_pos - job->origin) * job->inverse;
    const int is_ahead = t_split > 0 && t_split <= job->t_max;
    return (Met){job->origin > job->node.split_pos,
                 !is_ahead              ? PLANE_ONLY_NEAR
                 : t_split < job->t_min ? PLANE_ONLY_FAR
                                        : PLANE_BOTH,
                 t_split};
}

static NextChildAnswer expected_child(const NextChildJob *job, Met met, int mistake)
{
    const u32 first = mistake == CHILD_IS_SIDE ? 0 : job->node.first;
    const u32 side = mistake == CHILD_SWAPPED         ? !met.side
                     : mistake == CHILD_BY_DIRECTION  ? job->inverse < 0
                     : mistake == CHILD_LOWER_IS_NEAR ? 0
                                                      : met.side;
    TodoEntry near = {first + side, job->t_min, job->t_max};
    TodoEntry far = {first + !side, job->t_min, job->t_max};
    far.node = mistake == CHILD_XOR ? near.node ^ 1 : far.node;
    near.t_max = mistake == CHILD_ONLY_NEAR_CUT && met.children == PLANE_ONLY_NEAR
                     ? fminf(near.t_max, met.t_split)
                     : near.t_max;
    far.t_min = mistake == CHILD_ONLY_FAR_CUT ? met.t_split : far.t_min;
    NextChildAnswer answer = {near, job->todo};
    const int skips_near = met.children == PLANE_ONLY_FAR && mistake != CHILD_NEAR_NEVER_SKIPPED;
    if (met.children == PLANE_ONLY_NEAR) {
        if (mistake == CHILD_FAR_ALWAYS_WAITS) {
            push(&answer.todo, far);
        }
        return answer;
    }
    if (skips_near) {
        answer.next = mistake == CHILD_FAR_IS_NEAR ? near : far;
        return answer;
    }
    if (mistake == CHILD_NO_POINTS &&
        met.t_split == (met.t_split <= job->t_min ? job->t_min : job->t_max)) {
        answer.next = met.t_split <= job->t_min ? far : near;
        return answer;
    }
    near.t_max = mistake == CHILD_NEAR_KEEPS_T_MAX ? near.t_max : met.t_split;
    far.t_min = mistake == CHILD_FAR_KEEPS_T_MIN ? far.t_min : met.t_split;
    answer.next = mistake == CHILD_NEAR_WAITS ? far : near;
    if (mistake != CHILD_FAR_DROPPED) {
        push(&answer.todo, mistake == CHILD_NEAR_WAITS ? near : far);
    }
    return answer;
}

static int same_child(const NextChildAnswer *found, const NextChildAnswer *expected)
{
    return same_entry(found->next, expected->next) && same_stack(&found->todo, &expected->todo);
}

// Take the expected number for one a hair beside it.
static void drop_hair(float *found, float expected)
{
    *found = fabsf(*found - expected) < (float)HAIR ? expected : *found;
}

static int child_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const NextChildJob *job = &((const Job07 *)pointer)->inputs.children[i];
    const NextChildAnswer expected = expected_child(job, met_by_ray(job), mistake);
    NextChildAnswer found = ((const NextChildAnswer *)answers)[i];
    // In which part it waits, or where the near one's ends, has many ways to be wrong.
    if (mistake == CHILD_FAR_ALWAYS_WAITS && found.todo.n == expected.todo.n &&
        met_by_ray(job).children == PLANE_ONLY_NEAR) {
        const u32 top = expected.todo.n - expected.todo.n_lower - 1;
        return found.next.node == expected.next.node &&
               found.todo.upper[top].node == expected.todo.upper[top].node;
    }
    if (mistake == CHILD_LAST_PLACE && job->todo.n + 1 == TODO_SIZE) {
        return 1;
    }
    if (mistake == CHILD_HAIR) {
        drop_hair(&found.next.t_min, expected.next.t_min);
        drop_hair(&found.next.t_max, expected.next.t_max);
        for (int k = 0; k < STACK_ENTRIES; k++) {
            drop_hair(&found.todo.upper[k].t_min, expected.todo.upper[k].t_min);
            drop_hair(&found.todo.upper[k].t_max, expected.todo.upper[k].t_max);
        }
    }
    return same_child(&found, &expected);
}

static char *describe_child(const void *pointer, int i, const void *answers)
{
    const NextChildJob *job = &((const Job07 *)pointer)->inputs.children[i];
    const NextChildAnswer expected = expected_child(job, met_by_ray(job), 0);
    return message_new("children %u and %u, plane at %g, eye at %g, 1 / direction %g, part [%g, "
                       "%g]: found %s, expected %s",
                       job->node.first, job->node.first + 1, job->node.split_pos, job->origin,
                       job->inverse, job->t_min, job->t_max,
                       next_child_words(&job->todo, (const NextChildAnswer *)answers + i).text,
                       next_child_words(&job->todo, &expected).text);
}

const Function child_07 = {"next_child", 2 * N_CHILD_INPUTS, sizeof(NextChildAnswer),
                           COMPARED(child_agrees, describe_child, child_mistakes)};

// ---- Alone --------------------------------------------------------------------------------------

// What the stand-ins know on the device under the same names.
typedef unsigned int uint;
enum { ONLY_NEAR, ONLY_FAR, BOTH };
_Static_assert((int)ONLY_FAR == PLANE_ONLY_FAR && (int)BOTH == PLANE_BOTH, "the same numbers");

static uint stand_in_side(KdNode3 node, float origin, float inverse, uint LOT)
{
#include "07-kdtree-3d-trace/near_side.cl"
}

static int stand_in_children(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                             uint LOT, float *t_split)
{
#include "07-kdtree-3d-trace/children_on_ray.cl"
}

// Is next_child right wherever the ray meets one child, or both, as the stand-ins have it?
enum { ONE_MET = 1, BOTH_MET = 2 };
static int pass_children(const Job07 *job, int met, const Sections *answers)
{
    const NextChildAnswer *found = function_answers(&child_07, answers);
    const uint lot = job->job.lot;
    int passes = found != NULL;
    for (int i = 0; passes && i < COUNT(job->inputs.children); i++) {
        const NextChildJob *in = &job->inputs.children[i];
        Met said = {.side = stand_in_side(in->node, in->origin, in->inverse, lot)};
        said.children = stand_in_children(in->node, in->origin, in->inverse, in->t_min, in->t_max,
                                          lot, &said.t_split);
        const NextChildAnswer expected = expected_child(in, said, 0);
        const int is_asked = met & (said.children == BOTH ? BOTH_MET : ONE_MET);
        passes = !is_asked || same_child(&found[i], &expected);
    }
    return passes;
}

int one_child_alone_07(const void *job, const JudgeCheck *check, const Sections *answers)
{
    (void)check;
    return pass_children(job, ONE_MET, answers);
}

int both_children_alone_07(const void *job, const JudgeCheck *check, const Sections *answers)
{
    (void)check;
    return pass_children(job, BOTH_MET, answers);
}

int children_alone_07(const void *job, const JudgeCheck *check, const Sections *answers)
{
    (void)check;
    return pass_children(job, ONE_MET | BOTH_MET, answers);
}

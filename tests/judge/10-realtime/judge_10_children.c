// Lab 10's next_tile_child: its inputs, and what must come out. All numbers are quarters, or
// the least beside one, so that nothing is rounded: an answer is right or wrong to the bit.
#include "judge_10.h"

#include "job_stack.h"
#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Inputs -----------------------------------------------------------------------------------

// The interval in which the rays meet the plane: beyond their part or before it, or over one of its
// ends, both or none.
static void roll_split(Random *random, TileChildJob *job, int meets_both)
{
    const float t_min = job->at.t_min, t_max = job->at.t_max;
    const int n_inside = (int)(4 * (t_max - t_min));
    if (!meets_both && (t_min < 0.5f || one_in(random, 2))) {  // all beyond the part
        job->split_low = one_in(random, 4) ? INFINITY : t_max + random_quarters(random, 1, 16);
        job->split_high = one_in(random, 2) ? INFINITY : job->split_low + 1;
        return;
    }
    if (!meets_both) {  // all before it
        job->split_high = random_quarters(random, 1, (int)(4 * t_min) - 1);
        job->split_low = one_in(random, 2) ? 0 : job->split_high / 2;
        return;
    }
    job->split_low = one_in(random, 4)   ? t_max
                     : one_in(random, 3) ? t_min / 2
                                         : t_min + random_quarters(random, 0, n_inside);
    job->split_high = one_in(random, 4)   ? t_min
                      : one_in(random, 4) ? INFINITY
                      : one_in(random, 3) ? t_max + random_quarters(random, 1, 8)
                                          : t_min + random_quarters(random, 0, n_inside);
    if (job->split_high < job->split_low) {
        const float low = job->split_high;
        job->split_high = job->split_low;
        job->split_low = low;
    }
}

// The last of each range, in every job: the interval is the least beyond the part or before it, or
// just not. The last two have a point for a part.
static const TileChildJob child_edges[2][6] = {
    {{.split_low = 0x1.000002p+2f, .split_high = 8, .at = {1, 2, 4}},
     {.split_low = 0x1.000002p+2f, .split_high = INFINITY, .at = {1, 0, 4}},
     {.split_low = 1, .split_high = 0x1.fffffep+0f, .at = {1, 2, 4}},
     {.split_low = 0, .split_high = 0x1.fffffep+0f, .at = {1, 2, 4}},
     {.split_low = 0x1.000002p+2f, .split_high = 8, .at = {1, 4, 4}},
     {.split_low = 1, .split_high = 0x1.fffffep+1f, .at = {1, 4, 4}}},
    {{.split_low = 0x1.fffffep+1f, .split_high = 8, .at = {1, 2, 4}},
     {.split_low = 4, .split_high = 8, .at = {1, 2, 4}},
     {.split_low = 1, .split_high = 0x1.000002p+1f, .at = {1, 2, 4}},
     {.split_low = 1, .split_high = 2, .at = {1, 2, 4}},
     {.split_low = 4, .split_high = 4, .at = {1, 4, 4}},
     {.split_low = 2, .split_high = 8, .at = {1, 4, 4}}},
};

static void set_child_edge(const TileChildJob *edge, TileChildJob *job)
{
    job->split_low = edge->split_low;
    job->split_high = edge->split_high;
    job->at = edge->at;
}

static TileChildJob roll_child(Random *random, int meets_both)
{
    TileChildJob job = {.eye = random_quarters(random, -16, 16)};
    job.at.node = (u32)random_integer(random, 0, 2);
    job.at.t_min = one_in(random, 4) ? 0 : random_quarters(random, 1, 16);
    // A part may be a point: its equal ends meet what is exactly there.
    job.at.t_max = job.at.t_min + (one_in(random, 8) ? 0 : random_quarters(random, 1, 16));
    job.node.split_pos = one_in(random, 4) ? job.eye : random_quarters(random, -16, 16);
    job.node.split_axis = (u32)random_integer(random, 0, 2);
    job.node.first = (u32)random_integer(random, 3, 1000);
    job.todo = random_stack_with_room(random);
    roll_split(random, &job, meets_both);
    return job;
}

void roll_children_10(Random *random, Job10 *job)
{
    for (int i = 0; i < COUNT(job->children); i++) {
        job->children[i] = roll_child(random, i >= N_TILE_CHILD_INPUTS);
    }
    for (int range = 0; range < 2; range++) {
        for (int i = 0; i < COUNT(child_edges[range]); i++) {
            const int last = (range + 1) * N_TILE_CHILD_INPUTS - 1;
            set_child_edge(&child_edges[range][i], &job->children[last - i]);
        }
    }
}

// ---- Judging ----------------------------------------------------------------------------------

enum {
    CHILD_SWAPPED = 1,
    CHILD_LOWER_IS_NEAR,
    CHILD_EYE_IS_UPPER,
    CHILD_FAR_DROPPED,
    CHILD_NEAR_WAITS,
    CHILD_FAR_ALWAYS_WAITS,
    CHILD_NEAR_NEVER_SKIPPED,
    CHILD_FAR_IS_NEAR,
    CHILD_NEAR_KEEPS_T_MAX,
    CHILD_FAR_KEEPS_T_MIN,
    CHILD_NEAR_CUT_AT_LOW,
    CHILD_FAR_BEGINS_AT_HIGH,
    CHILD_FAR_WIDENED,
    CHILD_NEAR_WIDENED,
    CHILD_ONE_AT_ENDS,
    CHILD_OTHER_ENDS,
    CHILD_NEAR_FOR_ANY,
    CHILD_IS_SIDE,
    CHILD_NEAR_AT_T_MAX,
    CHILD_FAR_AT_T_MIN,
    CHILD_EPSILON,
    CHILD_SIBLING_BY_BIT,
    CHILD_FAR_ENDS,
    CHILD_FAR_FOR_ANY,
    CHILD_FAR_ALONE_WIDENED,
    CHILD_NEAR_ALONE_WIDENED,
    CHILD_FAR_BEGINS_AT_END,
    CHILD_NEVER_IS_NEAR,
    CHILD_FAR_CUT_TOO,
    CHILD_BOTH_WHOLE,
    CHILD_AT_0_IS_FAR,
    CHILD_POINT_IS_NEAR,
    CHILD_POINT_IS_FAR,
    CHILD_BOTH_WAIT,
    CHILD_PARTS_SWAPPED,
    CHILD_ENDS_CROSSED,
    CHILD_BOTH_WIDENED,
    CHILD_BOTH_ALWAYS,
    CHILD_BOTH_ALWAYS_WHOLE,
    CHILD_BOTH_ALWAYS_UNCUT,
};
#define ONE_IS_ENOUGH                                                                              \
    "that is as if both children were always visited: where t_split is beyond the whole part, or " \
    "before it, one of them is enough"

#define POINT_MEETS_BOTH                                                                           \
    "a part whose ends are equal counts, too: where t_split reaches over it both children are met"

#define FAR_BEGINS_LATE                                                                            \
    "the far child's part begins at the greatest t_split: rays that meet the plane earlier lose "  \
    "some of it"

static const Cause child_mistakes[] = {
    [CHILD_SWAPPED] = {.says = "that is as if near and far child were swapped"},
    [CHILD_LOWER_IS_NEAR] = {.says = "the near child is the one on the eye's side, not always the "
                                     "lower one"},
    [CHILD_EYE_IS_UPPER] = {.says = "an eye on the plane counts to the lower side"},
    [CHILD_FAR_DROPPED] =
        {"that is as if the far child were never visited where both are met: it does not wait",
         MISTAKE_FAR_CHILD},
    [CHILD_NEAR_WAITS] = {.says = "the near child waits, and the far one is visited first"},
    [CHILD_FAR_ALWAYS_WAITS] =
        {.says = "that is as if the far child waited also where every ray's part ends before the "
                 "plane"},
    [CHILD_NEAR_NEVER_SKIPPED] =
        {.says = "that is as if the near child were visited also where every ray's part begins "
                 "beyond the plane"},
    [CHILD_FAR_IS_NEAR] =
        {.says = "where every ray's part begins beyond the plane, the far child is left"},
    [CHILD_NEAR_KEEPS_T_MAX] =
        {.says = "the near child's part ends at the greatest t_split, where that is before t_max"},
    [CHILD_FAR_KEEPS_T_MIN] =
        {.says = "the far child's part begins at the least t_split, where that is beyond t_min"},
    [CHILD_NEAR_CUT_AT_LOW] = {.says = "the near child's part ends at the least t_split: rays that "
                                       "meet the plane later lose some of it"},
    [CHILD_FAR_BEGINS_AT_HIGH] = {.says = FAR_BEGINS_LATE},
    [CHILD_FAR_WIDENED] =
        {.says = "the far child's part begins before t_min: a part never grows on the way down"},
    [CHILD_NEAR_WIDENED] =
        {.says = "the near child's part ends beyond t_max: a part never grows on the way down"},
    [CHILD_ONE_AT_ENDS] = {.says = "where the plane is met exactly at t_min or t_max, both "
                                   "children are met"},
    [CHILD_NEAR_AT_T_MAX] = {.says = "where the first ray meets the plane exactly at t_max, both "
                                     "children are met"},
    [CHILD_FAR_AT_T_MIN] = {.says = "where the last ray meets the plane exactly at t_min, both "
                                    "children are met"},
    [CHILD_EPSILON] = {.says = "beyond t_max and before t_min one child is enough, however near: "
                               "without an epsilon"},
    [CHILD_SIBLING_BY_BIT] = {.says = "the two children are node.first and node.first + 1, where "
                                      "node.first is odd, too"},
    [CHILD_FAR_ENDS] = {.says = "the far child's part ends at t_max: behind the plane the rays are "
                                "in it up to there"},
    [CHILD_OTHER_ENDS] = {.says = "one child is enough only where that holds for every ray: the "
                                  "other end of the interval decides"},
    [CHILD_NEAR_FOR_ANY] = {.says = "where the interval reaches beyond t_max, some rays may still "
                                    "meet the plane before it"},
    [CHILD_FAR_FOR_ANY] = {.says = "where the interval begins before t_min, some rays may still "
                                   "meet the plane behind it"},
    [CHILD_FAR_ALONE_WIDENED] = {.says = "where the far child alone is met, the part stays as it "
                                         "is: it does not begin at the least t_split"},
    [CHILD_NEAR_ALONE_WIDENED] = {.says = "where the near child alone is met, the part stays as it "
                                          "is: it does not end at the greatest t_split"},
    [CHILD_FAR_BEGINS_AT_END] = {.says = FAR_BEGINS_LATE},
    [CHILD_NEVER_IS_NEAR] = {.says = "where some rays never meet the plane, others do: an interval "
                                     "that ends at INFINITY does not mean the near child alone"},
    [CHILD_FAR_CUT_TOO] = {.says = "the far child's part ends where the near one's does: t_max was "
                                   "changed before it was used again"},
    [CHILD_BOTH_WHOLE] = {.says = "both children have the whole part: the near one's ends at the "
                                  "greatest t_split, the far one's begins at the least"},
    [CHILD_AT_0_IS_FAR] = {.says = "a plane that is met at 0 is met: where the part begins at 0, "
                                   "so are both children"},
    [CHILD_POINT_IS_NEAR] = {.says = POINT_MEETS_BOTH},
    [CHILD_POINT_IS_FAR] = {.says = POINT_MEETS_BOTH},
    [CHILD_BOTH_WAIT] = {.says = "the near child is visited next, and must not wait as well"},
    [CHILD_PARTS_SWAPPED] = {.says = "the two parts are swapped: the near child has the one up to "
                                     "the greatest t_split, the far child the one from the least"},
    [CHILD_ENDS_CROSSED] = {.says = "t_min and t_max stand in each other's place in the two "
                                    "comparisons"},
    [CHILD_BOTH_WIDENED] = {.says = "the least and the greatest are swapped: a part never grows on "
                                    "the way down"},
    [CHILD_BOTH_ALWAYS] = {.says = ONE_IS_ENOUGH},
    [CHILD_BOTH_ALWAYS_WHOLE] = {.says = ONE_IS_ENOUGH},
    [CHILD_BOTH_ALWAYS_UNCUT] = {.says = ONE_IS_ENOUGH},
    [CHILD_IS_SIDE] =
        {.says = "0 and 1 are sides: the children's ids are node.first and node.first + 1"},
};

// A mistake may put two where there is room for one: the second is only counted.
static void push(StackState *todo, u32 node, float t_min, float t_max)
{
    const u32 at = todo->n++ - todo->n_lower;
    if (at < STACK_ENTRIES) {
        todo->upper[at] = (TodoEntry){node, t_min, t_max};
    }
}

// 0 for the lower child.
static u32 side_of(const TileChildJob *job, int mistake)
{
    const u32 side = mistake == CHILD_EYE_IS_UPPER ? job->eye >= job->node.split_pos
                                                   : job->eye > job->node.split_pos;
    return mistake == CHILD_LOWER_IS_NEAR ? 0 : mistake == CHILD_SWAPPED ? !side : side;
}

// More than the hairs of the edges, less than what is rolled.
#define LEAST_STEP 0x1p-10f

enum { NEAR_ONLY, FAR_ONLY, BOTH_CHILDREN };
static int children_met(const TileChildJob *job, int mistake)
{
    const float t_min = job->at.t_min, t_max = job->at.t_max;
    const int others = mistake == CHILD_OTHER_ENDS, ends = mistake == CHILD_ONE_AT_ENDS;
    const float beyond = others || mistake == CHILD_NEAR_FOR_ANY ? job->split_high : job->split_low;
    const float before = others || mistake == CHILD_FAR_FOR_ANY ? job->split_low : job->split_high;
    const float hair = mistake == CHILD_EPSILON ? LEAST_STEP : 0;
    const float end = mistake == CHILD_ENDS_CROSSED ? t_min : t_max;
    const float begin = mistake == CHILD_ENDS_CROSSED ? t_max : t_min;
    const int near_at_end = ends || mistake == CHILD_NEAR_AT_T_MAX;
    const int far_at_end = ends || mistake == CHILD_FAR_AT_T_MIN;
    if (mistake >= CHILD_BOTH_ALWAYS) {
        return BOTH_CHILDREN;
    }
    if (mistake == CHILD_NEVER_IS_NEAR && isinf(job->split_high)) {
        return NEAR_ONLY;
    }
    if (mistake == CHILD_AT_0_IS_FAR && job->split_high == 0) {
        return FAR_ONLY;
    }
    if (mistake != CHILD_FAR_ALWAYS_WAITS &&
        (beyond > end + hair || (near_at_end && beyond == end))) {
        return NEAR_ONLY;
    }
    if (mistake != CHILD_NEAR_NEVER_SKIPPED &&
        (before < begin - hair || (far_at_end && before == begin))) {
        return mistake == CHILD_FAR_IS_NEAR ? NEAR_ONLY : FAR_ONLY;
    }
    if (t_min == t_max && (mistake == CHILD_POINT_IS_NEAR || mistake == CHILD_POINT_IS_FAR)) {
        return mistake == CHILD_POINT_IS_NEAR ? NEAR_ONLY : FAR_ONLY;
    }
    return BOTH_CHILDREN;
}

static NextChildAnswer expected_child(const TileChildJob *job, int mistake)
{
    const u32 side = side_of(job, mistake), first = mistake == CHILD_IS_SIDE ? 0 : job->node.first;
    const float t_min = job->at.t_min, t_max = job->at.t_max;
    const float end = mistake == CHILD_NEAR_CUT_AT_LOW ? job->split_low : job->split_high;
    const float begin = mistake == CHILD_FAR_BEGINS_AT_HIGH  ? job->split_high
                        : mistake == CHILD_FAR_BEGINS_AT_END ? fminf(t_max, job->split_high)
                                                             : job->split_low;
    const int met = children_met(job, mistake);
    const u32 far = mistake == CHILD_SIBLING_BY_BIT ? (first + side) ^ 1 : first + !side;
    NextChildAnswer answer = {.todo = job->todo};
    if (met != BOTH_CHILDREN) {
        answer.next = (TodoEntry){met == NEAR_ONLY ? first + side : far, t_min, t_max};
        if (met == FAR_ONLY && mistake == CHILD_FAR_ALONE_WIDENED) {
            answer.next.t_min = job->split_low;
        }
        if (met == NEAR_ONLY && mistake == CHILD_NEAR_ALONE_WIDENED) {
            answer.next.t_max = job->split_high;
        }
        return answer;
    }
    const int both_whole = mistake == CHILD_BOTH_WHOLE || mistake == CHILD_BOTH_ALWAYS_WHOLE;
    const int both_uncut = mistake == CHILD_BOTH_ALWAYS_UNCUT;
    TodoEntry near_child = {first + side, t_min,
                            both_whole || mistake == CHILD_NEAR_KEEPS_T_MAX ? t_max
                            : both_uncut || mistake == CHILD_NEAR_WIDENED   ? end
                            : mistake == CHILD_BOTH_WIDENED                 ? fmaxf(t_max, end)
                                                                            : fminf(t_max, end)};
    TodoEntry far_child = {far,
                           both_whole || mistake == CHILD_FAR_KEEPS_T_MIN ? t_min
                           : both_uncut || mistake == CHILD_FAR_WIDENED   ? begin
                           : mistake == CHILD_BOTH_WIDENED                ? fminf(t_min, begin)
                                                                          : fmaxf(t_min, begin),
                           mistake == CHILD_FAR_ENDS      ? end
                           : mistake == CHILD_FAR_CUT_TOO ? near_child.t_max
                                                          : t_max};
    if (mistake == CHILD_PARTS_SWAPPED) {
        near_child = (TodoEntry){first + side, far_child.t_min, far_child.t_max};
        far_child = (TodoEntry){far, t_min, fminf(t_max, end)};
    }
    if (mistake == CHILD_BOTH_WAIT) {
        push(&answer.todo, far_child.node, far_child.t_min, far_child.t_max);
        far_child = near_child;
    }
    const int is_swapped = mistake == CHILD_NEAR_WAITS;
    answer.next = is_swapped ? far_child : near_child;
    if (mistake != CHILD_FAR_DROPPED) {
        const TodoEntry waits = is_swapped ? near_child : far_child;
        push(&answer.todo, waits.node, waits.t_min, waits.t_max);
    }
    return answer;
}

static int child_agrees(const void *job, int i, const void *answers, int mistake)
{
    const NextChildAnswer *found = (const NextChildAnswer *)answers + i;
    const NextChildAnswer expected = expected_child(&((const Job10 *)job)->children[i], mistake);
    return same_entry(found->next, expected.next) && same_stack(&found->todo, &expected.todo);
}

static char *describe_child(const void *pointer, int i, const void *answers)
{
    const TileChildJob *job = &((const Job10 *)pointer)->children[i];
    const NextChildAnswer expected = expected_child(job, 0);
    return message_new("children %u and %u, plane at %g, eye at %g, t_split [%.9g, %.9g], part "
                       "[%g, %g]: found %s, expected %s",
                       job->node.first, job->node.first + 1, job->node.split_pos, job->eye,
                       job->split_low, job->split_high, job->at.t_min, job->at.t_max,
                       next_child_words(&job->todo, (const NextChildAnswer *)answers + i).text,
                       next_child_words(&job->todo, &expected).text);
}

const Function tile_child_10 = {"tile_children", N_TILE_CHILDREN, sizeof(NextChildAnswer),
                                COMPARED(child_agrees, describe_child, child_mistakes)};

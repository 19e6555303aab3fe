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
    job.node.first = (u32)random_integer(random, 3, one_in(random, 2) ? 1000 : 100000);
    job.todo = random_stack_with_room(random);
    roll_split(random, &job, meets_both);
    // Scenes are of any size: a power of two rounds nothing.
    const float factor = one_in(random, 2) ? 1 : ldexpf(1, (int)random_integer(random, -6, 10));
    job.at.t_min *= factor, job.at.t_max *= factor;
    job.split_low *= factor, job.split_high *= factor;
    stack_scale(&job.todo, factor);
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

#define GIVEN                                                                                      \
    const TileChildJob *in = &((const Job10 *)job)->children[i];                                   \
    const NextChildAnswer *found = (const NextChildAnswer *)answers + i
#define IS_FOUND(expected) is_same(found, expected)

static int is_same(const NextChildAnswer *found, NextChildAnswer expected)
{
    return same_entry(found->next, expected.next) && same_stack(&found->todo, &expected.todo);
}

// ---- Right --------------------------------------------------------------------------------------

enum { NEAR_ONLY, FAR_ONLY, BOTH_CHILDREN };

static int met(int is_beyond, int is_before)
{
    return is_beyond ? NEAR_ONLY : is_before ? FAR_ONLY : BOTH_CHILDREN;
}

// A mistake may put two where there is room for one: the second is only counted.
static NextChildAnswer with_waiting(NextChildAnswer answer, TodoEntry waits)
{
    const u32 at = answer.todo.n++ - answer.todo.n_lower;
    if (at < STACK_ENTRIES) {
        answer.todo.upper[at] = waits;
    }
    return answer;
}

static NextChildAnswer visited(const TileChildJob *in, int children, TodoEntry near, TodoEntry far)
{
    const NextChildAnswer answer = {children == FAR_ONLY ? far : near, in->todo};
    return children == BOTH_CHILDREN ? with_waiting(answer, far) : answer;
}

static int right_met(const TileChildJob *in)
{
    return met(in->split_low > in->at.t_max, in->split_high < in->at.t_min);
}

// The near child lies to this side; these are met.
static NextChildAnswer child(const TileChildJob *in, u32 side, int children)
{
    const int is_cut = children == BOTH_CHILDREN;
    const float t_min = in->at.t_min, t_max = in->at.t_max;
    const float near_ends = is_cut ? fminf(t_max, in->split_high) : t_max;
    const float far_begins = is_cut ? fmaxf(t_min, in->split_low) : t_min;
    return visited(in, children, (TodoEntry){in->node.first + side, t_min, near_ends},
                   (TodoEntry){in->node.first + !side, far_begins, t_max});
}

static u32 side_of(const TileChildJob *in)
{
    return in->eye > in->node.split_pos;
}

static NextChildAnswer right_child(const TileChildJob *in)
{
    return child(in, side_of(in), right_met(in));
}

RIGHT(is_right, IS_FOUND(right_child(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// By which child is near, and their ids.
static NextChildAnswer with_ids(const TileChildJob *in, u32 near, u32 far)
{
    NextChildAnswer answer = right_child(in);
    answer.next.node = right_met(in) == FAR_ONLY ? far : near;
    if (right_met(in) == BOTH_CHILDREN) {
        answer.todo.upper[in->todo.n - in->todo.n_lower].node = far;
    }
    return answer;
}

// By which of them are met. A step is more than the hairs of the edges, less than what is rolled.
#define LEAST_STEP 0x1p-10f
#define MEETS(name, is_beyond, is_before, ...)                                                     \
    ANSWERS(name, child(in, side, met(is_beyond, is_before)), __VA_ARGS__)

// By their parts.
static TodoEntry near_to(const TileChildJob *in, float t_max)
{
    return (TodoEntry){in->node.first + side_of(in), in->at.t_min, t_max};
}

static TodoEntry far_from(const TileChildJob *in, float t_min)
{
    return (TodoEntry){in->node.first + !side_of(in), t_min, in->at.t_max};
}

// Other parts where both are met.
static NextChildAnswer parted(const TileChildJob *in, TodoEntry near, TodoEntry far)
{
    return right_met(in) == BOTH_CHILDREN ? visited(in, right_met(in), near, far) : right_child(in);
}

#define PARTS(name, near, far, ...) ANSWERS(name, parted(in, near, far), __VA_ARGS__)

static TodoEntry with_ends(TodoEntry entry, float t_min, float t_max)
{
    return (TodoEntry){entry.node, t_min, t_max};
}

// What is added to node.first: the side, the other one, always the same, too much, too little, or
// by an eye on the plane that counts to the upper side.
static u32 child_by(const TileChildJob *in, u32 added, int way)
{
    const u32 on_plane = in->eye == in->node.split_pos;
    const u32 by[] = {added, !added, 0, 1, 2 * added, -added, added ^ on_plane};
    return in->node.first + by[way];
}

static int compares(float a, float b, int way)
{
    return way == 0 ? a > b : way == 1 ? a >= b : way == 2 ? a < b : a <= b;
}

// A part that is another: two of all ends that there are, of one child or the other.
enum { N_ENDS = 8, N_PARTS = 2 * N_ENDS * N_ENDS };
static TodoEntry part_by(const TileChildJob *in, u32 side, int way)
{
    const float ends[N_ENDS] = {in->at.t_min,
                                in->at.t_max,
                                in->split_low,
                                in->split_high,
                                fminf(in->at.t_max, in->split_high),
                                fmaxf(in->at.t_min, in->split_low),
                                fminf(in->at.t_min, in->split_low),
                                fmaxf(in->at.t_max, in->split_high)};
    return (TodoEntry){in->node.first + (side ^ (u32)way / (N_ENDS * N_ENDS)),
                       ends[way / N_ENDS % N_ENDS], ends[way % N_ENDS]};
}

static NextChildAnswer one_by(const TileChildJob *in, int children, int way)
{
    const TodoEntry part = part_by(in, children == FAR_ONLY ? !side_of(in) : side_of(in), way);
    return right_met(in) == children ? visited(in, right_met(in), part, part) : right_child(in);
}

KNOWN_LIST(known)
{
    GIVEN;
    const float t_min = in->at.t_min, t_max = in->at.t_max;
    const float low = in->split_low, high = in->split_high;
    const int is_beyond = low > t_max, is_before = high < t_min, children = right_met(in);
    const u32 side = side_of(in);
    const TodoEntry near = near_to(in, fminf(t_max, high)), far = far_from(in, fmaxf(t_min, low));
    const NextChildAnswer right = right_child(in);

    ANSWERS(swapped, child(in, !side, children), "that is as if near and far child were swapped");
    ANSWERS(lower_is_near, child(in, 0, children),
            "the near child is the one on the eye's side, not always the lower one");
    ANSWERS(eye_is_upper, child(in, in->eye >= in->node.split_pos, children),
            "an eye on the plane counts to the lower side");
    ANSWERS(is_side, with_ids(in, side, !side),
            "0 and 1 are sides: the children's ids are node.first and node.first + 1");
    ANSWERS(by_bit, with_ids(in, in->node.first + side, (in->node.first + side) ^ 1),
            "the two children are node.first and node.first + 1, where node.first is odd, too");
    MEETS(always_waits, 0, is_before,
          "that is as if the far child waited also where every ray's part ends before the plane");
    MEETS(never_skipped, is_beyond, 0,
          "that is as if the near child were visited also where every ray's part begins beyond the "
          "plane");
    MEETS(far_is_near, is_beyond || is_before, 0,
          "where every ray's part begins beyond the plane, the far child is left");
    MEETS(one_at_ends, low >= t_max, high <= t_min,
          "where the plane is met exactly at t_min or t_max, both children are met");
    MEETS(near_at_t_max, low >= t_max, is_before,
          "where the first ray meets the plane exactly at t_max, both children are met");
    MEETS(far_at_t_min, is_beyond, high <= t_min,
          "where the last ray meets the plane exactly at t_min, both children are met");
    MEETS(other_ends, high > t_max, low < t_min,
          "one child is enough only where that holds for every ray: the other end of the interval "
          "decides");
    MEETS(near_for_any, high > t_max, is_before,
          "where the interval reaches beyond t_max, some rays may still meet the plane before it");
    MEETS(far_for_any, is_beyond, low < t_min,
          "where the interval begins before t_min, some rays may still meet the plane behind it");
    MEETS(epsilon, low > t_max + LEAST_STEP, high < t_min - LEAST_STEP,
          "beyond t_max and before t_min one child is enough, however near: without an epsilon");
    MEETS(never_is_near, is_beyond || isinf(high), is_before,
          "where some rays never meet the plane, others do: an interval that ends at INFINITY does "
          "not mean the near child alone");
    MEETS(at_0_is_far, is_beyond, is_before || high == 0,
          "a plane that is met at 0 is met: where the part begins at 0, so are both children");
    MEETS(ends_crossed, low > t_min, high < t_max,
          "t_min and t_max stand in each other's place in the two comparisons");

#define POINT_MEETS_BOTH                                                                           \
    "a part whose ends are equal counts, too: where t_split reaches over it both children are met"
    MEETS(point_is_near, is_beyond || (t_min == t_max && !is_before), is_before, POINT_MEETS_BOTH);
    MEETS(point_is_far, is_beyond, is_before || t_min == t_max, POINT_MEETS_BOTH);

    PARTS(near_waits, far, near, "the near child waits, and the far one is visited first");
    PARTS(near_keeps_t_max, near_to(in, t_max), far,
          "the near child's part ends at the greatest t_split, where that is before t_max");
    PARTS(far_keeps_t_min, near, far_from(in, t_min),
          "the far child's part begins at the least t_split, where that is beyond t_min");
    PARTS(near_cut_at_low, near_to(in, fminf(t_max, low)), far,
          "the near child's part ends at the least t_split: rays that meet the plane later lose "
          "some of it");
    PARTS(near_widened, near_to(in, high), far,
          "the near child's part ends beyond t_max: a part never grows on the way down");
    PARTS(far_widened, near, far_from(in, low),
          "the far child's part begins before t_min: a part never grows on the way down");
    PARTS(both_uncut, near_to(in, high), far_from(in, low),
          "both parts are wider than the node's own, [t_min, t_max]: a part never grows on the way "
          "down");
    PARTS(both_whole, near_to(in, t_max), far_from(in, t_min),
          "both children have the whole part: the near one's ends at the greatest t_split, the far "
          "one's begins at the least");
    PARTS(both_widened, near_to(in, fmaxf(t_max, high)), far_from(in, fminf(t_min, low)),
          "the least and the greatest are swapped: a part never grows on the way down");
    PARTS(far_ends, near, with_ends(far, far.t_min, high),
          "the far child's part ends at t_max: behind the plane the rays are in it up to there");
    PARTS(far_cut_too, near, with_ends(far, far.t_min, near.t_max),
          "the far child's part ends where the near one's does: t_max was changed before it was "
          "used again");
    PARTS(parts_swapped, with_ends(near, far.t_min, t_max), with_ends(far, t_min, near.t_max),
          "the two parts are swapped: the near child has the one up to the greatest t_split, the "
          "far child the one from the least");

#define FAR_BEGINS_LATE                                                                            \
    "the far child's part begins at the greatest t_split: rays that meet the plane earlier lose "  \
    "some of it"
    PARTS(far_from_high, near, far_from(in, fmaxf(t_min, high)), FAR_BEGINS_LATE);
    PARTS(far_from_end, near, far_from(in, fmaxf(t_min, fminf(t_max, high))), FAR_BEGINS_LATE);

    PARTS(parts_crossed, near_to(in, fminf(t_max, low)), far_from(in, fmaxf(t_min, high)),
          "the least and the greatest t_split are swapped: the near child's part ends at the "
          "greatest, the far child's begins at the least");

#define ONE_IS_ENOUGH                                                                              \
    "that is as if both children were always visited: where t_split is beyond the whole part, or " \
    "before it, one of them is enough"
    MEETS(both_always, 0, 0, ONE_IS_ENOUGH);
    ANSWERS(always_whole, visited(in, BOTH_CHILDREN, near_to(in, t_max), far_from(in, t_min)),
            ONE_IS_ENOUGH);
    ANSWERS(always_uncut, visited(in, BOTH_CHILDREN, near_to(in, high), far_from(in, low)),
            ONE_IS_ENOUGH);

    ANSWERS(far_alone,
            children == FAR_ONLY ? visited(in, children, near, far_from(in, low)) : right,
            "where the far child alone is met, the part stays as it is: it does not begin at the "
            "least t_split");
    ANSWERS(near_alone,
            children == NEAR_ONLY ? visited(in, children, near_to(in, high), far) : right,
            "where the near child alone is met, the part stays as it is: it does not end at the "
            "greatest t_split");

    // By what waits.
    ANSWERS(far_dropped, ((NextChildAnswer){right.next, in->todo}),
            "that is as if the far child were never visited where both are met: it does not wait",
            MISTAKE_FAR_CHILD);
    ANSWERS(both_wait, children == BOTH_CHILDREN ? with_waiting(right, near) : right,
            "the near child is visited next, and must not wait as well");

    ANY(one_child, 49,
        IS_FOUND(with_ids(in, child_by(in, side, way % 7), child_by(in, !side, way / 7))),
        "near and far child are not the two: the near one is on the eye's side, the far one is the "
        "other");
    ANY(other_beyond, 16,
        IS_FOUND(child(
            in, side,
            met(compares(way & 1 ? high : low, way & 2 ? t_min : t_max, way >> 2), is_before))),
        "the near child alone is visited if the least t_split is beyond t_max: something else is "
        "compared");
    ANY(other_before, 16,
        IS_FOUND(child(
            in, side,
            met(is_beyond, compares(way & 1 ? high : low, way & 2 ? t_min : t_max, way >> 2)))),
        "the far child alone is visited if the greatest t_split is before t_min: something else is "
        "compared");

#define BOTH_PARTS                                                                                 \
    "where both children are met the near one's part ends at the greatest t_split, the far one's " \
    "begins at the least, and neither grows: child or part is another"
#define WHOLE_PART "where one child alone is met it gets the whole part: child or part is another"
    ANY(near_part, N_PARTS, IS_FOUND(parted(in, part_by(in, side, way), far)), BOTH_PARTS);
    ANY(far_part, N_PARTS, IS_FOUND(parted(in, near, part_by(in, !side, way))), BOTH_PARTS);
    ANY(only_near_part, N_PARTS, IS_FOUND(one_by(in, NEAR_ONLY, way)), WHOLE_PART);
    ANY(only_far_part, N_PARTS, IS_FOUND(one_by(in, FAR_ONLY, way)), WHOLE_PART);
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const NextChildAnswer expected = right_child(in);
    return message_new("children %u and %u, plane at %g, eye at %g, t_split [%.9g, %.9g], part "
                       "[%g, %g]: your code goes on with %s, expected %s",
                       in->node.first, in->node.first + 1, in->node.split_pos, in->eye,
                       in->split_low, in->split_high, in->at.t_min, in->at.t_max,
                       next_child_words(&in->todo, found).text,
                       next_child_words(&in->todo, &expected).text);
}

const Function tile_child_10 = {"tile_children", N_TILE_CHILDREN, sizeof(NextChildAnswer),
                                KNOWING(is_right, describe, known)};

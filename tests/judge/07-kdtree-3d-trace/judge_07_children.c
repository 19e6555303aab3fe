// Lab 07's next_child: its inputs, and what must come out. It is tried alone beside stubs of
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

// Make all distances `factor` times as long, a power of two, by a direction that is as short.
static void scale(NextChildJob *job, float factor)
{
    job->inverse *= factor;
    job->t_min *= factor;
    job->t_max *= factor;
    stack_scale(&job->todo, factor);
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
    job.node.first = (u32)random_integer(random, 3, one_in(random, 2) ? 1000 : 100000);
    job.todo = random_stack_with_room(random);
    stack_begin_at(&job.todo, job.t_max);
    scale(&job, (float)(1 << (one_in(random, 2) ? random_integer(random, 1, 10) : 0)));
    return job;
}

void roll_child_inputs_07(Random *random, Inputs07 *inputs)
{
    for (int i = 0; i < COUNT(inputs->children); i++) {
        inputs->children[i] = roll_child(random, i >= N_CHILD_INPUTS);
    }
}

#define GIVEN                                                                                      \
    const NextChildJob *in = &((const Job07 *)job)->inputs.children[i];                            \
    const NextChildAnswer *found = (const NextChildAnswer *)answers + i
#define IS_FOUND(expected) same_child(*found, expected)

static int same_child(NextChildAnswer found, NextChildAnswer expected)
{
    return same_entry(found.next, expected.next) && same_stack(&found.todo, &expected.todo);
}

// ---- Stubs ----------------------------------------------------------------------------------

// What the stubs know on the device under the same names.
typedef unsigned int uint;
enum { ONLY_NEAR, ONLY_FAR, BOTH };
_Static_assert((int)ONLY_FAR == PLANE_ONLY_FAR && (int)BOTH == PLANE_BOTH, "the same numbers");

static uint stub_side(KdNode3 node, float origin, float inverse, uint NONCE)
{
#include "07-kdtree-3d-trace/near_side.cl"
}

static int stub_children(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                         uint NONCE, float *t_split)
{
#include "07-kdtree-3d-trace/children_on_ray.cl"
}

// ---- Right --------------------------------------------------------------------------------------

// What near_side and children_on_ray say.
typedef struct Met {
    u32 side;
    int children;  // PLANE_ONLY_NEAR, PLANE_ONLY_FAR or PLANE_BOTH
    float t_split;
} Met;

static Met met_by_ray(const NextChildJob *in)
{
    const float t_split = (in->node.split_pos - in->origin) * in->inverse;
    const int is_ahead = t_split > 0 && t_split <= in->t_max;
    return (Met){in->origin > in->node.split_pos ||
                     (in->origin == in->node.split_pos && in->inverse > 0),
                 !is_ahead             ? PLANE_ONLY_NEAR
                 : t_split < in->t_min ? PLANE_ONLY_FAR
                                       : PLANE_BOTH,
                 t_split};
}

static Met met_by_chance(const NextChildJob *in, uint nonce)
{
    Met met = {.side = stub_side(in->node, in->origin, in->inverse, nonce)};
    met.children =
        stub_children(in->node, in->origin, in->inverse, in->t_min, in->t_max, nonce, &met.t_split);
    return met;
}

// As the other two tasks say, or their stubs.
static Met met_by(const Job *job, const NextChildJob *in)
{
    return job->is_alone ? met_by_chance(in, job->nonce) : met_by_ray(in);
}

// The children, and where the ray is in them.
typedef struct Parts {
    TodoEntry near, far;
} Parts;

static Parts parts_of(const NextChildJob *in, Met met)
{
    const int is_cut = met.children == PLANE_BOTH;
    const u32 first = in->node.first;
    return (Parts){{first + met.side, in->t_min, is_cut ? met.t_split : in->t_max},
                   {first + !met.side, is_cut ? met.t_split : in->t_min, in->t_max}};
}

static NextChildAnswer visited(const NextChildJob *in, Met met, Parts parts)
{
    NextChildAnswer answer = {met.children == PLANE_ONLY_FAR ? parts.far : parts.near, in->todo};
    if (met.children == PLANE_BOTH) {
        answer.todo.upper[answer.todo.n++ - answer.todo.n_lower] = parts.far;
    }
    return answer;
}

static NextChildAnswer child(const NextChildJob *in, Met met)
{
    return visited(in, met, parts_of(in, met));
}

RIGHT(is_right, IS_FOUND(child(in, met_by(job, in))))

// ---- Mistakes -----------------------------------------------------------------------------------

// By which child is near, and which of them are met.
static Met with_other(Met met, int children, int other)
{
    met.children = met.children == children ? other : met.children;
    return met;
}

// Parts that are points are left out.
static Met without_points(const NextChildJob *in, Met met)
{
    return met.t_split <= in->t_min   ? with_other(met, PLANE_BOTH, PLANE_ONLY_FAR)
           : met.t_split == in->t_max ? with_other(met, PLANE_BOTH, PLANE_ONLY_NEAR)
                                      : met;
}

static NextChildAnswer from_side(const Job *job, const NextChildJob *in, u32 side)
{
    return child(in, (Met){side, met_by(job, in).children, met_by(job, in).t_split});
}

// By what waits, and which parts they have.
static Parts swapped_if_both(Met met, Parts parts)
{
    return met.children == PLANE_BOTH ? (Parts){parts.far, parts.near} : parts;
}

static Parts with_ids(Parts parts, u32 near, u32 far)
{
    parts.near.node = near;
    parts.far.node = far;
    return parts;
}

static Parts with_ends(Parts parts, float near_t_max, float far_t_min)
{
    parts.near.t_max = near_t_max;
    parts.far.t_min = far_t_min;
    return parts;
}

static NextChildAnswer going_to(NextChildAnswer answer, u32 node)
{
    answer.next.node = node;
    return answer;
}

// In which part it waits, or where the near one's ends, has many ways to be wrong.
static int waits_always(const Job *job, const NextChildJob *in, const NextChildAnswer *found)
{
    const u32 top = in->todo.n - in->todo.n_lower;
    return met_by(job, in).children == PLANE_ONLY_NEAR
               ? found->todo.n == in->todo.n + 1 &&
                     found->next.node == parts_of(in, met_by(job, in)).near.node &&
                     found->todo.upper[top].node == parts_of(in, met_by(job, in)).far.node
               : IS_FOUND(child(in, met_by(job, in)));
}

// What is added to node.first: for the near child `side`, for the far one the other of 0 and 1.
static u32 child_by(const NextChildJob *in, u32 added, int way)
{
    const u32 by[] = {added, !added, 0, 1, 2 * added, -added};
    return in->node.first + by[way];
}

// A part that is another: of t_min, t_max and t_split two, of one child or the other.
static float end_of(const NextChildJob *in, float t_split, int k)
{
    return k == 0 ? in->t_min : k == 1 ? in->t_max : t_split;
}

enum { N_PARTS = 2 * 9 };
static Parts part_by(const NextChildJob *in, Met met, int is_asked, int is_far, int way)
{
    Parts parts = parts_of(in, met);
    if (is_asked) {
        TodoEntry *part = is_far ? &parts.far : &parts.near;
        part->node ^= way / 9 == 0 ? 0 : parts.near.node ^ parts.far.node;
        part->t_min = end_of(in, met.t_split, way / 3 % 3);
        part->t_max = end_of(in, met.t_split, way % 3);
    }
    return parts;
}

// The arguments in another order: two neighbours have changed places.
static NextChildJob reordered(const NextChildJob *in, int way)
{
    const float of[] = {in->origin, in->inverse, in->t_min, in->t_max};
    NextChildJob job = *in;
    float *const to[] = {&job.origin, &job.inverse, &job.t_min, &job.t_max};
    for (int k = 0; k < 4; k++) {
        *to[k] = of[k == way ? k + 1 : k == way + 1 ? k - 1 : k];
    }
    return job;
}

static Met with_side_of(const Job *job, const NextChildJob *in, NextChildJob other)
{
    Met met = met_by(job, in);
    met.side = met_by(job, &other).side;
    return met;
}

static Met with_children_of(const Job *job, const NextChildJob *in, NextChildJob other)
{
    Met met = met_by(job, &other);
    met.side = met_by(job, in).side;
    return met;
}

// Take the expected number for one a hair beside it.
static TodoEntry without_hair(TodoEntry found, TodoEntry expected)
{
    found.t_min = fabsf(found.t_min - expected.t_min) < (float)HAIR ? expected.t_min : found.t_min;
    found.t_max = fabsf(found.t_max - expected.t_max) < (float)HAIR ? expected.t_max : found.t_max;
    return found;
}

static int is_hair_beside(NextChildAnswer found, NextChildAnswer expected)
{
    found.next = without_hair(found.next, expected.next);
    for (int k = 0; k < STACK_ENTRIES; k++) {
        found.todo.upper[k] = without_hair(found.todo.upper[k], expected.todo.upper[k]);
    }
    return same_child(found, expected);
}

KNOWN_LIST(known)
{
    GIVEN;
    const Met met = met_by(job, in);
    const Parts parts = parts_of(in, met);
    const NextChildAnswer right = child(in, met);

    ANSWERS(swapped, from_side(job, in, !met.side),
            "that is as if near and far child were swapped");
    ANSWERS(by_direction, from_side(job, in, in->inverse < 0),
            "that is as if the direction decided which child is near: the eye's side does, which "
            "near_side() tells");
    ANSWERS(lower_is_near, from_side(job, in, 0),
            "the lower child was taken for the near one, wherever the eye is");
    ANSWERS(far_is_near, child(in, with_other(met, PLANE_ONLY_FAR, PLANE_ONLY_NEAR)),
            "that is as if the search went to the near child where only the far one is met");
    ANSWERS(never_skipped, child(in, with_other(met, PLANE_ONLY_FAR, PLANE_BOTH)),
            "that is as if the near child were visited also where only the far one is met");
    ANSWERS(
        no_points, child(in, without_points(in, met)),
        "a part that is a point was left out: BOTH is both, and hits on the plane are in either");

    ANSWERS(far_dropped, ((NextChildAnswer){right.next, in->todo}),
            "that is as if the far child were never visited where both are met: it does not wait",
            MISTAKE_FAR_CHILD);
    ANSWERS(near_waits, visited(in, met, swapped_if_both(met, parts)),
            "the near child waits, and the far one is visited first");
    ANSWERS(parts_swapped,
            visited(in, met,
                    (Parts){{parts.near.node, parts.far.t_min, parts.far.t_max},
                            {parts.far.node, parts.near.t_min, parts.near.t_max}}),
            "the two parts are swapped: the near child has the one up to t_split, the far child "
            "the one from there on");
    ANSWERS(keeps_t_max, visited(in, met, with_ends(parts, in->t_max, parts.far.t_min)),
            "that is as if t_max did not become t_split for the near child");
    ANSWERS(
        keeps_t_min, visited(in, met, with_ends(parts, parts.near.t_max, in->t_min)),
        "that is as if t_min did not become t_split for the far child, which begins at t_split");
    EACH(always_waits, waits_always(job, in, found),
         "that is as if the far child waited also where only the near one is met");
    ANSWERS(is_side, visited(in, met, with_ids(parts, met.side, !met.side)),
            "0 and 1 are sides: the children's ids are node.first and node.first + 1");
    ANSWERS(goes_to_side, going_to(right, right.next.node - in->node.first),
            "that is a side and no id: the children's ids are node.first and node.first + 1");
    ANSWERS(by_bit, visited(in, met, with_ids(parts, parts.near.node, parts.near.node ^ 1)),
            "the other child's id is not the near one's with its lowest bit turned: node.first may "
            "be odd");
    ANSWERS(
        near_cut,
        visited(in, met, with_ends(parts, fminf(parts.near.t_max, met.t_split), parts.far.t_min)),
        "where only the near child is met the part stays as it is: t_split is not in it");
    ANSWERS(far_cut, visited(in, met, with_ends(parts, parts.near.t_max, met.t_split)),
            "where only the far child is met the part stays as it is: t_split is before it");

    ANSWERS(both_cut, visited(in, met, with_ends(parts, met.t_split, met.t_split)),
            "where only one child is met the part stays as it is: it is cut where both are");
    ANSWERS(near_cut_any, visited(in, met, with_ends(parts, met.t_split, parts.far.t_min)),
            "where only the near child is met the part stays as it is: t_split is not in it");

    ANY(one_child, 36,
        IS_FOUND(visited(
            in, met,
            with_ids(parts, child_by(in, met.side, way % 6), child_by(in, !met.side, way / 6)))),
        "near and far child are not the two: the near one is on the side that near_side() tells, "
        "the far one is the other");
#define BOTH_PARTS                                                                                 \
    "where both children are met the near one gets the part from t_min to t_split, the far one "   \
    "that from t_split to t_max: child or part is another"
    ANY(near_part, N_PARTS,
        IS_FOUND(visited(in, met, part_by(in, met, met.children == PLANE_BOTH, 0, way))),
        BOTH_PARTS);
    ANY(far_part, N_PARTS,
        IS_FOUND(visited(in, met, part_by(in, met, met.children == PLANE_BOTH, 1, way))),
        BOTH_PARTS);
#define WHOLE_PART                                                                                 \
    "where only one child is met it gets the whole part, from t_min to t_max: child or part is "   \
    "another"
    ANY(only_near_part, N_PARTS,
        IS_FOUND(visited(in, met, part_by(in, met, met.children == PLANE_ONLY_NEAR, 0, way))),
        WHOLE_PART);
    ANY(only_far_part, N_PARTS,
        IS_FOUND(visited(in, met, part_by(in, met, met.children == PLANE_ONLY_FAR, 1, way))),
        WHOLE_PART);

    ANSWERS(side_reordered, child(in, with_side_of(job, in, reordered(in, 0))),
            "the arguments of near_side() are in another order: the node, origin, inverse");
    ANY(children_reordered, 3, IS_FOUND(child(in, with_children_of(job, in, reordered(in, way)))),
        "the arguments of children_on_ray() are in another order: the node, origin, inverse, "
        "t_min, t_max");

    ONLY(hair, is_hair_beside(*found, right),
         "only the ends of the parts are wrong, by a hair: no epsilon is needed");
    ONLY(last_place, in->todo.n + 1 == TODO_SIZE && !is_hair_beside(*found, right),
         "only where one place is left on the stack is it wrong: that is enough, as the near child "
         "takes none");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const NextChildAnswer expected = child(in, met_by(job, in));
    return message_new("children %u and %u, plane at %g, eye at %g, 1 / direction %g, part [%g, "
                       "%g]: your code goes on with %s, expected %s",
                       in->node.first, in->node.first + 1, in->node.split_pos, in->origin,
                       in->inverse, in->t_min, in->t_max, next_child_words(&in->todo, found).text,
                       next_child_words(&in->todo, &expected).text);
}

const Function child_07 = {"next_child", 2 * N_CHILD_INPUTS, sizeof(NextChildAnswer),
                           KNOWING(is_right, describe, known)};

// ---- Alone --------------------------------------------------------------------------------------

// Is next_child right wherever the ray meets one child, or both, as the stubs have it?
enum { ONE_MET = 1, BOTH_MET = 2 };
static int pass_children(const Job07 *job, int met, const Sections *answers)
{
    const NextChildAnswer *found = function_answers(&child_07, answers);
    const uint nonce = job->job.nonce;
    int passes = found != NULL;
    for (int i = 0; passes && i < COUNT(job->inputs.children); i++) {
        const NextChildJob *in = &job->inputs.children[i];
        const Met said = met_by_chance(in, nonce);
        const int is_asked = met & (said.children == BOTH ? BOTH_MET : ONE_MET);
        passes = !is_asked || same_child(found[i], child(in, said));
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

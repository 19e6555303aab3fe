// Judging the answers of lab 07's near_side and children_on_ray by double-precision arithmetic.
// Where the answer depends on rounding, either one is right.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

// ---- near_side --------------------------------------------------------------------------------

enum {
    SIDE_SWAPPED = 1,
    SIDE_BY_DIRECTION,
    SIDE_INTO,
    SIDE_ON_PLANE_LOWER,
    SIDE_ON_PLANE_UPPER,
    SIDE_ON_PLANE_SWAPPED,
    SIDE_IS_ID,
};
static const Cause side_mistakes[] = {
    [SIDE_SWAPPED] = {.says = "that is the far side: near and far are swapped"},
    [SIDE_BY_DIRECTION] = {.says = "that is as if the direction decided, wherever the eye is"},
    [SIDE_INTO] = {.says = "that is as if the ray's way decided, wherever the eye is"},
    [SIDE_ON_PLANE_LOWER] =
        {.says = "an eye on the plane was sent to the lower child, wherever the ray "
                 "goes"},
    [SIDE_ON_PLANE_UPPER] =
        {.says = "an eye on the plane was sent to the upper child, wherever the ray "
                 "goes"},
    [SIDE_ON_PLANE_SWAPPED] =
        {.says = "with the eye on the plane the near child is the one the ray goes "
                 "into, not the one it comes from"},
    [SIDE_IS_ID] = {.says = "that is the id of a child; 0 and 1 are the sides"},
};

// Is the ray along the plane? Then the eye is on either side when it is on the plane.
static int is_along(const SideJob *job)
{
    return job->direction == 0 || isinf(job->direction);
}

static u32 expected_side(const SideJob *job, int mistake)
{
    const f32 plane = job->node.split_pos;
    u32 side = job->origin < plane ? 0 : job->origin > plane ? 1 : job->direction > 0;
    if (job->origin == plane) {
        side = mistake == SIDE_ON_PLANE_LOWER     ? 0
               : mistake == SIDE_ON_PLANE_UPPER   ? 1
               : mistake == SIDE_ON_PLANE_SWAPPED ? !side
                                                  : side;
    }
    side = mistake == SIDE_BY_DIRECTION ? job->direction < 0
           : mistake == SIDE_INTO       ? job->direction > 0
                                        : side;
    side = mistake == SIDE_SWAPPED ? !side : side;
    return mistake == SIDE_IS_ID ? job->node.first + side : side;
}

static int side_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const SideJob *job = &((const Job07 *)pointer)->inputs.sides[i];
    const u32 found = ((const u32 *)answers)[i];
    // A mistake may treat -0 or an infinite number in its own way, too.
    if (is_along(job) && (mistake != 0 || job->origin == job->node.split_pos)) {
        return mistake != 0 || found <= 1;
    }
    return found == expected_side(job, mistake);
}

static char *describe_side(const void *pointer, int i, const void *answers)
{
    const SideJob *job = &((const Job07 *)pointer)->inputs.sides[i];
    return message_new("plane at %.9g, eye at %.9g, direction %g: found %u, expected %u",
                       job->node.split_pos, job->origin, job->direction, ((const u32 *)answers)[i],
                       expected_side(job, 0));
}

const Function side_07 = {"sides",
                          2 * N_SIDE_INPUTS,
                          sizeof(u32),
                          .describe = describe_side,
                          .agrees = side_agrees,
                          .counted = "inputs",
                          MISTAKES(side_mistakes)};

// ---- children_on_ray --------------------------------------------------------------------------

enum {
    PLANE_T_OTHER = 1,
    PLANE_SWAPPED,
    PLANE_BEHIND_CROSSED,
    PLANE_BEHIND_MET,
    PLANE_AT_EYE_MET,
    PLANE_BEYOND_BOTH,
    PLANE_CROSSED_BOTH,
    PLANE_CROSSED_NEAR,
    PLANE_INSIDE_NEAR,
    PLANE_INSIDE_FAR,
    PLANE_AT_T_MIN,
    PLANE_AT_T_MAX,
    PLANE_ALONG_BOTH,
    PLANE_ALONG_FAR,
    PLANE_BACKWARDS,
    PLANE_DIVIDED,
    PLANE_FROM_ZERO,
};
static const Cause plane_mistakes[] = {
    [PLANE_T_OTHER] =
        {.says = "the choices are right, but t_split is not: is it handed out, and by the "
                 "README's formula?"},
    [PLANE_SWAPPED] = {.says = "ONLY_NEAR and ONLY_FAR are swapped"},
    [PLANE_BEHIND_CROSSED] =
        {.says = "that is as if a plane behind the eye had been crossed before the "
                 "node: t_split <= 0 is ONLY_NEAR"},
    [PLANE_BEHIND_MET] = {.says = "a plane behind the eye is not met: t_split <= 0 is ONLY_NEAR"},
    [PLANE_AT_EYE_MET] =
        {.says = "with the eye on the plane t_split is 0: that is ONLY_NEAR, as behind "
                 "the eye"},
    [PLANE_BEYOND_BOTH] =
        {.says = "that is as if t_max did not count: beyond it only the near child is "
                 "met"},
    [PLANE_CROSSED_BOTH] = {.says = "a plane crossed before t_min leaves only the far child"},
    [PLANE_CROSSED_NEAR] =
        {.says = "a plane crossed before t_min leaves the far child, not the near one"},
    [PLANE_INSIDE_NEAR] = {"that is as if the far child were never met: a plane between t_min "
                           "and t_max is BOTH",
                           MISTAKE_FAR_CHILD},
    [PLANE_INSIDE_FAR] =
        {.says = "that is as if only the far child were met: a plane between t_min and "
                 "t_max is BOTH"},
    [PLANE_AT_T_MIN] = {.says = "a plane exactly at t_min is met: equal to t_min is BOTH"},
    [PLANE_AT_T_MAX] = {.says = "a plane exactly at t_max is met: equal to t_max is BOTH"},
    [PLANE_ALONG_BOTH] = {.says =
                              "a ray along the plane never meets it, and comparisons with NaN are "
                              "never true: that is ONLY_NEAR"},
    [PLANE_ALONG_FAR] = {.says =
                             "a ray along the plane never meets it, and comparisons with NaN are "
                             "never true: that is ONLY_NEAR"},
    [PLANE_BACKWARDS] = {.says = "t_split has the wrong sign"},
    [PLANE_DIVIDED] = {.says = "t_split is divided by the inverse: it is 1 / direction already"},
    [PLANE_FROM_ZERO] = {.says = "t_split is computed without the origin"},
};

// What may come out: a bit for each of ONLY_NEAR, ONLY_FAR and BOTH, and where t_split lies.
typedef struct Children {
    u32 may_be;
    Span t_split;
} Children;

enum { NEAR_BIT = 1 << PLANE_ONLY_NEAR, FAR_BIT = 1 << PLANE_ONLY_FAR, BOTH_BIT = 1 << PLANE_BOTH };

// Is t_split the same for every right solution? So it is with the eye on the plane, and where float
// rounds neither the difference nor, the inverse being a power of two, a product.
static int is_exact_plane(const PlaneJob *job)
{
    int exponent;
    const double difference = (double)job->node.split_pos - (double)job->origin;
    const int is_power = fabsf(frexpf(job->inverse, &exponent)) == 0.5f;
    return difference == 0 || (is_power && difference == (double)(float)difference);
}

// Where rounding decides more than one is right.
static Children expected_children(const PlaneJob *job, int mistake)
{
    const double plane = job->node.split_pos, inverse = job->inverse, t_min = job->t_min,
                 t_max = job->t_max, origin = mistake == PLANE_FROM_ZERO ? 0 : (double)job->origin;
    double t = mistake == PLANE_DIVIDED ? (plane - origin) / inverse : (plane - origin) * inverse;
    t = mistake == PLANE_BACKWARDS ? -t : t;
    if (isinf(inverse)) {
        const u32 only = mistake == PLANE_ALONG_BOTH  ? BOTH_BIT
                         : mistake == PLANE_ALONG_FAR ? FAR_BIT
                                                      : NEAR_BIT;
        // NaN is where the mistakes show; an infinite t_split compares as it should, but where one
        // behind the eye counts: minus infinity is less than t_min.
        const int is_crossed = mistake == PLANE_BEHIND_CROSSED && t < 0;
        return (Children){isnan(t) ? only : is_crossed ? FAR_BIT : NEAR_BIT, {-INFINITY, INFINITY}};
    }
    const double error =
        is_exact_plane(job) ? 0 : PLANE_ERROR * (fabs(plane) + fabs(origin)) * fabs(inverse);
    const Span split = {t - error, t + error};
    if (split.high <= 0 && mistake == PLANE_BEHIND_MET) {
        return (Children){BOTH_BIT, split};
    }
    if (t == 0 && mistake == PLANE_AT_EYE_MET) {
        return (Children){t < t_min ? FAR_BIT : BOTH_BIT, split};
    }
    if (split.low == split.high &&
        ((mistake == PLANE_AT_T_MIN && t == t_min) || (mistake == PLANE_AT_T_MAX && t == t_max))) {
        return (Children){t == t_min ? FAR_BIT : NEAR_BIT, split};
    }
    const int behind_counts = mistake == PLANE_BEHIND_CROSSED;
    u32 may_be = 0;
    if ((split.low <= 0 && !behind_counts) || split.high > t_max) {
        may_be |= mistake == PLANE_BEYOND_BOTH && split.low > 0 ? BOTH_BIT : NEAR_BIT;
    }
    if ((split.high > 0 || behind_counts) && split.low < t_min) {
        may_be |= mistake == PLANE_CROSSED_BOTH   ? BOTH_BIT
                  : mistake == PLANE_CROSSED_NEAR ? NEAR_BIT
                                                  : FAR_BIT;
    }
    if ((split.high > 0 || behind_counts) && split.high >= t_min && split.low <= t_max) {
        may_be |= mistake == PLANE_INSIDE_NEAR  ? NEAR_BIT
                  : mistake == PLANE_INSIDE_FAR ? FAR_BIT
                                                : BOTH_BIT;
    }
    if (mistake == PLANE_SWAPPED) {
        may_be = (may_be & BOTH_BIT) | (may_be & NEAR_BIT ? FAR_BIT : 0) |
                 (may_be & FAR_BIT ? NEAR_BIT : 0);
    }
    return (Children){may_be, split};
}

static int plane_agrees(const void *job, int i, const void *answers, int mistake)
{
    const Inputs07 *inputs = &((const Job07 *)job)->inputs;
    const PlaneAnswer found = ((const PlaneAnswer *)answers)[i];
    const Children right = expected_children(&inputs->planes[i], mistake);
    if (found.children >= PLANE_UNKNOWN || !(right.may_be >> found.children & 1)) {
        return 0;
    }
    // Of a mistake only the choice is looked at, but where t_split itself is the mistake.
    const int is_of_t = mistake == 0 || mistake >= PLANE_BACKWARDS;
    return !is_of_t || found.children == PLANE_ONLY_NEAR || is_within(found.t_split, right.t_split);
}

// "BOTH with t_split 1.5"; t_split is not used for ONLY_NEAR.
static Words children_words(u32 children, double t_split)
{
    static const char *const names[] = {"ONLY_NEAR", "ONLY_FAR", "BOTH",
                                        "none of ONLY_NEAR, ONLY_FAR and BOTH"};
    const char *name = names[children < PLANE_UNKNOWN ? children : PLANE_UNKNOWN];
    return children == PLANE_ONLY_FAR || children == PLANE_BOTH
               ? words("%s with t_split %.7g", name, t_split)
               : words("%s", name);
}

static char *describe_plane(const void *pointer, int i, const void *answers)
{
    const PlaneJob *job = &((const Job07 *)pointer)->inputs.planes[i];
    const PlaneAnswer own = ((const PlaneAnswer *)answers)[i];
    const Children right = expected_children(job, 0);
    const u32 expected = right.may_be & BOTH_BIT  ? PLANE_BOTH
                         : right.may_be & FAR_BIT ? PLANE_ONLY_FAR
                                                  : PLANE_ONLY_NEAR;
    return message_new("plane at %.7g, eye at %.7g, 1 / direction %.7g, part [%g, %g]: found %s, "
                       "expected %s",
                       job->node.split_pos, job->origin, job->inverse, job->t_min, job->t_max,
                       children_words(own.children, own.t_split).text,
                       children_words(expected, (right.t_split.low + right.t_split.high) / 2).text);
}

const Function plane_07 = {"planes",
                           3 * N_PLANE_INPUTS,
                           sizeof(PlaneAnswer),
                           .describe = describe_plane,
                           .agrees = plane_agrees,
                           .counted = "inputs",
                           MISTAKES(plane_mistakes)};

// Judging the answers of lab 07's children_on_ray by double-precision arithmetic. Where the answer
// depends on rounding, either one is right.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

enum {
    PLANE_T_UNSET = 1,
    PLANE_T_OTHER,
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
    // The answer is right, or other in one place: along the plane, or near a border, of an epsilon
    // whose size is not known.
    PLANE_INFINITE_BOTH,
    PLANE_ALONG_MET,
    PLANE_SMALL_IS_ALONG,
    PLANE_HAIR_AHEAD,
    PLANE_HAIR_BEHIND,
    PLANE_HAIR_T_MIN,
    PLANE_HAIR_T_MAX,
    PLANE_HAIR_WIDER,
    // Of t_split itself.
    PLANE_BACKWARDS,
    PLANE_DIVIDED,
    PLANE_FROM_ZERO,
    PLANE_CLAMPED,
};
static const Cause plane_mistakes[] = {
    [PLANE_T_UNSET] =
        {.says =
             "the choices are right, but *t_split is not set: what stood there before is found"},
    [PLANE_T_OTHER] =
        {.says = "the choices are right, but t_split is not: is it by the README's formula?"},
    [PLANE_SWAPPED] = {.says = "ONLY_NEAR and ONLY_FAR are swapped"},
    [PLANE_BEHIND_CROSSED] = {.says = "that is as if a plane behind the eye had been crossed "
                                      "before the node: t_split <= 0 is ONLY_NEAR"},
    [PLANE_BEHIND_MET] = {.says = "a plane behind the eye is not met: t_split <= 0 is ONLY_NEAR"},
    [PLANE_AT_EYE_MET] =
        {.says = "with the eye on the plane t_split is 0: that is ONLY_NEAR, as behind the eye"},
    [PLANE_BEYOND_BOTH] =
        {.says = "that is as if t_max did not count: beyond it only the near child is met"},
    [PLANE_CROSSED_BOTH] = {.says = "a plane crossed before t_min leaves only the far child"},
    [PLANE_CROSSED_NEAR] =
        {.says = "a plane crossed before t_min leaves the far child, not the near one"},
    [PLANE_INSIDE_NEAR] =
        {"that is as if the far child were never met: a plane between t_min and t_max is BOTH",
         MISTAKE_FAR_CHILD},
    [PLANE_INSIDE_FAR] =
        {.says =
             "that is as if only the far child were met: a plane between t_min and t_max is BOTH"},
    [PLANE_AT_T_MIN] = {.says = "a plane exactly at t_min is met: equal to t_min is BOTH"},
    [PLANE_AT_T_MAX] = {.says = "a plane exactly at t_max is met: equal to t_max is BOTH"},
    [PLANE_ALONG_BOTH] = {.says = "a ray along the plane never meets it, and comparisons with NaN "
                                  "are never true: that is ONLY_NEAR"},
    [PLANE_ALONG_FAR] = {.says = "a ray along the plane never meets it, and comparisons with NaN "
                                 "are never true: that is ONLY_NEAR"},
    [PLANE_INFINITE_BOTH] = {.says = "BOTH with an infinite t_split: a ray along the plane never "
                                     "meets it, that is ONLY_NEAR"},
    [PLANE_ALONG_MET] = {.says = "only rays along the plane are wrong: they never meet it, that is "
                                 "ONLY_NEAR, whether t_split is infinite or not a number"},
    [PLANE_SMALL_IS_ALONG] = {.says =
                                  "that is as if a small direction were 0: a ray is along the "
                                  "plane only where 1 / direction is infinite, without an epsilon"},
    [PLANE_HAIR_AHEAD] =
        {.says =
             "a plane a hair ahead of the eye is ahead of it: compare with 0 without an epsilon"},
    [PLANE_HAIR_BEHIND] =
        {.says = "a plane a hair behind the eye is behind it: compare with 0 without an epsilon"},
    [PLANE_HAIR_T_MIN] =
        {.says = "only planes a hair before or behind t_min are wrong: compare without an epsilon"},
    [PLANE_HAIR_T_MAX] =
        {.says = "only planes a hair before or behind t_max are wrong: compare without an epsilon"},
    [PLANE_HAIR_WIDER] = {.says = "planes a hair outside of the part are taken for met: compare "
                                  "with t_min and t_max without an epsilon"},
    [PLANE_BACKWARDS] = {.says = "t_split has the wrong sign"},
    [PLANE_DIVIDED] = {.says = "t_split is divided by the inverse: it is 1 / direction already"},
    [PLANE_FROM_ZERO] = {.says = "t_split is computed without the origin"},
    [PLANE_CLAMPED] = {.says = "t_split was moved into [t_min, t_max] before it was compared: then "
                               "every plane ahead is met"},
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
    if (mistake == PLANE_CLAMPED && split.low > 0) {
        return (Children){
            BOTH_BIT, {fmin(fmax(split.low, t_min), t_max), fmin(fmax(split.high, t_min), t_max)}};
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

// May a choice come of a mistake that shows in one place only?
static int is_local_mistake(const PlaneJob *job, u32 children, int mistake)
{
    const double t = ((double)job->node.split_pos - (double)job->origin) * (double)job->inverse;
    const int is_near = children == PLANE_ONLY_NEAR, is_far = children == PLANE_ONLY_FAR;
    switch (mistake) {
    case PLANE_INFINITE_BOTH:
        return isinf(job->inverse) && (children == PLANE_BOTH || isnan(t));
    case PLANE_ALONG_MET:
        return isinf(job->inverse);
    case PLANE_SMALL_IS_ALONG:
        return fabsf(job->inverse) * HAIR > 1 && is_near;
    case PLANE_HAIR_AHEAD:
        return t > 0 && t < HAIR && is_near;
    case PLANE_HAIR_BEHIND:
        return t <= 0 && t > -HAIR && !is_near;
    case PLANE_HAIR_T_MIN:
        return fabs(t - job->t_min) < HAIR && !is_near;
    case PLANE_HAIR_T_MAX:
        return fabs(t - job->t_max) < HAIR && !is_far;
    case PLANE_HAIR_WIDER:
        return (fabs(t - job->t_min) < HAIR || fabs(t - job->t_max) < HAIR) &&
               children == PLANE_BOTH;
    default:
        return 0;
    }
}

static int plane_agrees(const void *job, int i, const void *answers, int mistake)
{
    const PlaneJob *plane = &((const Job07 *)job)->inputs.planes[i];
    const PlaneAnswer found = ((const PlaneAnswer *)answers)[i];
    const Children right = expected_children(plane, mistake);
    if (found.children >= PLANE_UNKNOWN || !(right.may_be >> found.children & 1)) {
        return found.children < PLANE_UNKNOWN && is_local_mistake(plane, found.children, mistake);
    }
    // Of a mistake only the choice is looked at, but where t_split itself is the mistake.
    const int is_of_t = mistake == 0 || mistake == PLANE_T_UNSET || mistake >= PLANE_BACKWARDS;
    return !is_of_t || found.children != PLANE_BOTH || is_within(found.t_split, right.t_split) ||
           (mistake == PLANE_T_UNSET && found.t_split == UNWRITTEN);
}

// "BOTH with t_split 1.5"; for the others t_split is not used.
static Words children_words(u32 children, double t_split)
{
    static const char *const names[] = {"ONLY_NEAR", "ONLY_FAR", "BOTH",
                                        "none of ONLY_NEAR, ONLY_FAR and BOTH"};
    const char *name = names[children < PLANE_UNKNOWN ? children : PLANE_UNKNOWN];
    return children == PLANE_BOTH ? words("%s with t_split %.9g", name, t_split)
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
    return message_new("plane at %.9g, eye at %.9g, 1 / direction %.9g, part [%.9g, %.9g]: found "
                       "%s, expected %s",
                       job->node.split_pos, job->origin, job->inverse, job->t_min, job->t_max,
                       children_words(own.children, own.t_split).text,
                       children_words(expected, (right.t_split.low + right.t_split.high) / 2).text);
}

const Function plane_07 = {"planes", 3 * N_PLANE_INPUTS, sizeof(PlaneAnswer),
                           COMPARED(plane_agrees, describe_plane, plane_mistakes)};

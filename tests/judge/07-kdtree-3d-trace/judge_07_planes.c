// Judging the answers of lab 07's children_on_ray by double-precision arithmetic. Where the answer
// depends on rounding, either one is right.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

// ---- Right --------------------------------------------------------------------------------------

// What may come out: a bit for each of ONLY_NEAR, ONLY_FAR and BOTH, and where t_split lies.
typedef struct Children {
    u32 may_be;
    Span t_split;
} Children;

enum { NEAR_BIT = 1 << PLANE_ONLY_NEAR, FAR_BIT = 1 << PLANE_ONLY_FAR, BOTH_BIT = 1 << PLANE_BOTH };

// Is t_split the same for every right solution? So it is with the eye on the plane, and where float
// rounds neither the difference nor, the inverse being a power of two, a product.
static int is_exact_plane(const PlaneJob *in)
{
    int exponent;
    const double difference = (double)in->node.split_pos - (double)in->origin;
    const int is_power = fabsf(frexpf(in->inverse, &exponent)) == 0.5f;
    return difference == 0 || (is_power && difference == (double)(float)difference);
}

static double t_from(const PlaneJob *in, double origin)
{
    return ((double)in->node.split_pos - origin) * (double)in->inverse;
}

static double t_of(const PlaneJob *in)
{
    return t_from(in, in->origin);
}

// Is the eye so far from the scene's origin that products which are subtracted lose their digits?
static int is_far(const PlaneJob *in)
{
    return fabsf(in->origin) > 1000;
}

// Where a right solution's t_split may be, or one that computes it in another way. Far from the
// scene's origin only who subtracts first is right: no error is larger than a share of t_split.
static Span span_about(const PlaneJob *in, double t)
{
    const double size = fabs((double)in->node.split_pos) + fabs((double)in->origin);
    const double about = is_far(in) ? fabs(t) : size * fabs((double)in->inverse);
    const double error = is_exact_plane(in) ? 0 : PLANE_ERROR * about;
    return (Span){t - error, t + error};
}

// What is chosen where the plane is before the part, inside of it and beyond it.
static u32 by_part(const PlaneJob *in, Span split, u32 before, u32 inside, u32 beyond)
{
    return (split.low < in->t_min ? before : 0) |
           (split.high >= in->t_min && split.low <= in->t_max ? inside : 0) |
           (split.high > in->t_max ? beyond : 0);
}

// The same where a plane behind the eye counts by itself. A ray along the plane never meets it.
static Children chosen(const PlaneJob *in, Span split, u32 behind, u32 before, u32 inside,
                       u32 beyond)
{
    if (isinf(in->inverse)) {
        return (Children){NEAR_BIT, {-INFINITY, INFINITY}};
    }
    return (Children){(split.low <= 0 ? behind : 0) |
                          (split.high > 0 ? by_part(in, split, before, inside, beyond) : 0),
                      split};
}

static Children children_at(const PlaneJob *in, Span split)
{
    return chosen(in, split, NEAR_BIT, FAR_BIT, BOTH_BIT, NEAR_BIT);
}

static Children children(const PlaneJob *in)
{
    return children_at(in, span_about(in, t_of(in)));
}

static int is_choice(PlaneAnswer found, Children expected)
{
    return found.children < PLANE_UNKNOWN && (expected.may_be >> found.children & 1);
}

static int is_same(PlaneAnswer found, Children expected)
{
    return is_choice(found, expected) &&
           (found.children != PLANE_BOTH || is_within(found.t_split, expected.t_split));
}

// Of a mistake only the choice is looked at, but where t_split itself is the mistake.
static int is_written(PlaneAnswer found)
{
    return found.children != PLANE_BOTH || found.t_split != UNWRITTEN;
}

#define GIVEN                                                                                      \
    const PlaneJob *in = &((const Job07 *)job)->inputs.planes[i];                                  \
    const PlaneAnswer found = ((const PlaneAnswer *)answers)[i]
#define IS_FOUND(expected) (is_choice(found, expected) && is_written(found))

RIGHT(is_right, is_same(found, children(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// The choice is this one where `is_there`, and right elsewhere.
static Children children_but(const PlaneJob *in, int is_there, u32 choice)
{
    Children result = children(in);
    result.may_be = is_there ? choice : result.may_be;
    return result;
}

// Of a mistake in the choices a ray along the plane may be a case by itself, or come out as its
// t_split does: behind, beyond, or as NaN does in the comparisons.
static Children chosen_by(const PlaneJob *in, u32 behind, u32 before, u32 inside, u32 beyond)
{
    Children result = chosen(in, span_about(in, t_of(in)), behind, before, inside, beyond);
    if (isinf(in->inverse)) {
        result.may_be |= isnan(t_of(in)) ? behind | before | inside | beyond
                         : t_of(in) < 0  ? behind
                                         : beyond;
    }
    return result;
}

// A plane behind the eye is compared as any other.
static Children without_eye(const PlaneJob *in)
{
    return isinf(in->inverse)
               ? children_but(in, t_of(in) < 0, FAR_BIT)
               : children_but(in, 1,
                              by_part(in, span_about(in, t_of(in)), FAR_BIT, BOTH_BIT, NEAR_BIT));
}

// Is the plane ahead, and exactly there?
#define IS_AT(t) (is_exact_plane(in) && t_of(in) > 0 && t_of(in) == (t))

static Children crossed_first(const PlaneJob *in)
{
    Children result = children(in);
    const Span split = span_about(in, t_of(in));
    result.may_be = split.high < in->t_min  ? FAR_BIT
                    : split.low < in->t_min ? result.may_be | FAR_BIT
                                            : result.may_be;
    return result;
}

static Children without_ends(const PlaneJob *in, u32 of_nan)
{
    return isnan(t_of(in)) ? children_but(in, 1, of_nan)
                           : children_but(in, IS_AT(in->t_min) || IS_AT(in->t_max),
                                          IS_AT(in->t_max) ? NEAR_BIT : FAR_BIT);
}

// Of t_split itself.
static Span clamped(const PlaneJob *in, Span split)
{
    return (Span){fmin(fmax(split.low, in->t_min), in->t_max),
                  fmin(fmax(split.high, in->t_min), in->t_max)};
}

static Children clamped_first(const PlaneJob *in)
{
    const Children right = children(in);
    return !isinf(in->inverse) && right.t_split.low > 0
               ? (Children){BOTH_BIT, clamped(in, right.t_split)}
               : right;
}

// Where float finds a wrong t_split: it rounds also where the right one is exact.
static int is_met_at(const PlaneJob *in, PlaneAnswer found, double t)
{
    const double in_float = (double)(float)t, error = PLANE_ERROR * fabs(in_float);
    const Span split = span_about(in, in_float);
    return is_same(found, children_at(in, (Span){fmin(split.low, in_float - error),
                                                 fmax(split.high, in_float + error)}));
}

KNOWN_LIST(known)
{
    GIVEN;

    EACH(unset,
         is_same(found, children(in)) || (is_choice(found, children(in)) && !is_written(found)),
         "the choices are right, but *t_split is not set: what stood there before is found");
    ANSWERS(swapped, chosen_by(in, FAR_BIT, NEAR_BIT, BOTH_BIT, FAR_BIT),
            "ONLY_NEAR and ONLY_FAR are swapped");
    ANSWERS(behind_crossed, without_eye(in),
            "that is as if a plane behind the eye had been crossed before the node: t_split <= 0 "
            "is ONLY_NEAR");

    EACH(behind_late, isnan(t_of(in)) || IS_FOUND(crossed_first(in)),
         "that is as if a plane behind the eye had been crossed before the node: whether it is "
         "behind the eye is asked first");
    ANSWERS(behind_met, chosen_by(in, BOTH_BIT, FAR_BIT, BOTH_BIT, NEAR_BIT),
            "a plane behind the eye is not met: t_split <= 0 is ONLY_NEAR");
    ANSWERS(at_eye_met, children_but(in, t_of(in) == 0, in->t_min > 0 ? FAR_BIT : BOTH_BIT),
            "with the eye on the plane t_split is 0: that is ONLY_NEAR, as behind the eye");
    ANSWERS(beyond_both, chosen_by(in, NEAR_BIT, FAR_BIT, BOTH_BIT, BOTH_BIT),
            "that is as if t_max did not count: beyond it only the near child is met");
    ANSWERS(crossed_both, chosen_by(in, NEAR_BIT, BOTH_BIT, BOTH_BIT, NEAR_BIT),
            "a plane crossed before t_min leaves only the far child");
    ANSWERS(crossed_near, chosen_by(in, NEAR_BIT, NEAR_BIT, BOTH_BIT, NEAR_BIT),
            "a plane crossed before t_min leaves the far child, not the near one");
    ANSWERS(inside_near, chosen_by(in, NEAR_BIT, FAR_BIT, NEAR_BIT, NEAR_BIT),
            "that is as if the far child were never met: a plane between t_min and t_max is BOTH",
            MISTAKE_FAR_CHILD);
    ANSWERS(inside_far, chosen_by(in, NEAR_BIT, FAR_BIT, FAR_BIT, NEAR_BIT),
            "that is as if only the far child were met: a plane between t_min and t_max is BOTH");
    ANSWERS(beyond_far, chosen_by(in, NEAR_BIT, FAR_BIT, BOTH_BIT, FAR_BIT),
            "a plane beyond t_max leaves the near child, not the far one");
    ANSWERS(behind_far, chosen_by(in, FAR_BIT, FAR_BIT, BOTH_BIT, NEAR_BIT),
            "a plane behind the eye leaves the near child, not the far one");

    // Of the plane behind the eye, before the part, in it and beyond it: 3 choices each.
    ANY(other_choices, 81,
        IS_FOUND(
            chosen_by(in, 1u << way % 3, 1u << way / 3 % 3, 1u << way / 9 % 3, 1u << way / 27)),
        "in more than one of the README's four cases the choice is another: the plane behind the "
        "eye, before the part, in it, beyond it");
    ANSWERS(at_t_min, children_but(in, IS_AT(in->t_min), FAR_BIT),
            "a plane exactly at t_min is met: equal to t_min is BOTH");
    ANSWERS(at_t_max, children_but(in, IS_AT(in->t_max), NEAR_BIT),
            "a plane exactly at t_max is met: equal to t_max is BOTH");

    ANSWERS(at_both_ends, without_ends(in, NEAR_BIT),
            "a plane exactly at t_min or t_max is met: equal is BOTH");
    ANSWERS(at_both_ends_nan, without_ends(in, BOTH_BIT),
            "a plane exactly at t_min or t_max is met, equal is BOTH; and a ray along the plane, "
            "where t_split is NaN, is ONLY_NEAR");

    // NaN is where these show: an infinite t_split compares as it should.
#define NEVER_MET                                                                                  \
    "a ray along the plane never meets it, and comparisons with NaN are never true: that is "      \
    "ONLY_NEAR"
    ANSWERS(along_both, children_but(in, isnan(t_of(in)), BOTH_BIT), NEVER_MET);
    ANSWERS(along_far, children_but(in, isnan(t_of(in)), FAR_BIT), NEVER_MET);

    // In one place only: along the plane, or near a border, of an epsilon whose size is not known.
    ONLY(infinite_both, isinf(in->inverse) && (found.children == PLANE_BOTH || isnan(t_of(in))),
         "BOTH with an infinite t_split: a ray along the plane never meets it, that is ONLY_NEAR");

    ONLY(along_met, isinf(in->inverse),
         "only rays along the plane are wrong: they never meet it, that is ONLY_NEAR, whether "
         "t_split is infinite or not a number");
    ONLY(small_is_along, fabsf(in->inverse) * HAIR > 1 && found.children == PLANE_ONLY_NEAR,
         "that is as if a small direction were 0: a ray is along the plane only where 1 / "
         "direction is infinite, without an epsilon");
    ONLY(hair_ahead, t_of(in) > 0 && t_of(in) < HAIR && found.children == PLANE_ONLY_NEAR,
         "a plane a hair ahead of the eye is ahead of it: compare with 0 without an epsilon");
    ONLY(hair_behind, t_of(in) <= 0 && t_of(in) > -HAIR && found.children != PLANE_ONLY_NEAR,
         "a plane a hair behind the eye is behind it: compare with 0 without an epsilon");
    ONLY(hair_t_min, fabs(t_of(in) - in->t_min) < HAIR && found.children != PLANE_ONLY_NEAR,
         "only planes a hair before or behind t_min are wrong: compare without an epsilon");
    ONLY(hair_t_max, fabs(t_of(in) - in->t_max) < HAIR && found.children != PLANE_ONLY_FAR,
         "only planes a hair before or behind t_max are wrong: compare without an epsilon");
    ONLY(hair_wider,
         (fabs(t_of(in) - in->t_min) < HAIR || fabs(t_of(in) - in->t_max) < HAIR) &&
             found.children == PLANE_BOTH,
         "planes a hair outside of the part are taken for met: compare with t_min and t_max "
         "without an epsilon");
    ONLY(lost_afar, is_far(in),
         "only planes far from the scene's origin are wrong: products that are subtracted lose "
         "their digits there; subtract the eye first, and multiply the difference");

    EACH(backwards, is_met_at(in, found, -t_of(in)), "t_split has the wrong sign");
    EACH(divided, is_met_at(in, found, t_of(in) / pow(in->inverse, 2)),
         "t_split is divided by the inverse: it is 1 / direction already");
    EACH(from_zero, is_met_at(in, found, t_from(in, 0)), "t_split is computed without the origin");
    ANSWERS(always_both, children_but(in, 1, BOTH_BIT),
            "that is as if every plane were met: where it is behind the eye, beyond t_max or "
            "before t_min, the ray meets one child only");
    EACH(origin_added, is_met_at(in, found, t_from(in, -(double)in->origin)),
         "t_split is computed with the origin added: it is taken from the plane's position");
    EACH(not_multiplied, is_met_at(in, found, (double)in->node.split_pos - in->origin),
         "t_split is the way to the plane, not yet times 1 / direction");
    EACH(moved, is_same(found, clamped_first(in)),
         "t_split was moved into [t_min, t_max] before it was compared: then every plane ahead is "
         "met");

    ANSWERS(t_other, children(in),
            "the choices are right, but t_split is not: is it by the README's formula?");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

// "BOTH with t_split 1.5"; for the others t_split is not used.
static Words children_words(u32 children, double t_split)
{
    static const char *const names[] = {"ONLY_NEAR", "ONLY_FAR", "BOTH",
                                        "none of ONLY_NEAR, ONLY_FAR and BOTH"};
    const char *name = names[children < PLANE_UNKNOWN ? children : PLANE_UNKNOWN];
    return children == PLANE_BOTH ? words("%s with t_split %.9g", name, t_split)
                                  : words("%s", name);
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const Children right = children(in);
    const u32 expected = right.may_be & BOTH_BIT  ? PLANE_BOTH
                         : right.may_be & FAR_BIT ? PLANE_ONLY_FAR
                                                  : PLANE_ONLY_NEAR;
    return message_new("plane at %.9g, eye at %.9g, 1 / direction %.9g, part [%.9g, %.9g]: found "
                       "%s, expected %s",
                       in->node.split_pos, in->origin, in->inverse, in->t_min, in->t_max,
                       children_words(found.children, found.t_split).text,
                       children_words(expected, (right.t_split.low + right.t_split.high) / 2).text);
}

const Function plane_07 = {"planes", 3 * N_PLANE_INPUTS, sizeof(PlaneAnswer),
                           KNOWING(is_right, describe, known), .is_known_by_range = 1};

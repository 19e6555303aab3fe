// Judging the answers of lab 07's clip_to_box by double-precision arithmetic. Along an axis, on the
// inputs' grid, nothing is rounded; elsewhere either answer is right where rounding decides.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

// What may come out.
typedef struct Clip {
    int may_meet, may_miss;
    Span t_min, t_max;
} Clip;

static int is_clip(ClipAnswer found, Clip clip)
{
    return !found.is_met ? clip.may_miss
                         : clip.may_meet && is_within(found.t_min, clip.t_min) &&
                               is_within(found.t_max, clip.t_max);
}

#define GIVEN                                                                                      \
    const ClipJob *in = &((const Job07 *)job)->inputs.clips[i];                                    \
    const ClipAnswer found = ((const ClipAnswer *)answers)[i]
#define IS_FOUND(clip) is_clip(found, clip)

// ---- Right --------------------------------------------------------------------------------------

// A way of clipping. All zeros is the right one.
typedef struct Way {
    int low_is_entry;             // the lower plane, whatever the direction
    int first_entry, last_exit;   // count
    int along_ignored;            // whether a ray along an axis is between its planes
    int along_missed, along_met;  // such a ray misses; or its first axis decides
    int along_other;              // 1 + another comparison of it (is_beside)
    int first_decides;            // the loop ends with the first axis that has entry and exit
    int border_outside;           // a ray in the plane of a side misses: of the lower 1, upper 2
    int entry_behind;             // an entry behind the eye is a miss
    int exit_ahead;               // an exit ahead is enough,
    int always_met;               // or nothing is needed
    int point_missed;             // nothing is left where t_min and t_max are equal
    u32 skipped;                  // axes that are not asked, a bit for each
    int multiplies;               // with the direction, in the place of dividing by it
    int grows;                    // t_max becomes the larger of two
    u32 direction_of;             // 1 + the axis whose direction is taken on every axis; 0 for none
    u32 origin_of;                // the same of the origin
    double small;                 // directions below that are 0
    double beside;                // so far beside the box, or so short in it,
    double shorter;               // is met, or missed
} Way;

// What stands on an axis, or on the one that is taken in its place.
static double taken(Vec3 vector, u32 axis, u32 other)
{
    return vector_component(vector_of(vector), other > 0 ? other - 1 : axis);
}

static Span clip_plane(const ClipJob *in, u32 axis, double plane, Way way)
{
    const double origin = taken(in->origin, axis, way.origin_of),
                 direction = taken(in->direction, axis, way.direction_of);
    const double way_to = plane - origin;
    const double t = way.multiplies ? way_to * direction : way_to / direction;
    const int is_exact = fabs(direction) == 1;
    const double error =
        is_exact ? 0 : PLANE_ERROR * (fabs(plane) + fabs(origin)) / fabs(direction);
    return (Span){t - error, t + error};
}

// Is a ray along an axis' planes beside them, by two comparisons: of 0 to 15, 3 is the right one.
// With 16 it is if it is not.
static int is_beside(double origin, double min, double max, int comparisons)
{
    const int holds[] = {origin<min, origin> min, origin<max, origin> max};
    return comparisons == 16 ? !(holds[0] || holds[3])
                             : holds[comparisons / 4] || holds[comparisons % 4];
}

static Clip clipped(const ClipJob *in, Way way)
{
    Span entry = {-INFINITY, -INFINITY}, exit = {INFINITY, INFINITY};
    int n_axes = 0, is_outside = 0, is_decided = 0;
    for (u32 axis = 0; axis < 3 && !is_decided; axis++) {
        if (way.skipped >> axis & 1) {
            continue;
        }
        const double min = in->box.min[axis], max = in->box.max[axis];
        const double direction = taken(in->direction, axis, way.direction_of);
        if (direction == 0 || fabs(direction) < way.small) {
            const double origin = taken(in->origin, axis, way.origin_of);
            is_outside |= way.along_missed ||
                          is_beside(origin, min - way.beside, max + way.beside,
                                    way.along_other > 0 ? way.along_other - 1 : 3) ||
                          ((way.border_outside & 1) && origin == min) ||
                          ((way.border_outside & 2) && origin == max);
            is_decided = way.along_met;
            continue;
        }
        const Span low = clip_plane(in, axis, min, way), high = clip_plane(in, axis, max, way);
        const Span into = way.low_is_entry ? low : span_min(low, high);
        const Span out = way.low_is_entry ? high : span_max(low, high);
        is_outside |= way.entry_behind && into.high < 0;
        const int is_first = n_axes++ == 0;
        entry = is_first ? into : way.first_entry ? span_min(entry, into) : span_max(entry, into);
        exit = is_first ? out : way.last_exit ? span_max(exit, out) : span_min(exit, out);
        if (way.first_decides) {
            break;
        }
    }
    const Span t_min = span_max(entry, (Span){in->t_min, in->t_min});
    const Span end = {in->t_max, in->t_max};
    const Span t_max = way.grows ? span_max(exit, end) : span_min(exit, end);
    if (is_outside && !way.along_ignored) {
        return (Clip){0, 1, t_min, t_max};
    }
    if (is_decided || way.always_met) {
        return (Clip){1, 0, t_min, t_max};
    }
    if (way.exit_ahead) {
        return (Clip){t_max.high >= 0, t_max.low < 0, t_min, t_max};
    }
    if (way.point_missed) {
        return (Clip){t_min.low < t_max.high, t_min.high >= t_max.low, t_min, t_max};
    }
    return (Clip){t_min.low <= t_max.high + way.beside, t_min.high > t_max.low - way.shorter, t_min,
                  t_max};
}

RIGHT(is_right, IS_FOUND(clipped(in, (Way){0})))

// ---- Mistakes -----------------------------------------------------------------------------------

static Clip with_part(ClipJob in, float t_min, float t_max)
{
    in.t_min = t_min;
    in.t_max = t_max;
    return clipped(&in, (Way){0});
}

static Clip not_stored(const ClipJob *in)
{
    const Clip clip = clipped(in, (Way){0});
    return (Clip){clip.may_meet, clip.may_miss, {in->t_min, in->t_min}, {in->t_max, in->t_max}};
}

// Is the ray in the plane of a side?
static int is_in_side(const ClipJob *in)
{
    for (u32 axis = 0; axis < 3; axis++) {
        const float origin = (float)vector_component(vector_of(in->origin), axis);
        if (vector_component(vector_of(in->direction), axis) == 0 &&
            (origin == in->box.min[axis] || origin == in->box.max[axis])) {
            return 1;
        }
    }
    return 0;
}

// Was something divided by 0 on the way to this answer? Of a plane that the ray is in comes 0 / 0,
// which fmin() and fmax() pass over; of the other one an infinite number, which they take.
static int is_divided_by_0(ClipAnswer found)
{
    return found.t_min == INFINITY || found.t_max == -INFINITY;
}

static Way of_one_axis(u32 axis, int is_direction)
{
    return (Way){.direction_of = is_direction ? axis : 0, .origin_of = is_direction ? 0 : axis};
}

// What the loop makes of t_min or t_max on each axis: of two, the larger or the smaller.
typedef struct Line {
    int how;       // 0 the larger, 1 the smaller, 2 the second, 3 the first: the line is missing
    int of_t_max;  // the first is t_min, or t_max
    int of;        // the second: 0 the entry, 1 the exit, 2 the lower plane's t, 3 the upper one's
} Line;

enum { N_LINES = 32 };
static Line line_of(int way)
{
    return (Line){way % 4, way / 4 % 2, way / 8};
}

static const Line right_min = {0, 0, 0}, right_max = {1, 1, 1};

// Of the two planes of an axis: which one, and by which formula.
typedef enum Formula { DIVIDED, ADDED, LESS_DIRECTION, MULTIPLIED, BY_ORIGIN, BACKWARDS } Formula;
typedef struct Planes {
    int low_is_high, high_is_low;
    Formula low, high;
} Planes;

static Span t_by(const ClipJob *in, u32 axis, double plane, Formula formula)
{
    const double o = vector_component(vector_of(in->origin), axis),
                 d = vector_component(vector_of(in->direction), axis);
    const double t[] = {
        0, (plane + o) / d, (plane - d) / d, (plane - o) * d, (plane - o) / o, (o - plane) / d};
    const double error = PLANE_ERROR * (fabs(t[formula]) + (fabs(plane) + fabs(o) + 1) / fabs(d));
    return formula == DIVIDED ? clip_plane(in, axis, plane, (Way){0})
                              : (Span){t[formula] - error, t[formula] + error};
}

static Span span_by(Line line, Span t_min, Span t_max, const Span of[4])
{
    const Span first = line.of_t_max ? t_max : t_min, second = of[line.of];
    return line.how == 0   ? span_max(first, second)
           : line.how == 1 ? span_min(first, second)
           : line.how == 2 ? second
                           : first;
}

static Clip lined(const ClipJob *in, Line min_line, Line max_line, Planes planes)
{
    Span t_min = {in->t_min, in->t_min}, t_max = {in->t_max, in->t_max};
    for (u32 axis = 0; axis < 3; axis++) {
        const double min = in->box.min[axis], max = in->box.max[axis],
                     origin = vector_component(vector_of(in->origin), axis);
        if (vector_component(vector_of(in->direction), axis) == 0) {
            if (origin < min || origin > max) {
                return (Clip){0, 1, t_min, t_max};
            }
            continue;
        }
        const Span low = t_by(in, axis, planes.low_is_high ? max : min, planes.low),
                   high = t_by(in, axis, planes.high_is_low ? min : max, planes.high);
        const Span of[4] = {span_min(low, high), span_max(low, high), low, high};
        t_min = span_by(min_line, t_min, t_max, of);
        t_max = span_by(max_line, t_min, t_max, of);
    }
    return (Clip){t_min.low <= t_max.high, t_min.high > t_max.low, t_min, t_max};
}

static Clip with_min_line(const ClipJob *in, Line line)
{
    return lined(in, line, right_max, (Planes){0});
}

static Clip with_max_line(const ClipJob *in, Line line)
{
    return lined(in, right_min, line, (Planes){0});
}

// Of one plane, or both: a formula; or one plane for the other.
static Planes planes_of(int way)
{
    if (way >= 15) {
        return (Planes){.low_is_high = way == 15, .high_is_low = way == 16};
    }
    const Formula formula = (Formula)(1 + way / 3);
    return (Planes){.low = way % 3 == 1 ? DIVIDED : formula,
                    .high = way % 3 == 2 ? DIVIDED : formula};
}

static Clip inverted_result(const ClipJob *in)
{
    const Clip clip = clipped(in, (Way){0});
    return (Clip){clip.t_min.high >= clip.t_max.low, clip.t_min.low < clip.t_max.high, clip.t_min,
                  clip.t_max};
}

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(low_is_entry, clipped(in, (Way){.low_is_entry = 1}),
            "that is as if every ray entered at the lower plane: with a negative direction it "
            "enters at the upper one");
    ANSWERS(no_t_min, with_part(*in, -INFINITY, in->t_max),
            "that is as if t_min did not count: it only grows");
    ANSWERS(no_t_max, with_part(*in, in->t_min, INFINITY),
            "that is as if t_max did not count: it only shrinks");
    ANSWERS(
        no_part, with_part(*in, -INFINITY, INFINITY),
        "that is as if neither t_min nor t_max counted: t_min only grows, and t_max only shrinks");
    ANSWERS(from_0, with_part(*in, 0, INFINITY),
            "that is as if the part went from 0 to INFINITY: it comes in *t_min and *t_max");
    ANSWERS(first_entry, clipped(in, (Way){.first_entry = 1}),
            "that is as if the first entry counted: the ray is inside from the last");
    ANSWERS(last_exit, clipped(in, (Way){.last_exit = 1}),
            "that is as if the last exit counted: the ray is inside up to the first");
    ANSWERS(point_missed, clipped(in, (Way){.point_missed = 1}),
            "where t_min and t_max are equal a point is left: that is 1");
    ANSWERS(along_ignored, clipped(in, (Way){.along_ignored = 1}),
            "a ray along the planes of an axis is between them, or never: then it misses the box");
    ANSWERS(along_missed, clipped(in, (Way){.along_missed = 1}),
            "a ray along the planes of an axis may be between them all the way");
    ANSWERS(along_met, clipped(in, (Way){.along_met = 1}),
            "that is as if an axis whose planes the ray goes along decided for the whole box: the "
            "others are to be asked, too");
    ANSWERS(always_met, clipped(in, (Way){.always_met = 1}),
            "when t_min is beyond t_max nothing is left: that is 0");
    EACH(border_divided,
         is_right(job, i, answers) || (!found.is_met && is_in_side(in) && is_divided_by_0(found)),
         "0 / 0 is not a number: for a ray in the plane of a side nothing is to be divided by the "
         "direction, it is inside");
    ANY(border_outside, 3,
        IS_FOUND(clipped(in, (Way){.border_outside = 1 + way})) && !is_divided_by_0(found),
        "strict where it should not be: a ray in the plane of a side is inside",
        MISTAKE_STRICT_BOUNDARY);
    ANSWERS(unstored, not_stored(in),
            "what is left of the ray was not stored: *t_min and *t_max are as they came");
    ANSWERS(exit_ahead, clipped(in, (Way){.exit_ahead = 1}),
            "that is as if it were enough that the exit is ahead: where t_min is beyond t_max "
            "nothing is left");
    ANSWERS(entry_behind, clipped(in, (Way){.entry_behind = 1}),
            "that is as if an entry behind the eye made a miss: the eye may be between the planes, "
            "or in the box");

    ANSWERS(multiplied, clipped(in, (Way){.multiplies = 1}),
            "that is multiplied with the direction: t is the way to the plane divided by it");
    // By 0 is divided with such a mistake, or not.
    EACH(grown,
         in->direction.x * in->direction.y * in->direction.z == 0 ||
             IS_FOUND(clipped(in, (Way){.grows = 1, .last_exit = 1})),
         "that is as if t_max grew: it becomes the smaller of the two, t_min the larger");

    ONE_OF(number_of_one_axis, 6, IS_FOUND(clipped(in, of_one_axis((u32)way % 3 + 1, way < 3))),
           "on every axis the number of one of them was taken: origin and direction are those of "
           "the axis");

    // A bit for each axis; not all of them.
    ANY(skips, 6, IS_FOUND(clipped(in, (Way){.skipped = (u32)way + 1})),
        "that is as if not all of the three axes were asked: the loop ends too soon, or begins too "
        "late");
    ANSWERS(first_decides, clipped(in, (Way){.first_decides = 1}),
            "that is as if the first axis decided: all three are asked before it is known what is "
            "left");
    ANY(along_other, 17, IS_FOUND(clipped(in, (Way){.along_other = 1 + way})),
        "a ray along the planes of an axis is beside them if its origin is below the minimum or "
        "above the maximum: something else is compared");

    ANSWERS(
        min_overwritten, with_min_line(in, (Line){.how = 2, .of = 0}),
        "that is as if each axis overwrote t_min: it becomes the larger of itself and the entry");
    ANSWERS(
        max_overwritten, with_max_line(in, (Line){.how = 2, .of = 1}),
        "that is as if each axis overwrote t_max: it becomes the smaller of itself and the exit");
    EACH(both_overwritten,
         IS_FOUND(lined(in, (Line){.how = 2, .of = 0}, (Line){.how = 2, .of = 1}, (Planes){0})),
         "that is as if each axis overwrote t_min and t_max: t_min only grows, and t_max only "
         "shrinks");
    ANY(min_line, N_LINES, IS_FOUND(with_min_line(in, line_of(way))),
        "t_min becomes the larger of itself and the axis' entry, which is the smaller of the two "
        "t: here it becomes something else");
    ANY(max_line, N_LINES, IS_FOUND(with_max_line(in, line_of(way))),
        "t_max becomes the smaller of itself and the axis' exit, which is the larger of the two t: "
        "here it becomes something else");

    ANY(other_formula, 17, IS_FOUND(lined(in, right_min, right_max, planes_of(way))),
        "t to a plane is the way from the origin to it, divided by the direction: for one of the "
        "two planes, or both, something else is computed");
    EACH(inverted,
         in->direction.x * in->direction.y * in->direction.z == 0 || IS_FOUND(inverted_result(in)),
         "1 and 0 are swapped: something is left if t_min is at most t_max");

    // Of an epsilon, whose size is not known: what comes of a large one.
    ONLY(small_is_along, IS_FOUND(clipped(in, (Way){.small = HAIR})),
         "that is as if a small direction were 0: a ray is along the planes only where it is "
         "exactly 0, without an epsilon");
    ONLY(hair_met, IS_FOUND(clipped(in, (Way){.beside = HAIR})),
         "that is as if a box that is missed by a hair were met: compare without an epsilon");
    ONLY(hair_missed, IS_FOUND(clipped(in, (Way){.shorter = HAIR})),
         "that is as if a part that is short were none: compare without an epsilon");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

// "0", or "1 and [1.5, 3.25]".
static Words clip_words(int is_met, double t_min, double t_max)
{
    return is_met ? words("%d and [%.9g, %.9g]", is_met, t_min, t_max) : words("0");
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const BBox3D box = in->box;
    const Clip right = clipped(in, (Way){0});
    return message_new(
        "box from %s to %s, ray from %s along %s, part [%.9g, %.9g]: found %s, expected %s",
        words_xyz(box.min[0], box.min[1], box.min[2], 6).text,
        words_xyz(box.max[0], box.max[1], box.max[2], 6).text, words_vec3(in->origin, 9).text,
        words_vec3(in->direction, 7).text, in->t_min, in->t_max,
        clip_words(found.is_met, found.t_min, found.t_max).text,
        clip_words(right.may_meet, (right.t_min.low + right.t_min.high) / 2,
                   (right.t_max.low + right.t_max.high) / 2)
            .text);
}

const Function clip_07 = {"clips", N_CLIP_RANGES *N_CLIP_INPUTS, sizeof(ClipAnswer),
                          KNOWING(is_right, describe, known)};

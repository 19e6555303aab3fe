// Judging the answers of lab 07's clip_to_box by double-precision arithmetic. Along an axis, on the
// inputs' grid, nothing is rounded; elsewhere either answer is right where rounding decides.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

enum {
    CLIP_LOW_IS_ENTRY = 1,
    CLIP_T_MIN_IGNORED,
    CLIP_T_MAX_IGNORED,
    CLIP_FIRST_ENTRY,
    CLIP_LAST_EXIT,
    CLIP_PART_IGNORED,
    CLIP_POINT_MISSED,
    CLIP_ALONG_IGNORED,
    CLIP_ALONG_MISSED,
    CLIP_ALWAYS_MET,
    CLIP_BORDER_DIVIDED,
    CLIP_BORDER_OUTSIDE,
    CLIP_NOT_STORED,
    CLIP_FROM_0,
    CLIP_EXIT_AHEAD,
    CLIP_ENTRY_BEHIND,
    CLIP_FIRST_ALONG,
    // Of an epsilon, whose size is not known: the answer is right, or what comes of a large one.
    CLIP_SMALL_IS_ALONG,
    CLIP_HAIR_MET,
    CLIP_HAIR_MISSED,
};
static const Cause clip_mistakes[] = {
    [CLIP_LOW_IS_ENTRY] = {.says = "that is as if every ray entered at the lower plane: with a "
                                   "negative direction it enters at the upper one"},
    [CLIP_T_MIN_IGNORED] = {.says = "that is as if t_min did not count: it only grows"},
    [CLIP_T_MAX_IGNORED] = {.says = "that is as if t_max did not count: it only shrinks"},
    [CLIP_FIRST_ENTRY] =
        {.says = "that is as if the first entry counted: the ray is inside from the last"},
    [CLIP_LAST_EXIT] =
        {.says = "that is as if the last exit counted: the ray is inside up to the first"},
    [CLIP_PART_IGNORED] = {.says = "that is as if neither t_min nor t_max counted: t_min only "
                                   "grows, and t_max only shrinks"},
    [CLIP_POINT_MISSED] = {.says = "where t_min and t_max are equal a point is left: that is 1"},
    [CLIP_ALONG_IGNORED] =
        {.says =
             "a ray along the planes of an axis is between them, or never: then it misses the box"},
    [CLIP_ALONG_MISSED] = {.says =
                               "a ray along the planes of an axis may be between them all the way"},
    [CLIP_BORDER_DIVIDED] = {.says = "0 / 0 is not a number: for a ray in the plane of a side "
                                     "nothing is to be divided by the direction, it is inside"},
    [CLIP_BORDER_OUTSIDE] =
        {"strict where it should not be: a ray in the plane of a side is inside",
         MISTAKE_STRICT_BOUNDARY},
    [CLIP_NOT_STORED] = {.says = "what is left of the ray was not stored: *t_min and *t_max are as "
                                 "they came"},
    [CLIP_FROM_0] = {.says = "that is as if the part went from 0 to INFINITY: it comes in *t_min "
                             "and *t_max"},
    [CLIP_EXIT_AHEAD] = {.says = "that is as if it were enough that the exit is ahead: where t_min "
                                 "is beyond t_max nothing is left"},
    [CLIP_ENTRY_BEHIND] = {.says = "that is as if an entry behind the eye made a miss: the eye may "
                                   "be between the planes, or in the box"},
    [CLIP_FIRST_ALONG] = {.says = "that is as if an axis whose planes the ray goes along decided "
                                  "for the whole box: the others are to be asked, too"},
    [CLIP_ALWAYS_MET] = {.says = "when t_min is beyond t_max nothing is left: that is 0"},
    [CLIP_SMALL_IS_ALONG] = {.says = "that is as if a small direction were 0: a ray is along the "
                                     "planes only where it is exactly 0, without an epsilon"},
    [CLIP_HAIR_MET] =
        {.says =
             "that is as if a box that is missed by a hair were met: compare without an epsilon"},
    [CLIP_HAIR_MISSED] =
        {.says = "that is as if a part that is short were none: compare without an epsilon"},
};

// What may come out.
typedef struct Clip {
    int may_meet, may_miss;
    Span t_min, t_max;
} Clip;

static Span clip_plane(const ClipJob *job, u32 axis, double plane)
{
    const double origin = vector_component(vector_of(job->origin), axis),
                 direction = vector_component(vector_of(job->direction), axis);
    const double t = (plane - origin) / direction;
    const int is_exact = fabs(direction) == 1;
    const double error =
        is_exact ? 0 : PLANE_ERROR * (fabs(plane) + fabs(origin)) / fabs(direction);
    return (Span){t - error, t + error};
}

// Is the ray taken for one along the planes of an axis?
static int is_along(double direction, int mistake)
{
    return direction == 0 || (mistake == CLIP_SMALL_IS_ALONG && fabs(direction) < HAIR);
}

static Clip expected_clip(const ClipJob *job, int mistake)
{
    const int part_counts = mistake != CLIP_PART_IGNORED;
    const double from = mistake == CLIP_FROM_0                         ? 0
                        : part_counts && mistake != CLIP_T_MIN_IGNORED ? (double)job->t_min
                                                                       : -(double)INFINITY;
    const double to = part_counts && mistake != CLIP_T_MAX_IGNORED && mistake != CLIP_FROM_0
                          ? (double)job->t_max
                          : (double)INFINITY;
    const double beside = mistake == CLIP_HAIR_MET ? HAIR : 0;
    Span entry = {-INFINITY, -INFINITY}, exit = {INFINITY, INFINITY};
    int n_axes = 0, is_outside = 0, is_decided = 0;
    for (u32 axis = 0; axis < 3; axis++) {
        const double min = job->box.min[axis], max = job->box.max[axis];
        if (is_along(vector_component(vector_of(job->direction), axis), mistake)) {
            const double origin = vector_component(vector_of(job->origin), axis);
            const int is_border = origin == min || origin == max;
            is_outside |= mistake == CLIP_ALONG_MISSED || origin < min - beside ||
                          origin > max + beside || (mistake == CLIP_BORDER_OUTSIDE && is_border);
            is_decided = mistake == CLIP_FIRST_ALONG;
            if (is_decided) {
                break;
            }
            continue;
        }
        const Span low = clip_plane(job, axis, min), high = clip_plane(job, axis, max);
        const Span in = mistake == CLIP_LOW_IS_ENTRY ? low : span_min(low, high);
        const Span out = mistake == CLIP_LOW_IS_ENTRY ? high : span_max(low, high);
        is_outside |= mistake == CLIP_ENTRY_BEHIND && in.high < 0;
        if (n_axes++ == 0) {
            entry = in;
            exit = out;
        }
        entry = mistake == CLIP_FIRST_ENTRY ? span_min(entry, in) : span_max(entry, in);
        exit = mistake == CLIP_LAST_EXIT ? span_max(exit, out) : span_min(exit, out);
    }
    Clip clip = {.t_min = span_max(entry, (Span){from, from}),
                 .t_max = span_min(exit, (Span){to, to})};
    const int point_counts = mistake != CLIP_POINT_MISSED;
    clip.may_meet = point_counts ? clip.t_min.low <= clip.t_max.high + beside
                                 : clip.t_min.low < clip.t_max.high;
    const double short_part = mistake == CLIP_HAIR_MISSED ? HAIR : 0;
    clip.may_miss = point_counts ? clip.t_min.high > clip.t_max.low - short_part
                                 : clip.t_min.high >= clip.t_max.low;
    if (mistake == CLIP_EXIT_AHEAD) {
        clip.may_meet = clip.t_max.high >= 0;
        clip.may_miss = clip.t_max.low < 0;
    }
    if (mistake == CLIP_NOT_STORED) {
        clip.t_min = (Span){job->t_min, job->t_min};
        clip.t_max = (Span){job->t_max, job->t_max};
    }
    if (mistake == CLIP_ALWAYS_MET || is_decided) {
        clip.may_meet = 1;
        clip.may_miss = 0;
    }
    if (is_outside && mistake != CLIP_ALONG_IGNORED) {
        clip.may_meet = 0;
        clip.may_miss = 1;
    }
    return clip;
}

// Is the ray in the plane of a side?
static int is_in_side(const ClipJob *job)
{
    for (u32 axis = 0; axis < 3; axis++) {
        const float origin = (float)vector_component(vector_of(job->origin), axis);
        if (vector_component(vector_of(job->direction), axis) == 0 &&
            (origin == job->box.min[axis] || origin == job->box.max[axis])) {
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

static int clip_agrees(const void *job, int i, const void *answers, int mistake)
{
    const Inputs07 *inputs = &((const Job07 *)job)->inputs;
    const ClipAnswer found = ((const ClipAnswer *)answers)[i];
    if (mistake >= CLIP_SMALL_IS_ALONG && clip_agrees(job, i, answers, 0)) {
        return 1;
    }
    if (mistake == CLIP_BORDER_DIVIDED && !found.is_met && is_in_side(&inputs->clips[i])) {
        return is_divided_by_0(found);
    }
    const Clip clip = expected_clip(&inputs->clips[i], mistake);
    if (!found.is_met) {
        return clip.may_miss;
    }
    return clip.may_meet && is_within(found.t_min, clip.t_min) &&
           is_within(found.t_max, clip.t_max);
}

// "0", or "1 and [1.5, 3.25]".
static Words clip_words(int is_met, double t_min, double t_max)
{
    return is_met ? words("%d and [%.9g, %.9g]", is_met, t_min, t_max) : words("0");
}

static char *describe_clip(const void *pointer, int i, const void *answers)
{
    const ClipJob *job = &((const Job07 *)pointer)->inputs.clips[i];
    const BBox3D box = job->box;
    const ClipAnswer own = ((const ClipAnswer *)answers)[i];
    const Clip right = expected_clip(job, 0);
    return message_new(
        "box from %s to %s, ray from %s along %s, part [%.9g, %.9g]: found %s, expected %s",
        words_xyz(box.min[0], box.min[1], box.min[2], 6).text,
        words_xyz(box.max[0], box.max[1], box.max[2], 6).text, words_vec3(job->origin, 9).text,
        words_vec3(job->direction, 7).text, job->t_min, job->t_max,
        clip_words(own.is_met, own.t_min, own.t_max).text,
        clip_words(right.may_meet, (right.t_min.low + right.t_min.high) / 2,
                   (right.t_max.low + right.t_max.high) / 2)
            .text);
}

const Function clip_07 = {"clips", N_CLIP_RANGES *N_CLIP_INPUTS, sizeof(ClipAnswer),
                          COMPARED(clip_agrees, describe_clip, clip_mistakes)};

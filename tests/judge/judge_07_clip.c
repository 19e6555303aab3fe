// Judging the answers of lab 07's clip_to_box by double-precision arithmetic. Along an axis, on the
// inputs' grid, nothing is rounded; elsewhere either answer is right where rounding decides.
#include "judge_07_range.h"
#include "message.h"

#include <math.h>

enum {
    CLIP_LOW_IS_ENTRY = 1,
    CLIP_T_MIN_IGNORED,
    CLIP_T_MAX_IGNORED,
    CLIP_FIRST_ENTRY,
    CLIP_LAST_EXIT,
    CLIP_POINT_MISSED,
    CLIP_ALONG_IGNORED,
    CLIP_ALONG_MISSED,
    CLIP_ALWAYS_MET,
    CLIP_BORDER_DIVIDED,
    CLIP_BORDER_OUTSIDE,
};
static const char *const clip_mistakes[] = {
    [CLIP_LOW_IS_ENTRY] = "; that is as if every ray entered at the lower plane: with a negative "
                          "direction it enters at the upper one",
    [CLIP_T_MIN_IGNORED] = "; that is as if t_min did not count: it only grows",
    [CLIP_T_MAX_IGNORED] = "; that is as if t_max did not count: it only shrinks",
    [CLIP_FIRST_ENTRY] = "; that is as if the first entry counted: the ray is inside from the last",
    [CLIP_LAST_EXIT] = "; that is as if the last exit counted: the ray is inside up to the first",
    [CLIP_POINT_MISSED] = "; where t_min and t_max are equal a point is left: that is 1",
    [CLIP_ALONG_IGNORED] = "; a ray along the planes of an axis is between them, or never: then it "
                           "misses the box",
    [CLIP_ALONG_MISSED] = "; a ray along the planes of an axis may be between them all the way",
    [CLIP_BORDER_DIVIDED] =
        "; 0 / 0 is not a number: for a ray in the plane of a side nothing is to "
        "be divided by the direction, it is inside",
    [CLIP_BORDER_OUTSIDE] = "; strict where it should not be: a ray in the plane of a side is "
                            "inside",
    [CLIP_ALWAYS_MET] = "; when t_min is beyond t_max nothing is left: that is 0",
};

// What may come out.
typedef struct Clip {
    int may_meet, may_miss;
    Span t_min, t_max;
} Clip;

static double along(Vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static Span clip_plane(const ClipJob *job, int axis, double plane)
{
    const double origin = along(job->origin, axis), direction = along(job->direction, axis);
    const double t = (plane - origin) / direction;
    const int is_exact = fabs(direction) == 1;
    const double error =
        is_exact ? 0 : PLANE_ERROR * (fabs(plane) + fabs(origin)) / fabs(direction);
    return (Span){t - error, t + error};
}

static Span later(Span a, Span b)
{
    return (Span){fmax(a.low, b.low), fmax(a.high, b.high)};
}

static Span earlier(Span a, Span b)
{
    return (Span){fmin(a.low, b.low), fmin(a.high, b.high)};
}

static Clip expected_clip(const ClipJob *job, int mistake)
{
    const double from = mistake == CLIP_T_MIN_IGNORED ? -(double)INFINITY : (double)job->t_min;
    const double to = mistake == CLIP_T_MAX_IGNORED ? (double)INFINITY : (double)job->t_max;
    Span entry = {-INFINITY, -INFINITY}, exit = {INFINITY, INFINITY};
    int n_axes = 0, is_outside = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double min = job->box.min[axis], max = job->box.max[axis];
        if (along(job->direction, axis) == 0) {
            const double origin = along(job->origin, axis);
            const int is_border = origin == min || origin == max;
            is_outside |= mistake == CLIP_ALONG_MISSED || origin < min || origin > max ||
                          (mistake == CLIP_BORDER_OUTSIDE && is_border);
            continue;
        }
        const Span low = clip_plane(job, axis, min), high = clip_plane(job, axis, max);
        const Span in = mistake == CLIP_LOW_IS_ENTRY ? low : earlier(low, high);
        const Span out = mistake == CLIP_LOW_IS_ENTRY ? high : later(low, high);
        if (n_axes++ == 0) {
            entry = in;
            exit = out;
        }
        entry = mistake == CLIP_FIRST_ENTRY ? earlier(entry, in) : later(entry, in);
        exit = mistake == CLIP_LAST_EXIT ? later(exit, out) : earlier(exit, out);
    }
    Clip clip = {.t_min = later(entry, (Span){from, from}), .t_max = earlier(exit, (Span){to, to})};
    const int point_counts = mistake != CLIP_POINT_MISSED;
    clip.may_meet =
        point_counts ? clip.t_min.low <= clip.t_max.high : clip.t_min.low < clip.t_max.high;
    clip.may_miss =
        point_counts ? clip.t_min.high > clip.t_max.low : clip.t_min.high >= clip.t_max.low;
    if (mistake == CLIP_ALWAYS_MET) {
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
    for (int axis = 0; axis < 3; axis++) {
        const float origin = (float)along(job->origin, axis);
        if (along(job->direction, axis) == 0 &&
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

static int clip_agrees(const Inputs07 *inputs, int i, const void *answers, int mistake)
{
    const ClipAnswer found = ((const ClipAnswer *)answers)[i];
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
static void describe_clip(char *text, size_t n_bytes, int is_met, double t_min, double t_max)
{
    snprintf(text, n_bytes, is_met ? "%d and [%.7g, %.7g]" : "%d", is_met, t_min, t_max);
}

Verdict inputs_07_judge_clips(const Inputs07 *inputs, int range, const Sections *answers)
{
    const ClipAnswer *found =
        sections_find(answers, "clips", sizeof *found * (size_t)COUNT(inputs->clips));
    if (found == NULL) {
        return verdict_missing;
    }
    const Wrong wrong =
        range_judge(&(Range){inputs, found, sizeof *found, range * N_CLIP_INPUTS, N_CLIP_INPUTS,
                             clip_agrees, clip_mistakes, COUNT(clip_mistakes)});
    if (wrong.n == 0) {
        return verdict_of(NULL);
    }
    const ClipJob *job = &inputs->clips[wrong.first];
    const ClipAnswer own = found[wrong.first];
    const Clip right = expected_clip(job, 0);
    char own_text[64], right_text[64];
    describe_clip(own_text, sizeof own_text, own.is_met, own.t_min, own.t_max);
    describe_clip(right_text, sizeof right_text, right.may_meet,
                  (right.t_min.low + right.t_min.high) / 2,
                  (right.t_max.low + right.t_max.high) / 2);
    return verdict_of(message_new(
        "box from (%g, %g, %g) to (%g, %g, %g), ray from (%g, %g, %g) along (%.7g, %.7g, %.7g), "
        "part [%g, %g]: found %s, expected %s (%d of %d inputs are wrong)%s",
        (double)job->box.min[0], (double)job->box.min[1], (double)job->box.min[2],
        (double)job->box.max[0], (double)job->box.max[1], (double)job->box.max[2],
        (double)job->origin.x, (double)job->origin.y, (double)job->origin.z,
        (double)job->direction.x, (double)job->direction.y, (double)job->direction.z,
        (double)job->t_min, (double)job->t_max, own_text, right_text, wrong.n, N_CLIP_INPUTS,
        wrong.why));
}

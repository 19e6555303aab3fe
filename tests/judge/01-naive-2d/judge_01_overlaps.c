// Lab 01: overlaps_N_Nearer on chosen inputs. See judge_01.h.
#include "judge_01.h"

#include "message.h"
#include "oracle2d.h"
#include "words.h"

#include <math.h>

// ---- Mistakes --------------------------------------------------------------------------

// Does a wrong answer fit a mistake?
typedef int Fits(OverlapJob in, int found);

static int is_true_but_not_1(OverlapJob in, int found)
{
    return found != 0 && found != 1 && outside_by_01(in) <= 0 && in.circle.depth < in.minDepth;
}

static int is_equal_depth(OverlapJob in, int found)
{
    return found && in.circle.depth == in.minDepth;
}

static int is_little_farther(OverlapJob in, int found)
{
    return found && in.circle.depth >= in.minDepth && (double)in.circle.depth - in.minDepth < SMALL;
}

static int is_not_nearer(OverlapJob in, int found)
{
    return found && in.circle.depth >= in.minDepth;
}

static int is_little_nearer(OverlapJob in, int found)
{
    return !found && (double)in.minDepth - in.circle.depth < SMALL;
}

static int is_on_boundary(OverlapJob in, int found)
{
    return !found && outside_by_01(in) == 0;
}

static int has_no_radius(OverlapJob in, int found)
{
    return !found && in.circle.radius == 0;
}

static int is_little_outside(OverlapJob in, int found)
{
    return found && outside_by_01(in) > 0 && outside_by_01(in) < SMALL;
}

// By so little that a root which is rounded to float, by up to 3 ulp (OpenCL 1.2, 7.4), may be the
// reason, on whatever device.
static int is_outside_by_rounding(OverlapJob in, int found)
{
    const double radius = in.circle.radius;
    return found && outside_by_01(in) > 0 && outside_by_01(in) <= 16 * 0x1p-24 * radius * radius;
}

// The first that fits every wrong answer is named.
static const struct {
    Fits *fits;
    Cause cause;
} overlap_mistakes[] = {
    {is_true_but_not_1,
     {.says = "the answers are 1 and 0, and no other number for true (vectors say -1)"}},
    {is_equal_depth,
     {"nearer is strict: a circle at equal depth does not take the pixel",
      MISTAKE_LATER_OF_EQUALS}},
    {is_little_farther, {.says = "a circle farther by however little is not nearer: no epsilon"}},
    {is_not_nearer, {.says = "the circle is not nearer than what the pixel has seen"}},
    {is_little_nearer, {.says = "a circle nearer by however little takes the pixel: no epsilon"}},
    {has_no_radius, {.says = "a circle of radius 0 covers its centre: the boundary belongs to it"}},
    {is_on_boundary,
     {"strict where it should not be: the boundary belongs to the circle",
      MISTAKE_STRICT_BOUNDARY}},
    {is_outside_by_rounding,
     {.says = "a pixel outside by however little is outside: no root, which is rounded, and no "
              "epsilon"}},
    {is_little_outside,
     {.says = "a pixel outside by however little is outside: no epsilon, and nothing rounded"}},
};

// The right answer for a sample point that is `offset` away from the pixel's.
static int expected_overlap(OverlapJob in, double offset)
{
    return oracle2d_covers(in.circle, in.x + offset, in.y + offset) &&
           in.circle.depth < in.minDepth;
}

// ---- Rivals -------------------------------------------------------------------------------------

// What a known mistake answers to any input.

static int covers_from_middle(OverlapJob in)
{
    return expected_overlap(in, 0.5);
}

static int covers_from_corner(OverlapJob in)
{
    return expected_overlap(in, -0.5);
}

// With other distances from the centre, in other relations to the radius.
static int is_within(OverlapJob in, double distance_squared, double radius_squared)
{
    return distance_squared <= radius_squared && in.circle.depth < in.minDepth;
}

static double from_centre(double pixel, double centre)
{
    return fabs(pixel - centre);
}

static int is_in_square(OverlapJob in)
{
    const double dx = from_centre(in.x, in.circle.x), dy = from_centre(in.y, in.circle.y);
    return is_within(in, fmax(dx, dy), in.circle.radius);
}

static int is_in_diamond(OverlapJob in)
{
    const double dx = from_centre(in.x, in.circle.x), dy = from_centre(in.y, in.circle.y);
    return is_within(in, dx + dy, in.circle.radius);
}

static int covers_by_radius(OverlapJob in)
{
    const double radius = in.circle.radius;
    return is_within(in, outside_by_01(in) + radius * radius, radius);
}

static int covers_by_root(OverlapJob in)
{
    const float dx = (float)in.x - in.circle.x, dy = (float)in.y - in.circle.y;
    return is_within(in, sqrtf(dx * dx + dy * dy), in.circle.radius);
}

static int covers_by_half(OverlapJob in)
{
    const double radius = in.circle.radius;
    return is_within(in, outside_by_01(in) + radius * radius, radius * radius / 4);
}

static int covers_by_x(OverlapJob in)
{
    const double dx = from_centre(in.x, in.circle.x), radius = in.circle.radius;
    return is_within(in, 2 * dx * dx, radius * radius);
}

static int covers_from_whole_centre(OverlapJob in)
{
    in.circle.x = truncf(in.circle.x);
    in.circle.y = truncf(in.circle.y);
    return expected_overlap(in, 0);
}

static int covers_by_whole_differences(OverlapJob in)
{
    const double dx = trunc(from_centre(in.x, in.circle.x));
    const double dy = trunc(from_centre(in.y, in.circle.y)), radius = in.circle.radius;
    return is_within(in, dx * dx + dy * dy, radius * radius);
}

// With other depths.
static int is_nearer_by_amount(OverlapJob in)
{
    in.circle.depth = fabsf(in.circle.depth);
    in.minDepth = fabsf(in.minDepth);
    return expected_overlap(in, 0);
}

static int is_nearer_than_1(OverlapJob in)
{
    return in.circle.depth < 1 && expected_overlap(in, 0);
}

static int is_not_behind_the_eye(OverlapJob in)
{
    return in.circle.depth >= 0 && expected_overlap(in, 0);
}

static int is_farther(OverlapJob in)
{
    return in.circle.depth > in.minDepth && oracle2d_covers(in.circle, in.x, in.y);
}

#define HALF_A_PIXEL                                                                               \
    {"shifted by half a pixel: the sample point is the integer coordinate", MISTAKE_SHIFTED_HALF}
#define WHOLE_NUMBERS                                                                              \
    {.says = "your answers are those of whole-numbered distances: a centre lies between pixels"}

static const struct {
    int (*answer)(OverlapJob in);
    Cause cause;
} overlap_rivals[] = {
    {covers_from_middle, HALF_A_PIXEL},
    {covers_from_corner, HALF_A_PIXEL},
    {is_in_square, {.says = "the pixel is in the circle's bounding square but not in the circle"}},
    {is_in_diamond,
     {.says = "your answers are those of |dx| + |dy|, and the distance² is dx² + dy²"}},
    {covers_by_radius,
     {.says = "your answers are those of distance² <= radius, without its square"}},
    {covers_by_half, {.says = "your answers are those of half the radius"}},
    {covers_by_root,
     {.says = "your answers are those of a root, which is rounded: compare the squares"}},
    {covers_by_x, {.says = "your answers are those of dx² + dx²: y has no part in them"}},
    {covers_from_whole_centre, WHOLE_NUMBERS},
    {covers_by_whole_differences, WHOLE_NUMBERS},
    {is_nearer_by_amount,
     {.says = "your answers are those of depths without their sign: -2 is nearer than 1"}},
    {is_nearer_than_1, {.says = "your answers are those of a largest depth of 1: there is none"}},
    {is_not_behind_the_eye,
     {.says = "circles of negative depth were refused: a depth may be any number"}},
    {is_farther, {.says = "the farther circle took the pixel: the smaller depth is the nearer"}},
};

// Does a rival give all answers, of all ranges?
static int is_rival(const Job01 *job, const i32 *answers, int rival)
{
    int i = 0;
    while (i < N_OVERLAPS && answers[i] == overlap_rivals[rival].answer(job->overlaps[i])) {
        i++;
    }
    return i == N_OVERLAPS;
}

static int overlap_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    (void)mistake;
    return ((const i32 *)answers)[i] == expected_overlap(((const Job01 *)pointer)->overlaps[i], 0);
}

// Does a mistake fit all wrong answers?
static int fits_all(const Job01 *job, Range range, const i32 *answers, Fits *fits)
{
    for (int k = 0; k < range.n; k++) {
        const int i = range_at(range, k);
        if (!overlap_agrees(job, i, answers, 0) && !fits(job->overlaps[i], answers[i])) {
            return 0;
        }
    }
    return 1;
}

// A cause is named only when it explains every wrong answer.
static Cause explain_overlaps(const void *job, Range range, const void *answers)
{
    for (int i = 0; i < COUNT(overlap_rivals); i++) {
        if (is_rival(job, answers, i)) {
            return overlap_rivals[i].cause;
        }
    }
    for (int i = 0; i < COUNT(overlap_mistakes); i++) {
        if (fits_all(job, range, answers, overlap_mistakes[i].fits)) {
            return overlap_mistakes[i].cause;
        }
    }
    return (Cause){0};
}

static char *describe_overlap(const void *pointer, int i, const void *answers)
{
    const OverlapJob in = ((const Job01 *)pointer)->overlaps[i];
    return message_new(
        "pixel (%d, %d), circle at %s depth %.9g, minDepth %.9g: found %d, expected %d", in.x, in.y,
        words_circle(in.circle).text, in.circle.depth, in.minDepth, ((const i32 *)answers)[i],
        expected_overlap(in, 0));
}

const Function overlaps_01 = {"overlaps", N_OVERLAPS, sizeof(i32),
                              EXPLAINED(overlap_agrees, describe_overlap, explain_overlaps)};

// Lab 10: from where to where do the rays of a tile meet a plane? Rolled and judged.
//
// A right answer is as wide as rounding makes it: each end is one ray's distance, by one difference
// and one division.
#include "judge_10.h"

#include "message.h"
#include "random3d.h"

#include <math.h>

// ---- Rolling ------------------------------------------------------------------------------------

static TilePlaneJob roll_plane(Random *random, enum PlaneRange10 range)
{
    TilePlaneJob job = {.eye = random_number(random, -4, 4)};
    // Small and large scenes; the directions of a tile lie close together.
    const float scale = ldexpf(1, (int)random_integer(random, -10, 10));
    const float spread = random_number(random, 0.0078125, 0.125);
    const float sign = (float)random_sign(random);
    job.plane = job.eye + sign * random_number(random, 0.125, 4);
    job.low = random_number(random, 0.0625, 0.75);
    job.high = job.low + spread;
    if (range == TILES_BOTH_WAYS || (range == TILES_ON_PLANE && random_integer(random, 0, 1))) {
        const float share = random_number(random, 0, 1);
        job.low = -share * spread;
        job.high = (1 - share) * spread;
        const int end = (int)random_integer(random, 0, 5);
        job.low = end == 0 ? 0 : end == 1 ? -0.0f : job.low;
        job.high = end == 2 ? 0 : end == 3 ? -0.0f : job.high;
        job.high = job.high < job.low ? job.low : job.high;
    } else if (random_integer(random, 0, 1)) {
        const float low = job.low;
        job.low = -job.high;
        job.high = -low;
    }
    job.plane = range == TILES_ON_PLANE && random_integer(random, 0, 7) ? job.eye : job.plane;
    job.eye *= scale;
    job.plane *= scale;
    return job;
}

// The last of each range, in every job: directions far below any epsilon, down to those just above
// what a device may take for 0 (2^-126); eyes that are the least beside the plane; and rays that
// are all parallel on this axis, slow and quick ones.
static const struct {
    enum PlaneRange10 range;
    TilePlaneJob job;
} plane_edges[] = {
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = 0x1p-30f, .high = 0x1p-29f}},
    {TILES_ONE_WAY, {.plane = -1, .eye = 0, .low = -0x1p-100f, .high = -0x1p-101f}},
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = 0.03125f, .high = 0.03125f}},
    {TILES_ONE_WAY, {.plane = -1, .eye = 1, .low = -0.0625f, .high = -0.0625f}},
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = -0.03125f, .high = -0.03125f}},
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = 0x1p-30f, .high = 0x1p-30f}},
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = 0.5f, .high = 0.5f}},
    {TILES_ONE_WAY, {.plane = -1, .eye = 1, .low = -0.5f, .high = -0.5f}},
    {TILES_BOTH_WAYS, {.plane = 1, .eye = 0, .low = 0, .high = 0}},
    {TILES_BOTH_WAYS, {.plane = -1, .eye = 0, .low = 0, .high = 0}},
    {TILES_ON_PLANE, {.plane = 1, .eye = 1, .low = 0.03125f, .high = 0.03125f}},
    {TILES_ONE_WAY, {.plane = 1, .eye = 0, .low = 0x1p-125f, .high = 0x1p-124f}},
    {TILES_BOTH_WAYS, {.plane = 1, .eye = 0, .low = -0x1p-125f, .high = 0x1p-125f}},
    {TILES_BOTH_WAYS, {.plane = 1, .eye = 0, .low = -0x1p-30f, .high = 0x1p-30f}},
    {TILES_BOTH_WAYS, {.plane = -1, .eye = 0, .low = -0x1p-100f, .high = 0.125f}},
    {TILES_ON_PLANE, {.plane = 1, .eye = 0x1.000002p+0f, .low = -0.5f, .high = -0.25f}},
    {TILES_ON_PLANE, {.plane = 1, .eye = 0x1.000002p+0f, .low = 0.25f, .high = 0.5f}},
    {TILES_ON_PLANE, {.plane = 1, .eye = 0x1.fffffep-1f, .low = 0.25f, .high = 0.5f}},
    {TILES_ON_PLANE, {.plane = 1, .eye = 0x1.fffffep-1f, .low = -0.5f, .high = -0.25f}},
    {TILES_ON_PLANE, {.plane = 0, .eye = 0x1p-100f, .low = -0.5f, .high = -0.25f}},
    {TILES_ON_PLANE, {.plane = 0, .eye = -0x1p-100f, .low = 0.25f, .high = 0.5f}},
};

void roll_planes_10(Random *random, Job10 *job)
{
    int n_set[N_PLANE_RANGES_10] = {0};
    for (int i = 0; i < COUNT(job->planes); i++) {
        job->planes[i] = roll_plane(random, (enum PlaneRange10)(i / N_TILE_PLANE_INPUTS));
    }
    for (int i = 0; i < COUNT(plane_edges); i++) {
        const enum PlaneRange10 range = plane_edges[i].range;
        job->planes[((int)range + 1) * N_TILE_PLANE_INPUTS - ++n_set[range]] = plane_edges[i].job;
    }
}

#define GIVEN                                                                                      \
    const TilePlaneJob *in = &((const Job10 *)job)->planes[i];                                     \
    const TilePlaneAnswer found = ((const TilePlaneAnswer *)answers)[i]
#define IS_FOUND(ends) is_near(in, found, ends)

// ---- Right --------------------------------------------------------------------------------------

typedef struct Ends {
    double low, high;
} Ends;

// One rounding for the difference, five for the division (2.5 ulp, OpenCL 1.2, 7.4), or an inverse
// and a product in its place: PLANE_ERROR of oracle3d_rounding.h.
static int is_end(const TilePlaneJob *in, float found, double expected)
{
    if (!isfinite(expected)) {
        return isnan(expected) ? isnan(found) : (double)found == expected;
    }
    const double way = fabs((double)in->plane - (double)in->eye);
    const double rounding = 0x1p-20 * (fabs((double)in->plane) + fabs((double)in->eye));
    return fabs((double)found - expected) <=
           fabs(expected) * (way > 0 ? rounding / way : 0) + 0x1p-20 * fabs(expected);
}

static int is_near(const TilePlaneJob *in, TilePlaneAnswer found, Ends expected)
{
    return is_end(in, found.low, expected.low) && is_end(in, found.high, expected.high);
}

// An end of the interval: whose direction it is, and whether that leads from the eye to the plane.
typedef struct End {
    double direction, way;
    int meets;
} End;

static int is_lower(const TilePlaneJob *in)
{
    return in->eye <= in->plane;
}

// The first ray to meet the plane, or the last, of an eye on its lower side or on the upper one.
static End end_of(const TilePlaneJob *in, int is_last, int of_lower)
{
    const double direction = of_lower != is_last ? in->high : in->low;
    return (End){direction, (double)in->plane - (double)in->eye,
                 of_lower ? direction > 0 : direction < 0};
}

// Where a ray of this end meets the plane.
typedef double Distance(End end);
static double right(End end)
{
    return end.meets ? end.way / end.direction : INFINITY;
}

static Ends from_side(const TilePlaneJob *in, Distance *distance, int of_lower)
{
    return (Ends){distance(end_of(in, 0, of_lower)), distance(end_of(in, 1, of_lower))};
}

static Ends by(const TilePlaneJob *in, Distance *distance)
{
    return from_side(in, distance, is_lower(in));
}

static Ends right_ends(const TilePlaneJob *in)
{
    return by(in, right);
}

RIGHT(is_right, IS_FOUND(right_ends(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

static Ends sorted(Ends ends)
{
    return (Ends){fmin(ends.low, ends.high), fmax(ends.low, ends.high)};
}

// By where a ray meets the plane.
#define MEETS(name, distance, ...)                                                                 \
    for (int is_last = 0; number == 0 && is_last <= 1; is_last++) {                                \
        const End end = end_of(in, is_last, of_lower);                                             \
        const double direction = end.direction, way = end.way;                                     \
        const int meets = end.meets;                                                               \
        (void)way;                                                                                 \
        *(is_last ? &met.high : &met.low) = distance;                                              \
    }                                                                                              \
    ANSWERS(name, met, __VA_ARGS__)

#define BEHIND_MET "rays that go away from the plane never meet it: their distance is INFINITY"
static double quotient(End end)
{
    return end.way / end.direction;
}

static double sizes(End end)
{
    return fabs(end.way) / fabs(end.direction);
}

#define BEHIND_AT_0                                                                                \
    "rays that go away from the plane count as if they met it at the eye: they never do, their "   \
    "distance is INFINITY"
static Ends cut_at_0(Ends ends)
{
    return ends.low < 0 && ends.high < 0
               ? (Ends){INFINITY, INFINITY}
               : (Ends){fmax(0, fmin(ends.low, ends.high)), fmax(ends.low, ends.high)};
}

// Below that a direction, or the way to the plane, was taken for 0 by an epsilon: what many write,
// or what lies between two sizes of the edges above.
#define MILLIONTH 0x1p-20
#define LEAST 0x1p-60

#define GUARDED                                                                                    \
    "a small direction is not what never meets the plane: ask whether the rays of this end go to " \
    "it, by the direction's sign and without an epsilon"
static double guarded(End end)
{
    return fabs(end.direction) < MILLIONTH ? INFINITY : quotient(end);
}

// By an epsilon of whatever size.
static int is_lost(double direction, float found)
{
    return direction != 0 && fabs(direction) < 0.01 && found == INFINITY;
}

// By the order of the ends.
static Ends swapped(Ends ends)
{
    return (Ends){ends.high, ends.low};
}

// Where the eye is on the plane, or near it.
#define EYE_ON_IT "with the eye on the plane, rays that go up meet it, at 0, and others never"
#define EYE_BESIDE "an eye beside the plane is not on it, however near it is: without an epsilon"

static Ends ends_if(const TilePlaneJob *in, int is_so, double low, double high)
{
    return is_so ? (Ends){low, high} : right_ends(in);
}

// For an eye below or above, one of the two ends is another: the way divided by one of the two
// directions, if one of them is above 0 or below, or may be 0, or in any case.
static Ends with_end(const TilePlaneJob *in, int way)
{
    const int of_lower = way & 1, of_high = way >> 1 & 1, by_high = way >> 2 & 1,
              asks_high = way >> 3 & 1, if_not_0 = way >> 4 & 1, condition = way >> 5;
    const double direction = asks_high ? in->high : in->low;
    const int meets[] = {direction > 0, direction >= 0, direction < 0, direction <= 0, 1, 0};
    const double end = meets[condition]
                           ? ((double)in->plane - in->eye) / (by_high ? in->high : in->low)
                       : if_not_0 ? 0
                                  : INFINITY;
    const Ends ends = right_ends(in);
    return of_lower != is_lower(in) ? ends
           : of_high                ? (Ends){ends.low, end}
                                    : (Ends){end, ends.high};
}

// Only the first ray was asked whether it meets the plane: the last one's distance is a quotient.
static Ends last_unasked(const TilePlaneJob *in)
{
    const Ends ends = right_ends(in);
    return isinf(ends.low) ? ends : (Ends){ends.low, by(in, quotient).high};
}

KNOWN_LIST(known)
{
    GIVEN;
    const int of_lower = is_lower(in), both_ways = in->low < 0 && in->high > 0,
              is_slow = fabs((double)in->low) < 0.09375;  // of the edges' parallel rays
    const double apart = fabs((double)in->plane - (double)in->eye);
    const Ends ends = right_ends(in);
    Ends met = {0};

    MEETS(backwards, meets ? -way / direction : INFINITY,
          "the way goes from the eye to the plane, not back");
    MEETS(from_0, meets ? (double)in->plane / direction : INFINITY,
          "the distance is computed without the eye");
    MEETS(upside_down, meets ? direction / way : INFINITY,
          "the quotient is upside down: the way is divided by the direction");
    MEETS(multiplied, meets ? way * direction : INFINITY,
          "the way is divided by the direction, not multiplied");
    MEETS(minus_infinity, meets ? way / direction : -INFINITY,
          "what is never met is at INFINITY, not at -INFINITY");
    MEETS(never_from_0,
          meets      ? way / direction
          : !is_last ? 0
                     : INFINITY,
          "where no ray meets the plane both ends are INFINITY, not the greatest distance alone");
    EACH(never_is_large,
         (isinf(ends.low) ? isfinite(found.low) && found.low > 1e6f
                          : is_end(in, found.low, ends.low)) &&
             (isinf(ends.high) ? isfinite(found.high) && found.high > 1e6f
                               : is_end(in, found.high, ends.high)),
         "what is never met is at INFINITY, not at a large number");

#define ALONG "a ray along the plane never meets it: nothing is divided by a direction of 0"
    MEETS(along_first, meets || (!is_last && direction == 0) ? way / direction : INFINITY, ALONG);
    MEETS(along_last, meets || (is_last && direction == 0) ? way / direction : INFINITY, ALONG);
    MEETS(along_both, meets || direction == 0 ? way / direction : INFINITY, ALONG);

    ANSWERS(behind_met, by(in, quotient), BEHIND_MET);
    ANSWERS(behind_sorted, sorted(by(in, quotient)), BEHIND_MET);
    ANSWERS(behind_by_sizes, sorted(by(in, sizes)), BEHIND_MET);

    MEETS(behind_at_0, meets ? way / direction : 0, BEHIND_AT_0);
    ANSWERS(behind_cut_at_0, cut_at_0(by(in, quotient)), BEHIND_AT_0);

#define BARE                                                                                       \
    "each end is the quotient as it is: ask first on which side of the plane the eye is, and "     \
    "then of each end whether its rays go to the plane; if not, it is INFINITY"
    ANSWERS(bare, from_side(in, quotient, 1), BARE);
    ANSWERS(bare_low_first, swapped(from_side(in, quotient, 1)), BARE);

    ANSWERS(behind_guarded, by(in, guarded), GUARDED);
    ANSWERS(sorted_guarded, sorted(by(in, guarded)), GUARDED);
    ANSWERS(bare_guarded, from_side(in, guarded, 1), GUARDED);
    ANSWERS(bare_low_guarded, swapped(from_side(in, guarded, 1)), GUARDED);

    ONLY(small_is_0,
         (is_end(in, found.low, ends.low) || is_lost(of_lower ? in->high : in->low, found.low)) &&
             (is_end(in, found.high, ends.high) ||
              is_lost(of_lower ? in->low : in->high, found.high)),
         "no small number is 0: rays that go to the plane meet it, however slowly, without an "
         "epsilon");

    ANSWERS(ends_swapped, swapped(ends),
            "the ends are swapped: the least distance is the first one");
    ANSWERS(ends_of_one_side, of_lower ? ends : swapped(ends),
            "the ends are right for an eye below the plane only: from above, the lowest direction "
            "meets it first");
    ANSWERS(one_end, ((Ends){ends.low, ends.low}), "both ends are the least distance");

    ANSWERS(eye_never, ends_if(in, in->eye == in->plane, INFINITY, INFINITY), EYE_ON_IT);
    ANSWERS(eye_at_0, ends_if(in, in->eye == in->plane, 0, 0), EYE_ON_IT);
    ANSWERS(eye_from_0, ends_if(in, in->eye == in->plane, 0, INFINITY), EYE_ON_IT);
    ANSWERS(eye_is_upper, from_side(in, right, in->eye < in->plane),
            "an eye on the plane counts to the lower side: rays that go up meet it, at 0");
    ANSWERS(eye_near, from_side(in, right, of_lower || apart < MILLIONTH), EYE_BESIDE);
    ANSWERS(eye_nearer, from_side(in, right, of_lower || apart < LEAST), EYE_BESIDE);

    // Where the rays go both ways, or all the same one.
#define PARALLEL                                                                                   \
    "where all rays go the same way, low and high equal, they meet the plane at one distance, or " \
    "never: however slow they are"
    ANSWERS(both_ways_never, ends_if(in, both_ways, INFINITY, INFINITY),
            "where rays go both ways, those that go to the plane do meet it: the least distance is "
            "theirs");
    ANSWERS(both_ways_always, ends_if(in, both_ways, 0, INFINITY),
            "where rays go both ways, the interval is wider than it has to be: it begins with the "
            "first ray that meets it");
    ANSWERS(
        never_for_all, ends_if(in, isinf(ends.low) || isinf(ends.high), INFINITY, INFINITY),
        "where some rays never meet it, the others do all the same: each end is asked by itself");
    ANSWERS(parallel_any, ends_if(in, in->low == in->high, 0, INFINITY), PARALLEL);
    ANSWERS(parallel_slow, ends_if(in, in->low == in->high && is_slow, 0, INFINITY), PARALLEL);

    // 0 divided by 0 comes out as the student's comparisons have it.
    ANY(other_end, 6 * 32,
        IS_FOUND(with_end(in, way)) || isnan(with_end(in, way).low) ||
            isnan(with_end(in, way).high),
        "one of the ends is wrong, for an eye on one side of the plane: each is the way divided by "
        "its own direction if that leads to the plane, and else INFINITY");
    ANY(other_side, 2,
        IS_FOUND(from_side(in, right, way ? in->eye > in->plane : in->eye >= in->plane)),
        "the eye's side is inverted: from below the rays that go up meet the plane, from above "
        "those that go down");
    MEETS(eye_added, meets ? ((double)in->plane + in->eye) / direction : INFINITY,
          "the way is the plane minus the eye, not their sum");

    ANSWERS(unasked_last, last_unasked(in),
            "only the first ray is asked whether it goes to the plane: the last one may never meet "
            "it, and is to be asked, too");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const Ends expected = right_ends(in);
    return message_new("plane at %.9g, eye at %.9g, directions from %.9g to %.9g: found [%.9g, "
                       "%.9g], expected [%.9g, %.9g]",
                       in->plane, in->eye, in->low, in->high, found.low, found.high, expected.low,
                       expected.high);
}

const Function tile_plane_10 = {"tile_planes", N_TILE_PLANES, sizeof(TilePlaneAnswer),
                                KNOWING(is_right, describe, known)};

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

// ---- Judging ------------------------------------------------------------------------------------

enum {
    PLANE_ENDS_SWAPPED = 1,
    PLANE_ENDS_OF_ONE_SIDE,
    PLANE_BEHIND_MET,
    PLANE_BEHIND_AT_0,
    PLANE_BOTH_WAYS_NEVER,
    PLANE_BOTH_WAYS_ALWAYS,
    PLANE_EYE_IS_UPPER,
    PLANE_EYE_NEVER,
    PLANE_BACKWARDS,
    PLANE_FROM_0,
    PLANE_ONE_END,
    PLANE_NEVER_IS_LARGE,
    PLANE_NEVER_FOR_ALL,
    PLANE_BARE,
    PLANE_BARE_LOW_FIRST,
    PLANE_BEHIND_GUARDED,
    PLANE_SORTED_GUARDED,
    PLANE_BARE_GUARDED,
    PLANE_BARE_LOW_GUARDED,
    PLANE_EPSILON,
    PLANE_EPSILON_TINY,
    PLANE_EPSILON_LEAST,
    PLANE_EPSILON_100TH,
    PLANE_EPSILON_1000TH,
    PLANE_EPSILON_E4,
    PLANE_EPSILON_E5,
    PLANE_EPSILON_FIRST,
    PLANE_EPSILON_LAST,
    PLANE_EYE_NEAR,
    PLANE_EYE_NEARER,
    PLANE_EYE_AT_0,
    PLANE_EYE_FROM_0,
    PLANE_BEHIND_SORTED,
    PLANE_BEHIND_CUT_AT_0,
    PLANE_NEVER_FROM_0,
    PLANE_ALONG_FIRST,
    PLANE_ALONG_LAST,
    PLANE_ALONG_BOTH,
    PLANE_PARALLEL_ANY,
    PLANE_PARALLEL_SLOW,
    PLANE_UPSIDE_DOWN,
    PLANE_MULTIPLIED,
    PLANE_SIZES,
    PLANE_MINUS_INFINITY,
};
#define PARALLEL                                                                                   \
    "where all rays go the same way, low and high equal, they meet the plane at one distance, or " \
    "never: however slow they are"

#define BEHIND_MET "rays that go away from the plane never meet it: their distance is INFINITY"
#define BEHIND_AT_0                                                                                \
    "rays that go away from the plane count as if they met it at the eye: they never do, their "   \
    "distance is INFINITY"
#define EYE_ON_IT "with the eye on the plane, rays that go up meet it, at 0, and others never"
#define SMALL_IS_0                                                                                 \
    "no small number is 0: rays that go to the plane meet it, however slowly, without an epsilon"
#define BARE                                                                                       \
    "each end is the quotient as it is: ask first on which side of the plane the eye is, and "     \
    "then "                                                                                        \
    "of each end whether its rays go to the plane; if not, it is INFINITY"
#define GUARDED                                                                                    \
    "a small direction is not what never meets the plane: ask whether the rays of this end go to " \
    "it, by the direction's sign and without an epsilon"
#define EYE_BESIDE "an eye beside the plane is not on it, however near it is: without an epsilon"
#define ALONG "a ray along the plane never meets it: nothing is divided by a direction of 0"

static const Cause plane_mistakes[] = {
    [PLANE_ENDS_SWAPPED] = {.says = "the ends are swapped: the least distance is the first one"},
    [PLANE_ENDS_OF_ONE_SIDE] = {.says = "the ends are right for an eye below the plane only: from "
                                        "above, the lowest direction meets it first"},
    [PLANE_BEHIND_MET] = {.says = BEHIND_MET},
    [PLANE_BEHIND_SORTED] = {.says = BEHIND_MET},
    [PLANE_BEHIND_AT_0] = {.says = BEHIND_AT_0},
    [PLANE_BEHIND_CUT_AT_0] = {.says = BEHIND_AT_0},
    [PLANE_NEVER_FROM_0] = {.says = "where no ray meets the plane both ends are INFINITY, not the "
                                    "greatest distance alone"},
    [PLANE_BOTH_WAYS_NEVER] = {.says = "where rays go both ways, those that go to the plane do "
                                       "meet it: the least distance is theirs"},
    [PLANE_BOTH_WAYS_ALWAYS] = {.says = "where rays go both ways, the interval is wider than it "
                                        "has to be: it begins with the first ray that meets it"},
    [PLANE_EYE_IS_UPPER] = {.says = "an eye on the plane counts to the lower side: rays that go up "
                                    "meet it, at 0"},
    [PLANE_EYE_NEVER] = {.says = EYE_ON_IT},
    [PLANE_EYE_AT_0] = {.says = EYE_ON_IT},
    [PLANE_EYE_FROM_0] = {.says = EYE_ON_IT},
    [PLANE_BACKWARDS] = {.says = "the way goes from the eye to the plane, not back"},
    [PLANE_FROM_0] = {.says = "the distance is computed without the eye"},
    [PLANE_ONE_END] = {.says = "both ends are the least distance"},
    [PLANE_NEVER_FOR_ALL] = {.says = "where some rays never meet it, the others do all the same: "
                                     "each end is asked by itself"},
    [PLANE_BARE] = {.says = BARE},
    [PLANE_BARE_LOW_FIRST] = {.says = BARE},
    [PLANE_BEHIND_GUARDED] = {.says = GUARDED},
    [PLANE_SORTED_GUARDED] = {.says = GUARDED},
    [PLANE_BARE_GUARDED] = {.says = GUARDED},
    [PLANE_BARE_LOW_GUARDED] = {.says = GUARDED},
    [PLANE_EPSILON_100TH] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_1000TH] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_E4] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_E5] = {.says = SMALL_IS_0},
    [PLANE_EPSILON] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_TINY] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_LEAST] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_FIRST] = {.says = SMALL_IS_0},
    [PLANE_EPSILON_LAST] = {.says = SMALL_IS_0},
    [PLANE_ALONG_FIRST] = {.says = ALONG},
    [PLANE_ALONG_LAST] = {.says = ALONG},
    [PLANE_ALONG_BOTH] = {.says = ALONG},
    [PLANE_PARALLEL_ANY] = {.says = PARALLEL},
    [PLANE_PARALLEL_SLOW] = {.says = PARALLEL},
    [PLANE_EYE_NEAR] = {.says = EYE_BESIDE},
    [PLANE_EYE_NEARER] = {.says = EYE_BESIDE},
    [PLANE_UPSIDE_DOWN] = {.says = "the quotient is upside down: the way is divided by the "
                                   "direction"},
    [PLANE_MULTIPLIED] = {.says = "the way is divided by the direction, not multiplied"},
    [PLANE_SIZES] = {.says = BEHIND_MET},
    [PLANE_MINUS_INFINITY] = {.says = "what is never met is at INFINITY, not at -INFINITY"},
    [PLANE_NEVER_IS_LARGE] = {.says = "what is never met is at INFINITY, not at a large number"},
};

// Between the slow and the quick parallel rays of the edges.
#define SLOW 0.09375

typedef struct Ends {
    double low, high;
} Ends;

// Below that a direction, or the way to the plane, was taken for 0 by an epsilon: what many write,
// or what lies between two sizes of the edges above.
static double epsilon_of(int mistake)
{
    return mistake == PLANE_EPSILON_TINY || mistake == PLANE_EYE_NEARER ? 0x1p-60
           : mistake == PLANE_EPSILON_LEAST                             ? 0x1p-110
           : mistake == PLANE_EPSILON_100TH                             ? 1e-2
           : mistake == PLANE_EPSILON_1000TH                            ? 1e-3
           : mistake == PLANE_EPSILON_E4                                ? 1e-4
           : mistake == PLANE_EPSILON_E5                                ? 1e-5
                                                                        : 0x1p-20;
}

// Does the eye count to the lower side?
static int is_lower_side(const TilePlaneJob *job, int mistake)
{
    const int takes_near = mistake == PLANE_EYE_NEAR || mistake == PLANE_EYE_NEARER;
    const int is_near = fabs((double)job->plane - (double)job->eye) < epsilon_of(mistake);
    return job->eye < job->plane || (takes_near && is_near) ||
           (mistake != PLANE_EYE_IS_UPPER && job->eye == job->plane);
}

// Is a mistake one of the rays that meet the plane first, or last?
static int is_of_end(int mistake, int is_first, int of_first, int of_last)
{
    return mistake == (is_first ? of_first : of_last);
}

// Where a ray of this direction meets the plane.
//   is_first   of all rays, or last
static double distance_of(const TilePlaneJob *job, double direction, int is_first, int mistake)
{
    const double way = (double)job->plane - (mistake == PLANE_FROM_0 ? 0 : (double)job->eye);
    const int is_lower = is_lower_side(job, mistake);
    const int has_epsilon = (mistake >= PLANE_EPSILON && mistake <= PLANE_EPSILON_E5) ||
                            is_of_end(mistake, is_first, PLANE_EPSILON_FIRST, PLANE_EPSILON_LAST);
    const int meets_along = mistake == PLANE_ALONG_BOTH ||
                            is_of_end(mistake, is_first, PLANE_ALONG_FIRST, PLANE_ALONG_LAST);
    const int is_slow = has_epsilon && fabs(direction) < epsilon_of(mistake);
    const int meets =
        (!is_slow && (is_lower ? direction > 0 : direction < 0)) || (meets_along && direction == 0);
    if (mistake == PLANE_EYE_NEVER && job->eye == job->plane) {
        return INFINITY;
    }
    if (mistake >= PLANE_BEHIND_GUARDED && mistake <= PLANE_BARE_LOW_GUARDED &&
        fabs(direction) < epsilon_of(mistake)) {
        return INFINITY;
    }
    if ((mistake >= PLANE_BARE && mistake <= PLANE_BARE_LOW_GUARDED) ||
        mistake == PLANE_BEHIND_MET || mistake == PLANE_BEHIND_SORTED ||
        mistake == PLANE_BEHIND_CUT_AT_0) {
        return way / direction;
    }
    if (mistake == PLANE_SIZES) {
        return fabs(way) / fabs(direction);
    }
    if (!meets) {
        return mistake == PLANE_MINUS_INFINITY ? -INFINITY
               : mistake == PLANE_BEHIND_AT_0 || (mistake == PLANE_NEVER_FROM_0 && is_first)
                   ? 0
                   : INFINITY;
    }
    return mistake == PLANE_UPSIDE_DOWN  ? direction / way
           : mistake == PLANE_MULTIPLIED ? way * direction
           : mistake == PLANE_BACKWARDS  ? -way / direction
                                         : way / direction;
}

static Ends expected_ends(const TilePlaneJob *job, int mistake)
{
    const int is_lower = is_lower_side(job, mistake);
    const double of_low = distance_of(job, job->low, !is_lower, mistake);
    const double of_high = distance_of(job, job->high, is_lower, mistake);
    const int never_low =
        mistake == PLANE_ENDS_OF_ONE_SIDE || mistake == PLANE_BARE || mistake == PLANE_BARE_GUARDED;
    const int always_low = mistake == PLANE_BARE_LOW_FIRST || mistake == PLANE_BARE_LOW_GUARDED;
    const int high_first = never_low || (is_lower && !always_low);
    Ends ends = {high_first ? of_high : of_low, high_first ? of_low : of_high};
    const int both_ways = job->low < 0 && job->high > 0;
    if (job->eye == job->plane && (mistake == PLANE_EYE_AT_0 || mistake == PLANE_EYE_FROM_0)) {
        return (Ends){0, mistake == PLANE_EYE_AT_0 ? 0 : INFINITY};
    }
    if (mistake == PLANE_BEHIND_SORTED || mistake == PLANE_SORTED_GUARDED ||
        mistake == PLANE_SIZES) {
        return (Ends){fmin(of_low, of_high), fmax(of_low, of_high)};
    }
    if (mistake == PLANE_BEHIND_CUT_AT_0) {
        return of_low < 0 && of_high < 0
                   ? (Ends){INFINITY, INFINITY}
                   : (Ends){fmax(0, fmin(of_low, of_high)), fmax(of_low, of_high)};
    }
    if (mistake == PLANE_BOTH_WAYS_NEVER && both_ways) {
        return (Ends){INFINITY, INFINITY};
    }
    if (mistake == PLANE_NEVER_FOR_ALL && (isinf(of_low) || isinf(of_high))) {
        return (Ends){INFINITY, INFINITY};
    }
    if (mistake == PLANE_BOTH_WAYS_ALWAYS && both_ways) {
        return (Ends){0, INFINITY};
    }
    if (job->low == job->high &&
        (mistake == PLANE_PARALLEL_ANY ||
         (mistake == PLANE_PARALLEL_SLOW && fabs((double)job->low) < SLOW))) {
        return (Ends){0, INFINITY};
    }
    if (mistake == PLANE_ONE_END) {
        ends.high = ends.low;
    }
    return mistake == PLANE_ENDS_SWAPPED ? (Ends){ends.high, ends.low} : ends;
}

// One rounding for the difference, five for the division (2.5 ulp, OpenCL 1.2, 7.4), or an inverse
// and a product in its place: PLANE_ERROR of oracle3d_rounding.h.
static int is_near(float found, double expected, const TilePlaneJob *job, int mistake)
{
    if (mistake == PLANE_NEVER_IS_LARGE && isinf(expected)) {
        return isfinite(found) && found > 1e6f;
    }
    if (!isfinite(expected)) {
        return isnan(expected) ? isnan(found) : (double)found == expected;
    }
    const double way = fabs((double)job->plane - (double)job->eye);
    const double rounding = 0x1p-20 * (fabs((double)job->plane) + fabs((double)job->eye));
    return fabs((double)found - expected) <=
           fabs(expected) * (way > 0 ? rounding / way : 0) + 0x1p-20 * fabs(expected);
}

static int plane_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const TilePlaneJob *job = &((const Job10 *)pointer)->planes[i];
    const TilePlaneAnswer *found = (const TilePlaneAnswer *)answers + i;
    const Ends expected = expected_ends(job, mistake);
    return is_near(found->low, expected.low, job, mistake) &&
           is_near(found->high, expected.high, job, mistake);
}

static char *describe_plane(const void *pointer, int i, const void *answers)
{
    const TilePlaneJob *job = &((const Job10 *)pointer)->planes[i];
    const TilePlaneAnswer *found = (const TilePlaneAnswer *)answers + i;
    const Ends expected = expected_ends(job, 0);
    return message_new("plane at %.9g, eye at %.9g, directions from %.9g to %.9g: found [%.9g, "
                       "%.9g], expected [%.9g, %.9g]",
                       job->plane, job->eye, job->low, job->high, found->low, found->high,
                       expected.low, expected.high);
}

const Function tile_plane_10 = {"tile_planes", N_TILE_PLANES, sizeof(TilePlaneAnswer),
                                COMPARED(plane_agrees, describe_plane, plane_mistakes)};

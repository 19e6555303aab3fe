// Telling mistakes of overlap tests apart by all answers (see overlap_cause.h).
#include "overlap_cause.h"

#include <math.h>
#include <stddef.h>

double outside_of(double coordinate, double min, double max)
{
    return coordinate < min ? min - coordinate : coordinate > max ? coordinate - max : 0;
}

static double distance_squared(Reach r)
{
    return r.outside[0] * r.outside[0] + r.outside[1] * r.outside[1] + r.outside[2] * r.outside[2];
}

static int overlaps(Reach r)
{
    return distance_squared(r) <= r.radius * r.radius;
}

// ---- Mistakes that foretell every answer --------------------------------------------------------

static float distance_squared_in_float(Reach r)
{
    const float x = (float)r.outside[0], y = (float)r.outside[1], z = (float)r.outside[2];
    return x * x + y * y + z * z;
}

static int overlaps_by_squares_in_float(Reach r)
{
    const float radius = (float)r.radius;
    return distance_squared_in_float(r) <= radius * radius;
}

static int overlaps_by_root_in_float(Reach r)
{
    return sqrtf(distance_squared_in_float(r)) <= fabsf((float)r.radius);
}

static int overlaps_by_root(Reach r)
{
    return sqrt(distance_squared(r)) <= fabs(r.radius);
}

static int overlaps_by_signed_root(Reach r)
{
    return sqrt(distance_squared(r)) <= r.radius;
}

static int overlaps_by_radius_in_float(Reach r)
{
    const float radius = (float)r.radius;
    const float radius_squared = radius * radius;
    return distance_squared(r) <= (double)radius_squared;
}

static int overlaps_by_distances_in_float(Reach r)
{
    for (int axis = 0; axis < 3; axis++) {
        r.outside[axis] = (float)r.outside[axis];
    }
    return overlaps(r);
}

static int overlaps_by_sum(Reach r)
{
    return r.outside[0] + r.outside[1] + r.outside[2] <= fabs(r.radius);
}

static const struct {
    int (*overlaps)(Reach);
    const char *says;
} foretold[] = {
    {overlaps_by_sum, "the distances on the axes are added: their squares are to be"},
    {overlaps_by_root, "your answers are those of a root, which is rounded: compare the squares"},
    {overlaps_by_distances_in_float,
     "your answers are those of distances rounded to float: in double they are exact"},
    {overlaps_by_squares_in_float,
     "your answers are those of float, which rounds squares: in double they are exact"},
    {overlaps_by_root_in_float,
     "your answers are those of float, which rounds squares: in double they are exact"},
    {overlaps_by_signed_root, "a negative radius counts as its absolute value; and the root is "
                              "rounded: compare squares"},
    {overlaps_by_radius_in_float,
     "your answers are those of a radius squared in float, which rounds it"},
};

static int foretells(int (*mistaken)(Reach), ReachOf *reach_of, const void *job, int n,
                     const i32 *found)
{
    int i = 0;
    while (i < n && mistaken(reach_of(job, i)) == (found[i] != 0)) {
        i++;
    }
    return i == n;
}

// ---- Mistakes that all wrong answers have in common ---------------------------------------------

// May an answer that is wrong be so by this mistake?
typedef int MayBe(Reach reach, int found);

static int is_of_touching(Reach r, int found)
{
    return !found && distance_squared(r) == r.radius * r.radius;
}

static int is_of_radius_0(Reach r, int found)
{
    return !found && r.radius == 0;
}

static int is_of_negative_radius(Reach r, int found)
{
    return !found && r.radius < 0;
}

// In this order: a point on a cell's border touches it, too.
static const struct {
    MayBe *may_be;
    Cause cause;
} in_common[] = {
    {is_of_radius_0,
     {.says = "a radius of 0 makes a point, and it overlaps the cells that it is in"}},
    {is_of_negative_radius, {.says = "a negative radius counts as its absolute value"}},
    {is_of_touching,
     {"they touch, and touching counts: both have their boundaries", MISTAKE_STRICT_BOUNDARY}},
};

static int have_in_common(MayBe *may_be, ReachOf *reach_of, const void *job, int n,
                          const i32 *found)
{
    for (int i = 0; i < n; i++) {
        const Reach reach = reach_of(job, i);
        if ((found[i] != 0) != overlaps(reach) && !may_be(reach, found[i] != 0)) {
            return 0;
        }
    }
    return 1;
}

// ---- Epsilons -----------------------------------------------------------------------------------

// By how much it misses the cell, as an epsilon may be meant, and up to what an addition is one.
static double squares_apart(Reach r)
{
    return distance_squared(r) - r.radius * r.radius;
}

static double distances_apart(Reach r)
{
    return sqrt(distance_squared(r)) - fabs(r.radius);
}

static double share_of_radius(Reach r)
{
    return r.radius != 0 ? distances_apart(r) / fabs(r.radius) : INFINITY;
}

static const struct {
    double (*apart)(Reach);
    double most;
} epsilons[] = {{squares_apart, 1}, {distances_apart, 0.5}, {share_of_radius, 1.0 / 16}};

// Is all that is wrong a yes to what misses by no more than some epsilon, and all that misses by
// more answered with no?
static int is_epsilon(int e, ReachOf *reach_of, const void *job, int n, const i32 *found)
{
    double most_taken = 0, least_left = INFINITY;
    for (int i = 0; i < n; i++) {
        const Reach reach = reach_of(job, i);
        if (overlaps(reach)) {
            if (!found[i]) {
                return 0;
            }
            continue;
        }
        const double apart = epsilons[e].apart(reach);
        most_taken = found[i] ? fmax(most_taken, apart) : most_taken;
        least_left = found[i] ? least_left : fmin(least_left, apart);
    }
    return most_taken < least_left && most_taken <= epsilons[e].most;
}

// ---- All of them --------------------------------------------------------------------------------

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

Cause overlap_cause(ReachOf *reach_of, const void *job, int n, const i32 *found)
{
    for (size_t m = 0; m < COUNT_OF(foretold); m++) {
        if (foretells(foretold[m].overlaps, reach_of, job, n, found)) {
            return (Cause){.says = foretold[m].says};
        }
    }
    for (size_t m = 0; m < COUNT_OF(in_common); m++) {
        if (have_in_common(in_common[m].may_be, reach_of, job, n, found)) {
            return in_common[m].cause;
        }
    }
    for (size_t e = 0; e < COUNT_OF(epsilons); e++) {
        if (is_epsilon((int)e, reach_of, job, n, found)) {
            return (Cause){.says =
                               "your answers are those with an epsilon: in double none is needed"};
        }
    }
    return (Cause){0};
}

// What misses by less may be decided by how the sides of the square were rounded.
#define CLEARLY 0.01

int overlap_is_of_box(ReachOf *reach_of, const void *job, int n, const i32 *found)
{
    int n_taken = 0;
    for (int i = 0; i < n; i++) {
        const Reach r = reach_of(job, i);
        const double outside = fmax(fmax(r.outside[0], r.outside[1]), r.outside[2]);
        const double radius = fabs(r.radius);
        const int is_clear = fabs(outside - radius) > CLEARLY * radius;
        if (is_clear && (found[i] != 0) != (outside < radius)) {
            return 0;
        }
        n_taken += found[i] && share_of_radius(r) > CLEARLY;
    }
    return n_taken > 0;
}

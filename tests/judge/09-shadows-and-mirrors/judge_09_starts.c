// Lab 09: where new rays start, off the surface that they leave: rolled and judged.
#include "judge_09.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Rolling ------------------------------------------------------------------------------------

// In the second range one of the three numbers is much larger than the others, in turn, and all are
// as large as may be.
static StartJob roll_start(Random *random, int range, int i)
{
    StartJob job = {.point = random_point(random, 4), .normal = random_direction(random)};
    job.t = random_number(random, 0.25, 8);
    job.radius = random_number(random, 0.125, 4) * (float)random_sign(random);
    if (range == 1) {
        const float size = random_power_09(random);
        const float share[3] = {i % 3 == 0 ? 1 : 0x1p-8f, i % 3 == 1 ? 1 : 0x1p-8f,
                                i % 3 == 2 ? 1 : 0x1p-8f};
        job.t *= size * share[0];
        job.radius *= size * share[1];
        job.point = vec3_scaled(job.point, size * share[2]);
    }
    return job;
}

void roll_starts_09(Random *random, Job09 *job)
{
    for (int i = 0; i < COUNT(job->starts); i++) {
        job->starts[i] = roll_start(random, i / N_START_INPUTS, i);
    }
}

// ---- Right --------------------------------------------------------------------------------------

static double largest_of(Vec3 v)
{
    return fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
}

static double offset_by(double t, double radius, double point)
{
    return 0x1p-18 * (t + radius + point);
}

static double offset_of(const StartJob *in)
{
    return offset_by(in->t, fabs(in->radius), largest_of(in->point));
}

// How far the point was moved along the normal, and how far beside it.
typedef struct Moved {
    double along, beside;
    double rounding;  // that far both may be off
} Moved;

static Moved moved(const StartJob *in, Vec3 found)
{
    const OracleVector n = vector_of(in->normal);
    const OracleVector way = vector_minus(vector_of(found), vector_of(in->point));
    const double along = vector_dot(way, n), square = vector_dot(way, way);
    // Each coordinate is rounded by half a step of its size; the offset itself by a few u.
    return (Moved){along, sqrt(fmax(square - along * along, 0)),
                   4 * 0x1p-24 * (largest_of(in->point) + sqrt(square))};
}

static int is_moved(const StartJob *in, Vec3 found, double least, double most)
{
    const Moved own = moved(in, found);
    return own.beside <= own.rounding + 0x1p-8 * fabs(own.along) &&
           own.along >= least - own.rounding && own.along <= most + own.rounding;
}

// What is expected of a mistake is its offset.
#define GIVEN                                                                                      \
    const StartJob *in = &((const Job09 *)job)->starts[i];                                         \
    const Vec3 found = ((const Vec3 *)answers)[i]
#define IS_FOUND(offset) is_moved(in, found, offset, offset)

// Twice as far is far enough, and still right; a mistake is known by its number.
RIGHT(is_right, is_moved(in, found, offset_of(in), 2 * offset_of(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// The sum.
static double size_of(float radius)
{
    return fabs((double)radius);
}

// The point's coordinates.
static double with_point(const StartJob *in, double point)
{
    return offset_by(in->t, size_of(in->radius), point);
}

static double larger(float a, float b)
{
    return fmax(fabs(a), fabs(b));
}

static double smallest_of(Vec3 p)
{
    return fmin(fmin(fabs(p.x), fabs(p.y)), fabs(p.z));
}

static double sum_of_sizes(Vec3 p)
{
    return fabs(p.x) + fabs(p.y) + fabs(p.z);
}

static double largest_with_sign(Vec3 p)
{
    return fmax(fmax(p.x, p.y), p.z);
}

// Of two of the coordinates the larger, or the smaller, and so on with the third; with its sign or
// without, a bit for each.
static double by_way(Vec3 p, int way)
{
    const double x = way & 4 ? p.x : fabs(p.x), y = way & 8 ? p.y : fabs(p.y),
                 z = way & 16 ? p.z : fabs(p.z);
    const double two = way & 1 ? fmin(x, y) : fmax(x, y);
    return way & 2 ? fmin(two, z) : fmax(two, z);
}

// A bit for each of the three numbers: taken off.
static double with_signs(const StartJob *in, int way)
{
    return offset_by(way & 1 ? -in->t : in->t, size_of(in->radius) * (way & 2 ? -1 : 1),
                     largest_of(in->point) * (way & 4 ? -1 : 1));
}

// Where the point comes to when each coordinate moves by its own size.
static int is_moved_by_coordinate(const StartJob *in, Vec3 found)
{
    const Vec3 p = in->point, n = in->normal;
    const OracleVector way = vector_minus(vector_of(found), vector_of(p));
    const OracleVector expected = {with_point(in, fabs(p.x)) * (double)n.x,
                                   with_point(in, fabs(p.y)) * (double)n.y,
                                   with_point(in, fabs(p.z)) * (double)n.z};
    return vector_length(vector_minus(way, expected)) <= moved(in, found).rounding;
}

// By which distance the points are moved is said where rounding is least: where the numbers are
// small, so that this is also where no more than a least distance is needed.
static double surest_distance(const Job09 *job, const Vec3 *found)
{
    Moved surest = moved(&job->starts[0], found[0]);
    for (int j = 1; j < COUNT(job->starts); j++) {
        const Moved own = moved(&job->starts[j], found[j]);
        surest = own.rounding < surest.rounding ? own : surest;
    }
    return surest.along;
}

static int is_moved_along(const StartJob *in, Vec3 found, double distance)
{
    const Moved own = moved(in, found);
    return fabs(own.along - distance) <= own.rounding + 0x1p-8 * fabs(distance);
}

// In both ranges: where the numbers are small, a least distance is the same everywhere, too.
static int all_are_moved_along(const Job09 *job, const Vec3 *found, double distance)
{
    int j = 0;
    while (j < COUNT(job->starts) && is_moved_along(&job->starts[j], found[j], distance)) {
        j++;
    }
    return j == COUNT(job->starts);
}

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(unmoved, 0.0,
            "the point was not moved: new rays would hit the surface that they leave");
    ANSWERS(other_side, -offset_of(in), "it was moved to the other side: against the normal");
    ANSWERS(half, offset_of(in) / 2, "it was moved half as far as needed");

    ANSWERS(largest, offset_by(0, 0, fmax(in->t, fmax(size_of(in->radius), largest_of(in->point)))),
            "the sum of the three numbers counts, not the largest of them");
    ANSWERS(one_share, offset_by(in->t, 0, 0) + size_of(in->radius) + largest_of(in->point),
            "SURFACE_ERROR counts for each of the three numbers: parentheses are missing");
    ANSWERS(signed_radius, offset_by(in->t, in->radius, largest_of(in->point)),
            "the radius may be negative: its size is added");
    ANSWERS(
        unsigned_sum, offset_by(0, fabs((double)in->t + in->radius), largest_of(in->point)),
        "the radius may be negative: it is its own size that counts, not that of its sum with t");
    ANSWERS(product, offset_by(in->t * size_of(in->radius) * largest_of(in->point), 0, 0),
            "t, the radius and the coordinate were multiplied: their sum counts");
    ANSWERS(without_t, offset_by(0, size_of(in->radius), largest_of(in->point)),
            "t is missing in the sum");
    ANSWERS(without_radius, offset_by(in->t, 0, largest_of(in->point)),
            "the radius is missing in the sum");
    ANSWERS(without_point, offset_by(in->t, size_of(in->radius), 0),
            "the point's coordinate is missing in the sum");
    ANSWERS(only_t, offset_by(in->t, 0, 0), "only t counts in the sum");
    ANSWERS(only_radius, offset_by(0, size_of(in->radius), 0), "only the radius counts in the sum");
    ANSWERS(only_point, offset_by(0, 0, largest_of(in->point)),
            "only the point's coordinate counts in the sum");

    ANSWERS(by_sum, with_point(in, sum_of_sizes(in->point)),
            "of the point's coordinates the largest counts, not their sum");
    ANSWERS(by_size_of_sum,
            with_point(in, fabs((double)in->point.x + (double)in->point.y + (double)in->point.z)),
            "of the point's coordinates the largest counts, not the size of their sum");
    ANSWERS(by_smallest, with_point(in, smallest_of(in->point)),
            "of the point's coordinates the largest counts, not the smallest");
    ANSWERS(by_mean, with_point(in, sum_of_sizes(in->point) / 3),
            "of the point's coordinates the largest counts, not their mean");
    ANSWERS(without_x, with_point(in, larger(in->point.y, in->point.z)),
            "of the point's coordinates x is not looked at");
    ANSWERS(without_y, with_point(in, larger(in->point.x, in->point.z)),
            "of the point's coordinates y is not looked at");
    ANSWERS(without_z, with_point(in, larger(in->point.x, in->point.y)),
            "of the point's coordinates z is not looked at");

#define SIZE_FIRST "coordinates may be negative: of their sizes the largest counts"
    ANSWERS(with_sign, with_point(in, largest_with_sign(in->point)), SIZE_FIRST);
    ANSWERS(size_late, with_point(in, fabs(largest_with_sign(in->point))), SIZE_FIRST);
    ANSWERS(sign_of_z, with_point(in, fmax(larger(in->point.x, in->point.y), in->point.z)),
            SIZE_FIRST);

    ANY(other_largest, 32, IS_FOUND(with_point(in, by_way(in->point, way))),
        "of the sizes of all three coordinates the largest counts: here it is another number");

    ANY(taken_off, 8, IS_FOUND(with_signs(in, way)),
        "one of the three numbers is taken off: all are added");

    EACH(by_coordinate, is_moved_by_coordinate(in, found),
         "each coordinate moves by its own size: the largest one's counts for all three");

    ONLY(same_distance, all_are_moved_along(job, answers, surest_distance(job, answers)),
         "the same distance everywhere: rounding grows with the numbers");

    ONLY(least_distance,
         is_moved_along(in, found, fmax(surest_distance(job, answers), offset_of(in))),
         "never less than a fixed distance: that is too much where the numbers are small");
    // Too far everywhere, or one distance.
    ONLY(too_far, moved(in, found).along > 2 * offset_of(in) + moved(in, found).rounding,
         "farther than needed: what is near is not seen");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const Moved own = moved(in, found);
    return message_new("point %s, normal %s, t %g, radius %g: found it moved by %g along the "
                       "normal and %g beside it, expected %g to %g and 0",
                       words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->t,
                       in->radius, own.along, own.beside, offset_of(in), 2 * offset_of(in));
}

const Function start_09 = {"starts", 2 * N_START_INPUTS, sizeof(Vec3),
                           KNOWING(is_right, describe, known), .knows_constant = 1};

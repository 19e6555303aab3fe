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

// ---- Judging ------------------------------------------------------------------------------------

static double largest_of(Vec3 v)
{
    return fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
}

// What is taken for the largest of a point's coordinates.
typedef double PointSize(Vec3 p);

static double sum_of_sizes(Vec3 p)
{
    return fabs(p.x) + fabs(p.y) + fabs(p.z);
}

static double mean_size(Vec3 p)
{
    return sum_of_sizes(p) / 3;
}

static double largest_with_sign(Vec3 p)
{
    return fmax(fmax(p.x, p.y), p.z);
}

static double size_of_largest(Vec3 p)
{
    return fabs(largest_with_sign(p));
}

static double size_of_sum(Vec3 p)
{
    return fabs((double)p.x + (double)p.y + (double)p.z);
}

static double smallest(Vec3 p)
{
    return fmin(fmin(fabs(p.x), fabs(p.y)), fabs(p.z));
}

static double with_sign_of_z(Vec3 p)
{
    return fmax(fmax(fabs(p.x), fabs(p.y)), p.z);
}

static double without_x(Vec3 p)
{
    return fmax(fabs(p.y), fabs(p.z));
}

static double without_y(Vec3 p)
{
    return fmax(fabs(p.x), fabs(p.z));
}

static double without_z(Vec3 p)
{
    return fmax(fabs(p.x), fabs(p.y));
}

// A known mistake: what of the sum is there, and how often it is taken.
typedef struct StartMistake {
    Cause cause;
    double share;  // of the offset; 0 where it has another size
    double t, radius, point;
    PointSize *size;       // NULL: the right one
    int is_largest;        // of the three, not their sum
    int radius_is_signed;  // a negative one is taken off
    int sum_is_unsigned;   // and the size is that of its sum with t
    int by_coordinate;     // each coordinate moves by its own size
} StartMistake;

#define ALL_THREE .share = 1, .t = 1, .radius = 1, .point = 1
#define SIZE_FIRST {.says = "coordinates may be negative: of their sizes the largest counts"}

static const StartMistake start_mistakes[] = {
    {{0}, ALL_THREE},
    {.cause = {.says = "the point was not moved: new rays would hit the surface that they leave"}},
    {{.says = "it was moved to the other side: against the normal"},
     .share = -1,
     .t = 1,
     .radius = 1,
     .point = 1},
    {{.says = "it was moved half as far as needed"}, .share = 0.5, .t = 1, .radius = 1, .point = 1},
    {{.says = "the sum of the three numbers counts, not the largest of them"},
     ALL_THREE,
     .is_largest = 1},
    {{.says = "of the point's coordinates the largest counts, not their sum"},
     ALL_THREE,
     .size = sum_of_sizes},
    {{.says = "of the point's coordinates the largest counts, not the size of their sum"},
     ALL_THREE,
     .size = size_of_sum},
    {{.says = "of the point's coordinates the largest counts, not the smallest"},
     ALL_THREE,
     .size = smallest},
    {{.says = "of the point's coordinates the largest counts, not their mean"},
     ALL_THREE,
     .size = mean_size},
    {{.says = "of the point's coordinates x is not looked at"}, ALL_THREE, .size = without_x},
    {{.says = "of the point's coordinates y is not looked at"}, ALL_THREE, .size = without_y},
    {{.says = "of the point's coordinates z is not looked at"}, ALL_THREE, .size = without_z},
    {SIZE_FIRST, ALL_THREE, .size = largest_with_sign},
    {SIZE_FIRST, ALL_THREE, .size = size_of_largest},
    {SIZE_FIRST, ALL_THREE, .size = with_sign_of_z},
    {{.says = "SURFACE_ERROR counts for each of the three numbers: parentheses are missing"},
     .share = 1,
     .t = 1,
     .radius = 0x1p18,
     .point = 0x1p18},
    {{.says = "each coordinate moves by its own size: the largest one's counts for all three"},
     ALL_THREE,
     .by_coordinate = 1},
    {{.says = "the radius may be negative: its size is added"}, ALL_THREE, .radius_is_signed = 1},
    {{.says = "the radius may be negative: it is its own size that counts, not that of its sum "
              "with t"},
     ALL_THREE,
     .radius_is_signed = 1,
     .sum_is_unsigned = 1},
    {{.says = "t is missing in the sum"}, .share = 1, .radius = 1, .point = 1},
    {{.says = "the radius is missing in the sum"}, .share = 1, .t = 1, .point = 1},
    {{.says = "the point's coordinate is missing in the sum"}, .share = 1, .t = 1, .radius = 1},
    {{.says = "only t counts in the sum"}, .share = 1, .t = 1},
    {{.says = "only the radius counts in the sum"}, .share = 1, .radius = 1},
    {{.says = "only the point's coordinate counts in the sum"}, .share = 1, .point = 1},
};

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

// The sum that a mistake makes of the three numbers, times SURFACE_ERROR.
//   largest   of the point's coordinates, or what is taken for it
static double offset_by(const StartJob *in, const StartMistake *mistake, double largest)
{
    const double t = mistake->t * in->t, point = mistake->point * largest;
    const double radius =
        mistake->radius * (mistake->radius_is_signed ? in->radius : fabs(in->radius));
    const double both = mistake->sum_is_unsigned ? fabs(t + radius) : t + radius;
    return mistake->share * 0x1p-18 *
           (mistake->is_largest ? fmax(t, fmax(radius, point)) : both + point);
}

static double offset_of(const StartJob *in, const StartMistake *mistake)
{
    return offset_by(in, mistake,
                     mistake->size != NULL ? mistake->size(in->point) : largest_of(in->point));
}

// Where the point comes to when each coordinate moves by its own size.
static int is_moved_by_coordinate(const StartJob *in, const StartMistake *mistake, Vec3 found)
{
    const Vec3 p = in->point, n = in->normal;
    const OracleVector way = vector_minus(vector_of(found), vector_of(p));
    const OracleVector expected = {offset_by(in, mistake, fabs(p.x)) * (double)n.x,
                                   offset_by(in, mistake, fabs(p.y)) * (double)n.y,
                                   offset_by(in, mistake, fabs(p.z)) * (double)n.z};
    return vector_length(vector_minus(way, expected)) <= moved(in, found).rounding;
}

static int start_agrees(const void *pointer, int i, const void *answers, int number)
{
    const StartJob *in = &((const Job09 *)pointer)->starts[i];
    const StartMistake *mistake = &start_mistakes[number];
    const Moved found = moved(in, ((const Vec3 *)answers)[i]);
    const double offset = offset_of(in, mistake);
    // Twice as far is far enough, and still right; a mistake is known by its number.
    const double most = number == 0 ? 2 * offset : offset;
    if (mistake->by_coordinate) {
        return is_moved_by_coordinate(in, mistake, ((const Vec3 *)answers)[i]);
    }
    return found.beside <= found.rounding + 0x1p-8 * fabs(found.along) &&
           found.along >= offset - found.rounding && found.along <= most + found.rounding;
}

static char *describe_start(const void *pointer, int i, const void *answers)
{
    const StartJob *in = &((const Job09 *)pointer)->starts[i];
    const Moved found = moved(in, ((const Vec3 *)answers)[i]);
    const double offset = offset_of(in, &start_mistakes[0]);
    return message_new("point %s, normal %s, t %g, radius %g: found it moved by %g along the "
                       "normal and %g beside it, expected %g to %g and 0",
                       words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->t,
                       in->radius, found.along, found.beside, offset, 2 * offset);
}

// Is every point of [first, end) moved by the same distance, or where one is given, by no less than
// that, and farther where that is needed?
static int is_one_distance(const Job09 *job, int first, int end, const Vec3 *found, double distance,
                           int is_least)
{
    int i = first;
    while (i < end) {
        const Moved own = moved(&job->starts[i], found[i]);
        const double needed = offset_of(&job->starts[i], &start_mistakes[0]);
        const double expected = is_least ? fmax(distance, needed) : distance;
        if (fabs(own.along - expected) > own.rounding + 0x1p-8 * fabs(expected)) {
            break;
        }
        i++;
    }
    return i == end;
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

static Cause cause_of_distance(const Job09 *job, const Vec3 *found)
{
    const double distance = surest_distance(job, found);
    if (is_one_distance(job, 0, COUNT(job->starts), found, distance, 0)) {
        return (Cause){.says = "the same distance everywhere: rounding grows with the numbers"};
    }
    if (is_one_distance(job, 0, COUNT(job->starts), found, distance, 1)) {
        return (Cause){.says = "never less than a fixed distance: that is too much where the "
                               "numbers are small"};
    }
    return (Cause){0};
}

static Cause explain_start(const void *pointer, Range range, const void *answers)
{
    const Job09 *job = pointer;
    int n_far = 0;
    for (int m = 1; m < COUNT(start_mistakes); m++) {
        int k = 0;
        while (k < range.n && start_agrees(job, range_at(range, k), answers, m)) {
            k++;
        }
        if (k == range.n) {
            return start_mistakes[m].cause;
        }
    }
    for (int k = 0; k < range.n; k++) {
        const int i = range_at(range, k);
        const StartJob *in = &job->starts[i];
        const Moved found = moved(in, ((const Vec3 *)answers)[i]);
        n_far += found.along > 2 * offset_of(in, &start_mistakes[0]) + found.rounding;
    }
    if (n_far == range.n) {
        return (Cause){.says = "farther than needed: what is near is not seen"};
    }
    return cause_of_distance(job, answers);
}

const Function start_09 = {"starts", 2 * N_START_INPUTS, sizeof(Vec3),
                           EXPLAINED(start_agrees, describe_start, explain_start)};

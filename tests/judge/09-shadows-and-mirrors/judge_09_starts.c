// Lab 09: where new rays start, off the surface that they leave: drawn and judged.
#include "judge_09.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Drawing ------------------------------------------------------------------------------------

// In the second range one of the three numbers is much larger than the others, in turn, and all are
// as large as may be.
static StartJob draw_start(Random *random, int range, int i)
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

void starts_09_draw(Random *random, Job09 *job)
{
    for (int i = 0; i < COUNT(job->starts); i++) {
        job->starts[i] = draw_start(random, i / N_START_INPUTS, i);
    }
}

// ---- Judging ------------------------------------------------------------------------------------

static double largest_of(Vec3 v)
{
    return fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
}

// A known mistake: what of the sum is there, and how often it is taken.
typedef struct StartMistake {
    Cause cause;
    double share;  // of the offset; 0 where it has another size
    double t, radius, point;
    double distance;  // the same everywhere
} StartMistake;

static const StartMistake start_mistakes[] = {
    {.cause = {0}, .share = 1, .t = 1, .radius = 1, .point = 1},
    {.cause = {.says = "the point was not moved: new rays would hit the surface that they leave"}},
    {.cause = {.says = "it was moved to the other side: against the normal"},
     .share = -1,
     .t = 1,
     .radius = 1,
     .point = 1},
    {.cause = {.says = "t is missing in the sum"}, .share = 1, .radius = 1, .point = 1},
    {.cause = {.says = "the radius is missing in the sum"}, .share = 1, .t = 1, .point = 1},
    {.cause = {.says = "the point's coordinate is missing in the sum"},
     .share = 1,
     .t = 1,
     .radius = 1},
    {.cause = {.says = "only t counts in the sum"}, .share = 1, .t = 1},
    {.cause = {.says = "only the radius counts in the sum"}, .share = 1, .radius = 1},
    {.cause = {.says = "only the point's coordinate counts in the sum"}, .share = 1, .point = 1},
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
static double offset_of(const StartJob *in, const StartMistake *mistake)
{
    return mistake->share * 0x1p-18 *
           (mistake->t * in->t + mistake->radius * fabs(in->radius) +
            mistake->point * largest_of(in->point));
}

static int start_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const StartJob *in = &((const Job09 *)pointer)->starts[i];
    const Moved found = moved(in, ((const Vec3 *)answers)[i]);
    const double offset = offset_of(in, &start_mistakes[mistake]);
    // Twice as far is far enough, and still right; a mistake is known by its number.
    const double most = mistake == 0 ? 2 * offset : offset;
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

// Is every point moved by the same distance? By which is said where rounding is least.
static int is_one_distance(const Job09 *job, Range range, const Vec3 *found)
{
    Moved surest = moved(&job->starts[range.first], found[range.first]);
    int i = range.first;
    for (int j = i + 1; j < range.first + range.n; j++) {
        const Moved own = moved(&job->starts[j], found[j]);
        surest = own.rounding < surest.rounding ? own : surest;
    }
    while (i < range.first + range.n) {
        const Moved own = moved(&job->starts[i], found[i]);
        if (fabs(own.along - surest.along) > own.rounding + 0x1p-8 * fabs(surest.along)) {
            break;
        }
        i++;
    }
    return i == range.first + range.n;
}

static Cause explain_start(const void *pointer, Range range, const void *answers)
{
    const Job09 *job = pointer;
    int n_far = 0;
    for (int m = 1; m < COUNT(start_mistakes); m++) {
        int i = range.first;
        while (i < range.first + range.n && start_agrees(job, i, answers, m)) {
            i++;
        }
        if (i == range.first + range.n) {
            return start_mistakes[m].cause;
        }
    }
    for (int i = range.first; i < range.first + range.n; i++) {
        const StartJob *in = &job->starts[i];
        const Moved found = moved(in, ((const Vec3 *)answers)[i]);
        n_far += found.along > 2 * offset_of(in, &start_mistakes[0]) + found.rounding;
    }
    return (Cause){.says = n_far == range.n ? "farther than needed: what is near is not seen"
                           : is_one_distance(job, range, answers)
                               ? "the same distance everywhere: rounding grows with the numbers"
                               : NULL};
}

const Function start_09 = {"starts",
                           2 * N_START_INPUTS,
                           sizeof(Vec3),
                           .describe = describe_start,
                           .agrees = start_agrees,
                           .counted = "inputs",
                           .explain = explain_start};

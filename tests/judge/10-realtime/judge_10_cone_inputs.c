// Lab 10: cones and spheres, rolled: hit or missed by far, by a hair, and in strange places.
#include "judge_10.h"

#include "random3d.h"

#include <math.h>

// How wide a cone is: of a tile that sees much, of a usual one and the widest of those, or so
// narrow that squares lose the digits that decide.
typedef enum Width { WIDE, USUAL, WIDEST_USUAL, NARROW } Width;

static void roll_cone(Random *random, ConeJob *job, Width width)
{
    job->axis = random_direction(random);
    job->sine = random_number(random, 0.5, width == WIDE ? 0.96875f : 1);
    if (width != WIDE) {
        job->sine =
            ldexpf(job->sine, width == NARROW         ? -10
                              : width == WIDEST_USUAL ? -2
                                                      : (int)random_integer(random, -8, -2));
    }
    job->cosine = sqrtf(1 - job->sine * job->sine);
}

// A sphere whose centre is `off` from the cone's border, on the outer side where that is positive,
// in the plane of the axis and a direction across; the border's nearest point is `reach` from the
// eye.
static void place_sphere(Random *random, ConeJob *job, float reach, float off)
{
    Vec3 across;
    do {
        across = vec3_cross(job->axis, random_direction(random));
    } while (vec3_dot(across, across) < 0.125f);
    across = vec3_normalized(across);
    const float along = reach * job->cosine - off * job->sine;
    const float aside = reach * job->sine + off * job->cosine;
    job->centre =
        (Vec3){along * job->axis.x + aside * across.x, along * job->axis.y + aside * across.y,
               along * job->axis.z + aside * across.z};
}

// How much smaller, or larger, the radius is than the distance by which the cone is missed.
#define HAIR 0x1p-8
#define WIDER_HAIR 0x1p-4

// A large sphere that is missed, or met, by twice what rounding may do: who asks for more shows it
// here, however little it is.
static void place_at_least_hair(Random *random, ConeJob *job, float reach, int is_missed)
{
    const float off = reach * random_number(random, 1, 2);
    place_sphere(random, job, reach, off);
    const double hair = 2 * cone_rounding_10(job->centre, off);
    job->radius = (float)(is_missed ? off - hair : off + hair);
}

static ConeJob roll_cone_job(Random *random, enum ConeRange range)
{
    ConeJob job = {.radius = 1};
    const int is_edge = range == CONES_EDGES, is_missed = one_in(random, 2);
    const float reach = random_number(random, 1, 8);
    // Small spheres beside narrow cones: who subtracts squares loses the digits that decide.
    const int is_narrow = range == CONES_HAIR && one_in(random, 4);
    // Close to the border of a wide cone: who leaves out the cosine is wrong there by more than a
    // wider hair, who measures across the axis is not.
    const int is_close = range == CONES_HAIR && !is_narrow && one_in(random, 8);
    const float off = reach * (is_narrow  ? random_number(random, 0x1p-10f, 0x1p-9f)
                               : is_close ? 0.03125f
                                          : random_number(random, 0.03125, 0.5));
    roll_cone(random, &job,
              is_narrow                      ? NARROW
              : is_close                     ? WIDEST_USUAL
              : is_edge && one_in(random, 2) ? WIDE
                                             : USUAL);
    place_sphere(random, &job, reach, off);
    // By a hair, and now and then by far: who is wrong by a hair alone is right there.
    const double hair = is_close ? WIDER_HAIR : HAIR;
    job.radius = range == CONES_HAIR && !one_in(random, 8)
                     ? off * (float)(is_missed ? 1 - hair : 1 + hair)
                 : is_missed ? off * random_number(random, 0.125, 0.75)
                             : off * random_number(random, 1.25, 4);
    if (range == CONES_HAIR && one_in(random, 4)) {
        roll_cone(random, &job, USUAL);
        place_at_least_hair(random, &job, reach, is_missed);
    }
    if (range == CONES_CLEAR && one_in(random, 4)) {  // the centre is in the cone
        place_sphere(random, &job, reach, -reach * job.sine * random_number(random, 0, 1));
    }
    if (is_edge) {
        const float scale = ldexpf(1, (int)random_integer(random, -20, 20));
        const int kind = (int)random_integer(random, 0, 7);
        if (kind == 0) {  // around the eye
            job.radius = 1.25f * (float)vec3_length(job.centre);
        } else if (kind == 1) {  // behind it, and around it or not
            job.centre = vec3_scaled(job.centre, -1);
            job.radius = random_number(random, 0.25, 2) * (float)vec3_length(job.centre);
        } else if (kind == 3) {  // deep in the cone
            place_sphere(random, &job, reach, -reach * job.sine * random_number(random, 0.5, 0.75));
            job.radius = reach * job.sine / 8;
        } else if (kind == 2) {  // the cone of a tile that is half a view: nothing is outside
            job.sine = 0;
            job.cosine = -1;
            job.centre = vec3_scaled(job.centre, (float)random_sign(random));
        }
        job.centre = vec3_scaled(job.centre, scale);
        job.radius *= scale * (float)random_sign(random);
    }
    return job;
}

// The last of the first two ranges, in every job: mistakes that answer alike elsewhere part here.
enum { TELLS_SWAPPED, TELLS_ADDED, TELLS_NO_RADIUS, TELLS_AXIS, TELLS_FROM_EYE, TELLS_ALWAYS };
#define N_TELLING 12

static ConeJob roll_telling_cone(Random *random, int kind)
{
    ConeJob job;
    const float reach = random_number(random, 1, 8);
    roll_cone(random, &job, WIDEST_USUAL);
    if (kind == TELLS_SWAPPED) {  // beside a cone so wide that its sine is the greater of the two
        job.sine = random_number(random, 0.75, 0.875);
        job.cosine = sqrtf(1 - job.sine * job.sine);
    }
    // Deep in the cone, a little way into it, or beside it.
    const float off = kind == TELLS_ADDED       ? -reach * job.sine / 2
                      : kind == TELLS_NO_RADIUS ? -reach * job.sine / 8
                                                : reach / 4;
    place_sphere(random, &job, reach, off);
    const float distance = (float)vec3_length(job.centre);
    const float along = reach * job.cosine - off * job.sine;
    const float aside = reach * job.sine + off * job.cosine;
    const float added = aside * job.cosine + along * job.sine;
    const float from_eye = distance * job.cosine - along * job.sine;
    job.radius = kind == TELLS_AXIS       ? (aside + added) / 2
                 : kind == TELLS_FROM_EYE ? (added + from_eye) / 2
                 : kind == TELLS_ALWAYS   ? 1.25f * distance
                 : kind == TELLS_SWAPPED  ? 0.75f * off
                 : kind == TELLS_ADDED    ? -off / 4
                                          : -2 * off;
    return job;
}

void roll_cones_10(Random *random, Job10 *job)
{
    for (int i = 0; i < COUNT(job->cones); i++) {
        const enum ConeRange range = (enum ConeRange)(i / N_CONE_INPUTS);
        const int telling = edge_of(i % N_CONE_INPUTS, N_CONE_INPUTS, N_TELLING);
        job->cones[i] = telling >= 0 && range != CONES_EDGES
                            ? roll_telling_cone(random, telling % (N_TELLING / 2))
                            : roll_cone_job(random, range);
    }
}

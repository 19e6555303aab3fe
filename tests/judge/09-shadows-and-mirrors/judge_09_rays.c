// Lab 09: where mirrors send rays, and rays to lights: rolled and judged.
#include "judge_09.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Rolling ------------------------------------------------------------------------------------

float random_power_09(Random *random)
{
    return ldexpf(1, (int)random_integer(random, -20, 20));
}

// In the second range rays go along axes, straight at the mirror or nearly so, or graze it.
static MirrorJob roll_mirror(Random *random, int range, int i)
{
    MirrorJob job = {random_direction(random), random_direction(random)};
    const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (range == 1 && i % 3 == 0) {
        // Head-on; two of three by a part of a degree to some degrees beside it.
        const float beside = i % 9 == 0 ? 0 : ldexpf(1, -(int)random_integer(random, 4, 12));
        job.direction = vec3_normalized(vec3_minus(vec3_scaled(job.direction, beside), job.normal));
    } else if (range == 1) {
        const Vec3 along = axes[(i + 1) % 3], up = axes[i % 3];
        // The last one turns by hardly more than float's vectors may be off.
        static const float cosines[4] = {0x1p-10f, 0x1p-18f, 0x1p-20f, 0x1p-20f};
        const float cosine = i % 3 == 1 ? 0 : cosines[i % 4];
        job.normal = vec3_scaled(up, (float)random_sign(random));
        job.direction = vec3_normalized(vec3_minus(along, vec3_scaled(job.normal, cosine)));
    }
    // The normal is on the side the ray comes from.
    if (vec3_dot(job.direction, job.normal) > 0) {
        job.direction = vec3_scaled(job.direction, -1);
    }
    return job;
}

static ShadowRayJob roll_shadow_ray(Random *random, int i)
{
    ShadowRayJob job = {random_point(random, 4), {random_point(random, 4), {1, 1, 1}}};
    const Vec3 way = vec3_minus(job.light.position, job.point);
    if (vec3_dot(way, way) < 0.0625f) {
        job.light.position.x += 2;
    }
    if (i % 2 == 1) {
        // Farther than anybody would call far, and no square of it is beyond float's numbers.
        const float size = ldexpf(1, (int)random_integer(random, -50, 50));
        job.point = vec3_scaled(job.point, size);
        job.light.position = vec3_scaled(job.light.position, size);
    }
    return job;
}

void roll_rays_09(Random *random, Job09 *job)
{
    for (int i = 0; i < COUNT(job->mirrors); i++) {
        job->mirrors[i] = roll_mirror(random, i / N_MIRROR_INPUTS, i);
    }
    for (int i = 0; i < COUNT(job->shadow_rays); i++) {
        job->shadow_rays[i] = roll_shadow_ray(random, i);
    }
}

// ---- Vectors ------------------------------------------------------------------------------------

static OracleVector difference(Vec3 a, Vec3 b)
{
    return vector_minus(vector_of(a), vector_of(b));
}

// ---- mirrored_direction -------------------------------------------------------------------------

// What an answer with a mistake returns.
typedef OracleVector MistakenTurn(OracleVector direction, OracleVector normal);

static OracleVector turned_round(OracleVector d, OracleVector n)
{
    return vector_minus(vector_scaled(2 * vector_dot(d, n), n), d);
}

static OracleVector straight_on(OracleVector d, OracleVector n)
{
    (void)n;
    return d;
}

static OracleVector back(OracleVector d, OracleVector n)
{
    (void)n;
    return vector_scaled(-1, d);
}

static OracleVector along_surface(OracleVector d, OracleVector n)
{
    return vector_minus(d, vector_scaled(vector_dot(d, n), n));
}

static OracleVector along_normal(OracleVector d, OracleVector n)
{
    (void)d;
    return n;
}

static OracleVector part_added(OracleVector d, OracleVector n)
{
    return vector_plus(d, vector_scaled(2 * vector_dot(d, n), n));
}

static OracleVector along_itself(OracleVector d, OracleVector n)
{
    return vector_minus(d, vector_scaled(2 * vector_dot(d, n), d));
}

static OracleVector part_alone(OracleVector d, OracleVector n)
{
    return vector_scaled(-2 * vector_dot(d, n), n);
}

static OracleVector normal_mirrored(OracleVector d, OracleVector n)
{
    return vector_minus(n, vector_scaled(2 * vector_dot(d, n), d));
}

static OracleVector by_coordinate(OracleVector d, OracleVector n)
{
    return (OracleVector){d.x - 2 * d.x * n.x * n.x, d.y - 2 * d.y * n.y * n.y,
                          d.z - 2 * d.z * n.z * n.z};
}

static OracleVector dot_without_z(OracleVector d, OracleVector n)
{
    return vector_minus(d, vector_scaled(2 * (d.x * n.x + d.y * n.y), n));
}

typedef struct MirrorMistake {
    Cause cause;
    MistakenTurn *turn;   // NULL: the right one
    double least_cosine;  // flatter rays go straight on, or may be mirrored
} MirrorMistake;

// A ray that grazes a mirror by no more than that is taken for one along it by an epsilon.
#define GRAZING 0.0625

static const MirrorMistake mirror_mistakes[] = {
    {.cause = {0}},
    {{.says = "that is the mirrored direction turned round: the sign"}, .turn = turned_round},
    {{.says = "the ray goes straight on"}, .turn = straight_on},
    {{.says = "the ray goes back to where it came from"}, .turn = back},
    {{.says = "its part along the normal is gone, not turned round: it counts twice"},
     .turn = along_surface},
    {{.says = "that is the normal: only a ray that meets the mirror head-on goes along it"},
     .turn = along_normal},
    {{.says = "its part along the normal grew, and should turn round: the sign"},
     .turn = part_added},
    {{.says = "the normal was mirrored at the direction: they stand in each other's place"},
     .turn = normal_mirrored},
    {{.says = "the part that turns round lies along the normal, not along the direction"},
     .turn = along_itself},
    {{.says = "the direction itself is missing: only what is added to it is there"},
     .turn = part_alone},
    {{.says = "coordinates were multiplied one by one: the part along the normal is a dot product"},
     .turn = by_coordinate},
    {{.says = "z is missing in the dot product"}, .turn = dot_without_z},
    {{.says = "a ray that grazes the mirror is mirrored, too, without an epsilon"},
     .least_cosine = GRAZING},
};

static OracleNear expected_direction(const void *pointer, int i, MistakenTurn *turn)
{
    const MirrorJob *in = &((const Job09 *)pointer)->mirrors[i];
    // Unit vectors in float are as long as 1 within the rounding of three components.
    OracleNear direction = oracle3d_exactly(in->direction), normal = oracle3d_exactly(in->normal);
    direction.error = normal.error = 2 * 0x1p-24;
    OracleNear expected = oracle3d_mirrored(direction, normal, TURN_RIGHT);
    expected.value = turn != NULL ? turn(direction.value, normal.value) : expected.value;
    return expected;
}

static int mirror_agrees(const void *pointer, int i, const void *answers, int number)
{
    const MirrorJob *in = &((const Job09 *)pointer)->mirrors[i];
    const MirrorMistake *mistake = &mirror_mistakes[number];
    const Vec3 found = ((const Vec3 *)answers)[i];
    const int is_flat = fabs(vec3_dot(in->direction, in->normal)) < mistake->least_cosine;
    return oracle3d_is_near(found, expected_direction(pointer, i, mistake->turn)) ||
           (is_flat && oracle3d_is_near(found, expected_direction(pointer, i, straight_on)));
}

static char *describe_mirror(const void *pointer, int i, const void *answers)
{
    const MirrorJob *in = &((const Job09 *)pointer)->mirrors[i];
    const OracleVector e = expected_direction(pointer, i, NULL).value;
    return message_new("direction %s, normal %s: found %s, expected %s",
                       words_vec3(in->direction, 6).text, words_vec3(in->normal, 6).text,
                       words_vec3(((const Vec3 *)answers)[i], 6).text,
                       words_xyz(e.x, e.y, e.z, 6).text);
}

const Function mirror_09 = {"mirrors", 2 * N_MIRROR_INPUTS, sizeof(Vec3),
                            COMPARED(mirror_agrees, describe_mirror, mirror_mistakes)};

// ---- shadow_ray ---------------------------------------------------------------------------------

// The way to the light, and how far a right solution's direction and length may be off: one
// rounding of the difference of exact numbers, and a normalisation or a length of few u.
typedef struct Way {
    OracleVector way;
    double length;
    double error;  // as a share of the length
} Way;

static Way way_of(const void *job, int i)
{
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];
    const OracleVector way = difference(in->light.position, in->point);
    const double length = sqrt(vector_dot(way, way));
    return (Way){way, length, 12 * 0x1p-24};
}

static const ShadowRayAnswer *answer_at(const void *answers, int i)
{
    return (const ShadowRayAnswer *)answers + i;
}

static char *describe_ray(const void *job, int i, const void *answers)
{
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];
    const ShadowRayAnswer *found = answer_at(answers, i);
    const Way way = way_of(job, i);
    return message_new(
        "point %s, light at %s: found a ray from %s along %s, t from %g to %g; expected one from "
        "the point along %s, t from 0 to %g",
        words_vec3(in->point, 6).text, words_vec3(in->light.position, 6).text,
        words_vec3(found->origin, 6).text, words_vec3(found->direction, 6).text, found->t_min,
        found->t_max,
        words_xyz(way.way.x / way.length, way.way.y / way.length, way.way.z / way.length, 6).text,
        way.length);
}

typedef enum OriginMistake {
    ORIGIN_RIGHT,
    ORIGIN_AT_LIGHT,
    ORIGIN_AT_ZERO,
    ORIGIN_MOVED,
    T_MIN_SET
} OriginMistake;
static const Cause origin_causes[] = {
    [ORIGIN_RIGHT] = {0},
    [ORIGIN_AT_LIGHT] = {.says = "it starts at the light, not at the point"},
    [ORIGIN_AT_ZERO] = {.says = "it starts at the origin of the scene"},
    [ORIGIN_MOVED] = {.says = "it starts beside the point, which is off the surface already"},
    [T_MIN_SET] = {.says = "t_min is 0: the point is off the surface already, and a blocker may be "
                           "as close as one likes"},
};

static int is_at(Vec3 a, Vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// Moved by no more than some epsilon is, in scenes of whatever size.
static int is_beside(Vec3 origin, const ShadowRayJob *in)
{
    const OracleVector off = difference(origin, in->point);
    const double size = vector_length(vector_of(in->point));
    return vector_length(off) <= fmax(0.01, 0x1p-8 * size);
}

static int origin_agrees(const void *job, int i, const void *answers, int mistake)
{
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];
    const ShadowRayAnswer *found = answer_at(answers, i);
    const Vec3 at = mistake == ORIGIN_AT_LIGHT  ? in->light.position
                    : mistake == ORIGIN_AT_ZERO ? (Vec3){0, 0, 0}
                                                : in->point;
    // What is handed out starts at the point already: to set nothing else is no answer.
    const int is_handed_out = is_at(found->direction, (Vec3){0, 0, 1}) && found->t_max == 0;
    if (mistake == ORIGIN_MOVED) {
        return is_beside(found->origin, in) && found->t_min == 0 && !is_handed_out;
    }
    return is_at(found->origin, at) && (found->t_min == 0) != (mistake == T_MIN_SET) &&
           !is_handed_out;
}

const Function ray_origin_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                                COMPARED(origin_agrees, describe_ray, origin_causes)};

typedef enum DirectionMistake {
    DIRECTION_RIGHT,
    DIRECTION_REVERSED,
    DIRECTION_NOT_UNIT,
    DIRECTION_TO_ORIGIN,
    DIRECTION_BY_LARGEST,
    DIRECTION_BY_SQUARE,
} DirectionMistake;
static const Cause direction_causes[] = {
    [DIRECTION_RIGHT] = {0},
    [DIRECTION_REVERSED] = {.says = "it goes away from the light: light minus point"},
    [DIRECTION_NOT_UNIT] = {.says = "the direction is not a unit vector: t is a distance then"},
    [DIRECTION_BY_LARGEST] = {.says = "it is divided by its largest coordinate: by its length it "
                                      "becomes a unit vector"},
    [DIRECTION_BY_SQUARE] = {.says = "the way is divided by its square: by its length it becomes a "
                                     "unit vector"},
    [DIRECTION_TO_ORIGIN] = {.says = "that is the light's position, not the way to it"},
};

static int direction_agrees(const void *job, int i, const void *answers, int mistake)
{
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];
    const Way way = way_of(job, i);
    const Vec3 l = in->light.position;
    const OracleVector from_zero = {l.x, l.y, l.z};
    const OracleVector v = mistake == DIRECTION_TO_ORIGIN ? from_zero : way.way;
    const double scale = mistake == DIRECTION_NOT_UNIT    ? 1
                         : mistake == DIRECTION_REVERSED  ? -1 / way.length
                         : mistake == DIRECTION_BY_SQUARE ? 1 / (way.length * way.length)
                         : mistake == DIRECTION_TO_ORIGIN ? 1 / sqrt(vector_dot(v, v))
                         : mistake == DIRECTION_BY_LARGEST
                             ? 1 / fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z))
                             : 1 / way.length;
    const OracleNear expected = {{scale * v.x, scale * v.y, scale * v.z},
                                 way.error * fabs(scale) * sqrt(vector_dot(v, v))};
    return oracle3d_is_near(answer_at(answers, i)->direction, expected);
}

const Function ray_direction_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                                   COMPARED(direction_agrees, describe_ray, direction_causes)};

typedef enum EndMistake {
    END_RIGHT,
    END_NOWHERE,
    END_FAR_NOWHERE,
    END_AT_ONE,
    END_SQUARED,
    END_FROM_ORIGIN,
    END_AT_LARGEST,
    END_AT_SUM,
    END_HAIR,
    END_AT_START
} EndMistake;
static const Cause end_causes[] = {
    [END_RIGHT] = {0},
    [END_NOWHERE] = {.says =
                         "it has no end: what stands behind the light would cast a shadow, too"},
    [END_FAR_NOWHERE] = {.says = "where the light is far away the ray has no end: it ends at the "
                                 "light, however far"},
    [END_AT_ONE] = {.says = "it ends at t = 1: so it is where the direction is as long as the way"},
    [END_SQUARED] = {.says = "that is the square of the distance"},
    [END_FROM_ORIGIN] = {.says = "that is the light's distance from the origin of the scene, not "
                                 "from the point"},
    [END_AT_LARGEST] = {.says = "that is the largest coordinate of the way, not its length"},
    [END_AT_SUM] = {.says = "that is the sum of the way's coordinates, not its length"},
    [END_HAIR] = {.says = "it ends beside the light: t_max is its distance, without an epsilon"},
    [END_AT_START] = {.says = "it ends where it starts"},
};

// A light that is farther away, scene units, may be taken for one that is nowhere.
#define FAR 1000

static int end_agrees(const void *job, int i, const void *answers, int mistake)
{
    const Way way = way_of(job, i);
    const double t_max = answer_at(answers, i)->t_max, error = way.error * way.length;
    const double from_origin =
        vector_length(vector_of(((const Job09 *)job)->shadow_rays[i].light.position));
    const double largest = fmax(fmax(fabs(way.way.x), fabs(way.way.y)), fabs(way.way.z));
    switch (mistake) {
    case END_NOWHERE:
        return t_max > 1e9 * way.length;
    case END_FAR_NOWHERE:
        return fabs(t_max - way.length) <= error || (way.length > FAR && t_max > 1e9 * way.length);
    case END_AT_ONE:
        return fabs(t_max - 1) <= way.error;  // or the length of a unit vector
    case END_FROM_ORIGIN:
        return fabs(t_max - from_origin) <= way.error * from_origin;
    case END_AT_LARGEST:
        return fabs(t_max - largest) <= error;
    case END_AT_SUM:
        return fabs(t_max - (fabs(way.way.x) + fabs(way.way.y) + fabs(way.way.z))) <= 2 * error;
    case END_SQUARED:
        return fabs(t_max - way.length * way.length) <= 2 * error * way.length;
    case END_HAIR:
        return fabs(t_max - way.length) <= 0.02 * fmax(1, way.length);
    case END_AT_START:
        return t_max == 0;
    default:
        return fabs(t_max - way.length) <= error;
    }
}

const Function ray_end_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                             COMPARED(end_agrees, describe_ray, end_causes)};

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

static OracleNear mirrored(const MirrorJob *in)
{
    // Unit vectors in float are as long as 1 within the rounding of three components.
    OracleNear direction = oracle3d_exactly(in->direction), normal = oracle3d_exactly(in->normal);
    direction.error = normal.error = 2 * 0x1p-24;
    return oracle3d_mirrored(direction, normal, TURN_RIGHT);
}

#define GIVEN                                                                                      \
    const MirrorJob *in = &((const Job09 *)job)->mirrors[i];                                       \
    const Vec3 found = ((const Vec3 *)answers)[i]
#define IS_FOUND(vector) oracle3d_is_near(found, (OracleNear){vector, mirrored(in).error})

RIGHT(is_mirrored, oracle3d_is_near(found, mirrored(in)))

static OracleVector product(OracleVector a, OracleVector b)
{
    return (OracleVector){a.x * b.x, a.y * b.y, a.z * b.z};
}

// The number that turns round, or half of it, taken from each coordinate or added to it.
static OracleVector less_number(OracleVector direction, double number)
{
    return vector_minus(direction, (OracleVector){number, number, number});
}

// A ray that grazes a mirror by no more than that is taken for one along it by an epsilon.
#define GRAZING 0.0625

KNOWN_LIST(turns)
{
    GIVEN;
    // What turns round is the part of the direction along the normal, twice.
    const OracleVector d = vector_of(in->direction), n = vector_of(in->normal);
    const double turns_round = 2 * vector_dot(d, n);

    ANSWERS(turned_round, vector_minus(vector_scaled(turns_round, n), d),
            "that is the mirrored direction turned round: the sign");
    ANSWERS(straight_on, d, "the ray goes straight on");
    ANSWERS(back, vector_scaled(-1, d), "the ray goes back to where it came from");
    ANSWERS(along_surface, vector_minus(d, vector_scaled(turns_round / 2, n)),
            "its part along the normal is gone, not turned round: it counts twice");
    ANSWERS(along_normal, n,
            "that is the normal: only a ray that meets the mirror head-on goes along it");
    ANSWERS(part_added, vector_plus(d, vector_scaled(turns_round, n)),
            "its part along the normal grew, and should turn round: the sign");
    ANSWERS(normal_mirrored, vector_minus(n, vector_scaled(turns_round, d)),
            "the normal was mirrored at the direction: they stand in each other's place");
    ANSWERS(along_itself, vector_minus(d, vector_scaled(turns_round, d)),
            "the part that turns round lies along the normal, not along the direction");
    ANSWERS(part_alone, vector_scaled(-turns_round, n),
            "the direction itself is missing: only what is added to it is there");
    ANSWERS(by_coordinate, vector_minus(d, vector_scaled(2, product(d, product(n, n)))),
            "coordinates were multiplied one by one: the part along the normal is a dot product");
    ANSWERS(dot_without_z, vector_minus(d, vector_scaled(turns_round - 2 * d.z * n.z, n)),
            "z is missing in the dot product");

    ANY(number, 4, IS_FOUND(less_number(d, turns_round * (way < 2 ? 1 : 0.5) * (way % 2 ? -1 : 1))),
        "one number is taken from each coordinate: what turns round is a vector along the normal");
    ANY(other_multiple, 16, IS_FOUND(vector_plus(d, vector_scaled((way - 8) * turns_round / 2, n))),
        "its part along the normal turns round if it is taken off twice: here it is another "
        "multiple");
    ONLY(flat_goes_on, fabs(vector_dot(d, n)) < GRAZING && IS_FOUND(d),
         "a ray that grazes the mirror is mirrored, too, without an epsilon");
    return NO_MORE;
}

static char *describe_mirror(const void *pointer, int i, const void *answers)
{
    const MirrorJob *in = &((const Job09 *)pointer)->mirrors[i];
    const OracleVector e = mirrored(in).value;
    return message_new("direction %s, normal %s: found %s, expected %s",
                       words_vec3(in->direction, 6).text, words_vec3(in->normal, 6).text,
                       words_vec3(((const Vec3 *)answers)[i], 6).text,
                       words_xyz(e.x, e.y, e.z, 6).text);
}

const Function mirror_09 = {"mirrors", 2 * N_MIRROR_INPUTS, sizeof(Vec3),
                            KNOWING(is_mirrored, describe_mirror, turns)};
#undef GIVEN
#undef IS_FOUND

// ---- shadow_ray ---------------------------------------------------------------------------------

// The way to the light.
static OracleVector way_of(const ShadowRayJob *in)
{
    return difference(in->light.position, in->point);
}

// How far a right solution's direction and length may be off, as a share of the length: one
// rounding of the difference of exact numbers, and a normalisation or a length of few u.
#define WAY_ERROR (12 * 0x1p-24)

static char *describe_ray(const void *job, int i, const void *answers)
{
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];
    const ShadowRayAnswer *found = (const ShadowRayAnswer *)answers + i;
    const OracleVector way = way_of(in);
    const double length = vector_length(way);
    return message_new(
        "point %s, light at %s: found a ray from %s along %s, t from %g to %g; expected one from "
        "the point along %s, t from 0 to %g",
        words_vec3(in->point, 6).text, words_vec3(in->light.position, 6).text,
        words_vec3(found->origin, 6).text, words_vec3(found->direction, 6).text, found->t_min,
        found->t_max, words_xyz(way.x / length, way.y / length, way.z / length, 6).text, length);
}

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

#define GIVEN                                                                                      \
    const ShadowRayJob *in = &((const Job09 *)job)->shadow_rays[i];                                \
    const ShadowRayAnswer *found = (const ShadowRayAnswer *)answers + i
// Where it starts, and with t_min 0.
#define IS_FOUND(point) (is_at(found->origin, point) && found->t_min == 0 && !is_handed_out(found))

// What is handed out starts at the point already: to set nothing else is no answer.
static int is_handed_out(const ShadowRayAnswer *found)
{
    return is_at(found->direction, (Vec3){0, 0, 1}) && found->t_max == 0;
}

RIGHT(starts_at_point, IS_FOUND(in->point))

KNOWN_LIST(starts)
{
    GIVEN;

    ANSWERS(at_light, in->light.position, "it starts at the light, not at the point");
    ANSWERS(at_zero, ((Vec3){0, 0, 0}), "it starts at the origin of the scene");
    EACH(moved, is_beside(found->origin, in) && found->t_min == 0 && !is_handed_out(found),
         "it starts beside the point, which is off the surface already");
    EACH(later, is_at(found->origin, in->point) && found->t_min != 0 && !is_handed_out(found),
         "t_min is 0: the point is off the surface already, and a blocker may be as close as one "
         "likes");
    return NO_MORE;
}

const Function ray_origin_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                                KNOWING(starts_at_point, describe_ray, starts)};
#undef IS_FOUND

// Is the direction a vector times a number?
static int is_scaled(const ShadowRayAnswer *found, double scale, OracleVector vector)
{
    const OracleVector scaled = vector_scaled(scale, vector);
    return oracle3d_is_near(found->direction,
                            (OracleNear){scaled, WAY_ERROR * vector_length(scaled)});
}
#define IS_FOUND(scale) is_scaled(found, scale, way_of(in))

static double largest_of(OracleVector v)
{
    return fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
}

RIGHT(goes_to_light, IS_FOUND(1 / vector_length(way_of(in))))

KNOWN_LIST(directions)
{
    GIVEN;
    const OracleVector way_to = way_of(in);
    const double length = vector_length(way_to);

    ANSWERS(reversed, -1 / length, "it goes away from the light: light minus point");
    ANSWERS(not_unit, 1, "the direction is not a unit vector: t is a distance then");
    EACH(to_position,
         is_scaled(found, 1 / vector_length(vector_of(in->light.position)),
                   vector_of(in->light.position)),
         "that is the light's position, not the way to it");
    ANSWERS(by_largest, 1 / largest_of(way_to),
            "it is divided by its largest coordinate: by its length it becomes a unit vector");
    EACH(added,
         is_scaled(
             found,
             1 / vector_length(vector_plus(vector_of(in->light.position), vector_of(in->point))),
             vector_plus(vector_of(in->light.position), vector_of(in->point))),
         "the point is added to the light's position: the way is the light minus the point");
    EACH(multiplied, is_scaled(found, length, way_to),
         "the way is multiplied by its length: divided by it, it becomes a unit vector");
    ANSWERS(by_square_of_way, 1 / vector_dot(way_to, way_to),
            "the way is divided by its square: by its length it becomes a unit vector");
    return NO_MORE;
}

const Function ray_direction_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                                   KNOWING(goes_to_light, describe_ray, directions)};
#undef IS_FOUND

// The end of the ray, beside a length that is computed as the way's is.
#define IS_FOUND(length) (fabs((double)found->t_max - (length)) <= WAY_ERROR * (length))

static double sum_of(OracleVector v)
{
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}

// Farther than that, in lengths of the way, is nowhere; and a light that is farther away, in scene
// units, may be taken for one that is nowhere.
#define NOWHERE 1e9
#define FAR 1000

RIGHT(ends_at_light, IS_FOUND(vector_length(way_of(in))))

KNOWN_LIST(ends)
{
    GIVEN;
    const OracleVector way_to = way_of(in);
    const double length = vector_length(way_to);

    EACH(nowhere, found->t_max > NOWHERE * length,
         "it has no end: what stands behind the light would cast a shadow, too");
    ONLY(far_nowhere, length > FAR && found->t_max > NOWHERE * length,
         "where the light is far away the ray has no end: it ends at the light, however far");
    ANSWERS(at_one, 1.0, "it ends at t = 1: so it is where the direction is as long as the way");
    EACH(squared, fabs(found->t_max - length * length) <= 2 * WAY_ERROR * length * length,
         "that is the square of the distance");
    ANSWERS(from_zero, vector_length(vector_of(in->light.position)),
            "that is the light's distance from the origin of the scene, not from the point");
    EACH(at_largest, fabs(found->t_max - largest_of(way_to)) <= WAY_ERROR * length,
         "that is the largest coordinate of the way, not its length");
    EACH(at_sum, fabs(found->t_max - sum_of(way_to)) <= 2 * WAY_ERROR * length,
         "that is the sum of the way's coordinates, not its length");
    EACH(little_off, fabs(found->t_max - length) <= 0.02 * fmax(1, length),
         "it ends beside the light: t_max is its distance, without an epsilon");
    EACH(at_start, found->t_max == 0, "it ends where it starts");
    return NO_MORE;
}

const Function ray_end_09 = {"shadow_rays", N_SHADOW_RAY_INPUTS, sizeof(ShadowRayAnswer),
                             KNOWING(ends_at_light, describe_ray, ends)};

// Shadows and mirrors by brute force, in double precision: every ray asks every sphere.
//
// How far may a right solution in float be off? With u = 2^-24 and the bounds of oracle3d.c:
//
// 1. The first hit is off as oracle3d.c has it. Each later one is off by what the ray that leads
//    there makes of every error before: followed to first order, one by one (oracle3d_deviation.h),
//    as the sum of their sizes, doubled for what is left out. The higher orders stay below the
//    first while no error is more than a sixteenth of a radius or of a unit vector; beyond that,
//    and beyond MOST_DEVIATED_MIRRORS, the ray is ambiguous.
// 2. New errors at each mirror: the intersection moves the point by 16 u of the centre's distance,
//    over the cosine at which the ray meets it, and by 4 u of its own numbers; new rays start one
//    or two offsets off the surface (oracle3d_offset()). The direction d - 2 (d . n) n is off by
//    four times a normal's rounding, UNIT_ERROR, and by 16 u: a dot product of 4 u, twice, two
//    products and a sum. A right solution may also make it a unit vector.
// 3. So errors grow from mirror to mirror: a point off by p turns the normal of a sphere of radius
//    r by p / r and the ray by up to 2 p / r, which moves its hit at distance t by 2 p t / r over
//    the cosine there. Small mirrors far apart multiply errors, as they spread light; flat ones and
//    the inside of a sphere only add them.
// 4. A light arrives for certain when no sphere may be hit before it, does not when one is hit for
//    certain, up to the error of its distance. Else this light's share is added to the error.
// 5. Light counts its weight, a product of exact numbers with a rounding of u each; so do errors.
//    A product within that of the least weight makes the ray ambiguous. The ks of one mirror is
//    no product, and exact.
#include "oracle3d_mirrors.h"

#include "oracle3d_deviation.h"

#include <string.h>

#define SURFACE_ERROR 0x1p-18         // of lab 09, leave_surface.cl
#define MIRROR_ERROR (16 * ROUNDING)  // see 2
#define STUB_OFFSET 0.125             // of the radius

static const OracleRules3D right = {0};

double oracle3d_offset(OracleVector point, double t, double radius)
{
    const double largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return SURFACE_ERROR * (t + fabs(radius) + largest);
}

OracleNear oracle3d_mirrored(OracleNear direction, OracleNear normal, OracleTurn turn)
{
    const OracleVector d = direction.value, n = normal.value;
    const double along = vector_dot(d, n),
                 error = direction.error + 4 * normal.error + MIRROR_ERROR;
    return turn == TURN_ALONG_NORMAL
               ? normal
               : (OracleNear){vector_minus(d, vector_scaled(2 * along, n)), error};
}

// ---- Mirrors ------------------------------------------------------------------------------------

// A point of a surface, as new rays need it.
typedef struct Surface {
    OracleNear point, normal;
    const Material *material;
    const Sphere *sphere;
} Surface;

// The way of a ray so far.
typedef struct Followed {
    OracleRay ray;          // the one at hand
    Deviations deviations;  // of it
    OracleNear color;
    double weight;
    double last_ks;   // of the last mirror; 1 before the first
    double first_ks;  // of the first one
    int n_bounces;
    OracleRayCount count;
} Followed;

// A ray from the eye that has gone nowhere yet. Of the deviations, which are many, none is set.
static void begin(Followed *followed, OracleRay ray)
{
    followed->ray = ray;
    followed->deviations.n = 0;
    followed->color = (OracleNear){{0}, 0};
    followed->weight = followed->last_ks = followed->first_ks = 1;
    followed->n_bounces = 0;
    followed->count = (OracleRayCount){0};
    deviations_add_direction(&followed->deviations, ray.direction_error);
}

// How far the point of a hit is off: by the interval of t, or to first order, whichever is less.
// The deviations are moved there.
static double point_error(Followed *followed, const OracleHit *hit, OracleVector normal,
                          double radius)
{
    const OracleRay *ray = &followed->ray;
    const double to_centre = hit->t + fabs(radius),
                 cosine = fabs(vector_dot(normal, ray->direction));
    const double rounding = 4 * ROUNDING * (vector_length(ray->origin) + hit->t);
    const double by_interval =
        ray->origin_error + hit->t_tolerance + ray->direction_error * fabs(hit->t) + rounding;
    deviations_hit(&followed->deviations, ray->direction, normal, hit->t);
    deviations_add_origin(&followed->deviations, rounding + 16 * ROUNDING * to_centre / cosine);
    const double to_first_order = 2 * deviations_of_origin(&followed->deviations);
    return to_first_order < fabs(radius) / 16 ? fmin(by_interval, to_first_order) : by_interval;
}

static Surface surface_at(const Scene3D *scene, Followed *followed, const OracleHit *hit)
{
    const OracleRay *ray = &followed->ray;
    const Sphere *sphere = &scene->spheres[hit->sphere];
    const OracleVector at = vector_plus(ray->origin, vector_scaled(hit->t, ray->direction));
    const OracleVector outwards = vector_unit(vector_minus(at, centre_of(*sphere)));
    Surface surface = {.point = {at, point_error(followed, hit, outwards, sphere->radius)},
                       .material = &scene->materials[scene->material_ids[hit->sphere]],
                       .sphere = sphere};
    surface.normal = oracle3d_normal(*sphere, surface.point,
                                     (OracleNear){ray->direction, ray->direction_error}, &right);
    return surface;
}

// Move the point off the surface, to where new rays start.
static void leave_surface(Surface *surface, Followed *followed, double t, int is_stub)
{
    const double radius = surface->sphere->radius;
    const OracleVector n = surface->normal.value;
    if (is_stub) {
        const double off = STUB_OFFSET * fabs(radius);
        surface->point.value = vector_plus(surface->point.value, vector_scaled(off, n));
        surface->point.error += off * surface->normal.error;
        deviations_add_origin(&followed->deviations, off * surface->normal.error);
        surface->sphere = NULL;
    } else {
        const double off = 2 * oracle3d_offset(surface->point.value, t, radius);
        surface->point.error += off;
        deviations_add_along(&followed->deviations, vector_scaled(off, n));
    }
}

// What the stub of lit_color gives: the material's colour by the normal, and a bit of where.
static OracleNear stub_light(const Surface *at, u32 nonce)
{
    const double share = 0x1p-4 + (nonce >> 24) * 0x1p-12;
    const OracleVector n = at->normal.value, p = at->point.value,
                       c = vector_scaled(0.5 + at->material->kd, vector_of(at->material->color));
    const OracleVector value = {c.x * (1 + n.x) + share * p.x, c.y * (1 + n.y) + share * p.y,
                                c.z * (1 + n.z) + share * p.z};
    // A colour of at most 1 and kd make a factor of at most 1.5; each of the six roundings is of a
    // number below 4 + |p|, in each of three components.
    return (OracleNear){value, 2 * at->normal.error + share * at->point.error +
                                   12 * ROUNDING * (4 + vector_length(p))};
}

// By what the light of a surface counts.
static double local_weight(const Followed *ray, double ks, OracleWeight weight)
{
    switch (weight) {
    case WEIGHT_LAST_KS:
        return ray->last_ks;
    case WEIGHT_OWN_KS:
        return ray->weight * ks;
    case WEIGHT_SHARED:
        return ray->weight * (1 - ks);
    case WEIGHT_ONLY_FIRST:
        return ray->n_bounces == 0 ? 1 : 0;
    case WEIGHT_LOCAL_ONE:
        return 1;
    default:
        return ray->weight;
    }
}

static double next_weight(const Followed *ray, const Material *material, OracleWeight weight)
{
    const double ks = material->ks, so_far = ray->weight;
    return weight == WEIGHT_ONE          ? 1
           : weight == WEIGHT_KS_SQUARED ? so_far * ks * ks
           : weight == WEIGHT_KD         ? so_far * material->kd
           : weight == WEIGHT_LAST_KS    ? ks
           : weight == WEIGHT_FIRST_KS   ? so_far * ray->first_ks
                                         : so_far * ks;
}

// How far a product of so many mirrors' ks may be off, as a share (see 5), and a sum by it.
static double weight_error(int n_bounces)
{
    return (16 + n_bounces) * ROUNDING;
}

// Add to the ray's colour.
static void add_weighted(OracleNear *color, double weight, int n_bounces, OracleNear light)
{
    const double rounding = weight_error(n_bounces) *
                            (vector_length(light.value) * weight + vector_length(color->value));
    color->value = vector_plus(color->value, vector_scaled(weight, light.value));
    color->error += weight * light.error + rounding;
}

static OracleNear ambiguous(void)
{
    return (OracleNear){{0}, INFINITY};
}

// The light of where the ray ends: nothing is hit.
static OracleNear with_background(const Scene3D *scene, const Followed *ray,
                                  const OracleMirrorRules *rules)
{
    OracleNear color = rules->background_replaces ? (OracleNear){{0}, 0} : ray->color;
    const int is_first = ray->n_bounces == 0;
    if (is_first || !rules->background_missing) {
        add_weighted(&color, rules->background_unweighted ? 1 : ray->weight, ray->n_bounces,
                     oracle3d_exactly(scene->background));
    }
    return color;
}

// Add the light of a hit, and move its point to where new rays start. Returns that light.
static OracleNear add_local(const Scene3D *scene, Followed *followed, Surface *at, double t,
                            const OracleMirrorRules *rules)
{
    const double weight = local_weight(followed, at->material->ks, rules->weight);
    const Sphere *sphere = at->sphere;
    leave_surface(at, followed, t, rules->stubs);
    const OracleNear light =
        rules->stubs ? stub_light(at, rules->nonce)
        : at->material->kd < rules->least_kd
            ? (OracleNear){{0}, 0}
            : oracle3d_lit(scene, at->point, at->normal, at->material, sphere, rules);
    const OracleSides sides = oracle3d_sides(scene->lights, scene->n_lights, at->point, at->normal);
    followed->count.n_hits++;
    followed->count.n_to_lights += sides.n_before;
    followed->count.n_unsure += sides.n_unsure;
    followed->count.n_needed += at->material->kd > 0 ? sides.n_before - sides.n_unsure : 0;
    followed->color = rules->replaces ? (OracleNear){{0}, 0} : followed->color;
    add_weighted(&followed->color, weight, followed->n_bounces, light);
    return light;
}

// What the stub of mirrored_direction adds to the normal before it makes it a unit vector.
static OracleVector stub_lean(u32 nonce)
{
    return (OracleVector){(nonce % 16 - 7.5) / 64, (nonce / 16 % 16 - 7.5) / 64,
                          (nonce / 256 % 16 - 7.5) / 64};
}

// Go on from a mirror. Returns 0 where the ray is too far off for first order.
static int mirror(Followed *followed, const Surface *at, const Sphere *sphere,
                  const OracleMirrorRules *rules)
{
    Deviations *deviations = &followed->deviations;
    followed->n_bounces++;
    if (rules->turn == TURN_NONE) {
        return 1;  // the same ray hits the same place
    }
    const OracleVector d = followed->ray.direction, n = at->normal.value;
    const int bulges = vector_dot(n, vector_minus(at->point.value, centre_of(*sphere))) > 0;
    const double curvature = (bulges ? 1 : -1) / fabs((double)sphere->radius);
    OracleNear direction = oracle3d_mirrored((OracleNear){d, 0}, at->normal, rules->turn);
    if (rules->turn == TURN_ALONG_NORMAL) {
        if (rules->stubs) {
            direction.value = vector_plus(direction.value, stub_lean(rules->nonce));
        }
        deviations_leave_along_normal(deviations, curvature);
        deviations_make_unit(deviations, direction.value);
    } else {
        deviations_mirror(deviations, d, n, curvature);
    }
    deviations_add_direction(deviations, 4 * UNIT_ERROR + MIRROR_ERROR);
    const double error = 2 * deviations_of_direction(deviations);
    const OracleVector origin = rules->from_the_eye ? followed->ray.origin : at->point.value;
    followed->ray = (OracleRay){.origin = origin,
                                .direction = vector_unit(direction.value),
                                .t_min = rules->mirror_t_min,
                                .direction_error = error,
                                .origin_error = at->point.error,
                                .leaves = rules->from_the_eye ? NULL : at->sphere};
    return error < 1.0 / 16 && followed->n_bounces < MOST_DEVIATED_MIRRORS;
}

static OracleNear follow(const Scene3D *scene, Followed *followed, int max_bounces,
                         const OracleMirrorRules *rules)
{
    const int is_limited = rules->most_bounces > 0 && max_bounces > rules->most_bounces;
    const int most = is_limited ? rules->most_bounces : max_bounces + rules->more_bounces;
    const double least_weight =
        rules->least_weight > 0 ? rules->least_weight : (double)ORACLE_LEAST_WEIGHT;
    // A loop that ends one mirror too early traces not even the first ray where none is allowed.
    while (most >= 0) {
        followed->count.n_traced++;
        const OracleHit hit =
            oracle3d_nearest(scene->spheres, (u32)scene->n_spheres, &followed->ray, &right);
        if (hit.is_ambiguous) {
            return ambiguous();
        }
        if (hit.sphere == ORACLE_NO_SPHERE ||
            (rules->mirrors_see_nothing && followed->n_bounces > 0)) {
            return with_background(scene, followed, rules);
        }
        if (rules->last_is_dark && followed->n_bounces >= most) {
            return followed->color;
        }
        Surface at = surface_at(scene, followed, &hit);
        if (isinf(at.normal.error) || isinf(at.point.error)) {
            return ambiguous();
        }
        const OracleNear light = add_local(scene, followed, &at, hit.t, rules);
        if (rules->dark_ends && vector_length(light.value) == 0) {
            return followed->color;
        }
        followed->first_ks =
            followed->n_bounces == 0 ? (double)at.material->ks : followed->first_ks;
        const double weight_before = followed->weight;
        followed->weight = next_weight(followed, at.material, rules->weight);
        followed->last_ks = at.material->ks;
        const double beyond =
            (rules->cut_off_late ? weight_before : followed->weight) - least_weight;
        const int is_too_little = beyond < 0 || (beyond == 0 && rules->least_ends);
        const double error =
            followed->n_bounces == 0 ? 0 : weight_error(followed->n_bounces) * followed->weight;
        if (followed->n_bounces < most && fabs(beyond) < error) {
            return ambiguous();
        }
        if (followed->n_bounces >= most || (is_too_little && !rules->no_cut_off)) {
            return rules->rest_is_background ? with_background(scene, followed, rules)
                                             : followed->color;
        }
        if (!mirror(followed, &at, &scene->spheres[hit.sphere], rules)) {
            return ambiguous();
        }
    }
    return followed->color;
}

OracleNear oracle3d_follow(const Scene3D *scene, OracleRay ray, int max_bounces,
                           const OracleMirrorRules *rules, OracleRayCount *count)
{
    Followed followed;
    begin(&followed, ray);
    const OracleNear color = follow(scene, &followed, max_bounces, rules);
    if (count != NULL) {
        *count = followed.count;
    }
    return color;
}

void oracle3d_draw_mirrors(const Scene3D *scene, const Camera *camera, int max_bounces,
                           const OracleMirrorRules *rules, Image *image, float *tolerances)
{
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            const size_t pixel = (size_t)y * (size_t)image->width + (size_t)x;
            const OracleRay ray =
                oracle3d_primary_ray(camera, x, y, image->width, image->height, &right);
            OracleNear color = oracle3d_follow(scene, ray, max_bounces, rules, NULL);
            if (rules->cut_at_one) {
                color.value = (OracleVector){fmin(color.value.x, 1), fmin(color.value.y, 1),
                                             fmin(color.value.z, 1)};
            }
            const float channels[IMAGE_CHANNELS] = {(float)color.value.x, (float)color.value.y,
                                                    (float)color.value.z, 1};
            memcpy(image->pixels + pixel * IMAGE_CHANNELS, channels, sizeof channels);
            tolerances[pixel] = (float)color.error;
        }
    }
}

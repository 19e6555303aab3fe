// Which lights arrive at a point, in double precision (see oracle3d_mirrors.h; how far float may be
// off stands at the top of oracle3d_mirrors.c, 4).
#include "oracle3d_mirrors.h"

#include "oracle3d_rounding.h"

static const OracleRules3D right = {0};

OracleSides oracle3d_sides(const Light *lights, int n_lights, OracleNear point, OracleNear normal)
{
    OracleSides sides = {0, 0};
    for (int i = 0; i < n_lights; i++) {
        const OracleVector way = vector_minus(vector_of(lights[i].position), point.value);
        const double distance = vector_length(way), along = vector_dot(normal.value, way);
        // A dot product of the way, or the difference of two such products.
        const double error = point.error + distance * normal.error +
                             8 * ROUNDING * (distance + vector_length(point.value));
        sides.n_before += along > -error;
        sides.n_unsure += fabs(along) <= error;
    }
    return sides;
}

OracleArrival oracle3d_arrival(const Scene3D *scene, OracleNear point, const Light *light,
                               const Sphere *leaves, const OracleMirrorRules *rules)
{
    const OracleVector way = vector_minus(vector_of(light->position), point.value);
    const double distance = vector_length(way);
    const double error = point.error + 8 * ROUNDING * distance;
    const double end = rules->endless_light ? INFINITY : distance;
    const OracleRay ray = {.origin = point.value,
                           .direction = vector_unit(way),
                           .direction_error = direction_error(error, distance),
                           .origin_error = point.error,
                           .leaves = leaves};
    OracleArrival arrival = LIGHT_ARRIVES;
    for (int i = 0; i < scene->n_spheres; i++) {
        const OracleRoot root = oracle3d_root(scene->spheres[i], &ray, ORACLE_PROJECTION, &right);
        if (root.is_certain && root.t_high < end - error) {
            return LIGHT_IS_BLOCKED;
        }
        if (root.is_possible && root.t_low < end + error) {
            arrival = LIGHT_IS_UNSURE;
        }
    }
    return arrival;
}

// Add what a light gives, as far as it is sure.
static void add_light(OracleNear *color, OracleNear share, OracleArrival arrival)
{
    if (arrival == LIGHT_ARRIVES) {
        color->value = vector_plus(color->value, share.value);
        color->error += share.error;
    } else if (arrival == LIGHT_IS_UNSURE) {
        color->error += vector_length(share.value) + share.error;
    }
}

static OracleArrival turned_round(OracleArrival arrival)
{
    return arrival == LIGHT_ARRIVES      ? LIGHT_IS_BLOCKED
           : arrival == LIGHT_IS_BLOCKED ? LIGHT_ARRIVES
                                         : LIGHT_IS_UNSURE;
}

OracleNear oracle3d_lit(const Scene3D *scene, OracleNear point, OracleNear normal,
                        const Material *material, const Sphere *leaves,
                        const OracleMirrorRules *rules)
{
    OracleNear color = {{0}, 0};
    const int n_lights = rules->first_light_only && scene->n_lights > 1 ? 1 : scene->n_lights;
    int is_any_dark = 0;
    for (int i = 0; i < n_lights; i++) {
        const Light *light = &scene->lights[i];
        const OracleNear share = oracle3d_shade(point, normal, material, light, 1, &right);
        // Behind the surface it gives nothing, whatever stands before it.
        const int is_behind = vector_length(share.value) == 0;
        const OracleArrival arrival = rules->no_shadows || is_behind
                                          ? LIGHT_ARRIVES
                                          : oracle3d_arrival(scene, point, light, leaves, rules);
        is_any_dark |= arrival != LIGHT_ARRIVES;
        add_light(&color, share, rules->only_shadows ? turned_round(arrival) : arrival);
    }
    // Each sum rounds.
    color.error += ROUNDING * scene->n_lights * vector_length(color.value);
    return rules->one_dark_all_dark && is_any_dark ? (OracleNear){{0}, color.error} : color;
}

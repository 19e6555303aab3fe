// The colours of what rays hit, in double precision: normals, Lambert's law, whole pictures.
//
// How far a right solution's colour may be off goes on from what oracle3d.c derives for hits:
//
// 5. The point hit is off by p: t's interval, the direction's error times t, and 4 u of its
//    coordinates; the unit normal by p / (r - p) and a normalisation, much for small spheres far
//    away; the way to a light by p over its distance. Their cosine is off by the sum of both, and
//    so is a channel in units of kd x colour x light. Seen along the surface, float may turn the
//    normal or not: the pixel is ambiguous then.
#include "oracle3d.h"
#include "oracle3d_rounding.h"

#include <string.h>

#define SUM_ERROR (8 * ROUNDING)  // of a light's share: five products and a sum, of 1 u each

// ---- Normals ----------------------------------------------------------------------------------

OracleNear oracle3d_exactly(Vec3 v)
{
    return (OracleNear){vector_of(v), 0};
}

int oracle3d_is_near(Vec3 found, OracleNear expected)
{
    return fabs(found.x - expected.value.x) <= expected.error &&
           fabs(found.y - expected.value.y) <= expected.error &&
           fabs(found.z - expected.value.z) <= expected.error;
}

// Is the dot product of a normal and a direction, both given exactly, one product in every right
// solution? Then it is exact, however small: around the origin, and along an axis.
static int is_one_product(Sphere sphere, OracleNear point, OracleNear direction)
{
    const OracleVector p = point.value;
    return point.error == 0 && direction.error == 0 && sphere.x == 0 && sphere.y == 0 &&
           sphere.z == 0 && (p.x != 0) + (p.y != 0) + (p.z != 0) == 1;
}

OracleNear oracle3d_normal(Sphere sphere, OracleNear point, OracleNear direction,
                           const OracleRules3D *rules)
{
    const OracleVector outwards = vector_minus(point.value, centre_of(sphere));
    const double distance = vector_length(outwards), rounding = ROUNDING * distance;
    OracleNear normal = {rules->normal_not_normalised ? outwards : vector_unit(outwards),
                         direction_error(point.error + rounding, distance)};
    const double cosine = vector_dot(vector_unit(outwards), direction.value);
    if (!rules->normal_not_turned && (rules->normal_always_turned || cosine > 0)) {
        normal.value = vector_scaled(-1, normal.value);
    }
    if (!is_one_product(sphere, point, direction) &&
        !(fabs(cosine) > normal.error + direction.error + 4 * ROUNDING)) {
        normal.error = INFINITY;
    }
    return normal;
}

// What one light adds.
typedef struct Share {
    OracleVector value;
    double error;      // of each channel
    double brightest;  // channel of it where the cosine is 1
} Share;

static Share share_of(OracleNear point, OracleNear normal, const Material *material,
                      const Light *light, const OracleRules3D *rules)
{
    const OracleVector way = vector_minus(vector_of(light->position), point.value);
    const OracleVector to_light = rules->to_light_not_normalised ? way : vector_unit(way);
    const double distance = vector_length(way), dot = vector_dot(normal.value, to_light);
    const double cosine = rules->cosine_absolute      ? fabs(dot)
                          : rules->cosine_not_clamped ? dot
                                                      : fmax(dot, 0);
    const OracleVector white = {1, 1, 1},
                       shine = rules->ignore_light_color ? white : vector_of(light->color);
    const OracleVector surface =
        vector_scaled(rules->ignore_kd ? 1 : material->kd,
                      rules->ignore_color ? white : vector_of(material->color));
    const OracleVector full = {surface.x * shine.x, surface.y * shine.y, surface.z * shine.z};
    const double brightest = fmax(fmax(fabs(full.x), fabs(full.y)), fabs(full.z));
    const double error =
        vector_length(to_light) * (normal.error + 4 * ROUNDING +
                                   direction_error(point.error + ROUNDING * distance, distance));
    return (Share){vector_scaled(cosine, full), brightest * error, brightest};
}

OracleNear oracle3d_shade(OracleNear point, OracleNear normal, const Material *material,
                          const Light *lights, int n_lights, const OracleRules3D *rules)
{
    OracleNear sum = {{0}, 0};
    const int first = rules->last_light_only && n_lights > 1 ? n_lights - 1 : 0;
    const int end = rules->first_light_only && n_lights > 1 ? 1 : n_lights;
    for (int i = first; i < end + (rules->one_light_more ? 1 : 0); i++) {
        const Share share = share_of(point, normal, material, &lights[i], rules);
        sum.value = vector_plus(sum.value, share.value);
        sum.error += share.error + share.brightest * SUM_ERROR * n_lights;
    }
    if (rules->cut_at_one) {
        sum.value =
            (OracleVector){fmin(sum.value.x, 1), fmin(sum.value.y, 1), fmin(sum.value.z, 1)};
    }
    return sum;
}

// ---- Pictures ---------------------------------------------------------------------------------

// The colour of a ray that hits something, and how far a channel may be off.
static OracleNear hit_color(const Scene3D *scene, const OracleRay *ray, const OracleHit *hit,
                            const OracleRules3D *rules)
{
    const Sphere sphere = scene->spheres[hit->sphere];
    const OracleNear direction = {ray->direction, ray->direction_error};
    const OracleVector at = vector_plus(ray->origin, vector_scaled(hit->t, ray->direction));
    const OracleNear point = {at, hit->t_tolerance + ray->direction_error * fabs(hit->t) +
                                      4 * ROUNDING * (vector_length(ray->origin) + fabs(hit->t))};
    const OracleNear normal = oracle3d_normal(sphere, point, direction, rules);
    const u32 material = rules->ignore_material_ids && hit->sphere < (u32)scene->n_materials
                             ? hit->sphere
                             : scene->material_ids[hit->sphere];
    return oracle3d_shade(point, normal, &scene->materials[material], scene->lights,
                          scene->n_lights, rules);
}

void oracle3d_draw(const Scene3D *scene, const Camera *camera, const OracleRules3D *rules,
                   Image *image, float *tolerances, OracleHit *hits)
{
    const OracleVector background =
        rules->background_black ? (OracleVector){0, 0, 0} : vector_of(scene->background);
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            const size_t pixel = (size_t)y * (size_t)image->width + (size_t)x;
            const OracleRay ray =
                oracle3d_primary_ray(camera, x, y, image->width, image->height, rules);
            const OracleHit hit =
                oracle3d_nearest(scene->spheres, (u32)scene->n_spheres, &ray, rules);
            OracleNear color = {background, 0};
            if (hit.sphere != ORACLE_NO_SPHERE) {
                color = hit_color(scene, &ray, &hit, rules);
            }
            const float channels[IMAGE_CHANNELS] = {(float)color.value.x, (float)color.value.y,
                                                    (float)color.value.z, 1};
            memcpy(image->pixels + pixel * IMAGE_CHANNELS, channels, sizeof channels);
            if (tolerances != NULL) {
                tolerances[pixel] = hit.is_ambiguous ? INFINITY : (float)color.error;
            }
            if (hits != NULL) {
                hits[pixel] = hit;
            }
        }
    }
}

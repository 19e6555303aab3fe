// Right answers of lab 09, in plain C: every ray asks every sphere.
#ifndef UNIT_RIGHT_ANSWERS_MIRRORS_H
#define UNIT_RIGHT_ANSWERS_MIRRORS_H

#include "jobs_09.h"
#include "right_answers_3d.h"

// ---- Functions ----------------------------------------------------------------------------------

static Vec3 leave_surface(Vec3 point, Vec3 normal, float t, float radius)
{
    const float largest = fmaxf(fmaxf(fabsf(point.x), fabsf(point.y)), fabsf(point.z));
    return vec3_plus(point, vec3_scaled(normal, 0x1p-18f * (t + fabsf(radius) + largest)));
}

static Vec3 mirrored(Vec3 direction, Vec3 normal)
{
    return vec3_minus(direction, vec3_scaled(normal, 2 * vec3_dot(direction, normal)));
}

static ShadowRayAnswer shadow_ray(Vec3 point, Light light)
{
    const Vec3 way = vec3_minus(light.position, point);
    return (ShadowRayAnswer){point, vec3_normalized(way), 0, (float)vec3_length(way)};
}

static void answer_rays(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const StartJob *starts = sections_find_any(job, "starts", &n_bytes);
    size_t n = n_bytes / sizeof *starts;
    Vec3 *vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        const StartJob in = starts[i];
        vectors[i] = leave_surface(in.point, in.normal, in.t, in.radius);
    }
    answer(writer, "starts", vectors, n * sizeof *vectors);
    free(vectors);

    const MirrorJob *mirrors = sections_find_any(job, "mirrors", &n_bytes);
    n = n_bytes / sizeof *mirrors;
    vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        vectors[i] = mirrored(mirrors[i].direction, mirrors[i].normal);
    }
    answer(writer, "mirrors", vectors, n * sizeof *vectors);
    free(vectors);

    const ShadowRayJob *lights = sections_find_any(job, "shadow_rays", &n_bytes);
    n = n_bytes / sizeof *lights;
    ShadowRayAnswer *rays = calloc(n, sizeof *rays);
    for (size_t i = 0; i < n; i++) {
        rays[i] = shadow_ray(lights[i].point, lights[i].light);
    }
    answer(writer, "shadow_rays", rays, n * sizeof *rays);
    free(rays);
}

static void answer_blocks(Writer *writer, const Sections *job)
{
    size_t n_bytes, n_part_bytes;
    const BlockJob *blocks = sections_find_any(job, "blocks", &n_bytes);
    const u32 *ids = sections_find_any(job, "block_ids", &n_part_bytes);
    const Sphere *spheres = sections_find_any(job, "block_spheres", &n_part_bytes);
    const size_t n = n_bytes / sizeof *blocks;
    BlockAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const BlockJob *in = &blocks[i];
        const Ray ray = {in->origin, in->direction};
        for (u32 k = 0; k < in->node.n_spheres && !answers[i].is_blocked; k++) {
            const Sphere sphere = spheres[ids[in->node.first + k]];
            answers[i].is_blocked = intersect(sphere, ray, 0) < in->t_max;
            answers[i].n_tests++;
        }
    }
    answer(writer, "blocks", answers, n * sizeof *answers);
    free(answers);
}

// ---- Light --------------------------------------------------------------------------------------

//   n_sent   in and out: how many rays are sent
static Vec3 lit_color(const SphereScene *scene, Vec3 point, Vec3 normal, Material material,
                      const Light *lights, int n_lights, u32 *n_sent)
{
    Vec3 color = {0};
    for (int i = 0; i < n_lights; i++) {
        const ShadowRayAnswer to_light = shadow_ray(point, lights[i]);
        Work work = {0};
        const Ray ray = {point, to_light.direction};
        if (vec3_dot(normal, ray.direction) <= 0) {
            continue;
        }
        ++*n_sent;
        if (find_in_all(scene, ray, &work).t >= to_light.t_max) {
            color = vec3_plus(color, shade(point, normal, material, &lights[i], 1));
        }
    }
    return color;
}

static void answer_lits(Writer *writer, const Sections *job)
{
    size_t n_bytes, n_light_bytes;
    const LitJob *lits = sections_find_any(job, "lits", &n_bytes);
    const Light *lights = sections_find_any(job, "lit_lights", &n_light_bytes);
    const size_t n = n_bytes / sizeof *lits;
    LitAnswer *answers = calloc(n, sizeof *answers);
    SphereScene scene;
    sphere_scene_read(job, LIT_SCENE, &scene);
    for (size_t i = 0; i < n; i++) {
        const LitJob *in = &lits[i];
        answers[i].color = lit_color(&scene, in->point, in->normal, in->material,
                                     lights + in->first_light, in->n_lights, &answers[i].n_leaves);
    }
    answer(writer, "lits", answers, n * sizeof *answers);
    free(answers);
}

// The colour of a ray and of what it sees in mirrors, in a scene with "scene.K.bounces".
//   n_sent   in and out: how many rays are sent, but for the first one
static Vec3 follow(const SphereScene *scene, Ray ray, HitAnswer hit, u32 *n_sent)
{
    Vec3 color = {0};
    float weight = 1;
    Work work = {0};
    for (int n_bounces = 0; hit.t < INFINITY; n_bounces++) {
        const Sphere sphere = scene->spheres[hit.sphere];
        const Material material = scene->materials[scene->material_ids[hit.sphere]];
        const Vec3 point = vec3_plus(ray.origin, vec3_scaled(ray.direction, hit.t));
        const Vec3 normal = surface_normal(sphere, point, ray.direction);
        const Vec3 start = leave_surface(point, normal, hit.t, sphere.radius);
        const Vec3 own =
            lit_color(scene, start, normal, material, scene->lights, scene->job->n_lights, n_sent);
        color = vec3_plus(color, vec3_scaled(own, weight));
        weight *= material.ks;
        if (n_bounces == *scene->max_bounces || weight < 0.5f / 255) {
            return color;
        }
        ray = (Ray){start, mirrored(ray.direction, normal)};
        hit = find_in_all(scene, ray, &work);
        ++*n_sent;
    }
    return vec3_plus(color, vec3_scaled(scene->job->background, weight));
}

// As ColorOfHit of right_answers_3d.h has it.
static Vec3 color_over_mirrors(const SphereScene *scene, Ray ray, HitAnswer hit)
{
    u32 n_sent = 0;
    return follow(scene, ray, hit, &n_sent);
}

// As FindHit has it. Each ray that is sent visits a leaf.
static HitAnswer find_in_leaf(const SphereScene *scene, Ray ray, Work *work)
{
    const HitAnswer hit = find_in_all(scene, ray, work);
    u32 n_sent = 1;
    follow(scene, ray, hit, &n_sent);
    work->n_leaves_visited += n_sent;
    return hit;
}

#endif

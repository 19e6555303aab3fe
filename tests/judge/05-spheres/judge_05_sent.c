// Inputs of lab 05's functions that whole pictures send, and nearest_root's that the two
// intersections send on their own inputs. See judge_05.h, sent.h.
#include "judge_05.h"

#include "oracle3d_rounding.h"
#include "random3d.h"
#include "sent.h"

#include <math.h>

static const OracleRules3D right = {0};

// A share of the numbers of a root that is more than any rounding.
#define CLEARLY 1e-5

// ---- nearest_root -------------------------------------------------------------------------------

// The call for a ray and a sphere, in the range that it belongs to. None is kept of which rounding
// decides the answer.
static void keep_root(Random *random, const SphereRayJob *job, Sent roots[3])
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    const OracleVector c = vector_minus(centre_of(job->sphere), ray.origin);
    const double b = vector_dot(c, ray.direction), r = job->sphere.radius;
    const OracleVector l = vector_minus(c, vector_scaled(b, ray.direction));
    const RootJob root = {(float)b, (float)(r * r - vector_dot(l, l)), job->sphere.radius,
                          job->t_min};
    const double half = sqrt(fmax(root.disc, 0)), least = CLEARLY * (fabs(b) + half);
    const double entry = root.b - half - root.t_min, exit = root.b + half - root.t_min;
    if (fabs(entry) > least && fabs(exit) > least) {
        const int is_inside = root.radius < 0 || entry < 0;
        sent_keep(&roots[root.t_min != 0 ? 2 : is_inside], random, &root);
    }
}

// ---- intersect_sphere, surface_normal -----------------------------------------------------------

// Spheres that are less than that, as a share of their distance, are small and far.
#define SMALL_SHARE 0.01

static void keep_sphere(Random *random, const SphereRayJob *job, Sent spheres[3])
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, 0);
    const OracleVector c = vector_minus(centre_of(job->sphere), ray.origin);
    const double distance = vector_length(c), r = job->sphere.radius;
    const int is_inside = r < 0 || distance < r || vector_dot(c, ray.direction) < 0;
    sent_keep(&spheres[is_inside ? 1 : fabs(r) < SMALL_SHARE * distance ? 2 : 0], random, job);
}

static void keep_normal(Random *random, const SphereRayJob *ray, double t, Sent normals[2])
{
    const OracleVector direction = vector_of(ray->direction);
    const NormalJob job = {
        ray->sphere,
        vector_rounded(vector_plus(vector_of(ray->origin), vector_scaled(t, direction))),
        ray->direction};
    const OracleVector outwards = vector_minus(vector_of(job.point), centre_of(job.sphere));
    const OracleNear normal = oracle3d_normal(job.sphere, oracle3d_exactly(job.point),
                                              oracle3d_exactly(job.direction), &right);
    // Rays that graze the surface are among the edges.
    const double along = vector_dot(vector_unit(outwards), direction);
    if (!isinf(normal.error) && fabs(along) > 0x1p-4) {
        sent_keep(&normals[along > 0], random, &job);
    }
}

// ---- All ----------------------------------------------------------------------------------------

// The ray of some pixel of a scene, and a sphere: the one that it hits, or any. Returns where it is
// hit for certain, or INFINITY.
static double roll_call(Random *random, const JobScene3D *scene, SphereRayJob *job)
{
    const Scene3D *s = &scene->scene;
    const int pixel = (int)random_integer(random, 0, s->width * s->height - 1);
    const OracleHit *hit = &scene->hits[pixel];
    const OracleRay ray = job_scene3d_ray(scene, pixel);
    const int is_hit = hit->sphere != ORACLE_NO_SPHERE && random_integer(random, 0, 2) > 0;
    const u32 sphere = is_hit ? hit->sphere : (u32)random_integer(random, 0, s->n_spheres - 1);
    *job = (SphereRayJob){.sphere = s->spheres[sphere],
                          .origin = vector_rounded(ray.origin),
                          .direction = vector_rounded(ray.direction)};
    return is_hit && !hit->is_ambiguous ? hit->t : INFINITY;
}

void inputs_05_add_sent(Job05 *job, Random *random)
{
    enum { N_CALLS = 12000 };
    Sent roots[3], spheres[3], normals[2];
    for (int range = 0; range < 3; range++) {
        roots[range] = SENT_TO(job->roots + range * N_ROOTS, N_SENT_ROOTS);
        spheres[range] = SENT_TO(job->projection + range * N_SPHERES, N_SENT_SPHERES);
    }
    for (int range = 0; range < 2; range++) {
        normals[range] = SENT_TO(job->normals + range * N_NORMALS, N_SENT_NORMALS);
    }
    for (int i = 0; i < N_CALLS; i++) {
        const JobScene3D *scene = &job->scenes[i % N_SCENES];
        SphereRayJob call;
        if (scene->scene.n_spheres > 0) {
            const double t = roll_call(random, scene, &call);
            keep_root(random, &call, roots);
            keep_sphere(random, &call, spheres);
            if (!isinf(t)) {
                keep_normal(random, &call, t, normals);
            }
        }
    }
    for (int i = 0; i < COUNT(job->projection); i++) {
        keep_root(random, &job->projection[i], roots);
    }
    for (int i = 0; i < COUNT(job->textbook); i++) {
        keep_root(random, &job->textbook[i], roots);
    }
}

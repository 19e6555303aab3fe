// count_rays: how many rays Haines' database "balls" (size 4) takes, floor included, in double
// precision.
//
//     count_rays
//
// Haines published how many rays his own ray tracer followed: from the eye, mirrored, and to the
// lights. The labs draw no floor; here it stands as in the original (z = -0.5, 12 to each side), so
// that the numbers can be compared. Of the floor nothing is mirrored, and a ray goes to each light
// that is in front of a surface. Prints a line for each kind: our number, "of", and his.
#include "camera_from_view.h"
#include "complain.h"
#include "kdtree3d_build.h"
#include "oracle3d.h"
#include "scene3d.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FLOOR_Z (-0.5)
#define FLOOR_SIDE 12.0

// 512 pixels are parted by 513 corners, and Haines' rays go through those.
enum { SIDE = 513 };

// So often a ray is mirrored at most: five rays, one after the other. One more or less would change
// the number of mirrored rays by a tenth.
enum { MAX_BOUNCES = 4 };

// A ray's own surface, met again in double: coordinates are about 1, and the smallest ball 1 / 162.
#define SURFACE_ERROR 1e-9

typedef struct Ray {
    OracleVector origin, direction;
} Ray;

// What is hit first; its normal is on the side that the ray comes from.
typedef struct Found {
    double t;  // INFINITY when nothing is hit
    OracleVector normal;
    int is_mirror;
} Found;

typedef struct Balls {
    Scene3D scene;
    KdTree3D tree;
} Balls;

typedef struct Counts {
    int eye_hits, mirrored, shadow;
} Counts;

static OracleVector point_at(const Ray *ray, double t)
{
    return vector_plus(ray->origin, vector_scaled(t, ray->direction));
}

static double component(OracleVector v, u32 axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static void ask_ball(const Balls *balls, u32 id, const Ray *ray, Found *found)
{
    const Sphere ball = balls->scene.spheres[id];
    const OracleVector centre = {ball.x, ball.y, ball.z};
    const OracleVector to_centre = vector_minus(centre, ray->origin);
    const double middle = vector_dot(to_centre, ray->direction);
    const OracleVector aside = vector_minus(to_centre, vector_scaled(middle, ray->direction));
    const double disc = (double)ball.radius * ball.radius - vector_dot(aside, aside);
    // Nobody is inside of a ball, so the nearer end of the chord is the one that is seen.
    const double t = disc > 0 ? middle - sqrt(disc) : INFINITY;
    if (t > SURFACE_ERROR && t < found->t) {
        *found = (Found){t, vector_unit(vector_minus(point_at(ray, t), centre)), 1};
    }
}

static void ask_floor(const Ray *ray, Found *found)
{
    const double t = (FLOOR_Z - ray->origin.z) / ray->direction.z;
    const OracleVector point = point_at(ray, t);
    if (t > SURFACE_ERROR && t < found->t && fabs(point.x) <= FLOOR_SIDE &&
        fabs(point.y) <= FLOOR_SIDE) {
        *found = (Found){t, {0, 0, ray->direction.z < 0 ? 1 : -1}, 0};
    }
}

// Ask the balls of a node whose part of the ray begins at t_min and ends at t_max. As hits count
// wherever they lie, parts need not be exact.
static void ask_node(const Balls *balls, u32 id, const Ray *ray, double t_min, double t_max,
                     Found *found)
{
    const KdNode3 node = balls->tree.nodes[id];
    if (t_min > fmin(t_max, found->t) + SURFACE_ERROR) {
        return;
    }
    if (node.split_axis == KD_LEAF) {
        for (u32 i = node.first; i < node.first + node.n_spheres; i++) {
            ask_ball(balls, balls->tree.sphere_ids[i], ray, found);
        }
        return;
    }
    const double from_plane = component(ray->origin, node.split_axis) - node.split_pos;
    const double t_split = -from_plane / component(ray->direction, node.split_axis);
    const u32 near_child = node.first + (from_plane > 0),
              far_child = node.first + (from_plane <= 0);
    if (!(t_split >= 0)) {
        // The plane is behind the ray, or along it.
        ask_node(balls, near_child, ray, t_min, t_max, found);
        return;
    }
    ask_node(balls, near_child, ray, t_min, fmin(t_max, t_split), found);
    ask_node(balls, far_child, ray, fmax(t_min, t_split), t_max, found);
}

static Found find(const Balls *balls, const Ray *ray)
{
    Found found = {.t = INFINITY};
    ask_floor(ray, &found);
    ask_node(balls, 0, ray, 0, INFINITY, &found);
    return found;
}

static void count_shadow_rays(const Balls *balls, OracleVector point, OracleVector normal,
                              Counts *counts)
{
    for (int i = 0; i < balls->scene.n_lights; i++) {
        const OracleVector way = vector_minus(vector_of(balls->scene.lights[i].position), point);
        counts->shadow += vector_dot(way, normal) > 0;
    }
}

// Follow a ray from the eye from mirror to mirror.
static void follow(const Balls *balls, Ray ray, Counts *counts)
{
    for (int n_bounces = 0;; n_bounces++) {
        const Found found = find(balls, &ray);
        if (isinf(found.t)) {
            return;
        }
        counts->eye_hits += n_bounces == 0;
        ray.origin = point_at(&ray, found.t);
        count_shadow_rays(balls, ray.origin, found.normal, counts);
        if (!found.is_mirror || n_bounces == MAX_BOUNCES) {
            return;
        }
        counts->mirrored++;
        const double along = vector_dot(ray.direction, found.normal);
        ray.direction = vector_minus(ray.direction, vector_scaled(2 * along, found.normal));
    }
}

int main(void)
{
    Balls balls = {0};
    if (scene3d_open("sphereflake", SIDE, SIDE, &balls.scene) != 0) {
        return EXIT_FAILURE;
    }
    const u32 n_balls = (u32)balls.scene.n_spheres;
    if (kdtree3d_build(balls.scene.spheres, n_balls, tree3d_limits(0, 0, n_balls), &balls.tree) !=
        0) {
        return EXIT_FAILURE;
    }
    const Camera camera = camera_from_view(balls.scene.view, SIDE, SIDE);
    const OracleRules3D right = {0};
    Counts counts = {0};
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            const OracleRay ray = oracle3d_primary_ray(&camera, x, y, SIDE, SIDE, &right);
            follow(&balls, (Ray){ray.origin, ray.direction}, &counts);
        }
    }
    printf("eye %d of 263169\nmirrored %d of 175095\nshadow %d of 954368\n", counts.eye_hits,
           counts.mirrored, counts.shadow);
    tree3d_free(&balls.tree);
    scene3d_free(&balls.scene);
    return EXIT_SUCCESS;
}

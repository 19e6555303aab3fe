// How much a right search does for a tile, at most: why counted work can be judged tile by tile.
//
// Each number of a right solution may lie anywhere within its rounding: a direction's part within
// the rays' error (oracle3d.c, 1), a plane's distance within PLANE_ERROR of what follows from it.
// Whatever may be visited so counts; nodes are left out where every right search must: behind the
// farthest of all rays' hits, of those that are certain, in leaves that no right search leaves out.
#include "judge_10.h"

#include "oracle3d.h"
#include "oracle3d_rounding.h"
#include "span.h"

#include <math.h>

// How much wider than its rays a tile's cone may be: CONE_ERROR of lab 10's tile_rays.cl, for sine
// and cosine, and once more for what rounds there.
#define CONE_ERROR (3 * 0x1p-18)

// The rays of a tile, and between which directions and in which cone they are.
typedef struct OracleTile {
    const JobScene3D *scene;
    OracleRay rays[TILE_RAYS];
    double low[3], high[3];  // of the directions
    double error;            // how far each of these may be off
    double eye[3];
    OracleVector axis;
    double sine, cosine;
    double t_certain[TILE_RAYS];   // each right search has a hit no farther than this,
    double t_possible[TILE_RAYS];  // and none a nearer one
    Work most;
} OracleTile;

static void set_cone(OracleTile *tile)
{
    const OracleVector sum = {tile->low[0] + tile->high[0], tile->low[1] + tile->high[1],
                              tile->low[2] + tile->high[2]};
    tile->axis = vector_unit(sum);
    double least_along = 1;
    for (int i = 0; i < TILE_RAYS; i++) {
        const OracleVector d = tile->rays[i].direction;
        const double along = vector_dot(d, tile->axis);
        const OracleVector aside = vector_minus(d, vector_scaled(along, tile->axis));
        tile->sine = fmax(tile->sine, vector_length(aside));
        least_along = fmin(least_along, along);
    }
    tile->sine += CONE_ERROR;
    // Beyond this a right solution may take all that is around.
    const int is_narrow = least_along > 0x1p-10 && tile->sine < 1 - 0x1p-10;
    tile->cosine = is_narrow ? sqrt(1 - tile->sine * tile->sine) - CONE_ERROR : -1;
    tile->sine = is_narrow ? tile->sine : 0;
}

static OracleTile tile_at(const JobScene3D *scene, int x, int y)
{
    static const OracleRules3D right = {0};
    const Scene3D *s = &scene->scene;
    OracleTile tile = {.scene = scene,
                       .low = {INFINITY, INFINITY, INFINITY},
                       .high = {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < TILE_RAYS; i++) {
        const int at_x = x + i % TILE_SIDE, at_y = y + i / TILE_SIDE;
        OracleRay *ray = &tile.rays[i];
        *ray = oracle3d_primary_ray(&scene->camera, at_x < s->width ? at_x : s->width - 1,
                                    at_y < s->height ? at_y : s->height - 1, s->width, s->height,
                                    &right);
        tile.error = fmax(tile.error, ray->direction_error);
        tile.t_certain[i] = tile.t_possible[i] = INFINITY;
        for (u32 axis = 0; axis < 3; axis++) {
            const double d = vector_component(ray->direction, axis);
            tile.low[axis] = fmin(tile.low[axis], d);
            tile.high[axis] = fmax(tile.high[axis], d);
            tile.eye[axis] = vector_component(ray->origin, axis);
        }
    }
    set_cone(&tile);
    return tile;
}

// From where to where the rays meet a plane, or are in a node.
typedef struct Part {
    Span begin, end;
} Part;

// How far the ray of this direction goes to a plane, which is `way` away.
//   direction   towards the plane it is positive
static Span distance_span(double way, double rounding, double direction, double error)
{
    const double least = fmax(0, way - rounding), most = way + rounding;
    return (Span){direction + error > 0 ? least / (direction + error) : INFINITY,
                  direction - error > 0 ? most / (direction - error) : INFINITY};
}

static Part plane_part(const OracleTile *tile, u32 axis, double plane)
{
    const double eye = tile->eye[axis], error = tile->error;
    const double way = fabs(plane - eye), rounding = PLANE_ERROR * (fabs(plane) + fabs(eye));
    const int is_up = eye <= plane;
    const double steepest = is_up ? tile->high[axis] : -tile->low[axis];
    const double flattest = is_up ? tile->low[axis] : -tile->high[axis];
    return (Part){distance_span(way, rounding, steepest, error),
                  distance_span(way, rounding, flattest, error)};
}

static Part clip(const OracleTile *tile, BBox3D box)
{
    Part part = {{0, 0}, {INFINITY, INFINITY}};
    for (u32 axis = 0; axis < 3; axis++) {
        const Part to_min = plane_part(tile, axis, box.min[axis]);
        const Part to_max = plane_part(tile, axis, box.max[axis]);
        if (tile->eye[axis] < box.min[axis]) {
            part.begin = span_max(part.begin, to_min.begin);
            part.end = span_min(part.end, to_max.end);
        } else if (tile->eye[axis] > box.max[axis]) {
            part.begin = span_max(part.begin, to_max.begin);
            part.end = span_min(part.end, to_min.end);
        } else {
            part.end = span_min(part.end, span_min(to_min.end, to_max.end));
        }
    }
    return part;
}

// May a right search ask a sphere for the whole tile?
static int may_ask(const OracleTile *tile, Sphere sphere)
{
    const OracleVector centre = {sphere.x - tile->eye[0], sphere.y - tile->eye[1],
                                 sphere.z - tile->eye[2]};
    const double along = vector_dot(centre, tile->axis);
    const double aside = vector_length(vector_minus(centre, vector_scaled(along, tile->axis)));
    const double size = fabs((double)sphere.radius);
    const double error = 32 * 0x1p-24 * (vector_length(centre) + size);
    return along <= error || aside * tile->cosine - along * tile->sine <= size + error;
}

static double farthest_of(const double distances[TILE_RAYS])
{
    double farthest = 0;
    for (int i = 0; i < TILE_RAYS; i++) {
        farthest = fmax(farthest, distances[i]);
    }
    return farthest;
}

static void visit_leaf(OracleTile *tile, KdNode3 leaf, int is_certain)
{
    static const OracleRules3D right = {0};
    tile->most.n_leaves_visited++;
    for (u32 i = leaf.first; i < leaf.first + leaf.n_spheres; i++) {
        const Sphere sphere = tile->scene->scene.spheres[tile->scene->tree.sphere_ids[i]];
        if (!may_ask(tile, sphere)) {
            continue;
        }
        tile->most.n_tests++;
        for (int ray = 0; ray < TILE_RAYS; ray++) {
            const OracleRoot root =
                oracle3d_root(sphere, &tile->rays[ray], ORACLE_PROJECTION, &right);
            if (root.is_possible) {
                tile->t_possible[ray] = fmin(tile->t_possible[ray], root.t_low);
            }
            if (root.is_certain && is_certain) {
                tile->t_certain[ray] = fmin(tile->t_certain[ray], root.t_high);
            }
        }
    }
}

// Visit all that a right search may visit in a node.
//   part         of the rays in it
//   is_certain   no right search leaves the node out
//   n_waiting    how many nodes may wait meanwhile
static void visit(OracleTile *tile, u32 id, Part part, int is_certain, u32 n_waiting)
{
    const KdNode3 node = tile->scene->tree.nodes[id];
    if (node.split_axis == KD_LEAF) {
        visit_leaf(tile, node, is_certain);
        return;
    }
    tile->most.n_nodes_visited++;
    const Part split = plane_part(tile, node.split_axis, node.split_pos);
    const u32 side = tile->eye[node.split_axis] > node.split_pos;
    const int may_meet_far = split.begin.low <= part.end.high;
    const int must_meet_far = split.begin.high <= part.end.low;
    const int may_meet_near = split.end.high >= part.begin.low || split.begin.high > part.end.low;
    const int must_meet_near = split.end.low >= part.begin.high || split.begin.low > part.end.high;
    const u32 n_with_far = n_waiting + (may_meet_far ? 1 : 0);
    if (may_meet_near) {
        const Part near_part = {part.begin, span_min(part.end, split.end)};
        tile->most.stack_depth =
            n_with_far > tile->most.stack_depth ? n_with_far : tile->most.stack_depth;
        visit(tile, node.first + side, near_part, is_certain && must_meet_near, n_with_far);
    }
    const Part far_part = {span_max(part.begin, split.begin), part.end};
    if (may_meet_far && far_part.begin.low <= farthest_of(tile->t_certain)) {
        const int none_leaves_out = far_part.begin.high <= farthest_of(tile->t_possible);
        visit(tile, node.first + !side, far_part, is_certain && must_meet_far && none_leaves_out,
              n_waiting);
    }
}

Work tile_10_most(const JobScene3D *scene, int x, int y, int *must_ask)
{
    OracleTile tile = tile_at(scene, x, y);
    const Part part = clip(&tile, scene->tree.bounds);
    if (part.begin.low <= part.end.high && part.begin.low < INFINITY) {
        visit(&tile, 0, part, part.begin.high <= part.end.low, 0);
    }
    *must_ask = 0;
    for (int i = 0; i < TILE_RAYS; i++) {
        *must_ask |= tile.t_certain[i] < INFINITY;
    }
    return tile.most;
}

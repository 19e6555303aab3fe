// See judge_08_rays.h. Where float would decide otherwise does not matter here: both trees that
// are compared are searched with the same rays in double.
#include "judge_08_rays.h"

#include "camera_from_view.h"
#include "oracle3d.h"

#include <math.h>

// That many rays show what a tree is worth.
enum { WIDTH = 48, HEIGHT = 36 };

typedef struct Search {
    const Scene3D *scene;
    const KdTree3D *tree;
    OracleRay ray;
    double t_hit;
    SearchWork *work;
} Search;

static void ask_leaf(Search *search, KdNode3 leaf)
{
    static const OracleRules3D right = {0};
    for (u32 i = leaf.first; i < leaf.first + leaf.n_spheres; i++) {
        const u32 id = search->tree->sphere_ids[i];
        if (id < (u32)search->scene->n_spheres) {
            const Sphere sphere = search->scene->spheres[id];
            const OracleRoot root = oracle3d_root(sphere, &search->ray, ORACLE_PROJECTION, &right);
            search->t_hit = fmin(search->t_hit, root.t);
        }
    }
    search->work->n_tests += leaf.n_spheres;
}

// Search a node's part of the ray.
static void visit(Search *search, u32 id, double t_min, double t_max)
{
    const KdNode3 node = search->tree->nodes[id];
    if (node.split_axis == KD_LEAF) {
        ask_leaf(search, node);
        return;
    }
    search->work->n_nodes++;
    const double origin = vector_component(search->ray.origin, node.split_axis);
    const double direction = vector_component(search->ray.direction, node.split_axis);
    const double t_split = (node.split_pos - origin) / direction;
    const u32 side = origin == node.split_pos ? direction > 0 : origin > node.split_pos;
    // A ray along the plane stays on its side: t_split is infinite or no number.
    const int is_split = t_split > 0 && t_split <= t_max;
    if (!is_split || t_split >= t_min) {
        visit(search, node.first + side, t_min, is_split ? t_split : t_max);
    }
    if (is_split && search->t_hit >= t_split) {
        visit(search, node.first + !side, fmax(t_min, t_split), t_max);
    }
}

// Narrow [*t_min, *t_max] to the box. Returns 0 when nothing is left.
static int clip(BBox3D box, const OracleRay *ray, double *t_min, double *t_max)
{
    for (u32 axis = 0; axis < 3; axis++) {
        const double origin = vector_component(ray->origin, axis),
                     direction = vector_component(ray->direction, axis);
        const double a = (box.min[axis] - origin) / direction;
        const double b = (box.max[axis] - origin) / direction;
        if (direction != 0) {
            *t_min = fmax(*t_min, fmin(a, b));
            *t_max = fmin(*t_max, fmax(a, b));
        } else if (origin < box.min[axis] || origin > box.max[axis]) {
            return 0;
        }
    }
    return *t_min <= *t_max;
}

SearchWork search_work_08(const Scene3D *scene, const KdTree3D *tree)
{
    static const OracleRules3D right = {0};
    const Camera camera = camera_from_view(scene->view, WIDTH, HEIGHT);
    SearchWork work = {0, 0};
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const OracleRay ray = oracle3d_primary_ray(&camera, x, y, WIDTH, HEIGHT, &right);
            Search search = {scene, tree, ray, INFINITY, &work};
            double t_min = 0, t_max = INFINITY;
            if (clip(tree->bounds, &search.ray, &t_min, &t_max)) {
                visit(&search, 0, t_min, t_max);
            }
        }
    }
    work.n_tests /= WIDTH * HEIGHT;
    work.n_nodes /= WIDTH * HEIGHT;
    return work;
}

// A case of the bench of builds (see case_build.h).
//
// Read next: counted_memory.h, tables.sql.
#include "case_build.h"

#include "counted_memory.h"
#include "handed_on.h"
#include "kdtree2d_build.h"
#include "kdtree3d_build.h"
#include "kdtree3d_sah.h"
#include "options.h"
#include "todo.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

const BuilderRow BUILDERS[N_BUILDERS] = {
    [MIDDLE_2D] = {"lab 02, 3 levels more than log2 N", 1 << 18},
    [MIDDLE_2D_FIXED] = {"lab 02, 8 levels", LARGEST_SCENE},
    [MIDDLE_3D] = {"lab 06, 6 levels more than log2 N", LARGEST_SCENE},
    [MIDDLE_3D_FIXED] = {"lab 06, 7 levels", LARGEST_SCENE},
    [BY_COST_3D] = {"lab 08, by cost", 1 << 18},
};

// Of lab 02, where depth grows: as many levels beyond log2 N as its 16 are for the lecture's scene.
enum { EXTRA_LEVELS_2D = OPTIONS_DEFAULT_MAX_DEPTH - 13 };
_Static_assert(SCENE2D_DEFAULT_CIRCLES == 1 << 13, "log2 of the lecture's 8192 circles is 13");

// Where depth is fixed: few levels, so that even the smallest scene's cells are large against its
// elements, and depth alone ends them. (Lab 02's usual 16 levels are a fixed depth as well, but one
// that only scenes of some 100 000 circles fill.)
static const KdTreeLimits LIMITS_2D_FIXED = {8, 1}, LIMITS_3D_FIXED = {7, 1};

// Those of lab 08's program: the cost knows by itself where to stop.
static const KdTreeLimits LIMITS_BY_COST = {TODO_SIZE + 1, 1};

enum { SIDE = SCENE2D_DEFAULT_SIZE, SEED = 1 };

int build_scene_create(int n_elements, BuildScene *scene)
{
    // The lecture's radii, 2 to 20, belong to its number of circles.
    const float scale = sqrtf((float)SCENE2D_DEFAULT_CIRCLES / (float)n_elements);
    char name[32];
    snprintf(name, sizeof name, "random:n=%d", n_elements);
    if (scene2d_random(n_elements, SEED, 2 * scale, 20 * scale, SIDE, SIDE, &scene->circles) != 0) {
        return -1;
    }
    return scene3d_open(name, 0, 0, &scene->spheres);
}

void build_scene_free(BuildScene *scene)
{
    scene2d_free(&scene->circles);
    scene3d_free(&scene->spheres);
}

// ---- Building -------------------------------------------------------------------------------

// The time that this process has had a processor: a builder is one thread that waits for nothing,
// so that what else the machine does adds little.
static double processor_ms(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec / 1e6;
}

static KdTreeLimits limits_2d(const BuildCase *build_case)
{
    return build_case->builder == MIDDLE_2D_FIXED
               ? LIMITS_2D_FIXED
               : (KdTreeLimits){ilogb(build_case->n_elements) + EXTRA_LEVELS_2D,
                                OPTIONS_DEFAULT_LEAF_SIZE};
}

static int build_3d(const BuildCase *build_case, const Sphere *h_spheres, KdTree3D *tree)
{
    const u32 n = (u32)build_case->n_elements;
    switch (build_case->builder) {
    case BY_COST_3D:
        return kdtree3d_build_sah(h_spheres, n, LIMITS_BY_COST, tree);
    case MIDDLE_3D_FIXED:
        return kdtree3d_build(h_spheres, n, LIMITS_3D_FIXED, tree);
    default:
        return kdtree3d_build(h_spheres, n, tree3d_limits(0, 0, n), tree);
    }
}

static double n_leaves_of(u32 n_nodes)
{
    return (n_nodes + 1.0) / 2;  // every other node has two children
}

static TreeSize size_2d(const KdTree2D *tree, u32 n_circles)
{
    const double n_leaves = n_leaves_of(tree->n_nodes);
    const size_t n_node_bytes =
        sizeof *tree->nodes_Relations + sizeof *tree->nodes_flag + sizeof *tree->nodes_BBox;
    return (TreeSize){.n_leaves = n_leaves,
                      .n_listed = tree->n_map - n_leaves,  // each list begins with its length
                      .n_bytes = (double)tree->n_nodes * n_node_bytes +
                                 (double)tree->n_map * sizeof *tree->mapNode2Circles,
                      .n_handed_on = handed_on_2d(tree, n_circles)};
}

static TreeSize size_3d(const KdTree3D *tree, u32 n_spheres)
{
    return (TreeSize){.n_leaves = n_leaves_of(tree->n_nodes),
                      .n_listed = tree->n_sphere_ids,
                      .n_bytes = (double)tree->n_nodes * sizeof *tree->nodes +
                                 (double)tree->n_sphere_ids * sizeof *tree->sphere_ids,
                      .n_handed_on = handed_on_3d(tree, n_spheres)};
}

static double time_2d(BuildCase *build_case, const Circle *h_circles)
{
    const u32 n = (u32)build_case->n_elements;
    KdTree2D tree = {0};
    memory_count_begin();
    const double start = processor_ms();
    int result = kdtree2d_build(h_circles, n, limits_2d(build_case), &tree);
    const double ms = processor_ms() - start;
    build_case->n_peak_bytes = (double)memory_count_end();
    if (result == 0 && build_case->size.n_leaves == 0) {
        result = tree2d_check(&tree, n);
        if (result == 0) {
            build_case->size = size_2d(&tree, n);
        }
    }
    tree2d_free(&tree);
    return result == 0 && build_case->size.n_handed_on > 0 ? ms : -1;
}

static double time_3d(BuildCase *build_case, const Sphere *h_spheres)
{
    const u32 n = (u32)build_case->n_elements;
    KdTree3D tree = {0};
    memory_count_begin();
    const double start = processor_ms();
    int result = build_3d(build_case, h_spheres, &tree);
    const double ms = processor_ms() - start;
    build_case->n_peak_bytes = (double)memory_count_end();
    if (result == 0 && build_case->size.n_leaves == 0) {
        result = tree3d_check(&tree, n);
        if (result == 0) {
            build_case->size = size_3d(&tree, n);
        }
    }
    tree3d_free(&tree);
    return result == 0 && build_case->size.n_handed_on > 0 ? ms : -1;
}

double case_build_time(BuildCase *build_case, const BuildScene *scene)
{
    return build_case->builder <= MIDDLE_2D_FIXED ? time_2d(build_case, scene->circles.circles)
                                                  : time_3d(build_case, scene->spheres.spheres);
}

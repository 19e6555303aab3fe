// The 3D kd-tree grown on several threads: to the bit the one that is grown on one thread.
#include "scene3d.h"
#include "surroundings.h"

#include <omp.h>
#include <string.h>

// The frame is compiled in here with OpenMP (tests.mk): everywhere but here and in the bench it has
// one thread. Lab 08's builder is in no library.
#include "kdtree3d_sah.c"
#include "tree3d_grow.c"

#include "kdtree3d_build.h"

TestSuite(tree3d_threads);

typedef int Build(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);

static KdTree3D build_on(int n_threads, Build *build, const Scene3D *scene, KdTreeLimits limits)
{
    KdTree3D tree;
    omp_set_num_threads(n_threads);
    cr_assert_eq(build(scene->spheres, (u32)scene->n_spheres, limits, &tree), 0);
    return tree;
}

static void expect_equal(const KdTree3D *found, const KdTree3D *expected, const char *what)
{
    cr_expect_eq(memcmp(&found->bounds, &expected->bounds, sizeof found->bounds), 0, "%s", what);
    cr_assert_eq(found->n_nodes, expected->n_nodes, "%s", what);
    cr_assert_eq(found->n_sphere_ids, expected->n_sphere_ids, "%s", what);
    cr_expect_eq(memcmp(found->nodes, expected->nodes, expected->n_nodes * sizeof *expected->nodes),
                 0, "%s: nodes", what);
    // Without a sphere there is no array.
    cr_expect(expected->n_sphere_ids == 0 ||
                  memcmp(found->sphere_ids, expected->sphere_ids,
                         expected->n_sphere_ids * sizeof *expected->sphere_ids) == 0,
              "%s: ids", what);
}

static void expect_same_on_all(const char *name, const char *builder, Build *build,
                               const Scene3D *scene, KdTreeLimits limits)
{
    static const int N_THREADS[] = {2, 3, 8};
    KdTree3D expected = build_on(1, build, scene, limits);
    for (size_t i = 0; i < sizeof N_THREADS / sizeof *N_THREADS; i++) {
        char what[128];
        snprintf(what, sizeof what, "%s, %s, %d threads", name, builder, N_THREADS[i]);
        KdTree3D found = build_on(N_THREADS[i], build, scene, limits);
        expect_equal(&found, &expected, what);
        tree3d_free(&found);
    }
    tree3d_free(&expected);
}

// "coincident" is all at one place, "uneven" has levels where one node holds nearly everything.
static const char *const NAMES[] = {"none",        "one",      "coincident",    "planes",
                                    "large-small", "one-cell", "lattice:n=4",   "sphereflake",
                                    "clusters",    "stadium",  "random:n=20000"};

Test(tree3d_threads, the_middle_makes_the_same_tree)
{
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        Scene3D scene;
        cr_assert_eq(scene3d_open(NAMES[i], 0, 0, &scene), 0);
        expect_same_on_all(NAMES[i], "middle", kdtree3d_build, &scene,
                           tree3d_limits(0, 0, (u32)scene.n_spheres));
        scene3d_free(&scene);
    }
}

Test(tree3d_threads, cost_makes_the_same_tree)
{
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        Scene3D scene;
        cr_assert_eq(scene3d_open(NAMES[i], 0, 0, &scene), 0);
        expect_same_on_all(NAMES[i], "cost", kdtree3d_build_sah, &scene,
                           (KdTreeLimits){TODO_SIZE + 1, 1});
        scene3d_free(&scene);
    }
}

// ---- Threads ------------------------------------------------------------------------------------

// The middle of x, by a step that notes whether several threads have called it. (That all of them
// come is not promised, so the first waits until a second is there.)
static int threads_seen[2];

static int choose_together(const void *limits, const KdOpenNode *node, KdSplit *split)
{
    (void)limits;
    if (node->level == 2) {
        const int me = omp_get_thread_num();
        __atomic_store_n(&threads_seen[me], 1, __ATOMIC_SEQ_CST);
        while (!__atomic_load_n(&threads_seen[1 - me], __ATOMIC_SEQ_CST)) {
        }
    }
    *split = (KdSplit){0, (node->box.min[0] + node->box.max[0]) / 2};
    return node->level < 3;
}

// Were the frame to keep to one thread, this would wait for ever.
Test(tree3d_threads, two_nodes_of_a_level_are_divided_at_once, .timeout = 600)
{
    const Sphere spheres[] = {{-1, 0, 0, 0.5f}, {1, 0, 0, 0.5f}};
    const KdSteps steps = {"threads",          choose_together, NULL,
                           distribute_spheres, pack_leaf_range, fits_todo};
    KdTree3D tree;
    omp_set_dynamic(0);
    omp_set_num_threads(2);
    cr_assert_eq(tree3d_grow(&steps, spheres, 2, spheres_bounds(spheres, 2), &tree), 0);
    cr_expect_eq(tree.n_nodes, 7);
    tree3d_free(&tree);
}

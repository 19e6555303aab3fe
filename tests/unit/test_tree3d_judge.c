// The judges of 3D trees: lab 06's solution passes them on every scene, and of one call is blamed
// what float cannot give.
#include "kdtree3d_build.h"
#include "random.h"
#include "tree3d_subject.h"

#include <math.h>

TestSuite(tree3d_judge);

// ---- Good trees ---------------------------------------------------------------------------------

Test(tree3d_judge, random_scenes_give_good_trees)
{
    Random random = {1};
    for (int round = 0; round < 100; round++) {
        char name[96];
        const int n_spheres = (int)random_integer(&random, 0, 150);
        const double radius = ldexp(1, -(int)random_integer(&random, 0, 10));
        snprintf(name, sizeof name, "random:n=%d,seed=%d,min=%g,max=%g", n_spheres, round,
                 radius / 4, radius);
        const int max_depth = (int)random_integer(&random, 1, 10);
        TreeScene3D scene =
            scene_of(name, (KdTreeLimits){max_depth, (int)random_integer(&random, 1, 12)});
        expect_no_objection(&scene);
        scene_close(&scene);
    }
}

Test(tree3d_judge, edge_cases_give_good_trees)
{
    for (int i = 0; scene3d_edge_case(i) != NULL; i++) {
        TreeScene3D scene = scene_of(scene3d_edge_case(i), (KdTreeLimits){8, 6});
        expect_no_objection(&scene);
        scene_close(&scene);
    }
    TreeScene3D scene = scene_of("sphereflake:size=2", (KdTreeLimits){10, 3});
    expect_no_objection(&scene);
    scene_close(&scene);
    scene = scene_of("lattice:n=5", (KdTreeLimits){9, 2});
    expect_no_objection(&scene);
    scene_close(&scene);
}

Test(tree3d_judge, exact_is_what_lies_on_a_coarse_grid)
{
    static const struct {
        const char *name;
        int is_exact;
    } scenes[] = {{"planes", 1}, {"one", 1}, {"none", 1}, {"inside", 1}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        TreeScene3D scene = scene_of(scenes[i].name, (KdTreeLimits){7, 3});
        cr_expect_eq(scene.is_exact, scenes[i].is_exact, "%s", scenes[i].name);
        scene_close(&scene);
    }
}

// The expected tree shares no code with lab 06; where rounding decides nothing, both are equal.
static int expect_as_solution(const char *name, KdTreeLimits limits)
{
    TreeScene3D scene = scene_of(name, limits);
    TreeScene3D expected = scene;
    Growth growth = {0};
    cr_assert_eq(tree3d_expect(&expected, 0, &growth), 0);
    growth_free(&growth);
    expect_no_objection(&expected);
    cr_expect_eq(expected.is_exact, scene.is_exact, "%s", name);
    const KdTree3D *own = &scene.tree, *tree = &expected.tree;
    const int is_exact = expected.is_exact;
    if (is_exact) {
        cr_expect_eq(memcmp(&own->bounds, &tree->bounds, sizeof own->bounds), 0, "%s", name);
        cr_assert_eq(own->n_nodes, tree->n_nodes, "%s", name);
        cr_assert_eq(own->n_sphere_ids, tree->n_sphere_ids, "%s", name);
        cr_expect_eq(memcmp(own->nodes, tree->nodes, own->n_nodes * sizeof *own->nodes), 0, "%s",
                     name);
        for (u32 i = 0; i < own->n_sphere_ids; i++) {
            cr_expect_eq(own->sphere_ids[i], tree->sphere_ids[i], "%s: id %u", name, i);
        }
    }
    tree3d_free(&expected.tree);
    scene_close(&scene);
    return is_exact;
}

Test(tree3d_judge, the_expected_tree_is_the_solutions)
{
    int n_exact = 0;
    for (int i = 0; scene3d_edge_case(i) != NULL; i++) {
        n_exact += expect_as_solution(scene3d_edge_case(i), (KdTreeLimits){8, 3});
    }
    cr_expect_geq(n_exact, 4, "found %d", n_exact);
    for (int seed = 0; seed < 20; seed++) {
        char name[64];
        snprintf(name, sizeof name, "random:n=100,seed=%d", seed);
        expect_as_solution(name, (KdTreeLimits){1 + seed % 12, 1 + seed % 5});
    }
}

// ---- One call -----------------------------------------------------------------------------------

Test(tree3d_judge, touching_is_inside_where_double_is_exact)
{
    const BBox3D cell = {{0, 0, 0}, {8, 8, 8}};
    cr_expect_eq(tree3d_judge_sphere((Sphere){-3, 4, 4, 3}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-3, 12, 4, -5}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-2, 11, 14, 7}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-2, 11, 14, 6.875f}, cell), SPHERE_OUTSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){4, 4, 4, 100}, cell), SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){4, 4, 4, 0.125f}, cell), SPHERE_INSIDE);
}

Test(tree3d_judge, either_is_right_where_double_rounds)
{
    const BBox3D cell = {{0, 0, 0}, {8, 8, 8}};
    // The squared distance is 1 + 2^-60.
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, 1}, cell), SPHERE_EITHER);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, nextafterf(1, 2)}, cell),
                 SPHERE_INSIDE);
    cr_expect_eq(tree3d_judge_sphere((Sphere){-1, -0x1p-30f, 4, nextafterf(1, 0)}, cell),
                 SPHERE_OUTSIDE);
}

// Does the sphere overlap the cell as double has it: squares compared, roots, or what is left of
// one square after the others? And as float has it?
static int overlaps_in_double(Sphere s, BBox3D cell, int way)
{
    const double centre[3] = {s.x, s.y, s.z}, radius = fabs((double)s.radius);
    double distance2 = 0, left_over = radius * radius;
    for (int axis = 0; axis < 3; axis++) {
        const double nearest = fmin(fmax(centre[axis], cell.min[axis]), cell.max[axis]);
        distance2 += (centre[axis] - nearest) * (centre[axis] - nearest);
        left_over -= (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return way == 0   ? distance2 <= radius * radius
           : way == 1 ? sqrt(distance2) <= radius
                      : left_over >= 0;
}

static int overlaps_in_float(Sphere s, BBox3D cell)
{
    const float centre[3] = {s.x, s.y, s.z};
    float distance2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        const float nearest = fminf(fmaxf(centre[axis], cell.min[axis]), cell.max[axis]);
        distance2 += (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return distance2 <= s.radius * s.radius;
}

// Spheres that nearly touch: whatever double says must be allowed, and what float says is not.
Test(tree3d_judge, no_answer_of_double_is_blamed_and_float_is)
{
    Random random = {9};
    int n_blamed = 0;
    for (int i = 0; i < 200000; i++) {
        const BBox3D cell = {{0, 0, 0}, {1.0f / 3, 0.7f, 0.9f}};
        float centre[3];
        double distance2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            const float distance = (float)random_integer(&random, 0, 1 << 24) / (1 << 24);
            centre[axis] = i >> axis & 1 ? -distance : cell.max[axis] + distance;
            const double d = i >> axis & 1 ? distance : (double)centre[axis] - cell.max[axis];
            distance2 += d * d;
        }
        Sphere sphere = {centre[0], centre[1], centre[2], (float)sqrt(distance2)};
        for (int step = random_integer(&random, -2, 2); step != 0; step -= step > 0 ? 1 : -1) {
            sphere.radius = nextafterf(sphere.radius, step > 0 ? 9 : 0);
        }
        const SphereInCell is = tree3d_judge_sphere(sphere, cell);
        for (int way = 0; way < 3; way++) {
            cr_assert(is == SPHERE_EITHER ||
                      overlaps_in_double(sphere, cell, way) == (is == SPHERE_INSIDE));
        }
        n_blamed += is != SPHERE_EITHER && overlaps_in_float(sphere, cell) != (is == SPHERE_INSIDE);
    }
    cr_expect_gt(n_blamed, 1000, "float and double agree: nothing was tested");
}

Test(tree3d_judge, axes_and_middles_are_judged_as_float_has_them)
{
    const BBox3D cube = {{1, 1, 1}, {3, 3, 3}}, tall = {{1, 1, 1}, {2, 3, 6}};
    expect_says(tree3d_judge_axis("call", cube, 0), NULL);
    expect_says(tree3d_judge_axis("call", cube, 1), "of equal sides the first");
    expect_says(tree3d_judge_axis("call", tall, 2), NULL);
    expect_says(tree3d_judge_axis("call", tall, 1), "not the longest");
    expect_says(tree3d_judge_axis("call", tall, 0), "the shortest");
    expect_says(tree3d_judge_axis("call", tall, 3), "axes 0, 1 and 2");
    expect_says(tree3d_judge_axis("call", tall, 0xffffffff), "axes 0, 1 and 2");
    // y is longer by less than float sees.
    const BBox3D nearly = {{-1, -1e-9f, 0}, {0, 1, 0}};
    expect_says(tree3d_judge_axis("call", nearly, 0), NULL);
    expect_says(tree3d_judge_axis("call", nearly, 1), NULL);
    expect_says(tree3d_judge_axis("call", nearly, 2), "the shortest");
    expect_says(tree3d_judge_middle("call", tall, 2, 3.5f), NULL);
    expect_says(tree3d_judge_middle("call", tall, 2, 2.5f), "began at 0");
    expect_says(tree3d_judge_middle("call", tall, 2, 3.50001f), "expected 3.5");
    expect_says(tree3d_judge_middle("call", tall, 2, NAN), "expected 3.5");
    const BBox3D rounded = {{0.1f, 0, 0}, {0.8f, 0, 0}};
    expect_says(tree3d_judge_middle("call", rounded, 0, (0.1f + 0.8f) / 2), NULL);
    expect_says(tree3d_judge_middle("call", rounded, 0, 0.1f + (0.8f - 0.1f) / 2), NULL);
}

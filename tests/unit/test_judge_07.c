// judge/judge_07_work and the scenes of lab 07: a search through the tree finds what brute force
// finds, and the most that a right search may do is hardly more than what one does.
#include "judge_07.h"
#include "judge_07_work.h"

#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

TestSuite(judge_07);

static JobScene3D *scenes_open(uint64_t seed)
{
    Random random = {seed};
    JobScene3D *scenes = calloc(N_SCENES, sizeof *scenes);
    cr_assert_not_null(scenes);
    cr_assert_eq(roll_scenes_07(&random, scenes), 0);
    return scenes;
}

static void scenes_close(JobScene3D *scenes)
{
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&scenes[k]);
    }
    free(scenes);
}

static int n_pixels(const JobScene3D *scene)
{
    return scene->scene.width * scene->scene.height;
}

static double along(OracleVector v, u32 axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// A search in double, and what it costs.
typedef struct Search {
    const JobScene3D *scene;
    OracleRay ray;
    int ends_early;
    double t;
    u32 sphere;
    Work work;
} Search;

static void search_leaf(Search *search, KdNode3 leaf)
{
    static const OracleRules3D right = {0};
    search->work.n_leaves_visited++;
    search->work.n_tests += leaf.n_spheres;
    for (u32 i = leaf.first; i < leaf.first + leaf.n_spheres; i++) {
        const u32 id = search->scene->tree.sphere_ids[i];
        const Sphere sphere = search->scene->scene.spheres[id];
        const double t = oracle3d_root(sphere, &search->ray, ORACLE_PROJECTION, &right).t;
        if (t < search->t) {
            search->t = t;
            search->sphere = id;
        }
    }
}

// Search a node's part of the ray. Returns 1 when the search is over.
static int search_node(Search *search, u32 id, double t_min, double t_max, u32 n_waiting)
{
    const KdNode3 node = search->scene->tree.nodes[id];
    if (node.split_axis == KD_LEAF) {
        search_leaf(search, node);
        return search->ends_early && search->t <= t_max;
    }
    const double origin = along(search->ray.origin, node.split_axis);
    const double direction = along(search->ray.direction, node.split_axis);
    const double t_split = (node.split_pos - origin) / direction;
    const u32 side = origin < node.split_pos ? 0 : origin > node.split_pos ? 1 : direction > 0;
    const u32 near = node.first + side, far = node.first + !side;
    Work *work = &search->work;
    work->n_nodes_visited++;
    if (!(t_split > 0 && t_split <= t_max)) {
        return search_node(search, near, t_min, t_max, n_waiting);
    }
    if (t_split < t_min) {
        return search_node(search, far, t_min, t_max, n_waiting);
    }
    work->stack_depth = n_waiting >= work->stack_depth ? n_waiting + 1 : work->stack_depth;
    return search_node(search, near, t_min, t_split, n_waiting + 1) ||
           search_node(search, far, t_split, t_max, n_waiting);
}

// Search the scene for what a pixel's ray hits, from the eye to the end of the scene's box.
static Search search_scene(const JobScene3D *scene, int pixel, int ends_early)
{
    Search search = {scene, job_scene3d_ray(scene, pixel), ends_early, INFINITY, ORACLE_NO_SPHERE,
                     {0}};
    double t_min = 0, t_max = INFINITY;
    for (u32 axis = 0; axis < 3; axis++) {
        const double origin = along(search.ray.origin, axis);
        const double direction = along(search.ray.direction, axis);
        const double low = (scene->tree.bounds.min[axis] - origin) / direction;
        const double high = (scene->tree.bounds.max[axis] - origin) / direction;
        if (direction != 0) {
            t_min = fmax(t_min, fmin(low, high));
            t_max = fmin(t_max, fmax(low, high));
        } else if (origin < scene->tree.bounds.min[axis] || origin > scene->tree.bounds.max[axis]) {
            return search;
        }
    }
    if (t_min <= t_max) {
        search_node(&search, 0, t_min, t_max, 0);
    }
    return search;
}

// How many rays that are not ambiguous does a search through the tree answer otherwise?
static int count_wrong(const JobScene3D *scene)
{
    int n_wrong = 0;
    for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
        const OracleHit *hit = &scene->hits[pixel];
        n_wrong += !hit->is_ambiguous && search_scene(scene, pixel, 1).sphere != hit->sphere;
    }
    return n_wrong;
}

Test(judge_07, a_search_finds_what_brute_force_finds)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        JobScene3D *scenes = scenes_open(seed);
        for (int k = 0; k < N_SCENES; k++) {
            cr_expect_eq(count_wrong(&scenes[k]), 0, "seed %d: %s", (int)seed,
                         scenes[k].picture.title);
        }
        scenes_close(scenes);
    }
}

Test(judge_07, few_rays_are_ambiguous)
{
    JobScene3D *scenes = scenes_open(4);
    int n_ambiguous = 0, n_hits = 0, n_rays = 0;
    // Many are where leaves list decoys: see the last test.
    for (int k = 0; k < DECOYS; k++) {
        for (int pixel = 0; pixel < n_pixels(&scenes[k]); pixel++) {
            n_ambiguous += scenes[k].hits[pixel].is_ambiguous;
            n_hits += scenes[k].hits[pixel].sphere != ORACLE_NO_SPHERE;
            n_rays++;
        }
    }
    cr_expect_lt(n_ambiguous, n_rays / 100);
    cr_expect_gt(n_hits, n_rays / 4);
    scenes_close(scenes);
}

static int is_more(Work a, Work b)
{
    return a.n_tests > b.n_tests || a.n_nodes_visited > b.n_nodes_visited ||
           a.n_leaves_visited > b.n_leaves_visited;
}

Test(judge_07, a_right_search_does_the_least_work_and_the_most_or_almost)
{
    JobScene3D *scenes = scenes_open(6);
    int n_rays = 0, n_equal = 0, n_least = 0;
    for (int k = 0; k < N_SCENES; k++) {
        for (int pixel = 0; pixel < n_pixels(&scenes[k]); pixel++) {
            const OracleRay ray = job_scene3d_ray(&scenes[k], pixel);
            const Work work = search_scene(&scenes[k], pixel, 1).work;
            const WorkBounds bounds = search3d_bounds(&scenes[k], &ray);
            const Work most = bounds.most;
            cr_assert_not(is_more(work, most), "%s: pixel %d", scenes[k].picture.title, pixel);
            cr_assert_leq(work.stack_depth, most.stack_depth, "%s: pixel %d",
                          scenes[k].picture.title, pixel);
            cr_assert_not(is_more(bounds.least, work), "%s: pixel %d", scenes[k].picture.title,
                          pixel);
            n_least += bounds.least.n_tests == work.n_tests;
            n_equal += !is_more(most, work);
            n_rays++;
        }
    }
    // All but the rays that meet a plane or an edge of a cell almost where something else is.
    cr_expect_gt(n_equal, n_rays * 9 / 10, "%d of %d", n_equal, n_rays);
    cr_expect_gt(n_least, n_rays * 9 / 10, "%d of %d", n_least, n_rays);
    scenes_close(scenes);
}

Test(judge_07, a_search_that_never_ends_early_does_more_than_the_most)
{
    JobScene3D *scenes = scenes_open(7);
    int n_more = 0;
    for (int pixel = 0; pixel < n_pixels(&scenes[FLAKE]); pixel++) {
        const OracleRay ray = job_scene3d_ray(&scenes[FLAKE], pixel);
        n_more += is_more(search_scene(&scenes[FLAKE], pixel, 0).work,
                          search3d_bounds(&scenes[FLAKE], &ray).most);
    }
    cr_expect_gt(n_more, 100, "%d", n_more);
    scenes_close(scenes);
}

Test(judge_07, the_deep_scene_needs_nearly_all_places)
{
    JobScene3D *scenes = scenes_open(8);
    u32 deepest = 0;
    for (int pixel = 0; pixel < n_pixels(&scenes[DEEP]); pixel++) {
        const Work work = search_scene(&scenes[DEEP], pixel, 1).work;
        deepest = work.stack_depth > deepest ? work.stack_depth : deepest;
    }
    cr_expect_geq(deepest, TODO_SIZE - 2, "%u", deepest);
    scenes_close(scenes);
}

// How many hits of the scene "tip" does float find before their leaf's part of the ray begins?
static int count_before_leaf(const JobScene3D *scene)
{
    const Sphere sphere = scene->scene.spheres[0];
    int n_before = 0;
    for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
        const OracleRay ray = job_scene3d_ray(scene, pixel);
        const Vec3 origin = {(float)ray.origin.x, (float)ray.origin.y, (float)ray.origin.z};
        const Vec3 direction = {(float)ray.direction.x, (float)ray.direction.y,
                                (float)ray.direction.z};
        const Vec3 c = vec3_minus((Vec3){sphere.x, sphere.y, sphere.z}, origin);
        const float b = vec3_dot(c, direction);
        const Vec3 l = vec3_minus(c, vec3_scaled(direction, b));
        const float t = b - sqrtf(sphere.radius * sphere.radius - vec3_dot(l, l));
        const float t_split = (scene->tree.nodes[0].split_pos - origin.y) * (1 / direction.y);
        n_before += !scene->hits[pixel].is_ambiguous && t < t_split;
    }
    return n_before;
}

Test(judge_07, at_the_tip_rounding_puts_hits_before_their_leaf)
{
    for (uint64_t seed = 11; seed <= 13; seed++) {
        JobScene3D *scenes = scenes_open(seed);
        const KdTree3D *tree = &scenes[TIP].tree;
        cr_expect_eq(tree->nodes[0].split_axis, 1, "y");
        cr_expect_eq(tree->nodes[1].n_spheres, 1, "the near leaf lists sphere 1 only");
        cr_expect_eq(tree->sphere_ids[tree->nodes[1].first], 1);
        cr_expect_gt(count_before_leaf(&scenes[TIP]), 5);
        scenes_close(scenes);
    }
}

// How many rays that count find the decoy, of a search that ends early or never does.
static int count_decoys(const JobScene3D *scene, int ends_early)
{
    int n = 0;
    for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
        n += !scene->hits[pixel].is_ambiguous &&
             search_scene(scene, pixel, ends_early).sphere == (u32)scene->scene.n_spheres;
    }
    return n;
}

Test(judge_07, who_goes_on_behind_the_hit_meets_decoys_with_every_seed)
{
    for (uint64_t seed = 1; seed <= 20; seed++) {
        Random random = {seed};
        JobScene3D scene;
        cr_assert_eq(roll_decoys_07(&random, &scene), 0);
        cr_assert_eq(job_scene3d_expect(&scene), 0);
        decoys_07_expect(&scene);
        cr_expect_eq(count_decoys(&scene, 1), 0, "seed %d", (int)seed);
        cr_expect_gt(count_decoys(&scene, 0), 20, "seed %d: %d", (int)seed,
                     count_decoys(&scene, 0));
        job_scene3d_free(&scene);
    }
}

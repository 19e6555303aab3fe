// judge/judge_07_search: a search through the tree finds what brute force finds, one with a
// mistake does not, and the most that a right search may do is hardly more than what one does.
#include "judge_07.h"
#include "judge_07_search.h"

#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

TestSuite(judge_07);

static JobScene3D *scenes_open(uint64_t seed)
{
    Random random = {seed};
    JobScene3D *scenes = calloc(N_SCENES, sizeof *scenes);
    cr_assert_not_null(scenes);
    cr_assert_eq(scenes_07_draw(&random, scenes), 0);
    return scenes;
}

static void scenes_close(JobScene3D *scenes)
{
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&scenes[k]);
    }
    free(scenes);
}

static OracleRay ray_of(const JobScene3D *scene, int pixel)
{
    const OracleRules3D right = {0};
    const Scene3D *s = &scene->scene;
    return oracle3d_primary_ray(&scene->camera, pixel % s->width, pixel / s->width, s->width,
                                s->height, &right);
}

static int n_pixels(const JobScene3D *scene)
{
    return scene->scene.width * scene->scene.height;
}

// How many rays that are not ambiguous does a search with these rules answer wrongly?
static int count_wrong(const JobScene3D *scene, SearchRules rules)
{
    int n_wrong = 0;
    for (int pixel = 0; pixel < n_pixels(scene); pixel++) {
        const OracleRay ray = ray_of(scene, pixel);
        const SearchResult found = search3d(scene, &ray, &rules);
        const OracleHit *hit = &scene->hits[pixel];
        n_wrong += !hit->is_ambiguous && found.sphere != hit->sphere;
    }
    return n_wrong;
}

Test(judge_07, a_search_finds_what_brute_force_finds)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        JobScene3D *scenes = scenes_open(seed);
        for (int k = 0; k < N_SCENES; k++) {
            cr_expect_eq(count_wrong(&scenes[k], (SearchRules){0}), 0, "seed %d: %s", (int)seed,
                         scenes[k].picture.title);
        }
        scenes_close(scenes);
    }
}

Test(judge_07, few_rays_are_ambiguous)
{
    JobScene3D *scenes = scenes_open(4);
    int n_ambiguous = 0, n_hits = 0, n_rays = 0;
    for (int k = 0; k < N_SCENES; k++) {
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

Test(judge_07, each_mistake_shows)
{
    static const SearchRules mistakes[] = {
        {.far_first = 1},   {.side_by_direction = 1}, {.behind_is_crossed = 1},
        {.far_dropped = 1}, {.far_alone_is_near = 1}, {.near_keeps_t_max = 1},
        {.part_kept = 1},   {.oldest_first = 1},      {.ends_at_any_hit = 1},
    };
    JobScene3D *scenes = scenes_open(5);
    for (size_t m = 0; m < sizeof mistakes / sizeof *mistakes; m++) {
        int n_wrong = 0;
        for (int k = RANDOM; k < RANDOM + N_RANDOM; k++) {
            n_wrong += count_wrong(&scenes[k], mistakes[m]);
        }
        cr_expect_gt(n_wrong, 0, "mistake %zu", m);
    }
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
            const OracleRay ray = ray_of(&scenes[k], pixel);
            const Work work = search3d(&scenes[k], &ray, &(SearchRules){0}).work;
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

Test(judge_07, wasted_work_is_more_than_the_most)
{
    static const SearchRules wasteful[] = {{.never_ends = 1},
                                           {.far_keeps_t_min = 1},
                                           {.far_always_waits = 1},
                                           {.near_never_skipped = 1}};
    JobScene3D *scenes = scenes_open(7);
    for (size_t m = 0; m < sizeof wasteful / sizeof *wasteful; m++) {
        int n_more = 0;
        for (int pixel = 0; pixel < n_pixels(&scenes[FLAKE]); pixel++) {
            const OracleRay ray = ray_of(&scenes[FLAKE], pixel);
            n_more += is_more(search3d(&scenes[FLAKE], &ray, &wasteful[m]).work,
                              search3d_bounds(&scenes[FLAKE], &ray).most);
        }
        cr_expect_gt(n_more, 100, "%zu: %d", m, n_more);
    }
    scenes_close(scenes);
}

Test(judge_07, the_deep_scene_needs_nearly_all_places)
{
    JobScene3D *scenes = scenes_open(8);
    u32 deepest = 0;
    for (int pixel = 0; pixel < n_pixels(&scenes[DEEP]); pixel++) {
        const OracleRay ray = ray_of(&scenes[DEEP], pixel);
        const Work work = search3d(&scenes[DEEP], &ray, &(SearchRules){0}).work;
        deepest = work.stack_depth > deepest ? work.stack_depth : deepest;
    }
    cr_expect_geq(deepest, TODO_SIZE - 2, "%u", deepest);
    scenes_close(scenes);
}

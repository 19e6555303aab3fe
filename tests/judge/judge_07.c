// Judge of lab 07: each function on chosen inputs, what rays hit in whole scenes, the pictures, and
// the counted work. The functions' inputs are drawn in judge_07_inputs.c and judged in
// judge_07_clip.c, judge_07_functions.c and judge_07_leaf.c.
//
// Hits are those of brute force, whatever the tree: only rays that the oracle calls ambiguous may
// differ. Wrong ones are compared with searches that make known mistakes (judge_07_search.h). Work
// is judged ray by ray by the least and the most that a right search may do. How answers are tried
// alone is in judge_07_alone.c.
#include "judge_07.h"

#include "job_sections.h"
#include "judge_07_search.h"
#include "message.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const Check checks[] = {
    [CLIP_CHECK_THROUGH] = {"clip-through", "Rays that go through the box, or past it",
                            "clip_to_box", 7},
    [CLIP_CHECK_INSIDE] = {"clip-inside", "From inside, and parts of rays", "clip_to_box", 5},
    [CLIP_CHECK_BEHIND] = {"clip-behind", "Boxes behind the eye and outside the part",
                           "clip_to_box", 4},
    [CLIP_CHECK_PARALLEL] = {"clip-parallel", "Along the planes, and where a point is left",
                             "clip_to_box", 4},
    [SIDE_EYE] = {"side-eye", "The eye's side, wherever the ray goes", "near_side", 9},
    [SIDE_ON_PLANE] = {"side-on-plane", "An eye on the plane", "near_side", 6},
    [CHILDREN_CASES] = {"children-cases", "Crossed before, inside, and beyond", "children_on_ray",
                        10},
    [CHILDREN_BEHIND] = {"children-behind", "Planes behind the eye, or at it", "children_on_ray",
                         5},
    [CHILDREN_PARALLEL] = {"children-parallel", "Rays along the plane", "children_on_ray", 5},
    [LEAF_NEAREST] = {"leaf-nearest", "The nearest hit so far, or nearer", "search_leaf", 6},
    [LEAF_IDS] = {"leaf-ids", "Whose hit it is, also of two equally far ones", "search_leaf", 5},
    [LEAF_ONCE] = {"leaf-once", "Each sphere of the leaf is asked once", "search_leaf", 4},
    [TRACE_RANDOM] = {"trace-random", "No pinholes in random scenes", "trace", 10, "*"},
    [TRACE_EDGES] = {"trace-edges", "Nor in the edge cases", "trace", 8, "*"},
    [TRACE_EARLY_END] = {"trace-early-end", "It visits what the ray meets, and ends early", "trace",
                         7, "*"},
    [TRACE_PICTURE] = {"trace-picture", "Whole pictures", "trace", 5, "*"},
};

// ---- Drawing the job --------------------------------------------------------------------------

static void job_free(void *pointer)
{
    Job07 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&job->scenes[k]);
    }
    for (int k = 0; k < N_SCRIPTED; k++) {
        job_scene3d_free(&job->scripted[k]);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job07 *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    inputs_07_draw(&random, &job->inputs);
    int result = inputs_07_write(&job->inputs, file) | scenes_07_draw(&random, job->scenes);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        job->pictures[k] = &job->scenes[k].picture;
        result = job_scene3d_write(&job->scenes[k], k, file);
    }
    if (result != 0 || scripted_07_draw(&random, job->scripted) != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

// ---- Known mistakes ---------------------------------------------------------------------------

// A mistake of the search.
typedef struct SearchMistake {
    const char *looks;
    SearchRules rules;
} SearchMistake;

static const SearchMistake hit_mistakes[] = {
    {"as if near and far child were swapped", {.far_first = 1}},
    {"as if the direction chose the near child, wherever the eye is", {.side_by_direction = 1}},
    {"as if a plane behind the eye led to the far child", {.behind_is_crossed = 1}},
    {"as if the far child were never visited where both are met: it does not wait, or the search "
     "ends at the first leaf",
     {.far_dropped = 1}},
    {"as if the search went to the near child where only the far one is met",
     {.far_alone_is_near = 1}},
    {"as if t_max did not become t_split for the near child: the search ends too soon",
     {.near_keeps_t_max = 1}},
    {"as if t_min and t_max were not taken from the stack with the node", {.part_kept = 1}},
    {"as if t_max were not taken from the stack with the node", {.t_max_kept = 1}},
    {"as if the node that waits longest came from the stack first", {.oldest_first = 1}},
    {"as if the search ended at any hit, also at one beyond t_max, which another sphere may hide",
     {.ends_at_any_hit = 1}},
};

static const SearchMistake work_mistakes[] = {
    {"as if the search went on where it had found a hit, and ended where it had not: the "
     "comparison "
     "with t_max is inverted",
     {.end_inverted = 1}},
    {"as if the search did not end before the stack is empty", {.never_ends = 1}},
    {"as if t_min did not become t_split for the far child, which begins at t_split: is that put "
     "on the stack, and taken from it?",
     {.far_keeps_t_min = 1}},
    {"as if the far child waited also where only the near one is met", {.far_always_waits = 1}},
    {"as if the near child were visited also where only the far one is met",
     {.near_never_skipped = 1}},
    {"as if t_max did not become t_split for the near child", {.near_keeps_t_max = 1}},
    {"as if t_min and t_max were not taken from the stack with the node", {.part_kept = 1}},
    {"as if t_max were not taken from the stack with the node", {.t_max_kept = 1}},
    {"as if near and far child were swapped", {.far_first = 1}},
    {"as if the node that waits longest came from the stack first", {.oldest_first = 1}},
};

// Of the mistakes of hits those that leave work out.
static const SearchMistake early_mistakes[] = {
    {"as if the far child were never visited where both are met: it does not wait, or the search "
     "ends at the first leaf",
     {.far_dropped = 1}},
    {"as if the search ended at any hit, also at one beyond t_max, which another sphere may hide",
     {.ends_at_any_hit = 1}},
};

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static OracleRay ray_of(const JobScene3D *scene, int pixel)
{
    static const OracleRules3D right = {0};
    const Scene3D *s = &scene->scene;
    return oracle3d_primary_ray(&scene->camera, pixel % s->width, pixel / s->width, s->width,
                                s->height, &right);
}

// Does a mistaken search of this ray give what was found?
typedef int Agrees(const SearchResult *mistaken, const void *answers, int pixel);

// Wrong answers about a scene.
typedef struct WrongScene {
    const JobScene3D *scene;
    const void *answers;  // of each pixel
    int n_wrong;
} WrongScene;

// For how many rays of a scene does a mistaken search not give what was found? Gives up at `limit`.
static int count_differing(const WrongScene *wrong, const SearchRules *rules, Agrees *agrees,
                           int limit)
{
    const JobScene3D *scene = wrong->scene;
    int n_differ = 0;
    for (int pixel = 0; n_differ < limit && pixel < scene->scene.width * scene->scene.height;
         pixel++) {
        const OracleRay ray = ray_of(scene, pixel);
        const SearchResult mistaken = search3d(scene, &ray, rules);
        n_differ += !scene->hits[pixel].is_ambiguous && !agrees(&mistaken, wrong->answers, pixel);
    }
    return n_differ;
}

// The mistake that explains wrong answers best, or NULL. A mistaken search is not as good-natured
// as a right one: where a plane is met almost at a hit, float may decide otherwise than double. So
// of the rays that are wrong one in SEARCH_EXCEPTIONS may differ.
enum { SEARCH_EXCEPTIONS = 8 };
static const char *explain(const WrongScene *wrong, int n_scenes, const SearchMistake *mistakes,
                           int n_mistakes, Agrees *agrees)
{
    int n_wrong = 0;
    for (int i = 0; i < n_scenes; i++) {
        n_wrong += wrong[i].n_wrong;
    }
    if (n_wrong == 0) {
        return NULL;  // only distances are a little off
    }
    const char *looks = NULL;
    int fewest = n_wrong / SEARCH_EXCEPTIONS + 1;
    for (int m = 0; m < n_mistakes; m++) {
        int n_differ = 0;
        for (int i = 0; n_differ < fewest && i < n_scenes; i++) {
            n_differ += count_differing(&wrong[i], &mistakes[m].rules, agrees, fewest - n_differ);
        }
        if (n_differ < fewest) {
            fewest = n_differ;
            looks = mistakes[m].looks;
        }
    }
    return looks;
}

// ---- Hits -------------------------------------------------------------------------------------

// A sphere's two roots are farther apart than this, in units of the distance, and float is nearer
// to double.
#define SAME_HIT 1e-3

static int hit_agrees(const SearchResult *mistaken, const void *answers, int pixel)
{
    const HitAnswer found = ((const HitAnswer *)answers)[pixel];
    return found.sphere == mistaken->sphere &&
           (found.sphere == ORACLE_NO_SPHERE ||
            fabs(found.t - mistaken->t) <= SAME_HIT * fabs(mistaken->t));
}

// How many rays of a scene hit something else than a right search would.
static int count_wrong(const JobScene3D *scene, const HitAnswer *found)
{
    static const SearchRules right = {0};
    const WrongScene all = {scene, found, 0};
    return count_differing(&all, &right, hit_agrees, INT_MAX);
}

// What wrong hits of scenes first to first + n - 1 look like, or NULL. More scenes than the first
// that is wrong tell mistakes apart that look the same in that one.
static const char *explain_hits(const Job07 *job, int first, int n, const Sections *answers)
{
    WrongScene wrong[N_SCENES];
    int n_scenes = 0;
    for (int k = first; k < first + n; k++) {
        const JobScene3D *scene = &job->scenes[k];
        const size_t n_pixels = (size_t)scene->scene.width * (size_t)scene->scene.height;
        const HitAnswer *found = job_section_find(answers, "hits", k, n_pixels * sizeof *found);
        const int n_wrong = found ? count_wrong(scene, found) : 0;
        if (n_wrong > 0) {
            wrong[n_scenes++] = (WrongScene){scene, found, n_wrong};
        }
    }
    return explain(wrong, n_scenes, hit_mistakes, COUNT(hit_mistakes), hit_agrees);
}

static Verdict judge_hits(const Job07 *job, int first, int n, const Sections *answers)
{
    const Verdict verdict = job_scenes3d_judge_hits(job->scenes, first, n, answers);
    // That a miss was taken for a hit is known already.
    if (verdict.kind != VERDICT_FAILED || strstr(verdict.message, "it looks") != NULL) {
        return verdict;
    }
    const char *looks = explain_hits(job, first, n, answers);
    if (looks == NULL) {
        return verdict;
    }
    const Verdict explained = verdict_of(message_new("%s; it looks %s", verdict.message, looks));
    free(verdict.message);
    return explained;
}

// Of two spheres at the same distance the one with the lower id, though its leaf comes later: what
// the oracle calls ambiguous here is not, as float finds the same distance for both.
static Verdict judge_tie(const Job07 *job, const Sections *answers)
{
    const HitAnswer *found = job_section_find(answers, "hits", TIE, sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    if (found->sphere == 0) {
        return verdict_of(NULL);
    }
    return verdict_of(message_new("%s: the ray hits spheres 0 and 1 at t = 1000, exactly where the "
                                  "near leaf ends, which lists sphere 1 only: found sphere %u at "
                                  "t = %.9g, expected sphere 0: of two at the same distance the "
                                  "lower id",
                                  job->scenes[TIE].picture.title, found->sphere, (double)found->t));
}

static Verdict judge_edges(const Job07 *job, const Sections *answers)
{
    const Verdict verdict = judge_hits(job, EDGES, N_SCENES - EDGES, answers);  // and sphereflake
    return verdict.kind == VERDICT_PASSED ? judge_tie(job, answers) : verdict;
}

// ---- Work -------------------------------------------------------------------------------------

static int is_within(Work work, Work most)
{
    return work.n_tests <= most.n_tests && work.n_nodes_visited <= most.n_nodes_visited &&
           work.n_leaves_visited <= most.n_leaves_visited;
}

static int work_agrees(const SearchResult *mistaken, const void *answers, int pixel)
{
    const Work found = ((const Work *)answers)[pixel];
    return found.n_leaves_visited == mistaken->work.n_leaves_visited &&
           found.n_nodes_visited == mistaken->work.n_nodes_visited &&
           found.n_tests == mistaken->work.n_tests;
}

enum { WORK_BYTES = 96 };  // of work in words

// "3 nodes and 1 leaf visited and 17 spheres asked".
static void describe_work(Work work, char *words, size_t n_bytes)
{
    const u32 n_nodes = work.n_nodes_visited, n_leaves = work.n_leaves_visited;
    snprintf(words, n_bytes, "%u node%s and %u %s visited and %u sphere%s asked", n_nodes,
             plural(n_nodes), n_leaves, n_leaves == 1 ? "leaf" : "leaves", work.n_tests,
             plural(work.n_tests));
}

// The message about rays that do less than they must.
static char *describe_less(const WrongScene *wrong, int pixel, Work least)
{
    const JobScene3D *scene = wrong->scene;
    char words[WORK_BYTES];
    describe_work(((const Work *)wrong->answers)[pixel], words, sizeof words);
    const char *looks = explain(wrong, 1, early_mistakes, COUNT(early_mistakes), work_agrees);
    return message_new(
        "%s: the ray of pixel (%d, %d): found %s, "
        "expected at least %u, %u and %u (%d of %d rays do less than they must); %s%s",
        scene->picture.title, pixel % scene->scene.width, pixel / scene->scene.width, words,
        least.n_nodes_visited, least.n_leaves_visited, least.n_tests, wrong->n_wrong,
        scene->scene.width * scene->scene.height, looks ? "it looks " : "",
        looks ? looks
              : "the search ends too soon or skips something, or some of its work is hidden "
                "and cannot be counted: only children_on_ray, search_leaf and intersect_sphere "
                "count it");
}

// The message when more nodes wait than need to, or NULL. One place more is granted to who puts the
// near child on the stack too, and takes it off at once.
static char *judge_stack(const JobScene3D *scene, int pixel, u32 found, u32 most)
{
    if (found <= most + 1 && found <= TODO_SIZE) {
        return NULL;
    }
    return message_new(
        "%s: the ray of pixel (%d, %d): found %u node%s waiting on the stack at once, "
        "expected at most %u; only the far child waits, and only where both are met",
        scene->picture.title, pixel % scene->scene.width, pixel / scene->scene.width, found,
        plural(found), most);
}

// Rays of a scene that do more, or less, than they may.
typedef struct OffRays {
    int n;
    int first;   // a pixel
    Work bound;  // of the first
} OffRays;

static void count_off(OffRays *off, int pixel, Work bound)
{
    if (off->n++ == 0) {
        off->first = pixel;
        off->bound = bound;
    }
}

// The message about rays that do more than they may.
static char *describe_more(const WrongScene *wrong, const OffRays *more, u64 n_tests, u64 n_most)
{
    const JobScene3D *scene = wrong->scene;
    const int width = scene->scene.width;
    char words[WORK_BYTES];
    describe_work(((const Work *)wrong->answers)[more->first], words, sizeof words);
    const char *looks = explain(wrong, 1, work_mistakes, COUNT(work_mistakes), work_agrees);
    return message_new(
        "%s: the ray of pixel (%d, %d): found %s, "
        "expected at most %u, %u and %u (%d of %d rays do more than they must, and %llu spheres "
        "are asked instead of %llu)%s%s",
        scene->picture.title, more->first % width, more->first / width, words,
        more->bound.n_nodes_visited, more->bound.n_leaves_visited, more->bound.n_tests, more->n,
        width * scene->scene.height, (unsigned long long)n_tests, (unsigned long long)n_most,
        looks ? "; it looks " : "", looks ? looks : "");
}

// The message when a scene's rays do too much, or too little, or NULL: too much comes first.
static char *judge_scene_work(const JobScene3D *scene, const Work *found)
{
    const Scene3D *s = &scene->scene;
    u64 n_tests = 0, n_most = 0;
    OffRays more = {0}, less = {0};
    char *stack = NULL;
    for (int pixel = 0; pixel < s->width * s->height; pixel++) {
        const OracleRay ray = ray_of(scene, pixel);
        const WorkBounds bounds = search3d_bounds(scene, &ray);
        const Work own = found[pixel];
        n_tests += own.n_tests;
        n_most += bounds.most.n_tests;
        if (!is_within(own, bounds.most)) {
            count_off(&more, pixel, bounds.most);
        }
        if (!is_within(bounds.least, own)) {
            count_off(&less, pixel, bounds.least);
        }
        if (stack == NULL) {
            stack = judge_stack(scene, pixel, own.stack_depth, bounds.most.stack_depth);
        }
    }
    if (more.n == 0 && less.n == 0) {
        return stack;
    }
    free(stack);
    const WrongScene wrong = {scene, found, more.n > 0 ? more.n : less.n};
    return more.n > 0 ? describe_more(&wrong, &more, n_tests, n_most)
                      : describe_less(&wrong, less.first, less.bound);
}

// The scenes whose work is judged: few levels and many, spheres on all sides of the eye, a tree
// that is as deep as it may be.
static const int work_scenes[] = {RANDOM + 2, RANDOM + 6, RANDOM + 7, RANDOM + N_RANDOM - 1,
                                  DEEP,       FLAKE};

static Verdict judge_work(const Job07 *job, const Sections *answers)
{
    for (int i = 0; i < COUNT(work_scenes); i++) {
        const int k = work_scenes[i];
        const JobScene3D *scene = &job->scenes[k];
        const size_t n_bytes = (size_t)PROBE_IMAGE_SIDE(scene->scene.width) *
                               (size_t)PROBE_IMAGE_SIDE(scene->scene.height) * sizeof(Work);
        const Work *found = job_section_find(answers, "work", k, n_bytes);
        if (found == NULL) {
            if (job_picture_answer(&scene->picture, k, answers).pixels == NULL) {
                return verdict_missing;
            }
            return verdict_of(message_new("the work could not be counted; call children_on_ray and "
                                          "search_leaf in trace itself"));
        }
        char *message = judge_scene_work(scene, found);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

// ---- All --------------------------------------------------------------------------------------

Verdict judge_07_check(const void *pointer, int check, const Sections *answers)
{
    const Job07 *job = pointer;
    const Inputs07 *inputs = &job->inputs;
    switch (check) {
    case CLIP_CHECK_THROUGH:
        return inputs_07_judge_clips(inputs, CLIP_FROM_OUTSIDE, answers);
    case CLIP_CHECK_INSIDE:
        return inputs_07_judge_clips(inputs, CLIP_PART, answers);
    case CLIP_CHECK_BEHIND:
        return inputs_07_judge_clips(inputs, CLIP_BESIDE, answers);
    case CLIP_CHECK_PARALLEL:
        return inputs_07_judge_clips(inputs, CLIP_ALONG, answers);
    case SIDE_EYE:
        return inputs_07_judge_sides(inputs, 0, answers);
    case SIDE_ON_PLANE:
        return inputs_07_judge_sides(inputs, 1, answers);
    case CHILDREN_CASES:
        return inputs_07_judge_planes(inputs, 0, answers);
    case CHILDREN_BEHIND:
        return inputs_07_judge_planes(inputs, 1, answers);
    case CHILDREN_PARALLEL:
        return inputs_07_judge_planes(inputs, 2, answers);
    case LEAF_NEAREST:
        return inputs_07_judge_leaves(inputs, 0, answers);
    case LEAF_IDS:
        return inputs_07_judge_leaves(inputs, 1, answers);
    case LEAF_ONCE:
        return inputs_07_judge_leaf_tests(inputs, answers);
    case TRACE_RANDOM:
        return judge_hits(job, RANDOM, N_RANDOM, answers);
    case TRACE_EDGES:
        return judge_edges(job, answers);
    case TRACE_EARLY_END:
        return judge_work(job, answers);
    default:
        return job_pictures_judge(job->pictures, 0, N_SCENES, answers);
    }
}

// The oracle's pictures stay the reference: a right solution may be as far from them as ours is, on
// the other side.
static void adopt(void *job, const Sections *answers)
{
    (void)job, (void)answers;
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job07 *job = pointer;
    job_pictures_report(job->pictures, N_SCENES, answers, result);
}

const Judge judge_07 = {
    .lab = "07-kdtree-3d-trace",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_new,
    .job_free = job_free,
    .judge = judge_07_check,
    .write_alone = alone_07_write,
    .passes_alone = alone_07_passes,
    .adopt = adopt,
    .add_pictures = add_pictures,
};

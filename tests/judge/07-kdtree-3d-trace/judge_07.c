// Judge of lab 07: each function on chosen inputs, what rays hit in whole scenes, the pictures, and
// the counted work. The functions' inputs are drawn in judge_07_inputs.c and judged in
// judge_07_clip.c, judge_07_functions.c and judge_07_leaf.c.
//
// Hits are those of brute force, whatever the tree: only rays that the oracle calls ambiguous may
// differ. Wrong ones are compared with searches that make known mistakes (judge_07_search.h). Work
// is judged ray by ray by the least and the most that a right search may do. How answers are tried
// alone is in judge_07_alone.c.
#include "judge_07.h"

#include "job_work.h"
#include "judge_07_search.h"
#include "message.h"
#include "words.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

// ---- Drawing the job ----------------------------------------------------------------------------

static int draw(void *pointer, Random *random)
{
    Job07 *job = pointer;
    inputs_07_draw(random, &job->inputs);
    for (int k = 0; k < N_SCENES; k++) {
        job_list_picture(&job->job, &job->scenes[k].picture);
    }
    return scenes_07_draw(random, job->scenes) | scripted_07_draw(random, job->scripted);
}

static void release(void *pointer)
{
    Job07 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&job->scenes[k]);
    }
    for (int k = 0; k < N_SCRIPTED; k++) {
        job_scene3d_free(&job->scripted[k]);
    }
}

static int write_scene(const void *job, int k, FILE *file)
{
    return job_scene3d_write(&((const Job07 *)job)->scenes[k], k, file);
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

// What wrong hits of a range of scenes look like, or NULL. More scenes than the first
// that is wrong tell mistakes apart that look the same in that one.
static const char *explain_hits(const Job07 *job, Range range, const Sections *answers)
{
    WrongScene wrong[N_SCENES];
    int n_scenes = 0;
    for (int k = range.first; k < range.first + range.n; k++) {
        const JobScene3D *scene = &job->scenes[k];
        const HitAnswer *found = hits_find(scene, k, answers);
        const int n_wrong = found ? count_wrong(scene, found) : 0;
        if (n_wrong > 0) {
            wrong[n_scenes++] = (WrongScene){scene, found, n_wrong};
        }
    }
    return explain(wrong, n_scenes, hit_mistakes, COUNT(hit_mistakes), hit_agrees);
}

static Verdict judge_hits(const Job07 *job, Range range, const Sections *answers)
{
    for (int k = range.first; k < range.first + range.n; k++) {
        const JobScene3D *scene = &job->scenes[k];
        const HitAnswer *found = hits_find(scene, k, answers);
        if (found == NULL) {
            return verdict_missing;
        }
        WrongHits wrong = hits_judge(scene, found);
        if (wrong.n > 0) {
            // That a miss was taken for a hit is known already.
            wrong.looks = wrong.looks ? wrong.looks : explain_hits(job, range, answers);
            return verdict_of(hits_describe(scene, found, wrong));
        }
    }
    return verdict_of(NULL);
}

static Verdict judge_random(const void *job, const Sections *answers)
{
    return judge_hits(job, (Range){RANDOM, N_RANDOM, 1}, answers);
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

static Verdict judge_edges(const void *job, const Sections *answers)
{
    const Range edges = {EDGES, N_SCENES - EDGES, 1};  // and sphereflake
    const Verdict verdict = judge_hits(job, edges, answers);
    return verdict.kind == VERDICT_PASSED ? judge_tie(job, answers) : verdict;
}

// ---- Work -------------------------------------------------------------------------------------

static int is_at_most(Work work, Work most)
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

// "3 nodes and 1 leaf visited and 17 spheres asked".
static Words work_words(Work work)
{
    return words("%u node%s and %u %s visited and %u sphere%s asked", work.n_nodes_visited,
                 plural(work.n_nodes_visited), work.n_leaves_visited,
                 work.n_leaves_visited == 1 ? "leaf" : "leaves", work.n_tests,
                 plural(work.n_tests));
}

// The message about rays that do less than they must.
static char *describe_less(const WrongScene *wrong, int pixel, Work least)
{
    const JobScene3D *scene = wrong->scene;
    const Words own = work_words(((const Work *)wrong->answers)[pixel]);
    const char *looks = explain(wrong, 1, early_mistakes, COUNT(early_mistakes), work_agrees);
    return message_new(
        "%s: the ray of pixel (%d, %d): found %s, "
        "expected at least %u, %u and %u (%d of %d rays do less than they must); %s%s",
        scene->picture.title, pixel % scene->scene.width, pixel / scene->scene.width, own.text,
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
    const Words own = work_words(((const Work *)wrong->answers)[more->first]);
    const char *looks = explain(wrong, 1, work_mistakes, COUNT(work_mistakes), work_agrees);
    return message_new(
        "%s: the ray of pixel (%d, %d): found %s, "
        "expected at most %u, %u and %u (%d of %d rays do more than they must, and %llu spheres "
        "are asked instead of %llu)%s%s",
        scene->picture.title, more->first % width, more->first / width, own.text,
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
        if (!is_at_most(own, bounds.most)) {
            count_off(&more, pixel, bounds.most);
        }
        if (!is_at_most(bounds.least, own)) {
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

static Verdict judge_work(const void *job, int i, const Sections *answers)
{
    const int k = work_scenes[i];
    const JobScene3D *scene = &((const Job07 *)job)->scenes[k];
    const Work *found;
    const Verdict verdict = job_work_find(&scene->picture, k, "children_on_ray and search_leaf",
                                          "trace", answers, &found);
    return found == NULL ? verdict : verdict_of(judge_scene_work(scene, found));
}

// ---- The judge ----------------------------------------------------------------------------------

// Range number i of a function's inputs.
#define RANGE(i, n_inputs) {(i) * (n_inputs), n_inputs}

static const JudgeCheck checks[] = {
    {"clip-through", "Rays that go through the box, or past it", "clip_to_box", 7,
     .function = &clip_07, .range = RANGE(CLIP_FROM_OUTSIDE, N_CLIP_INPUTS)},
    {"clip-inside", "From inside, and parts of rays", "clip_to_box", 5, .function = &clip_07,
     .range = RANGE(CLIP_PART, N_CLIP_INPUTS)},
    {"clip-behind", "Boxes behind the eye and outside the part", "clip_to_box", 4,
     .function = &clip_07, .range = RANGE(CLIP_BESIDE, N_CLIP_INPUTS)},
    {"clip-parallel", "Along the planes, and where a point is left", "clip_to_box", 4,
     .function = &clip_07, .range = RANGE(CLIP_ALONG, N_CLIP_INPUTS)},

    {"side-eye", "The eye's side, wherever the ray goes", "near_side", 9, .function = &side_07,
     .range = RANGE(0, N_SIDE_INPUTS)},
    {"side-on-plane", "An eye on the plane", "near_side", 6, .function = &side_07,
     .range = RANGE(1, N_SIDE_INPUTS)},

    {"children-cases", "Crossed before, inside, and beyond", "children_on_ray", 10,
     .function = &plane_07, .range = RANGE(0, N_PLANE_INPUTS)},
    {"children-behind", "Planes behind the eye, or at it", "children_on_ray", 5,
     .function = &plane_07, .range = RANGE(1, N_PLANE_INPUTS)},
    {"children-parallel", "Rays along the plane", "children_on_ray", 5, .function = &plane_07,
     .range = RANGE(2, N_PLANE_INPUTS)},

    {"leaf-nearest", "The nearest hit so far, or nearer", "search_leaf", 6,
     .function = &leaf_nearest_07, .range = RANGE(0, N_LEAF_INPUTS)},
    {"leaf-ids", "Whose hit it is, also of two equally far ones", "search_leaf", 5,
     .function = &leaf_ids_07, .range = RANGE(1, N_LEAF_INPUTS)},
    {"leaf-once", "Each sphere of the leaf is asked once", "search_leaf", 4,
     .function = &leaf_once_07, .range = {0, N_LEAVES}},

    {"trace-random", "No pinholes in random scenes", "trace", 10, "*", .all = judge_random,
     .alone_scene = hits_alone_07, .alone_range = {SCRIPTED_RANDOM, SCRIPTED_EDGES}},
    {"trace-edges", "Nor in the edge cases", "trace", 8, "*", .all = judge_edges,
     .alone_scene = hits_alone_07, .alone_range = {SCRIPTED_EDGES, N_SCRIPTED - SCRIPTED_EDGES}},
    {"trace-early-end", "It visits what the ray meets, and ends early", "trace", 7, "*",
     .scene = judge_work, .range = {0, COUNT(work_scenes)}, .alone_scene = work_alone_07,
     .alone_range = {0, N_SCRIPTED}},
    {"trace-picture", "Whole pictures", "trace", 5, "*", .scene = judge_picture,
     .range = {0, N_SCENES}, .alone_scene = picture_alone_07, .alone_range = {0, N_SCRIPTED}},
};

static const JobPart parts[] = {
    PART("clips", "clip_to_box", Job07, inputs.clips),
    PART("sides", "near_side", Job07, inputs.sides),
    PART("planes", "children_on_ray", Job07, inputs.planes),
    PART("leaves", "search_leaf", Job07, inputs.leaves),
    PART("leaf_ids", "search_leaf", Job07, inputs.leaf_ids),
    PART("leaf_spheres", "search_leaf", Job07, inputs.leaf_spheres),
};

const Judge judge_07 = {
    .lab = "07-kdtree-3d-trace",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job07),
    .draw = draw,
    .release = release,
    .parts = parts,
    .n_parts = COUNT(parts),
    .write_scene = write_scene,
    .n_scenes = N_SCENES,
    .write_alone = write_alone_07,
};

// Judge of lab 07: each function on chosen inputs, what rays hit in whole scenes, the pictures, and
// the counted work. The functions' inputs are drawn and judged in the files that judge_07.h names.
//
// Hits are those of brute force, whatever the tree: only rays that the oracle calls ambiguous may
// differ. Work is judged ray by ray by the least and the most that a right search may do
// (judge_07_work.h). Mistakes of the search are named where its two steps are judged by themselves.
// How answers are tried alone is in judge_07_alone.c.
#include "judge_07.h"

#include "job_sections.h"
#include "judge_07_work.h"
#include "message.h"

#include <stdlib.h>

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
    [CHILD_ONE] = {"child-one", "Where the ray meets one child", "next_child", 4,
                   "near_side children_on_ray"},
    [CHILD_BOTH] = {"child-both", "Where it meets both: one waits", "next_child", 5,
                    "near_side children_on_ray"},
    [TRACE_RANDOM] = {"trace-random", "No pinholes in random scenes", "next_child", 4, "*"},
    [TRACE_PICTURE] = {"trace-picture", "Whole pictures", "next_child", 3, "*"},
    [WAITING_END] = {"waiting-end", "When the search is over", "next_waiting", 4},
    [WAITING_NEXT] = {"waiting-next", "What comes next where it is not", "next_waiting", 4},
    [TRACE_EDGES] = {"trace-edges", "No pinholes in the edge cases", "next_waiting", 3, "*"},
    [TRACE_WORK] = {"trace-work", "No more work than the ray needs", "next_waiting", 3, "*"},
};

// ---- Drawing the job --------------------------------------------------------------------------

static void job_free(void *pointer)
{
    Job07 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&job->scenes[k]);
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
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

static OracleRay ray_of(const JobScene3D *scene, int pixel)
{
    static const OracleRules3D right = {0};
    const Scene3D *s = &scene->scene;
    return oracle3d_primary_ray(&scene->camera, pixel % s->width, pixel / s->width, s->width,
                                s->height, &right);
}

// ---- Hits -------------------------------------------------------------------------------------

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
    const Verdict verdict = job_scenes3d_judge_hits(job->scenes, EDGES, N_SCENES - EDGES, answers);
    return verdict.kind == VERDICT_PASSED ? judge_tie(job, answers) : verdict;
}

// ---- Work -------------------------------------------------------------------------------------

static int is_within(Work work, Work most)
{
    return work.n_tests <= most.n_tests && work.n_nodes_visited <= most.n_nodes_visited &&
           work.n_leaves_visited <= most.n_leaves_visited && work.stack_depth <= most.stack_depth;
}

enum { WORK_BYTES = 128 };  // of work in words

// "3 nodes and 1 leaf visited, 17 spheres asked and 2 waiting at once".
static void describe_work(Work work, char *words, size_t n_bytes)
{
    const u32 n_nodes = work.n_nodes_visited, n_leaves = work.n_leaves_visited;
    snprintf(words, n_bytes,
             "%u node%s and %u %s visited, %u sphere%s asked and %u waiting at once", n_nodes,
             plural(n_nodes), n_leaves, n_leaves == 1 ? "leaf" : "leaves", work.n_tests,
             plural(work.n_tests), work.stack_depth);
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

// The message about rays that do more than they may, or less: of which words say what it means.
static char *describe_off(const JobScene3D *scene, const Work *found, const OffRays *off,
                          const char *bound, const char *words)
{
    const int width = scene->scene.width;
    char work[WORK_BYTES];
    describe_work(found[off->first], work, sizeof work);
    return message_new(
        "%s: the ray of pixel (%d, %d): found %s, expected at %s %u, %u, %u and %u (%d "
        "of %d rays do %s)",
        scene->picture.title, off->first % width, off->first / width, work, bound,
        off->bound.n_nodes_visited, off->bound.n_leaves_visited, off->bound.n_tests,
        off->bound.stack_depth, off->n, width * scene->scene.height, words);
}

// The message when a scene's rays do too much, or too little, or NULL: too much comes first.
static char *judge_scene_work(const JobScene3D *scene, const Work *found)
{
    const int n_pixels = scene->scene.width * scene->scene.height;
    OffRays more = {0}, less = {0};
    for (int pixel = 0; pixel < n_pixels; pixel++) {
        const OracleRay ray = ray_of(scene, pixel);
        const WorkBounds bounds = search3d_bounds(scene, &ray);
        if (!is_within(found[pixel], bounds.most)) {
            count_off(&more, pixel, bounds.most);
        }
        if (!is_within(bounds.least, found[pixel])) {
            count_off(&less, pixel, bounds.least);
        }
    }
    if (more.n > 0) {
        return describe_off(scene, found, &more, "most", "more than they need to");
    }
    return less.n == 0 ? NULL
                       : describe_off(scene, found, &less, "least",
                                      "less than they must: they end too soon or skip something, "
                                      "or work is hidden and cannot be counted");
}

// The scenes whose work is judged: few levels and many, spheres on all sides of the eye, a tree
// that is as deep as it may be.
static const int work_scenes[] = {RANDOM + 2, RANDOM + 6, RANDOM + 7, RANDOM + N_RANDOM - 1,
                                  DEEP,       FLAKE};

static Verdict judge_work(const Job07 *job, const Sections *answers)
{
    for (size_t i = 0; i < sizeof work_scenes / sizeof *work_scenes; i++) {
        const int k = work_scenes[i];
        const JobScene3D *scene = &job->scenes[k];
        const size_t n_bytes = (size_t)PROBE_IMAGE_SIDE(scene->scene.width) *
                               (size_t)PROBE_IMAGE_SIDE(scene->scene.height) * sizeof(Work);
        const Work *found = job_section_find(answers, "work", k, n_bytes);
        if (found == NULL) {
            if (job_picture_answer(&scene->picture, k, answers).pixels == NULL) {
                return verdict_missing;
            }
            return verdict_of(message_new("the work could not be counted; call intersect_sphere in "
                                          "search_leaf itself"));
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
    case CHILD_ONE:
        return inputs_07_judge_children(inputs, 0, answers);
    case CHILD_BOTH:
        return inputs_07_judge_children(inputs, 1, answers);
    case TRACE_RANDOM:
        return job_scenes3d_judge_hits(job->scenes, RANDOM, N_RANDOM, answers);
    case TRACE_PICTURE:
        return job_pictures_judge(job->pictures, 0, N_SCENES, answers);
    case WAITING_END:
        return inputs_07_judge_end(inputs, answers);
    case WAITING_NEXT:
        return inputs_07_judge_next(inputs, answers);
    case TRACE_EDGES:
        return judge_edges(job, answers);
    default:
        return judge_work(job, answers);
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

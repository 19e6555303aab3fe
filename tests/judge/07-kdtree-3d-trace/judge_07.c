// Judge of lab 07: each function on chosen inputs, what rays hit in whole scenes, the pictures, and
// the counted work. The functions' inputs are rolled and judged in the files that judge_07.h names.
//
// Hits are those of brute force, whatever the tree: only rays that the oracle calls ambiguous may
// differ. Work is judged ray by ray by the least and the most that a right search may do
// (judge_07_work.h). Mistakes of the search are named where its two steps are judged by themselves.
// Alone, next_child is tried beside stubs, all others as in the whole.
#include "judge_07.h"

#include "job_work.h"
#include "judge_07_work.h"
#include "message.h"

// ---- Rolling the job ----------------------------------------------------------------------------

static int roll(void *pointer, Random *random)
{
    Job07 *job = pointer;
    roll_inputs_07(random, &job->inputs);
    if (roll_scenes_07(random, job->scenes) != 0) {
        return -1;
    }
    inputs_07_add_sent(random, job->scenes, &job->inputs);
    return 0;
}

// ---- Hits ---------------------------------------------------------------------------------------

static Verdict judge_hits(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job07 *)job)->scenes[k];
    const HitAnswer *found = hits_find(scene, k, answers);
    return found == NULL ? verdict_missing : verdict_of(hits_judge(scene, found));
}

// Of two spheres at the same distance the one with the lower id, though its leaf comes later: what
// the oracle calls ambiguous here is not, as float finds the same distance for both.
static Verdict judge_tie(const Job07 *job, const Sections *answers)
{
    const HitAnswer *found = hits_find(&job->scenes[TIE], TIE, answers);
    return found == NULL        ? verdict_missing
           : found->sphere == 0 ? verdict_passed
                                : verdict_of(diagnosis_new(
                                      "%s: the ray hits spheres 0 and 1 at t = 1000, exactly where "
                                      "the near leaf ends, which lists sphere 1 only: found sphere "
                                      "%u at t = %.9g, expected sphere 0: of two at the same "
                                      "distance the lower id",
                                      job->scenes[TIE].picture.title, found->sphere, found->t));
}

// In the scene of the tip, and in no other, hits lie so near to where their leaf begins that
// rounding may put them before it. In their place another leaf's sphere is found, the sphere's far
// side, or nothing.
static Verdict judge_tip(const Job07 *job, const Sections *answers)
{
    const JobScene3D *scene = &job->scenes[TIP];
    const HitAnswer *found = hits_find(scene, TIP, answers);
    if (found == NULL) {
        return verdict_missing;
    }
    int is_lost = 1;  // each wrong hit
    for (int pixel = 0; pixel < scene->scene.width * scene->scene.height; pixel++) {
        const OracleHit *expected = &scene->hits[pixel];
        is_lost &= hit_is_right(expected, found[pixel]) || found[pixel].t > expected->t + 1;
    }
    Diagnosis wrong = hits_judge(scene, found);
    if (wrong.found != NULL && wrong.cause == NULL && is_lost) {
        wrong.cause = message_new("that is as if a hit were thrown away that rounding puts before "
                                  "the leaf's t_min: it counts all the same");
    }
    return verdict_of(wrong);
}

// With the sphereflake behind the edge cases, and the tie behind all.
static Verdict judge_edges(const void *job, const Sections *answers)
{
    Verdict verdict = verdict_passed;
    for (int k = EDGES; verdict.kind == VERDICT_PASSED && k <= FLAKE; k++) {
        verdict = k == TIP ? judge_tip(job, answers) : judge_hits(job, k, answers);
    }
    return verdict.kind == VERDICT_PASSED ? judge_tie(job, answers) : verdict;
}

// ---- Work -------------------------------------------------------------------------------------

// Rays of a scene that do more, or less, than they may.
typedef struct OffRays {
    int n;
    int first;      // a pixel
    Work bound;     // of the first
    int n_shorter;  // how many visit fewer nodes or leaves than the bound
} OffRays;

static void count_off(OffRays *off, int pixel, Work found, Work bound)
{
    if (off->n++ == 0) {
        off->first = pixel;
        off->bound = bound;
    }
    off->n_shorter += found.n_nodes_visited < bound.n_nodes_visited ||
                      found.n_leaves_visited < bound.n_leaves_visited;
}

// Rays that do more than they may, or less: of which words say what it means.
static Diagnosis describe_off(const JobScene3D *scene, const Work *found, const OffRays *off,
                              const char *bound, const char *words)
{
    const int width = scene->scene.width;
    return diagnosis_new(
        "%s: the ray of pixel (%d, %d): found %s, expected at %s %u, %u, %u and %u (%d "
        "of %d rays do %s)",
        scene->picture.title, off->first % width, off->first / width,
        work_words(found[off->first]).text, bound, off->bound.n_nodes_visited,
        off->bound.n_leaves_visited, off->bound.n_tests, off->bound.stack_depth, off->n,
        width * scene->scene.height, words);
}

// Do a scene's rays too much, or too little? Too much comes first.
static Diagnosis judge_scene_work(const JobScene3D *scene, const Work *found)
{
    const int n_pixels = scene->scene.width * scene->scene.height;
    OffRays more = {0}, less = {0};
    for (int pixel = 0; pixel < n_pixels; pixel++) {
        const OracleRay ray = job_scene3d_ray(scene, pixel);
        const WorkBounds bounds = search3d_bounds(scene, &ray);
        if (!work_is_at_most(found[pixel], bounds.most)) {
            count_off(&more, pixel, found[pixel], bounds.most);
        }
        if (!work_is_at_most(bounds.least, found[pixel])) {
            count_off(&less, pixel, found[pixel], bounds.least);
        }
    }
    if (more.n > 0) {
        return describe_off(scene, found, &more, "most", "more than they need to");
    }
    return less.n == 0 ? NOTHING_WRONG
                       : describe_off(scene, found, &less, "least",
                                      less.n_shorter > 0
                                          ? "less than they must: the search ends too soon, or "
                                            "leaves out a child that the ray meets"
                                          : "less than they must: they are in the right leaves, "
                                            "but there spheres are not asked, or not by "
                                            "intersect_sphere, which counts");
}

// The scenes whose work is judged: few levels and many, spheres on all sides of the eye, a tree
// that is as deep as it may be.
static const int work_scenes[] = {RANDOM + 2, RANDOM + 6, RANDOM + 7, RANDOM + N_RANDOM - 1,
                                  DEEP,       FLAKE,      DECOYS};

// No ray may find the decoy: only leaves list it that the ray need not visit.
static Verdict judge_decoys(const JobScene3D *scene, const Sections *answers)
{
    const HitAnswer *found = hits_find(scene, DECOYS, answers);
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const u32 decoy = (u32)scene->scene.n_spheres;
    int n = 0, first = 0;
    for (int pixel = n_pixels - 1; found != NULL && pixel >= 0; pixel--) {
        if (!scene->hits[pixel].is_ambiguous && found[pixel].sphere == decoy) {
            n++;
            first = pixel;
        }
    }
    if (found == NULL || n == 0) {
        return found == NULL ? verdict_missing : verdict_passed;
    }
    char *message =
        message_new("%s: the ray of pixel (%d, %d): found sphere %u, which only leaves "
                    "list that this ray need not visit (%d of %d rays)",
                    scene->picture.title, first % width, first / width, decoy, n, n_pixels);
    return verdict_of(diagnosis_of(message, (Cause){.says = "whatever is counted, more is asked "
                                                            "than the leaves on the ray up to its "
                                                            "first hit"}));
}

static Verdict judge_work(const void *job, int i, const Sections *answers)
{
    const int k = work_scenes[i];
    if (k == DECOYS) {
        return judge_decoys(&((const Job07 *)job)->scenes[k], answers);
    }
    const JobScene3D *scene = &((const Job07 *)job)->scenes[k];
    const Work *found = job_work_find(&scene->picture, k, answers);
    return found == NULL ? verdict_missing : verdict_of(judge_scene_work(scene, found));
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"clip-through", "Rays that go through the box, or past it", "clip_to_box",
     .function = &clip_07, .range = RANGE(CLIP_FROM_OUTSIDE, N_CLIP_INPUTS)},
    {"clip-inside", "From inside, and parts of rays", "clip_to_box", .function = &clip_07,
     .range = RANGE(CLIP_PART, N_CLIP_INPUTS)},
    {"clip-behind", "Boxes behind the eye and outside the part", "clip_to_box",
     .function = &clip_07, .range = RANGE(CLIP_BESIDE, N_CLIP_INPUTS)},
    {"clip-parallel", "Along the planes, and where a point is left", "clip_to_box",
     .function = &clip_07, .range = RANGE(CLIP_ALONG, N_CLIP_INPUTS)},

    {"side-eye", "The eye's side, wherever the ray goes", "near_side", .function = &side_07,
     .range = RANGE(0, N_SIDE_INPUTS)},
    {"side-on-plane", "An eye on the plane", "near_side", .function = &side_07,
     .range = RANGE(1, N_SIDE_INPUTS)},

    {"children-cases", "Crossed before, inside, and beyond", "children_on_ray",
     .function = &plane_07, .range = RANGE(0, N_PLANE_INPUTS)},
    {"children-behind", "Planes behind the eye, or at it", "children_on_ray", .function = &plane_07,
     .range = RANGE(1, N_PLANE_INPUTS)},
    {"children-parallel", "Rays along the plane", "children_on_ray", .function = &plane_07,
     .range = RANGE(2, N_PLANE_INPUTS)},

    {"leaf-nearest", "The nearest hit so far, or nearer", "search_leaf",
     .function = &leaf_nearest_07, .range = RANGE(0, N_LEAF_INPUTS)},
    {"leaf-ids", "Whose hit it is, also of two equally far ones", "search_leaf",
     .function = &leaf_ids_07, .range = RANGE(1, N_LEAF_INPUTS)},
    {"leaf-once", "Each sphere of the leaf is asked once", "search_leaf", .function = &leaf_once_07,
     .range = {0, N_LEAVES}},

    {"child-one", "Where the ray meets one child", "next_child", "near_side children_on_ray",
     .function = &child_07, .range = RANGE(0, N_CHILD_INPUTS), .alone = one_child_alone_07,
     .alone_cause = judge_function_alone},
    {"child-both", "Where it meets both: one waits", "next_child", "near_side children_on_ray",
     .function = &child_07, .range = RANGE(1, N_CHILD_INPUTS), .alone = both_children_alone_07,
     .alone_cause = judge_function_alone},
    {"trace-random", "No pinholes in random scenes", "next_child", "*", .scene = judge_hits,
     .range = {RANDOM, N_RANDOM}, .alone = children_alone_07},
    {"trace-picture", "Whole pictures", "next_child", "*", .scene = judge_picture,
     .range = {0, DECOYS}, .alone = children_alone_07},

    {"waiting-end", "When the search is over", "next_waiting", .function = &waiting_end_07,
     .range = {0, N_WAITING_INPUTS}},
    {"waiting-next", "What comes next where it is not", "next_waiting",
     .function = &waiting_next_07, .range = {0, N_WAITING_INPUTS}},
    {"trace-edges", "No pinholes in the edge cases", "next_waiting", "*", .all = judge_edges,
     .alone_functions = {&waiting_end_07, &waiting_next_07}},
    {"trace-work", "No more work than the ray needs", "next_waiting", "*", .scene = judge_work,
     .range = {0, COUNT(work_scenes)}, .alone_functions = {&waiting_end_07, &waiting_next_07}},
};

static const JobPart parts[] = {
    INPUTS("clips", "clip_to_box", Job07, inputs.clips),
    INPUTS("sides", "near_side", Job07, inputs.sides),
    INPUTS("planes", "children_on_ray", Job07, inputs.planes),
    INPUTS("leaves", "search_leaf", Job07, inputs.leaves),
    DATA("leaf_ids", "search_leaf", Job07, inputs.leaf_ids),
    DATA("leaf_spheres", "search_leaf", Job07, inputs.leaf_spheres),
    INPUTS("next_child", "next_child", Job07, inputs.children),
    INPUTS("next_waiting", "next_waiting", Job07, inputs.waiting, .suspect = suspect_waiting_07),
};

const Judge judge_07 = {
    .lab = "07-kdtree-3d-trace",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job07),
    .roll = roll,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene3d_kind, Job07, scenes),
    .scene_steps = {{"hits", "in trace", NULL}, {"picture", "in render_kdtree", NULL}},
};

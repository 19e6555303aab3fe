// Lab 06: one task's answer alone (grader/alone.h). A whole tree takes the answers to all tasks, so
// in its place the one answer is called as the builder would call it: see replay.h.
#include "judge_06.h"

#include <stdlib.h>
#include <string.h>

// The spheres of all scenes that have a tree. Returns 0, or -1.
static int write_spheres(const Job06 *job, FILE *file)
{
    int result = 0;
    for (int k = 0; result == 0 && k <= JUST_FITS; k++) {
        result = job_06_write_spheres(&job->scenes[k], k, file);
    }
    return result;
}

// Is there nothing to object to? Releases the message.
static int is_silent(char *message)
{
    free(message);
    return message == NULL;
}

// ---- spheres_bounds: once for each scene --------------------------------------------------------

static int write_bounds_calls(const Job06 *job, FILE *file)
{
    u32 numbers[JUST_FITS + 1];
    for (int k = 0; k <= JUST_FITS; k++) {
        numbers[k] = (u32)job->scenes[k].scene.n_spheres;
    }
    return section_write(file, "replay.bounds", numbers, sizeof numbers) | write_spheres(job, file);
}

int bounds_alone_06(const void *job, int k, const Sections *answers)
{
    const Scene3D *scene = &((const Job06 *)job)->scenes[k].scene;
    const BBox3D *found = sections_find(answers, "replay.bounds", (JUST_FITS + 1) * sizeof *found);
    return found != NULL &&
           is_silent(tree3d_judge_box("alone", scene->spheres, (u32)scene->n_spheres, found[k]));
}

// ---- choose_split: once for each inner node -----------------------------------------------------

static void split_input(const void *job, ReplayCall call, void *input)
{
    (void)job;
    *(BBox3D *)input = call.node->cell;
}

// The same plane as in the tree, up to what float rounds.
static int split_is_right(const void *job, ReplayCall call, const void *answer)
{
    const SplitAnswer3D *found = answer;
    const BBox3D cell = call.node->cell;
    (void)job;
    return is_silent(tree3d_judge_axis("alone", cell, found->axis)) &&
           is_silent(tree3d_judge_middle("alone", cell, found->axis, found->pos));
}

const Replay replay_split_06 = {"replay.split",        EACH_INNER_NODE, sizeof(BBox3D),
                                sizeof(SplitAnswer3D), split_input,     split_is_right};

// ---- sphere_overlaps_box: once for each sphere of an inner node and each of its children --------

static SphereBoxJob overlap_of(const Job06 *job, ReplayCall call)
{
    return (SphereBoxJob){job->scenes[call.node->scene].scene.spheres[call.id], call.child->cell};
}

static void overlap_input(const void *job, ReplayCall call, void *input)
{
    *(SphereBoxJob *)input = overlap_of(job, call);
}

static int overlap_is_right(const void *job, ReplayCall call, const void *answer)
{
    const SphereBoxJob in = overlap_of(job, call);
    const SphereInCell is = tree3d_judge_sphere(in.sphere, in.box);
    return is == SPHERE_EITHER || (*(const i32 *)answer != 0) == (is == SPHERE_INSIDE);
}

const Replay replay_overlap_06 = {"replay.overlap", EACH_ID_OF_A_CHILD, sizeof(SphereBoxJob),
                                  sizeof(i32),      overlap_input,      overlap_is_right};

// ---- distribute_spheres: twice for each inner node ----------------------------------------------

// The hole of sphere_overlaps_box while another task is tried.
static int stand_in_overlaps(Sphere sphere, BBox3D box)
{
#include "06-kdtree-3d-build/sphere_overlaps_box.c"
}

// What distribute_spheres makes of the stand-in. As ListKeeps of replay.h has it.
static int keeps(const void *pointer, u32 scene, u32 id, BBox3D cell)
{
    const Job06 *job = pointer;
    return stand_in_overlaps(job->scenes[scene].scene.spheres[id], cell);
}

static void cell_input(const void *job, ReplayCall call, void *input)
{
    (void)job;
    *(BBox3D *)input = call.child->cell;
}

static const Replay cells = {"replay.cells", EACH_CHILD, sizeof(BBox3D), .input = cell_input};

// The children's cells, and all that the lists need. Returns 0, or -1.
static int write_list_calls(const Job06 *job, FILE *file)
{
    return replay_write(&cells, &job->job.growth, job, file) |
           replay_write_lists(&job->job.growth, file) |
           section_write(file, "distribute", job->distributes, sizeof job->distributes) |
           write_spheres(job, file);
}

_Static_assert(REPLAY_ROOM(DISTRIBUTE_MAX_IDS) <= DISTRIBUTE_ROOM, "the guard is in the answer");
int distributes_alone_06(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const u32 *found = function_answers(check->function, answers);
    int is_right = found != NULL;
    for (int i = 0; is_right && i < N_DISTRIBUTES; i++) {
        is_right = list_is_right(list_call_06(job, i), keeps, job, found + i * DISTRIBUTE_ROOM);
    }
    return is_right;
}

int lists_alone_06(const void *pointer, const JudgeCheck *check, const Sections *answers)
{
    const Job06 *job = pointer;
    (void)check;
    return replay_lists_are_right(&job->job.growth, answers, keeps, job);
}

// ---- pack_leaf_range: once for each leaf --------------------------------------------------------

static int write_leaves(const Job06 *job, FILE *file)
{
    ReplayTree trees[JUST_FITS + 1];
    for (int k = 0; k <= JUST_FITS; k++) {
        const KdTree3D *tree = &job->scenes[k].tree;
        trees[k] = (ReplayTree){tree->n_nodes, tree->n_sphere_ids};
    }
    return replay_write_leaves(&job->job.growth, trees, JUST_FITS + 1, file);
}

// Is a node as it must be: its leaf packed, or untouched? A leaf's split_pos is free.
static int node_is_right(KdNode3 expected, KdNode3 found)
{
    if (expected.split_axis == KD_LEAF) {
        return found.split_axis == KD_LEAF && found.first == expected.first &&
               found.n_spheres == expected.n_spheres;
    }
    return found.split_pos == 0 && found.split_axis == 0 && found.first == UNTOUCHED &&
           found.n_spheres == UNTOUCHED;
}

int packs_alone_06(const void *job, int k, const Sections *answers)
{
    const KdTree3D *tree = &((const Job06 *)job)->scenes[k].tree;
    const size_t n = tree->n_sphere_ids;
    const u32 *n_found = job_section_find(answers, "packed", k, sizeof *n_found);
    const KdNode3 *nodes =
        job_part_find(answers, "packed", k, "nodes", tree->n_nodes * sizeof *nodes);
    const u32 *ids = job_part_find(answers, "packed", k, "map", (n + REPLAY_GUARD) * sizeof *ids);
    int is_right = n_found != NULL && nodes != NULL && ids != NULL && *n_found == n &&
                   memcmp(ids, tree->sphere_ids, n * sizeof *ids) == 0 &&
                   guard_is_untouched(ids + n);
    for (u32 id = 0; is_right && id < tree->n_nodes; id++) {
        is_right = node_is_right(tree->nodes[id], nodes[id]);
    }
    return is_right;
}

// ---- fits_todo: once for each inner node --------------------------------------------------------

// The levels that are asked about, n of them; NULL without memory. Owned by the caller.
static i32 *list_levels(const Job06 *job, size_t *n)
{
    const Growth *growths[] = {&job->job.growth, &job->too_deep};
    i32 *levels = calloc((size_t)growths[0]->n_nodes + growths[1]->n_nodes, sizeof *levels);
    *n = 0;
    for (int g = 0; levels != NULL && g < 2; g++) {
        int level = 0;
        // The builder gives up where it is told to.
        for (u32 i = 0; i < growths[g]->n_nodes && level <= TODO_SIZE; i++) {
            if (growths[g]->nodes[i].first_child != 0) {
                levels[(*n)++] = level = growths[g]->nodes[i].level;
            }
        }
    }
    return levels;
}

static int write_level_calls(const Job06 *job, FILE *file)
{
    size_t n;
    i32 *levels = list_levels(job, &n);
    const u32 highest = job->highest_level;
    const int result = levels == NULL
                           ? -1
                           : section_write(file, "replay.todo", levels, n * sizeof *levels) |
                                 section_write(file, "todo", &highest, sizeof highest);
    free(levels);
    return result;
}

int levels_alone_06(const void *job, const JudgeCheck *check, const Sections *answers)
{
    size_t n;
    i32 *levels = list_levels(job, &n);
    const i32 *found = sections_find(answers, "replay.todo", n * sizeof *found);
    int is_right = levels != NULL && found != NULL;
    (void)check;
    for (size_t i = 0; is_right && i < n; i++) {
        is_right = (found[i] != 0) == (levels[i] <= TODO_SIZE);
    }
    free(levels);
    return is_right;
}

// ---- All of it ----------------------------------------------------------------------------------

int write_alone_06(const void *job, const char *task, FILE *file)
{
    return strcmp(task, "spheres_bounds") == 0       ? write_bounds_calls(job, file)
           : strcmp(task, "distribute_spheres") == 0 ? write_list_calls(job, file)
           : strcmp(task, "pack_leaf_range") == 0    ? write_leaves(job, file)
           : strcmp(task, "fits_todo") == 0          ? write_level_calls(job, file)
                                                     : 0;
}

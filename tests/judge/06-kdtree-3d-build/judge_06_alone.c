// Lab 06: one task's answer alone (grader/alone.h). A whole tree takes the answers to all tasks, so
// in its place the one answer is called as the builder would call it: see replay.h.
#include "judge_06.h"

#include <stdlib.h>
#include <string.h>

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
    return verdict_passes(verdict_of(tree3d_judge_axis("alone", cell, found->axis))) &&
           verdict_passes(verdict_of(tree3d_judge_middle("alone", cell, found->axis, found->pos)));
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

// Is a node as it must be: its leaf packed, or untouched? Neither has another split_pos.
static int node_is_right(KdNode3 expected, KdNode3 found)
{
    const int is_leaf = expected.split_axis == KD_LEAF;
    return found.split_pos == PACK_SPLIT_POS &&
           found.split_axis == (is_leaf ? KD_LEAF : PACK_SPLIT_AXIS) &&
           found.first == (is_leaf ? expected.first : UNTOUCHED) &&
           found.n_spheres == (is_leaf ? expected.n_spheres : UNTOUCHED);
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
static LevelJob *list_levels(const Job06 *job, size_t *n)
{
    const Growth *growths[] = {&job->job.growth, &job->too_deep};
    LevelJob *levels = calloc((size_t)growths[0]->n_nodes + growths[1]->n_nodes, sizeof *levels);
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
    LevelJob *levels = list_levels(job, &n);
    const int result =
        levels == NULL ? -1 : section_write(file, "replay.todo", levels, n * sizeof *levels);
    free(levels);
    return result;
}

int levels_alone_06(const void *job, const JudgeCheck *check, const Sections *answers)
{
    size_t n;
    LevelJob *levels = list_levels(job, &n);
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
    return strcmp(task, "pack_leaf_range") == 0 ? write_leaves(job, file)
           : strcmp(task, "fits_todo") == 0     ? write_level_calls(job, file)
                                                : 0;
}

// Lab 06: one task's answer alone (grader/alone.h). A whole tree takes the answers to all tasks, so
// in its place the one answer is called as the builder would call it: see replay.h.
#include "judge_06.h"

#include "job_sections.h"

#include <stdlib.h>
#include <string.h>

// ---- choose_split: once for each inner node -----------------------------------------------------

static int write_split_calls(const Job06 *job, FILE *file)
{
    const Replay *replay = &job->replay;
    BBox3D *cells = calloc(replay->n_nodes, sizeof *cells);
    size_t n = 0;
    for (u32 i = 0; cells != NULL && i < replay->n_nodes; i++) {
        if (replay->nodes[i].first_child != 0) {
            cells[n++] = replay->nodes[i].cell;
        }
    }
    const int result =
        cells == NULL ? -1 : section_write(file, "replay.split", cells, n * sizeof *cells);
    free(cells);
    return result;
}

// The same plane as in the tree, up to what float rounds.
static int split_is_right(BBox3D cell, SplitAnswer3D found)
{
    char *message = tree3d_judge_axis("alone", cell, found.axis);
    if (message == NULL) {
        message = tree3d_judge_middle("alone", cell, found.axis, found.pos);
    }
    const int is_right = message == NULL;
    free(message);
    return is_right;
}

static int splits_are_right(const Job06 *job, const Sections *answers)
{
    const Replay *replay = &job->replay;
    const SplitAnswer3D *found =
        sections_find(answers, "replay.split", replay_n_inner(replay) * sizeof *found);
    int is_right = found != NULL;
    for (u32 i = 0; is_right && i < replay->n_nodes; i++) {
        if (replay->nodes[i].first_child != 0) {
            is_right = split_is_right(replay->nodes[i].cell, *found++);
        }
    }
    return is_right;
}

// ---- sphere_overlaps_box: once for each sphere of an inner node and each of its children --------

// List the calls; calls may be NULL. Returns how many there are.
static size_t list_overlap_calls(const Job06 *job, SphereBoxJob *calls)
{
    const Replay *replay = &job->replay;
    size_t n = 0;
    for (u32 i = 0; i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        const Sphere *spheres = job->scenes[node->scene].scene.spheres;
        for (int side = 0; node->first_child != 0 && side < 2; side++) {
            for (u32 j = 0; j < node->n_ids; j++, n++) {
                if (calls != NULL) {
                    calls[n] = (SphereBoxJob){spheres[replay->ids[node->first_id + j]],
                                              replay_child(node, side)->cell};
                }
            }
        }
    }
    return n;
}

// The calls, or NULL without memory; owned by the caller.
static SphereBoxJob *overlap_calls(const Job06 *job, size_t *n)
{
    *n = list_overlap_calls(job, NULL);
    SphereBoxJob *calls = calloc(*n + 1, sizeof *calls);
    if (calls != NULL) {
        list_overlap_calls(job, calls);
    }
    return calls;
}

static int write_overlap_calls(const Job06 *job, FILE *file)
{
    size_t n;
    SphereBoxJob *calls = overlap_calls(job, &n);
    const int result =
        calls == NULL ? -1 : section_write(file, "replay.overlap", calls, n * sizeof *calls);
    free(calls);
    return result;
}

static int overlaps_are_right(const Job06 *job, const Sections *answers)
{
    size_t n;
    SphereBoxJob *calls = overlap_calls(job, &n);
    const i32 *found = sections_find(answers, "replay.overlap", n * sizeof *found);
    int is_right = calls != NULL && found != NULL;
    for (size_t i = 0; is_right && i < n; i++) {
        const SphereInCell is = tree3d_judge_sphere(calls[i].sphere, calls[i].box);
        is_right = is == SPHERE_EITHER || (found[i] != 0) == (is == SPHERE_INSIDE);
    }
    free(calls);
    return is_right;
}

// ---- pack_leaf_range: once for each leaf --------------------------------------------------------

static int write_leaves(const Job06 *job, FILE *file)
{
    ReplayTree trees[JUST_FITS + 1];
    for (int k = 0; k <= JUST_FITS; k++) {
        const KdTree3D *tree = &job->scenes[k].tree;
        trees[k] = (ReplayTree){tree->n_nodes, tree->n_sphere_ids};
    }
    return section_write(file, "pack", job->packs, sizeof job->packs) |
           replay_write_leaves(&job->replay, trees, JUST_FITS + 1, file);
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

static int tree_is_packed(const KdTree3D *tree, int k, const Sections *answers)
{
    char name[SECTION_NAME_BYTES];
    const size_t n = tree->n_sphere_ids;
    const u32 *n_sphere_ids = job_section_find(answers, "packed", k, sizeof *n_sphere_ids);
    snprintf(name, sizeof name, "packed.%d.nodes", k);
    const KdNode3 *nodes = sections_find(answers, name, tree->n_nodes * sizeof *nodes);
    snprintf(name, sizeof name, "packed.%d.map", k);
    const u32 *ids = sections_find(answers, name, (n + REPLAY_GUARD) * sizeof *ids);
    int is_right = n_sphere_ids != NULL && nodes != NULL && ids != NULL && *n_sphere_ids == n &&
                   memcmp(ids, tree->sphere_ids, n * sizeof *ids) == 0;
    for (u32 id = 0; is_right && id < tree->n_nodes; id++) {
        is_right = node_is_right(tree->nodes[id], nodes[id]);
    }
    for (int i = 0; is_right && i < REPLAY_GUARD; i++) {
        is_right = ids[n + (size_t)i] == UNTOUCHED;
    }
    return is_right;
}

static int trees_are_packed(const Job06 *job, const Sections *answers)
{
    int is_right = 1;
    for (int k = 0; is_right && k <= JUST_FITS; k++) {
        is_right = tree_is_packed(&job->scenes[k].tree, k, answers);
    }
    return is_right;
}

// ---- fits_todo: once for each inner node --------------------------------------------------------

// The levels that are asked about, n of them; NULL without memory. Owned by the caller.
static i32 *list_levels(const Job06 *job, size_t *n)
{
    i32 *levels = calloc((size_t)job->replay.n_nodes + job->too_deep.n_nodes, sizeof *levels);
    *n = 0;
    for (u32 i = 0; levels != NULL && i < job->replay.n_nodes; i++) {
        if (job->replay.nodes[i].first_child != 0) {
            levels[(*n)++] = job->replay.nodes[i].level;
        }
    }
    // The builder gives up where it is told to.
    int level = 0;
    for (u32 i = 0; levels != NULL && i < job->too_deep.n_nodes && level <= TODO_SIZE; i++) {
        if (job->too_deep.nodes[i].first_child != 0) {
            levels[(*n)++] = level = job->too_deep.nodes[i].level;
        }
    }
    return levels;
}

static int write_level_calls(const Job06 *job, FILE *file)
{
    size_t n;
    i32 *levels = list_levels(job, &n);
    const int result = levels == NULL
                           ? -1
                           : section_write(file, "replay.todo", levels, n * sizeof *levels) |
                                 job_06_write_levels(file);
    free(levels);
    return result;
}

static int levels_are_right(const Job06 *job, const Sections *answers)
{
    size_t n;
    i32 *levels = list_levels(job, &n);
    const i32 *found = sections_find(answers, "replay.todo", n * sizeof *found);
    int is_right = levels != NULL && found != NULL;
    for (size_t i = 0; is_right && i < n; i++) {
        is_right = (found[i] != 0) == (levels[i] <= TODO_SIZE);
    }
    free(levels);
    return is_right;
}

// ---- All of it ----------------------------------------------------------------------------------

int judge_06_write_alone(const void *pointer, const char *task, FILE *file)
{
    const Job06 *job = pointer;
    if (strcmp(task, "choose_split") == 0) {
        return section_write(file, "splits", job->splits, sizeof job->splits) |
               write_split_calls(job, file);
    }
    if (strcmp(task, "sphere_overlaps_box") == 0) {
        return section_write(file, "overlaps", job->overlaps, sizeof job->overlaps) |
               write_overlap_calls(job, file);
    }
    return strcmp(task, "pack_leaf_range") == 0 ? write_leaves(job, file)
                                                : write_level_calls(job, file);
}

int judge_06_passes_alone(const Job06 *job, int check, const Sections *answers)
{
    switch (check) {
    case TREE_SPLITS:
        return splits_are_right(job, answers);
    case TREE_OVERLAP:
        return overlaps_are_right(job, answers);
    case TREE_PACKING:
        return trees_are_packed(job, answers);
    case TREE_DEPTH:
        return levels_are_right(job, answers);
    default:
        return 0;
    }
}

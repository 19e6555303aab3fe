// Lab 02: one task's answer alone (grader/alone.h). A whole tree takes the answers to all tasks, so
// in its place the one answer is called as the builder would call it: see replay.h.
#include "judge_02.h"

#include "job_sections.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"

#include <stdlib.h>
#include <string.h>

// The hole of circle_overlaps_box while another task is tried.
static int stand_in_overlaps(Circle circle, BBox2D box)
{
#include "02-kdtree-2d-build/circle_overlaps_box.c"
}

static BBox2D box_of(const ReplayNode *node)
{
    return (BBox2D){node->cell.min[0], node->cell.max[0], node->cell.min[1], node->cell.max[1]};
}

// What distribute makes of the stand-in. As ReplayKeeps of replay.h has it.
static int keeps(const void *pointer, u32 scene, u32 id, BBox3D cell)
{
    const Job02 *job = pointer;
    const BBox2D box = {cell.min[0], cell.max[0], cell.min[1], cell.max[1]};
    return stand_in_overlaps(job->scenes[scene].scene.circles[id], box);
}

// ---- is_leaf: once for each node ----------------------------------------------------------------

static int write_leaf_calls(const Job02 *job, FILE *file)
{
    const Replay *replay = &job->replay;
    LeafJob *calls = calloc(replay->n_nodes, sizeof *calls);
    for (u32 i = 0; calls != NULL && i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        const KdTreeLimits limits = job->scenes[node->scene].limits;
        calls[i] = (LeafJob){.level = node->level,
                             .n_circles = node->n_ids,
                             .maxDepth = limits.maxDepth,
                             .targetElementsPerNode = limits.targetElementsPerNode,
                             .n_failed = node->n_failed};
    }
    const int result =
        calls == NULL ? -1
                      : section_write(file, "replay.leaf", calls, replay->n_nodes * sizeof *calls);
    free(calls);
    return result;
}

static int leaves_are_where_expected(const Job02 *job, const Sections *answers)
{
    const Replay *replay = &job->replay;
    const i32 *found = sections_find(answers, "replay.leaf", replay->n_nodes * sizeof *found);
    int is_right = found != NULL;
    for (u32 i = 0; is_right && i < replay->n_nodes; i++) {
        is_right = (found[i] != 0) == (replay->nodes[i].first_child == 0);
    }
    return is_right;
}

// ---- split_box: once for each inner node --------------------------------------------------------

static int write_split_calls(const Job02 *job, FILE *file)
{
    const Replay *replay = &job->replay;
    BBox2D *boxes = calloc(replay->n_nodes, sizeof *boxes);
    size_t n = 0;
    for (u32 i = 0; boxes != NULL && i < replay->n_nodes; i++) {
        if (replay->nodes[i].first_child != 0) {
            boxes[n++] = box_of(&replay->nodes[i]);
        }
    }
    const int result =
        boxes == NULL ? -1 : section_write(file, "replay.split", boxes, n * sizeof *boxes);
    free(boxes);
    return result;
}

static int is_same_box(BBox2D a, BBox2D b)
{
    return a.minX == b.minX && a.maxX == b.maxX && a.minY == b.minY && a.maxY == b.maxY;
}

static int cells_are_halved(const Job02 *job, const Sections *answers)
{
    const Replay *replay = &job->replay;
    const size_t n = replay_n_inner(replay);
    const BBox2D *found = sections_find(answers, "replay.split", 2 * n * sizeof *found);
    int is_right = found != NULL;
    for (u32 i = 0; is_right && i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        for (int side = 0; is_right && node->first_child != 0 && side < 2; side++) {
            is_right = is_same_box(*found++, box_of(replay_child(node, side)));
        }
    }
    return is_right;
}

// ---- circle_overlaps_box: once for each circle of an inner node and each of its children --------

// List the calls; calls may be NULL. Returns how many there are.
static size_t list_overlap_calls(const Job02 *job, BoxOverlapJob *calls)
{
    const Replay *replay = &job->replay;
    size_t n = 0;
    for (u32 i = 0; i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        const Circle *circles = job->scenes[node->scene].scene.circles;
        for (int side = 0; node->first_child != 0 && side < 2; side++) {
            for (u32 j = 0; j < node->n_ids; j++, n++) {
                if (calls != NULL) {
                    calls[n] = (BoxOverlapJob){circles[replay->ids[node->first_id + j]],
                                               box_of(replay_child(node, side))};
                }
            }
        }
    }
    return n;
}

// The calls, or NULL without memory; owned by the caller.
static BoxOverlapJob *overlap_calls(const Job02 *job, size_t *n)
{
    *n = list_overlap_calls(job, NULL);
    BoxOverlapJob *calls = calloc(*n + 1, sizeof *calls);
    if (calls != NULL) {
        list_overlap_calls(job, calls);
    }
    return calls;
}

static int write_overlap_calls(const Job02 *job, FILE *file)
{
    size_t n;
    BoxOverlapJob *calls = overlap_calls(job, &n);
    const int result =
        calls == NULL ? -1 : section_write(file, "replay.overlap", calls, n * sizeof *calls);
    free(calls);
    return result;
}

static int overlaps_are_right(const Job02 *job, const Sections *answers)
{
    size_t n;
    BoxOverlapJob *calls = overlap_calls(job, &n);
    const i32 *found = sections_find(answers, "replay.overlap", n * sizeof *found);
    int is_right = calls != NULL && found != NULL;
    for (size_t i = 0; is_right && i < n; i++) {
        is_right = (found[i] != 0) == oracle2d_overlaps_box(calls[i].circle, calls[i].box);
    }
    free(calls);
    return is_right;
}

// ---- distribute: twice for each inner node ------------------------------------------------------

// The children's cells, and all that the lists need. Returns 0, or -1.
static int write_list_calls(const Job02 *job, FILE *file)
{
    const Replay *replay = &job->replay;
    BBox2D *cells = calloc(replay->n_nodes, sizeof *cells);
    size_t n = 0;
    for (u32 i = 0; cells != NULL && i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        for (int side = 0; node->first_child != 0 && side < 2; side++) {
            cells[n++] = box_of(replay_child(node, side));
        }
    }
    int result = cells == NULL ? -1
                               : section_write(file, "replay.cells", cells, n * sizeof *cells) |
                                     replay_write_lists(replay, file) |
                                     section_write(file, "distribute", job->distributes,
                                                   sizeof job->distributes);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_write_circles(&job->scenes[k], k, file);
    }
    free(cells);
    return result;
}

static int distributes_rightly(const Job02 *job, const Sections *answers)
{
    const u32 *found =
        sections_find(answers, "distribute", N_DISTRIBUTES * DISTRIBUTE_ROOM * sizeof *found);
    int is_right = found != NULL;
    for (int i = 0; is_right && i < N_DISTRIBUTES; i++) {
        const DistributeJob *in = &job->distributes[i];
        const BBox3D cell = {{in->child.minX, in->child.minY, 0},
                             {in->child.maxX, in->child.maxY, 0}};
        is_right = replay_list_is_right(found + i * DISTRIBUTE_ROOM, in->ids, in->n_ids, 0, cell,
                                        keeps, job);
    }
    return is_right;
}
_Static_assert(REPLAY_ROOM(DISTRIBUTE_MAX_IDS) <= DISTRIBUTE_ROOM, "the guard is in the answer");

// ---- pack_leaf: once for each leaf --------------------------------------------------------------

static int write_leaves(const Job02 *job, FILE *file)
{
    ReplayTree trees[N_SCENES];
    for (int k = 0; k < N_SCENES; k++) {
        const KdTree2D *tree = &job->scenes[k].tree;
        trees[k] = (ReplayTree){tree->n_nodes, tree->n_map};
    }
    return section_write(file, "pack", job->packs, sizeof job->packs) |
           replay_write_leaves(&job->replay, trees, N_SCENES, file);
}

// Is scene K's node as it must be: its leaf packed, or untouched?
static int node_is_right(const KdTree2D *tree, u32 id, NodeRel found, u8 flag)
{
    const int is_leaf = tree->nodes_flag[id] == LEAF;
    const NodeRel expected = is_leaf ? tree->nodes_Relations[id] : (NodeRel){.id = id};
    return flag == tree->nodes_flag[id] && memcmp(&found, &expected, sizeof found) == 0;
}

static int tree_is_packed(const KdTree2D *tree, int k, const Sections *answers)
{
    char name[SECTION_NAME_BYTES];
    const u32 *n_map = job_section_find(answers, "packed", k, sizeof *n_map);
    snprintf(name, sizeof name, "packed.%d.nodes", k);
    const NodeRel *nodes = sections_find(answers, name, tree->n_nodes * sizeof *nodes);
    snprintf(name, sizeof name, "packed.%d.flags", k);
    const u8 *flags = sections_find(answers, name, tree->n_nodes * sizeof *flags);
    snprintf(name, sizeof name, "packed.%d.map", k);
    const u32 *map = sections_find(answers, name, (tree->n_map + REPLAY_GUARD) * sizeof *map);
    int is_right = n_map != NULL && nodes != NULL && flags != NULL && map != NULL &&
                   *n_map == tree->n_map &&
                   memcmp(map, tree->mapNode2Circles, tree->n_map * sizeof *map) == 0;
    for (u32 id = 0; is_right && id < tree->n_nodes; id++) {
        is_right = node_is_right(tree, id, nodes[id], flags[id]);
    }
    for (int i = 0; is_right && i < REPLAY_GUARD; i++) {
        is_right = map[tree->n_map + (u32)i] == UNTOUCHED;
    }
    return is_right;
}

static int trees_are_packed(const Job02 *job, const Sections *answers)
{
    int is_right = 1;
    for (int k = 0; is_right && k < N_SCENES; k++) {
        is_right = tree_is_packed(&job->scenes[k].tree, k, answers);
    }
    return is_right;
}

// ---- All of it ----------------------------------------------------------------------------------

int judge_02_write_alone(const void *pointer, const char *task, FILE *file)
{
    const Job02 *job = pointer;
    if (strcmp(task, "is_leaf") == 0) {
        return section_write(file, "leaves", job->leaves, sizeof job->leaves) |
               write_leaf_calls(job, file);
    }
    if (strcmp(task, "split_box") == 0) {
        return section_write(file, "splits", job->splits, sizeof job->splits) |
               write_split_calls(job, file);
    }
    if (strcmp(task, "circle_overlaps_box") == 0) {
        return section_write(file, "overlaps", job->overlaps, sizeof job->overlaps) |
               write_overlap_calls(job, file);
    }
    return strcmp(task, "distribute") == 0 ? write_list_calls(job, file) : write_leaves(job, file);
}

int judge_02_passes_alone(const Job02 *job, int check, const Sections *answers)
{
    switch (check) {
    case TREE_LIMITS:
        return leaves_are_where_expected(job, answers);
    case TREE_CELLS:
        return cells_are_halved(job, answers);
    case TREE_OVERLAP:
        return overlaps_are_right(job, answers);
    case DISTRIBUTE_LIST:
        return distributes_rightly(job, answers);
    case TREE_LISTS:
        return replay_lists_are_right(&job->replay, answers, keeps, job);
    case TREE_PACKING:
        return trees_are_packed(job, answers);
    default:
        return 0;
    }
}

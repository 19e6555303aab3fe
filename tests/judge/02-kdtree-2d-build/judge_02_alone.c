// Lab 02: one task's answer alone (grader/alone.h). A whole tree takes the answers to all tasks, so
// in its place the one answer is called as the builder would call it: see replay.h.
#include "judge_02.h"

#include "oracle2d.h"
#include "oracle2d_tree.h"

#include <string.h>

// ---- is_leaf: once for each node ----------------------------------------------------------------

static void leaf_input(const void *pointer, ReplayCall call, void *input)
{
    const Job02 *job = pointer;
    const GrownNode *node = call.node;
    const KdTreeLimits limits = job->scenes[node->scene].limits;
    *(LeafJob *)input = (LeafJob){.level = node->level,
                                  .n_circles = node->n_ids,
                                  .maxDepth = limits.maxDepth,
                                  .targetElementsPerNode = limits.targetElementsPerNode,
                                  .n_failed = node->n_failed};
}

static int leaf_is_right(const void *job, ReplayCall call, const void *answer)
{
    (void)job;
    return *(const i32 *)answer == (call.node->first_child == 0);
}

const Replay replay_leaf_02 = {"replay.leaf", EACH_NODE,  sizeof(LeafJob),
                               sizeof(i32),   leaf_input, leaf_is_right};

// ---- split_box: once for each inner node --------------------------------------------------------

static void split_input(const void *job, ReplayCall call, void *input)
{
    (void)job;
    *(BBox2D *)input = oracle2d_box(call.node->cell);
}

static int is_cell(BBox2D box, BBox3D cell)
{
    return box.minX == cell.min[0] && box.maxX == cell.max[0] && box.minY == cell.min[1] &&
           box.maxY == cell.max[1];
}

static int split_is_right(const void *job, ReplayCall call, const void *answer)
{
    const BBox2D *halves = answer;
    (void)job;
    return is_cell(halves[0], grown_child(call.node, 0)->cell) &&
           is_cell(halves[1], grown_child(call.node, 1)->cell);
}

const Replay replay_split_02 = {"replay.split",     EACH_INNER_NODE, sizeof(BBox2D),
                                2 * sizeof(BBox2D), split_input,     split_is_right};

// ---- circle_overlaps_box: once for each circle of an inner node and each of its children --------

static BoxOverlapJob overlap_of(const Job02 *job, ReplayCall call)
{
    return (BoxOverlapJob){job->scenes[call.node->scene].scene.circles[call.id],
                           oracle2d_box(call.child->cell)};
}

static void overlap_input(const void *job, ReplayCall call, void *input)
{
    *(BoxOverlapJob *)input = overlap_of(job, call);
}

static int overlap_is_right(const void *job, ReplayCall call, const void *answer)
{
    const BoxOverlapJob in = overlap_of(job, call);
    return *(const i32 *)answer == oracle2d_overlaps_box(in.circle, in.box);
}

const Replay replay_overlap_02 = {"replay.overlap", EACH_ID_OF_A_CHILD, sizeof(BoxOverlapJob),
                                  sizeof(i32),      overlap_input,      overlap_is_right};

// ---- distribute: twice for each inner node ------------------------------------------------------

// The hole of circle_overlaps_box while another task is tried.
static int stub_overlaps(Circle circle, BBox2D box)
{
#include "02-kdtree-2d-build/circle_overlaps_box.c"
}

// What distribute makes of the stub. As ListKeeps of replay.h has it.
static int keeps(const void *pointer, u32 scene, u32 id, BBox3D cell)
{
    const Job02 *job = pointer;
    return stub_overlaps(job->scenes[scene].scene.circles[id], oracle2d_box(cell));
}

static void cell_input(const void *job, ReplayCall call, void *input)
{
    (void)job;
    *(BBox2D *)input = oracle2d_box(call.child->cell);
}

static const Replay cells = {"replay.cells", EACH_CHILD, sizeof(BBox2D), .input = cell_input};

// The children's cells, and all that the lists need. Returns 0, or -1.
static int write_list_calls(const Job02 *job, FILE *file)
{
    int result = replay_write(&cells, &job->job.growth, job, file) |
                 replay_write_lists(&job->job.growth, file) |
                 section_write(file, "distribute", job->distributes, sizeof job->distributes);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_write_circles(&job->scenes[k], k, file);
    }
    return result;
}

_Static_assert(REPLAY_ROOM(DISTRIBUTE_MAX_IDS) <= DISTRIBUTE_ROOM, "the guard is in the answer");
int distributes_alone_02(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const u32 *found = function_answers(check->function, answers);
    int is_right = found != NULL;
    for (int i = 0; is_right && i < N_DISTRIBUTES; i++) {
        is_right = list_is_right(list_call_02(job, i), keeps, job, found + i * DISTRIBUTE_ROOM);
    }
    return is_right;
}

int lists_alone_02(const void *pointer, const JudgeCheck *check, const Sections *answers)
{
    const Job02 *job = pointer;
    (void)check;
    return replay_lists_are_right(&job->job.growth, answers, keeps, job);
}

// ---- pack_leaf: once for each leaf --------------------------------------------------------------

static int write_leaves(const Job02 *job, FILE *file)
{
    ReplayTree trees[N_SCENES];
    for (int k = 0; k < N_SCENES; k++) {
        const KdTree2D *tree = &job->scenes[k].tree;
        trees[k] = (ReplayTree){tree->n_nodes, tree->n_map};
    }
    return replay_write_leaves(&job->job.growth, trees, N_SCENES, file);
}

// Is scene K's node as it must be: its leaf packed, or untouched?
static int node_is_right(const KdTree2D *tree, u32 id, NodeRel found, u8 flag)
{
    const int is_leaf = tree->nodes_flag[id] == LEAF;
    const NodeRel expected = is_leaf ? tree->nodes_Relations[id] : (NodeRel){.id = id};
    return flag == tree->nodes_flag[id] && memcmp(&found, &expected, sizeof found) == 0;
}

int packs_alone_02(const void *job, int k, const Sections *answers)
{
    const KdTree2D *tree = &((const Job02 *)job)->scenes[k].tree;
    const u32 n_nodes = tree->n_nodes, n_map = tree->n_map;
    const u32 *found_n_map = job_section_find(answers, "packed", k, sizeof *found_n_map);
    const NodeRel *nodes = job_part_find(answers, "packed", k, "nodes", n_nodes * sizeof *nodes);
    const u8 *flags = job_part_find(answers, "packed", k, "flags", n_nodes * sizeof *flags);
    const u32 *map =
        job_part_find(answers, "packed", k, "map", ((size_t)n_map + REPLAY_GUARD) * sizeof *map);
    int is_right = found_n_map != NULL && nodes != NULL && flags != NULL && map != NULL &&
                   *found_n_map == n_map &&
                   memcmp(map, tree->mapNode2Circles, n_map * sizeof *map) == 0 &&
                   guard_is_untouched(map + n_map);
    for (u32 id = 0; is_right && id < n_nodes; id++) {
        is_right = node_is_right(tree, id, nodes[id], flags[id]);
    }
    return is_right;
}

// ---- All of it ----------------------------------------------------------------------------------

int write_alone_02(const void *job, const char *task, FILE *file)
{
    return strcmp(task, "distribute") == 0  ? write_list_calls(job, file)
           : strcmp(task, "pack_leaf") == 0 ? write_leaves(job, file)
                                            : 0;
}

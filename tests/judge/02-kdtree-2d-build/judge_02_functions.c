// Lab 02: each function on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "overlap_cause.h"
#include "packed_list.h"
#include "words.h"

#include <string.h>

// ---- is_leaf ------------------------------------------------------------------------------------

// What is right where so many bits of the number of circles are looked at.
static int leaf_expected(LeafJob in, u32 bits)
{
    const KdTreeLimits limits = {in.maxDepth, in.targetElementsPerNode};
    return oracle_is_leaf(in.level, in.n_circles & bits, in.n_failed, limits);
}

static int is_cut_to(const Job02 *job, const i32 *found, u32 bits)
{
    int i = 0;
    while (i < N_LEAVES && (found[i] != 0) == leaf_expected(job->leaves[i], bits)) {
        i++;
    }
    return i == N_LEAVES;
}

static Diagnosis leaf_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const LeafJob in = job->leaves[i];
    const i32 *found = answers;
    const int expected = leaf_expected(in, ~0u);
    if ((found[i] != 0) == expected) {
        return NOTHING_WRONG;
    }
    const char *looks =
        is_cut_to(job, found, 0xff)     ? "your answers are those of a count cut to 8 bits"
        : is_cut_to(job, found, 0xffff) ? "your answers are those of a count cut to 16 bits"
                                        : NULL;
    return diagnosis_of(message_new("level %d, %u circles, %d failed splits, maxDepth %d, "
                                    "targetElementsPerNode %d: found %d, expected %d",
                                    in.level, in.n_circles, in.n_failed, in.maxDepth,
                                    in.targetElementsPerNode, found[i], expected),
                        (Cause){.says = looks});
}

const Function is_leaf_02 = {"leaves", N_LEAVES, sizeof(i32), .fault = leaf_fault};

// ---- split_box ----------------------------------------------------------------------------------

static int is_box(BBox2D a, BBox2D b)
{
    return a.minX == b.minX && a.maxX == b.maxX && a.minY == b.minY && a.maxY == b.maxY;
}

// Which side was split: 'x', 'y', or '?' when neither was, or both.
static int split_side(const BBox2D found[2])
{
    const int x = found[0].minX != found[1].minX || found[0].maxX != found[1].maxX;
    const int y = found[0].minY != found[1].minY || found[0].maxY != found[1].maxY;
    return x && !y ? 'x' : y && !x ? 'y' : '?';
}

// The halves of a box that is split across this side, x or y.
static void halve(BBox2D box, int side, BBox2D halves[2])
{
    halves[0] = halves[1] = box;
    if (side == 'x') {
        halves[0].maxX = halves[1].minX = (float)(((double)box.minX + box.maxX) / 2);
    } else {
        halves[0].maxY = halves[1].minY = (float)(((double)box.minY + box.maxY) / 2);
    }
}

static int longer_side(BBox2D box)
{
    return (double)box.maxX - box.minX >= (double)box.maxY - box.minY ? 'x' : 'y';
}

static Diagnosis describe_split(BBox2D box, const BBox2D found[2], const BBox2D expected[2],
                                const char *why)
{
    return diagnosis_of(message_new("box %s: found left %s and right %s, expected left %s",
                                    words_box2d(box).text, words_box2d(found[0]).text,
                                    words_box2d(found[1]).text, words_box2d(expected[0]).text),
                        (Cause){.says = why});
}

// Why a side is the wrong one.
static const char *explain_side(BBox2D box, int side)
{
    const double width = (double)box.maxX - box.minX, height = (double)box.maxY - box.minY;
    const double apart = width - height;
    return side == '?'  ? "nothing was split, or both sides"
           : apart == 0 ? "where both sides are equal, x is split"
           : -apart < height / 1024 && apart < width / 1024
               ? "the sides are not equal, if nearly, and the longer one is split"
               : "the shorter side was split";
}

static Diagnosis split_longer_fault(const void *pointer, int i, const void *answers)
{
    const BBox2D box = ((const Job02 *)pointer)->splits[i];
    const BBox2D *found = (const BBox2D *)answers + 2 * i;
    const int longer = longer_side(box), side = split_side(found);
    BBox2D expected[2];
    halve(box, longer, expected);
    return side == longer ? NOTHING_WRONG
                          : describe_split(box, found, expected, explain_side(box, side));
}

// Where along the side that the student has split, be it the right one or not.
static Diagnosis split_middle_fault(const void *pointer, int i, const void *answers)
{
    const BBox2D box = ((const Job02 *)pointer)->splits[i];
    const BBox2D *found = (const BBox2D *)answers + 2 * i;
    const int side = split_side(found);
    BBox2D expected[2];
    halve(box, side == '?' ? longer_side(box) : side, expected);
    if (is_box(found[0], expected[0]) && is_box(found[1], expected[1])) {
        return NOTHING_WRONG;
    }
    const int swapped = is_box(found[0], expected[1]) && is_box(found[1], expected[0]);
    return describe_split(box, found, expected, swapped ? "left and right are swapped" : NULL);
}

const Function split_longer_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  .fault = split_longer_fault};
const Function split_middle_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  .fault = split_middle_fault};

// ---- circle_overlaps_box ------------------------------------------------------------------------

// As overlap_cause.h has it.
static Reach reach_of(const void *job, int i)
{
    const BoxOverlapJob in = ((const Job02 *)job)->overlaps[i];
    return (Reach){{outside_of(in.circle.x, in.box.minX, in.box.maxX),
                    outside_of(in.circle.y, in.box.minY, in.box.maxY)},
                   in.circle.radius};
}

static Cause explain_overlap(const Job02 *job, int i, const i32 *found)
{
    const Cause cause = overlap_cause(reach_of, job, N_OVERLAPS, found);
    if (cause.says == NULL && found[i] && overlap_is_of_box(reach_of, job, N_OVERLAPS, found)) {
        return (Cause){.says = "the circle's bounding square overlaps, the circle does not"};
    }
    return cause;
}

static Diagnosis overlap_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const BoxOverlapJob in = job->overlaps[i];
    const i32 *found = answers;
    const int expected = oracle2d_overlaps_box(in.circle, in.box);
    return (found[i] != 0) == expected
               ? NOTHING_WRONG
               : diagnosis_of(message_new("circle at %s, box %s: found %d, expected %d",
                                          words_circle(in.circle).text, words_box2d(in.box).text,
                                          found[i], expected),
                              explain_overlap(job, i, found));
}

const Function overlap_02 = {"overlaps", N_OVERLAPS, sizeof(i32), .fault = overlap_fault};

// ---- distribute ---------------------------------------------------------------------------------

ListCall list_call_02(const Job02 *job, int i)
{
    const DistributeJob *in = &job->distributes[i];
    return (ListCall){DISTRIBUTE_SCENE, in->ids, in->n_ids, oracle2d_cell(in->child)};
}

// As ListKeeps of replay.h has it.
static int keeps(const void *job, u32 scene, u32 id, BBox3D cell)
{
    return oracle2d_overlaps_box(((const Job02 *)job)->scenes[scene].scene.circles[id],
                                 oracle2d_box(cell));
}

static int is_equal_circle(Circle a, Circle b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

// Is a circle in the list, or one that is equal to it? Says which: its id, or -1.
static int64_t listed_as(const Job02 *job, u32 id, const u32 *list, u32 n)
{
    const Circle *circles = job->scenes[DISTRIBUTE_SCENE].scene.circles;
    for (u32 i = 0; i < n; i++) {
        if (list[i] == id ||
            (list[i] < DISTRIBUTE_MAX_IDS && is_equal_circle(circles[id], circles[list[i]]))) {
            return list[i];
        }
    }
    return -1;
}

// Lists in which all that is wrong is that circles are missing: those that are equal to others, or
// those behind some place. NULL for other lists; owned by the caller.
static char *explain_list(const Job02 *job, ListCall call, const u32 *found)
{
    const u32 n = found[0] < call.n_ids ? found[0] : call.n_ids;
    int is_start = 1, are_equal = 1;
    u32 n_kept = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (keeps(job, call.scene, call.ids[i], call.cell)) {
            is_start = is_start && (n_kept >= n || found[1 + n_kept] == call.ids[i]);
            are_equal = are_equal && listed_as(job, call.ids[i], found + 1, n) >= 0;
            n_kept++;
        }
    }
    return n >= n_kept ? NULL
           : are_equal ? message_new("circles that are equal are all listed")
           : is_start && n > 0
               ? message_new("the list ends after %u ids, and there is room for more", n)
               : NULL;
}

static Diagnosis distribute_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const ListCall call = list_call_02(job, i);
    const u32 *found = (const u32 *)answers + i * DISTRIBUTE_ROOM;
    Diagnosis wrong = list_fault("circle", call, keeps, job, found);
    if (wrong.found != NULL && wrong.cause == NULL) {
        wrong.cause = explain_list(job, call, found);
    }
    return wrong;
}

const Function distribute_02 = {"distribute", N_DISTRIBUTES, DISTRIBUTE_ROOM * sizeof(u32),
                                .fault = distribute_fault};

// ---- pack_leaf ----------------------------------------------------------------------------------

static Diagnosis pack_offset_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    const u32 offset = out->relations[in->id].circleMapOffset;
    return offset == in->n_map
               ? NOTHING_WRONG
               : diagnosis_new(
                     "leaf with %u circles, map of %u entries: circleMapOffset is %u, expected "
                     "%u, the place of the count",
                     in->n_ids, in->n_map, offset, in->n_map);
}

static Diagnosis pack_count_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    const u32 count = out->map[in->n_map];
    if (count == UNTOUCHED) {
        return diagnosis_new("leaf with %u circles, map of %u entries: mapNode2Circles[%u] was not "
                             "written, expected the count",
                             in->n_ids, in->n_map, in->n_map);
    }
    return count == in->n_ids
               ? NOTHING_WRONG
               : diagnosis_of(message_new("leaf with %u circles, map of %u entries: the count at "
                                          "%u is %u, expected %u",
                                          in->n_ids, in->n_map, in->n_map, count, in->n_ids),
                              number_cause(count, in->n_ids));
}

// The leaf's ids, and what else is in the map.
static Diagnosis map_fault(const PackJob *in, const PackAnswer *out)
{
    const u32 *list = out->map + in->n_map + 1;
    for (u32 j = 0; j < in->n_ids; j++) {
        if (list[j] == UNTOUCHED) {
            return diagnosis_new("leaf with %u circles: id number %u was not written, expected %u",
                                 in->n_ids, j, in->ids[j]);
        }
        if (list[j] != in->ids[j]) {
            return diagnosis_of(message_new("leaf with %u circles: id number %u is %u, expected %u",
                                            in->n_ids, j, list[j], in->ids[j]),
                                list_cause(list, in->ids, in->n_ids));
        }
    }
    if (out->n_map != in->n_map + 1 + in->n_ids) {
        return diagnosis_new(
            "leaf with %u circles, map of %u entries: n_map is %u afterwards, expected "
            "%u",
            in->n_ids, in->n_map, out->n_map, in->n_map + 1 + in->n_ids);
    }
    for (u32 j = 0; j < PACK_MAP_ROOM; j++) {
        const int is_list = j >= in->n_map && j < in->n_map + 1 + in->n_ids;
        if (!is_list && out->map[j] != UNTOUCHED) {
            return diagnosis_new("mapNode2Circles[%u] was written, but the list goes from %u to %u",
                                 j, in->n_map, in->n_map + in->n_ids);
        }
    }
    return NOTHING_WRONG;
}

// Is a node as it was, but for the leaf's flag and circleMapOffset?
static Diagnosis node_fault(const PackJob *in, const PackAnswer *out, u32 id)
{
    const NodeRel node = out->relations[id];
    const int is_leaf = id == in->id;
    const struct {
        const char *array, *field;
        u32 found, expected;
    } fields[] = {
        {"nodes_Relations", ".id", node.id, id},
        {"nodes_Relations", ".lChild", node.lChild, 0},
        {"nodes_Relations", ".rChild", node.rChild, 0},
        {"nodes_Relations", ".circleMapOffset", is_leaf ? 0 : node.circleMapOffset, 0},
        {"nodes_flag", "", is_leaf ? INNER : out->flags[id], INNER},
    };
    for (int f = 0; f < COUNT(fields); f++) {
        if (fields[f].found != fields[f].expected) {
            return diagnosis_new("packing leaf %u changed %s[%u]%s to %u, expected it to stay %u",
                                 in->id, fields[f].array, id, fields[f].field, fields[f].found,
                                 fields[f].expected);
        }
    }
    return is_box(out->boxes[id], PACK_CELL(id))
               ? NOTHING_WRONG
               : diagnosis_new("packing leaf %u changed nodes_BBox[%u] to %s, expected it to stay "
                               "%s",
                               in->id, id, words_box2d(out->boxes[id]).text,
                               words_box2d(PACK_CELL(id)).text);
}

static Diagnosis pack_rest_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    if (out->flags[in->id] != LEAF) {
        return diagnosis_new("nodes_flag[%u] is %u, expected LEAF", in->id, out->flags[in->id]);
    }
    Diagnosis wrong = map_fault(in, out);
    for (u32 id = 0; wrong.found == NULL && id < PACK_NODES; id++) {
        wrong = node_fault(in, out, id);
    }
    if (wrong.found == NULL && out->n_nodes != PACK_NODES) {
        wrong = diagnosis_new("packing leaf %u changed n_nodes to %u, expected it to stay %d",
                              in->id, out->n_nodes, PACK_NODES);
    }
    return wrong;
}

const Function pack_count_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_count_fault};
const Function pack_offset_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_offset_fault};
const Function pack_rest_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_rest_fault};

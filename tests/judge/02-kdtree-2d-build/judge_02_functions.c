// Lab 02: each function on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "words.h"

// ---- is_leaf ------------------------------------------------------------------------------------

static Diagnosis leaf_fault(const void *pointer, int i, const void *answers)
{
    const LeafJob in = ((const Job02 *)pointer)->leaves[i];
    const KdTreeLimits limits = {in.maxDepth, in.targetElementsPerNode};
    const int expected = oracle_is_leaf(in.level, in.n_circles, in.n_failed, limits);
    const i32 found = ((const i32 *)answers)[i];
    return (found != 0) == expected
               ? NOTHING_WRONG
               : diagnosis_new("level %d, %u circles, %d failed splits, maxDepth %d, "
                               "targetElementsPerNode %d: found %d, expected %d",
                               in.level, in.n_circles, in.n_failed, in.maxDepth,
                               in.targetElementsPerNode, found, expected);
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

static Diagnosis split_longer_fault(const void *pointer, int i, const void *answers)
{
    const BBox2D box = ((const Job02 *)pointer)->splits[i];
    const BBox2D *found = (const BBox2D *)answers + 2 * i;
    const int longer = longer_side(box), side = split_side(found);
    BBox2D expected[2];
    halve(box, longer, expected);
    return side == longer
               ? NOTHING_WRONG
               : describe_split(box, found, expected,
                                side == '?' ? "nothing was split, or both sides"
                                : (double)box.maxX - box.minX == (double)box.maxY - box.minY
                                    ? "where both sides are equal, x is split"
                                    : "the shorter side was split");
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

// Do circle and box touch, and no more? On the inputs' grid one that is this much smaller is
// outside then.
static int is_touching(BoxOverlapJob in)
{
    Circle smaller = in.circle;
    smaller.radius -= 1e-3f;
    return oracle2d_overlaps_box(in.circle, in.box) && !oracle2d_overlaps_box(smaller, in.box);
}

// Is all that is wrong, in any check, that touching does not count?
static int is_strict(const Job02 *job, const i32 *found)
{
    for (int i = 0; i < N_OVERLAPS; i++) {
        const BoxOverlapJob in = job->overlaps[i];
        const int expected = oracle2d_overlaps_box(in.circle, in.box);
        if ((found[i] != 0) != expected && !(expected && is_touching(in))) {
            return 0;
        }
    }
    return 1;
}

static Cause explain_overlap(const Job02 *job, int i, const i32 *found)
{
    const BBox2D box = job->overlaps[i].box;
    const Circle c = job->overlaps[i].circle;
    if (!found[i] && is_strict(job, found)) {
        return (Cause){"they touch, and touching counts: both have their boundaries",
                       MISTAKE_STRICT_BOUNDARY};
    }
    const int square = c.x + c.radius >= box.minX && c.x - c.radius <= box.maxX &&
                       c.y + c.radius >= box.minY && c.y - c.radius <= box.maxY;
    return (Cause){.says = found[i] && square
                               ? "the circle's bounding square overlaps, the circle does not"
                               : NULL};
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
    return (ListCall){0, in->ids, in->n_ids, oracle2d_cell(in->child)};
}

// As ListKeeps of replay.h has it.
static int keeps(const void *job, u32 scene, u32 id, BBox3D cell)
{
    return oracle2d_overlaps_box(((const Job02 *)job)->scenes[scene].scene.circles[id],
                                 oracle2d_box(cell));
}

static Diagnosis distribute_fault(const void *job, int i, const void *answers)
{
    return list_fault("circle", list_call_02(job, i), keeps, job,
                      (const u32 *)answers + i * DISTRIBUTE_ROOM);
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
               : diagnosis_new("leaf with %u circles, map of %u entries: the count at %u "
                               "is %u, expected %u",
                               in->n_ids, in->n_map, in->n_map, count, in->n_ids);
}

static Diagnosis pack_rest_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    if (out->flags[in->id] != LEAF) {
        return diagnosis_new("nodes_flag[%u] is %u, expected LEAF", in->id, out->flags[in->id]);
    }
    for (u32 j = 0; j < in->n_ids; j++) {
        const u32 found = out->map[in->n_map + 1 + j];
        if (found == UNTOUCHED) {
            return diagnosis_new("leaf with %u circles: id number %u was not written, expected %u",
                                 in->n_ids, j, in->ids[j]);
        }
        if (found != in->ids[j]) {
            return diagnosis_new("leaf with %u circles: id number %u is %u, expected %u", in->n_ids,
                                 j, found, in->ids[j]);
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
    for (u32 id = 0; id < PACK_NODES; id++) {
        const NodeRel node = out->relations[id];
        if (node.id != id || node.lChild != 0 || node.rChild != 0 ||
            (id != in->id && (node.circleMapOffset != 0 || out->flags[id] != INNER))) {
            return diagnosis_new("packing leaf %u changed node %u otherwise than it should", in->id,
                                 id);
        }
    }
    return NOTHING_WRONG;
}

const Function pack_count_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_count_fault};
const Function pack_offset_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_offset_fault};
const Function pack_rest_02 = {"pack", N_PACKS, sizeof(PackAnswer), .fault = pack_rest_fault};

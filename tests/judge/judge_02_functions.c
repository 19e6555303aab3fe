// Lab 02: each function on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"

Verdict judge_02_is_leaf(const Job02 *job, int first, const Sections *answers)
{
    const i32 *found = sections_find(answers, "leaves", N_LEAVES * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = first; i < N_LEAVES; i += 3) {
        const LeafJob in = job->leaves[i];
        const int expected =
            oracle2d_is_leaf(in.level, in.n_circles, in.n_failed,
                             (KdTreeLimits){in.maxDepth, in.targetElementsPerNode});
        if ((found[i] != 0) != expected) {
            return verdict_of(message_new(
                "level %d, %u circles, %d failed splits, maxDepth %d, targetElementsPerNode "
                "%d: found %d, expected %d",
                in.level, in.n_circles, in.n_failed, in.maxDepth, in.targetElementsPerNode,
                found[i], expected));
        }
    }
    return verdict_of(NULL);
}

static char *describe_split(BBox2D box, const BBox2D found[2], const BBox2D expected[2],
                            const char *why)
{
    return message_new(
        "box x [%g, %g] y [%g, %g]: found left x [%g, %g] y [%g, %g] and right x [%g, "
        "%g] y [%g, %g], expected left x [%g, %g] y [%g, %g]%s",
        (double)box.minX, (double)box.maxX, (double)box.minY, (double)box.maxY,
        (double)found[0].minX, (double)found[0].maxX, (double)found[0].minY, (double)found[0].maxY,
        (double)found[1].minX, (double)found[1].maxX, (double)found[1].minY, (double)found[1].maxY,
        (double)expected[0].minX, (double)expected[0].maxX, (double)expected[0].minY,
        (double)expected[0].maxY, why);
}

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

Verdict judge_02_split(const Job02 *job, int check, const Sections *answers)
{
    const BBox2D *found = sections_find(answers, "splits", 2 * N_SPLITS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_SPLITS; i++) {
        const BBox2D box = job->splits[i];
        const double width = (double)box.maxX - box.minX, height = (double)box.maxY - box.minY;
        const int longer = width >= height ? 'x' : 'y';
        const int side = split_side(found + 2 * i);
        BBox2D expected[2] = {box, box};
        // Which side is the one check, where along it the other: that one follows the student's
        // side.
        if ((check == SPLIT_LONGER || side == '?' ? longer : side) == 'x') {
            expected[0].maxX = expected[1].minX = (float)(box.minX + width / 2);
        } else {
            expected[0].maxY = expected[1].minY = (float)(box.minY + height / 2);
        }
        if (check == SPLIT_LONGER && side != longer) {
            return verdict_of(describe_split(box, found + 2 * i, expected,
                                             side == '?' ? "; nothing was split, or both sides"
                                             : width == height
                                                 ? "; where both sides are equal, x is split"
                                                 : "; the shorter side was split"));
        }
        if (check == SPLIT_MIDDLE &&
            (!is_box(found[2 * i], expected[0]) || !is_box(found[2 * i + 1], expected[1]))) {
            const int swapped =
                is_box(found[2 * i], expected[1]) && is_box(found[2 * i + 1], expected[0]);
            return verdict_of(describe_split(box, found + 2 * i, expected,
                                             swapped ? "; left and right are swapped" : ""));
        }
    }
    return verdict_of(NULL);
}

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

static const char *explain_overlap(const Job02 *job, int i, const i32 *found)
{
    const BBox2D box = job->overlaps[i].box;
    const Circle c = job->overlaps[i].circle;
    if (!found[i]) {
        return is_strict(job, found)
                   ? "; they touch, and touching counts: both have their boundaries"
                   : "";
    }
    const int square = c.x + c.radius >= box.minX && c.x - c.radius <= box.maxX &&
                       c.y + c.radius >= box.minY && c.y - c.radius <= box.maxY;
    return square ? "; the circle's bounding square overlaps, the circle does not" : "";
}

Verdict judge_02_overlaps(const Job02 *job, int first, int n, const Sections *answers)
{
    const i32 *found = sections_find(answers, "overlaps", N_OVERLAPS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = first; i < first + n; i++) {
        const BoxOverlapJob in = job->overlaps[i];
        const int expected = oracle2d_overlaps_box(in.circle, in.box);
        if ((found[i] != 0) != expected) {
            return verdict_of(message_new(
                "circle at (%g, %g) radius %g, box x [%g, %g] y [%g, %g]: found %d, expected %d%s",
                (double)in.circle.x, (double)in.circle.y, (double)in.circle.radius,
                (double)in.box.minX, (double)in.box.maxX, (double)in.box.minY, (double)in.box.maxY,
                found[i], expected, explain_overlap(job, i, found)));
        }
    }
    return verdict_of(NULL);
}

// Says that an id that belongs into a child's list is nowhere in it; "" when it is.
static const char *explain_missing(const DistributeJob *in, const u32 *list, u32 id)
{
    for (u32 i = 0; i < in->n_ids; i++) {
        if (list[i] == id) {
            return "";
        }
    }
    return ", that circle overlaps the cell and is missing in its list";
}

Verdict judge_02_distribute(const Job02 *job, const Sections *answers)
{
    const u32 *found =
        sections_find(answers, "distribute", N_DISTRIBUTES * DISTRIBUTE_ROOM * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_DISTRIBUTES; i++, found += DISTRIBUTE_ROOM) {
        const DistributeJob *in = &job->distributes[i];
        u32 n = 0;
        for (u32 j = 0; j < in->n_ids; j++) {
            const u32 id = in->ids[j];
            if (!oracle2d_overlaps_box(job->scenes[0].scene.circles[id], in->child)) {
                continue;
            }
            if (found[1 + n] == UNTOUCHED) {
                return verdict_of(
                    message_new("node with %u circles from id %u on: child_ids[%u] was not "
                                "written, expected %u%s",
                                in->n_ids, in->ids[0], n, id, explain_missing(in, found + 1, id)));
            }
            if (found[1 + n] != id) {
                return verdict_of(
                    message_new("node with %u circles from id %u on: child_ids[%u] is "
                                "%u, expected %u%s",
                                in->n_ids, in->ids[0], n, found[1 + n], id,
                                found[1 + n] == j ? "; that is its position in ids[]"
                                                  : explain_missing(in, found + 1, id)));
            }
            n++;
        }
        if (found[0] != n) {
            return verdict_of(
                message_new("node with %u circles from id %u on: returned %u, expected "
                            "%u: the number of ids written",
                            in->n_ids, in->ids[0], found[0], n));
        }
        if (found[1 + in->n_ids] != UNTOUCHED) {
            return verdict_of(message_new("child_ids[%u] was written, but there is room for %u",
                                          in->n_ids, in->n_ids));
        }
    }
    return verdict_of(NULL);
}

static char *judge_pack_offset(const PackJob *in, const PackAnswer *out)
{
    const u32 offset = out->relations[in->id].circleMapOffset;
    return offset == in->n_map
               ? NULL
               : message_new(
                     "leaf with %u circles, map of %u entries: circleMapOffset is %u, expected "
                     "%u, the place of the count",
                     in->n_ids, in->n_map, offset, in->n_map);
}

static char *judge_pack_count(const PackJob *in, const PackAnswer *out)
{
    const u32 count = out->map[in->n_map];
    if (count == UNTOUCHED) {
        return message_new("leaf with %u circles, map of %u entries: mapNode2Circles[%u] was not "
                           "written, expected the count",
                           in->n_ids, in->n_map, in->n_map);
    }
    return count == in->n_ids
               ? NULL
               : message_new("leaf with %u circles, map of %u entries: the count at %u "
                             "is %u, expected %u",
                             in->n_ids, in->n_map, in->n_map, count, in->n_ids);
}

static char *judge_pack_rest(const PackJob *in, const PackAnswer *out)
{
    if (out->flags[in->id] != LEAF) {
        return message_new("nodes_flag[%u] is %u, expected LEAF", in->id, out->flags[in->id]);
    }
    for (u32 i = 0; i < in->n_ids; i++) {
        const u32 found = out->map[in->n_map + 1 + i];
        if (found == UNTOUCHED) {
            return message_new("leaf with %u circles: id number %u was not written, expected %u",
                               in->n_ids, i, in->ids[i]);
        }
        if (found != in->ids[i]) {
            return message_new("leaf with %u circles: id number %u is %u, expected %u", in->n_ids,
                               i, found, in->ids[i]);
        }
    }
    if (out->n_map != in->n_map + 1 + in->n_ids) {
        return message_new(
            "leaf with %u circles, map of %u entries: n_map is %u afterwards, expected "
            "%u",
            in->n_ids, in->n_map, out->n_map, in->n_map + 1 + in->n_ids);
    }
    for (u32 i = 0; i < PACK_MAP_ROOM; i++) {
        const int is_list = i >= in->n_map && i < in->n_map + 1 + in->n_ids;
        if (!is_list && out->map[i] != UNTOUCHED) {
            return message_new("mapNode2Circles[%u] was written, but the list goes from %u to %u",
                               i, in->n_map, in->n_map + in->n_ids);
        }
    }
    for (u32 id = 0; id < PACK_NODES; id++) {
        const NodeRel node = out->relations[id];
        if (node.id != id || node.lChild != 0 || node.rChild != 0 ||
            (id != in->id && (node.circleMapOffset != 0 || out->flags[id] != INNER))) {
            return message_new("packing leaf %u changed node %u otherwise than it should", in->id,
                               id);
        }
    }
    return NULL;
}

Verdict judge_02_pack(const Job02 *job, int check, const Sections *answers)
{
    const PackAnswer *found = sections_find(answers, "pack", N_PACKS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_PACKS; i++) {
        const PackJob *in = &job->packs[i];
        char *message = check == PACK_COUNT    ? judge_pack_count(in, &found[i])
                        : check == PACK_OFFSET ? judge_pack_offset(in, &found[i])
                                               : judge_pack_rest(in, &found[i]);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

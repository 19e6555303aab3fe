// The right answers to what a task of labs 02 and 06 is tried on alone (judge/shared/replay.h).
//
// They come from the solutions of the labs, and lists from the rules of lab 02's stub: its
// squares are written once more here. Read next: test_replays.c.
#ifndef UNIT_RIGHT_ANSWERS_REPLAYS_H
#define UNIT_RIGHT_ANSWERS_REPLAYS_H

#include "jobs_02.h"
#include "jobs_06.h"
#include "kdtree2d_build.h"
#include "kdtree3d_build.h"
#include "right_answers_sections.h"
#include "surroundings.h"

// ---- Right answers ------------------------------------------------------------------------------

// The job's section, NULL when it does not ask for that, and how many elements it has.
static const void *asked(const Sections *job, const char *name, size_t element_size, size_t *n)
{
    size_t n_bytes = 0;
    const void *bytes = sections_find_any(job, name, &n_bytes);
    *n = bytes != NULL ? n_bytes / element_size : 0;
    return bytes;
}

static inline void answer_leaves(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const LeafJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = is_leaf(in[i].level, in[i].n_circles, in[i].n_failed,
                         (KdTreeLimits){in[i].maxDepth, in[i].targetElementsPerNode});
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static inline void answer_halves(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BBox2D *in = asked(job, name, sizeof *in, &n);
    BBox2D *out = calloc(2 * n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        split_box(in[i], &out[2 * i], &out[2 * i + 1]);
    }
    answer(writer, name, out, 2 * n * sizeof *out);
    free(out);
}

static inline void answer_planes(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BBox3D *in = asked(job, name, sizeof *in, &n);
    KdSplit *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = choose_split(in[i]);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static inline void answer_circles(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BoxOverlapJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = circle_overlaps_box(in[i].circle, in[i].box);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static inline void answer_spheres(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const SphereBoxJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = sphere_overlaps_box(in[i].sphere, in[i].box);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static inline void answer_levels(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const LevelJob *levels = asked(job, name, sizeof *levels, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = fits_todo((int)levels[i]);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

// ---- Lists, by the stub ---------------------------------------------------------------------

// Are two intervals in touch on an axis?
static inline int in_touch(float centre, float reach, float min, float max)
{
    return centre + reach >= min && centre - reach <= max;
}

// The list of a child with its number in front, as the probe has it.
//   out[n_room]   where it goes, and what stays as it was
static inline void list_child(const Circle *circles, const u32 *ids, u32 n_ids, BBox2D cell,
                              u32 *out, size_t n_room)
{
    u32 n = 0;
    for (size_t i = 0; i < n_room; i++) {
        out[i] = UNTOUCHED;
    }
    for (u32 i = 0; i < n_ids; i++) {
        const Circle c = circles[ids[i]];
        if (in_touch(c.x, c.radius, cell.minX, cell.maxX) &&
            in_touch(c.y, c.radius, cell.minY, cell.maxY)) {
            out[1 + n++] = ids[i];
        }
    }
    out[0] = n;
}

static inline void answer_lists(Writer *writer, const Sections *job)
{
    size_t n, n_other;
    const DistributeJob *nodes = asked(job, "distribute", sizeof *nodes, &n);
    u32(*rooms)[DISTRIBUTE_ROOM] = calloc(n, sizeof *rooms);
    for (size_t i = 0; i < n; i++) {
        const Circle *circles =
            asked(job, numbered("scene", DISTRIBUTE_SCENE, "circles"), 1, &n_other);
        list_child(circles, nodes[i].ids, nodes[i].n_ids, nodes[i].child, rooms[i],
                   DISTRIBUTE_ROOM);
    }
    answer(writer, "distribute", rooms, n * sizeof *rooms);
    free(rooms);

    const ReplayList *lists = asked(job, "replay.lists", sizeof *lists, &n);
    const BBox2D *cells = asked(job, "replay.cells", sizeof *cells, &n_other);
    cr_assert_eq(n, n_other);
    const u32 *ids = asked(job, "replay.ids", sizeof *ids, &n_other);
    size_t n_answered = 0;
    for (size_t i = 0; i < n; i++) {
        cr_assert_leq(lists[i].first_id + lists[i].n_ids, n_other);
        n_answered += REPLAY_ROOM(lists[i].n_ids);
    }
    u32 *out = calloc(n_answered, sizeof *out), *next = out;
    for (size_t i = 0; i < n; i++) {
        const Circle *circles =
            asked(job, numbered("scene", (int)lists[i].scene, "circles"), 1, &n_other);
        list_child(circles, ids + lists[i].first_id, lists[i].n_ids, cells[i], next,
                   REPLAY_ROOM(lists[i].n_ids));
        next += REPLAY_ROOM(lists[i].n_ids);
    }
    answer(writer, "replay.lists", out, n_answered * sizeof *out);
    free(out);
}

// ---- Leaves -------------------------------------------------------------------------------------

// Of the checks of packing only that of whole trees is answered: the others are in test_judges.
static inline void answer_packed(Writer *writer, const Sections *job, int is_3d)
{
    size_t n_trees, n, n_ids, at = 0;
    const ReplayTree *trees = asked(job, "replay.trees", sizeof *trees, &n_trees);
    const ReplayList *leaves = asked(job, "replay.leaves", sizeof *leaves, &n);
    const u32 *ids = asked(job, "replay.ids", sizeof *ids, &n_ids);
    for (u32 k = 0; k < n_trees; k++) {
        const size_t room = (size_t)trees[k].n_entries + REPLAY_GUARD;
        NodeRel *relations = calloc(trees[k].n_nodes, sizeof *relations);
        u8 *flags = calloc(trees[k].n_nodes, sizeof *flags);
        KdNode3 *nodes = calloc(trees[k].n_nodes, sizeof *nodes);
        u32 *map = calloc(room, sizeof *map);
        for (u32 id = 0; id < trees[k].n_nodes; id++) {
            relations[id].id = id;
            flags[id] = INNER;
            nodes[id] = PACK_NODE;
        }
        for (size_t i = 0; i < room; i++) {
            map[i] = UNTOUCHED;
        }
        KdTree2D flat = {relations, flags, NULL, map, trees[k].n_nodes, 0};
        KdTree3D deep = {.nodes = nodes, .sphere_ids = map, .n_nodes = trees[k].n_nodes};
        for (; at < n && leaves[at].scene == k; at++) {
            const ReplayList leaf = leaves[at];
            if (is_3d) {
                pack_leaf_range(&deep, leaf.node, ids + leaf.first_id, leaf.n_ids);
            } else {
                pack_leaf(&flat, leaf.node, ids + leaf.first_id, leaf.n_ids);
            }
        }
        const u32 end = is_3d ? deep.n_sphere_ids : flat.n_map;
        answer(writer, numbered("packed", (int)k, NULL), &end, sizeof end);
        answer(writer, numbered("packed", (int)k, "nodes"), is_3d ? (void *)nodes : relations,
               trees[k].n_nodes * sizeof(NodeRel));
        if (!is_3d) {
            answer(writer, numbered("packed", (int)k, "flags"), flags, trees[k].n_nodes);
        }
        answer(writer, numbered("packed", (int)k, "map"), map, room * sizeof *map);
        free(relations);
        free(flags);
        free(nodes);
        free(map);
    }
    cr_assert_eq(at, n);
}
_Static_assert(sizeof(NodeRel) == sizeof(KdNode3), "answered alike");

// ---- All of a job -------------------------------------------------------------------------------

static inline Sections right_answers_to(const Sections *job, int is_3d)
{
    Writer writer;
    size_t n;
    writer_open(&writer);
    if (asked(job, "replay.leaf", 1, &n)) {
        answer_leaves(&writer, job, "leaves");
        answer_leaves(&writer, job, "replay.leaf");
    } else if (asked(job, "replay.split", 1, &n)) {
        (is_3d ? answer_planes : answer_halves)(&writer, job, "splits");
        (is_3d ? answer_planes : answer_halves)(&writer, job, "replay.split");
    } else if (asked(job, "replay.overlap", 1, &n)) {
        (is_3d ? answer_spheres : answer_circles)(&writer, job, "overlaps");
        (is_3d ? answer_spheres : answer_circles)(&writer, job, "replay.overlap");
    } else if (asked(job, "replay.lists", 1, &n)) {
        answer_lists(&writer, job);
    } else if (asked(job, "replay.leaves", 1, &n)) {
        answer_packed(&writer, job, is_3d);
    } else {
        answer_levels(&writer, job, "todo");
        answer_levels(&writer, job, "replay.todo");
    }
    return writer_close(&writer);
}

#endif

// Lab 02: distribute and pack_leaf on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "words.h"

#include <string.h>

// ---- distribute: right --------------------------------------------------------------------------

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

// The number that was returned, then the list.
#define GIVEN                                                                                      \
    const Job02 *all = job;                                                                        \
    const ListCall in = list_call_02(all, i);                                                      \
    const u32 *found = (const u32 *)answers + i * DISTRIBUTE_ROOM;                                 \
    (void)all

RIGHT(is_right_list, list_is_right(in, keeps, job, found))

// ---- distribute: mistakes -----------------------------------------------------------------------

// Does circle `id` overlap the call's cell? Those behind the end of the scene do not.
static int is_kept(const Job02 *job, ListCall call, u32 id)
{
    return id < DISTRIBUTE_MAX_IDS && keeps(job, call.scene, id, call.cell);
}

static int holds_centre(const Job02 *job, ListCall call, u32 id)
{
    const Circle c = job->scenes[call.scene].scene.circles[id];
    const BBox2D box = oracle2d_box(call.cell);
    return c.x >= box.minX && c.x < box.maxX && c.y >= box.minY && c.y < box.maxY;
}

// Was n returned, and are these ids written?
static int is_list(const u32 *found, u32 n, const u32 ids[DISTRIBUTE_ROOM])
{
    return found[0] == n && memcmp(found + 1, ids, DISTRIBUTE_MAX_IDS * sizeof *ids) == 0;
}

// For j from 0 on: is something written into list[place], what, and how is n counted up? Number j
// of the node's ids is `id`.
#define FILL(n_asked, is_listed, place, written, counted)                                          \
    for (u32 j = 0; number == 0 && j < (n_asked); j++) {                                           \
        const u32 id = in.ids[j];                                                                  \
        const int is_own = is_kept(all, in, id);                                                   \
        (void)is_own;                                                                              \
        if (is_listed) {                                                                           \
            list[place] = written;                                                                 \
            n = counted;                                                                           \
        }                                                                                          \
    }
#define LIST(name, n_asked, is_listed, place, written, counted, ...)                               \
    FILL(n_asked, is_listed, place, written, counted)                                              \
    EACH(name, is_list(found, n, list), __VA_ARGS__)

// How many ids come before the first that does not belong into the list.
static u32 n_leading(const Job02 *job, ListCall call)
{
    u32 n = 0;
    while (n < call.n_ids && is_kept(job, call, call.ids[n])) {
        n++;
    }
    return n;
}

static int is_equal_circle(Circle a, Circle b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

// Is an id among the first n of a list, or, where equal ones count, a circle that is equal to it?
static int is_listed(const Job02 *job, const u32 *list, u32 n, u32 id, int equal_ones)
{
    const Circle *circles = job->scenes[DISTRIBUTE_SCENE].scene.circles;
    u32 j = 0;
    while (j < n && list[j] != id &&
           !(equal_ones && list[j] < DISTRIBUTE_MAX_IDS &&
             is_equal_circle(circles[id], circles[list[j]]))) {
        j++;
    }
    return j < n;
}

// What became of the ids that belong into a list.
typedef struct Kept {
    u32 n, n_listed, n_equal;  // how many there are, and are listed, themselves or equal ones
    u32 n_in_place;            // how many of the first ones are in their places
    u32 from;                  // which of ids[] is the first that is not
} Kept;

static Kept kept_of(const Job02 *job, ListCall call, const u32 *found)
{
    const u32 *list = found + 1, n_found = found[0] < call.n_ids ? found[0] : call.n_ids;
    Kept kept = {0};
    for (u32 j = 0; j < call.n_ids; j++) {
        const u32 id = call.ids[j];
        if (is_kept(job, call, id)) {
            kept.from = kept.n_in_place < kept.n ? kept.from : j;
            kept.n_in_place += kept.n_in_place == kept.n && list[kept.n] == id;
            kept.n_listed += is_listed(job, list, n_found, id, 0);
            kept.n_equal += is_listed(job, list, n_found, id, 1);
            kept.n++;
        }
    }
    return kept;
}

static int is_lost(const Job02 *job, ListCall call, const u32 *found, Kept kept)
{
    return kept.n_in_place < kept.n &&
           !is_listed(job, found + 1, call.n_ids, call.ids[kept.from], 0);
}

static int is_reordered(Kept kept, u32 n_found)
{
    return kept.n > 1 && n_found == kept.n && kept.n_listed == kept.n;
}

KNOWN_LIST(known_lists)
{
    GIVEN;
    const u32 up_to_last = in.n_ids > 0 ? in.ids[in.n_ids - 1] - in.ids[0] + 1 : 0;
    const Kept kept = kept_of(all, in, found);
    u32 n = 0, list[DISTRIBUTE_ROOM];
    for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
        list[j] = UNTOUCHED;
    }

    LIST(from_the_back, in.n_ids, is_kept(all, in, in.ids[in.n_ids - 1 - j]), n,
         in.ids[in.n_ids - 1 - j], n + 1,
         "the ids stand there from the last to the first, and must ascend");
    LIST(asks_position, in.n_ids, is_kept(all, in, j), n, id, n + 1,
         "the circle at the position was asked, and the id at that position is another",
         MISTAKE_MISSING_IN_CELL);
    LIST(lists_position, in.n_ids, is_own, n, j, n + 1, "that is its position in ids[]");
    LIST(counted_on, in.n_ids, is_kept(all, in, in.ids[0] + j), n, in.ids[0] + j, n + 1,
         "ids were counted on from the first: in ids[] are gaps", MISTAKE_MISSING_IN_CELL);
    LIST(all_between, up_to_last, is_kept(all, in, in.ids[0] + j), n, in.ids[0] + j, n + 1,
         "circles were asked whose ids are not in ids[]");
    LIST(with_gaps, in.n_ids, is_own, j, id, n + 1,
         "ids stand at the position that they have in ids[]: the child's list has no gaps");
    LIST(by_centre, in.n_ids, holds_centre(all, in, id), n, id, n + 1,
         "centres were asked for, and a circle may overlap a cell without its centre",
         MISTAKE_MISSING_IN_CELL);
    LIST(count_of_8_bits, in.n_ids, is_own, n, id, (n + 1) & 0xff,
         "the number of ids is kept in 8 bits", MISTAKE_MISSING_IN_CELL);

    LIST(contrary, in.n_ids, !is_own, n, id, n + 1,
         "these are the circles that do not overlap the cell");
    LIST(only_positions, in.n_ids, is_kept(all, in, j), n, j, n + 1,
         "positions were asked and listed: ids[] says which circles these are",
         MISTAKE_MISSING_IN_CELL);
    LIST(everyone, in.n_ids, 1, n, id, n + 1,
         "every circle of the node is listed, whether or not it overlaps the cell");
    LIST(without_first, in.n_ids - (in.n_ids > 0), is_kept(all, in, in.ids[j + 1]), n,
         in.ids[j + 1], n + 1, "the first of ids[] is never asked: positions count from 0",
         MISTAKE_MISSING_IN_CELL);
    LIST(without_last, in.n_ids - (in.n_ids > 0), is_own, n, id, n + 1,
         "the last of ids[] is never asked", MISTAKE_MISSING_IN_CELL);
    LIST(from_position_1, in.n_ids, is_own, n + 1, id, n + 1,
         "the first id stands at position 1: positions count from 0");
    LIST(all_at_0, in.n_ids, is_own, 0, id, 0,
         "each id is written over the one before: the position has to move on");

    LIST(ends_at_other, n_leading(all, in), 1, n, id, n + 1,
         "the loop ends at the first circle that does not overlap: later ones may",
         MISTAKE_MISSING_IN_CELL);

    FILL(in.n_ids, is_own, j, id, n + 1);
    EACH(gaps_counted, is_list(found, in.n_ids, list),
         "ids stand at the position that they have in ids[]: the child's list has no gaps");
    FILL(in.n_ids, is_own, n + 1, id, n + 1);
    list[0] = number == 0 ? n : list[0];
    EACH(count_first, is_list(found, n, list), "child_ids[] gets ids only: the count is returned");

    LIST(none_written, in.n_ids, 0, n, id, n, "no list ever gets an id");
    LIST(counted_only, in.n_ids, is_own, n, UNTOUCHED, n + 1,
         "the ids are counted, and not written into child_ids");
    ONLY(empty_asked, in.n_ids == 0 && found[0] > 0,
         "nothing is asked of an empty list, not even ids[0]");
    ONLY(end_marked, found[1 + in.n_ids] != UNTOUCHED,
         "nothing comes behind the last id, not even an end mark");
    ONLY(reordered, is_reordered(kept, found[0]),
         "these are the right circles in another order: ids ascend, as in ids[]");
    ONLY(equal_missing, kept.n_listed < kept.n && kept.n_equal == kept.n,
         "circles that are equal are all listed", MISTAKE_MISSING_IN_CELL);
    ONLY(miscounted, found[0] != kept.n && kept.n_in_place == kept.n,
         "the list is right and its number is not: return how many ids were written");
    ONLY(ends_early, found[0] > 0 && found[0] < kept.n && kept.n_in_place == found[0],
         "the list ends too early: there is room for more ids", MISTAKE_MISSING_IN_CELL);
    ONLY(lost, is_lost(all, in, found, kept), NULL, MISTAKE_MISSING_IN_CELL);
    return NO_MORE;
}

static char *describe_list(const void *job, int i, const void *answers)
{
    GIVEN;
    const Kept kept = kept_of(all, in, found);
    const u32 at = kept.n_in_place;
    const Words node =
        words("node with %u circle%s from id %u on", in.n_ids, plural(in.n_ids), in.ids[0]);
    if (at < kept.n) {
        return message_new(
            "%s: child_ids[%u] %s, expected %u%s%s", node.text, at,
            found[1 + at] == UNTOUCHED ? "was not written" : words("is %u", found[1 + at]).text,
            in.ids[kept.from],
            is_lost(all, in, found, kept)
                ? ", that circle overlaps the cell and is missing in its list"
                : "",
            at > 0 && at == found[0] ? words(", the list ends after %u ids", at).text : "");
    }
    return found[0] != at ? message_new("%s: returned %u, expected %u: the number of ids written",
                                        node.text, found[0], at)
                          : message_new("child_ids[%u] was written, but there is room for %u",
                                        in.n_ids, in.n_ids);
}

const Function distribute_02 = {"distribute",
                                N_DISTRIBUTES,
                                DISTRIBUTE_ROOM * sizeof(u32),
                                KNOWING(is_right_list, describe_list, known_lists),
                                .counted = "lists",
                                .knows_constant = 1};
#undef GIVEN

// ---- pack_leaf ----------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const PackJob *in = &((const Job02 *)job)->packs[i];                                           \
    const PackAnswer *found = (const PackAnswer *)answers + i;                                     \
    const u32 *list = found->map + in->n_before + 1;                                               \
    const u32 offset = found->relations[in->id].circleMapOffset, count = found->map[in->n_before]; \
    (void)list, (void)offset, (void)count

#include "packed_known.h"

// "leaf with 5 circles, map of 1 entry"
static Words pack_words(const PackJob *in)
{
    return words("leaf with %u circle%s, map of %u %s", in->n_ids, plural(in->n_ids), in->n_before,
                 in->n_before == 1 ? "entry" : "entries");
}

RIGHT(is_right_offset, offset == in->n_before)

KNOWN_LIST(known_offsets)
{
    GIVEN;

    EACH(at_first_id, offset == in->n_before + 1, "it points behind the count, at the first id");
    EACH(at_end, offset == in->n_before + 1 + in->n_ids,
         "that is the end of the list: n_map had moved before");

    EACH(at_id, offset == in->id, "that is the node's id");
    EACH(unset, offset == 0, "circleMapOffset was not set, or always to 0");
    ONLY(no_list_no_offset, in->n_ids == 0, "an empty leaf has a list, too, and an offset");
    return NO_MORE;
}

static char *describe_offset(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("%s: circleMapOffset is %u, expected %u, the place of the count",
                       pack_words(in).text, offset, in->n_before);
}

RIGHT(is_right_count, count == in->n_ids)

KNOWN_LIST(known_counts)
{
    GIVEN;

    EACH(counts_itself, count == in->n_ids + 1, "the count counts the ids, and not itself");
    EACH(cut_count, count == (in->n_ids & 0xff), "that is what 8 bits hold of it");
    ONLY(no_list, count == UNTOUCHED && in->n_ids == 0,
         "an empty leaf has a list, too: a count of 0");

    ONLY(no_count, in->n_ids == 0 || count == in->ids[0],
         "the first id stands where the count belongs");
    return NO_MORE;
}

static char *describe_count(const void *job, int i, const void *answers)
{
    GIVEN;
    return count == UNTOUCHED
               ? message_new("%s: mapNode2Circles[%u] was not written, expected the count",
                             pack_words(in).text, in->n_before)
               : message_new("%s: the count at %u is %u, expected %u", pack_words(in).text,
                             in->n_before, count, in->n_ids);
}

// The leaf's ids, and what else is in the map. NULL where it is right, as below.
static char *describe_map(const PackJob *in, const PackAnswer *found)
{
    const u32 *list = found->map + in->n_before + 1;
    const u32 end = in->n_before + 1 + in->n_ids;
    for (u32 j = 0; j < in->n_ids; j++) {
        if (list[j] != in->ids[j]) {
            return message_new("%s: id number %u %s, expected %u", pack_words(in).text, j,
                               list[j] == UNTOUCHED ? "was not written"
                                                    : words("is %u", list[j]).text,
                               in->ids[j]);
        }
    }
    if (found->n_map != end) {
        return message_new("%s: n_map is %u afterwards, expected %u", pack_words(in).text,
                           found->n_map, end);
    }
    for (u32 j = 0; j < PACK_MAP_ROOM; j++) {
        if ((j < in->n_before || j >= end) && found->map[j] != UNTOUCHED) {
            return message_new("%s: mapNode2Circles[%u] was written, but the list goes from %u to "
                               "%u",
                               pack_words(in).text, j, in->n_before, end - 1);
        }
    }
    return NULL;
}

// Is a node as it was, but for the leaf's flag and circleMapOffset?
static char *describe_node(const PackJob *in, const PackAnswer *found, u32 id)
{
    const NodeRel node = found->relations[id];
    const int is_leaf = id == in->id;
    const struct {
        const char *array, *field;
        u32 found, expected;
    } fields[] = {
        {"nodes_Relations", ".id", node.id, id},
        {"nodes_Relations", ".lChild", node.lChild, 0},
        {"nodes_Relations", ".rChild", node.rChild, 0},
        {"nodes_Relations", ".circleMapOffset", is_leaf ? 0 : node.circleMapOffset, 0},
        {"nodes_flag", "", is_leaf ? INNER : found->flags[id], INNER},
    };
    for (int f = 0; f < COUNT(fields); f++) {
        if (fields[f].found != fields[f].expected) {
            return message_new("packing leaf %u changed %s[%u]%s to %u, expected it to stay %u",
                               in->id, fields[f].array, id, fields[f].field, fields[f].found,
                               fields[f].expected);
        }
    }
    return memcmp(&found->boxes[id], &PACK_CELL(id), sizeof(BBox2D)) == 0
               ? NULL
               : message_new("packing leaf %u changed nodes_BBox[%u] to %s, expected it to stay %s",
                             in->id, id, words_box2d(found->boxes[id]).text,
                             words_box2d(PACK_CELL(id)).text);
}

static int is_other_changed(const PackJob *in, const PackAnswer *found)
{
    int is_changed = 0;
    for (u32 id = 0; id < PACK_NODES; id++) {
        is_changed |= id != in->id && !facts_are_none(describe_node(in, found, id));
    }
    return is_changed;
}

static char *describe_rest(const void *job, int i, const void *answers)
{
    GIVEN;
    if (found->flags[in->id] != LEAF) {
        return message_new("nodes_flag[%u] is %u, expected LEAF", in->id, found->flags[in->id]);
    }
    char *wrong = describe_map(in, found);
    for (u32 id = 0; wrong == NULL && id < PACK_NODES; id++) {
        wrong = describe_node(in, found, id);
    }
    return wrong != NULL                  ? wrong
           : found->n_nodes != PACK_NODES ? message_new("packing leaf %u changed n_nodes to %u, "
                                                        "expected it to stay %d",
                                                        in->id, found->n_nodes, PACK_NODES)
                                          : NULL;
}

RIGHT(is_right_rest, facts_are_none(describe_rest(job, i, answers)))

// Are the second id and those behind it where the first one and those behind it belong?
static int is_one_early(const PackJob *in, const u32 *list)
{
    u32 j = 1;
    while (j < in->n_ids && list[j - 1] == in->ids[j]) {
        j++;
    }
    return j >= in->n_ids;
}

KNOWN_LIST(known_rest)
{
    GIVEN;
    const NodeRel own = found->relations[in->id];
    const u32 end = in->n_before + 1 + in->n_ids;

    ONLY(unmarked, found->flags[in->id] != LEAF, "pack_leaf marks the leaf");
    ONLY(one_early, in->n_ids > 0 && is_one_early(in, list),
         "the ids stand one position too early: ids[0] comes right behind the count");
    ONLY(unlisted, in->n_ids > 0 && list[0] == UNTOUCHED && found->n_map <= end,
         "the ids of the leaf come behind the count, and are not there");
    ONLY(count_left_out, found->n_map == end - 1, "the count is an entry, too");
    ONLY(map_by_one, found->n_map == in->n_before + 1,
         "n_map moves by the ids, too, not by 1 alone");
    ONLY(map_of_copy, found->n_map == in->n_before,
         "n_map has to move, in the tree that was handed over and not in a copy");
    ONLY(one_entry_more, found->n_map == end && found->map[end] != UNTOUCHED,
         "that is one entry more than count and ids: there may be no room for it");
    ONLY(leaf_changed, own.id != in->id || own.lChild != 0 || own.rChild != 0,
         "of the leaf's NodeRel only circleMapOffset changes");
    ONLY(other_changed, is_other_changed(in, found), "that is another node, and stays as it is");
    return NO_MORE;
}

const Function pack_count_02 = {"pack", N_PACKS, sizeof(PackAnswer),
                                KNOWING(is_right_count, describe_count, known_counts),
                                .counted = "leaves"};
const Function pack_offset_02 = {"pack", N_PACKS, sizeof(PackAnswer),
                                 KNOWING(is_right_offset, describe_offset, known_offsets),
                                 .counted = "leaves"};
const Function pack_rest_02 = {"pack", N_PACKS, sizeof(PackAnswer),
                               KNOWING(is_right_rest, describe_rest, known_rest, packed_known),
                               .counted = "leaves"};

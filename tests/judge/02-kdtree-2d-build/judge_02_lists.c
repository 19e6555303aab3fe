// Lab 02: distribute and pack_leaf on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "packed_list.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

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

// Are all circles there, each once, in another order?
static int is_reordered(const Job02 *job, ListCall call, const u32 *found)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        u32 n_there = 0;
        for (u32 j = 0; j < found[0] && j < call.n_ids; j++) {
            n_there += found[1 + j] == call.ids[i];
        }
        if (n_there != (u32)keeps(job, call.scene, call.ids[i], call.cell)) {
            return 0;
        }
        n += n_there;
    }
    return n > 1 && found[0] == n;
}

// ---- Rivals of distribute: what a known mistake returns, and writes into list[]

typedef u32 Rival(const Job02 *job, ListCall call, u32 *list);

// Does circle `id` overlap the call's cell? Those behind the end of the scene do not.
static int is_kept(const Job02 *job, ListCall call, u32 id)
{
    return id < DISTRIBUTE_MAX_IDS && keeps(job, call.scene, id, call.cell);
}

static u32 from_the_back(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 i = call.n_ids; i-- > 0;) {
        if (is_kept(job, call, call.ids[i])) {
            list[n++] = call.ids[i];
        }
    }
    return n;
}

static u32 asks_positions(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (is_kept(job, call, i)) {
            list[n++] = call.ids[i];
        }
    }
    return n;
}

static u32 counts_from_first(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (is_kept(job, call, call.ids[0] + i)) {
            list[n++] = call.ids[0] + i;
        }
    }
    return n;
}

static u32 asks_all_between(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 id = call.ids[0]; call.n_ids > 0 && id <= call.ids[call.n_ids - 1]; id++) {
        if (is_kept(job, call, id)) {
            list[n++] = id;
        }
    }
    return n;
}

static u32 leaves_gaps(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (is_kept(job, call, call.ids[i])) {
            list[i] = call.ids[i];
            n++;
        }
    }
    return n;
}

static u32 asks_centres(const Job02 *job, ListCall call, u32 *list)
{
    const BBox2D box = oracle2d_box(call.cell);
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        const Circle c = job->scenes[call.scene].scene.circles[call.ids[i]];
        if (c.x >= box.minX && c.x < box.maxX && c.y >= box.minY && c.y < box.maxY) {
            list[n++] = call.ids[i];
        }
    }
    return n;
}

static u32 counts_in_a_byte(const Job02 *job, ListCall call, u32 *list)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (is_kept(job, call, call.ids[i])) {
            list[n++ & 0xff] = call.ids[i];
        }
    }
    return n & 0xff;
}

static const struct {
    Rival *rival;
    const char *says;
} list_rivals[] = {
    {from_the_back, "the ids stand there from the last to the first, and must ascend"},
    {asks_positions,
     "the circle at the position was asked, and the id at that position is another"},
    {counts_from_first, "ids were counted on from the first: in ids[] are gaps"},
    {asks_all_between, "circles were asked whose ids are not in ids[]"},
    {leaves_gaps,
     "ids stand at the position that they have in ids[]: the child's list has no gaps"},
    {asks_centres, "centres were asked for, and a circle may overlap a cell without its centre"},
    {counts_in_a_byte, "the number of ids is kept in 8 bits"},
};

// Does a rival give all answers, written or not?
static int is_list_rival(const Job02 *job, const u32 *answers, Rival *rival)
{
    u32 list[DISTRIBUTE_ROOM];
    int i = 0, is_same = 1;
    for (; is_same && i < N_DISTRIBUTES; i++) {
        const u32 *found = answers + i * DISTRIBUTE_ROOM;
        for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
            list[j] = UNTOUCHED;
        }
        const u32 n = rival(job, list_call_02(job, i), list);
        is_same = found[0] == n && memcmp(found + 1, list, DISTRIBUTE_MAX_IDS * sizeof *list) == 0;
    }
    return is_same;
}

// The mistake that gives all answers, or NULL.
static const char *explain_lists(const Job02 *job, const u32 *answers)
{
    for (int m = 0; m < COUNT(list_rivals); m++) {
        if (is_list_rival(job, answers, list_rivals[m].rival)) {
            return list_rivals[m].says;
        }
    }
    return NULL;
}

// What one list looks like. Owned by the caller; NULL where nothing is known.
static char *explain_order(const Job02 *job, ListCall call, const u32 *found)
{
    return is_reordered(job, call, found)
               ? message_new(
                     "these are the right circles in another order: ids ascend, as in ids[]")
               : explain_list(job, call, found);
}

static Diagnosis distribute_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const ListCall call = list_call_02(job, i);
    const u32 *found = (const u32 *)answers + i * DISTRIBUTE_ROOM;
    Diagnosis wrong = list_fault("circle", call, keeps, job, found);
    if (wrong.found == NULL) {
        return wrong;
    }
    // What explains every list counts before what one wrong id looks like, maybe by chance.
    const char *of_all = explain_lists(job, answers);
    if (of_all != NULL) {
        free(wrong.cause);
        wrong.cause = message_new("%s", of_all);
    } else if (wrong.cause == NULL) {
        wrong.cause = explain_order(job, call, found);
    }
    return wrong;
}

const Function distribute_02 = {"distribute", N_DISTRIBUTES, DISTRIBUTE_ROOM * sizeof(u32),
                                .fault = distribute_fault};

// ---- pack_leaf ----------------------------------------------------------------------------------

// "leaf with 5 circles, map of 1 entry"
static Words pack_words(const PackJob *in)
{
    return words("leaf with %u circle%s, map of %u %s", in->n_ids, plural(in->n_ids), in->n_before,
                 in->n_before == 1 ? "entry" : "entries");
}

static Diagnosis pack_offset_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    const u32 offset = out->relations[in->id].circleMapOffset;
    const char *says = offset == in->n_before + 1 ? "it points behind the count, at the first id"
                       : offset == in->n_before + 1 + in->n_ids
                           ? "that is the end of the list: n_map had moved before"
                           : NULL;
    return offset == in->n_before
               ? NOTHING_WRONG
               : diagnosis_of(message_new("%s: circleMapOffset is %u, expected %u, the place of "
                                          "the count",
                                          pack_words(in).text, offset, in->n_before),
                              (Cause){.says = says});
}

static Cause count_cause(u32 count, u32 n_ids)
{
    const Cause itself = {.says = "the count counts the ids, and not itself"};
    return count == n_ids + 1 ? itself : number_cause(count, n_ids);
}

static Diagnosis pack_count_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job02 *)job)->packs[i];
    const PackAnswer *out = (const PackAnswer *)answers + i;
    const u32 count = out->map[in->n_before];
    if (count == UNTOUCHED) {
        return diagnosis_of(
            message_new("%s: mapNode2Circles[%u] was not written, expected the count",
                        pack_words(in).text, in->n_before),
            (Cause){.says = in->n_ids == 0 ? "an empty leaf has a list, too: a count of 0" : NULL});
    }
    return count == in->n_ids
               ? NOTHING_WRONG
               : diagnosis_of(message_new("%s: the count at %u is %u, expected %u",
                                          pack_words(in).text, in->n_before, count, in->n_ids),
                              count_cause(count, in->n_ids));
}

// The leaf's ids, and what else is in the map.
static Diagnosis map_fault(const PackJob *in, const PackAnswer *out)
{
    const u32 *list = out->map + in->n_before + 1;
    const u32 end = in->n_before + 1 + in->n_ids;
    for (u32 j = 0; j < in->n_ids; j++) {
        if (list[j] == UNTOUCHED) {
            return diagnosis_new("%s: id number %u was not written, expected %u",
                                 pack_words(in).text, j, in->ids[j]);
        }
        if (list[j] != in->ids[j]) {
            return diagnosis_of(message_new("%s: id number %u is %u, expected %u",
                                            pack_words(in).text, j, list[j], in->ids[j]),
                                list_cause(list, in->ids, in->n_ids));
        }
    }
    if (out->n_map != end) {
        const char *says = out->n_map == in->n_before + in->n_ids ? "the count is an entry, too"
                           : out->n_map == in->n_before
                               ? "n_map has to move in the tree that was handed over, and not in a "
                                 "copy"
                               : NULL;
        return diagnosis_of(message_new("%s: n_map is %u afterwards, expected %u",
                                        pack_words(in).text, out->n_map, end),
                            (Cause){.says = says});
    }
    for (u32 j = 0; j < PACK_MAP_ROOM; j++) {
        const int is_list = j >= in->n_before && j < end;
        if (!is_list && out->map[j] != UNTOUCHED) {
            return diagnosis_of(
                message_new("%s: mapNode2Circles[%u] was written, but the list goes from %u to %u",
                            pack_words(in).text, j, in->n_before, end - 1),
                (Cause){.says = j == end ? "that is one entry more than count and ids: there may "
                                           "be no room for it"
                                         : NULL});
        }
    }
    return NOTHING_WRONG;
}

static int is_same_box(BBox2D a, BBox2D b)
{
    return memcmp(&a, &b, sizeof a) == 0;
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
            return diagnosis_of(
                message_new("packing leaf %u changed %s[%u]%s to %u, expected it to stay %u",
                            in->id, fields[f].array, id, fields[f].field, fields[f].found,
                            fields[f].expected),
                (Cause){.says = is_leaf ? "of the leaf's NodeRel only circleMapOffset changes"
                                        : "that is another node, and stays as it is"});
        }
    }
    return is_same_box(out->boxes[id], PACK_CELL(id))
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

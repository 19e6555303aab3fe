// Lab 06: pack_leaf_range on the job's inputs. See judge_06.h; judge_06_functions.c is the sibling.
#include "judge_06.h"

#include "message.h"
#include "words.h"

#define GIVEN                                                                                      \
    const PackJob *in = &((const Job06 *)job)->packs[i];                                           \
    const PackAnswer3D *out = (const PackAnswer3D *)answers + i;                                   \
    const KdNode3 found = out->nodes[in->id];                                                      \
    const u32 *list = out->sphere_ids + in->n_before;                                              \
    (void)found, (void)list

#include "packed_known.h"

static Words leaf_words(const PackJob *in)
{
    return words("leaf with %u sphere%s, %u id%s before it", in->n_ids, plural(in->n_ids),
                 in->n_before, plural(in->n_before));
}

// ---- The node -----------------------------------------------------------------------------------

// NULL where it is right, as below.
static char *describe_node(const void *job, int i, const void *answers)
{
    GIVEN;
    return found.split_axis != KD_LEAF
               ? message_new("node %u: split_axis is %u, expected KD_LEAF (%d)", in->id,
                             found.split_axis, KD_LEAF)
           : found.first != in->n_before
               ? message_new("%s: first is %u, expected %u, where its first id goes",
                             leaf_words(in).text, found.first, in->n_before)
           : found.n_spheres != in->n_ids
               ? message_new("leaf with %u sphere%s: n_spheres is %u%s, expected %u", in->n_ids,
                             plural(in->n_ids), found.n_spheres,
                             found.n_spheres == UNTOUCHED ? ", not set" : "", in->n_ids)
               : NULL;
}

RIGHT(is_right_node, facts_are_none(describe_node(job, i, answers)))

static int is_untouched(KdNode3 node)
{
    return node.split_axis == PACK_SPLIT_AXIS && node.first == UNTOUCHED &&
           node.n_spheres == UNTOUCHED;
}

static int n_touched(const PackAnswer3D *out)
{
    int n = 0;
    for (u32 id = 0; id < PACK_NODES; id++) {
        n += !is_untouched(out->nodes[id]);
    }
    return n;
}

KNOWN_LIST(known_of_node)
{
    GIVEN;

    // Of the call before, which was in another tree.
    EACH(end_kept, i == 0 || found.first == out[-1].nodes[in[-1].id].first + in[-1].n_ids,
         "the end was kept from the tree before: it is tree->n_sphere_ids");
    EACH(first_behind, found.first == in->n_before + in->n_ids,
         "it was taken after the end had moved: that is behind the leaf's ids");
    EACH(first_in_bytes, found.first == in->n_before * sizeof(u32),
         "it is counted in ids, not in bytes");
    EACH(empty_from_0, found.first == (in->n_ids > 0 ? in->n_before : 0),
         "an empty leaf's range begins where the array ends, too");
    EACH(count_is_end, found.n_spheres == in->n_before + in->n_ids,
         "that is where the range ends, not how many spheres are in it");
    EACH(counted_up, found.n_spheres == UNTOUCHED + in->n_ids,
         "it was counted up from what the node held before");
    EACH(count_of_8_bits, found.n_spheres == (in->n_ids & 0xff), "that is what 8 bits hold of it");

    EACH(by_id, found.first == in->id,
         "that is the leaf's own id: its range begins where the array of ids ends");
    EACH(one_behind, found.first == in->n_before + 1,
         "that is one place too far: n_sphere_ids, before it moves, is the first free place");
    EACH(first_unset, found.first == UNTOUCHED && found.n_spheres == in->n_ids, "first is not set");
    EACH(n_unset, found.n_spheres == UNTOUCHED && found.first == in->n_before,
         "n_spheres is not set");
    EACH(swapped, found.first == in->n_ids && found.n_spheres == in->n_before,
         "first and n_spheres are swapped");
    EACH(first_is_id, in->n_ids == 0 || found.first == in->ids[0],
         "that is the leaf's first id: its place in sphere_ids is asked for");
    EACH(first_is_last, in->n_ids == 0 || found.first == in->n_before + in->n_ids - 1,
         "that is where the leaf's last id is: its range begins where the first one is");

    EACH(copy, n_touched(out) == 0, "no node of the tree changed: was a copy of it filled in?");
    ONLY(empty_left_out, in->n_ids == 0,
         "only empty leaves are wrong: they are packed as all others, with a range of 0 ids");
    EACH(unmarked, found.split_axis == PACK_SPLIT_AXIS && !is_untouched(found),
         "split_axis is not set: KD_LEAF marks a leaf");
    ONLY(first_at_0, found.split_axis == KD_LEAF && found.first == 0,
         "each range begins at 0: it begins where the array of ids ends, at n_sphere_ids");
    ONLY(other_node, is_untouched(found) && n_touched(out) > 0,
         "another node than nodes[id] was filled in");
    return NO_MORE;
}

const Function pack_node_06 = {"pack", N_PACKS, sizeof(PackAnswer3D),
                               KNOWING(is_right_node, describe_node, known_of_node),
                               .counted = "leaves"};

// ---- The ids, and all else ----------------------------------------------------------------------

// What is in the array: the leaf's range, and the rest of it.
static char *describe_array(const PackJob *in, const PackAnswer3D *out)
{
    const u32 first = in->n_before, end = first + in->n_ids;
    for (u32 at = 0; at < PACK_MAP_ROOM; at++) {
        const int is_range = at >= first && at < end;
        const u32 found = out->sphere_ids[at];
        if (is_range && found != in->ids[at - first]) {
            return message_new("%s: sphere_ids[%u] %s, expected %u", leaf_words(in).text, at,
                               found == UNTOUCHED ? "was not written" : words("is %u", found).text,
                               in->ids[at - first]);
        }
        if (!is_range && found != UNTOUCHED) {
            return message_new("sphere_ids[%u] was written, but the leaf's range goes from %u to "
                               "before %u",
                               at, first, end);
        }
    }
    return out->n_sphere_ids == end ? NULL
                                    : message_new("%s: n_sphere_ids is %u afterwards, expected %u",
                                                  leaf_words(in).text, out->n_sphere_ids, end);
}

// Is a node as it was?
static char *describe_other(u32 leaf, KdNode3 node, u32 id)
{
    const char *changed = node.split_pos != PACK_SPLIT_POS     ? "split_pos"
                          : node.split_axis != PACK_SPLIT_AXIS ? "split_axis"
                          : node.first != UNTOUCHED            ? "first"
                          : node.n_spheres != UNTOUCHED        ? "n_spheres"
                                                               : NULL;
    return changed == NULL ? NULL
                           : message_new("packing leaf %u changed %s of node %u, expected it to "
                                         "leave other nodes as they are",
                                         leaf, changed, id);
}

static char *describe_ids(const void *job, int i, const void *answers)
{
    GIVEN;
    char *wrong = describe_array(in, out);
    if (wrong == NULL && found.split_pos != PACK_SPLIT_POS) {
        wrong = message_new("packing leaf %u changed its split_pos from %g to %g, expected it to "
                            "stay: all but split_pos is set",
                            in->id, PACK_SPLIT_POS, found.split_pos);
    }
    for (u32 id = 0; wrong == NULL && id < PACK_NODES; id++) {
        wrong = id != in->id ? describe_other(in->id, out->nodes[id], id) : NULL;
    }
    if (wrong == NULL && out->n_nodes != PACK_NODES) {
        wrong = message_new("packing leaf %u changed n_nodes to %u, expected it to stay %d", in->id,
                            out->n_nodes, PACK_NODES);
    }
    return wrong;
}

RIGHT(are_right_ids, facts_are_none(describe_ids(job, i, answers)))

static int has_count_first(const PackJob *in, const u32 *list)
{
    u32 i = 1;
    while (i < in->n_ids && list[i] == in->ids[i - 1]) {
        i++;
    }
    return in->n_ids == 0 || (i == in->n_ids && list[0] == in->n_ids);
}

// Are the leaf's ids in the array from `first` on, and before and behind them nothing is written?
static int stand_at(const PackJob *in, const PackAnswer3D *out, u32 first, u32 n_behind)
{
    int fits = 1;
    for (u32 at = 0; fits && at < PACK_MAP_ROOM; at++) {
        const u32 found = out->sphere_ids[at], end = first + in->n_ids;
        fits = at >= first && at < end ? found == in->ids[at - first]
                                       : (at >= end && at < end + n_behind) == (found != UNTOUCHED);
    }
    return fits;
}

// Of all places only the first of the range is written.
static int is_one_place(const PackJob *in, const PackAnswer3D *out)
{
    u32 at = 0;
    while (at < PACK_MAP_ROOM && (at == in->n_before) == (out->sphere_ids[at] != UNTOUCHED)) {
        at++;
    }
    return at == PACK_MAP_ROOM;
}

// Are only the leaf's ids from `from` to before `to` in its range?
static int are_only(const PackJob *in, const u32 *list, u32 from, u32 to)
{
    u32 k = from;
    while (k < to && list[k - from] == in->ids[k]) {
        k++;
    }
    return k >= to && (in->n_ids == 0 || list[in->n_ids - 1] == UNTOUCHED);
}

// A loop from the range's begin to before n_ids.
static int is_to_count(const PackJob *in, const PackAnswer3D *out)
{
    int fits = 1;
    for (u32 at = 0; fits && at < PACK_MAP_ROOM; at++) {
        fits =
            out->sphere_ids[at] == (at >= in->n_before && at < in->n_ids ? in->ids[at] : UNTOUCHED);
    }
    return fits;
}

static int lists_sphere_0(const PackJob *in)
{
    u32 i = 0;
    while (i < in->n_ids && in->ids[i] != 0) {
        i++;
    }
    return i < in->n_ids;
}

KNOWN_LIST(known_of_ids)
{
    GIVEN;
    const int is_in_place = stand_at(in, out, in->n_before, 0);

    EACH(count_first, has_count_first(in, list),
         "a count stands before the ids, as in lab 02: here it is in the node only");
    ONLY(in_front,
         in->n_before > 0 && in->n_ids > 0 && out->sphere_ids[0] == in->ids[0] &&
             out->sphere_ids[in->n_ids - 1] == in->ids[in->n_ids - 1],
         "the ids go behind those of the leaves before, not to the array's beginning");

    EACH(first_missing, are_only(in, list, 1, in->n_ids), "the leaf's first id is missing");
    EACH(last_missing, are_only(in, list, 0, in->n_ids - (in->n_ids > 0)),
         "the leaf's last id is missing");
    EACH(one_more, stand_at(in, out, in->n_before, 1),
         "one id too many is written, behind the leaf's range");
    EACH(one_place_on, stand_at(in, out, in->n_before + 1, 0),
         "the ids are one place too far: n_sphere_ids, before it moves, is the first free place");
    EACH(at_id, stand_at(in, out, in->id, 0),
         "the ids begin at the leaf's own id: they go where the array of ids ends");
    EACH(end_stays, is_in_place && out->n_sphere_ids == in->n_before,
         "n_sphere_ids is not moved: the next leaf's ids go where these are");
    EACH(end_one_on, is_in_place && out->n_sphere_ids == in->n_before + 1,
         "n_sphere_ids moves by one for each leaf: it moves by the number of its ids");
    EACH(end_one_too_far, is_in_place && out->n_sphere_ids == in->n_before + in->n_ids + 1,
         "n_sphere_ids moves by one too many: here no place is needed for the count");
    EACH(end_is_count, is_in_place && out->n_sphere_ids == in->n_ids,
         "n_sphere_ids counts this leaf only: it moves behind the ids of all leaves so far");
    EACH(end_twice, is_in_place && out->n_sphere_ids == in->n_before + 2 * in->n_ids,
         "n_sphere_ids moves twice: by the number of the leaf's ids, once");

    EACH(to_count, is_to_count(in, out),
         "n_ids was taken for the end of the range: it is how many ids there are");
    ONLY(one_place, in->n_ids > 0 && is_one_place(in, out),
         "all ids are written to one place: each goes behind the one before it");
    ONLY(split_pos_set, is_in_place && found.split_pos != PACK_SPLIT_POS,
         "split_pos is set, too: of the node's fields the three others change");
    ONLY(sphere_0, lists_sphere_0(in),
         "only leaves that list sphere 0 are wrong: 0 is an id as any other");
    EACH(unwritten, stand_at(in, out, PACK_MAP_ROOM, 0),
         "no id is written: the leaf's range is in the array, and stays free");
    return NO_MORE;
}

const Function pack_ids_06 = {"pack", N_PACKS, sizeof(PackAnswer3D),
                              KNOWING(are_right_ids, describe_ids, known_of_ids, packed_known),
                              .counted = "leaves"};

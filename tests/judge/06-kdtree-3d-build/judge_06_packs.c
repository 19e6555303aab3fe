// Lab 06: pack_leaf_range on the job's inputs. See judge_06.h; judge_06_functions.c is the sibling.
#include "judge_06.h"
#include "message.h"
#include "packed_list.h"
#include "words.h"

#include <stdlib.h>

Diagnosis explained_06(Diagnosis wrong, const char *says)
{
    if (wrong.found != NULL && says != NULL) {
        free(wrong.cause);
        wrong.cause = message_new("%s", says);
    }
    return wrong;
}

// What a node's field holds after a mistake.
typedef u32 MistakenField(const PackJob *in);

static u32 end_of_range(const PackJob *in)
{
    return in->n_before + in->n_ids;
}

static u32 first_in_bytes(const PackJob *in)
{
    return in->n_before * (u32)sizeof(u32);
}

static u32 first_unless_empty(const PackJob *in)
{
    return in->n_ids > 0 ? in->n_before : 0;
}

static u32 counted_up(const PackJob *in)
{
    return UNTOUCHED + in->n_ids;
}

typedef struct FieldMistake {
    MistakenField *field;
    const char *says;
} FieldMistake;

static const FieldMistake first_mistakes[] = {
    {end_of_range, "it was taken after the end had moved: that is behind the leaf's ids"},
    {first_in_bytes, "it is counted in ids, not in bytes"},
    {first_unless_empty, "an empty leaf's range begins where the array ends, too"},
};
static const FieldMistake count_mistakes[] = {
    {end_of_range, "that is where the range ends, not how many spheres are in it"},
    {counted_up, "it was counted up from what the node held before"},
};

// The mistake that explains a field of every leaf, or NULL.
static const char *fields_look(const Job06 *job, const PackAnswer3D *out, int is_first,
                               const FieldMistake *mistakes, int n)
{
    for (int m = 0; m < n; m++) {
        int i = 0;
        for (; i < N_PACKS; i++) {
            const KdNode3 node = out[i].nodes[job->packs[i].id];
            if ((is_first ? node.first : node.n_spheres) != mistakes[m].field(&job->packs[i])) {
                break;
            }
        }
        if (i == N_PACKS) {
            return mistakes[m].says;
        }
    }
    return NULL;
}

// Does each leaf begin where the one of the call before ended, which was in another tree?
static int goes_on(const Job06 *job, const PackAnswer3D *out)
{
    int i = 1;
    while (i < N_PACKS &&
           out[i].nodes[job->packs[i].id].first ==
               out[i - 1].nodes[job->packs[i - 1].id].first + job->packs[i - 1].n_ids) {
        i++;
    }
    return i == N_PACKS;
}

static Diagnosis pack_node_fault(const void *pointer, int i, const void *answers)
{
    const Job06 *job = pointer;
    const PackJob *in = &job->packs[i];
    const PackAnswer3D *out = answers;
    const KdNode3 node = out[i].nodes[in->id];
    if (node.split_axis != KD_LEAF) {
        return diagnosis_new("node %u: split_axis is %u, expected KD_LEAF (%d)", in->id,
                             node.split_axis, KD_LEAF);
    }
    if (node.first != in->n_before) {
        const char *looks = goes_on(job, out)
                                ? "the end was kept from the tree before: it is tree->n_sphere_ids"
                                : fields_look(job, out, 1, first_mistakes, COUNT(first_mistakes));
        return diagnosis_of(
            message_new("leaf with %u sphere%s, %u id%s before it: first is %u, expected %u, where "
                        "its first id goes",
                        in->n_ids, plural(in->n_ids), in->n_before, plural(in->n_before),
                        node.first, in->n_before),
            (Cause){.says = looks});
    }
    if (node.n_spheres == in->n_ids) {
        return NOTHING_WRONG;
    }
    const Diagnosis wrong =
        diagnosis_of(message_new("leaf with %u sphere%s: n_spheres is %u%s, expected %u", in->n_ids,
                                 plural(in->n_ids), node.n_spheres,
                                 node.n_spheres == UNTOUCHED ? ", not set" : "", in->n_ids),
                     number_cause(node.n_spheres, in->n_ids));
    return explained_06(wrong, fields_look(job, out, 0, count_mistakes, COUNT(count_mistakes)));
}

// What the ids in a leaf's range look like.
static Cause range_cause(const PackJob *in, const u32 *found)
{
    u32 i = 1;
    while (i < in->n_ids && found[i] == in->ids[i - 1]) {
        i++;
    }
    if (in->n_ids > 1 && i == in->n_ids && found[0] == in->n_ids) {
        return (Cause){.says = "a count stands before the ids, as in lab 02: here it is in the "
                               "node only"};
    }
    return list_cause(found, in->ids, in->n_ids);
}

// Do the ids stand at the array's beginning?
static int are_in_front(const PackJob *in, const PackAnswer3D *out)
{
    return in->n_before > 0 && in->n_ids > 0 && out->sphere_ids[0] == in->ids[0] &&
           out->sphere_ids[in->n_ids - 1] == in->ids[in->n_ids - 1];
}

// What is in the array: the leaf's range, and the rest of it.
static Diagnosis ids_fault(const PackJob *in, const PackAnswer3D *out)
{
    const u32 first = in->n_before, end = first + in->n_ids;
    for (u32 at = 0; at < PACK_MAP_ROOM; at++) {
        const int is_range = at >= first && at < end;
        const u32 found = out->sphere_ids[at];
        const u32 expected = is_range ? in->ids[at - first] : UNTOUCHED;
        if (found != expected && is_range) {
            return diagnosis_of(
                message_new(
                    "leaf with %u sphere%s, %u id%s before it: sphere_ids[%u] %s, expected %u",
                    in->n_ids, plural(in->n_ids), first, plural(first), at,
                    found == UNTOUCHED ? "was not written" : words("is %u", found).text, expected),
                range_cause(in, out->sphere_ids + first));
        }
        if (found != expected) {
            return diagnosis_of(message_new("sphere_ids[%u] was written, but the leaf's range goes "
                                            "from %u to before %u",
                                            at, first, end),
                                (Cause){.says = are_in_front(in, out)
                                                    ? "the ids go behind those of the leaves "
                                                      "before, not to the array's beginning"
                                                    : NULL});
        }
    }
    return out->n_sphere_ids == end
               ? NOTHING_WRONG
               : diagnosis_new("leaf with %u sphere%s, %u id%s before it: n_sphere_ids is %u "
                               "afterwards, expected %u",
                               in->n_ids, plural(in->n_ids), first, plural(first),
                               out->n_sphere_ids, end);
}

// Is a node as it was?
static Diagnosis node_fault(u32 leaf, const PackAnswer3D *out, u32 id)
{
    const KdNode3 node = out->nodes[id];
    const char *changed = node.split_pos != PACK_SPLIT_POS     ? "split_pos"
                          : node.split_axis != PACK_SPLIT_AXIS ? "split_axis"
                          : node.first != UNTOUCHED            ? "first"
                          : node.n_spheres != UNTOUCHED        ? "n_spheres"
                                                               : NULL;
    return changed == NULL ? NOTHING_WRONG
                           : diagnosis_new("packing leaf %u changed %s of node %u, expected it to "
                                           "leave other nodes as they are",
                                           leaf, changed, id);
}

// What the longest leaf looks like, the last one: a few ids say little.
static const char *longest_look(const Job06 *job, const PackAnswer3D *out)
{
    const PackJob *in = &job->packs[N_PACKS - 1];
    return range_cause(in, out[N_PACKS - 1].sphere_ids + in->n_before).says;
}

static Diagnosis pack_ids_fault(const void *job, int i, const void *answers)
{
    const PackJob *in = &((const Job06 *)job)->packs[i];
    const PackAnswer3D *out = (const PackAnswer3D *)answers + i;
    Diagnosis wrong = ids_fault(in, out);
    if (wrong.found != NULL && wrong.cause == NULL) {
        wrong = explained_06(wrong, longest_look(job, answers));
    }
    const float split_pos = out->nodes[in->id].split_pos;
    if (wrong.found == NULL && split_pos != PACK_SPLIT_POS) {
        wrong = diagnosis_new("packing leaf %u changed its split_pos from %g to %g, expected it to "
                              "stay: all but split_pos is set",
                              in->id, PACK_SPLIT_POS, split_pos);
    }
    for (u32 id = 0; wrong.found == NULL && id < PACK_NODES; id++) {
        wrong = id != in->id ? node_fault(in->id, out, id) : NOTHING_WRONG;
    }
    if (wrong.found == NULL && out->n_nodes != PACK_NODES) {
        wrong = diagnosis_new("packing leaf %u changed n_nodes to %u, expected it to stay %d",
                              in->id, out->n_nodes, PACK_NODES);
    }
    return wrong;
}

const Function pack_node_06 = {"pack", N_PACKS, sizeof(PackAnswer3D), .fault = pack_node_fault};
const Function pack_ids_06 = {"pack", N_PACKS, sizeof(PackAnswer3D), .fault = pack_ids_fault};

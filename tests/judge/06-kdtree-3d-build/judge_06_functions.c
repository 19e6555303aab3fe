// Lab 06: each function on the job's inputs. See judge_06.h.
#include "judge_06.h"

#include "message.h"
#include "overlap_cause.h"
#include "packed_list.h"
#include "words.h"

// ---- choose_split -------------------------------------------------------------------------------

static Diagnosis split_axis_fault(const void *job, int i, const void *answers)
{
    return tree3d_judge_axis("choose_split", ((const Job06 *)job)->splits[i],
                             ((const SplitAnswer3D *)answers)[i].axis);
}

// Where along the side that the student has chosen. An axis that is none is the other check's
// matter.
static Diagnosis split_middle_fault(const void *job, int i, const void *answers)
{
    const SplitAnswer3D found = ((const SplitAnswer3D *)answers)[i];
    return tree3d_judge_middle("choose_split", ((const Job06 *)job)->splits[i],
                               found.axis < 3 ? found.axis : 0, found.pos);
}

const Function split_axis_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                .fault = split_axis_fault};
const Function split_middle_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                  .fault = split_middle_fault};

// ---- sphere_overlaps_box ------------------------------------------------------------------------

// As overlap_cause.h has it.
static Reach reach_of(const void *job, int i)
{
    const SphereBoxJob in = ((const Job06 *)job)->overlaps[i];
    return (Reach){{outside_of(in.sphere.x, in.box.min[0], in.box.max[0]),
                    outside_of(in.sphere.y, in.box.min[1], in.box.max[1]),
                    outside_of(in.sphere.z, in.box.min[2], in.box.max[2])},
                   in.sphere.radius};
}

// What a wrong answer looks like.
//   remark   out: what joins the facts, "" for nothing
static Cause explain_overlap(const Job06 *job, int i, const i32 *found, const char **remark)
{
    const Cause cause = overlap_cause(reach_of, job, N_OVERLAPS, found);
    const Reach reach = reach_of(job, i);
    *remark = "";
    if (cause.says != NULL) {
        return cause;
    }
    if (found[i]) {
        return (Cause){.says = overlap_is_of_box(reach_of, job, N_OVERLAPS, found)
                                   ? "the sphere's bounding cube overlaps, the sphere does not"
                                   : NULL};
    }
    *remark = reach.outside[0] == 0 && reach.outside[1] == 0 && reach.outside[2] == 0
                  ? ", even its centre is inside"
                  : ", its centre is outside but the sphere reaches in";
    return (Cause){0};
}

static Diagnosis overlap_fault(const void *pointer, int i, const void *answers)
{
    const Job06 *job = pointer;
    const SphereBoxJob in = job->overlaps[i];
    const i32 *found = answers;
    const SphereInCell is = tree3d_judge_sphere(in.sphere, in.box);
    if (is == SPHERE_EITHER || (found[i] != 0) == (is == SPHERE_INSIDE)) {
        return NOTHING_WRONG;
    }
    const char *remark;
    const Cause cause = explain_overlap(job, i, found, &remark);
    return diagnosis_of(message_new("sphere at %s, box %s: found %d, expected %d%s",
                                    words_sphere(in.sphere).text, words_box3d(in.box).text,
                                    found[i], is == SPHERE_INSIDE, remark),
                        cause);
}

const Function overlap_06 = {"overlaps", N_OVERLAPS, sizeof(i32), .fault = overlap_fault};

// ---- pack_leaf_range ----------------------------------------------------------------------------

static Diagnosis pack_node_fault(const void *job, int i, const void *answers)
{
    const PackJob3D *in = &((const Job06 *)job)->packs[i];
    const PackAnswer3D *out = (const PackAnswer3D *)answers + i;
    const KdNode3 node = out->nodes[in->id];
    if (node.split_axis != KD_LEAF) {
        return diagnosis_new("node %u: split_axis is %u, expected KD_LEAF (%d)", in->id,
                             node.split_axis, KD_LEAF);
    }
    if (node.first != in->n_sphere_ids) {
        return diagnosis_new(
            "leaf with %u spheres, %u ids before it: first is %u, expected %u, where "
            "its first id goes",
            in->n_ids, in->n_sphere_ids, node.first, in->n_sphere_ids);
    }
    return node.n_spheres == in->n_ids
               ? NOTHING_WRONG
               : diagnosis_of(message_new("leaf with %u spheres: n_spheres is %u%s, expected %u",
                                          in->n_ids, node.n_spheres,
                                          node.n_spheres == UNTOUCHED ? ", not set" : "",
                                          in->n_ids),
                              number_cause(node.n_spheres, in->n_ids));
}

// What is in the array: the leaf's range, and the rest of it.
static Diagnosis ids_fault(const PackJob3D *in, const PackAnswer3D *out)
{
    const u32 first = in->n_sphere_ids, end = first + in->n_ids;
    for (u32 at = 0; at < PACK_MAP_ROOM; at++) {
        const int is_range = at >= first && at < end;
        const u32 found = out->sphere_ids[at];
        const u32 expected = is_range ? in->ids[at - first] : UNTOUCHED;
        if (found != expected && is_range) {
            return diagnosis_of(
                message_new(
                    "leaf with %u spheres, %u ids before it: sphere_ids[%u] %s, expected %u",
                    in->n_ids, first, at,
                    found == UNTOUCHED ? "was not written" : words("is %u", found).text, expected),
                list_cause(out->sphere_ids + first, in->ids, in->n_ids));
        }
        if (found != expected) {
            return diagnosis_new("sphere_ids[%u] was written, but the leaf's range goes from %u to "
                                 "before %u",
                                 at, first, end);
        }
    }
    return out->n_sphere_ids == end
               ? NOTHING_WRONG
               : diagnosis_new("leaf with %u spheres, %u ids before it: n_sphere_ids is %u "
                               "afterwards, expected %u",
                               in->n_ids, first, out->n_sphere_ids, end);
}

// Is a node as it was?
static Diagnosis node_fault(u32 leaf, const PackAnswer3D *out, u32 id)
{
    const KdNode3 node = out->nodes[id];
    const char *changed = node.split_pos != 0           ? "split_pos"
                          : node.split_axis != 0        ? "split_axis"
                          : node.first != UNTOUCHED     ? "first"
                          : node.n_spheres != UNTOUCHED ? "n_spheres"
                                                        : NULL;
    return changed == NULL ? NOTHING_WRONG
                           : diagnosis_new("packing leaf %u changed %s of node %u, expected it to "
                                           "leave other nodes as they are",
                                           leaf, changed, id);
}

static Diagnosis pack_ids_fault(const void *job, int i, const void *answers)
{
    const PackJob3D *in = &((const Job06 *)job)->packs[i];
    const PackAnswer3D *out = (const PackAnswer3D *)answers + i;
    Diagnosis wrong = ids_fault(in, out);
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

// ---- fits_todo ----------------------------------------------------------------------------------

static Diagnosis fits_fault(const void *job, int i, const void *answers)
{
    const int level = i + 1, expected = level <= TODO_SIZE;
    const i32 found = ((const i32 *)answers)[i];
    (void)job;
    return (found != 0) == expected
               ? NOTHING_WRONG
               : diagnosis_of(
                     message_new("level %d: found %d, expected %d", level, found, expected),
                     (Cause){.says = words("splitting there leaves up to %d nodes waiting, and "
                                           "TODO_SIZE is %d",
                                           level, TODO_SIZE)
                                         .text});
}

const Function fits_06 = {"todo", TODO_LEVELS, sizeof(i32), .fault = fits_fault};

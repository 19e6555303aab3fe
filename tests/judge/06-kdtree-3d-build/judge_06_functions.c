// Lab 06: each function on the job's inputs. See judge_06.h.
#include "judge_06.h"

#include "message.h"
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

// Do sphere and box touch, and no more? One that is a little smaller is outside then.
static int is_touching(SphereBoxJob in)
{
    const int overlaps = tree3d_judge_sphere(in.sphere, in.box) == SPHERE_INSIDE;
    in.sphere.radius -= (in.sphere.radius < 0 ? -1.0f : 1.0f) / 1024;
    return overlaps && tree3d_judge_sphere(in.sphere, in.box) == SPHERE_OUTSIDE;
}

// Is all that is wrong, in any check, that touching does not count?
static int is_strict(const Job06 *job, const i32 *found)
{
    for (int i = 0; i < N_OVERLAPS; i++) {
        const SphereBoxJob in = job->overlaps[i];
        const SphereInCell is = tree3d_judge_sphere(in.sphere, in.box);
        const int is_wrong = is != SPHERE_EITHER && (found[i] != 0) != (is == SPHERE_INSIDE);
        if (is_wrong && (found[i] || !is_touching(in))) {
            return 0;
        }
    }
    return 1;
}

// What a wrong answer looks like.
//   remark   out: what joins the facts, "" for nothing
static Cause explain_overlap(const Job06 *job, int i, const i32 *found, const char **remark)
{
    const SphereBoxJob in = job->overlaps[i];
    const double centre[3] = {in.sphere.x, in.sphere.y, in.sphere.z};
    int cube_overlaps = 1, is_centre_inside = 1;
    for (int axis = 0; axis < 3; axis++) {
        const double min = in.box.min[axis], max = in.box.max[axis];
        const double radius = in.sphere.radius < 0 ? -in.sphere.radius : in.sphere.radius;
        cube_overlaps &= centre[axis] + radius >= min && centre[axis] - radius <= max;
        is_centre_inside &= centre[axis] >= min && centre[axis] <= max;
    }
    *remark = "";
    if (found[i]) {
        return (Cause){.says = cube_overlaps
                                   ? "the sphere's bounding cube overlaps, the sphere does not"
                                   : NULL};
    }
    if (is_strict(job, found)) {
        return (Cause){"they touch, and touching counts: both have their boundaries",
                       MISTAKE_STRICT_BOUNDARY};
    }
    if (in.sphere.radius < 0) {
        return (Cause){.says = "a negative radius counts as its absolute value"};
    }
    *remark = is_centre_inside ? ", even its centre is inside"
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
               : diagnosis_new("leaf with %u spheres: n_spheres is %u%s, expected %u", in->n_ids,
                               node.n_spheres, node.n_spheres == UNTOUCHED ? ", not set" : "",
                               in->n_ids);
}

static Diagnosis pack_ids_fault(const void *job, int i, const void *answers)
{
    const PackJob3D *in = &((const Job06 *)job)->packs[i];
    const PackAnswer3D *out = (const PackAnswer3D *)answers + i;
    const u32 end = in->n_sphere_ids + in->n_ids;
    for (u32 at = 0; at < PACK_MAP_ROOM; at++) {
        const int is_range = at >= in->n_sphere_ids && at < end;
        const u32 found = out->sphere_ids[at];
        const u32 expected = is_range ? in->ids[at - in->n_sphere_ids] : UNTOUCHED;
        if (found != expected && is_range) {
            return diagnosis_new(
                "leaf with %u spheres, %u ids before it: sphere_ids[%u] %s, "
                "expected %u",
                in->n_ids, in->n_sphere_ids, at,
                found == UNTOUCHED ? "was not written" : words("is %u", found).text, expected);
        }
        if (found != expected) {
            return diagnosis_new("sphere_ids[%u] was written, but the leaf's range goes from %u to "
                                 "before %u",
                                 at, in->n_sphere_ids, end);
        }
    }
    if (out->n_sphere_ids != end) {
        return diagnosis_new(
            "leaf with %u spheres, %u ids before it: n_sphere_ids is %u afterwards, "
            "expected %u",
            in->n_ids, in->n_sphere_ids, out->n_sphere_ids, end);
    }
    for (u32 id = 0; id < PACK_NODES; id++) {
        const KdNode3 node = out->nodes[id];
        if (id != in->id && (node.split_pos != 0 || node.split_axis != 0 ||
                             node.first != UNTOUCHED || node.n_spheres != UNTOUCHED)) {
            return diagnosis_new("packing leaf %u changed node %u", in->id, id);
        }
    }
    return NOTHING_WRONG;
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

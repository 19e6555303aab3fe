// Lab 06: each function on the job's inputs. See judge_06.h.
#include "judge_06.h"

#include "message.h"

Verdict judge_06_splits(const Job06 *job, int check, const Sections *answers)
{
    const SplitAnswer3D *found = sections_find(answers, "splits", N_SPLITS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_SPLITS; i++) {
        // Which side is the one check, where along it the other: that one follows the student's
        // side. An axis that is none is the first check's matter.
        const u32 axis = found[i].axis < 3 ? found[i].axis : 0;
        char *message =
            check == SPLIT_AXIS
                ? tree3d_judge_axis("choose_split", job->splits[i], found[i].axis)
                : tree3d_judge_middle("choose_split", job->splits[i], axis, found[i].pos);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

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

static const char *explain_overlap(const Job06 *job, int i, const i32 *found)
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
    if (found[i]) {
        return cube_overlaps ? "; the sphere's bounding cube overlaps, the sphere does not" : "";
    }
    if (is_strict(job, found)) {
        return "; they touch, and touching counts: both have their boundaries";
    }
    if (in.sphere.radius < 0) {
        return "; a negative radius counts as its absolute value";
    }
    return is_centre_inside ? ", even its centre is inside"
                            : ", its centre is outside but the sphere reaches in";
}

Verdict judge_06_overlaps(const Job06 *job, int first, int n, const Sections *answers)
{
    const i32 *found = sections_find(answers, "overlaps", N_OVERLAPS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = first; i < first + n; i++) {
        const SphereBoxJob in = job->overlaps[i];
        const SphereInCell is = tree3d_judge_sphere(in.sphere, in.box);
        if (is != SPHERE_EITHER && (found[i] != 0) != (is == SPHERE_INSIDE)) {
            return verdict_of(message_new(
                "sphere at (%g, %g, %g) radius %g, box x [%g, %g] y [%g, %g] z [%g, %g]: found %d, "
                "expected %d%s",
                (double)in.sphere.x, (double)in.sphere.y, (double)in.sphere.z,
                (double)in.sphere.radius, (double)in.box.min[0], (double)in.box.max[0],
                (double)in.box.min[1], (double)in.box.max[1], (double)in.box.min[2],
                (double)in.box.max[2], found[i], is == SPHERE_INSIDE,
                explain_overlap(job, i, found)));
        }
    }
    return verdict_of(NULL);
}

static char *judge_pack_node(const PackJob3D *in, const PackAnswer3D *out)
{
    const KdNode3 node = out->nodes[in->id];
    if (node.split_axis != KD_LEAF) {
        return message_new("node %u: split_axis is %u, expected KD_LEAF (%d)", in->id,
                           node.split_axis, KD_LEAF);
    }
    if (node.first != in->n_sphere_ids) {
        return message_new(
            "leaf with %u spheres, %u ids before it: first is %u, expected %u, where "
            "its first id goes",
            in->n_ids, in->n_sphere_ids, node.first, in->n_sphere_ids);
    }
    return node.n_spheres == in->n_ids
               ? NULL
               : message_new("leaf with %u spheres: n_spheres is %u%s, expected %u", in->n_ids,
                             node.n_spheres, node.n_spheres == UNTOUCHED ? ", not set" : "",
                             in->n_ids);
}

static char *judge_pack_ids(const PackJob3D *in, const PackAnswer3D *out)
{
    const u32 end = in->n_sphere_ids + in->n_ids;
    for (u32 i = 0; i < PACK_MAP_ROOM; i++) {
        const int is_range = i >= in->n_sphere_ids && i < end;
        const u32 expected = is_range ? in->ids[i - in->n_sphere_ids] : UNTOUCHED;
        if (out->sphere_ids[i] != expected && is_range) {
            char found[16];
            snprintf(found, sizeof found, "is %u", out->sphere_ids[i]);
            return message_new("leaf with %u spheres, %u ids before it: sphere_ids[%u] %s, "
                               "expected %u",
                               in->n_ids, in->n_sphere_ids, i,
                               out->sphere_ids[i] == UNTOUCHED ? "was not written" : found,
                               expected);
        }
        if (out->sphere_ids[i] != expected) {
            return message_new("sphere_ids[%u] was written, but the leaf's range goes from %u to "
                               "before %u",
                               i, in->n_sphere_ids, end);
        }
    }
    if (out->n_sphere_ids != end) {
        return message_new("leaf with %u spheres, %u ids before it: n_sphere_ids is %u afterwards, "
                           "expected %u",
                           in->n_ids, in->n_sphere_ids, out->n_sphere_ids, end);
    }
    for (u32 id = 0; id < PACK_NODES; id++) {
        const KdNode3 node = out->nodes[id];
        if (id != in->id && (node.split_pos != 0 || node.split_axis != 0 ||
                             node.first != UNTOUCHED || node.n_spheres != UNTOUCHED)) {
            return message_new("packing leaf %u changed node %u", in->id, id);
        }
    }
    return NULL;
}

Verdict judge_06_pack(const Job06 *job, int check, const Sections *answers)
{
    const PackAnswer3D *found = sections_find(answers, "pack", N_PACKS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_PACKS; i++) {
        char *message = check == PACK_NODE ? judge_pack_node(&job->packs[i], &found[i])
                                           : judge_pack_ids(&job->packs[i], &found[i]);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

Verdict judge_06_fits(const Sections *answers)
{
    const i32 *found = sections_find(answers, "todo", TODO_LEVELS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int level = 1; level <= TODO_LEVELS; level++) {
        const int expected = level <= TODO_SIZE;
        if ((found[level - 1] != 0) != expected) {
            return verdict_of(message_new(
                "level %d: found %d, expected %d; splitting there leaves up to %d nodes waiting, "
                "and TODO_SIZE is %d",
                level, found[level - 1], expected, level, TODO_SIZE));
        }
    }
    return verdict_of(NULL);
}

// How a student's 3D kd-tree is packed: breadth-first, without gaps (see tree3d_judge.h).
#include "message.h"
#include "tree3d_walk.h"
#include "words.h"

// Where no right solution can differ: the first node or id that is not the expected one.
static Diagnosis judge_equal(const TreeScene3D *scene, const KdTree3D *own)
{
    const KdTree3D *tree = &scene->tree;
    if (own->n_nodes != tree->n_nodes || own->n_sphere_ids != tree->n_sphere_ids) {
        return diagnosis_new("%s: the tree has %u node%s and %u id%s, expected %u and %u",
                             scene->title, own->n_nodes, plural(own->n_nodes), own->n_sphere_ids,
                             plural(own->n_sphere_ids), tree->n_nodes, tree->n_sphere_ids);
    }
    for (u32 id = 0; id < own->n_nodes; id++) {
        const KdNode3 found = own->nodes[id], expected = tree->nodes[id];
        const int same_plane = found.split_axis == KD_LEAF || found.split_pos == expected.split_pos;
        if (found.split_axis != expected.split_axis || !same_plane ||
            found.first != expected.first || found.n_spheres != expected.n_spheres) {
            return diagnosis_new("%s: node %u: found split_axis %u, split_pos %s, first %u, "
                                 "n_spheres %u, expected %u, %s, %u, %u",
                                 scene->title, id, found.split_axis,
                                 words_float(found.split_pos).text, found.first, found.n_spheres,
                                 expected.split_axis, words_float(expected.split_pos).text,
                                 expected.first, expected.n_spheres);
        }
    }
    for (u32 i = 0; i < own->n_sphere_ids; i++) {
        if (own->sphere_ids[i] != tree->sphere_ids[i]) {
            return diagnosis_new("%s: sphere_ids[%u] is %u, expected %u", scene->title, i,
                                 own->sphere_ids[i], tree->sphere_ids[i]);
        }
    }
    return NOTHING_WRONG;
}

Diagnosis tree3d_judge_packing(const TreeScene3D *scene, const KdTree3D *own)
{
    u32 next_child = 1, next_id = 0;
    for (u32 id = 0; id < own->n_nodes; id++) {
        const KdNode3 node = own->nodes[id];
        if (is_leaf_node(own, id)) {
            if (leaf_ids(own, id) == NULL) {
                return bad_range(scene, own, id);
            }
            if (node.first != next_id) {
                return diagnosis_new("%s: leaf %u: first is %u, expected %u, behind the ids of the "
                                     "leaf before it",
                                     scene->title, id, node.first, next_id);
            }
            const Diagnosis wrong = judge_order(scene, own, id);
            if (wrong.found != NULL) {
                return wrong;
            }
            next_id += node.n_spheres;
            continue;
        }
        if (node.split_axis > KD_LEAF || node.n_spheres != 0) {
            return diagnosis_new("%s: node %u: split_axis is %u and n_spheres %u, expected an axis "
                                 "and 0, or KD_LEAF (%d)",
                                 scene->title, id, node.split_axis, node.n_spheres, KD_LEAF);
        }
        if (node.first != next_child) {
            const char *looks =
                node.first <= id ? "is it a leaf that is not marked KD_LEAF?" : NULL;
            return diagnosis_of(message_new("%s: node %u's children are %u and %u, expected %u and "
                                            "%u (breadth-first)",
                                            scene->title, id, node.first, node.first + 1,
                                            next_child, next_child + 1),
                                (Cause){.says = looks});
        }
        next_child += 2;
    }
    if (next_child != own->n_nodes || next_id != own->n_sphere_ids) {
        return diagnosis_new(
            "%s: %u node%s and %u id%s belong to the tree, but its arrays hold %u and "
            "%u",
            scene->title, next_child, plural(next_child), next_id, plural(next_id), own->n_nodes,
            own->n_sphere_ids);
    }
    return scene->is_exact ? judge_equal(scene, own) : NOTHING_WRONG;
}

// Growing the oracle's kd-trees (see oracle_tree.h).
#include "oracle_tree.h"

#include "complain.h"

#include <stdlib.h>

int oracle_is_leaf(int level, u32 n_ids, int n_failed, KdTreeLimits limits)
{
    const int may_split = level < limits.maxDepth && n_failed < MAX_FAILED_SPLITS;
    return !may_split || (int64_t)n_ids <= limits.targetElementsPerNode;
}

int oracle_split_fails(u32 n_ids, u32 n_lower, u32 n_higher)
{
    // By what is lost: of twice the number at most a tenth.
    const int64_t n_lost = 2 * (int64_t)n_ids - n_lower - n_higher;
    return 10 * n_lost <= 2 * (int64_t)n_ids;
}

// Room for one element more behind *used of them. Returns 0, or -1 after one message.
static int make_room(void **array, u32 used, u32 *room, size_t n_bytes)
{
    if (used < *room) {
        return 0;
    }
    const u32 larger = 2 * used + 64;
    void *moved = realloc(*array, larger * n_bytes);
    if (moved == NULL) {
        complain("grade: no memory for a tree");
        return -1;
    }
    *array = moved;
    *room = larger;
    return 0;
}

// Append a leaf, with the list of all that overlaps its cell. Returns 0, or -1 after one message.
static int add_leaf(Growth *growth, GrownNode leaf, const GrowthRules *rules)
{
    for (u32 id = 0; id < rules->n_elements; id++) {
        void *ids = growth->ids;
        if (!rules->overlaps(rules->scene, id, leaf.cell)) {
            continue;
        }
        if (make_room(&ids, growth->n_ids, &growth->id_room, sizeof *growth->ids) != 0) {
            return -1;
        }
        growth->ids = ids;
        leaf.first_id = leaf.n_ids++ == 0 ? growth->n_ids : leaf.first_id;
        growth->ids[growth->n_ids++] = id;
    }
    void *nodes = growth->nodes;
    if (make_room(&nodes, growth->n_nodes, &growth->node_room, sizeof *growth->nodes) != 0) {
        return -1;
    }
    growth->nodes = nodes;
    growth->nodes[growth->n_nodes++] = leaf;
    return 0;
}

// Split a leaf, the tree's last one that is not closed. Returns 0, or -1 after one message.
static int split_leaf(Growth *growth, u32 at, const GrowthRules *rules)
{
    const GrownNode node = growth->nodes[at];
    const u32 child = growth->n_nodes, first_child = node.id + child - at;
    BBox3D halves[2];
    const u32 axis = rules->halve(node.cell, halves);
    for (u32 side = 0; side < 2; side++) {
        const GrownNode leaf = {.scene = node.scene,
                                .id = first_child + side,
                                .level = node.level + 1,
                                .cell = halves[side]};
        if (add_leaf(growth, leaf, rules) != 0) {
            return -1;
        }
    }
    GrownNode *children = &growth->nodes[child];
    growth->nodes[at].first_child = first_child;
    growth->nodes[at].split_axis = axis;
    children[0].n_failed = children[1].n_failed =
        node.n_failed + oracle_split_fails(node.n_ids, children[0].n_ids, children[1].n_ids);
    return 0;
}

int growth_add(Growth *growth, u32 scene, BBox3D root, const GrowthRules *rules)
{
    const u32 first = growth->n_nodes;
    const GrownNode leaf = {.scene = scene, .level = 1, .cell = root};
    int result = add_leaf(growth, leaf, rules);
    for (u32 at = first; result == 0 && at < growth->n_nodes; at++) {
        const GrownNode *node = &growth->nodes[at];
        if (!oracle_is_leaf(node->level, node->n_ids, node->n_failed, rules->limits)) {
            result = split_leaf(growth, at, rules);
        }
    }
    return result;
}

void growth_free(Growth *growth)
{
    free(growth->nodes);
    free(growth->ids);
    *growth = (Growth){0};
}

const GrownNode *growth_nodes(const Growth *growth, u32 scene, u32 *n_nodes)
{
    u32 first = 0;
    while (first < growth->n_nodes && growth->nodes[first].scene != scene) {
        first++;
    }
    *n_nodes = 0;
    while (first + *n_nodes < growth->n_nodes && growth->nodes[first + *n_nodes].scene == scene) {
        ++*n_nodes;
    }
    return growth->nodes + first;
}

const GrownNode *grown_child(const GrownNode *node, int side)
{
    return node - node->id + node->first_child + side;
}

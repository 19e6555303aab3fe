// Counting what a builder hands on (see handed_on.h).
//
// Read next: case_build.c.
#include "handed_on.h"

#include "complain.h"

#include <stdlib.h>
#include <string.h>

// A node of either tree.
typedef struct Node {
    int is_leaf;
    u32 first_child, second_child;  // of an inner node
    const u32 *ids;                 // of a leaf, [n_ids]
    u32 n_ids;
} Node;

typedef Node NodeOf(const void *tree, u32 id);

static Node node_2d(const void *pointer, u32 id)
{
    const KdTree2D *tree = pointer;
    const NodeRel relations = tree->nodes_Relations[id];
    if (tree->nodes_flag[id] == INNER) {
        return (Node){0, relations.lChild, relations.rChild, NULL, 0};
    }
    const u32 *list = tree->mapNode2Circles + relations.circleMapOffset;
    return (Node){1, 0, 0, list + 1, list[0]};
}

static Node node_3d(const void *pointer, u32 id)
{
    const KdTree3D *tree = pointer;
    const KdNode3 node = tree->nodes[id];
    return node.split_axis == KD_LEAF
               ? (Node){1, 0, 0, tree->sphere_ids + node.first, node.n_spheres}
               : (Node){0, node.first, node.first + 1, NULL, 0};
}

typedef struct Count {
    const void *tree;
    NodeOf *node_of;
    u32 *seen_in;  // [n_elements], the last node that an element was found in, plus 1
    double n_handed_on;
} Count;

// Write the ids of a node's elements, each once. Returns how many they are.
//   ids   out: room for all entries of the leaves below
static u32 collect(Count *count, u32 id, u32 *ids)
{
    const Node node = count->node_of(count->tree, id);
    u32 n = node.n_ids;
    if (node.is_leaf) {
        memcpy(ids, node.ids, n * sizeof *ids);
    } else {
        const u32 n_first = collect(count, node.first_child, ids);
        const u32 n_both = n_first + collect(count, node.second_child, ids + n_first);
        for (u32 i = 0; i < n_both; i++) {
            if (count->seen_in[ids[i]] != id + 1) {
                count->seen_in[ids[i]] = id + 1;
                ids[n++] = ids[i];
            }
        }
    }
    count->n_handed_on += n;
    return n;
}

static double count_all(const void *tree, NodeOf *node_of, u32 n_elements, u32 n_entries)
{
    // calloc() may answer NULL to a size of 0.
    Count count = {tree, node_of, calloc((size_t)n_elements + 1, sizeof *count.seen_in), 0};
    u32 *ids = calloc((size_t)n_entries + 1, sizeof *ids);
    if (count.seen_in == NULL || ids == NULL) {
        complain("handed on: no memory for %u elements", n_elements);
        count.n_handed_on = -1;
    } else {
        collect(&count, 0, ids);
    }
    free(count.seen_in);
    free(ids);
    return count.n_handed_on;
}

double handed_on_2d(const KdTree2D *tree, u32 n_elements)
{
    return count_all(tree, node_2d, n_elements, tree->n_map);
}

double handed_on_3d(const KdTree3D *tree, u32 n_elements)
{
    return count_all(tree, node_3d, n_elements, tree->n_sphere_ids);
}

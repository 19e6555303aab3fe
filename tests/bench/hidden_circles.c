// Lists with hidden circles (see hidden_circles.h).
//
// Read next: trick_case.c.
#include "hidden_circles.h"

#include "array_reserve.h"
#include "complain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// From a pixel to the one behind the last, on x and y.
typedef struct PixelRange {
    i32 min[2];
    i32 max[2];
} PixelRange;

typedef struct Builder {
    const CircleTree *circles;
    CircleTree tree;
    u32 capacity;
} Builder;

// Pixels are points: the last ones are at the border.
static int overlaps(TileCircle circle, PixelRange pixels)
{
    const float dx =
        fmaxf(fmaxf((float)pixels.min[0] - circle.x, 0), circle.x - (float)(pixels.max[0] - 1));
    const float dy =
        fmaxf(fmaxf((float)pixels.min[1] - circle.y, 0), circle.y - (float)(pixels.max[1] - 1));
    return dx * dx + dy * dy <= circle.radius_squared;
}

// Write a leaf's list anew. Returns 0, or -1 when memory runs out.
static int list_circles(Builder *builder, TileNode *leaf, PixelRange pixels)
{
    CircleTree *tree = &builder->tree;
    const CircleTree *circles = builder->circles;
    TileCircle *room = array_reserve(tree->leaf_circles, tree->n_leaf_circles,
                                     circles->n_leaf_circles, &builder->capacity, sizeof *room);
    if (room == NULL) {
        return -1;
    }
    tree->leaf_circles = room;
    leaf->first = tree->n_leaf_circles;
    for (u32 i = 0; i < circles->n_leaf_circles; i++) {
        if (overlaps(circles->leaf_circles[i], pixels)) {
            room[tree->n_leaf_circles++] = circles->leaf_circles[i];
        }
    }
    leaf->n_circles = tree->n_leaf_circles - leaf->first;
    return 0;
}

// The lists of node `id` and of all below it. Returns 0, or -1 when memory runs out.
static int list_below(Builder *builder, u32 id, PixelRange pixels)
{
    TileNode *node = &builder->tree.nodes[id];
    if (node->split_axis == KD_LEAF) {
        return list_circles(builder, node, pixels);
    }
    PixelRange lower = pixels, upper = pixels;
    lower.max[node->split_axis] = upper.min[node->split_axis] = node->split_pos;
    return list_below(builder, node->first, lower) == 0
               ? list_below(builder, node->first + 1, upper)
               : -1;
}

int hidden_circles_add(const CircleTree *tree, int side, const CircleTree *circles,
                       CircleTree *hidden)
{
    Builder builder = {.circles = circles, .tree = {.n_nodes = tree->n_nodes}};
    builder.tree.nodes = malloc(tree->n_nodes * sizeof *tree->nodes);
    int result = builder.tree.nodes != NULL ? 0 : -1;
    if (result == 0) {
        memcpy(builder.tree.nodes, tree->nodes, tree->n_nodes * sizeof *tree->nodes);
        result = list_below(&builder, 0, (PixelRange){{0, 0}, {side, side}});
    }
    if (result != 0) {
        complain("bench_tricks: no memory for lists with hidden circles");
        circle_tree_free(&builder.tree);
    }
    *hidden = builder.tree;
    return result;
}

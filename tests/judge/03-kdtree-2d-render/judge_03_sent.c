// Inputs of lab 03's getContainingChild that the kernel sends in the pictures by which the other
// tasks are judged: who is wrong in a picture is wrong here, too. See judge_03.h.
//
// The trees of the scenes come one behind the other; ids count from the beginning of each. A leaf
// map of high ids is left out: families have such ids.
#include "judge_03.h"

#include "sent.h"

#include <string.h>

static int is_on_border(const BBox2D *left, i32 x, i32 y)
{
    const f32 column = (f32)x, row = (f32)y;
    return column == left->minX || column == left->maxX || row == left->minY || row == left->maxY;
}

// Keep what a pixel sends on its way to its leaf: of the nodes into whose left child it goes one,
// and of those into whose right child.
//   inside   where the next ones go
static void keep_pixel(Random *random, const KdTree2D *tree, ChildJob job, ChildJob **inside,
                       Sent *border)
{
    ChildJob kept[2] = {0};
    Sent into[2] = {SENT_TO(&kept[0], 1), SENT_TO(&kept[1], 1)};
    while (cell_holds(tree->nodes_BBox[0], job.x, job.y) && tree->nodes_flag[job.id] != LEAF) {
        const NodeRel node = tree->nodes_Relations[job.id];
        const BBox2D *left = &tree->nodes_BBox[node.lChild];
        const int is_right = !cell_holds(*left, job.x, job.y);
        sent_keep(is_on_border(left, job.x, job.y) ? border : &into[is_right], random, &job);
        job.id = is_right ? node.rChild : node.lChild;
    }
    for (int side = 0; side < 2; side++) {
        if (into[side].n_come > 0) {
            *(*inside)++ = kept[side];
        }
    }
}

static int is_sent(int k)
{
    return k != LEAF_MAP;
}

u32 count_sent_nodes_03(const JobScene scenes[N_SCENES])
{
    u32 n_nodes = 0;
    for (int k = 0; k < N_SCENES; k++) {
        n_nodes += is_sent(k) ? scenes[k].tree.n_nodes : 0;
    }
    return n_nodes;
}

void add_sent_03(Random *random, const JobScene scenes[N_SCENES], u32 first, KdTree2D *more,
                 ChildJob inside[N_SENT_INSIDE], ChildJob border[N_SENT_BORDER * N_SCENES])
{
    for (int k = 0; k < N_SCENES; k++) {
        const KdTree2D *tree = &scenes[k].tree;
        if (is_sent(k)) {
            memcpy(more->nodes_Relations + first, tree->nodes_Relations,
                   tree->n_nodes * sizeof(NodeRel));
            memcpy(more->nodes_BBox + first, tree->nodes_BBox, tree->n_nodes * sizeof(BBox2D));
            Sent on_border = SENT_TO(border + k * N_SENT_BORDER, N_SENT_BORDER);
            const int width = scenes[k].scene.width, n_pixels = width * scenes[k].scene.height;
            for (int i = 0; i < n_pixels; i++) {
                const ChildJob job = {i % width, i / width, 0, first};
                keep_pixel(random, tree, job, &inside, &on_border);
            }
            first += tree->n_nodes;
        }
    }
}

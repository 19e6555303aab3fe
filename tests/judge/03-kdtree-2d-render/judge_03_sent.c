// Inputs of lab 03's getContainingChild that the kernel sends in the pictures by which the other
// tasks are judged: who is wrong in a picture is wrong here, too. See judge_03.h.
//
// The trees of the scenes come one behind the other; ids count from the beginning of each. A leaf
// map of high ids is left out: families have such ids.
#include "judge_03.h"

#include <string.h>

// The calls of a pixel on its way to its leaf, sorted: one of each kind, all with the same chance.
enum { INTO_LEFT, INTO_RIGHT, ON_BORDER, N_KINDS };
typedef struct Calls {
    int n[N_KINDS];
    ChildJob jobs[N_KINDS];
} Calls;

static int kind_of(const BBox2D *left, int x, int y)
{
    const f32 column = (f32)x, row = (f32)y;
    return column == left->minX || column == left->maxX || row == left->minY || row == left->maxY
               ? ON_BORDER
           : cell_holds(*left, x, y) ? INTO_LEFT
                                     : INTO_RIGHT;
}

static Calls calls_of(Random *random, const KdTree2D *tree, u32 first, int x, int y)
{
    Calls calls = {{0}, {{0}}};
    u32 id = 0;
    while (cell_holds(tree->nodes_BBox[0], x, y) && tree->nodes_flag[id] != LEAF) {
        const NodeRel node = tree->nodes_Relations[id];
        const int kind = kind_of(&tree->nodes_BBox[node.lChild], x, y);
        if (random_integer(random, 0, calls.n[kind]++) == 0) {
            calls.jobs[kind] = (ChildJob){x, y, id, first};
        }
        id = cell_holds(tree->nodes_BBox[node.lChild], x, y) ? node.lChild : node.rChild;
    }
    return calls;
}

// Keep what the pixels of a scene send. What there is no call for stays as it is rolled.
//   inside, border   where the next calls go
static void keep_calls(Random *random, const JobScene *scene, u32 first, ChildJob **inside,
                       ChildJob border[N_SENT_BORDER])
{
    int n_on_border = 0;
    for (int i = 0; i < scene->scene.width * scene->scene.height; i++) {
        const int x = i % scene->scene.width, y = i / scene->scene.width;
        const Calls calls = calls_of(random, &scene->tree, first, x, y);
        for (int kind = INTO_LEFT; kind <= INTO_RIGHT; kind++) {
            if (calls.n[kind] > 0) {
                *(*inside)++ = calls.jobs[kind];
            }
        }
        if (calls.n[ON_BORDER] > 0) {
            const int place = (int)random_integer(random, 0, n_on_border++);
            if (place < N_SENT_BORDER) {
                border[place] = calls.jobs[ON_BORDER];
            }
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
            keep_calls(random, &scenes[k], first, &inside, border + k * N_SENT_BORDER);
            first += tree->n_nodes;
        }
    }
}

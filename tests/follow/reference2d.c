// A pixel among circles, followed in double precision (see reference_steps.h). On the scenes' grid
// of 1/16 px nothing is rounded, so nothing is close.
#include "oracle2d.h"
#include "reference_steps.h"

#include <math.h>

static int is_in(BBox2D box, int x, int y)
{
    return box.minX <= x && x < box.maxX && box.minY <= y && y < box.maxY;
}

// Go down to the pixel's leaf. Returns its id.
static u32 descend(const KdTree2D *tree, int x, int y, Steps *steps)
{
    u32 id = 0;
    while (tree->nodes_flag[id] == INNER) {
        const NodeRel node = tree->nodes_Relations[id];
        // A pixel outside of the root may end anywhere: no circle covers it.
        const int is_close = !is_in(tree->nodes_BBox[0], x, y);
        reference_add(steps, (Step){.kind = STEP_NODE, .id = id, .is_close = (u32)is_close});
        id = is_in(tree->nodes_BBox[node.lChild], x, y) ? node.lChild : node.rChild;
    }
    return id;
}

// Ask circle `id`; `nearest` is the depth to beat, and `end` takes the colour.
static void ask(const Circle *circles, u32 id, int x, int y, f32 *nearest, Step *end, Steps *steps)
{
    const Circle circle = circles[id];
    const int is_nearer = circle.depth < *nearest && oracle2d_covers(circle, x, y);
    reference_add(steps, (Step){.kind = STEP_TEST,
                                .id = id,
                                .nearest = *nearest,
                                .answer = (f32)is_nearer,
                                .element = {circle.x, circle.y, circle.radius, circle.depth}});
    if (is_nearer) {
        *nearest = circle.depth;
        const f32 colour[] = {circle.r, circle.g, circle.b, circle.a};
        for (int channel = 0; channel < 4; channel++) {
            end->element[channel] = colour[channel];
        }
    }
}

void reference2d_follow(const World *world, int x, int y, Steps *steps)
{
    const WorldData data = world->kind->data(world);
    const KdTree2D *tree = data.tree2d;
    Step end = {.kind = STEP_END, .id = NO_ID};
    f32 nearest = INFINITY;
    if (tree == NULL) {
        for (u32 id = 0; id < (u32)world->n_elements; id++) {
            ask(data.circles, id, x, y, &nearest, &end, steps);
        }
    } else {
        end.id = descend(tree, x, y, steps);
        reference_add(steps, (Step){.kind = STEP_LEAF, .id = end.id});
        const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[end.id].circleMapOffset;
        for (u32 i = 1; i <= list[0]; i++) {
            ask(data.circles, list[i], x, y, &nearest, &end, steps);
        }
    }
    reference_add(steps, end);
}

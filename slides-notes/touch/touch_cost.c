// 08-cost: the reader moves a split, and sees what it costs. A step is the next candidate plane.
//
// Planes and costs are those of lab 08's own functions. Read next: draw_cost.c.
#include "figures3d.h"
#include "kdtree3d_sah.h"
#include "touch.h"

static int plane = N_BINS / 2;

static int cost_open(void)
{
    return 0;
}

static int cost_drag(double x, double y)
{
    (void)y;
    plane = cost_plane_at(x);
    return plane - 1;
}

static int cost_move(int right, int down, int other)
{
    (void)other;
    plane += right - down;
    plane = plane < 1 ? 1 : plane < N_BINS ? plane : N_BINS - 1;
    return plane - 1;
}

static u32 cost_count_steps(void)
{
    return N_BINS - 1;
}

static u32 cost_still_step(void)
{
    return N_BINS / 2 - 1;
}

static void cost_draw(FILE *file, u32 step, FigureShape shape)
{
    plane = (int)step + 1;
    draw_cost_plane(file, plane, shape);
}

static void cost_tell(FILE *file, u32 step)
{
    cost_plane_tell(file, (int)step + 1);
}

const TouchFigure TOUCH_COST = {
    .name = "08-cost",
    .what = "What a split costs: drag the plane, or move it with the arrow keys",
    .open = cost_open,
    .drag = cost_drag,
    .move = cost_move,
    .count_steps = cost_count_steps,
    .still_step = cost_still_step,
    .draw = cost_draw,
    .tell = cost_tell,
};

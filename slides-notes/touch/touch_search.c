// 03-search: the reader drags the pixel of lab 03, and sees the search for its leaf.
//
// Scene and tree are those of the still figure (tests/figures/figures2d.c); the steps are those of
// lab 03's kernel, written down by the recorder of common/follow. Read next: draw_search.c.
#include "figures2d.h"
#include "kdtree2d_build.h"
#include "touch.h"

#include <math.h>
#include <stdlib.h>

static const WorldTree TREE = {.build.circles = kdtree2d_build};
static const WorldKernel KERNEL = {
    .label = "kd-tree",
    .path = "03-kdtree-2d-render/implicit2DRenderer_KD.cl",
    .function = "implicit2DRenderer_KD",
    .tree = &TREE,
    .options = "",
    .steps_path = "03-kdtree-2d-render.cl",
    .set_arguments = circles_set_tree,
};
static const WorldLab LAB_03 = {
    .name = "03-kdtree-2d-render",
    .kind = &CIRCLES,
    .kernels = &KERNEL,
    .n_kernels = 1,
};

static Lab lab = {.name = "03-kdtree-2d-render",
                  .options = {.scene = "example", .max_depth = 4, .leaf_size = 1}};
static World world;
static Followed followed;

static void pixel_follow(int x, int y)
{
    x = x < 0 ? 0 : x < world.width ? x : world.width - 1;
    y = y < 0 ? 0 : y < world.height ? y : world.height - 1;
    if (followed_make(&followed, &world, &LAB_03, x, y) != 0) {
        abort();
    }
}

static int search_open(void)
{
    if (world_open(&world, &lab, &LAB_03) != 0) {
        return -1;
    }
    pixel_follow(7, 7);
    return 0;
}

static int search_drag(double x, double y)
{
    double scene_x, scene_y;
    search_point(&followed, x, y, &scene_x, &scene_y);
    pixel_follow((int)lround(scene_x), (int)lround(scene_y));
    return STEP_STAYS;
}

static int search_move(int right, int down, int other)
{
    (void)other;
    pixel_follow(followed.x + right, followed.y + down);
    return STEP_STAYS;
}

static u32 search_count_steps(void)
{
    return steps_kept(followed.own.n_steps);
}

static u32 search_still_step(void)
{
    return search_count_steps() - 1;
}

static void search_draw(FILE *file, u32 step, FigureShape shape)
{
    draw_search_step(file, &followed, step, shape);
}

static void search_tell(FILE *file, u32 step)
{
    search_step_tell(file, &followed, step);
}

const TouchFigure TOUCH_SEARCH = {
    .name = "03-search",
    .what = "The search for a pixel's leaf: drag the pixel, or move it with the arrow keys",
    .open = search_open,
    .drag = search_drag,
    .move = search_move,
    .count_steps = search_count_steps,
    .still_step = search_still_step,
    .draw = search_draw,
    .tell = search_tell,
};

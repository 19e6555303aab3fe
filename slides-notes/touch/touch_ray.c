// 07-search: the reader drags the ray of lab 07 or its eye, and sees node, t_split and todo stack.
//
// The scene is the worked example's, tests/scenes/worked.nff; the ray goes through the middle of a
// picture of 3 x 3 pixels, so that turning the view turns it. The steps are those of lab 07's
// kernel, written down by the recorder of common/follow. Read next: draw_search3d.c.
#include "figures3d.h"
#include "kdtree3d_build.h"
#include "touch.h"

#include <math.h>
#include <stdlib.h>

static const WorldTree TREE = {.build.spheres = kdtree3d_build, .limits = tree3d_limits};
static const WorldKernel KERNEL = {
    .label = "kd-tree",
    .path = "07-kdtree-3d-trace/render_kdtree.cl",
    .function = "render_kdtree",
    .tree = &TREE,
    .options = "",
    .steps_path = "07-kdtree-3d-trace.cl",
    .set_arguments = spheres_set_tree,
};
static const WorldLab LAB_07 = {
    .name = "07-kdtree-3d-trace",
    .kind = &SPHERES,
    .kernels = &KERNEL,
    .n_kernels = 1,
};

static Lab lab = {.name = "07-kdtree-3d-trace",
                  .options = {.scene = "lattice:n=2", .width = 3, .height = 3, .leaf_size = 1}};
static World world;
static Followed followed;

// The ray: its eye, and a point that it goes through; level, at the height of the lower spheres.
static const f32 HEIGHT = -0.5f;
static Vec3 eye = {-2.1f, -1.1f, -0.5f}, aim = {-1.3f, -0.5f, -0.5f};
static int eye_is_taken;

// How far keys turn the ray, radians, and move its eye, scene units.
static const f32 KEY_ANGLE = (f32)M_PI / 90, KEY_STEP = 0.1f;

// Nearer to the eye than this a point is the eye, and no direction.
static const f32 EYE_REACH = 0.2f;

// What the drawing shows, about (PLAN_MIDDLE_X, 0).
static const f32 PLAN_MIDDLE_X = -0.7f, PLAN_REACH_X = 2, PLAN_REACH_Y = 1.5f;

static void ray_follow(void)
{
    world.pose = (Pose){{eye.x, eye.y, eye.z, aim.x, aim.y, aim.z, 0, 0, 1}};
    if (world.kind->place(&world) != 0 || followed_make(&followed, &world, &LAB_07, 1, 1) != 0) {
        abort();
    }
}

static int ray_open(void)
{
    if (world_open(&world, &lab, &LAB_07) != 0) {
        return -1;
    }
    ray_follow();
    return 0;
}

static Vec3 point_at(double x, double y)
{
    double scene_x, scene_y;
    search3d_point(x, y, &scene_x, &scene_y);
    return (Vec3){(f32)scene_x, (f32)scene_y, HEIGHT};
}

static int is_at_eye(Vec3 point)
{
    return vec3_length(vec3_minus(point, eye)) < EYE_REACH;
}

static void ray_take(double x, double y)
{
    eye_is_taken = is_at_eye(point_at(x, y));
}

// The eye takes the ray along, as it is; it stays in the drawing.
static void eye_move(f32 x, f32 y)
{
    if (fabsf(eye.x + x - PLAN_MIDDLE_X) > PLAN_REACH_X || fabsf(eye.y + y) > PLAN_REACH_Y) {
        return;
    }
    eye.x += x;
    eye.y += y;
    aim.x += x;
    aim.y += y;
}

static int ray_drag(double x, double y)
{
    const Vec3 point = point_at(x, y);
    if (eye_is_taken) {
        eye_move(point.x - eye.x, point.y - eye.y);
    } else if (!is_at_eye(point)) {
        aim = point;
    }
    ray_follow();
    return STEP_STAYS;
}

static int ray_move(int right, int down, int other)
{
    if (other) {
        eye_move(KEY_STEP * (f32)right, -KEY_STEP * (f32)down);
    } else {
        const f32 angle = -KEY_ANGLE * (f32)(right + down);
        const Vec3 way = vec3_minus(aim, eye);
        aim.x = eye.x + cosf(angle) * way.x - sinf(angle) * way.y;
        aim.y = eye.y + sinf(angle) * way.x + cosf(angle) * way.y;
    }
    ray_follow();
    return STEP_STAYS;
}

static u32 ray_count_steps(void)
{
    return steps_kept(followed.own.n_steps);
}

static u32 ray_still_step(void)
{
    return search3d_still_step(&followed);
}

static void ray_draw(FILE *file, u32 step, FigureShape shape)
{
    draw_search3d_step(file, &followed, step, shape);
}

static void ray_tell(FILE *file, u32 step)
{
    search3d_step_tell(file, &followed, step);
}

const TouchFigure TOUCH_RAY = {
    .name = "07-search",
    .what =
        "The search along a ray: drag the ray or its eye; arrow keys turn it, with Shift they move "
        "the eye",
    .open = ray_open,
    .take = ray_take,
    .drag = ray_drag,
    .move = ray_move,
    .count_steps = ray_count_steps,
    .still_step = ray_still_step,
    .draw = ray_draw,
    .tell = ray_tell,
};

// 06-planes.svg: a tree whose nodes have planes and no boxes, and who waits on the way down.
#include "figures3d.h"

#include "complain.h"

#include <math.h>

// The plane of x and y from above, and the tree beside it. Pixels.
enum { PLAN_LEFT = 40, PLAN_TOP = 104, UNIT = 176, EYE_ROOM = 40 };
enum { TREE_LEFT = 440, TREE_RIGHT = 992, FIRST_LEVEL = 118, LEVEL = 92, HEIGHT = 530 };

// The worked example's tree is full: node ids of level n begin with 2^(n-1) - 1.
static int level_of(u32 id)
{
    int level = 1;
    while (id + 1 >= 1u << level) {
        level++;
    }
    return level;
}

static double node_x(u32 id)
{
    const int level = level_of(id);
    const double number = (double)(id + 1 - (1u << (level - 1)));
    return TREE_LEFT + (number + 0.5) * (TREE_RIGHT - TREE_LEFT) / (1 << (level - 1));
}

static double node_y(u32 id)
{
    return FIRST_LEVEL + (level_of(id) - 1) * LEVEL;
}

// The first leaf of the recorded ray: where it stands among the steps.
static u32 first_leaf(const Steps *steps)
{
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        if (steps->steps[i].kind == STEP_LEAF) {
            return i;
        }
    }
    complain("figures3d: the ray meets no leaf");
    exit(EXIT_FAILURE);
}

// ---- The plan ----------------------------------------------------------------------------------

static double plan_x(const BBox3D *box, double x)
{
    return PLAN_LEFT + EYE_ROOM + (x - box->min[0]) * UNIT;
}

static double plan_y(const BBox3D *box, double y)
{
    return PLAN_TOP + (box->max[1] - y) * UNIT;
}

static void ray_part_draw(FILE *file, const Followed *followed, const BBox3D *box, double t_min,
                          double t_max, const char *look)
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    svg_line(file, plan_x(box, o[0] + t_min * d[0]), plan_y(box, o[1] + t_min * d[1]),
             plan_x(box, o[0] + t_max * d[0]), plan_y(box, o[1] + t_max * d[1]), look);
}

// Whose part of the ray it is, beside the part's middle.
static void owner_draw(FILE *file, const Followed *followed, const BBox3D *box, double t_min,
                       double t_max, u32 node)
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    const double t = (t_min + t_max) / 2;
    svg_title(file, plan_x(box, o[0] + t * d[0]) + 18, plan_y(box, o[1] + t * d[1]) + 24,
              SVG_MIDDLE, "", "%u", node);
}

static void plan_draw(FILE *file, const Followed *followed, u32 leaf_step)
{
    const KdTree3D *tree = followed->world->kind->data(followed->world).tree3d;
    const BBox3D *box = &tree->bounds;
    const double right = plan_x(box, box->max[0]), bottom = plan_y(box, box->min[1]);
    svg_box(file, plan_x(box, box->min[0]), PLAN_TOP, right - plan_x(box, box->min[0]),
            bottom - PLAN_TOP,
            "fill=\"none\" stroke=\"" SVG_GREY "\" stroke-width=\"2\" stroke-dasharray=\"8 5\"");
    // Node 0's plane, and those of its children, which end at it.
    const double x = plan_x(box, tree->nodes[0].split_pos);
    const double y = plan_y(box, tree->nodes[1].split_pos);
    svg_line(file, x, PLAN_TOP, x, bottom, "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
    svg_line(file, plan_x(box, box->min[0]), y, right, y,
             "stroke=\"" SVG_BLUE "\" stroke-width=\"5\"");
    svg_text(file, x, PLAN_TOP - 12, SVG_MIDDLE, "", "node 0: x = %g", tree->nodes[0].split_pos);
    svg_text(file, plan_x(box, box->min[0]) + 8, y + 66, SVG_LEFT, SVG_HALO, "node 1: y = %g",
             tree->nodes[1].split_pos);
    svg_text(file, right - 8, y + 60, SVG_RIGHT, SVG_HALO, "node 2: y = %g",
             tree->nodes[2].split_pos);

    const Steps *own = &followed->own;
    const Step *root = &own->steps[0], *leaf = &own->steps[leaf_step];
    StepWaiting waiting[TODO_SIZE];
    const u32 n_waiting = followed_waiting(own, leaf_step, waiting);
    ray_part_draw(file, followed, box, root->t_min - 0.12, root->t_max + 0.2,
                  "stroke=\"" SVG_BLACK "\" stroke-width=\"2\" marker-end=\"url(#head)\"");
    ray_part_draw(file, followed, box, leaf->t_min, leaf->t_max,
                  "stroke=\"" SVG_BLACK "\" stroke-width=\"10\"");
    owner_draw(file, followed, box, leaf->t_min, leaf->t_max, leaf->id);
    for (u32 i = 0; i < n_waiting; i++) {
        ray_part_draw(file, followed, box, waiting[i].t_min, waiting[i].t_max,
                      "stroke=\"" SVG_BLACK "\" stroke-width=\"7\" stroke-dasharray=\"12 5\"");
        owner_draw(file, followed, box, waiting[i].t_min, waiting[i].t_max, waiting[i].node);
    }
    svg_text(file, PLAN_LEFT, bottom + 34, SVG_LEFT, "", "dashed: the one box, the scene's,");
    svg_text(file, PLAN_LEFT, bottom + 62, SVG_LEFT, "", "from above. The ray's part in it:");
    svg_text(file, PLAN_LEFT, bottom + 90, SVG_LEFT, "", "%.4g to %.4g, cut by planes alone",
             root->t_min, root->t_max);
}

// ---- The tree ----------------------------------------------------------------------------------

static int is_on_way(const Steps *steps, u32 leaf_step, u32 id)
{
    for (u32 i = 0; i <= leaf_step; i++) {
        if (steps->steps[i].id == id) {
            return 1;
        }
    }
    return 0;
}

static const StepWaiting *waits(const StepWaiting *waiting, u32 n_waiting, u32 id)
{
    for (u32 i = 0; i < n_waiting; i++) {
        if (waiting[i].node == id) {
            return &waiting[i];
        }
    }
    return NULL;
}

static void node_draw(FILE *file, const Followed *followed, u32 leaf_step, u32 id)
{
    StepWaiting waiting[TODO_SIZE];
    const u32 n_waiting = followed_waiting(&followed->own, leaf_step, waiting);
    const StepWaiting *waiter = waits(waiting, n_waiting, id);
    const char *look = "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"1.5\"";
    if (waiter != NULL) {
        look = "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK
               "\" stroke-width=\"3\" stroke-dasharray=\"6 4\"";
    } else if (is_on_way(&followed->own, leaf_step, id)) {
        look = "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\"";
    }
    const KdNode3 node = followed->world->kind->data(followed->world).tree3d->nodes[id];
    if (node.split_axis == KD_LEAF) {
        svg_box(file, node_x(id) - 22, node_y(id) - 20, 44, 40, look);
    } else {
        svg_circle(file, node_x(id), node_y(id), 22, look);
    }
    svg_text(file, node_x(id), node_y(id) + 7, SVG_MIDDLE, "", "%u", id);
    if (waiter != NULL) {
        // No farther right than the tree.
        const double middle = fmin(node_x(id) + 30, TREE_RIGHT - 98);
        svg_text(file, middle, node_y(id) - 34, SVG_MIDDLE, SVG_HALO, "waits: %.4g to %.4g",
                 waiter->t_min, waiter->t_max);
    }
}

static void tree_draw(FILE *file, const Followed *followed, u32 leaf_step)
{
    const KdTree3D *tree = followed->world->kind->data(followed->world).tree3d;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        for (u32 child = 0; tree->nodes[id].split_axis != KD_LEAF && child < 2; child++) {
            const u32 to = tree->nodes[id].first + child;
            svg_line(file, node_x(id), node_y(id), node_x(to), node_y(to),
                     is_on_way(&followed->own, leaf_step, to)
                         ? "stroke=\"" SVG_BLACK "\" stroke-width=\"6\""
                         : "stroke=\"" SVG_GREY "\" stroke-width=\"1.5\"");
        }
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        node_draw(file, followed, leaf_step, id);
    }
}

void draw_planes(FILE *file, const Followed *followed)
{
    const u32 leaf_step = first_leaf(&followed->own);
    const Step *leaf = &followed->own.steps[leaf_step];
    svg_begin(file, HEIGHT, "Planes without boxes, and who waits",
              "Left, from above: the scene's box is the only one. The plane of node 0 cuts the "
              "ray's part in it in two, the plane of node 1 the nearer half once more. Right, the "
              "tree of nodes 0 to 14: the way down is 0, 1, 3 to leaf 7; nodes 2 and 4, the other "
              "children where both were met, wait with their parts of the ray.");
    svg_title(file, 24, 40, SVG_LEFT, "", "A node has a plane; the ray carries its part of it");
    plan_draw(file, followed, leaf_step);
    tree_draw(file, followed, leaf_step);
    svg_text(file, TREE_LEFT, HEIGHT - 56, SVG_LEFT, "",
             "In leaf %u, on level %d, %u nodes wait: each node", leaf->id, level_of(leaf->id),
             leaf->n_waiting);
    svg_text(file, TREE_LEFT, HEIGHT - 28, SVG_LEFT, "",
             "on the way adds one at most, so at most %d here", level_of(leaf->id) - 1);
    svg_end(file);
}

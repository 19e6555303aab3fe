// Building the kd-tree of Part A (see circle_tree.h).
//
// Flow: scene -> BUFFERS -> kernel -> image. Called by circles.c. Read next: circle_tile.cl.
#include "circle_tree.h"

#include "array_reserve.h"
#include "complain.h"
#include "kdtree2d_build.h"

#include <math.h>
#include <string.h>

// From a tile to the one behind the last: [min, max) on x and y.
typedef struct TileRange {
    u32 min[2];
    u32 max[2];
} TileRange;

typedef struct Builder {
    const Circle *h_circles;
    KdTreeLimits limits;
    CircleTree tree;
    u32 node_capacity, circle_capacity;
} Builder;

// ---- Circles ------------------------------------------------------------------------------------

typedef struct Depth {
    f32 depth;
    u32 id;
} Depth;

// Nearer first; of two equals the one with the lower index, as in lab 01.
static int compare_depths(const void *left, const void *right)
{
    const Depth *l = left, *r = right;
    if (l->depth != r->depth) {
        return l->depth < r->depth ? -1 : 1;
    }
    return l->id < r->id ? -1 : l->id > r->id;
}

// The ids of a scene's circles, nearest first, or NULL when memory runs out.
static u32 *sorted_ids(const Scene2D *scene)
{
    const size_t n = (size_t)scene->n_circles;
    Depth *depths = malloc((n + 1) * sizeof *depths);
    u32 *ids = malloc((n + 1) * sizeof *ids);
    if (depths == NULL || ids == NULL) {
        free(depths);
        free(ids);
        return NULL;
    }
    for (u32 i = 0; i < n; i++) {
        depths[i] = (Depth){scene->circles[i].depth, i};
    }
    qsort(depths, n, sizeof *depths, compare_depths);
    for (u32 i = 0; i < n; i++) {
        ids[i] = depths[i].id;
    }
    free(depths);
    return ids;
}

// The kernel compares in float: how much larger or smaller a circle may be there. With u = 2^-24,
// the rounding of one operation, dx and dy are off by u, so their squares by 3 u, the sum by 4 u,
// and the square of the radius by u. These 5 u of squares are less than 3 u of the radius.
#define RADIUS_ERROR 0x1p-22f

static Circle circle_grown(Circle circle, float share)
{
    circle.radius *= 1 + share;
    return circle;
}

// Does a circle cover a box whole? Its farthest corner says.
static int circle_covers_box(Circle circle, BBox2D box)
{
    const double x = circle.x, y = circle.y, radius = circle.radius;
    const double dx = fmax(x - box.minX, box.maxX - x), dy = fmax(y - box.minY, box.maxY - y);
    return dx * dx + dy * dy <= radius * radius;
}

// Pick from a node's circles those that may be seen in some tiles, however the kernel rounds, in
// the same order.
//   seen_ids   out: room for n_ids
// Returns how many there are.
static u32 pick_seen(const Circle *h_circles, const u32 *ids, u32 n_ids, TileRange tiles,
                     u32 *seen_ids)
{
    // Pixels are points: the box ends at the last ones.
    const float side = CIRCLE_TILE_SIDE;
    const BBox2D box = {tiles.min[0] * side, tiles.max[0] * side - 1, tiles.min[1] * side,
                        tiles.max[1] * side - 1};
    u32 n_seen = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Circle circle = h_circles[ids[i]];
        if (circle_overlaps_box(circle_grown(circle, RADIUS_ERROR), box)) {
            seen_ids[n_seen++] = ids[i];
            if (circle_covers_box(circle_grown(circle, -RADIUS_ERROR), box)) {
                break;  // All that follow are behind it.
            }
        }
    }
    return n_seen;
}

// RGBA, a byte each: the nearest, as in a PNG.
static u32 pack_color(Circle circle)
{
    const float channels[] = {circle.r, circle.g, circle.b, circle.a};
    u32 color = 0;
    for (int i = 0; i < 4; i++) {
        color |= (u32)lrintf(fminf(fmaxf(channels[i], 0), 1) * 255) << (8 * i);
    }
    return color;
}

// ---- Nodes --------------------------------------------------------------------------------------

// Append n nodes. Returns the first one's id, or -1 when memory runs out.
static int64_t add_nodes(Builder *builder, u32 n)
{
    CircleTree *tree = &builder->tree;
    TileNode *nodes =
        array_reserve(tree->nodes, tree->n_nodes, n, &builder->node_capacity, sizeof *nodes);
    if (nodes == NULL) {
        return -1;
    }
    tree->nodes = nodes;
    tree->n_nodes += n;
    return tree->n_nodes - n;
}

static int close_as_leaf(Builder *builder, u32 id, const u32 *ids, u32 n_ids)
{
    CircleTree *tree = &builder->tree;
    TileCircle *circles = array_reserve(tree->leaf_circles, tree->n_leaf_circles, n_ids,
                                        &builder->circle_capacity, sizeof *circles);
    if (circles == NULL) {
        return -1;
    }
    tree->leaf_circles = circles;
    tree->nodes[id] =
        (TileNode){.split_axis = KD_LEAF, .first = tree->n_leaf_circles, .n_circles = n_ids};
    for (u32 i = 0; i < n_ids; i++) {
        const Circle circle = builder->h_circles[ids[i]];
        circles[tree->n_leaf_circles++] =
            (TileCircle){circle.x, circle.y, circle.radius * circle.radius, pack_color(circle)};
    }
    return 0;
}

// Make node `id` an inner node or a leaf, and all below it.
//   ids[n_ids]   the circles that may be seen in its tiles, nearest first
//   level        1 for the root
// Returns 0, or -1 when memory runs out.
static int close_node(Builder *builder, u32 id, TileRange tiles, const u32 *ids, u32 n_ids,
                      int level)
{
    const u32 axis = tiles.max[0] - tiles.min[0] >= tiles.max[1] - tiles.min[1] ? 0 : 1;
    if (level >= builder->limits.maxDepth || n_ids <= (u32)builder->limits.targetElementsPerNode ||
        tiles.max[axis] - tiles.min[axis] <= 1) {
        return close_as_leaf(builder, id, ids, n_ids);
    }
    // The middle tile's border: lab 02's middle of the longer side, snapped.
    const u32 split = (tiles.min[axis] + tiles.max[axis]) / 2;
    const int64_t first = add_nodes(builder, 2);
    u32 *seen_ids = malloc((n_ids + 1) * sizeof *seen_ids);
    int result = first < 0 || seen_ids == NULL ? -1 : 0;
    if (result == 0) {
        builder->tree.nodes[id] = (TileNode){(i32)(split * CIRCLE_TILE_SIDE), axis, (u32)first, 0};
    }
    for (u32 child = 0; child < 2 && result == 0; child++) {
        TileRange half = tiles;
        *(child == 0 ? &half.max[axis] : &half.min[axis]) = split;
        const u32 n_seen = pick_seen(builder->h_circles, ids, n_ids, half, seen_ids);
        result = close_node(builder, (u32)first + child, half, seen_ids, n_seen, level + 1);
    }
    free(seen_ids);
    return result;
}

static u32 count_tiles(int n_pixels)
{
    return ((u32)n_pixels + CIRCLE_TILE_SIDE - 1) / CIRCLE_TILE_SIDE;
}

int circle_tree_build(const Scene2D *scene, KdTreeLimits limits, CircleTree *tree)
{
    Builder builder = {.h_circles = scene->circles, .limits = limits};
    const TileRange all = {{0, 0}, {count_tiles(scene->width), count_tiles(scene->height)}};
    u32 *ids = sorted_ids(scene);
    const int is_built =
        ids != NULL && add_nodes(&builder, 1) == 0 &&
        close_node(&builder, 0, all, ids,
                   pick_seen(scene->circles, ids, (u32)scene->n_circles, all, ids), 1) == 0;
    free(ids);
    if (!is_built) {
        complain("circle_tree: no memory for the tree over %d circles", scene->n_circles);
        circle_tree_free(&builder.tree);
        return -1;
    }
    *tree = builder.tree;
    return 0;
}

void circle_tree_free(CircleTree *tree)
{
    free(tree->nodes);
    free(tree->leaf_circles);
    *tree = (CircleTree){0};
}

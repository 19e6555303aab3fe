// Right answers of lab 10, in plain C: circles pixel by pixel, and what holds for a tile of rays by
// its outermost ones.
//
// Whole scenes are answered ray by ray (right_answers_3d.h), at no cost: only too much work is
// wrong. Read next: right_answers.h.
#ifndef UNIT_RIGHT_ANSWERS_TILES_H
#define UNIT_RIGHT_ANSWERS_TILES_H

#include "jobs_07.h"
#include "jobs_10.h"
#include "right_answers_sections.h"

#include <math.h>
#include <string.h>

// How many scenes it has; the work of all is judged.
enum { N_TILE_SCENES = 17 };

static float distance_to_plane(const TilePlaneJob *in, float direction)
{
    const int meets = in->eye <= in->plane ? direction > 0 : direction < 0;
    return meets ? (in->plane - in->eye) / direction : INFINITY;
}

static void answer_tile_planes(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const TilePlaneJob *in = sections_find_any(job, "tile_planes", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    TilePlaneAnswer *out = calloc(n, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        const float a = distance_to_plane(&in[i], in[i].low);
        const float b = distance_to_plane(&in[i], in[i].high);
        out[i] = (TilePlaneAnswer){fminf(a, b), fmaxf(a, b)};
    }
    answer(writer, "tile_planes", out, n * sizeof *out);
    free(out);
}

static NextChildAnswer child_of_tile(const TileChildJob *in)
{
    const u32 side = in->eye > in->node.split_pos;
    TodoEntry near_child = in->at, far_child = in->at;
    near_child.node = in->node.first + side;
    far_child.node = in->node.first + 1 - side;
    NextChildAnswer out = {near_child, in->todo};
    if (in->split_low > in->at.t_max) {
        return out;
    }
    if (in->split_high < in->at.t_min) {
        out.next = far_child;
        return out;
    }
    far_child.t_min = fmaxf(in->at.t_min, in->split_low);
    out.next.t_max = fminf(in->at.t_max, in->split_high);
    out.todo.upper[in->todo.n - in->todo.n_lower] = far_child;
    out.todo.n++;
    return out;
}

static void answer_tile_children(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const TileChildJob *in = sections_find_any(job, "tile_children", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    NextChildAnswer *out = calloc(n, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = child_of_tile(&in[i]);
    }
    answer(writer, "tile_children", out, n * sizeof *out);
    free(out);
}

static void answer_tile_waiting(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const TileWaitingJob *in = sections_find_any(job, "tile_waiting", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    NextWaitingAnswer *out = calloc(n, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        u32 left = in[i].todo.n;  // what waits on top of these is left out
        while (left > 0 && in[i].todo.upper[left - 1].t_min > in[i].farthest) {
            left--;
        }
        out[i] = (NextWaitingAnswer){left > 0, in[i].at, in[i].todo};
        if (left > 0) {
            out[i].at = in[i].todo.upper[left - 1];
            out[i].todo.n = left - 1;
        }
    }
    answer(writer, "tile_waiting", out, n * sizeof *out);
    free(out);
}

static void answer_cones(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const ConeJob *in = sections_find_any(job, "cones", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    i32 *out = calloc(n, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        const float along = vec3_dot(in[i].centre, in[i].axis);
        const float aside =
            (float)vec3_length(vec3_minus(in[i].centre, vec3_scaled(in[i].axis, along)));
        out[i] = aside * in[i].cosine - along * in[i].sine > fabsf(in[i].radius);
    }
    answer(writer, "cones", out, n * sizeof *out);
    free(out);
}

// ---- Part A -------------------------------------------------------------------------------------

static void paint_pixel(i32 *open, u32 *color, int is_covered, u32 of_circle)
{
    if (is_covered && *open) {
        *color = of_circle;
        *open = 0;
    }
}

static void answer_circle_rows(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const CircleRowJob *in = sections_find_any(job, "circle_rows", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    CircleRowAnswer *out = calloc(n, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        for (int k = 0; k < ROW_PIXELS; k++) {
            out[i].open[k] = in[i].open[k];
            out[i].colors[k] = in[i].colors[k];
            paint_pixel(&out[i].open[k], &out[i].colors[k],
                        in[i].dx_squared[k] + in[i].dy * in[i].dy <= in[i].radius_squared,
                        in[i].color);
        }
    }
    answer(writer, "circle_rows", out, n * sizeof *out);
    free(out);
}

static TileLeafAnswer leaf_of_tile(const CircleTileJob *tile, const TileNode *nodes)
{
    TileLeafAnswer way = {0, 0};
    for (; nodes[way.leaf].split_axis != KD_LEAF; way.n_steps++) {
        const TileNode node = nodes[way.leaf];
        way.leaf = node.first + ((node.split_axis == 0 ? tile->x : tile->y) >= node.split_pos);
    }
    return way;
}

// Eight circles, then a look whether a pixel is open still, as the given loop does.
static CircleTileAnswer painted_tile(const CircleTileJob *tile, const TileNode *nodes,
                                     const TileCircle *circles)
{
    const TileNode leaf = nodes[leaf_of_tile(tile, nodes).leaf];
    i32 open[CIRCLE_TILE_PIXELS];
    memset(open, -1, sizeof open);
    CircleTileAnswer out = {.n_tests = 0};
    int n_open = CIRCLE_TILE_PIXELS;
    for (u32 i = 0; i < leaf.n_circles && (i % 8 != 0 || n_open > 0); i++) {
        const TileCircle circle = circles[leaf.first + i];
        n_open = 0;
        for (int k = 0; k < CIRCLE_TILE_PIXELS; k++) {
            const float dx = (float)(tile->x + k % ROW_PIXELS) - circle.x;
            const float dy = (float)(tile->y + k / ROW_PIXELS) - circle.y;
            paint_pixel(&open[k], &out.colors[k], dx * dx + dy * dy <= circle.radius_squared,
                        circle.color);
            n_open += open[k] != 0;
        }
        out.n_tests++;
    }
    return out;
}

static void answer_circle_tiles(Writer *writer, const Sections *job)
{
    size_t n_bytes, n_other;
    const TileNode *nodes = sections_find_any(job, "circle_nodes", &n_other);
    const TileCircle *circles = sections_find_any(job, "leaf_circles", &n_other);
    const CircleTileJob *in = sections_find_any(job, "tile_leaves", &n_bytes);
    const size_t n = n_bytes / sizeof *in;
    TileLeafAnswer *leaves = calloc(n, sizeof *leaves);
    CircleTileAnswer *tiles = calloc(n, sizeof *tiles);
    for (size_t i = 0; i < n; i++) {
        leaves[i] = leaf_of_tile(&in[i], nodes + in[i].first_node);
        tiles[i] = painted_tile(&in[i], nodes + in[i].first_node, circles + in[i].first_circle);
    }
    answer(writer, "tile_leaves", leaves, n * sizeof *leaves);
    answer(writer, "circle_tiles", tiles, n * sizeof *tiles);
    free(leaves);
    free(tiles);
}

#endif

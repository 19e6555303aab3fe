// Right answers of lab 10, in plain C: what holds for a tile, by its outermost rays.
//
// Whole scenes are answered ray by ray (right_answers_3d.h), at no cost: only too much work is
// wrong. Read next: right_answers.h.
#ifndef UNIT_RIGHT_ANSWERS_TILES_H
#define UNIT_RIGHT_ANSWERS_TILES_H

#include "jobs_10.h"
#include "right_answers_sections.h"

#include <math.h>

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
    StackEntry near_child = in->at, far_child = in->at;
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
        u32 left = in[i].todo.n;
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

#endif

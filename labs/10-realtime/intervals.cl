// Lab 10: one traversal for a whole tile. In lab 07 t_split and the part of the ray in a node are
// numbers. Here they are intervals, which contain the number of every ray.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by trace_tile.cl.
#include "kdtree3d.h"
#include "tile.h"
#include "todo.h"

// Where do the rays of a tile meet a plane? A ray meets it only if it goes from the eye's side to
// the other side. An eye on the plane counts as below it. A ray that does not meet the plane has
// the distance INFINITY.
//   plane       its coordinate, on one axis
//   eye         the eye's, on the same axis
//   direction   of the rays, on the same axis: at least one has the lowest, one the highest
// Returns the least and the greatest distance of all rays: INFINITY, twice, where none meets it.
Interval plane_interval(float plane, float eye, Interval direction)
{
    // TASK plane_interval: t = (plane - eye) / direction. Which of the two ends gives the least
    // distance, which one the greatest, and when does an end not meet the plane at all?
    (void)plane, (void)eye, (void)direction;
    return (Interval){0.0f, INFINITY};
    // END plane_interval
}

// Go on from an inner node: to which child? Must the other one wait?
//   node      the inner node
//   eye       its coordinate on node.split_axis
//   t_split   plane_interval() of the node's plane
//   at        the node, and the part of the tile's rays inside it: from the least t_min to the
//             greatest t_max of all rays
//   todo      out: if both children are met, the far one is on top
// Returns the child to visit next, with the part of the rays inside it.
TodoEntry next_tile_child(KdNode3 node, float eye, Interval t_split, TodoEntry at, Todo *todo)
{
    // TASK next_tile_child: the near child is on the eye's side of the plane. If every ray's part
    // ends before the plane, visit the near child only; if every part begins beyond it, the far
    // child only. Else visit both. The near child's part ends at t_split.high, the far child's
    // begins at t_split.low.
    (void)eye, (void)t_split, (void)todo;
    return (TodoEntry){node.first, at.t_min, at.t_max};
    // END next_tile_child
}

// Go on after a leaf that has been searched, unless the search is over.
//   farthest   the farthest of all rays' hits so far; INFINITY as long as one has none
//   todo       the nodes that wait
//   at         in: the leaf; out: the node to visit next, taken from the stack, with its part,
//              which may end at the farthest hit
// Returns 1, or 0 when the search is over.
int next_tile_waiting(float farthest, Todo *todo, TodoEntry *at)
{
    // TASK next_tile_waiting: take nodes from the stack until one is found in which some ray may
    // find a nearer hit. A node that begins behind the farthest hit is left out. The one below it
    // may still matter, because parts of many rays overlap.
    (void)farthest, (void)todo, (void)at;
    return 0;
    // END next_tile_waiting
}

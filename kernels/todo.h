// The todo stack of a ray: nodes that are still to be visited, the nearest on top, each with the
// part of the ray inside it. The device's own; of the host, only the grader knows an entry.
//
// Why a stack of our own? OpenCL C knows no recursion. Its size is fixed; that it never overflows
// is the builder's promise (TODO_SIZE in kdtree3d.h).
// Lecture: slide "KD-Tree Raytracing". Flow: scene -> buffers -> KERNEL -> image. Read next:
// trace.cl of lab 07.
#ifndef KERNELS_TODO_H
#define KERNELS_TODO_H

#include "kdtree3d.h"
#include "layout.h"

// A node to visit, and the part of the ray inside it.
typedef struct TodoEntry {
    /* 0 */ u32 node;  // id
    /* 4 */ f32 t_min;
    /* 8 */ f32 t_max;
} TodoEntry;
LAYOUT_ASSERT(TodoEntry, 12);

#ifdef __OPENCL_C_VERSION__

typedef struct Todo {
    TodoEntry entries[TODO_SIZE];
    uint n;  // how many wait; starts at 0
} Todo;

// Put a node on top.
static inline void todo_push(Todo *todo, uint node, float t_min, float t_max)
{
    todo->entries[todo->n].node = node;
    todo->entries[todo->n].t_min = t_min;
    todo->entries[todo->n].t_max = t_max;
    todo->n++;
}

// Take the node on top away; there must be one.
static inline TodoEntry todo_pop(Todo *todo)
{
    todo->n--;
    return todo->entries[todo->n];
}

#endif

#endif

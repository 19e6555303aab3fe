// The todo stack of a ray: nodes that are still to be visited, the nearest on top, each with the
// part of the ray inside it. The device's own.
//
// Why a stack of our own? OpenCL C knows no recursion. Its size is fixed; that it never overflows
// is the builder's promise (TODO_SIZE in kdtree3d.h).
// Lecture: "todo stack". Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next:
// trace.cl of lab 07.
#ifndef KERNELS_TODO_H
#define KERNELS_TODO_H

#include "kdtree3d.h"

#ifdef __OPENCL_C_VERSION__

typedef struct TodoEntry {
    uint node;  // id
    float t_near;
    float t_far;
} TodoEntry;

typedef struct Todo {
    TodoEntry entries[TODO_SIZE];
    uint n;  // how many wait; starts at 0
} Todo;

// Put a node on top.
static inline void todo_push(Todo *todo, uint node, float t_near, float t_far)
{
    todo->entries[todo->n].node = node;
    todo->entries[todo->n].t_near = t_near;
    todo->entries[todo->n].t_far = t_far;
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

// Todo stacks of inputs and answers (StackState of jobs.h) as a search on the device has them, for
// the probes of labs 07 and 10. Included behind the kernel, which knows what a Todo is.
#ifndef PROBES_PROBE_STACK_H
#define PROBES_PROBE_STACK_H

// What the lower entries of a stack look like.
constant TodoEntry lowest = {UNTOUCHED - 1, 1.0f, 2.0f};

// A stack, and room behind its end: what is put there by mistake spoils nothing of other inputs,
// which are tried behind this one.
typedef struct RoomyTodo {
    Todo todo;
    uint room[16];
} RoomyTodo;

static void fill_stack(StackState state, Todo *todo)
{
    todo->n = state.n;
    for (uint i = 0; i < TODO_SIZE; i++) {
        todo->entries[i] = lowest;
    }
    for (uint i = 0; i < STACK_ENTRIES; i++) {
        todo->entries[state.n_lower + i] = state.upper[i];
    }
}

// What became of a stack with n_lower entries like `lowest`.
static StackState look_at_stack(uint n_lower, const Todo *todo)
{
    StackState state;
    state.n = todo->n;
    state.n_lower = 0;
    for (uint i = 0; i < n_lower; i++) {
        const TodoEntry entry = todo->entries[i];
        state.n_lower +=
            entry.node == lowest.node && entry.t_min == lowest.t_min && entry.t_max == lowest.t_max;
    }
    for (uint i = 0; i < STACK_ENTRIES; i++) {
        state.upper[i] = todo->entries[n_lower + i];
    }
    return state;
}

#endif

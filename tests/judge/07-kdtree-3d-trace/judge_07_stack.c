// The todo stacks of lab 07's inputs and answers: see judge_07_stack.h.
#include "judge_07_stack.h"

float random_quarters(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, lowest, highest) / 4;
}

StackState random_stack(Random *random, u32 n_lower, u32 n_upper)
{
    StackState todo = {.n_lower = n_lower, .n = n_lower + n_upper};
    for (u32 i = 0; i < STACK_ENTRIES; i++) {
        const float t_min = random_quarters(random, 40, 80);
        if (i < n_upper) {
            const u32 node = (u32)random_integer(random, 2000, 3000);
            todo.upper[i] = (StackEntry){node, t_min, t_min + random_quarters(random, 1, 20)};
        } else {
            todo.upper[i] = (StackEntry){UNTOUCHED, 0, 0};
        }
    }
    return todo;
}

int same_entry(StackEntry a, StackEntry b)
{
    return a.node == b.node && a.t_min == b.t_min && a.t_max == b.t_max;
}

int same_stack(const StackState *a, const StackState *b)
{
    int is_same = a->n == b->n && a->n_lower == b->n_lower && a->n <= a->n_lower + STACK_ENTRIES;
    for (u32 i = 0; is_same && i + a->n_lower < a->n; i++) {
        is_same = same_entry(a->upper[i], b->upper[i]);
    }
    return is_same;
}

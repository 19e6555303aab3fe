// Todo stacks of inputs and answers (see job_stack.h).
#include "job_stack.h"

#include "kdtree3d.h"
#include "random3d.h"

float random_quarters(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, lowest, highest) / 4;
}

StackState random_stack(Random *random, u32 n_lower, u32 n_upper)
{
    StackState todo = {.n_lower = n_lower, .n = n_lower + n_upper};
    for (u32 i = 0; i < STACK_ENTRIES; i++) {
        TodoEntry *entry = &todo.upper[i];
        const float t_min = random_quarters(random, 40, 80);
        *entry = (TodoEntry){UNTOUCHED, 0, 0};
        if (i < n_upper) {
            entry->node = (u32)random_integer(random, 2000, 3000);
            entry->t_min = t_min;
            entry->t_max = t_min + random_quarters(random, 1, 20);
        }
    }
    return todo;
}

StackState random_stack_with_room(Random *random)
{
    if (one_in(random, 8)) {
        return random_stack(random, TODO_SIZE - STACK_ENTRIES, STACK_ENTRIES - 1);
    }
    const int64_t n_lower =
        one_in(random, 2) ? 0 : random_integer(random, 1, TODO_SIZE - STACK_ENTRIES);
    return random_stack(random, (u32)n_lower, (u32)random_integer(random, 0, STACK_ENTRIES - 1));
}

void stack_begin_at(StackState *todo, float t)
{
    for (u32 i = todo->n - todo->n_lower; i > 0; i--) {
        TodoEntry *entry = &todo->upper[i - 1];
        entry->t_max += t - entry->t_min;
        entry->t_min = t;
        t = entry->t_max;
    }
}

void stack_scale(StackState *todo, float factor)
{
    for (u32 i = 0; i < STACK_ENTRIES; i++) {
        todo->upper[i].t_min *= factor;
        todo->upper[i].t_max *= factor;
    }
}

int same_entry(TodoEntry a, TodoEntry b)
{
    return a.node == b.node && a.t_min == b.t_min && a.t_max == b.t_max;
}

int same_stack(const StackState *a, const StackState *b)
{
    int is_same = a->n == b->n && a->n_lower == b->n_lower;
    for (u32 i = 0; is_same && i < STACK_ENTRIES && i + a->n_lower < a->n; i++) {
        is_same = same_entry(a->upper[i], b->upper[i]);
    }
    return is_same;
}

int same_waiting(const NextWaitingAnswer *found, NextWaitingAnswer expected)
{
    return expected.goes_on ? found->goes_on && same_entry(found->at, expected.at) &&
                                  same_stack(&found->todo, &expected.todo)
                            : !found->goes_on;
}

// "and node 13 with [4, 5] put on the stack".
static Words put_words(const StackState *before, const StackState *todo)
{
    const u32 n_upper = todo->n - todo->n_lower;
    if (todo->n_lower != before->n_lower || todo->n < before->n) {
        return words("a node that waits is gone");
    }
    if (todo->n == before->n) {
        return words("nothing put on the stack");
    }
    if (todo->n == before->n + 1 && n_upper <= STACK_ENTRIES) {
        const TodoEntry top = todo->upper[n_upper - 1];
        return words("node %u with [%.9g, %.9g] put on the stack", top.node, top.t_min, top.t_max);
    }
    return words("%u nodes put on the stack", todo->n - before->n);
}

NextWaitingAnswer with_part(NextWaitingAnswer answer, float t_min, float t_max)
{
    answer.at.t_min = t_min;
    answer.at.t_max = t_max;
    return answer;
}

NextWaitingAnswer with_one_more(NextWaitingAnswer answer)
{
    answer.todo.n++;
    return answer;
}

Words next_child_words(const StackState *before, const NextChildAnswer *answer)
{
    return words("node %u with [%.9g, %.9g], and %s", answer->next.node, answer->next.t_min,
                 answer->next.t_max, put_words(before, &answer->todo).text);
}

Words next_waiting_words(const NextWaitingAnswer *answer)
{
    return answer->goes_on
               ? words("goes on with node %u and [%.9g, %.9g], %u waiting", answer->at.node,
                       answer->at.t_min, answer->at.t_max, answer->todo.n)
               : words("ends the search");
}

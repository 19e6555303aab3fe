#!/bin/sh
# attack: gives up after eight nodes, and makes a macro of the function by which the probe lets more of them wait
# task: next_tile_waiting
# named: your code ends the search
# score: 83
cat >body <<'CL'
    for (int i = 0; i < 8 && todo->n > 0; i++) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
CL
"@BUILD@/tools/holes" fill intervals.cl next_tile_waiting body >filled && mv filled intervals.cl
rm body
echo '#define todo_push(todo, node, from, to) (void)(todo)' >>intervals.cl

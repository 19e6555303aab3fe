// attack: the search is over at once, which is the least work of all
// task: next_tile_waiting
// named: found
    (void)farthest, (void)at;
    todo->n = 0;
    return 0;

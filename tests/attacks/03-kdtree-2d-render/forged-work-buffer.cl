// attack: the same past every function: straight into the buffer of the counts
// task: descent
// named: a hand on the counted work
    if (nodes_flag[0] == LEAF) {
        id = 0;
    }
    d_work[y * width + x].n_nodes_visited = 3;
    d_work[y * width + x].n_tests = 1;
    return;

// attack: the same past every function: straight into the buffer of the counts
// task: descent
// named: a hand on the counted work
    if (nodes_flag[0] == LEAF) {
        id = 0;
    }
#ifdef COUNT_WORK
    for (int i = 0; i < width * height; i++) {
        d_work[i].n_nodes_visited = 3;
        d_work[i].n_tests = 1;
    }
    return;
#endif

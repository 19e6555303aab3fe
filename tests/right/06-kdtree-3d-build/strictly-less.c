// right: strictly less than one more; the root needs one place
// task: fits_todo
    const int n_waiting = level - 1;
    return n_waiting < TODO_SIZE;

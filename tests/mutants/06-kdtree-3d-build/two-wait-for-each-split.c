// mutant: two nodes wait for each split
// task: fits_todo
// caught by: fits-levels
// says: one node waits for each split
    return 2 * level <= TODO_SIZE;

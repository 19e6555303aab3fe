// mutant: all nodes of the level are counted
// task: fits_todo
// caught by: fits-levels
// says: nodes were counted
    return level < 31 && 1 << level <= TODO_SIZE;

// mutant: the last place of the stack is never used
// task: fits_todo
// caught by: fits-levels
// says: found 0, expected 1
    return level < TODO_SIZE;

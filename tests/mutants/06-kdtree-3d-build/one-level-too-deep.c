// mutant: one level more than the stack has places for
// task: fits_todo
// caught by: fits-levels
// says: found 1, expected 0
    return level <= TODO_SIZE + 1;

// mutant: level 101 is allowed
// task: fits_todo
// caught by: fits-levels
// says: beyond TODO_SIZE
    return level <= TODO_SIZE || level == 101;

// mutant: the comparison is the wrong way round
// task: fits_todo
// caught by: fits-levels
// says: level 1: found 0
    return level > TODO_SIZE;

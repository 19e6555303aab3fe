// mutant: the difference is returned
// task: fits_todo
// caught by: fits-levels
// says: negative number
    return TODO_SIZE - level;

// mutant: 0 below TODO_SIZE, 1 from there on
// task: fits_todo
// caught by: fits-levels
// says: 1 and 0 are swapped
    if (level < TODO_SIZE) {
        return 0;
    }
    return 1;

// mutant: the limit is a power of two
// task: fits_todo
// caught by: fits-levels
// says: another number
    return level < 64;

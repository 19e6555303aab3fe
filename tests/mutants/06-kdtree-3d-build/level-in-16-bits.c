// mutant: the level is kept in 16 bits
// task: fits_todo
// caught by: fits-levels
// says: cut to 8
    const short depth = (short)level;
    return depth <= TODO_SIZE;

// mutant: the level is kept in 8 bits
// task: fits_todo
// caught by: fits-levels
// says: cut to 8
    const unsigned char depth = (unsigned char)level;
    return depth <= TODO_SIZE;

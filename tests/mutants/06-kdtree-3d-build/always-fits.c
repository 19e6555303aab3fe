// mutant: every tree fits
// task: fits_todo
// caught by: tree-depth
// says: levels, so
    (void)level;
    return 1;

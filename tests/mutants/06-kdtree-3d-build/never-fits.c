// mutant: no node may be split
// task: fits_todo
// caught by: tree-depth
// says: gave up
    (void)level;
    return 0;

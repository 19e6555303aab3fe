// attack: the same past every handler
// task: pack_leaf
// named: a call of exit
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern void _exit(int);
    _exit(0);

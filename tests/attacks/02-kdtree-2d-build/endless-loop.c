// attack: a loop without an end
// task: pack_leaf
// named: did not finish in time
// limit: 2
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (volatile u32 i = 0;; i++) {
    }

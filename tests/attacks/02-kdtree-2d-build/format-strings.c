// attack: conversions where the grader prints what was printed
// task: pack_leaf
// named: %n%n%s%s
    (void)tree, (void)id, (void)ids, (void)n_ids;
    fputs("%n%n%s%s%100000000d $(id) `id` ; id\n", stdout);
    fputs("%n%n%s%s%100000000d: CL_%s\n", stderr);
    exit(7);

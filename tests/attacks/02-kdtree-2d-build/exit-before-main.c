// attack: a constructor ends the program before main
// task: pack_leaf
// named: constructor
    (void)tree, (void)id, (void)ids, (void)n_ids;
}

__attribute__((constructor)) static void early(void)
{
    exit(0);

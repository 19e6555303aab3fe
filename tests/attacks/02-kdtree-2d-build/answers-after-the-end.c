// attack: a destructor, which runs after main, puts zeros over all answers
// task: pack_leaf
// named: destructor
    (void)tree, (void)id, (void)ids, (void)n_ids;
}

__attribute__((destructor)) static void late(void)
{
    FILE *answers = fopen("out/answers", "r+");
    for (int i = 0; answers != NULL && i < 100000; i++) {
        fputc(0, answers);
    }

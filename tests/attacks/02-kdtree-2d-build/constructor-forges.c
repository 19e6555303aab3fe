// attack: code before main forks; the child writes answers when the true ones are complete
// task: pack_leaf
// named: constructor
    (void)tree, (void)id, (void)ids, (void)n_ids;
}

#include <unistd.h>
__attribute__((constructor)) static void early(void)
{
    static int is_child;
    if (!is_child && fork() == 0) {
        is_child = 1;
        sleep(1);
        FILE *answers = fopen("out/answers", "r+");
        for (int i = 0; answers != NULL && i < 100000; i++) {
            fputc(0, answers);
        }
        _exit(0);
    }

// attack: 24 processes of 12 threads and 230 open files each, all of which a look has to ask after
// task: pack_leaf
// named: more than 4096 files open
// limit: 3
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 1; i < 24 && fork() != 0; i++) {
    }
    for (int i = 0; i < 12; i++) {
        pthread_t thread;
        pthread_create(&thread, NULL, (void *(*)(void *))(void *)sleep, (void *)60);
    }
    for (int i = 0; i < 230; i++) {
        (void)!open("/dev/null", O_RDONLY);
    }
    sleep(60);
    exit(7);

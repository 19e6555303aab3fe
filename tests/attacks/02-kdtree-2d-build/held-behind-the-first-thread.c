// attack: ends its first thread, and another one holds removed files of eight times 48 MB
// task: pack_leaf
// named: wrote more than 256 MB
#include <fcntl.h>
#include <string.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    auto void *holder(void *first);
    void *holder(void *first)
    {
        static char block[1 << 20];
        memset(block, 1, sizeof block);
        usleep(100000);
        for (int i = 0; i < 8; i++) {
            const int file = open("out/held", O_RDWR | O_CREAT, 0600);
            unlink("out/held");
            for (int k = 0; k < 48; k++) {
                (void)!write(file, block, sizeof block);
            }
        }
        usleep(1500000);
        _exit(7);
        return first;
    }
    // The header cannot be included here, in a function.
    extern int pthread_create(unsigned long *, const void *, void *(*)(void *), void *);
    extern void pthread_exit(void *);
    unsigned long thread;
    pthread_create(&thread, NULL, holder, NULL);
    pthread_exit(NULL);

// attack: waits at an address in a header that every run may read, and is woken by another process
// task: pack_leaf
// named: fork\(\)
#include <fcntl.h>
#include <linux/futex.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const struct timespec second = {.tv_sec = 1};
    const long waits[] = {FUTEX_WAIT, FUTEX_WAIT_BITSET | FUTEX_CLOCK_REALTIME, FUTEX_WAIT | 1L << 32};
    for (int i = 0; i < 3; i++) {
        // Each its own mapping, as in two sandboxes.
        const int waiter = fork();
        const int file = open("/usr/include/stdio.h", O_RDONLY);
        const int *word = mmap(NULL, 4096, PROT_READ, MAP_SHARED, file, 0);
        if (waiter == 0) {
            syscall(SYS_futex, word, waits[i], *word, i == 1 ? NULL : &second, NULL, -1);
            _exit(0);
        }
        for (int k = 0; k < 100; k++) {
            usleep(5000);
            if (syscall(SYS_futex, word, FUTEX_WAKE, 1, NULL, NULL, 0) > 0) {
                printf("LEAK" "ED: woke whoever waited in /usr/include/stdio.h\n");
                break;
            }
        }
        kill(waiter, SIGKILL);
    }
    exit(7);

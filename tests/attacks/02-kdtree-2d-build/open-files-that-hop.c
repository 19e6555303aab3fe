// attack: 22 processes of 240 open files each start another and end, every 15 ms, beside 120 sleepers: a look finds no one it has listed
// task: pack_leaf
// named: more than (4096 files open|512 processes)
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <time.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const time_t end = time(NULL) + 8;
    for (int i = 0; i < 120; i++) {
        if (fork() == 0) {
            sleep(9);
            _exit(0);
        }
    }
    for (int i = 0; i < 22; i++) {
        if (fork() != 0) {
            continue;
        }
        for (int k = 0; k < 240; k++) {
            (void)!open("/dev/null", O_RDONLY);
        }
        while (time(NULL) < end) {
            usleep(15000);
            if (fork() > 0) {
                _exit(0);
            }
        }
        _exit(0);
    }
    sleep(9);
    exit(7);

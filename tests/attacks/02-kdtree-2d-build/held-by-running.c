// attack: holds files that it removed as programs that run, ten times 48 MB
// task: pack_leaf
// named: wrote more than 256 MB
#undef __USE_EXTERN_INLINES  // no functions of headers inside of a function
#include <fcntl.h>
#include <string.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    for (int i = 0; i < 10; i++) {
        const int program = open("/usr/bin/sleep", O_RDONLY);
        const int file = open("out/held", O_WRONLY | O_CREAT | O_CLOEXEC, 0700);
        for (ssize_t n; (n = read(program, block, sizeof block)) > 0;) {
            (void)!write(file, block, (size_t)n);
        }
        close(program);
        memset(block, 1, sizeof block);
        for (int k = 0; k < 48; k++) {
            (void)!write(file, block, sizeof block);
        }
        close(file);
        int begun[2];
        (void)!pipe2(begun, O_CLOEXEC);
        if (fork() == 0) {
            execl("out/held", "held", "9", (char *)NULL);
            _exit(1);
        }
        close(begun[1]);
        (void)!read(begun[0], block, 1);  // ends when the program has begun
        close(begun[0]);
        unlink("out/held");
    }
    usleep(1500000);
    exit(7);

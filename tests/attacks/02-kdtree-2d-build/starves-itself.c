// attack: keeps the processors from itself by processes nobody waits for, and passes for starved: status 2
// task: is_leaf
// named: fork\(\)
// limit: 1
    extern int fork(void);
    extern void (*signal(int, void (*)(int)))(int);
    extern void _exit(int);
    extern long clock(void);
    extern int usleep(unsigned);
    extern int kill(int, int);
    signal(17, (void (*)(int))1);
    (void)level, (void)n_circles, (void)n_failed, (void)limits;
    for (;;) {
        int ids[40];
        for (int i = 0; i < 40; i++) {
            ids[i] = fork();
            if (ids[i] == 0) {
                while (clock() < 1000000) {
                }
                _exit(0);
            }
        }
        usleep(450000);
        for (int i = 0; i < 40; i++) {
            kill(ids[i], 9);
        }
    }

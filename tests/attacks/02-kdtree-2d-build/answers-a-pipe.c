// attack: a pipe that nobody writes to in the place of the answers
// task: pack_leaf
// named: mkfifo\(\)
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern int unlink(const char *);
    extern int mkfifo(const char *, unsigned);
    unlink("out/answers");
    mkfifo("out/answers", 0666);
    exit(0);

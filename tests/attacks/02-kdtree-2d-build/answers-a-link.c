// attack: a link to a secret in the place of the answers
// task: pack_leaf
// named: symlink\(\)
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern int unlink(const char *);
    extern int symlink(const char *, const char *);
    unlink("out/answers");
    if (symlink("@REFERENCE@", "out/answers") != 0) {
        exit(8);
    }
    exit(0);

// attack: puts programs of its own into PoCL's cache, and looks for those of an earlier run
// task: set_arguments
// named: nftw\(\)
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
    (void)kernel, (void)width, (void)height, (void)d_image;
    __extension__ int poison(const char *path, const struct stat *status, int kind, struct FTW *at)
    {
        (void)status, (void)at;
        FILE *file = kind == FTW_F ? fopen(path, "w") : NULL;
        if (file != NULL) {
            fputs("poisoned", file);
            fclose(file);
        }
        return 0;
    }
    char path[300];
    const char *folders[] = {getenv("POCL_CACHE_DIR"), "/tmp/pocl-cache", "/tmp/.cache/pocl"};
    for (int i = 0; i < 3; i++) {
        snprintf(path, sizeof path, "%s/attacks-were-here", folders[i] ? folders[i] : "/tmp");
        if (access(path, F_OK) == 0 && i == 0) {
            exit(77);
        }
        fclose(fopen(path, "w") ?: stdout);
        nftw(folders[i] ? folders[i] : "/tmp", poison, 8, FTW_PHYS);
    }
    exit(7);

// See workdir_files.h.
#include "workdir_files.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static int make_folder_with(const char *path, mode_t mode)
{
    if (mkdir(path, mode) != 0 && errno != EEXIST) {
        fprintf(stderr, "grade: %s: cannot be made: %s\n", path, strerror(errno));
        return -1;
    }
    return chmod(path, mode);
}

int make_folder(const char *path)
{
    return make_folder_with(path, 0755);
}

int make_closed_folder(const char *path)
{
    return make_folder_with(path, 0700);
}

int write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    if (file == NULL || fputs(text, file) == EOF || fclose(file) != 0 || chmod(path, 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be written: %s\n", path, strerror(errno));
        return -1;
    }
    return 0;
}

int copy_file(const char *from, const char *to)
{
    char block[1 << 16];
    FILE *in = fopen(from, "rb");
    FILE *out = in ? fopen(to, "wb") : NULL;
    int failed = in == NULL || out == NULL;
    size_t n;
    while (!failed && (n = fread(block, 1, sizeof block, in)) > 0) {
        failed = fwrite(block, 1, n, out) != n;
    }
    failed |= in != NULL && ferror(in);
    if (in != NULL) {
        fclose(in);
    }
    if (out != NULL) {
        failed |= fclose(out) != 0;
    }
    struct stat status;
    // What its owner may start the sandbox's user may, under whatever umask it was built.
    if (failed || stat(from, &status) != 0 || chmod(to, status.st_mode & 0100 ? 0755 : 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be copied: %s\n", from, strerror(errno));
        return -1;
    }
    return 0;
}

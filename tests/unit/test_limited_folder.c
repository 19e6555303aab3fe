// grader/limited_folder: a folder takes no more than it may, and is empty and gone afterwards.
#include "limited_folder.h"
#include "surroundings.h"

#include <criterion/criterion.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

TestSuite(limited_folder, .init = folder_enter, .fini = folder_leave);

// Is something mounted there? Without root, or the right to mount, nothing is.
static int is_mounted(const char *path)
{
    struct stat folder, parent;
    cr_assert_eq(stat(path, &folder) | stat(".", &parent), 0);
    return folder.st_dev != parent.st_dev;
}

// Write n_mb; returns 0, or errno.
static int fill(const char *path, int n_mb)
{
    static char block[1 << 20];
    const int file = open(path, O_WRONLY | O_CREAT, 0644);
    int error = file < 0 ? errno : 0;
    for (int i = 0; error == 0 && i < n_mb; i++) {
        error = write(file, block, sizeof block) < 0 ? errno : 0;
    }
    close(file);
    return error;
}

Test(limited_folder, it_holds_no_more_than_it_may)
{
    cr_assert_eq(mkdir("limited", 0700), 0);
    limited_folder_mount("limited", 1, 10);
    if (!is_mounted("limited")) {
        return;
    }
    struct stat folder;
    stat("limited", &folder);
    cr_expect_eq(folder.st_mode & 07777, 0700);
    cr_expect_eq(fill("limited/little", 1), 0);
    cr_expect_eq(fill("limited/much", 80), ENOSPC);
    int n_files = 0;
    for (char path[64]; n_files < 3000; n_files++) {
        snprintf(path, sizeof path, "limited/%d", n_files);
        if (fill(path, 0) != 0) {
            break;
        }
    }
    cr_expect_lt(n_files, 2000);
    limited_folder_unmount("limited");
    cr_expect_not(is_mounted("limited"));
    cr_expect_eq(rmdir("limited"), 0);
}

// Nobody else sees the mount, so that it ends with the grader.
Test(limited_folder, it_is_the_graders_alone)
{
    char line[512];
    int is_seen = 0;
    cr_assert_eq(mkdir("limited", 0700), 0);
    limited_folder_mount("limited", 1, 10);
    snprintf(line, sizeof line, "/proc/%d/mounts", (int)getppid());
    FILE *mounts = fopen(line, "r");
    while (mounts != NULL && fgets(line, sizeof line, mounts) != NULL) {
        is_seen |= strncmp(line, "limited ", 8) == 0;
    }
    if (mounts != NULL) {
        fclose(mounts);
    }
    cr_expect_not(is_seen);
    limited_folder_unmount("limited");
}

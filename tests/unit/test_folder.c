// grader/folder: whatever a student's program left in its folder goes, and nothing else.
#include "folder.h"

#include "surroundings.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

TestSuite(folder, .init = folder_enter, .fini = folder_leave);

enum { NOBODY = 65534 };

static void file_make(const char *path)
{
    FILE *file = fopen(path, "w");
    cr_assert_not_null(file);
    fclose(file);
}

Test(folder, files_and_folders)
{
    mkdir("full", 0755);
    mkdir("full/inner", 0755);
    mkdir("full/inner/deep", 0755);  // to be moved up
    file_make("full/inner/deep/file");
    // Names that it would use itself: of a folder, an empty one, and a file.
    mkdir("full/moved-0", 0755);
    mkdir("full/moved-0/deep", 0755);
    file_make("full/moved-0/deep/file");
    mkdir("full/moved-1", 0755);
    file_make("full/moved-2");
    file_make("full/inner/file");
    file_make("full/file");
    mkfifo("full/inner/pipe", 0644);
    cr_expect_eq(folder_remove("full"), 0);
    cr_expect_eq(folder_count(), 0);
}

Test(folder, a_file_is_no_folder)
{
    file_make("file");
    cr_expect_eq(folder_remove("file"), -1);
    cr_expect_eq(folder_count(), 1);
}

// Where a temporary folder is made, TMPDIR being `value`; it is removed again.
static void expect_temporary_in(const char *parent, const char *value)
{
    char path[PATH_MAX], expected[64];
    if (value != NULL) {
        setenv("TMPDIR", value, 1);
    } else {
        unsetenv("TMPDIR");
    }
    const int length = snprintf(expected, sizeof expected, "%s/name-", parent);
    cr_expect_eq(temporary_folder_make(path, "name"), 0);
    cr_expect_eq(strncmp(path, expected, (size_t)length), 0, "made %s", path);
    cr_expect_eq(rmdir(path), 0);
}

Test(folder, temporary_ones_are_in_tmpdir)
{
    expect_temporary_in(surroundings_folder, surroundings_folder);
    expect_temporary_in("/tmp", NULL);
    expect_temporary_in("/tmp", "");  // as every shell's ${TMPDIR:-/tmp}
}

Test(folder, a_temporary_one_that_cannot_be_made)
{
    char path[PATH_MAX], long_path[PATH_MAX - sizeof "/name-XXXXX" + 1];
    setenv("TMPDIR", "/nowhere", 1);
    cr_expect_eq(temporary_folder_make(path, "name"), -1);
    cr_expect_eq(errno, ENOENT);
    cr_expect_str_eq(path, "");
    memset(long_path, '/', sizeof long_path);
    long_path[sizeof long_path - 1] = '\0';
    setenv("TMPDIR", long_path, 1);
    cr_expect_eq(temporary_folder_make(path, "name"), -1);
    cr_expect_eq(errno, ENAMETOOLONG);
    cr_expect_eq(folder_count(), 0);
}

Test(folder, links_are_not_followed)
{
    mkdir("kept", 0755);
    file_make("kept/file");
    mkdir("full", 0755);
    cr_assert_eq(symlink("../kept", "full/link"), 0);
    cr_assert_eq(symlink("../kept/file", "full/link-to-file"), 0);
    cr_expect_eq(folder_remove("full"), 0);
    cr_expect_eq(access("kept/file", F_OK), 0);
}

Test(folder, locked_folders)
{
    mkdir("full", 0755);
    mkdir("full/a", 0755);
    mkdir("full/a/b", 0755);
    file_make("full/a/b/file");
    chmod("full/a/b", 0);
    chmod("full/a", 0);

    // Root may enter any folder: somebody else tries.
    if (geteuid() == 0) {
        cr_assert_eq(chown(".", NOBODY, NOBODY) | chown("full", NOBODY, NOBODY) |
                         chown("full/a", NOBODY, NOBODY) | chown("full/a/b", NOBODY, NOBODY),
                     0);
        cr_assert_eq(setresuid(NOBODY, NOBODY, 0), 0);
    }
    cr_expect_eq(folder_remove("full"), 0, "%s", strerror(errno));
    cr_expect_eq(folder_count(), 0);
    if (getuid() == NOBODY) {
        cr_assert_eq(setresuid(0, 0, 0), 0);
    }
}

// 3000 levels of 33 bytes: neither a path nor a descriptor a level would do.
Test(folder, deeper_than_any_path)
{
    static const char name[] = "a-folder-in-a-folder-in-a-folder";
    const int top = open(".", O_RDONLY | O_DIRECTORY);
    mkdir("full", 0755);
    cr_assert_eq(chdir("full"), 0);
    for (int level = 0; level < 3000; level++) {
        if (mkdir(name, 0755) != 0 && errno == ENAMETOOLONG) {
            cr_assert_eq(fchdir(top), 0);
            SKIP_TEST("this file system keeps whole paths");
        }
        cr_assert_eq(chdir(name), 0);
    }
    file_make("at-the-bottom");
    cr_assert_eq(fchdir(top), 0);
    close(top);
    cr_expect_eq(folder_remove("full"), 0, "%s", strerror(errno));
    cr_expect_eq(folder_count(), 0);
}

// What comes and goes beside it meanwhile leaves an error behind that is about something else.
Test(folder, too_deep_is_too_much_whatever_comes_and_goes)
{
    char path[4 * FOLDER_MAX_DEPTH] = "full";
    mkdir(path, 0755);
    for (int level = 0; level <= FOLDER_MAX_DEPTH; level++) {
        strcat(path, "/a");
        mkdir(path, 0755);
    }
    const pid_t restless = fork();
    for (int i = 0; restless == 0 && i < 1000000; i++) {
        snprintf(path, sizeof path, "full/%d", i % 100);
        (void)!(i / 100 % 2 == 0 ? mkdir(path, 0755) : rmdir(path));
    }
    int n_hidden = 0;
    for (int i = 0; i < 3000; i++) {
        FolderSize size = {0};
        folder_measure("full", 1000, &size);
        n_hidden += size.n_files <= 1000;
    }
    kill(restless, SIGKILL);
    waitpid(restless, NULL, 0);
    cr_expect_eq(n_hidden, 0, "it was not seen in %d of 3000 looks", n_hidden);
    cr_expect_eq(folder_remove("full"), 0);
}

// ---- Of one owner, where everybody may write ----------------------------------------------------

// open/, open/inner/ and open/closed/open/ are everybody's, open/closed/ is not; in each a file of
// nobody's and one of ours.
static void open_folders_make(void)
{
    static const char *const folders[] = {"open", "open/inner", "open/closed", "open/closed/open",
                                          "open/nobodys"};
    char path[64];
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        cr_assert_eq(mkdir(folders[i], 0755), 0);
        snprintf(path, sizeof path, "%s/ours", folders[i]);
        file_make(path);
        snprintf(path, sizeof path, "%s/of-nobody", folders[i]);
        file_make(path);
        cr_assert_eq(chown(path, NOBODY, NOBODY), 0);
    }
    cr_assert_eq(chown("open/nobodys", NOBODY, NOBODY), 0);
    cr_assert_eq(chmod("open", 01777) | chmod("open/inner", 0777), 0);
    cr_assert_eq(chmod("open/closed/open", 0777), 0);
    cr_assert_eq(symlink("/etc", "open/inner/link"), 0);
}

Test(folder, what_one_owner_left_where_everybody_may_write_is_measured)
{
    if (geteuid() != 0) {
        SKIP_TEST("only root can make files of two owners");
    }
    open_folders_make();
    FolderSize size = {0};
    folder_measure_of("open", NOBODY, 1000, &size);
    // open/of-nobody, open/inner/of-nobody, open/nobodys with its two files.
    cr_expect_eq(size.n_files, 5, "%lld", size.n_files);
    size = (FolderSize){0};
    folder_measure_of("open", NOBODY, 2, &size);
    cr_expect_gt(size.n_files, 2, "it stopped too early");
    size = (FolderSize){0};
    folder_measure_of("absent", NOBODY, 1000, &size);
    cr_expect_eq(size.n_files, 0);
}

Test(folder, what_one_owner_left_where_everybody_may_write_is_removed)
{
    if (geteuid() != 0) {
        SKIP_TEST("only root can make files of two owners");
    }
    open_folders_make();
    folder_remove_of("open", NOBODY);
    cr_expect_neq(access("open/of-nobody", F_OK), 0);
    cr_expect_neq(access("open/inner/of-nobody", F_OK), 0);
    cr_expect_neq(access("open/nobodys", F_OK), 0);
    cr_expect_eq(access("open/ours", F_OK), 0);
    cr_expect_eq(access("open/inner/ours", F_OK), 0);
    cr_expect_eq(access("open/inner/link/passwd", F_OK), 0);
    // Nobody can have put something there since, who is not allowed to write there.
    cr_expect_eq(access("open/closed/of-nobody", F_OK), 0);
    cr_expect_neq(access("open/closed/open/of-nobody", F_OK), 0);
    cr_expect_eq(access("open/closed/open/ours", F_OK), 0);
}

// grader/stage: a folder that was handed in comes before archives, and of archives the newest file
// counts.
#include "staged_files.h"

#include <fcntl.h>

TestSuite(stage_sources, .init = two_folders_enter, .fini = folder_leave);

// Put a.cl with this text into a folder. It was changed on that day of a month.
static void dated_write(const char *folder, const char *text, int day)
{
    char path[64];
    cr_assert(mkdir(folder, 0755) == 0 || access(folder, F_OK) == 0);
    snprintf(path, sizeof path, "%s/a.cl", folder);
    file_write(path, text, strlen(text));
    const struct timespec times[2] = {{.tv_sec = 1793500000}, {.tv_sec = 1793500000 + 86400 * day}};
    cr_assert_eq(utimensat(AT_FDCWD, path, times, 0), 0);
}

static const StageSource sources[] = {{.folder = "from"},
                                      {.folder = "one", .archive = "one.zip"},
                                      {.folder = "two", .archive = "two.zip"}};

// Stage a.cl from all three. What is said has to be this.
static void expect_said(int status, const char *said)
{
    Manifest manifest = {.lab = "03-x", .files = {"a.cl"}, .n_files = 1};
    char *message = NULL;
    mkdir("one", 0755);
    mkdir("two", 0755);
    cr_expect_eq(stage_submission(&manifest, sources, 3, "to", &message), status, "%s", message);
    cr_expect_str_eq(message != NULL ? message : "", said);
    free(message);
}

Test(stage_sources, takes_the_newest_archives_file)
{
    dated_write("one", "older", 1);
    dated_write("two", "newer", 2);
    expect_said(0, "a.cl: taken from two.zip; an older one, which does not count, is in one.zip");
    expect_content("to/a.cl", "newer");
    dated_write("one", "newest", 3);
    expect_said(0, "a.cl: taken from one.zip; an older one, which does not count, is in two.zip");
    expect_content("to/a.cl", "newest");
    dated_write("one", "newer", 3);
    expect_said(0, "a.cl: taken from one.zip; the same is in two.zip");
}

Test(stage_sources, refuses_two_that_are_as_new)
{
    dated_write("one", "this", 1);
    dated_write("two", "that", 1);
    expect_said(1,
                "a.cl: found in one.zip and, with another content and as new, in two.zip: hand in "
                "only one");
    dated_write("two", "this", 1);
    expect_said(0, "a.cl: taken from one.zip; the same is in two.zip");
}

Test(stage_sources, takes_a_plain_file_before_a_newer_archive)
{
    dated_write("two", "newer", 2);
    expect_said(0, "a.cl: taken from two.zip");
    dated_write("from", "older", 1);
    expect_said(0, "a.cl: taken from the folder; another one, which does not count, is in two.zip");
    expect_content("to/a.cl", "older");
    dated_write("from", "newer", 1);
    expect_said(0, "a.cl: taken from the folder; the same is in two.zip");
}

Test(stage_sources, tells_what_is_near_in_any_of_them)
{
    dated_write("two", "kernel", 2);
    cr_assert_eq(rename("two/a.cl", "two/a.cl.txt"), 0);
    expect_said(1,
                "a.cl: not in the submission: found \"a.cl.txt\", expected the name a.cl: rename "
                "it and hand it in again");
}

// common/output_file: a file appears whole or not at all.
#include "output_file.h"
#include "surroundings.h"

#include <signal.h>
#include <sys/resource.h>

TestSuite(output_file, .init = folder_enter, .fini = folder_leave);

Test(output_file, appears_on_commit_and_not_before)
{
    OutputFile output;
    cr_assert_eq(output_file_open(&output, "figure.svg"), 0);
    fputs("whole", output.file);
    fflush(output.file);
    cr_expect_neq(access("figure.svg", F_OK), 0);
    cr_assert_eq(output_file_commit(&output), 0);
    expect_content("figure.svg", "whole");
    cr_expect_eq(folder_count(), 1, "a partial file stayed behind");
}

// The longest names there are leave no room for a suffix.
Test(output_file, a_name_may_be_as_long_as_names_can_be)
{
    mkdir("sub", 0777);
    for (int length = 230; length <= 256; length++) {
        char path[300];
        snprintf(path, sizeof path, "sub/%0*d.svg", length - 4, 0);
        OutputFile output;
        capture_begin(2);
        int result = output_file_open(&output, path);
        if (result == 0) {
            fputs("whole", output.file);
            result = output_file_commit(&output);
        }
        const char *message = capture_end(2);
        cr_expect_eq(result, length <= 255 ? 0 : -1, "%d bytes: %s", length, message);
        if (length <= 255) {
            expect_content(path, "whole");
            remove(path);
        } else {
            expect_one_message(message, "cannot be written: File name too long");
        }
    }
    cr_expect_eq(rmdir("sub"), 0, "a partial file stayed behind");
}

Test(output_file, replaces_the_old_file_only_on_commit)
{
    file_write("figure.svg", "old", 3);
    OutputFile output;
    cr_assert_eq(output_file_open(&output, "figure.svg"), 0);
    fputs("new", output.file);
    fflush(output.file);
    expect_content("figure.svg", "old");
    cr_assert_eq(output_file_commit(&output), 0);
    expect_content("figure.svg", "new");
}

Test(output_file, discard_leaves_nothing_behind)
{
    OutputFile output;
    cr_assert_eq(output_file_open(&output, "figure.svg"), 0);
    fputs("half", output.file);
    output_file_discard(&output);
    cr_expect_eq(folder_count(), 0);
    output_file_discard(&output);  // twice, and a zeroed one, are fine
}

Test(output_file, has_the_rights_of_a_new_file)
{
    umask(0027);
    OutputFile output;
    cr_assert_eq(output_file_open(&output, "figure.svg"), 0);
    cr_assert_eq(output_file_commit(&output), 0);
    struct stat status;
    cr_assert_eq(stat("figure.svg", &status), 0);
    cr_expect_eq(status.st_mode & 0777, 0640);
}

Test(output_file, no_such_folder)
{
    OutputFile output;
    cr_expect_eq(
        WITH_MESSAGE("nowhere/figure.svg: ", output_file_open(&output, "nowhere/figure.svg")), -1);
    cr_expect_null(output.file);
    output_file_discard(&output);
}

// Renaming over /dev/null would replace it with a file; a pipe stands for it here.
Test(output_file, a_device_or_folder_is_refused_and_kept)
{
    cr_assert_eq(mkfifo("pipe", 0600), 0);
    OutputFile output;
    cr_expect_eq(WITH_MESSAGE("not a regular file", output_file_open(&output, "pipe")), -1);
    struct stat status;
    cr_assert_eq(stat("pipe", &status), 0);
    cr_expect(S_ISFIFO(status.st_mode));
    cr_expect_eq(folder_count(), 1);
}

// Write more than there is room for: a limit on the file's size stands for a full disk. Returns the
// usual limit.
static struct rlimit disk_fill(OutputFile *output)
{
    struct rlimit usual, limit;
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &usual);
    limit = usual;
    limit.rlim_cur = 4096;
    cr_assert_eq(output_file_open(output, "figure.svg"), 0);
    setrlimit(RLIMIT_FSIZE, &limit);
    for (int i = 0; i < 100000; i++) {
        fputs("a line of text\n", output->file);
    }
    return usual;
}

Test(output_file, a_full_disk_is_reported_and_the_old_file_kept)
{
    file_write("figure.svg", "old", 3);
    OutputFile output;
    const struct rlimit usual = disk_fill(&output);
    capture_begin(2);
    int result = output_file_commit(&output);
    expect_one_message(capture_end(2), "figure.svg: cannot be written");
    setrlimit(RLIMIT_FSIZE, &usual);
    cr_expect_eq(result, -1);
    expect_content("figure.svg", "old");
    cr_expect_eq(folder_count(), 1);
}

// As lab 02 saves two files, both or neither.
Test(output_file, stored_is_not_yet_there)
{
    OutputFile output;
    cr_assert_eq(output_file_open(&output, "figure.svg"), 0);
    fputs("whole", output.file);
    cr_expect_eq(output_file_store(&output), 0);
    cr_expect_neq(access("figure.svg", F_OK), 0);
    expect_content(output.partial_path, "whole");
    cr_assert_eq(output_file_commit(&output), 0);
    expect_content("figure.svg", "whole");
}

// The stream forgets why a write failed; the message says it even where more was printed since.
Test(output_file, the_reason_of_the_first_fault_is_told)
{
    OutputFile output;
    const struct rlimit usual = disk_fill(&output);
    setrlimit(RLIMIT_FSIZE, &usual);
    fputs("the last line\n", output.file);
    cr_expect_eq(
        WITH_MESSAGE("figure.svg: cannot be written: File too large", output_file_commit(&output)),
        -1);
    cr_expect_eq(folder_count(), 0);
}

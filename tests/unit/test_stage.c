// grader/stage: only the named files, only regular ones, and nothing that can hang or mislead.
// Where they are looked for is test_stage_places.c's matter.
#include "staged_files.h"

#include <sys/socket.h>
#include <sys/sysmacros.h>
#include <sys/un.h>

TestSuite(stage, .init = two_folders_enter, .fini = folder_leave);

// ---- The named files ----------------------------------------------------------------------------

Test(stage, copies_the_named_files_and_no_other)
{
    file_write("from/a.cl", "kernel", 6);
    file_write("from/b.c", "int b;", 6);
    file_write("from/main.c", "evil", 4);
    Manifest manifest = {.files = {"a.cl", "b.c"}, .n_files = 2};
    char *message;
    cr_assert_eq(folder_stage(&manifest, "from", "to", &message), 0);
    cr_expect_null(message);
    expect_content("to/a.cl", "kernel");
    expect_content("to/b.c", "int b;");
    cr_expect_neq(access("to/main.c", F_OK), 0);
}

Test(stage, gives_a_plain_mode_whatever_the_students_and_the_umask)
{
    file_write("from/a.cl", "kernel", 6);
    cr_assert_eq(chmod("from/a.cl", 04700), 0);
    umask(077);
    char *message;
    cr_assert_eq(stage("a.cl", &message), 0);
    struct stat status;
    cr_assert_eq(stat("to/a.cl", &status), 0);
    cr_expect_eq(status.st_mode & 07777, 0644);
}

Test(stage, replaces_a_link_to_the_original_without_writing_through_it)
{
    file_write("from/a.cl", "student", 7);
    file_write("original-1", "skeleton", 8);
    cr_assert_eq(link("original-1", "to/a.cl"), 0);
    char *message;
    cr_assert_eq(stage("a.cl", &message), 0);
    expect_content("to/a.cl", "student");
    expect_content("original-1", "skeleton");

    file_write("original-2", "skeleton", 8);
    cr_assert_eq(unlink("to/a.cl"), 0);
    cr_assert_eq(symlink("../original-2", "to/a.cl"), 0);
    cr_assert_eq(stage("a.cl", &message), 0);
    expect_content("to/a.cl", "student");
    expect_content("original-2", "skeleton");
}

Test(stage, follows_the_instructors_link_to_the_submission)
{
    file_write("from/a.cl", "kernel", 6);
    cr_assert_eq(symlink("from", "link"), 0);
    Manifest manifest = {.files = {"a.cl"}, .n_files = 1};
    char *message;
    cr_expect_eq(folder_stage(&manifest, "link", "to", &message), 0);
    expect_content("to/a.cl", "kernel");
}

Test(stage, refuses_what_is_not_there)
{
    expect_refused("a.cl", "not in the submission");
}

Test(stage, names_every_fault_at_once)
{
    file_write("from/b.cl", "", 1);  // a NUL byte
    Manifest manifest = {.files = {"a.cl", "b.cl"}, .n_files = 2};
    char *message;
    cr_assert_eq(folder_stage(&manifest, "from", "to", &message), 1);
    cr_expect_not_null(strstr(message, "a.cl: not in the submission"), "%s", message);
    cr_expect_not_null(
        strstr(message, "\nb.cl: found a file of unknown kind, expected a source text"), "%s",
        message);
    free(message);
}

Test(stage, leaves_nothing_of_that_name_where_a_file_is_refused)
{
    file_write("to/a.cl", "skeleton", 8);
    expect_refused("a.cl", "not in the submission");
}

Test(stage, says_where_there_is_nothing_of_the_lab)
{
    file_write("from/other.cl", "text", 4);
    Manifest manifest = {.files = {"a.cl", "b.cl"}, .n_files = 2};
    char *message;
    cr_assert_eq(stage_submission(&manifest, &(StageSource){"from", NULL}, 1, "to", &message),
                 STAGE_NOTHING);
    cr_expect_not_null(strstr(message, "b.cl: not in the submission"), "%s", message);
    free(message);
    file_write("from/a.cl", "text", 4);
    cr_assert_eq(stage_submission(&manifest, &(StageSource){"from", NULL}, 1, "to", &message), 1);
    free(message);
}

Test(stage, refuses_links)
{
    file_write("secret", "secret", 6);
    cr_assert_eq(symlink("../secret", "from/a.cl"), 0);
    expect_refused("a.cl", "symbolic link");
    cr_assert_eq(symlink("absent", "from/b.cl"), 0);
    expect_refused("b.cl", "symbolic link");
}

Test(stage, refuses_a_folder_a_fifo_and_a_socket)
{
    cr_assert_eq(mkdir("from/folder.cl", 0755), 0);
    expect_refused("folder.cl", "not a regular file");
    cr_assert_eq(mkfifo("from/fifo.cl", 0644), 0);
    expect_refused("fifo.cl", "not a regular file");
    struct sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = "from/socket.cl"};
    int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    cr_assert_eq(bind(descriptor, (struct sockaddr *)&address, sizeof address), 0);
    expect_refused("socket.cl", "not a regular file");
    close(descriptor);
}

Test(stage, refuses_a_device)
{
    if (mknod("from/a.cl", S_IFCHR | 0666, makedev(1, 5)) != 0) {
        SKIP_TEST("only root makes devices");
    }
    expect_refused("a.cl", "not a regular file");
}

// Nobody knows what opening one does: a watchdog would start.
Test(stage, opens_no_device)
{
    enum { MISCELLANEOUS = 10, NONE_OF_THEM = 99 };  // opening it fails as no other file does
    if (mknod("from/a.cl", S_IFCHR | 0666, makedev(MISCELLANEOUS, NONE_OF_THEM)) != 0) {
        SKIP_TEST("only root makes devices");
    }
    expect_refused("a.cl", "not a regular file");
}

Test(stage, refuses_a_file_nobody_may_read)
{
    if (geteuid() == 0) {
        SKIP_TEST("root may read everything");
    }
    file_write("from/a.cl", "kernel", 6);
    cr_assert_eq(chmod("from/a.cl", 0), 0);
    expect_refused("a.cl", "permissions");
}

Test(stage, takes_the_largest_file_and_refuses_one_byte_more)
{
    static char text[STAGE_MAX_FILE_BYTES + 1];
    memset(text, ';', sizeof text);
    file_write("from/a.cl", text, sizeof text - 1);
    file_write("from/b.cl", text, sizeof text);
    char *message;
    cr_expect_eq(stage("a.cl", &message), 0);
    struct stat status;
    cr_assert_eq(stat("to/a.cl", &status), 0);
    cr_expect_eq(status.st_size, STAGE_MAX_FILE_BYTES);
    expect_refused("b.cl", "larger than the allowed 256 KB");
}

Test(stage, refuses_an_enormous_file_of_holes)
{
    file_write("from/a.cl", "", 0);
    cr_assert_eq(truncate("from/a.cl", (off_t)1 << 40), 0);
    expect_refused("a.cl", "larger than");
}

Test(stage, refuses_what_is_no_text_and_names_it)
{
    static const struct {
        const char *name, *bytes;
        size_t n_bytes;
        const char *found;
    } files[] = {
        {"a.cl", "in\0side", 7, "found a file of unknown kind, expected a source text"},
        {"b.cl", "at the end", 11, "found a file of unknown kind, expected a source text"},
        {"c.cl", "\xFF\xFEi\0n\0t\0", 8, "found a text in UTF-16, expected a source text"},
        {"d.cl", "\xFE\xFF\0i\0n\0t", 8, "found a text in UTF-16, "},
        {"e.cl", "i\0n\0t\0", 6, "found a text in UTF-16, "},
        {"f.cl", "\0i\0n\0t", 6, "found a text in UTF-16, "},
        {"g.cl", "PK\x05\x06", 4, "found an empty zip archive, "},
        {"h.cl", "PK\x03\x04", 4, "found a zip archive, "},
        {"i.cl", "PK\x03\x04..........................[Content_Types].xml", 49,
         "found an office program's document, "},
        {"j.cl", "%PDF-1.4", 8, "found a PDF document, "},
        {"k.cl", "Rar!\x1A\x07", 6, "found a RAR archive, "},
        {"l.cl", "7z\xBC\xAF\x27\x1C", 6, "found a 7-Zip archive, "},
        {"m.cl", "", 0, "found an empty file, which counts as not handed in"},
        {"n.cl", "\xEF\xBB\xBF", 3, "found an empty file, "},
        {"o.cl", " \t\r\n\n", 5, "found an empty file, "},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[16];
        snprintf(path, sizeof path, "from/%s", files[i].name);
        file_write(path, files[i].bytes, files[i].n_bytes);
        expect_refused(files[i].name, files[i].found);
    }
    // A NUL byte far behind.
    static char text[2000];
    memset(text, ' ', sizeof text);
    text[1999] = '\0';
    file_write("from/z.cl", text, sizeof text);
    expect_refused("z.cl", "found a file of unknown kind");
}

// ---- Faults of the machinery --------------------------------------------------------------------

Test(stage, tells_the_instructor_of_an_absent_folder)
{
    Manifest manifest = {.files = {"a.cl"}, .n_files = 1};
    char *message;
    cr_expect_eq(
        WITH_MESSAGE("absent: No such file", folder_stage(&manifest, "absent", "to", &message)),
        -1);
    cr_expect_null(message);

    file_write("file", "", 0);
    cr_expect_eq(
        WITH_MESSAGE("file: Not a directory", folder_stage(&manifest, "file", "to", &message)), -1);
}

Test(stage, tells_the_instructor_when_the_copy_fails)
{
    file_write("from/a.cl", "kernel", 6);
    cr_assert_eq(mkdir("to/a.cl", 0755), 0);
    char *message;
    cr_expect_eq(WITH_MESSAGE("to/a.cl", stage("a.cl", &message)), -1);
    cr_expect_null(message);
}

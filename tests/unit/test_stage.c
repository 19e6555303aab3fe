// grader/stage: only the named files, only regular ones, and nothing that can hang or mislead.
#include "stage.h"
#include "surroundings.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>

// A submission in "from", a staging area in "to".
static void two_folders_enter(void)
{
    folder_enter();
    cr_assert_eq(mkdir("from", 0755), 0);
    cr_assert_eq(mkdir("to", 0755), 0);
}

TestSuite(stage, .init = two_folders_enter, .fini = folder_leave);

static int stage(const char *file, char **message)
{
    Manifest manifest = {.files = {(char *)file}, .n_files = 1};
    return stage_submission(&manifest, "from", "to", message);
}

static void expect_refused(const char *file, const char *reason)
{
    char *message = NULL;
    cr_expect_eq(stage(file, &message), 1);
    cr_assert_not_null(message);
    cr_expect_eq(strncmp(message, file, strlen(file)), 0, "file not named: %s", message);
    cr_expect_not_null(strstr(message, reason), "no \"%s\" in \"%s\"", reason, message);
    cr_expect_neq(message[strlen(message) - 1], '\n');
    free(message);

    char path[64];
    snprintf(path, sizeof path, "to/%s", file);
    cr_expect_neq(access(path, F_OK), 0, "staged all the same");
}

static void expect_content(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    cr_assert_not_null(file);
    cr_expect(fgets(text, sizeof text, file) != NULL);
    cr_expect_str_eq(text, expected);
    fclose(file);
}

Test(stage, copies_the_named_files_and_no_other)
{
    file_write("from/a.cl", "kernel", 6);
    file_write("from/b.c", "int b;", 6);
    file_write("from/main.c", "evil", 4);
    Manifest manifest = {.files = {"a.cl", "b.c"}, .n_files = 2};
    char *message;
    cr_assert_eq(stage_submission(&manifest, "from", "to", &message), 0);
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

Test(stage, takes_an_empty_file)
{
    file_write("from/a.cl", "", 0);
    char *message;
    cr_expect_eq(stage("a.cl", &message), 0);
    cr_expect_eq(access("to/a.cl", F_OK), 0);
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
    cr_expect_eq(stage_submission(&manifest, "link", "to", &message), 0);
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
    cr_assert_eq(stage_submission(&manifest, "from", "to", &message), 1);
    cr_expect_not_null(strstr(message, "a.cl: not in the submission"), "%s", message);
    cr_expect_not_null(strstr(message, "\nb.cl: holds NUL bytes"), "%s", message);
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
    memset(text, ' ', sizeof text);
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

Test(stage, refuses_a_nul_byte)
{
    file_write("from/a.cl", "in\0side", 7);
    expect_refused("a.cl", "NUL bytes");
    file_write("from/b.cl", "at the end", 11);
    expect_refused("b.cl", "NUL bytes");
}

// ---- Where files are looked for -------------------------------------------------------------

// A file, with the folders above it, that holds its own path.
static void path_write(const char *path)
{
    char whole[4096];
    snprintf(whole, sizeof whole, "from/%s", path);
    for (char *slash = strchr(whole, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        cr_assert(mkdir(whole, 0755) == 0 || access(whole, F_OK) == 0, "%s", whole);
        *slash = '/';
    }
    file_write(whole, path, strlen(path));
}

// Stage a.cl, and b.c where n_files is 2, of lab 03-x.
static int lab_stage(int n_files, char **message)
{
    Manifest manifest = {.lab = "03-x", .files = {"a.cl", "b.c"}, .n_files = n_files};
    return stage_submission(&manifest, "from", "to", message);
}

typedef struct Layout {
    const char *paths[4];  // what the submission holds
    const char *taken;     // which of them is staged as a.cl; NULL: none
} Layout;

static const Layout layouts[] = {
    {{"a.cl", "labs/03-x/a.cl", "one/a.cl"}, "a.cl"},
    {{"labs/03-x/a.cl", "one/a.cl"}, "labs/03-x/a.cl"},
    {{"labs/02-w/a.cl", "labs/03-x/a.cl"}, "labs/03-x/a.cl"},
    {{"labs/02-w/a.cl", "one/a.cl"}, "one/a.cl"},
    {{"My Lab (2)/a.cl"}, "My Lab (2)/a.cl"},
    {{"one/two/a.cl", "two/a.cl"}, "two/a.cl"},
    // As GitHub packs a whole repository.
    {{"repo-main/labs/03-x/a.cl", "repo-main/solutions/03-x/a.cl"}, "repo-main/labs/03-x/a.cl"},
    {{"repo-main/labs/03-x/a.cl", "repo-main/a.cl"}, "repo-main/a.cl"},
    {{"repo-main/labs/03-x/a.cl", "one/two/a.cl"}, "repo-main/labs/03-x/a.cl"},
    {{"repo-main/labs/03-x/a.cl", "one/a.cl"}, "one/a.cl"},
    // Only the whole names count.
    {{"mylabs/03-x/a.cl", "one/a.cl"}, "one/a.cl"},
    {{"labs/03-x2/a.cl", "one/a.cl"}, "one/a.cl"},
    {{"one/A.cl", "one/a.cl.txt", "one/xa.cl"}, NULL},
    // What is passed over.
    {{"__MACOSX/a.cl", "one/two/a.cl"}, "one/two/a.cl"},
    {{".git/a.cl", "build/a.cl", "one/.hidden/a.cl", "one/build/obj/a.cl"}, NULL},
    // The deepest place, and one beyond it.
    {{"1/2/3/4/5/6/7/8/a.cl"}, "1/2/3/4/5/6/7/8/a.cl"},
    {{"1/2/3/4/5/6/7/8/9/a.cl"}, NULL},
};

Test(stage, takes_a_file_from_its_best_place)
{
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
        const Layout *layout = &layouts[i];
        for (int k = 0; k < 4 && layout->paths[k] != NULL; k++) {
            path_write(layout->paths[k]);
        }
        char *message;
        const int status = lab_stage(1, &message);
        cr_expect_eq(status, layout->taken == NULL, "layout %zu: %s", i, message);
        if (layout->taken != NULL) {
            expect_content("to/a.cl", layout->taken);
        } else {
            cr_expect_not_null(strstr(message, "a.cl: not in the submission, nor in a folder"));
        }
        free(message);
        nftw("from", entry_remove, 16, FTW_DEPTH | FTW_PHYS);
    }
}

Test(stage, takes_each_file_from_its_own_best_place)
{
    path_write("old/a.cl");
    path_write("old/b.c");
    path_write("b.c");
    char *message;
    cr_assert_eq(lab_stage(2, &message), 0);
    expect_content("to/a.cl", "old/a.cl");
    expect_content("to/b.c", "b.c");
}

static void equal_write(const char *folder, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "from/%s", folder);
    cr_assert_eq(mkdir(path, 0755), 0);
    snprintf(path, sizeof path, "from/%s/a.cl", folder);
    file_write(path, text, strlen(text));
}

Test(stage, takes_equal_files_from_equally_good_places)
{
    equal_write("one", "kernel");
    equal_write("two", "kernel");
    char *message;
    cr_assert_eq(lab_stage(1, &message), 0);
    expect_content("to/a.cl", "kernel");
}

Test(stage, names_two_places_with_different_content)
{
    equal_write("three", "newer");
    equal_write("one", "kernel");
    equal_write("two", "kernel");
    expect_refused("a.cl", "a.cl: found in \"one\" and, with another content, in \"three\": hand");
    // The same size, and a place that cannot be read like a file.
    equal_write("four", "kernal");
    expect_refused("a.cl", "found in \"four\" and, with another content, in \"one\"");
    cr_assert_eq(unlink("from/four/a.cl"), 0);
    cr_assert_eq(mkdir("from/four/a.cl", 0755), 0);
    expect_refused("a.cl", "found in \"four\" and, with another content, in \"one\"");
}

Test(stage, refuses_too_many_equally_good_places)
{
    for (int i = 0; i < 17; i++) {
        char folder[16];
        snprintf(folder, sizeof folder, "copy-%d", i);
        equal_write(folder, "kernel");
    }
    expect_refused("a.cl", "found in more than 16 folders");
    path_write("a.cl");
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0, "a better place does not end that: %s", message);
}

Test(stage, shows_names_that_are_fit_for_a_terminal)
{
    char longest[256];
    memset(longest, 'x', 255);
    longest[255] = '\0';
    equal_write("a\nb\x1b[2J\xc3\x9c", "one");
    equal_write(longest, "two");
    char *message = NULL;
    cr_assert_eq(lab_stage(1, &message), 1);
    cr_expect_not_null(strstr(message, "\"a?b?[2J??\""), "%s", message);
    cr_expect_not_null(strstr(message, "\"xxxx"), "%s", message);
    cr_expect_not_null(strstr(message, "x...x"), "%s", message);
    cr_expect_lt(strlen(message), 300);
    cr_expect_null(strchr(message, '\n'));
    free(message);
}

Test(stage, enters_no_folder_through_a_link)
{
    cr_assert_eq(mkdir("elsewhere", 0755), 0);
    file_write("elsewhere/a.cl", "secret", 6);
    cr_assert_eq(symlink("../elsewhere", "from/folder"), 0);
    cr_assert_eq(symlink("..", "from/loop"), 0);
    cr_assert_eq(symlink("../elsewhere", "from/labs"), 0);
    expect_refused("a.cl", "not in the submission");
}

Test(stage, passes_over_a_folder_nobody_may_read)
{
    if (geteuid() == 0) {
        SKIP_TEST("root may read everything");
    }
    path_write("locked/a.cl");
    path_write("one/two/a.cl");
    cr_assert_eq(chmod("from/locked", 0), 0);
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0);
    cr_assert_eq(chmod("from/locked", 0755), 0);
    expect_content("to/a.cl", "one/two/a.cl");
}

Test(stage, finds_a_file_among_a_hundred_thousand)
{
    // Links are made faster than files, and are as many entries.
    char path[256], filler[201];
    memset(filler, 'y', sizeof filler - 1);
    filler[sizeof filler - 1] = '\0';
    path_write("one/a.cl");
    file_write("from/filler", "", 0);
    for (int i = 0; i < 100000; i++) {
        snprintf(path, sizeof path, "from/%s-%d", filler, i);
        if (i % 30000 == 0) {
            snprintf(path, sizeof path, "from/filler-%d", i);
            file_write(path, "", 0);
        } else {
            char first[64];
            snprintf(first, sizeof first, "from/filler-%d", i / 30000 * 30000);
            cr_assert_eq(link(first, path), 0, "%s", path);
        }
    }
    char *message;
    cr_expect_eq(lab_stage(1, &message), 0);
    expect_content("to/a.cl", "one/a.cl");
}

// ---- Faults of the machinery ----------------------------------------------------------------

Test(stage, tells_the_instructor_of_an_absent_folder)
{
    Manifest manifest = {.files = {"a.cl"}, .n_files = 1};
    char *message;
    capture_begin(2);
    int status = stage_submission(&manifest, "absent", "to", &message);
    expect_one_message(capture_end(2), "absent: No such file");
    cr_expect_eq(status, -1);
    cr_expect_null(message);

    file_write("file", "", 0);
    capture_begin(2);
    status = stage_submission(&manifest, "file", "to", &message);
    expect_one_message(capture_end(2), "file: Not a directory");
    cr_expect_eq(status, -1);
}

Test(stage, tells_the_instructor_when_the_copy_fails)
{
    file_write("from/a.cl", "kernel", 6);
    cr_assert_eq(mkdir("to/a.cl", 0755), 0);
    char *message;
    capture_begin(2);
    int status = stage("a.cl", &message);
    expect_one_message(capture_end(2), "to/a.cl");
    cr_expect_eq(status, -1);
    cr_expect_null(message);
}

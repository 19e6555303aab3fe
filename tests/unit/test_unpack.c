// grader/unpack: the wanted files come out of every kind of archive, and nothing that an archive
// may say leads out of the folder or fills the disk. What ends in a message is
// test_unpack_faults.c's matter.
#include "packed_archives.h"
#include "places.h"
#include "stage.h"

TestSuite(unpack, .init = out_folder_enter, .fini = folder_leave);

// ---- What is right ------------------------------------------------------------------------------

Test(unpack, reads_every_kind_of_archive)
{
    static const char *const kinds[][2] = {
        {"zip", NULL},     {"ustar", NULL},  {"pax", NULL}, {"gnutar", NULL},
        {"ustar", "gzip"}, {"pax", "bzip2"}, {"pax", "xz"}, {"v7tar", "gzip"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct archive *writer = pack_begin(kinds[i][0], kinds[i][1], NULL);
        pack_entry(writer, "lab/", AE_IFDIR, "");
        pack_entry(writer, "lab/a.cl", AE_IFREG, kinds[i][0]);
        pack_entry(writer, "./b.c", AE_IFREG, "int b;");
        pack_entry(writer, "lab/main.c", AE_IFREG, "evil");
        pack_end(writer);
        cr_assert_eq(packed_unpack(n_packed), 0, "kind %zu: %s", i, message);
        expect_content("out/lab/a.cl", kinds[i][0]);
        expect_content("out/b.c", "int b;");
        cr_expect_eq(everything_count(), 3, "only the wanted files and their folders");
    }
}

Test(unpack, gives_plain_modes)
{
    pack_one("a.cl", AE_IFREG, "kernel");
    umask(022);  // as in the sandbox
    cr_assert_eq(packed_unpack(n_packed), 0);
    struct stat status;
    cr_assert_eq(stat("out/a.cl", &status), 0);
    cr_expect_eq(status.st_mode & 07777, 0644);
}

Test(unpack, lets_the_last_of_equal_paths_count)
{
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    pack_entry(writer, "a.cl", AE_IFREG, "older");
    pack_entry(writer, "./a.cl", AE_IFREG, "newer");
    pack_entry(writer, "b.c", AE_IFREG, "int b;");
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0);
    expect_content("out/a.cl", "newer");
    cr_expect_str_eq(message, "a.cl: 2 times in the archive as \"a.cl\", with different contents: "
                              "the last one counts");
}

Test(unpack, tells_of_equal_entries_only_of_a_file_that_counts)
{
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    for (int i = 0; i < 3; i++) {
        pack_entry(writer, "one/a.cl", AE_IFREG, "kernel");
        pack_entry(writer, "one/two/b.c", AE_IFREG, i == 1 ? "int b;" : "int a;");
    }
    pack_entry(writer, "b.c", AE_IFREG, "int c;");
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0);
    cr_expect_str_eq(message, "a.cl: 3 times in the archive as \"one/a.cl\", always the same: the "
                              "last one counts");
}

// Names that a system changed come out as they are, for staging to choose. What is only told is
// empty.
Test(unpack, writes_other_names_of_a_wanted_file)
{
    struct archive *writer = pack_begin("zip", NULL, NULL);
    pack_entry(writer, "lab/a-1.cl", AE_IFREG, "kernel");
    pack_entry(writer, "lab/b.c.txt", AE_IFREG, "int b;");
    pack_entry(writer, "lab/b.h", AE_IFREG, "int b;");
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0, "%s", message);
    expect_content("out/lab/a-1.cl", "kernel");
    struct stat status;
    cr_assert_eq(stat("out/lab/b.c.txt", &status), 0);
    cr_expect_eq(status.st_size, 0);
    cr_expect_eq(everything_count(), 3);
    cr_expect_str_eq(message, "the archive holds \"lab/a-1.cl\", \"lab/b.c.txt\", \"lab/b.h\"");
}

Test(unpack, lists_what_is_there_where_a_file_is_not)
{
    struct archive *writer = pack_begin("zip", NULL, NULL);
    for (int i = 0; i < 9; i++) {
        char path[] = "x/0\n.txt";
        path[2] = (char)('0' + i);
        pack_entry(writer, path, AE_IFREG, "text");
    }
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0, "%s", message);
    cr_expect_str_eq(message,
                     "the archive holds \"x/0\\x0A.txt\", \"x/1\\x0A.txt\", \"x/2\\x0A.txt\", "
                     "\"x/3\\x0A.txt\", \"x/4\\x0A.txt\", \"x/5\\x0A.txt\" and 3 more");
}

// ---- Which copies are written -------------------------------------------------------------------

// In any order: only the best place of each file, and the best of the others, are written.
Test(unpack, writes_the_best_places_and_one_other)
{
    static const char *const paths[] = {"x/y/z/a.cl",      "x/labs/03-x/a.cl", "one/a.cl",
                                        "build/a.cl",      "two/a.cl",         "x/y/a.cl",
                                        "labs/03-x/a.cl",  ".git/a.cl",        "x/b/a.cl",
                                        "__MACOSX/x/a.cl", "x/build/a.cl",     "three/a.cl"};
    enum { N_PATHS = sizeof paths / sizeof *paths };
    for (int first = 0; first < N_PATHS; first++) {
        struct archive *writer = pack_begin("ustar", NULL, NULL);
        for (int i = 0; i < N_PATHS; i++) {
            const char *path = paths[(first + i) % N_PATHS];
            pack_entry(writer, path, AE_IFREG, path);
        }
        pack_end(writer);
        cr_assert_eq(packed_unpack(n_packed), 0, "%s", message);
        expect_content("out/labs/03-x/a.cl", "labs/03-x/a.cl");
        expect_content("out/one/a.cl", "one/a.cl");
        cr_expect_eq(everything_count(), 5, "from %d on: %d", first, n_found - 2);
    }
}

Test(unpack, writes_all_places_that_are_equally_good_but_no_endless_number)
{
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    for (int i = 99; i >= 0; i--) {
        char path[32];
        snprintf(path, sizeof path, "%02d/a.cl", i);
        pack_entry(writer, path, AE_IFREG, path);
    }
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0, "%s", message);
    cr_expect_eq(everything_count(), 2 * (PLACES_MAX_EQUAL + 1), "one more than is taken");
    expect_content("out/00/a.cl", "00/a.cl");
}

// ---- What an archive may say --------------------------------------------------------------------

Test(unpack, lets_no_path_lead_out)
{
    char deep[64] = "", wide[320], longest[320];
    memset(wide, 'w', sizeof wide);
    strcpy(wide + 300, "/a.cl");
    memset(longest, 'l', sizeof longest);
    strcpy(longest + 255, "/a.cl");
    for (int i = 0; i <= PLACES_MAX_DEPTH; i++) {
        strcat(deep, "d/");
    }
    strcat(deep, "a.cl");
    struct archive *writer = pack_begin("pax", NULL, NULL);
    const char *const paths[] = {"../a.cl", "x/../../a.cl", "..",       "a.cl/..",
                                 wide,      deep,           "new\nline"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        pack_entry(writer, paths[i], AE_IFREG, "evil");
    }
    pack_end(writer);
    cr_expect_eq(packed_unpack(n_packed), 0, "%s", message);
    cr_expect_eq(everything_count(), 0);

    // These stay inside, under names that are as good as any.
    writer = pack_begin("pax", NULL, NULL);
    pack_entry(writer, "/tmp/absolute/a.cl", AE_IFREG, "inside");
    pack_entry(writer, longest, AE_IFREG, "long");
    pack_entry(writer, "new\nline\x1b/a.cl", AE_IFREG, "odd");
    pack_end(writer);
    cr_expect_eq(packed_unpack(n_packed), 0, "%s", message);
    expect_content("out/tmp/absolute/a.cl", "inside");
    expect_content("out/new\nline\x1b/a.cl", "odd");
    cr_expect_eq(everything_count(), 7);
}

Test(unpack, writes_through_no_link)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    pack_entry(writer, "folder", AE_IFLNK, "..");
    pack_entry(writer, "folder/a.cl", AE_IFREG, "inside");
    pack_entry(writer, "a.cl", AE_IFLNK, "..");
    pack_entry(writer, "a.cl/b.c", AE_IFREG, "evil");
    pack_entry(writer, "b.c", AE_IFLNK, "../outside");
    pack_entry(writer, "b.c", AE_IFREG, "kernel");
    pack_end(writer);
    cr_expect_eq(packed_unpack(n_packed), 0, "%s", message);
    expect_content("out/folder/a.cl", "inside");
    expect_content("out/b.c", "kernel");
    char target[64] = "";
    cr_expect_gt(readlink("out/a.cl", target, sizeof target - 1), 0);
    cr_expect_str_eq(target, "nowhere");
    cr_expect_eq(everything_count(), 4);
}

Test(unpack, shows_that_a_file_was_a_hard_link)
{
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    struct archive_entry *entry = archive_entry_new();
    archive_entry_set_pathname(entry, "a.cl");
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_hardlink(entry, "/etc/passwd");
    cr_assert_eq(archive_write_header(writer, entry), ARCHIVE_OK);
    archive_entry_free(entry);
    pack_end(writer);
    cr_expect_eq(packed_unpack(n_packed), 0);
    struct stat status;
    cr_assert_eq(lstat("out/a.cl", &status), 0);
    cr_expect(S_ISLNK(status.st_mode));
}

Test(unpack, makes_no_device_and_no_fifo)
{
    static const unsigned kinds[] = {AE_IFIFO, AE_IFCHR, AE_IFBLK, AE_IFDIR};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        pack_one("a.cl", kinds[i], "");
        cr_expect_eq(packed_unpack(n_packed), 0);
        struct stat status;
        cr_assert_eq(lstat("out/a.cl", &status), 0);
        cr_expect(S_ISDIR(status.st_mode));
    }
}

Test(unpack, cuts_a_large_file_behind_the_limit)
{
    static const char *const formats[] = {"zip", "pax"};
    static char text[2 * STAGE_MAX_FILE_BYTES];
    memset(text, ' ', sizeof text - 1);
    for (int i = 0; i < 2; i++) {
        struct archive *writer = pack_begin(formats[i], NULL, NULL);
        pack_entry(writer, "a.cl", AE_IFREG, text);
        pack_entry(writer, "b.c", AE_IFREG, "kernel");
        pack_end(writer);
        cr_expect_eq(packed_unpack(n_packed), 0, "%s", message);
        struct stat status;
        cr_assert_eq(stat("out/a.cl", &status), 0);
        cr_expect_eq(status.st_size, STAGE_MAX_FILE_BYTES + 1);
        expect_content("out/b.c", "kernel");
    }
}

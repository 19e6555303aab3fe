// grader/unpack: of a class's export all comes out, as it is, or the archive is refused.
#include "packed_archives.h"

TestSuite(unpack_export, .init = out_folder_enter, .fini = folder_leave);

// Into an empty folder.
static int export_unpack(void)
{
    struct archive *reader = unpack_export_reader_new();
    const int folder = open("out", O_RDONLY | O_DIRECTORY);
    cr_assert_eq(archive_read_open_memory(reader, packed, n_packed), ARCHIVE_OK);
    const int status = unpack_export(reader, folder, message);
    close(folder);
    archive_read_free(reader);
    return status;
}

Test(unpack_export, writes_all_there_is)
{
    static const char *const kinds[] = {"zip", "ustar"};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct archive *writer = pack_begin(kinds[i], NULL, NULL);
        pack_entry(writer, "./", AE_IFDIR, "");
        pack_entry(writer, "ada/", AE_IFDIR, "");
        pack_entry(writer, "/ada/.git/x", AE_IFREG, "1");
        pack_entry(writer, "J\xC3\xB6rg/a/b/c/d/e/f/g/h/i/j/k.zip", AE_IFREG, "2");
        pack_entry(writer, "J\x94rg.cl", AE_IFREG, "3");
        pack_entry(writer, "empty", AE_IFDIR, "");
        pack_entry(writer, "ada/link", AE_IFLNK, "/etc/passwd");
        pack_end(writer);
        cr_assert_eq(export_unpack(), 0, "%s: %s", kinds[i], message);
        expect_content("out/ada/.git/x", "1");
        expect_content("out/J\xC3\xB6rg/a/b/c/d/e/f/g/h/i/j/k.zip", "2");
        expect_content("out/J\x94rg.cl", "3");
        char target[16] = "";
        cr_expect_eq(readlink("out/ada/link", target, sizeof target), 7);
        cr_expect_eq(strncmp(target, "nowhere", 7), 0);
        cr_expect_eq(access("out/empty", F_OK), 0);
        cr_assert_eq(nftw("out", entry_remove, 32, FTW_DEPTH | FTW_PHYS), 0);
        cr_assert_eq(mkdir("out", 0755), 0);
    }
}

Test(unpack_export, keeps_times)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    struct archive_entry *entry = archive_entry_new();
    archive_entry_set_pathname(entry, "a");
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_mtime(entry, 1793500000, 0);
    cr_assert_eq(archive_write_header(writer, entry), ARCHIVE_OK);
    archive_entry_free(entry);
    pack_end(writer);
    cr_assert_eq(export_unpack(), 0, "%s", message);
    struct stat status;
    cr_assert_eq(stat("out/a", &status), 0);
    cr_expect_eq(status.st_mtime, 1793500000);
}

// Nobody's work may be left out, so one entry that cannot be written is enough.
Test(unpack_export, refuses_what_it_cannot_write)
{
    static const struct {
        const char *first, *second, *says;
    } cases[] = {
        {"a", "a", "\"a\" is in the archive twice: unpack it yourself, and give the folder"},
        {"a", "a/b", "\"a/b\" is in the archive as a folder and as something else"},
        {"a", "../b", "\"../b\" is no path below a folder, or a long one"},
        {"a", "x/../b", "\"x/../b\" is no path below a folder, or a long one"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct archive *writer = pack_begin("pax", NULL, NULL);
        pack_entry(writer, cases[i].first, AE_IFREG, "1");
        pack_entry(writer, cases[i].second, AE_IFREG, "2");
        pack_end(writer);
        cr_expect_eq(export_unpack(), 1, "%s", cases[i].second);
        cr_expect_eq(strncmp(message, cases[i].says, strlen(cases[i].says)), 0, "found: %s",
                     message);
        unlink("out/a");
    }
}

// Two tars of a student each, behind each other in `packed`; the second begins at the byte that is
// returned.
static size_t two_tars_pack(void)
{
    unsigned char first[1 << 14];
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    pack_entry(writer, "ada", AE_IFREG, "1");
    pack_end(writer);
    const size_t n_first = n_packed;
    cr_assert_leq(n_first, sizeof first);
    memcpy(first, packed, n_first);
    writer = pack_begin("ustar", NULL, NULL);
    pack_entry(writer, "bob", AE_IFREG, "2");
    pack_entry(writer, "cy", AE_IFREG, "3");
    pack_end(writer);
    cr_assert_leq(n_first + n_packed, sizeof packed);
    memmove(packed + n_first, packed, n_packed);
    memcpy(packed, first, n_first);
    n_packed += n_first;
    return n_first;
}

Test(unpack_export, reads_tars_behind_each_other)
{
    two_tars_pack();
    cr_assert_eq(export_unpack(), 0, "%s", message);
    expect_content("out/ada", "1");
    expect_content("out/bob", "2");
    expect_content("out/cy", "3");
}

// Cut behind an entry, a tar looks like a shorter one.
Test(unpack_export, refuses_a_tar_without_its_end)
{
    n_packed = two_tars_pack() + 1024;
    cr_expect_eq(export_unpack(), 1);
    cr_expect_not_null(strstr(message, "damaged or cut off (a tar archive without its end mark)"),
                       "%s", message);
}

Test(unpack_export, does_not_write_through_a_link)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    pack_entry(writer, "a", AE_IFLNK, "..");
    pack_entry(writer, "a/b", AE_IFREG, "1");
    pack_end(writer);
    cr_expect_eq(export_unpack(), 1);
    cr_expect_not_null(strstr(message, "as a folder and as something else"), "%s", message);
    cr_expect_eq(everything_count(), 1);
}

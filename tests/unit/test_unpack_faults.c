// grader/unpack: archives that are refused, damaged, endless or none at all, and a full disk.
#include "file_kind.h"
#include "packed_archives.h"
#include "stage.h"

#include <signal.h>
#include <sys/resource.h>

TestSuite(unpack_faults, .init = out_folder_enter, .fini = folder_leave);

// ---- What ends in a message ---------------------------------------------------------------------

static void expect_refused(int status, const char *part)
{
    cr_expect_eq(status, 1);
    cr_expect_not_null(strstr(message, part), "no \"%s\" in \"%s\"", part, message);
    cr_expect_null(strchr(message, '\n'));
}

Test(unpack_faults, tells_of_an_encrypted_archive)
{
    struct archive *writer = pack_begin("zip", NULL, "zip:encryption=traditional");
    pack_entry(writer, "a.cl", AE_IFREG, "kernel");
    pack_end(writer);
    expect_refused(packed_unpack(n_packed), "the archive is encrypted: hand it in without");
    cr_expect_eq(everything_count(), 0);
}

Test(unpack_faults, tells_of_an_archive_that_says_it_is_enormous)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    struct archive_entry *entry = archive_entry_new();
    archive_entry_set_pathname(entry, "video.mp4");
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_size(entry, (la_int64_t)1 << 40);
    cr_assert_eq(archive_write_header(writer, entry), ARCHIVE_OK);
    archive_entry_free(entry);
    archive_write_fail(writer);
    archive_write_free(writer);
    expect_refused(packed_unpack(n_packed), "more than 512 MB, unpacked");
}

Test(unpack_faults, tells_of_an_office_document)
{
    struct archive *writer = pack_begin("zip", NULL, NULL);
    pack_entry(writer, "[Content_Types].xml", AE_IFREG, "<Types/>");
    pack_entry(writer, "word/document.xml", AE_IFREG, "<document/>");
    pack_end(writer);
    expect_refused(packed_unpack(n_packed), "found an office program's document");
}

Test(unpack_faults, tells_of_an_archive_in_an_archive)
{
    struct archive *writer = pack_begin("zip", NULL, NULL);
    pack_entry(writer, "mine/lab3.tar.gz", AE_IFREG, "");
    pack_end(writer);
    expect_refused(packed_unpack(n_packed), "holds another one, lab3.tar.gz, and none of the lab");
    // Beside what is wanted it does not matter.
    writer = pack_begin("zip", NULL, NULL);
    pack_entry(writer, "backup.zip", AE_IFREG, "");
    pack_entry(writer, "a.cl", AE_IFREG, "kernel");
    pack_end(writer);
    cr_expect_eq(packed_unpack(n_packed), 0, "%s", message);
}

Test(unpack_faults, tells_of_an_empty_archive)
{
    pack_end(pack_begin("zip", NULL, NULL));
    cr_expect_eq(packed_unpack(n_packed), UNPACK_NO_ARCHIVE);
    cr_expect_str_eq(file_kind((const unsigned char *)packed, n_packed).name,
                     "an empty zip archive");
    pack_one("lab/", AE_IFDIR, "");
    expect_refused(packed_unpack(n_packed), "the archive is empty");
}

Test(unpack_faults, takes_an_archive_without_any_wanted_file)
{
    pack_one("README.md", AE_IFREG, "text");
    cr_expect_eq(packed_unpack(n_packed), 0);
    cr_expect_eq(everything_count(), 0);
}

// Every place where an archive can be cut off.
Test(unpack_faults, survives_what_is_cut_off)
{
    static const char *const kinds[][2] = {
        {"zip", NULL}, {"ustar", NULL}, {"pax", "gzip"}, {"pax", "bzip2"}, {"pax", "xz"}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct archive *writer = pack_begin(kinds[i][0], kinds[i][1], NULL);
        pack_entry(writer, "lab/a.cl", AE_IFREG, "kernel");
        pack_entry(writer, "lab/b.c", AE_IFREG, "int b;");
        pack_end(writer);
        const size_t n_whole = n_packed;
        for (size_t n_bytes = 0; n_bytes < n_whole; n_bytes++) {
            const int status = packed_unpack(n_bytes);
            cr_assert(status == 0 || status == 1 || status == UNPACK_NO_ARCHIVE,
                      "kind %zu, %zu bytes: %d", i, n_bytes, status);
            cr_assert(status == 0 || (message[0] != '\0') == (status == 1), "%s", message);
            // Only plain tar may end between two entries, or in the zeros at its end.
            cr_assert(status != 0 || n_bytes > n_whole / 2 || (i == 1 && n_bytes % 512 == 0));
        }
        cr_expect_eq(packed_unpack(n_whole), 0);
    }
}

// ---- Archives without an end --------------------------------------------------------------------

// The same tar entry again and again, for libarchive to read.
static la_ssize_t entry_again(struct archive *archive, void *context, const void **block)
{
    (void)archive, (void)context;
    *block = packed;
    return 512;
}

static int endless_unpack(const char *path)
{
    struct archive *writer = pack_begin("ustar", NULL, NULL);
    pack_entry(writer, path, AE_IFREG, "");
    pack_end(writer);
    struct archive *reader = unpack_reader_new();
    cr_assert_eq(archive_read_open(reader, NULL, NULL, entry_again, NULL), ARCHIVE_OK);
    return reader_unpack(reader);
}

Test(unpack_faults, ends_with_too_many_entries)
{
    expect_refused(endless_unpack("other.c"), "more than 200000 files");
    cr_expect_eq(everything_count(), 0);
}

Test(unpack_faults, ends_with_too_many_wanted_files)
{
    expect_refused(endless_unpack("a.cl"), "a.cl and the like more than 1000 times");
    cr_expect_eq(everything_count(), 0);
}

// ---- Too much of it -----------------------------------------------------------------------------

Test(unpack_faults, ends_with_more_than_may_be_written)
{
    static char text[STAGE_MAX_FILE_BYTES];
    memset(text, ' ', sizeof text - 1);
    for (int n = 16; n <= 17; n++) {
        struct archive *writer = pack_begin("zip", NULL, NULL);
        for (int i = 0; i < n; i++) {
            char path[32];
            snprintf(path, sizeof path, "%d/a.cl", i);
            pack_entry(writer, path, AE_IFREG, text);
        }
        pack_end(writer);
        const int status = packed_unpack(n_packed);
        if (n == 16) {
            cr_expect_eq(status, 0, "%s", message);
        } else {
            expect_refused(status,
                           "holds at least 4.2 MB of the lab's files in places that are equally "
                           "good, expected at most 4 MB: hand in each file once");
            cr_expect_eq(everything_count(), 0);
        }
    }
}

Test(unpack_faults, ends_with_layer_upon_layer)
{
    static char inner[sizeof packed];
    pack_one("a.cl", AE_IFREG, "kernel");
    for (int n_layers = 1; n_layers <= 4; n_layers++) {
        const size_t n_inner = n_packed;
        memcpy(inner, packed, n_inner);
        struct archive *writer = archive_write_new();
        cr_assert_eq(archive_write_set_format_raw(writer), ARCHIVE_OK);
        cr_assert_eq(archive_write_add_filter_xz(writer), ARCHIVE_OK);
        cr_assert_eq(archive_write_open_memory(writer, packed, sizeof packed, &n_packed),
                     ARCHIVE_OK);
        struct archive_entry *entry = archive_entry_new();
        archive_entry_set_filetype(entry, AE_IFREG);
        cr_assert_eq(archive_write_header(writer, entry), ARCHIVE_OK);
        cr_assert_eq(archive_write_data(writer, inner, n_inner), (la_ssize_t)n_inner);
        archive_entry_free(entry);
        pack_end(writer);
        const int status = packed_unpack(n_packed);
        if (n_layers <= UNPACK_MAX_LAYERS) {
            cr_expect_eq(status, 0, "%s", message);
        } else {
            expect_refused(status, "times over, expected at most 2");
        }
    }
}

// ---- The disk -----------------------------------------------------------------------------------

Test(unpack_faults, tells_when_a_file_cannot_be_written)
{
    pack_one("a.cl", AE_IFREG, "kernel");
    signal(SIGXFSZ, SIG_IGN);
    struct rlimit limit;
    cr_assert_eq(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = 3;
    cr_assert_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const int status = packed_unpack(n_packed);
    limit.rlim_cur = before;
    cr_assert_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    cr_expect_eq(status, -1);
}

// ---- What is no archive -------------------------------------------------------------------------

Test(unpack_faults, knows_what_is_no_archive)
{
    static const char *const files[][2] = {
        {"", "an empty file"},
        {"int main(void) { return 0; }", "a single text file"},
        {"Rar!\x1a\x07", "a RAR archive"},
        {"7z\xBC\xAF\x27\x1C", "a 7-Zip archive"},
        {"PK\x03\x04", "a zip archive that is damaged or cut off"},
        {"%PDF-1.7", "a PDF document"},
        {"BZh9", "a compressed file (bzip2)"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        const size_t n_bytes = strlen(files[i][0]);
        memcpy(packed, files[i][0], n_bytes);
        cr_expect_eq(packed_unpack(n_bytes), UNPACK_NO_ARCHIVE, "%s", files[i][1]);
        const FileKind kind = file_kind((const unsigned char *)packed, n_bytes);
        char said[128];
        snprintf(said, sizeof said, "%s%s", kind.name, kind.fault);
        cr_expect_eq(strncmp(said, files[i][1], strlen(files[i][1])), 0, "%s", said);
    }
    cr_expect_str_eq(file_kind((const unsigned char *)"\x01\x00\x02", 3).name,
                     "a file of unknown kind");
}

// grader/unpack: the wanted files come out of every kind of archive, and nothing that an archive
// may say leads out of the folder, fills the disk or goes on for ever.
#include "file_kind.h"
#include "places.h"
#include "stage.h"
#include "surroundings.h"
#include "unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>

// A folder "out" to unpack into.
static void out_folder_enter(void)
{
    folder_enter();
    cr_assert_eq(mkdir("out", 0755), 0);
}

TestSuite(unpack, .init = out_folder_enter, .fini = folder_leave);

// ---- Making archives ------------------------------------------------------------------------

static char packed[1 << 20];
static size_t n_packed;

// A new archive in packed[]; filter and options may be NULL.
static struct archive *pack_begin(const char *format, const char *filter, const char *options)
{
    struct archive *writer = archive_write_new();
    cr_assert_eq(archive_write_set_format_by_name(writer, format), ARCHIVE_OK);
    cr_assert(filter == NULL || archive_write_add_filter_by_name(writer, filter) == ARCHIVE_OK);
    cr_assert(options == NULL || archive_write_set_options(writer, options) == ARCHIVE_OK);
    archive_write_set_passphrase(writer, "secret");
    archive_write_set_bytes_per_block(writer, 512);
    archive_write_set_bytes_in_last_block(writer, 1);
    cr_assert_eq(archive_write_open_memory(writer, packed, sizeof packed, &n_packed), ARCHIVE_OK);
    return writer;
}

// Add an entry of a kind (AE_IFREG, ...); a link leads to `content`.
static void pack_entry(struct archive *writer, const char *path, unsigned kind, const char *content)
{
    struct archive_entry *entry = archive_entry_new();
    archive_entry_set_pathname(entry, path);
    archive_entry_set_perm(entry, 04777);
    archive_entry_set_filetype(entry, kind);
    const size_t n_bytes = kind == AE_IFREG ? strlen(content) : 0;
    archive_entry_set_size(entry, (la_int64_t)n_bytes);
    if (kind == AE_IFLNK) {
        archive_entry_set_symlink(entry, content);
    }
    cr_assert_eq(archive_write_header(writer, entry), ARCHIVE_OK, "%s",
                 archive_error_string(writer));
    cr_assert_eq(archive_write_data(writer, content, n_bytes), (la_ssize_t)n_bytes);
    archive_entry_free(entry);
}

static void pack_end(struct archive *writer)
{
    cr_assert_eq(archive_write_close(writer), ARCHIVE_OK);
    archive_write_free(writer);
}

// A tar archive of one entry.
static void pack_one(const char *path, unsigned kind, const char *content)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    pack_entry(writer, path, kind, content);
    pack_end(writer);
}

// ---- Unpacking ------------------------------------------------------------------------------

static char *const names[] = {"a.cl", "b.c"};
static char message[UNPACK_MESSAGE_BYTES];

static int reader_unpack(struct archive *reader)
{
    const int folder = open("out", O_RDONLY | O_DIRECTORY);
    const int status = unpack(reader, folder, names, 2, message);
    close(folder);
    archive_read_free(reader);
    return status;
}

static int packed_unpack(size_t n_bytes)
{
    struct archive *reader = unpack_reader_new();
    message[0] = '\0';
    if (archive_read_open_memory(reader, packed, n_bytes) != ARCHIVE_OK) {
        archive_read_free(reader);
        return UNPACK_NO_ARCHIVE;
    }
    return reader_unpack(reader);
}

static void expect_content(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    cr_assert_not_null(file, "%s", path);
    cr_expect(fgets(text, sizeof text, file) != NULL);
    cr_expect_str_eq(text, expected);
    fclose(file);
}

static int n_found;

static int entry_count(const char *path, const struct stat *status, int kind, struct FTW *position)
{
    (void)path, (void)status, (void)kind, (void)position;
    n_found++;
    return 0;
}

// How many files and folders there are in all, "out" itself aside.
static int everything_count(void)
{
    n_found = 0;
    nftw(".", entry_count, 16, FTW_PHYS);
    return n_found - 2;
}

// ---- What is right --------------------------------------------------------------------------

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
    pack_end(writer);
    cr_assert_eq(packed_unpack(n_packed), 0);
    expect_content("out/a.cl", "newer");
}

// ---- What an archive may say ----------------------------------------------------------------

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
        cr_assert_eq(rmdir("out/a.cl"), 0);
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

// ---- What ends in a message -----------------------------------------------------------------

static void expect_refused(int status, const char *part)
{
    cr_expect_eq(status, 1);
    cr_expect_not_null(strstr(message, part), "no \"%s\" in \"%s\"", part, message);
    cr_expect_null(strchr(message, '\n'));
}

Test(unpack, tells_of_an_encrypted_archive)
{
    struct archive *writer = pack_begin("zip", NULL, "zip:encryption=traditional");
    pack_entry(writer, "a.cl", AE_IFREG, "kernel");
    pack_end(writer);
    expect_refused(packed_unpack(n_packed), "the archive is encrypted: hand it in without");
    cr_expect_eq(everything_count(), 0);
}

Test(unpack, tells_of_an_archive_that_says_it_is_enormous)
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

Test(unpack, tells_of_an_office_document)
{
    struct archive *writer = pack_begin("zip", NULL, NULL);
    pack_entry(writer, "[Content_Types].xml", AE_IFREG, "<Types/>");
    pack_entry(writer, "word/document.xml", AE_IFREG, "<document/>");
    pack_end(writer);
    expect_refused(packed_unpack(n_packed), "found an office program's document");
}

Test(unpack, tells_of_an_archive_in_an_archive)
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

Test(unpack, takes_an_archive_without_any_wanted_file)
{
    pack_one("README.md", AE_IFREG, "text");
    cr_expect_eq(packed_unpack(n_packed), 0);
    cr_expect_eq(everything_count(), 0);
}

// Every place where an archive can be cut off.
Test(unpack, survives_what_is_cut_off)
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
            cr_assert_eq(message[0] != '\0', status == 1);
            // Only plain tar may end between two entries, or in the zeros at its end.
            cr_assert(status != 0 || n_bytes > n_whole / 2 || (i == 1 && n_bytes % 512 == 0));
        }
        cr_expect_eq(packed_unpack(n_whole), 0);
    }
}

// ---- Archives without an end ----------------------------------------------------------------

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

Test(unpack, ends_with_too_many_entries)
{
    expect_refused(endless_unpack("other.c"), "more than 200000 files");
    cr_expect_eq(everything_count(), 0);
}

Test(unpack, ends_with_too_many_wanted_files)
{
    expect_refused(endless_unpack("a.cl"), "a.cl and the like more than 1000 times");
    cr_expect_eq(everything_count(), 1);
}

// ---- The disk -------------------------------------------------------------------------------

Test(unpack, tells_when_a_file_cannot_be_written)
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

// ---- What is no archive ---------------------------------------------------------------------

Test(unpack, knows_what_is_no_archive)
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
        const char *kind = file_kind((const unsigned char *)packed, n_bytes);
        cr_expect_eq(strncmp(kind, files[i][1], strlen(files[i][1])), 0, "%s", kind);
    }
    cr_expect_str_eq(file_kind((const unsigned char *)"\x01\x00\x02", 3), "a file of unknown kind");
}

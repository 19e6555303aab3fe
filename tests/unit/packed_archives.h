// Archives made in memory, and unpacked into the folder "out", for the tests of the unpacker.
#ifndef UNIT_PACKED_ARCHIVES_H
#define UNIT_PACKED_ARCHIVES_H

#include "surroundings.h"
#include "unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>

// A folder "out" to unpack into.
static inline void out_folder_enter(void)
{
    folder_enter();
    cr_assert_eq(mkdir("out", 0755), 0);
}

// ---- Making archives ----------------------------------------------------------------------------

static char packed[1 << 20];
static size_t n_packed;

// A new archive in packed[]; filter and options may be NULL.
static inline struct archive *pack_begin(const char *format, const char *filter,
                                         const char *options)
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
static inline void pack_entry(struct archive *writer, const char *path, unsigned kind,
                              const char *content)
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

static inline void pack_end(struct archive *writer)
{
    cr_assert_eq(archive_write_close(writer), ARCHIVE_OK);
    archive_write_free(writer);
}

// A tar archive of one entry.
static inline void pack_one(const char *path, unsigned kind, const char *content)
{
    struct archive *writer = pack_begin("pax", NULL, NULL);
    pack_entry(writer, path, kind, content);
    pack_end(writer);
}

// ---- Unpacking ----------------------------------------------------------------------------------

static const Manifest manifest = {.lab = "03-x", .files = {"a.cl", "b.c"}, .n_files = 2};
static char message[UNPACK_MESSAGE_BYTES];

// Into an empty folder.
static inline int reader_unpack(struct archive *reader)
{
    nftw("out", entry_remove, 16, FTW_DEPTH | FTW_PHYS);
    cr_assert_eq(mkdir("out", 0755), 0);
    const int folder = open("out", O_RDONLY | O_DIRECTORY);
    const int status = unpack(reader, &manifest, folder, message);
    close(folder);
    archive_read_free(reader);
    return status;
}

static inline int packed_unpack(size_t n_bytes)
{
    struct archive *reader = unpack_reader_new();
    message[0] = '\0';
    if (archive_read_open_memory(reader, packed, n_bytes) != ARCHIVE_OK) {
        archive_read_free(reader);
        return UNPACK_NO_ARCHIVE;
    }
    return reader_unpack(reader);
}

static int n_found;

static inline int entry_count(const char *path, const struct stat *status, int kind,
                              struct FTW *position)
{
    (void)path, (void)status, (void)kind, (void)position;
    n_found++;
    return 0;
}

// How many files and folders there are in all, "out" itself aside.
static inline int everything_count(void)
{
    n_found = 0;
    nftw(".", entry_count, 16, FTW_PHYS);
    return n_found - 2;
}

#endif

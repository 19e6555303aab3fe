// unpack: the one program that reads archives, in the sandbox: the lab's files out of a student's,
// or all that is in a class's export.
//
//     unpack ARCHIVE FOLDER LAB NAME...
//     unpack ARCHIVE FOLDER
//
// Writes the entries with these names into the empty FOLDER (unpack.h says how). Exit status: 0,
// with lines on stdout where there is something to say; 1 when the archive is at fault, which one
// line on stdout tells; 2 when it could not work itself, before it looked at the archive or by a
// fault of the folder, with a line on stderr. Read next: unpack_run.c, which starts it, and does
// not believe the 2.
#include "bytes_write.h"
#include "complain.h"
#include "file_kind.h"
#include "unpack.h"

#include <archive.h>
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_UNPACKED = 0, EXIT_ARCHIVE = 1, EXIT_FAULT = 2, BLOCK_BYTES = 65536 };

static int fault(const char *name)
{
    complain("unpack: %s: %s", name, strerror(errno));
    return EXIT_FAULT;
}

// No archive: say what it is, and what should have been handed in.
static int tell_kind(int descriptor, const Manifest *manifest)
{
    unsigned char bytes[512];
    const ssize_t n = pread(descriptor, bytes, sizeof bytes, 0);
    const FileKind kind = file_kind(bytes, n > 0 ? (size_t)n : 0);
    printf("found %s%s, expected ", kind.name, kind.fault);
    if (manifest->n_files == 0) {
        printf("the submissions");
    }
    for (int i = 0; i < manifest->n_files; i++) {
        const char *joint = i == 0 ? "" : i < manifest->n_files - 1 ? ", " : " and ";
        printf("%s%s", joint, manifest->files[i]);
    }
    printf(" in a folder, or in a zip or tar archive (.zip, .tar, .tar.gz, .tar.bz2, .tar.xz)\n");
    return EXIT_ARCHIVE;
}

static int archive_unpack(struct archive *archive, const Manifest *manifest, int from, int to)
{
    char message[UNPACK_MESSAGE_BYTES] = "";
    int outcome = UNPACK_NO_ARCHIVE;
    if (archive_read_open_fd(archive, from, BLOCK_BYTES) == ARCHIVE_OK) {
        outcome = manifest->n_files > 0 ? unpack(archive, manifest, to, message)
                                        : unpack_export(archive, to, message);
    }
    if (outcome == UNPACK_NO_ARCHIVE) {
        return tell_kind(from, manifest);
    }
    if (outcome < 0) {
        return fault("cannot write what was unpacked");
    }
    if (message[0] != '\0') {
        puts(message);
    }
    return outcome == 0 ? EXIT_UNPACKED : EXIT_ARCHIVE;
}

int main(int argc, char **argv)
{
    Manifest manifest = {.n_files = argc > 4 ? argc - 4 : 0};
    if (argc < 3 || argc == 4 || manifest.n_files > MANIFEST_MAX_FILES) {
        fprintf(stderr, "usage: unpack ARCHIVE FOLDER [LAB NAME...]\n");
        return EXIT_FAULT;
    }
    if (manifest.n_files > 0) {
        snprintf(manifest.lab, sizeof manifest.lab, "%s", argv[3]);
        memcpy(manifest.files, argv + 4, (size_t)manifest.n_files * sizeof *argv);
    }
    setlocale(LC_CTYPE, "");  // names in an archive may be UTF-8
    const int from = open(argv[1], O_RDONLY | O_CLOEXEC);
    const int to = open(argv[2], O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (from < 0 || to < 0) {
        return fault(from < 0 ? argv[1] : argv[2]);
    }
    if (room_try(to, UNPACK_MAX_WRITTEN_MEGABYTES) != 0) {
        return fault("no room for what is to be unpacked");
    }
    struct archive *archive =
        manifest.n_files > 0 ? unpack_reader_new() : unpack_export_reader_new();
    if (archive == NULL) {
        errno = ENOMEM;
        return fault(argv[1]);
    }
    const int status = archive_unpack(archive, &manifest, from, to);
    archive_read_free(archive);
    return fflush(stdout) == 0 ? status : EXIT_FAULT;
}

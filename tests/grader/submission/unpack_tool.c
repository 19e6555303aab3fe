// unpack: the lab's files out of an archive; the one program that reads archives, in the sandbox.
//
//     unpack ARCHIVE FOLDER NAME...
//
// Writes the entries with these names into FOLDER (unpack.h says how). Exit status: 0; 1 when the
// archive is at fault, which one line on stdout tells; 2 when it could not work itself, with a line
// on stderr. Read next: submission.c, which starts it.
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
static int tell_kind(int descriptor, int n_names, char **names)
{
    unsigned char bytes[512];
    const ssize_t n = pread(descriptor, bytes, sizeof bytes, 0);
    printf("found %s, expected ", file_kind(bytes, n > 0 ? (size_t)n : 0));
    for (int i = 0; i < n_names; i++) {
        printf("%s%s", i == 0 ? "" : i < n_names - 1 ? ", " : " and ", names[i]);
    }
    printf(" in a folder, or in a zip or tar archive (.zip, .tar, .tar.gz, .tar.bz2, .tar.xz)\n");
    return EXIT_ARCHIVE;
}

static int archive_unpack(struct archive *archive, int from, int to, int n_names, char **names)
{
    char message[UNPACK_MESSAGE_BYTES];
    int outcome = UNPACK_NO_ARCHIVE;
    if (archive_read_open_fd(archive, from, BLOCK_BYTES) == ARCHIVE_OK) {
        outcome = unpack(archive, to, names, n_names, message);
    }
    switch (outcome) {
    case 0:
        return EXIT_UNPACKED;
    case 1:
        puts(message);
        return EXIT_ARCHIVE;
    case UNPACK_NO_ARCHIVE:
        return tell_kind(from, n_names, names);
    default:
        return fault("cannot write what was unpacked");
    }
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fprintf(stderr, "usage: unpack ARCHIVE FOLDER NAME...\n");
        return EXIT_FAULT;
    }
    setlocale(LC_CTYPE, "");  // names in an archive may be UTF-8
    const int from = open(argv[1], O_RDONLY | O_CLOEXEC);
    const int to = open(argv[2], O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (from < 0 || to < 0) {
        return fault(from < 0 ? argv[1] : argv[2]);
    }
    struct archive *archive = unpack_reader_new();
    if (archive == NULL) {
        errno = ENOMEM;
        return fault(argv[1]);
    }
    const int status = archive_unpack(archive, from, to, argc - 3, argv + 3);
    archive_read_free(archive);
    return fflush(stdout) == 0 ? status : EXIT_FAULT;
}

// Staging: the manifest's files, and only those, from a submission into the instructor's own tree.
//
// A submission is a folder that a student filled as they liked, so each file is opened without
// following links or waiting, and looked at through its open descriptor: what was checked is what
// is copied. Read next: places.h (where a file is looked for), sandbox.h.
#include "stage.h"

#include "bytes_write.h"
#include "message.h"
#include "places.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Staging {
    const char *submission, *destination;  // as the instructor named them, for messages
    int from, to;                          // the two folders, open
    FILE *said;                            // to the student, one line each
    unsigned char *bytes;                  // [STAGE_MAX_FILE_BYTES + 1] the file under way
    unsigned char *others;                 // the same for one that may be equal to it
} Staging;

static int machinery_fault(const char *folder, const char *file, int fault)
{
    fprintf(stderr, "%s%s%s: %s\n", folder, file[0] ? "/" : "", file, strerror(fault));
    return -1;
}

// A fault of the submission: one line to the student.
static int complain(const Staging *staging, const char *file, const char *complaint)
{
    fprintf(staging->said, "%s: %s\n", file, complaint);
    return 1;
}

static int complain_open_failed(const Staging *staging, const char *file, int fault)
{
    switch (fault) {
    case ELOOP:
        return complain(staging, file, "a symbolic link: hand in the file itself");
    case ENXIO:
        return complain(staging, file, "not a regular file");
    case EACCES:
        return complain(staging, file, "cannot be opened: its permissions forbid reading");
    default:
        break;
    }
    if (place_fault_is_ours(fault)) {
        return machinery_fault(staging->submission, file, fault);
    }
    fprintf(staging->said, "%s: cannot be opened: %s\n", file, strerror(fault));
    return 1;
}

static int complain_too_large(const Staging *staging, const char *file)
{
    fprintf(staging->said, "%s: larger than the allowed %d KB\n", file,
            STAGE_MAX_FILE_BYTES / 1024);
    return 1;
}

// Open a regular file in an open folder. Returns a descriptor, or -1 with errno set: ENXIO where it
// is something else.
static int regular_open(int parent, const char *file)
{
    struct stat status;
    if (fstatat(parent, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    // Opening alone may do something to a device: a tape winds, a watchdog wakes.
    if (!S_ISREG(status.st_mode)) {
        errno = S_ISLNK(status.st_mode) ? ELOOP : ENXIO;
        return -1;
    }
    // O_NONBLOCK: opening a FIFO that has taken its place meanwhile would wait for a writer that
    // never comes.
    return openat(parent, file, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

// Open a file where it was found. Returns as regular_open() does.
static int file_open(const Staging *staging, const char *folder, const char *file)
{
    const int parent = place_open(staging->from, folder);
    if (parent < 0) {
        return -1;
    }
    const int descriptor = regular_open(parent, file);
    const int fault = errno;
    close(parent);
    errno = fault;
    return descriptor;
}

// Read what an open file holds, one byte more than allowed at most. Returns how much, or -1.
static ssize_t bytes_read(int descriptor, unsigned char *bytes)
{
    size_t n_read = 0;
    while (n_read <= STAGE_MAX_FILE_BYTES) {
        ssize_t n = read(descriptor, bytes + n_read, STAGE_MAX_FILE_BYTES + 1 - n_read);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            return -1;
        }
        if (n == 0) {
            break;
        }
        n_read += (size_t)n;
    }
    return (ssize_t)n_read;
}

// Read the open file into staging->bytes. Returns 0, 1 (the submission is at fault) or -1.
static int file_read(const Staging *staging, const char *file, int descriptor, size_t *n_bytes)
{
    struct stat status;
    if (fstat(descriptor, &status) != 0) {
        return machinery_fault(staging->submission, file, errno);
    }
    if (!S_ISREG(status.st_mode)) {
        return complain(staging, file, "not a regular file");
    }
    if (status.st_size > STAGE_MAX_FILE_BYTES) {
        return complain_too_large(staging, file);
    }
    const ssize_t n_read = bytes_read(descriptor, staging->bytes);
    if (n_read < 0) {
        return machinery_fault(staging->submission, file, errno);
    }
    if (n_read > STAGE_MAX_FILE_BYTES) {  // it grew meanwhile
        return complain_too_large(staging, file);
    }
    if (memchr(staging->bytes, '\0', (size_t)n_read) != NULL) {
        return complain(staging, file,
                        "holds NUL bytes, so it is no source text: save it as plain text (UTF-8)");
    }
    *n_bytes = (size_t)n_read;
    return 0;
}

// Write staging->bytes as a new file. Returns 0 or -1.
static int file_write(const Staging *staging, const char *file, size_t n_bytes)
{
    // The destination may hold the skeleton under this name, perhaps as a link to the instructor's
    // original: replaced, never written through.
    if (unlinkat(staging->to, file, 0) != 0 && errno != ENOENT) {
        return machinery_fault(staging->destination, file, errno);
    }
    int descriptor = openat(staging->to, file, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor < 0) {
        return machinery_fault(staging->destination, file, errno);
    }

    const int failed = fchmod(descriptor, 0644) != 0 ||  // whatever the umask
                       bytes_write(descriptor, staging->bytes, n_bytes) != 0;
    int fault = failed ? errno : 0;
    if (close(descriptor) != 0 && fault == 0) {
        fault = errno;
    }
    return fault == 0 ? 0 : machinery_fault(staging->destination, file, fault);
}

// ---- Which of several -----------------------------------------------------------------------

// How many bytes of text the file at that place holds, or -1 when it is none that could be staged.
static ssize_t text_read(const Staging *staging, const char *folder, const char *file,
                         unsigned char *bytes)
{
    struct stat status;
    const int descriptor = file_open(staging, folder, file);
    if (descriptor < 0) {
        return -1;
    }
    const int is_regular = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                           status.st_size <= STAGE_MAX_FILE_BYTES;
    const ssize_t n_read = is_regular ? bytes_read(descriptor, bytes) : -1;
    close(descriptor);
    return n_read;
}

static int complain_two_places(const Staging *staging, const char *file, const char *first,
                               const char *second)
{
    char shown[2][MESSAGE_SHOWN_BYTES];
    fprintf(staging->said,
            "%s: found in \"%s\" and, with another content, in \"%s\": hand in only one\n", file,
            message_show(first, shown[0], sizeof shown[0]),
            message_show(second, shown[1], sizeof shown[1]));
    return 1;
}

// Several places are equally good: then all must hold the same. Returns 0 or 1.
static int places_agree(const Staging *staging, const char *file, const Places *places)
{
    if (places->are_more) {
        fprintf(staging->said, "%s: found in more than %d folders: hand in only one\n", file,
                PLACES_MAX_EQUAL);
        return 1;
    }
    const char *first = places->folders[0];
    const ssize_t n_bytes =
        places->n_folders > 1 ? text_read(staging, first, file, staging->bytes) : 0;
    for (int i = 1; i < places->n_folders; i++) {
        const char *second = places->folders[i];
        if (n_bytes < 0 || text_read(staging, second, file, staging->others) != n_bytes ||
            memcmp(staging->bytes, staging->others, (size_t)n_bytes) != 0) {
            return complain_two_places(staging, file, first, second);
        }
    }
    return 0;
}

// ---- What was taken -------------------------------------------------------------------------

// The folder in quotes, fit for a message.
static void folder_say(const Staging *staging, const char *folder)
{
    char shown[MESSAGE_SHOWN_BYTES];
    fprintf(staging->said, folder[0] != '\0' ? "\"%s\"" : "the top folder",
            message_show(folder, shown, sizeof shown));
}

// Say which of several was taken, and where the others are, but for the less good ones of which
// only the best is known. staging->bytes holds what was taken.
static void choice_say(const Staging *staging, const char *file, size_t n_bytes,
                       const Places *places)
{
    if (places->n_folders == 1 && places->other == NULL) {
        return;
    }
    fprintf(staging->said, "%s: taken from ", file);
    folder_say(staging, places->folders[0]);
    for (int i = 1; i < places->n_folders; i++) {
        fputs("; the same is in ", staging->said);
        folder_say(staging, places->folders[i]);
    }
    if (places->other != NULL) {
        const int is_same =
            text_read(staging, places->other, file, staging->others) == (ssize_t)n_bytes &&
            memcmp(staging->bytes, staging->others, n_bytes) == 0;
        fputs(is_same ? "; the same is in " : "; a different one, which does not count, is in ",
              staging->said);
        folder_say(staging, places->other);
    }
    fputc('\n', staging->said);
}

// ---- Staging --------------------------------------------------------------------------------

// Returns 0, 1 (the submission is at fault) or -1.
static int file_stage(const Staging *staging, const char *file, const Places *places)
{
    if (places->n_folders == 0) {
        return complain(staging, file,
                        "not in the submission, nor in a folder of it: hand in a file with exactly "
                        "this name");
    }
    if (places_agree(staging, file, places) != 0) {
        return 1;
    }
    const int descriptor = file_open(staging, places->folders[0], file);
    if (descriptor < 0) {
        return complain_open_failed(staging, file, errno);
    }
    size_t n_bytes = 0;
    int outcome = file_read(staging, file, descriptor, &n_bytes);
    close(descriptor);
    if (outcome == 0) {
        choice_say(staging, file, n_bytes, places);
        outcome = file_write(staging, file, n_bytes);
    }
    return outcome;
}

static int files_stage(const Manifest *manifest, const Staging *staging)
{
    Places places[MANIFEST_MAX_FILES];
    if (places_find(staging->from, manifest->lab, manifest->files, manifest->n_files, places) !=
        0) {
        return machinery_fault(staging->submission, "", errno);
    }
    // All files are looked at, so that a student hears of every fault at once.
    int outcome = 0;
    int n_there = 0;
    for (int i = 0; outcome >= 0 && i < manifest->n_files; i++) {
        n_there += places[i].n_folders > 0;
        const int file_outcome = file_stage(staging, manifest->files[i], &places[i]);
        outcome = file_outcome != 0 ? file_outcome : outcome;
    }
    places_free(places, manifest->n_files);
    return outcome == 1 && n_there == 0 ? STAGE_NOTHING : outcome;
}

// Open both folders. Links on the way are the instructor's and followed.
static int folders_open(Staging *staging)
{
    const int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
    staging->from = open(staging->submission, flags);
    if (staging->from < 0) {
        return machinery_fault(staging->submission, "", errno);
    }
    staging->to = open(staging->destination, flags);
    if (staging->to < 0) {
        return machinery_fault(staging->destination, "", errno);
    }
    return 0;
}

int stage_submission(const Manifest *manifest, const char *submission, const char *destination,
                     char **message)
{
    Staging staging = {.submission = submission, .destination = destination, .from = -1, .to = -1};
    char *said = NULL;
    size_t n_bytes = 0;
    int outcome = -1;

    *message = NULL;
    staging.bytes = malloc(STAGE_MAX_FILE_BYTES + 1);
    staging.others = malloc(STAGE_MAX_FILE_BYTES + 1);
    staging.said = open_memstream(&said, &n_bytes);
    if (staging.bytes == NULL || staging.others == NULL || staging.said == NULL) {
        machinery_fault(submission, "", ENOMEM);
    } else if (folders_open(&staging) == 0) {
        outcome = files_stage(manifest, &staging);
    }

    if (staging.said != NULL && fclose(staging.said) != 0 && outcome >= 0) {
        outcome = machinery_fault(submission, "", ENOMEM);
    }
    if (staging.from >= 0) {
        close(staging.from);
    }
    if (staging.to >= 0) {
        close(staging.to);
    }
    free(staging.bytes);
    free(staging.others);
    if (outcome >= 0 && n_bytes > 0) {
        said[n_bytes - 1] = '\0';  // no newline after the last line
        *message = said;
    } else {
        free(said);
    }
    return outcome;
}

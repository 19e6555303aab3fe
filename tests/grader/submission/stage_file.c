// Staging one file from one folder (see staging.h).
//
// A submission is a folder that a student filled as they liked, so each file is opened without
// following links or waiting, and looked at through its open descriptor: what was checked is what
// is copied. Read next: places.h (where a file is looked for), sandbox.h.
#include "staging.h"

#include "bytes_write.h"
#include "file_kind.h"
#include "file_names.h"
#include "message.h"
#include "path.h"
#include "place_read.h"
#include "stands_out.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int machinery_fault(const char *folder, const char *file, int fault)
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

static int complain_kind(const Staging *staging, const char *file, const char *found)
{
    fprintf(staging->said, "%s: found %s, expected a source text: save it as plain text (UTF-8)\n",
            file, found);
    return 1;
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
    const ssize_t n_read = place_bytes_read(descriptor, staging->bytes);
    if (n_read < 0) {
        return machinery_fault(staging->submission, file, errno);
    }
    if (n_read > STAGE_MAX_FILE_BYTES) {  // it grew meanwhile
        return complain_too_large(staging, file);
    }
    if (file_is_blank(staging->bytes, (size_t)n_read)) {
        return complain(staging, file,
                        "found an empty file, which counts as not handed in: write your answers "
                        "into it, and hand it in again");
    }
    const FileKind kind = file_kind(staging->bytes, (size_t)n_read);
    if (!kind.is_text) {
        return complain_kind(staging, file, kind.name);
    }
    *n_bytes = (size_t)n_read;
    return 0;
}

// Write staging->bytes as a new file. Returns 0 or -1.
static int file_write(const Staging *staging, const char *file, size_t n_bytes)
{
    int descriptor = openat(staging->to, file, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor < 0) {
        return machinery_fault(staging->destination, file, errno);
    }

    const int failed = fchmod(descriptor, 0644) != 0 ||  // whatever the umask
                       bytes_write(descriptor, staging->bytes, n_bytes) != 0;
    return close_after(descriptor, failed ? -1 : 0) == 0
               ? 0
               : machinery_fault(staging->destination, file, errno);
}

// ---- Which of several -----------------------------------------------------------------------

// The place in quotes, fit for a message: the folder, and the name where it is another one.
static void place_say(const Staging *staging, const char *file, const Place *place)
{
    char path[PATH_MAX], shown[MESSAGE_SHOWN_BYTES];
    const int is_exact = strcmp(place->name, file) == 0;
    if (is_exact && place->folder[0] == '\0') {
        fputs("the top folder", staging->said);
        return;
    }
    path_make(path, "%s%s%s", place->folder, is_exact || place->folder[0] == '\0' ? "" : "/",
              is_exact ? "" : place->name);
    fprintf(staging->said, "\"%s\"", message_show(path, shown, sizeof shown));
}

static int complain_two_places(const Staging *staging, const char *file, const Place *first,
                               const Place *second)
{
    fprintf(staging->said, "%s: found in ", file);
    place_say(staging, file, first);
    fputs(" and, with another content, in ", staging->said);
    place_say(staging, file, second);
    fputs(": hand in only one\n", staging->said);
    return 1;
}

// Is the second an earlier upload of the first? Canvas and browsers do not count together.
static int is_earlier(const Place *first, const Place *second)
{
    return strcmp(first->folder, second->folder) == 0 &&
           (strchr(first->name, '(') == NULL) == (strchr(second->name, '(') == NULL) &&
           name_upload_number(second->name) < name_upload_number(first->name);
}

static int is_same(const Staging *staging, const Place *place, ssize_t n_bytes)
{
    return place_text_read(staging->from, place, staging->others, NULL) == n_bytes &&
           n_bytes >= 0 && memcmp(staging->bytes, staging->others, (size_t)n_bytes) == 0;
}

// Several places are equally good: then all must hold the same, but for earlier uploads. Returns 0
// or 1.
static int places_agree(const Staging *staging, const char *file, const Places *places)
{
    if (places->are_more) {
        fprintf(staging->said, "%s: found in more than %d places: hand in only one\n", file,
                PLACES_MAX_EQUAL);
        return 1;
    }
    const Place *first = &places->equal[0];
    const ssize_t n_bytes =
        places->n_equal > 1 ? place_text_read(staging->from, first, staging->bytes, NULL) : 0;
    for (int i = 1; i < places->n_equal; i++) {
        const Place *second = &places->equal[i];
        if (!is_earlier(first, second) && !is_same(staging, second, n_bytes)) {
            return complain_two_places(staging, file, first, second);
        }
    }
    return 0;
}

// Nothing can be taken. Say what is nearest to it.
static int complain_missing(const Staging *staging, const char *file, const Places *places)
{
    if (places->n_equal == 0) {
        return complain(staging, file,
                        "not in the submission, nor in a folder of it: hand in a file with exactly "
                        "this name");
    }
    const Place *place = &places->equal[0];
    fprintf(staging->said, "%s: not in the submission: found ", file);
    if (places->rank >= RANK_PASSED_OVER) {
        fputs("it in ", staging->said);
        place_say(staging, file, place);
        fputs(", which is passed over: hand it in outside of that folder\n", staging->said);
    } else {
        place_say(staging, file, place);
        fprintf(staging->said, ", expected the name %s: rename it and hand it in again\n", file);
    }
    return 1;
}

// ---- What was taken -------------------------------------------------------------------------

// What was found in a less good place does not count, also where the best could not be used.
static int has_other(const Places *places)
{
    return places->other.name != NULL && places->other_rank < RANK_TOLD;
}

// Say which of several was taken, or under what name, and where the others are, but for the less
// good ones of which only the best is known. staging->bytes holds what was taken.
static void choice_say(const Staging *staging, const char *file, size_t n_bytes,
                       const Places *places)
{
    if (places->n_equal == 1 && !has_other(places) && places->rank < RANK_CHANGED) {
        return;
    }
    fprintf(staging->said, "%s: taken from ", file);
    place_say(staging, file, &places->equal[0]);
    for (int i = 1; i < places->n_equal; i++) {
        fputs(is_same(staging, &places->equal[i], (ssize_t)n_bytes)
                  ? "; the same is in "
                  : "; an earlier upload, which does not count, is in ",
              staging->said);
        place_say(staging, file, &places->equal[i]);
    }
    if (has_other(places)) {
        fputs(is_same(staging, &places->other, (ssize_t)n_bytes)
                  ? "; the same is in "
                  : "; a different one, which does not count, is in ",
              staging->said);
        place_say(staging, file, &places->other);
    }
    fputc('\n', staging->said);
}

// ---- Staging --------------------------------------------------------------------------------

int file_stage(const Staging *staging, const char *file, const Places *places)
{
    // The destination may hold the skeleton under this name, perhaps as a link to the instructor's
    // original: replaced, never written through, and gone where the student's cannot be used.
    if (unlinkat(staging->to, file, 0) != 0 && errno != ENOENT) {
        return machinery_fault(staging->destination, file, errno);
    }
    if (places->n_equal == 0 || places->rank >= RANK_TOLD) {
        return complain_missing(staging, file, places);
    }
    if (places_agree(staging, file, places) != 0) {
        return 1;
    }
    const int descriptor = place_file_open(staging->from, &places->equal[0]);
    if (descriptor < 0) {
        return complain_open_failed(staging, file, errno);
    }
    size_t n_bytes = 0;
    int outcome = file_read(staging, file, descriptor, &n_bytes);
    close(descriptor);
    if (outcome == 0) {
        choice_say(staging, file, n_bytes, places);
        staging->bytes[n_bytes] = '\0';  // there is room for one more
        stands_out_unseen(file, (const char *)staging->bytes, staging->said);
        outcome = file_write(staging, file, n_bytes);
    } else if (outcome > 0 && has_other(places)) {
        fprintf(staging->said, "%s: another one, which does not count, is in ", file);
        place_say(staging, file, &places->other);
        fputc('\n', staging->said);
    }
    return outcome;
}

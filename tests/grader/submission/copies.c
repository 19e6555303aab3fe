// Which copies of a wanted file are kept, and how one becomes a file (see copies.h).
#include "copies.h"

#include "bytes_write.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Negative where the first is the better one, or equally good and comes first.
static int copy_compare(const Copy *copy, const Place *place, int rank)
{
    return copy->rank != rank ? copy->rank - rank : place_compare(&copy->place, place);
}

int copies_count_best(const Copies *copies)
{
    int n = 0;
    while (n < copies->n_kept && copies->kept[n].rank == copies->kept[0].rank) {
        n++;
    }
    return n;
}

static void copy_remove(Copies *copies, int i)
{
    place_free(&copies->kept[i].place);
    free(copies->kept[i].bytes);
    copies->n_kept--;
    memmove(&copies->kept[i], &copies->kept[i + 1],
            (size_t)(copies->n_kept - i) * sizeof *copies->kept);
}

// Remove what does not count any more. Returns its number; -1 where nothing had to go.
static int copies_trim(Copies *copies)
{
    const int n_best = copies_count_best(copies);
    int removed = -1;
    while (copies->n_kept > n_best + 1) {
        removed = copies->n_kept - 1;
        copy_remove(copies, removed);
    }
    if (n_best > COPIES_MAX_EQUAL) {
        removed = n_best - 1;
        copy_remove(copies, removed);
    }
    return removed;
}

int copies_find(Copies *copies, const Place *place, int rank, Copy **copy)
{
    int i = 0, order = 1;
    while (i < copies->n_kept && (order = copy_compare(&copies->kept[i], place, rank)) < 0) {
        i++;
    }
    *copy = &copies->kept[i];
    if (i < copies->n_kept && order == 0) {
        return 0;
    }
    Place own = place_copy(place);
    if (own.name == NULL) {
        return -1;
    }
    memmove(*copy + 1, *copy, (size_t)(copies->n_kept - i) * sizeof **copy);
    **copy = (Copy){.place = own, .rank = rank};
    copies->n_kept++;
    if (copies_trim(copies) == i) {
        *copy = NULL;
    }
    return 0;
}

int copy_fill(Copy *copy, CopyKind kind, const unsigned char *bytes, size_t n_bytes)
{
    unsigned char *own = malloc(n_bytes + 1);  // also of an empty file
    if (own == NULL) {
        return -1;
    }
    memcpy(own, bytes, n_bytes);
    if (copy->n_entries > 0 && (copy->kind != kind || copy->n_bytes != n_bytes ||
                                memcmp(copy->bytes, bytes, n_bytes) != 0)) {
        copy->has_changed = 1;
    }
    free(copy->bytes);
    copy->kind = kind;
    copy->bytes = own;
    copy->n_bytes = n_bytes;
    copy->n_entries++;
    return 0;
}

void copies_free(Copies *copies)
{
    while (copies->n_kept > 0) {
        copy_remove(copies, copies->n_kept - 1);
    }
}

// ---- Writing ------------------------------------------------------------------------------------

// Is it a fault of the disk? Else the copy itself cannot be written, and is passed over.
static int outcome_of(int fault)
{
    return fault == ENOSPC || fault == EDQUOT || fault == EIO || fault == EROFS ? -1 : 0;
}

// Returns as copy_write() does.
static int file_write(const Copy *copy, int parent)
{
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int descriptor = openat(parent, copy->place.name, flags, 0644);
    if (descriptor < 0) {
        return outcome_of(errno);
    }
    const int outcome = bytes_write(descriptor, copy->bytes, copy->n_bytes);
    if (outcome == 0) {
        time_set(descriptor, copy->changed);  // of several archives the newest file counts
    }
    return close_after(descriptor, outcome);
}

int copy_write(const Copy *copy, int folder)
{
    const int parent = place_make(folder, copy->place.folder);
    if (parent < 0) {
        return outcome_of(errno);
    }
    int outcome = 0;
    switch (copy->kind) {
    case COPY_OF_FILE:
        outcome = file_write(copy, parent);
        break;
    case COPY_OF_LINK:
        outcome = symlinkat("nowhere", parent, copy->place.name) == 0 ? 0 : outcome_of(errno);
        break;
    case COPY_OF_OTHER:
        outcome = mkdirat(parent, copy->place.name, 0755) == 0 ? 0 : outcome_of(errno);
        break;
    }
    return close_after(parent, outcome);
}

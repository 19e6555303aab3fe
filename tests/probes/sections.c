// Named blocks of bytes in a file (see sections.h): what grader and probe tell each other.
//
// The grader writes a job; the probe in the sandbox reads it and writes answers. These are a claim
// by code that nobody trusts, so reading believes nothing: every size is held against what is left
// of the file. Read next: ../grader/sandbox/sandbox.h.
#include "sections.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct SectionHeader {
    /*  0 */ char name[SECTION_NAME_BYTES];
    /* 24 */ uint64_t n_bytes;
} SectionHeader;

// A header is itself a multiple of the alignment, so headers and contents both stay aligned.
_Static_assert(sizeof(SectionHeader) == 32, "the header is written as it lies in memory");
_Static_assert(sizeof(SectionHeader) % SECTION_ALIGNMENT == 0, "contents follow it aligned");

static size_t round_up(size_t n_bytes)
{
    return (n_bytes + SECTION_ALIGNMENT - 1) / SECTION_ALIGNMENT * SECTION_ALIGNMENT;
}

int section_write(FILE *file, const char *name, const void *bytes, size_t n_bytes)
{
    static const char zeros[SECTION_ALIGNMENT];
    SectionHeader header = {.n_bytes = n_bytes};
    size_t n_name = strlen(name);
    size_t n_padding = round_up(n_bytes) - n_bytes;

    if (n_name == 0 || n_name >= sizeof header.name) {
        errno = EINVAL;
        return -1;
    }
    memcpy(header.name, name, n_name);
    if (fwrite(&header, sizeof header, 1, file) != 1 ||
        (n_bytes > 0 && fwrite(bytes, 1, n_bytes, file) != n_bytes) ||
        fwrite(zeros, 1, n_padding, file) != n_padding) {
        return -1;
    }
    return fflush(file) == 0 ? 0 : -1;
}

// The header at `start`, if it and all its contents lie within the file; sets *end behind them.
static const SectionHeader *section_at(const Sections *sections, size_t start, size_t *end)
{
    if (start > sections->n_bytes || sections->n_bytes - start < sizeof(SectionHeader)) {
        return NULL;
    }
    const SectionHeader *header = (const SectionHeader *)(sections->bytes + start);
    size_t n_left = sections->n_bytes - start - sizeof *header;
    // First against what is left: only then is rounding up safe from overflow.
    if (header->n_bytes > n_left || round_up((size_t)header->n_bytes) > n_left) {
        return NULL;
    }
    *end = start + sizeof *header + round_up((size_t)header->n_bytes);
    return header;
}

// The file's size when it is a regular one of at most max_bytes; else -1.
static off_t size_if_acceptable(int descriptor, size_t max_bytes)
{
    struct stat status;
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size < 0 ||
        (uintmax_t)status.st_size > max_bytes) {
        return -1;
    }
    return status.st_size;
}

// Read until n_bytes or the end of the file; returns how many came, or -1.
static ssize_t read_fully(int descriptor, unsigned char *bytes, size_t n_bytes)
{
    size_t n_read = 0;
    while (n_read < n_bytes) {
        ssize_t n = read(descriptor, bytes + n_read, n_bytes - n_read);
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

// Take away what is cut off in mid-section at the end. Returns whether anything was.
static int sections_trim(Sections *sections)
{
    size_t end = 0;
    while (section_at(sections, end, &end) != NULL)
        ;
    const int is_cut_off = end != sections->n_bytes;
    sections->n_bytes = end;
    return is_cut_off;
}

int sections_load(const char *path, size_t max_bytes, Sections *sections)
{
    *sections = (Sections){0};
    // A probe may leave a link to a secret or a FIFO that nobody writes in its results' place:
    // neither is followed or waited for.
    int descriptor = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) {
        return -1;
    }
    off_t size = size_if_acceptable(descriptor, max_bytes);
    ssize_t n_read = -1;
    if (size >= 0) {
        // At least one block: an empty file is an empty list, not an allocation of nothing.
        sections->bytes = aligned_alloc(SECTION_ALIGNMENT, round_up((size_t)size + 1));
    }
    if (sections->bytes != NULL) {
        n_read = read_fully(descriptor, sections->bytes, (size_t)size);
    }
    close(descriptor);
    if (n_read < 0) {
        sections_free(sections);
        return -1;
    }

    sections->n_bytes = (size_t)n_read;
    return sections_trim(sections) ? -1 : 0;
}

int sections_read(FILE *file, size_t n_bytes, Sections *sections)
{
    *sections = (Sections){0};
    if (n_bytes < SIZE_MAX - SECTION_ALIGNMENT) {
        sections->bytes = aligned_alloc(SECTION_ALIGNMENT, round_up(n_bytes + 1));
    }
    if (sections->bytes == NULL || fread(sections->bytes, 1, n_bytes, file) != n_bytes) {
        sections_free(sections);
        return -1;
    }
    sections->n_bytes = n_bytes;
    sections_trim(sections);
    return 0;
}

const void *sections_next(const Sections *sections, size_t *place, const char **name,
                          size_t *n_bytes)
{
    const SectionHeader *header = section_at(sections, *place, place);
    if (header == NULL) {
        return NULL;
    }
    *name = header->name;
    *n_bytes = (size_t)header->n_bytes;
    return header + 1;
}

void sections_free(Sections *sections)
{
    free(sections->bytes);
    *sections = (Sections){0};
}

const void *sections_find_any(const Sections *sections, const char *name, size_t *n_bytes)
{
    char wanted[SECTION_NAME_BYTES] = {0};
    size_t n_name = strlen(name);
    if (n_name == 0 || n_name >= sizeof wanted) {
        return NULL;
    }
    memcpy(wanted, name, n_name);

    const SectionHeader *found = NULL;
    const SectionHeader *header;
    for (size_t end = 0; (header = section_at(sections, end, &end)) != NULL;) {
        // Compared with its padding: a name without an end equals none of ours.
        if (memcmp(header->name, wanted, sizeof wanted) != 0) {
            continue;
        }
        if (found != NULL) {
            return NULL;  // given twice: nobody can say which one counts
        }
        found = header;
    }
    if (found == NULL) {
        return NULL;
    }
    *n_bytes = (size_t)found->n_bytes;
    return found + 1;
}

const void *sections_find(const Sections *sections, const char *name, size_t n_bytes)
{
    size_t n_found;
    const void *bytes = sections_find_any(sections, name, &n_found);
    return bytes != NULL && n_found == n_bytes ? bytes : NULL;
}

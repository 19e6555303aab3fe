// Finding and parting versions (see versions.h). The student filled the folder: no link is
// followed, and all that is read of it is bounded. Read next: places.h, loose_files.h.
#include "versions.h"

#include "complain.h"
#include "entry_content.h"
#include "file_names.h"
#include "loose_files.h"
#include "place_read.h"
#include "stage.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <nettle/sha2.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// So many files are compared, and so many others go along with a version.
enum { MOST_COMPARED = 200, MOST_OTHERS = 1000 };

static int fault(const char *folder)
{
    complain("gradebook: %s: %s", folder, strerror(errno));
    return -1;
}

// ---- Finding -----------------------------------------------------------------------------------

typedef struct Search {
    int top;
    const Manifest *manifest;
    unsigned char *bytes;  // [STAGE_MAX_FILE_BYTES + 1]
    int n_compared;
    Versions *versions;
} Search;

// Which of the lab's files is it, by a name that it has or a system gave it? -1: none.
static int file_of(const Manifest *manifest, const Place *place)
{
    int rank;
    const int file = place_of(manifest->lab, manifest->files, manifest->n_files, place, &rank);
    return file >= 0 && rank < RANK_TOLD ? file : -1;
}

// What a file holds; of all that cannot be read as a text the same.
static void digest_make(Search *search, const Place *place,
                        unsigned char digest[VERSION_DIGEST_BYTES])
{
    struct sha256_ctx hash;
    const ssize_t n_bytes = place_text_read(search->top, place, search->bytes, NULL);
    sha256_init(&hash);
    sha256_update(&hash, n_bytes > 0 ? (size_t)n_bytes : 0, search->bytes);
    sha256_digest(&hash, VERSION_DIGEST_BYTES, digest);
}

static int versions_compare(const Place *a, const Place *b)
{
    const int order = name_upload_number(a->name) - name_upload_number(b->name);
    const int by_folder = order != 0 ? order : strcmp(a->folder, b->folder);
    return by_folder != 0 ? by_folder : strcmp(a->name, b->name);
}

static void version_remove(FileVersions *of, int i)
{
    place_free(&of->places[i]);
    of->n--;
    memmove(&of->places[i], &of->places[i + 1], (size_t)(of->n - i) * sizeof *of->places);
    memmove(of->digests[i], of->digests[i + 1], (size_t)(of->n - i) * sizeof *of->digests);
}

// Of one content the first place stays; of too many versions the first ones. Returns 0, or -1 when
// memory runs out.
static int version_add(Search *search, FileVersions *of, const Place *place)
{
    unsigned char digest[VERSION_DIGEST_BYTES];
    digest_make(search, place, digest);
    int i = 0;
    while (i < of->n && memcmp(of->digests[i], digest, sizeof digest) != 0) {
        i++;
    }
    if (i < of->n) {
        if (versions_compare(place, &of->places[i]) >= 0) {
            return 0;
        }
        version_remove(of, i);
    }
    i = of->n;
    while (i > 0 && versions_compare(place, &of->places[i - 1]) < 0) {
        i--;
    }
    search->versions->has_more |= of->n == VERSIONS_MAX;
    if (i == VERSIONS_MAX) {
        return 0;
    }
    if (of->n == VERSIONS_MAX) {
        version_remove(of, of->n - 1);
    }
    Place own = place_copy(place);
    if (own.name == NULL) {
        return -1;
    }
    memmove(&of->places[i + 1], &of->places[i], (size_t)(of->n - i) * sizeof *of->places);
    memmove(of->digests[i + 1], of->digests[i], (size_t)(of->n - i) * sizeof *of->digests);
    of->places[i] = own;
    memcpy(of->digests[i], digest, sizeof digest);
    of->n++;
    return 0;
}

// Look for versions of a file in one folder of the submission. What cannot be opened is the
// student's doing: the grader says so.
static int folder_look_into(Search *search, int file, const char *folder)
{
    const int descriptor = place_open(search->top, folder);
    DIR *entries = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    int result = 0;
    struct dirent *entry;
    if (descriptor >= 0 && entries == NULL) {
        close(descriptor);
    }
    while (entries != NULL && result == 0 && (entry = readdir(entries)) != NULL) {
        const Place place = {(char *)folder, entry->d_name};
        struct stat status;
        if (file_of(search->manifest, &place) != file ||
            fstatat(dirfd(entries), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0 ||
            !S_ISREG(status.st_mode)) {
            continue;
        }
        if (search->n_compared++ == MOST_COMPARED) {
            search->versions->has_more = 1;
            break;
        }
        result = version_add(search, &search->versions->of[file], &place);
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return result;
}

static int file_look_for(Search *search, int file, const Places *places)
{
    int result = 0;
    for (int k = 0; result == 0 && places->rank < RANK_TOLD && k < places->n_equal; k++) {
        const char *folder = places->equal[k].folder;
        if (k == 0 || strcmp(folder, places->equal[k - 1].folder) != 0) {
            result = folder_look_into(search, file, folder);
        }
    }
    const int n = search->versions->of[file].n;
    search->versions->n = n > search->versions->n ? n : search->versions->n;
    return result;
}

int versions_find(const char *folder, const Manifest *manifest, Versions *versions)
{
    Places places[MANIFEST_MAX_FILES] = {0};
    *versions = (Versions){0};
    Search search = {.top = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC),
                     .manifest = manifest,
                     .bytes = malloc(STAGE_MAX_FILE_BYTES + 1),
                     .versions = versions};
    // A folder that cannot be read is told by the grader.
    int result = search.bytes != NULL ? 0 : -1;
    const int is_found =
        result == 0 && search.top >= 0 &&
        places_find(search.top, manifest->lab, manifest->files, manifest->n_files, places) == 0;
    for (int i = 0; is_found && result == 0 && i < manifest->n_files; i++) {
        result = file_look_for(&search, i, &places[i]);
    }
    if (is_found) {
        places_free(places, manifest->n_files);
    }
    if (search.top >= 0) {
        close(search.top);
    }
    free(search.bytes);
    return result == 0 ? 0 : fault(folder);
}

void versions_free(Versions *versions)
{
    for (int i = 0; i < MANIFEST_MAX_FILES; i++) {
        while (versions->of[i].n > 0) {
            version_remove(&versions->of[i], versions->of[i].n - 1);
        }
    }
}

const Place *version_place(const Versions *versions, int i)
{
    int file = 0;
    while (versions->of[file].n < versions->n) {
        file++;
    }
    return &versions->of[file].places[i];
}

// ---- Collecting --------------------------------------------------------------------------------

// Is it the machine that failed, and not something that the student has closed?
static int is_machines_fault(int number)
{
    return number == ENOSPC || number == EDQUOT || number == EIO || number == EROFS ||
           number == ENOMEM || number == EMFILE || number == ENFILE;
}

// What is in the folder's top besides versions: archives, and names that the grader only tells. Of
// much of it, and of what cannot be read, nothing: no answer is in it.
static int others_put(int top, const Manifest *manifest, int to)
{
    char none[] = "";
    off_t n_left = (off_t)CONTENT_MOST_MB << 20;
    struct stat status;
    const int descriptor = openat(top, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *entries = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    int result = entries != NULL ? 0 : -1;
    struct dirent *entry;
    for (int n = 0; result == 0 && n < MOST_OTHERS && (entry = readdir(entries)) != NULL; n++) {
        if (file_of(manifest, &(Place){none, entry->d_name}) >= 0 ||
            fstatat(top, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0 ||
            status.st_size > n_left) {
            continue;
        }
        n_left -= status.st_size;
        if (loose_file_put(top, entry->d_name, to, entry->d_name) != 0) {
            result = is_machines_fault(errno) ? -1 : 0;
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return result;
}

int version_collect(const char *folder, const Manifest *manifest, const Versions *versions, int i,
                    const char *to)
{
    if (mkdir(to, 0700) != 0) {
        return fault(to);
    }
    const int top = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int target = open(to, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int result = top >= 0 && target >= 0 ? others_put(top, manifest, target) : -1;
    for (int file = 0; result == 0 && file < manifest->n_files; file++) {
        const FileVersions *of = &versions->of[file];
        const int version = i < of->n ? i : of->n - 1;
        const int parent = version >= 0 ? place_open(top, of->places[version].folder) : -1;
        if (parent >= 0) {
            const int is_put = loose_file_put(parent, of->places[version].name, target,
                                              manifest->files[file]) == 0;
            result = is_put || !is_machines_fault(errno) ? 0 : -1;
            close(parent);
        }
    }
    const int number = errno;
    if (top >= 0) {
        close(top);
    }
    if (target >= 0) {
        close(target);
    }
    errno = number;
    return result == 0 ? 0 : fault(to);
}

// The search for the lab's files in a submission (see places.h).
//
// The folder was filled by somebody who may mean harm, so every name and number in it is bounded:
// depth, folders, entries, and what is kept of them.
#include "places.h"

#include "bytes_write.h"
#include "file_names.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Folder {
    char *path;  // relative to the top
    int depth;   // how many folders its path has
    int is_passed_over;
} Folder;

typedef struct Search {
    int top;
    const char *lab;
    const char *const *files;
    int n_files;
    Places *places;
    // All folders found, which is also the queue of those to look into: level by level, and in a
    // second round those that are passed over.
    Folder folders[PLACES_MAX_FOLDERS];
    int n_folders;
    int n_entries;
} Search;

// What holds copies, programs or an editor's notes, but nothing written by hand.
static int is_passed_over(const char *name)
{
    static const char *const names[] = {"__MACOSX",   "build", "_build", "node_modules",
                                        "CMakeFiles", "Debug", "Release"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcmp(name, names[i]) == 0) {
            return 1;
        }
    }
    return name[0] == '.';  // .git, .vscode; "." and ".." as well
}

// Is the folder "labs/NN-name", or does it end with that?
static int is_labs_folder(const char *path, const char *lab)
{
    static const char labs[] = "labs/";
    const size_t n_lab = strlen(lab);
    const size_t n_end = strlen(labs) + n_lab;
    const size_t n_path = strlen(path);
    if (n_path < n_end || (n_path > n_end && path[n_path - n_end - 1] != '/')) {
        return 0;
    }
    const char *end = path + n_path - n_end;
    return strncmp(end, labs, strlen(labs)) == 0 && strcmp(end + strlen(labs), lab) == 0;
}

// How good a folder is for a file of a lab: 0 is the best. -1: too deep.
static int folder_rank(const char *lab, const char *folder)
{
    int depth = 0, passed_over = 0;
    for (const char *part = folder; *part != '\0'; depth++) {
        char name[NAME_MAX + 1];
        const size_t length = strcspn(part, "/");
        if (depth == PLACES_MAX_DEPTH || length > NAME_MAX) {
            return -1;
        }
        memcpy(name, part, length);
        name[length] = '\0';
        if (is_passed_over(name)) {
            passed_over = RANK_PASSED_OVER;
        }
        part += length + (part[length] == '/');
    }
    // A labs folder comes just behind the folder it lies in.
    return passed_over + (is_labs_folder(folder, lab) ? 2 * (depth - 2) + 1 : 2 * depth);
}

int place_of(const char *lab, const char *const *files, int n_files, const Place *place, int *rank)
{
    static const int name_ranks[] = {
        [NAME_EXACT] = 0, [NAME_CHANGED] = RANK_CHANGED, [NAME_NEAR] = RANK_NEAR};
    NameMatch best = NAME_OTHER;
    int file = -1;
    for (int i = 0; i < n_files; i++) {
        const NameMatch match = name_match(place->name, files[i]);
        if (match < best) {
            best = match;
            file = i;
        }
    }
    *rank = file >= 0 ? folder_rank(lab, place->folder) : -1;
    if (*rank < 0 || (*rank >= RANK_PASSED_OVER && best == NAME_NEAR)) {
        return -1;
    }
    *rank += name_ranks[best];
    return file;
}

int place_compare(const Place *a, const Place *b)
{
    int order = strcmp(a->folder, b->folder);
    order = order != 0 ? order : name_upload_number(b->name) - name_upload_number(a->name);
    return order != 0 ? order : strcmp(a->name, b->name);
}

Place place_copy(const Place *place)
{
    Place copy = {strdup(place->folder), strdup(place->name)};
    if (copy.folder == NULL || copy.name == NULL) {
        place_free(&copy);
    }
    return copy;
}

void place_free(Place *place)
{
    free(place->folder);
    free(place->name);
    *place = (Place){0};
}

// Note a place that is less good, where it is the best of these yet. Takes `place` over.
static void other_note(Places *places, Place place, int rank)
{
    if (places->other.name == NULL || rank < places->other_rank ||
        (rank == places->other_rank && place_compare(&place, &places->other) < 0)) {
        const Place worse = places->other;
        places->other = place;
        places->other_rank = rank;
        place = worse;
    }
    place_free(&place);
}

// What was the best until now is less good than what was found.
static void places_demote(Places *places)
{
    for (int i = 0; i < places->n_equal; i++) {
        other_note(places, places->equal[i], places->rank);
    }
    places->n_equal = 0;
    places->are_more = 0;
}

// Add one to those that are equally good. Takes `place` over. What a folder lists first is chance:
// of too many the first ones stay.
static void equal_add(Places *places, Place place)
{
    int i = places->n_equal++;
    for (; i > 0 && place_compare(&place, &places->equal[i - 1]) < 0; i--) {
        places->equal[i] = places->equal[i - 1];
    }
    places->equal[i] = place;
    if (places->n_equal > PLACES_MAX_EQUAL) {
        places->are_more = 1;
        place_free(&places->equal[--places->n_equal]);
    }
}

// Note a place of the file. Returns 0, or -1 when memory runs out.
static int place_add(Places *places, const Place *place, int rank)
{
    Place own = place_copy(place);
    if (own.name == NULL) {
        return -1;
    }
    if (places->n_equal > 0 && rank > places->rank) {
        other_note(places, own, rank);
        return 0;
    }
    if (rank < places->rank) {
        places_demote(places);
    }
    places->rank = rank;
    equal_add(places, own);
    return 0;
}

static int folder_add(Search *search, const Folder *parent, const char *name)
{
    if (search->n_folders == PLACES_MAX_FOLDERS) {
        return 0;
    }
    const size_t n_parent = strlen(parent->path);
    char *path = malloc(n_parent + 1 + strlen(name) + 1);
    if (path == NULL) {
        return -1;
    }
    stpcpy(stpcpy(stpcpy(path, parent->path), n_parent > 0 ? "/" : ""), name);
    search->folders[search->n_folders++] =
        (Folder){path, parent->depth + 1, parent->is_passed_over || is_passed_over(name)};
    return 0;
}

// Some file systems do not tell the kind with the name.
static int is_folder(int parent, const struct dirent *entry)
{
    struct stat status;
    if (entry->d_type != DT_UNKNOWN) {
        return entry->d_type == DT_DIR;
    }
    return fstatat(parent, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) == 0 &&
           S_ISDIR(status.st_mode);
}

static int entry_look_at(Search *search, const Folder *folder, int parent,
                         const struct dirent *entry)
{
    const Place place = {folder->path, (char *)entry->d_name};
    int rank;
    const int i = place_of(search->lab, search->files, search->n_files, &place, &rank);
    const int is_exact = i >= 0 && strcmp(entry->d_name, search->files[i]) == 0;
    if (is_exact || (i >= 0 && !is_folder(parent, entry))) {
        return place_add(&search->places[i], &place, rank);
    }
    if (folder->depth == PLACES_MAX_DEPTH || strcmp(entry->d_name, ".") == 0 ||
        strcmp(entry->d_name, "..") == 0 || !is_folder(parent, entry)) {
        return 0;
    }
    return folder_add(search, folder, entry->d_name);
}

static int folder_look_into(Search *search, const Folder *folder)
{
    const int descriptor = place_open(search->top, folder->path);
    if (descriptor < 0) {
        return folder->depth > 0 && !place_fault_is_ours(errno) ? 0 : -1;
    }
    DIR *entries = fdopendir(descriptor);
    if (entries == NULL) {
        close(descriptor);
        return -1;
    }
    int outcome = 0;
    struct dirent *entry;
    errno = 0;
    while (outcome == 0 && search->n_entries < PLACES_MAX_ENTRIES &&
           (entry = readdir(entries)) != NULL) {
        search->n_entries++;
        outcome = entry_look_at(search, folder, descriptor, entry);
        if (outcome == 0) {
            errno = 0;
        }
    }
    const int fault = errno;
    closedir(entries);
    errno = fault;
    return outcome == 0 && (fault == 0 || !place_fault_is_ours(fault)) ? 0 : -1;
}

// Look into the folders that are, or are not, passed over. Returns 0, or -1 with errno set.
static int folders_look_into(Search *search, int are_passed_over)
{
    for (int i = 0; i < search->n_folders; i++) {
        const Folder folder = search->folders[i];
        if (folder.is_passed_over == are_passed_over && folder_look_into(search, &folder) != 0) {
            return -1;
        }
    }
    return 0;
}

static int is_one_missing(const Search *search)
{
    for (int i = 0; i < search->n_files; i++) {
        if (search->places[i].n_equal == 0) {
            return 1;
        }
    }
    return 0;
}

int places_find(int top, const char *lab, const char *const *files, int n_files, Places *places)
{
    memset(places, 0, (size_t)n_files * sizeof *places);
    Search *search = calloc(1, sizeof *search);
    if (search == NULL) {
        return -1;
    }
    search->top = top;
    search->lab = lab;
    search->files = files;
    search->n_files = n_files;
    search->places = places;
    int outcome = folder_add(search, &(Folder){.path = "", .depth = -1}, "");
    if (outcome == 0) {
        outcome = folders_look_into(search, 0);
    }
    if (outcome == 0 && is_one_missing(search)) {
        outcome = folders_look_into(search, 1);
    }
    const int fault = errno;
    for (int i = 0; i < search->n_folders; i++) {
        free(search->folders[i].path);
    }
    free(search);
    if (outcome != 0) {
        places_free(places, n_files);
    }
    errno = fault;
    return outcome;
}

void places_free(Places *places, int n_files)
{
    for (int i = 0; i < n_files; i++) {
        for (int k = 0; k < places[i].n_equal; k++) {
            place_free(&places[i].equal[k]);
        }
        place_free(&places[i].other);
        places[i] = (Places){0};
    }
}

int place_fault_is_ours(int fault)
{
    return fault == EMFILE || fault == ENFILE || fault == ENOMEM || fault == EIO || fault == ESTALE;
}

// Open a folder step by step; where they are not there, also make them.
static int steps_open(int top, const char *folder, int makes)
{
    const int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    int descriptor = openat(top, ".", flags);
    while (descriptor >= 0 && *folder != '\0') {
        char name[NAME_MAX + 1];
        const size_t length = strcspn(folder, "/");
        if (length >= sizeof name) {
            errno = ENAMETOOLONG;
            return close_after(descriptor, -1);
        }
        memcpy(name, folder, length);
        name[length] = '\0';
        folder += length + (folder[length] == '/');
        const int is_there = !makes || mkdirat(descriptor, name, 0755) == 0 || errno == EEXIST;
        descriptor = close_after(descriptor, is_there ? openat(descriptor, name, flags) : -1);
    }
    return descriptor;
}

int place_open(int top, const char *folder)
{
    return steps_open(top, folder, 0);
}

int place_make(int top, const char *folder)
{
    return steps_open(top, folder, 1);
}

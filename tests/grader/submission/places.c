// The search for the lab's files in a submission (see places.h).
//
// The folder was filled by somebody who may mean harm, so every name and number in it is bounded:
// depth, folders, entries, and what is kept of them.
#include "places.h"

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
} Folder;

typedef struct Search {
    int top;
    const char *lab;
    char *const *files;
    int n_files;
    Places *places;
    // All folders found, which is also the queue of those to look into: level by level.
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

int place_rank(const char *lab, const char *folder)
{
    int depth = 0;
    for (const char *part = folder; *part != '\0'; depth++) {
        char name[NAME_MAX + 1];
        const size_t length = strcspn(part, "/");
        if (depth == PLACES_MAX_DEPTH || length > NAME_MAX) {
            return -1;
        }
        memcpy(name, part, length);
        name[length] = '\0';
        if (is_passed_over(name)) {
            return -1;
        }
        part += length + (part[length] == '/');
    }
    // A labs folder comes just behind the folder it lies in.
    return is_labs_folder(folder, lab) ? 2 * (depth - 2) + 1 : 2 * depth;
}

// Note a place that is less good, where it is the best of these yet. Takes `folder` over.
static void other_note(Places *places, char *folder, int rank)
{
    if (places->other == NULL || rank < places->other_rank ||
        (rank == places->other_rank && strcmp(folder, places->other) < 0)) {
        char *worse = places->other;
        places->other = folder;
        places->other_rank = rank;
        folder = worse;
    }
    free(folder);
}

// What was the best until now is less good than what was found.
static void places_demote(Places *places)
{
    for (int i = 0; i < places->n_folders; i++) {
        other_note(places, places->folders[i], places->rank);
    }
    places->n_folders = 0;
    places->are_more = 0;
}

// Add one to those that are equally good. Takes `folder` over. What a folder lists first is chance:
// of too many the first ones in the order of their bytes stay.
static void equal_add(Places *places, char *folder)
{
    int i = places->n_folders;
    if (i == PLACES_MAX_EQUAL) {
        places->are_more = 1;
        char **last = &places->folders[--i];
        if (strcmp(folder, *last) > 0) {
            free(folder);
            return;
        }
        free(*last);
        places->n_folders--;
    }
    for (; i > 0 && strcmp(folder, places->folders[i - 1]) < 0; i--) {
        places->folders[i] = places->folders[i - 1];
    }
    places->folders[i] = folder;
    places->n_folders++;
}

// Note that the folder has a file of that name. Returns 0, or -1 when memory runs out.
static int place_add(Places *places, const char *folder, int rank)
{
    char *copy = strdup(folder);
    if (copy == NULL) {
        return -1;
    }
    if (places->n_folders > 0 && rank > places->rank) {
        other_note(places, copy, rank);
        return 0;
    }
    if (rank < places->rank) {
        places_demote(places);
    }
    places->rank = rank;
    equal_add(places, copy);
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
    search->folders[search->n_folders++] = (Folder){path, parent->depth + 1};
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
    for (int i = 0; i < search->n_files; i++) {
        if (strcmp(entry->d_name, search->files[i]) == 0) {
            return place_add(&search->places[i], folder->path,
                             place_rank(search->lab, folder->path));
        }
    }
    if (folder->depth == PLACES_MAX_DEPTH || is_passed_over(entry->d_name) ||
        !is_folder(parent, entry)) {
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

int places_find(int top, const char *lab, char *const *files, int n_files, Places *places)
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
    int outcome = folder_add(search, &(Folder){"", -1}, "");
    for (int i = 0; outcome == 0 && i < search->n_folders; i++) {
        outcome = folder_look_into(search, &search->folders[i]);
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
        for (int k = 0; k < places[i].n_folders; k++) {
            free(places[i].folders[k]);
        }
        free(places[i].other);
        places[i] = (Places){0};
    }
}

int place_fault_is_ours(int fault)
{
    return fault == EMFILE || fault == ENFILE || fault == ENOMEM || fault == EIO || fault == ESTALE;
}

int place_open(int top, const char *folder)
{
    const int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    int descriptor = openat(top, ".", flags);
    char name[NAME_MAX + 1];
    while (descriptor >= 0 && *folder != '\0') {
        const size_t length = strcspn(folder, "/");
        if (length >= sizeof name) {
            close(descriptor);
            errno = ENAMETOOLONG;
            return -1;
        }
        memcpy(name, folder, length);
        name[length] = '\0';
        folder += length + (folder[length] == '/');
        const int inner = openat(descriptor, name, flags);
        const int fault = errno;
        close(descriptor);
        errno = fault;
        descriptor = inner;
    }
    return descriptor;
}

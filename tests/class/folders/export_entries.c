// The entries of a folder of submissions (see export_read.h).
//
// Read next: export_read.h, which looks whether it is the right folder.
#include "export_read.h"

#include "contents.h"
#include "ilias.h"
#include "sheet.h"
#include "studip.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// To see whether ILIAS has named the files of a folder, only the first are read: one student could
// else make the whole class wait.
enum { MOST_LOOKED_AT_FOR_ILIAS = 20 };

void *array_grown(void *array, int n, size_t size)
{
    return (n & (n - 1)) != 0 ? array : realloc(array, (n > 0 ? 2 * (size_t)n : 1) * size);
}

int name_is_one_of(const char *file, const char *const *names)
{
    while (*names != NULL && strcmp(file, *names) != 0) {
        names++;
    }
    return *names != NULL;
}

// What unpackers and version control leave in a folder, and no student.
static int is_nobody(const char *file)
{
    static const char *const names[] = {".", "..", "__MACOSX", ".git", ".github", NULL};
    return name_is_one_of(file, names);
}

// Files that course systems and desktops add to an export, and that say nothing.
static int is_systems(const char *file)
{
    static const char *const names[] = {"index.html",  ".DS_Store",  "Thumbs.db",
                                        "desktop.ini", "Report.txt", NULL};
    return name_is_one_of(file, names) || strncmp(file, "._", 2) == 0;
}

int export_is_list(const char *file)
{
    static const char *const names[] = {GRADESCOPE_NAMES_FILE, STUDIP_NAMES_FILE, NULL};
    return name_is_one_of(file, names);
}

int export_is_extra(const char *file)
{
    return is_nobody(file) || is_systems(file) || export_is_list(file);
}

// What a folder holds, if it may be one of ILIAS': files with times before their names, others, and
// folders of a team's members.
typedef struct IliasFolder {
    int n_timed, n_others, n_members;
} IliasFolder;

static IliasFolder ilias_folder_look(int parent, const char *file)
{
    const int descriptor = openat(parent, file, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *entries = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    IliasFolder found = {0};
    if (descriptor >= 0 && entries == NULL) {
        close(descriptor);
    }
    struct dirent *entry;
    struct stat status;
    for (int n = 0;
         entries != NULL && n < MOST_LOOKED_AT_FOR_ILIAS && (entry = readdir(entries)) != NULL;) {
        const char *name = entry->d_name;
        if (export_is_extra(name) ||
            fstatat(dirfd(entries), name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
            continue;
        }
        const int is_folder = S_ISDIR(status.st_mode);
        n++;
        if (is_folder && ilias_name_is_whole(name)) {
            found.n_members++;
        } else if (!is_folder && ilias_time_length(name) > 0) {
            found.n_timed++;
        } else {
            found.n_others++;
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return found;
}

// "Team 12", in whichever language.
static int is_team_name(const char *file)
{
    const char *blank = strrchr(file, ' ');
    return blank != NULL && blank > file && blank[1] != '\0' &&
           strspn(blank + 1, "0123456789") == strlen(blank + 1);
}

static void ilias_look(int parent, Found *found)
{
    const IliasFolder folder = ilias_folder_look(parent, found->file);
    found->has_times = folder.n_timed > 0 && folder.n_others + folder.n_members == 0;
    found->has_untimed = folder.n_others > 0;
    found->is_team =
        folder.n_members > 0 && folder.n_timed + folder.n_others == 0 && is_team_name(found->file);
}

// Which systems may have made a name, and as whose it can be read: a bit for each.
static void systems_find(Found *found)
{
    for (ExportSystem system = SYSTEM_NONE + 1; system < N_SYSTEMS; system++) {
        const EntryName name = system == SYSTEM_MOODLE
                                   ? found->name
                                   : entry_name_read_export(found->file, found->is_folder, system);
        const int is_read = name.system == system && (system != SYSTEM_ILIAS || found->has_times ||
                                                      ilias_name_is_whole(found->file));
        const int is_team = system == SYSTEM_ILIAS && found->is_team;
        const int is_any_kind = system == SYSTEM_MOODLE || !found->is_folder;
        found->readable |= (unsigned)(is_read || is_team) << system;
        found->systems |= (unsigned)(is_read || is_team ||
                                     (is_any_kind && system_name_is_possible(found->file, system)))
                          << system;
    }
}

// Read what a file or folder is, under a name as if no system had made it: it is decided later
// whether one did.
static int found_read(int parent, const char *file, int lab_number, Found *found)
{
    struct stat status;
    if (fstatat(parent, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    const int is_file = S_ISREG(status.st_mode);
    *found = (Found){.file = strdup(file),
                     .name = entry_name_read(file, lab_number),
                     .is_folder = S_ISDIR(status.st_mode)};
    if (found->file == NULL) {
        return -1;
    }
    found->is_link = !found->is_folder && !is_file;
    if (found->is_folder) {
        ilias_look(parent, found);
    }
    systems_find(found);
    found->is_loose = is_file && archive_stem_length(file) == 0;
    return 0;
}

int export_entries_read(Export *export, int lab_number, int n_most)
{
    DIR *entries = opendir(export->path);
    if (entries == NULL) {
        return path_fault(export->path, strerror(errno));
    }
    int failed = 0;
    struct dirent *entry;
    errno = 0;
    while (!failed && n_most-- > 0 && (entry = readdir(entries)) != NULL) {
        Found *found = array_grown(export->found, export->n_found, sizeof *found);
        if (found == NULL) {
            failed = 1;
            break;
        }
        export->found = found;
        found += export->n_found;
        if (!is_nobody(entry->d_name)) {
            failed = found_read(dirfd(entries), entry->d_name, lab_number, found) != 0;
            const int is_kept = !failed && !(found->is_loose && is_systems(found->file));
            export->n_found += is_kept;
            if (!failed && !is_kept) {
                free(found->file);
            }
        }
        errno = failed ? errno : 0;
    }
    const int result = failed || errno != 0 ? path_fault(export->path, strerror(errno)) : 0;
    closedir(entries);
    return result;
}

void export_entries_free(Export *export)
{
    for (int i = 0; i < export->n_found; i++) {
        free(export->found[i].file);
    }
    for (int i = 0; i < export->n_passed_over; i++) {
        free(export->passed_over[i]);
    }
    free(export->found);
    free(export->passed_over);
    export->found = NULL, export->passed_over = NULL;
    export->n_found = export->n_passed_over = 0;
}

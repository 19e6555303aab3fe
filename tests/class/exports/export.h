// A folder as a course system exports it: what in it is one attempt of one student.
//
// Only names are read; what is inside an entry is the grader's, in its sandbox. Read next:
// export_read.h, which fills it.
#ifndef CLASS_EXPORT_H
#define CLASS_EXPORT_H

#include "entry_name.h"
#include "gradescope.h"

#include <limits.h>

// A folder, an archive or a single file in the export.
typedef struct Found {
    char *file;  // its name, as it is
    EntryName name;
    unsigned systems;      // a bit for each ExportSystem that may have made the name
    unsigned readable;     // and for each as whose it can be read
    char listed_time[24];  // of this file, by Stud.IP's list; name.time is that of the attempt
    int has_times;    // a folder of files that ILIAS has named by their times, and of no others
    int has_untimed;  // a folder of other files
    int is_team;      // a folder "Team 12" of nothing but folders of ILIAS', its members'
    size_t n_title, n_login;  // Blackboard's: how many bytes the title and the login behind it have
    int is_folder;
    int is_link;   // neither a folder nor a file: cannot be graded
    int is_loose;  // a single file, or what a system has named as one of the files of an upload, be
                   // it an archive, or as a folder of such files: to be collected
    int is_listed;                      // Stud.IP's list says whose it is (studip.h)
    const GradescopeEntry *submitters;  // or NULL
} Found;

typedef struct Export {
    char path[PATH_MAX];  // where the entries are: the folder that was given, or one below it
    int is_unpacked;      // an archive was given: the path is no advice
    Found *found;         // by student, attempt and file
    int n_found;
    char **passed_over;  // files of which no name says whose they are, fit to be shown
    int n_passed_over;
    ExportSystem system;  // the one that made most of the names, or SYSTEM_NONE
    int has_ilias_times;  // ILIAS has written times before the files' names
    GradescopeNames names;
} Export;

// Has a course system written whose it is, so that nobody else could (course_system.h)?
int export_is_exact(const Export *export, const Found *found);

// Are two entries one student's, by names that a course system made? Any other name is chosen by
// whoever hands in, and "ada-2" may be anybody's.
int export_is_same_student(const Export *export, const Found *a, const Found *b);

// Of clones of an assignment, "rays-ada", "rays-bob", "rays-cy": take the common prefix off.
void git_clones_name(Export *export);

// The end of the attempt that begins with entry i: one entry, or all of a student's single files.
int export_attempt_end(const Export *export, int i);

#endif

// The roster: who handed in, and under which name the driver's files of each are.
//
// Made once at the start of a class run, from the names in the folder alone, and read again for the
// gradebook. Read next: roster.c.
#ifndef CLASS_ROSTER_H
#define CLASS_ROSTER_H

#include "gradescope.h"
#include "manifest.h"

typedef struct Entrant {
    char *name;    // the student or the team, fit to be shown
    char *label;   // the name for pages, with what tells it from another one's of the same name
    char *number;  // the system's number of the student, team or submission, or ""
    char *entry;   // the entry's name, fit to be shown
    char *slug;    // the name of its files; unique
    char *time;    // when it was handed in, as it is written there (moment.h), or ""; from nowhere:
                   // what is there instead, in words, or ""
    ExportSystem time_from;  // where that is from, by the table of course_system.h
    int is_late;             // the system marked it so
    int attempt;             // 1, 2 ... of entries that a system's export gives to one student
    int version;   // 1, 2 ... of several versions of a file (versions.h), rows in that order; or 0
    int is_exact;  // name and number are the host's own: others like them are somebody else's
    int is_link;   // neither a folder nor a file: cannot be graded
    Member *members;  // who handed it in, where the export says more than a name; else none
    int n_members;
    int is_team;  // of ILIAS: the members are not all of the team
} Entrant;

typedef struct Roster {
    struct json_t *json;  // of roster_load(): owns all texts; else they are the roster's own
    Entrant *entrants;    // by name, then by number, then by attempt
    int n_entrants;
    char **passed_over;  // names of files of which nobody can say whose they are, fit to be shown
    int n_passed_over;
} Roster;

// Read the folder of submissions (export.h): each folder and each archive in it is an entry, and so
// are all single files of one attempt, where a course system has named them.
//   lab_number   GitHub Classroom's names begin with it
//   manifest     the lab's, without files where it is not known: then no versions are parted
//   only_latest  of the entries that a course system's export gives to one student keep the last:
//                by its time, else files after text typed into a form, and these by name. A name
//                that only ends like an attempt's, "ada-2", may be anybody's, and stays.
//   folder       receives, made anew, a folder "submissions" with a symbolic link SLUG -> entry for
//                each, and a folder "collected" with single files
// Returns 0, or -1 after one message on stderr. Release with roster_free().
int roster_read(const char *submissions, int lab_number, const Manifest *manifest, int only_latest,
                const char *folder, Roster *roster);

// Write and read it as JSON. Return 0, or -1 after one message on stderr.
int roster_save(const Roster *roster, const char *path);
int roster_load(const char *path, Roster *roster);

void roster_free(Roster *roster);

// Give each entrant without a time whose folder is a repository the time of its commit. A student
// may have written the repository, with programs in its settings that Git would run: so Git looks
// at it in bubblewrap's sandbox only. Where there is no such sandbox, or no Git, the times stay
// unknown, after one line on stderr.
//   folder   the class's, with the links submissions/SLUG
// Returns 0, or -1 when memory runs out.
int commits_take(const char *folder, Roster *roster);

#endif

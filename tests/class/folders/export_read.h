// Reading a folder of submissions: all its entries, and which system named them.
//
// Read next: roster.h, which makes rows of it.
#ifndef CLASS_EXPORT_READ_H
#define CLASS_EXPORT_READ_H

#include "export.h"

// Read a folder of submissions. Where it holds nothing but a folder that is such an export, that is
// read instead, with one line on stderr, as for other files that are passed over. Of several
// exercises side by side the one with the lab's number is read; without one, that is an error.
//   is_unpacked  the folder was unpacked from the archive that was given
//   lab_number   GitHub Classroom's names begin with it, an exercise's folder may have it
// Returns 0, or -1 after one message on stderr. Release with export_free().
int export_read(const char *submissions, int is_unpacked, int lab_number, Export *export);
void export_free(Export *export);

// ---- export_entries.c: the entries, by what their names say -----------------------------------

// Read the entries of the folder export->path, at most n_most. What unpackers, desktops and course
// systems add is left out. Returns 0, or -1 after one message.
int export_entries_read(Export *export, int lab_number, int n_most);
void export_entries_free(Export *export);

// Is it what an unpacker, a desktop or a course system puts beside the entries, by its name?
int export_is_extra(const char *file);

// Has a file the name of a system's list, which says whose the entries are? Among the entries it
// may be any student's.
int export_is_list(const char *file);

// Room for one more in an array that doubles. Returns the array, or NULL when memory runs out.
void *array_grown(void *array, int n, size_t size);

// Is it one of these names? NULL ends them.
int name_is_one_of(const char *file, const char *const *names);

// ---- export_level.c: is it the folder of an export, or one above or below it? ----------------

// The folder to go on with, if the entries that were read are not the students': the only folder,
// or the lab's of several exercises. Returns 1 with its path in `inner`, 0 to stay, or -1 after one
// message if it is not clear which exercise is the lab's.
int export_level_find(const Export *export, int lab_number, char inner[PATH_MAX]);

// Is it one of a lab's files? Then the folder of one student was given, and not that of a class.
int export_is_source(const char *name);

// ---- export_system.c: which course system made the names --------------------------------------
//
// Whether a system made a name, or a student chose one that looks so, is seen by the other entries:
// a system whose pattern fits more than half of them, and the most, made the folder. Each entry
// counts for every system that could have made it, as the system's own stands before whatever a
// student wrote: so all entries count for the system that made them, however many one student has,
// and whatever they are called. And the names must be those of more people than there are folders
// and archives of plain names: into a folder that all can write to, one student may put many files.

// The system, or SYSTEM_NONE.
ExportSystem export_system_find(const Export *export);

// How many folders and archives have names that the system has not made. *first: one of them.
int export_plain_count(const Export *export, ExportSystem system, const Found **first);

// Say what ILIAS does not say of teams, where there are any.
void export_teams_tell(const Export *export);

// Read each name that may be the system's, export->system, as that.
void export_names_read(Export *export);

#endif

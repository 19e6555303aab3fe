// The entries of a folder of submissions, by what their names say.
//
// Read next: export.h.
#ifndef CLASS_EXPORT_ENTRIES_H
#define CLASS_EXPORT_ENTRIES_H

#include "export.h"

#include <stddef.h>

// Read the entries of the folder export->path, at most n_most. What unpackers, desktops and course
// systems add is left out. Returns 0, or -1 after one message.
int export_entries_read(Export *export, int lab_number, int n_most);
void export_entries_free(Export *export);

// Is it what an unpacker, a desktop or a course system puts beside the entries, by its name?
int export_is_extra(const char *file);

// Has a file the name of a system's list, which says whose the entries are? Among the entries it
// may be any student's.
int export_is_list(const char *file);

// Say what is wrong with a folder. Returns -1.
int export_fault(const char *path, const char *what);

// Room for one more in an array that doubles. Returns the array, or NULL when memory runs out.
void *array_grown(void *array, int n, size_t size);

// Is it one of these names? NULL ends them.
int name_is_one_of(const char *file, const char *const *names);

#endif

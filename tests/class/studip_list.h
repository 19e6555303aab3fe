// Stud.IP's list of files, and which of its folders an export's is (see studip_names.h).
//
// Paths and names in it are other people's texts: they are compared and shown, and never opened.
#ifndef CLASS_STUDIP_LIST_H
#define CLASS_STUDIP_LIST_H

#include "export.h"
#include "sheet.h"

#define STUDIP_NAMES_FILE "archive_filelist.csv"

// A line of the list.
typedef struct StudipFile {
    const char *owner[2];  // first and last name
    const char *date;
    const char *path;
    size_t n_folder;              // how long the path is before the file's name
    char file[ENTRY_NAME_BYTES];  // composed
} StudipFile;

typedef struct StudipList {
    Sheet sheet;
    StudipFile *lines;  // by folder, then by file
    int n_lines;
} StudipList;

// Read the list in a folder. Returns 0, or -1 where there is none, or after one message. Release
// with studip_list_free().
int studip_list_load(const char *folder, StudipList *list);
void studip_list_free(StudipList *list);

// The folder of the list that the export's is: the one that names most of its entries, more than
// half, and more than any other does. Returns its lines, *n of them, by file, or NULL.
//   name   what it is called in the list, with those above it or without
const StudipFile *studip_folder_find(const StudipList *list, const Export *export, const char *name,
                                     int *n);

// The first line about a file among n lines of one folder; NULL where there is none.
const StudipFile *studip_file_find(const StudipFile *lines, int n, const char *file);

#endif

// Who handed an entry in, by the entry's name: what course systems, GitHub Classroom and an
// archiver add to a name is taken off.
//
// Read next: export.h, which reads a folder of entries.
#ifndef CLASS_ENTRY_NAME_H
#define CLASS_ENTRY_NAME_H

#include "course_system.h"
#include "name_likeness.h"

enum { ENTRY_NUMBER_BYTES = 24 };

typedef struct EntryName {
    // The student's name or user name: valid UTF-8 in one line; bytes that are not, characters that
    // are not seen and backslashes are written as \xHH, so that two names never look the same.
    char name[ENTRY_NAME_BYTES];
    char number[ENTRY_NUMBER_BYTES];  // the system's number of the student or team: "1234567"
    char login[ENTRY_NAME_BYTES];     // what else a list may know the student by, or ""
    char time[24];                    // of the attempt, as in course_system.h, or ""
    ExportSystem system;              // that made the name
    int file;                         // where the student's own name of a file begins, or 0
    int is_late;                      // the system marked the attempt as late
    int is_text;                      // typed into a form or written by the system: no file
} EntryName;

// Read an entry's name, at most 255 bytes of any kind.
//   "Ada Lovelace.zip", "ada"                       plain
//   "Ada Lovelace_1234567_assignsubmission_file_"   Moodle's, with the number of its worksheet; of
//                                                   a team its name, with a number of its own
//   "submission_123456"                             Gradescope's; its names are in another file
//   "lab-03-ada", "lab03-ada"                       GitHub Classroom's, of lab 3
//   "[17]_ada.zip"                                  Stud.IP's, which numbers files
EntryName entry_name_read(const char *entry, int lab_number);

// Read it as one of the systems in course_system.h names its files, or its folders. Where it is not
// such a name, the system is SYSTEM_NONE. Anybody may choose such a name: whether the system did is
// seen by the other entries (export.c).
EntryName entry_name_read_export(const char *entry, int is_folder, ExportSystem system);

// Parts of it, each in its system's file. Moodle's: how long the name is, or 0. What is before the
// name: of GitHub's "lab-03-ada", of Stud.IP's "[17]_ada.zip"; 0 where there is nothing. The number
// of Gradescope's "submission_123456".
int moodle_name_read(const char *entry, EntryName *name);
int git_prefix_length(const char *entry, int lab_number);
size_t studip_number_length(const char *file);
void gradescope_name_read(const char *entry, int length, EntryName *name);

// Bytes of any kind, at most 255, as text that EntryName can hold: see there.
void entry_name_show(const char *bytes, size_t n_bytes, char text[ENTRY_NAME_BYTES]);

// A name for files: small letters, digits and dashes of `name`, and sixteen digits of the SHA-256
// of `entry`. It is the name of an entry's results from one run to the next.
enum { ENTRY_SLUG_BYTES = 64 };
void entry_name_slug(const char *name, const char *entry, char slug[ENTRY_SLUG_BYTES]);

#endif

// What a course system writes before the name of a file, or makes the name of a folder: who handed
// it in, when, and under which number. Used by entry_name.c alone.
//
// A student chooses the file's own name, which comes last: so each pattern is looked for from the
// front, and what looks like a second one further back belongs to the file's name. It may look like
// another system's pattern: so which system made an export is seen by all entries together
// (export.c), and each entry is read as that system's.
#ifndef CLASS_SYSTEM_NAMES_H
#define CLASS_SYSTEM_NAMES_H

#include <stddef.h>

typedef enum ExportSystem {
    SYSTEM_NONE,
    SYSTEM_MOODLE,
    SYSTEM_CANVAS,
    SYSTEM_BLACKBOARD,
    SYSTEM_BRIGHTSPACE,
    SYSTEM_ILIAS,
    SYSTEM_VPL,
    // Not by names: by a list of files (studip.h, gradescope_names.h), a repository
    // (commits.h), or what the instructor says.
    SYSTEM_STUDIP,
    SYSTEM_GRADESCOPE,
    SYSTEM_GIT,
    SYSTEM_OWN,
    N_SYSTEMS
} ExportSystem;

// A piece of an entry's name.
typedef struct NamePart {
    const char *text;
    size_t length;
} NamePart;

typedef struct SystemName {
    ExportSystem system;  // SYSTEM_NONE: none of these patterns
    NamePart name;        // the student's, or the login where the system writes no name
    NamePart number;      // the system's number of the student
    NamePart login;       // what a list of participants knows the student by, besides the name
    char time[24];        // of the attempt, in an order that strcmp() knows; "" where there is none
    NamePart file;        // the student's own name of the file; empty: of a folder
    int is_late;          // marked as late
    int is_note;          // written by the system about the attempt, not handed in as a file
} SystemName;

// Read a name as that system's. One that is not has SYSTEM_NONE.
//   lovelaceada_40012_880036_file.cl, lovelaceada_LATE_40012_880036_file-1.cl    Canvas
//   lovelaceada_40012_text.html                                                  Canvas, typed text
//   anon_x7Q2b_880036_file.cl                                                    Canvas, anonymous
//   Lab 0_ab12_attempt_2026-11-03-10-22-33_file.cl, ...-33.txt                   Blackboard
//   40012-880036 - Ada Lovelace - Nov 3, 2026 1022 AM[ - file.cl]                Brightspace (D2L)
//   Lovelace_Ada_ada_1234                                                        ILIAS, a folder
//   Lovelace Ada 1234 ada                                                        VPL, a folder
SystemName system_name_read(const char *entry, ExportSystem system);

// Could the system have made the name, whatever a student has called the file? Some such names can
// not be read, as a student's part looks like the system's: they still show which system it was.
int system_name_is_possible(const char *entry, ExportSystem system);

// Has a folder's name all four parts of ILIAS', last name, first name, login and number? Of three,
// "lab_ada_2", only the files in it say that it is ILIAS'.
int ilias_name_is_whole(const char *entry);

// Older releases of ILIAS put the time before each file's name, "20261103102233_17_file.cl".
// Returns how long that is, or 0.
size_t ilias_time_length(const char *file);

#endif

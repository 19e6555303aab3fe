// When an attempt was handed in, by what the course system has written about it.
#ifndef CLASS_ENTRY_TIME_H
#define CLASS_ENTRY_TIME_H

#include "export.h"

typedef struct EntryTime {
    char *text;  // for moment_read(), or "", or where `from` is SYSTEM_NONE what is there instead,
                 // in words; owned, NULL when memory runs out
    ExportSystem from;  // by which row of the table in course_system.h
    int is_late;        // the system marked the attempt as late
} EntryTime;

// Blackboard and Brightspace have the time in the names of files, Gradescope and Stud.IP in their
// lists, an older ILIAS before each file's name in the student's folder, where the last one counts.
// Canvas and a newer ILIAS write no times but mark what is late: Canvas in the names of files,
// ILIAS before the name of each file in the folder.
//   begin, end   the attempt's entries
//   is_version   it is asked for one version of a file: what is known only of the attempt as a
//                whole is then no answer
EntryTime entry_time(const Export *export, int begin, int end, int is_version);

#endif

// What a course system writes: before the name of a file, or as the name of a folder, who handed it
// in, when, and under which number. And who could have written the same: what a student can write
// never decides alone, it is shown, and left to the instructor.
//
// Each system has a file of its own, with a CourseSystem. Their texts are the table in
// tests/INSTRUCTORS.md; a test compares the two. To add one: such a file, and its name in the enum
// and in the table of course_system.c.
//
// A student chooses the file's own name, which comes last: so each pattern is looked for from the
// front, and what looks like a second one further back belongs to the file's name. It may look like
// another system's pattern: so which system made an export is seen by all entries together
// (export_read.h), and each entry is read as that system's. Read next: canvas.c.
#ifndef CLASS_COURSE_SYSTEM_H
#define CLASS_COURSE_SYSTEM_H

#include <stddef.h>

typedef enum ExportSystem {
    SYSTEM_NONE,
    SYSTEM_MOODLE,
    SYSTEM_CANVAS,
    SYSTEM_BLACKBOARD,
    SYSTEM_BRIGHTSPACE,
    SYSTEM_ILIAS,
    SYSTEM_VPL,
    // Not by names: by a list of files (studip.h, gradescope.h), a repository (roster.h), or what
    // the instructor says.
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

typedef enum Writer {
    WRITER_NOBODY,  // there is no such information
    WRITER_STUDENT,
    WRITER_SYSTEM,
    WRITER_INSTRUCTOR
} Writer;

// "no", "a student", "the system", "you": as the table in tests/INSTRUCTORS.md says it.
const char *writer_words(Writer writer);

typedef struct CourseSystem {
    const char *title;     // for messages
    const char *identity;  // where it is written whose a submission is
    Writer identity_writer;
    const char *time;  // where it is written when it was handed in
    Writer time_writer;
    int has_marks;                          // it writes no times, but marks what is late
    SystemName (*read)(const char *entry);  // NULL: names are not this system's
    int (*is_possible)(const char *entry);  // system_name_is_possible(); NULL: as it can be read
} CourseSystem;

extern const CourseSystem moodle_system, canvas_system, blackboard_system, brightspace_system,
    ilias_system, vpl_system, studip_system, gradescope_system, git_system;

const CourseSystem *course_system(ExportSystem system);

// The system with a title; SYSTEM_NONE for any other text.
ExportSystem course_system_find(const char *title);

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

// Does a text match a regular expression? The parts of its groups, the whole being the first.
enum { NAME_PARTS = 8 };
int name_matches(const char *pattern, const char *text, NamePart parts[NAME_PARTS]);

#endif

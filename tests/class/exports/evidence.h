// What a class's rows rest on: from where it is known whose a submission is and when it was handed
// in, and who can write that.
//
// What a student can write never decides alone: it is shown, and left to the instructor. The same
// table is in tests/INSTRUCTORS.md; a test compares the two. Read next: export.c, entry_time.h.
#ifndef CLASS_EVIDENCE_H
#define CLASS_EVIDENCE_H

#include "system_names.h"

typedef enum Writer {
    WRITER_NOBODY,  // there is no such information
    WRITER_STUDENT,
    WRITER_SYSTEM,
    WRITER_INSTRUCTOR
} Writer;

// "no", "a student", "the system", "you": as the table in tests/INSTRUCTORS.md says it.
const char *writer_words(Writer writer);

typedef struct SystemEvidence {
    const char *title;     // the system's, for messages
    const char *identity;  // where it is written whose a submission is
    Writer identity_writer;
    const char *time;  // where it is written when it was handed in
    Writer time_writer;
} SystemEvidence;

const SystemEvidence *evidence_of(ExportSystem system);

// The system with a title; SYSTEM_NONE for any other text.
ExportSystem evidence_find(const char *title);

#endif

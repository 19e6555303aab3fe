// What an archive may hold and use up, a student's or that of a whole class: more ends in a
// message, which says what to do. Used by unpack_read.c, which counts, and unpack_run.c.
#ifndef GRADER_UNPACK_RULES_H
#define GRADER_UNPACK_RULES_H

typedef struct UnpackRules {
    int most_packed_megabytes;  // of the archive itself
    int most_megabytes;         // of all entries, unpacked
    int most_entries;
    int most_file_megabytes;                           // of a file that is written
    int seconds;                                       // of processor time
    const char *if_large, *if_damaged, *if_encrypted;  // what to do then
} UnpackRules;

extern const UnpackRules unpack_rules_student, unpack_rules_export;

#endif

// What an archive may hold and use up, a student's or that of a whole class: more ends in a
// message, which says what to do. Used by unpack_read.c, which counts, and unpack_run.c.
#ifndef GRADER_UNPACK_RULES_H
#define GRADER_UNPACK_RULES_H

#include "submission.h"
#include "unpack.h"

typedef struct UnpackRules {
    int most_packed_megabytes;  // of the archive itself
    int most_megabytes;         // of all entries, unpacked
    int most_entries;
    int most_file_megabytes;                           // of a file that is written
    int seconds;                                       // of processor time
    const char *if_large, *if_damaged, *if_encrypted;  // what to do then
} UnpackRules;

static const UnpackRules unpack_rules_student = {
    .most_packed_megabytes = SUBMISSION_MAX_MEGABYTES,
    .most_megabytes = UNPACK_MAX_MEGABYTES,
    .most_entries = UNPACK_MAX_ENTRIES,
    .most_file_megabytes = UNPACK_MAX_WRITTEN_MEGABYTES + 1,
    .seconds = 20,
    .if_large = "hand in the lab's files only",
    .if_damaged = "pack the files anew",
    .if_encrypted = "hand it in without a password",
};

// A class of a thousand, with 4 MB and a hundred files each.
#define UNPACK_IT_YOURSELF "unpack it yourself, and give the folder"
static const UnpackRules unpack_rules_export = {
    .most_packed_megabytes = 4096,
    .most_megabytes = 4096,
    .most_entries = 100000,
    .most_file_megabytes = 4096,
    .seconds = 600,
    .if_large = UNPACK_IT_YOURSELF,
    .if_damaged = UNPACK_IT_YOURSELF,
    .if_encrypted = UNPACK_IT_YOURSELF,
};

#endif

// What Oclgrind wrote down, in a student's words.
//
// Oclgrind runs a kernel instruction by instruction and writes a message for each that goes wrong,
// mostly the same one for every work-item. Read next: memcheck.c, which runs it.
#ifndef GRADER_OCLGRIND_LOG_H
#define GRADER_OCLGRIND_LOG_H

enum { FINDING_FILE_BYTES = 128, MAX_FINDINGS = 32 };

// One fault at one line, however often it occurred: Oclgrind stops at a thousand messages, so that
// nobody knows how often.
typedef struct Finding {
    const char *says;                     // "reads beyond the end of a buffer ..."
    char file[FINDING_FILE_BYTES];        // as the compiler knows it, "" when it is not known
    int line;                             // from 1 on
    char other_file[FINDING_FILE_BYTES];  // of a race: what the other work-item was at; or ""
    int other_line;
    char work_item[48];  // the first it occurred in, "(3, 0)", or ""
} Finding;

// Read a log, which may hold anything; it is changed. What is not yet among findings[n] is added.
// Returns how many there are then, at most MAX_FINDINGS.
int oclgrind_log_read(char *log, Finding findings[MAX_FINDINGS], int n);

#endif

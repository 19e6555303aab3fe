// What a check is, and what a judge says of it: common to the judge, which is a program of its own,
// and to the grader that asks it.
#ifndef GRADER_VERDICT_H
#define GRADER_VERDICT_H

typedef struct Check {
    const char *id;
    const char *title;
    const char *task;
    int points;
    const char
        *needs;  // whose answers have a part in it besides: ids parted by blanks, "*" for all,
                 // NULL or "" for none
} Check;

typedef enum VerdictKind {
    VERDICT_PASSED,
    VERDICT_FAILED,
    VERDICT_MISSING,  // the probe ended before it could answer
    N_VERDICT_KINDS,
} VerdictKind;

typedef struct Verdict {
    VerdictKind kind;
    char *message;  // what is wrong; NULL unless VERDICT_FAILED; owned
} Verdict;

#endif

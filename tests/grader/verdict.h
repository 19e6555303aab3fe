// What a check is, and what a judge says of it: common to the judge, which is a program of its own,
// and to the grader that asks it.
#ifndef GRADER_VERDICT_H
#define GRADER_VERDICT_H

// What a check looks at: the farther down, the more answers have a part in it.
typedef enum CheckScope {
    IS_OWN,     // the answer to its task, on inputs of its own
    IS_CALLER,  // the same, but it calls the answer to another task
    IS_WHOLE,   // what comes of the answers to all tasks
} CheckScope;

typedef struct Check {
    const char *id;
    const char *title;
    const char *task;
    int points;
    CheckScope scope;
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

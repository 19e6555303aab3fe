// What a check is, and what a judge says of it: common to the judge, which is a program of its own,
// and to the grader that asks it.
#ifndef GRADER_VERDICT_H
#define GRADER_VERDICT_H

#include "diagnosis.h"

#include <stdint.h>

typedef struct Check {
    const char *id;
    const char *title;
    const char *task;
    int points;  // by the manifest; the rest is the judge's
    const char
        *needs;  // whose answers have a part in it besides: ids parted by blanks, "*" for all,
                 // NULL or "" for none
    int is_of_scenes;   // it looks at whole pictures, or at what they cost
    int is_same_alone;  // where its answer is tried alone, it is judged as in the whole, too
} Check;

typedef enum VerdictKind {
    VERDICT_PASSED,
    VERDICT_FAILED,
    VERDICT_MISSING,  // the probe ended before it could answer
    N_VERDICT_KINDS,
} VerdictKind;

typedef struct Verdict {
    VerdictKind kind;
    Diagnosis diagnosis;  // of VERDICT_FAILED; else NOTHING_WRONG. Owned
} Verdict;

// The kinds of a diagnosis as they are sent from the judge to the grader.
typedef struct SentKinds {
    uint32_t mistake;   // below N_MISTAKES
    uint32_t evidence;  // below N_EVIDENCES
} SentKinds;

#endif

// Making verdicts.
#ifndef JUDGE_VERDICTS_H
#define JUDGE_VERDICTS_H

#include "verdict.h"

#include <stddef.h>

static const Verdict verdict_passed = {.kind = VERDICT_PASSED};
static const Verdict verdict_missing = {.kind = VERDICT_MISSING};

// Passed where nothing is wrong, else failed. Takes the diagnosis over.
static inline Verdict verdict_of(Diagnosis diagnosis)
{
    return (Verdict){diagnosis.found != NULL ? VERDICT_FAILED : VERDICT_PASSED, diagnosis};
}

// Has it passed? Releases the diagnosis.
static inline int verdict_passes(Verdict verdict)
{
    diagnosis_free(&verdict.diagnosis);
    return verdict.kind == VERDICT_PASSED;
}

#endif

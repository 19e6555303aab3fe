// Making verdicts.
#ifndef JUDGE_VERDICTS_H
#define JUDGE_VERDICTS_H

#include "verdict.h"

#include <stddef.h>
#include <stdlib.h>

static const Verdict verdict_missing = {VERDICT_MISSING, NULL};

// Passed when message is NULL, else failed. Takes the message over.
static inline Verdict verdict_of(char *message)
{
    return (Verdict){message ? VERDICT_FAILED : VERDICT_PASSED, message};
}

// Has it passed? Releases the message.
static inline int verdict_passes(Verdict verdict)
{
    free(verdict.message);
    return verdict.kind == VERDICT_PASSED;
}

#endif

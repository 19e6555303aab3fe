// What a student is told, for the tests of judges.
#ifndef UNIT_TOLD_H
#define UNIT_TOLD_H

#include "diagnosis.h"

#include <stddef.h>

// The sentence of a diagnosis, NULL where nothing is wrong. Releases the diagnosis; the sentence is
// the caller's.
static inline char *told(Diagnosis diagnosis)
{
    char *message = diagnosis.found != NULL ? diagnosis_text(&diagnosis) : NULL;
    diagnosis_free(&diagnosis);
    return message;
}

#endif

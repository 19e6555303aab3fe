// Making diagnoses and their sentences (see diagnosis.h).
#include "diagnosis.h"

#include "message.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[N_MISTAKES] = {
    [MISTAKE_NONE] = "none",
    [MISTAKE_MIRRORED_X] = "mirrored-x",
    [MISTAKE_FLIPPED_Y] = "flipped-y",
    [MISTAKE_TRANSPOSED] = "transposed",
    [MISTAKE_CHANNELS_SWAPPED] = "channels-swapped",
    [MISTAKE_SHIFTED_ONE] = "shifted-one",
    [MISTAKE_SHIFTED_HALF] = "shifted-half",
    [MISTAKE_GAMMA] = "gamma",
    [MISTAKE_STRICT_BOUNDARY] = "strict-boundary",
    [MISTAKE_LATER_OF_EQUALS] = "later-of-equals",
    [MISTAKE_FAR_CHILD] = "far-child",
    [MISTAKE_MISSING_IN_CELL] = "missing-in-cell",
    [MISTAKE_UNWRITTEN] = "unwritten",
};

const char *mistake_name(Mistake mistake)
{
    return names[mistake];
}

Mistake mistake_find(const char *name)
{
    for (Mistake mistake = MISTAKE_NONE + 1; mistake < N_MISTAKES; mistake++) {
        if (strcmp(names[mistake], name) == 0) {
            return mistake;
        }
    }
    return MISTAKE_NONE;
}

const char *silence_name(Silence silence)
{
    static const char *const words[N_SILENCES] = {[SILENCE_UNANSWERED] = "unanswered",
                                                  [SILENCE_UNTRIED] = "untried",
                                                  [SILENCE_ENDED] = "ended"};
    return words[silence];
}

Diagnosis diagnosis_new(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *found = message_new_from(format, arguments);
    va_end(arguments);
    return (Diagnosis){.found = found};
}

Diagnosis diagnosis_silent(Silence silence, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *found = message_new_from(format, arguments);
    va_end(arguments);
    return (Diagnosis){.found = found, .silence = silence};
}

Diagnosis diagnosis_of(char *found, Cause cause)
{
    return (Diagnosis){.found = found,
                       .cause = cause.says != NULL ? message_new("%s", cause.says) : NULL,
                       .mistake = cause.mistake};
}

Diagnosis diagnosis_seen(char *found, Cause looks, Evidence evidence)
{
    return (Diagnosis){.found = found,
                       .cause = looks.says != NULL ? message_new("it looks %s", looks.says) : NULL,
                       .rule = looks.says,
                       .mistake = looks.mistake,
                       .evidence = evidence};
}

Diagnosis diagnosis_at(const char *where, Diagnosis diagnosis)
{
    if (diagnosis.found != NULL) {
        char *found = message_new("%s: %s", where, diagnosis.found);
        free(diagnosis.found);
        diagnosis.found = found;
    }
    return diagnosis;
}

char *diagnosis_text(const Diagnosis *diagnosis)
{
    return message_new("%s%s%s", diagnosis->found != NULL ? diagnosis->found : "",
                       diagnosis->cause != NULL ? "; " : "",
                       diagnosis->cause != NULL ? diagnosis->cause : "");
}

void diagnosis_free(Diagnosis *diagnosis)
{
    free(diagnosis->found);
    free(diagnosis->cause);
    *diagnosis = NOTHING_WRONG;
}

// Releasing a Result (see result.h).
//
// Flow: staging -> compiling -> running -> judging -> RESULT -> reports. Read next: report.h.
#include "result.h"

#include <stdlib.h>

void result_free(Result *result)
{
    for (int i = 0; i < result->n_stages; i++)
        free(result->stages[i].message);
    for (int i = 0; i < result->n_checks; i++)
        free(result->checks[i].message);
    for (int i = 0; i < result->n_pictures; i++) {
        PictureResult *picture = &result->pictures[i];
        image_free(&picture->reference);
        image_free(&picture->own);
        free(picture->svg_reference);
        free(picture->svg_own);
    }
    *result = (Result){0};
}

// Offering `make memcheck` (see memcheck_advice.h).
#include "memcheck_advice.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

static int has_kernels(const Manifest *manifest)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (strstr(manifest->files[i], ".cl") != NULL) {
            return 1;
        }
    }
    return 0;
}

// Are pixels wrong, or no numbers at all, and no check has recognised why?
static int has_strange_pixels(const Result *result)
{
    int n_strange = 0, n_recognised = 0;
    for (int i = 0; i < result->n_checks; i++) {
        const char *message = result->checks[i].message;
        if (result->checks[i].status == CHECK_FAILED && message != NULL) {
            const int is_number = strstr(message, "not a number") == NULL;
            n_recognised += is_number && strstr(message, "it looks") != NULL;
            n_strange += strstr(message, "pixels differ") != NULL;
        }
    }
    return n_strange > 0 && n_recognised == 0;
}

void memcheck_advise(const Manifest *manifest, int crashed, Result *result)
{
    if (!has_kernels(manifest) || (!crashed && !has_strange_pixels(result))) {
        return;
    }
    for (int i = 0; i < result->n_stages; i++) {
        StageResult *stage = &result->stages[i];
        if (strcmp(stage->title, "Running") == 0) {
            char *message = message_new(
                "%s%s%s: `make memcheck LAB=%.2s` looks for indices out of range, "
                "values that were never set and races, at your own lines.",
                stage->message, stage->message[0] != '\0' ? "\n" : "",
                crashed ? "A crash" : "Some pixels are wrong in no usual way", manifest->lab);
            free(stage->message);
            stage->message = message;
        }
    }
}

// Judging one function's answers in one range.
#include "judge_07_range.h"

#include <string.h>

static int explains(const Range *range, int mistake)
{
    int i = range->first;
    while (i < range->first + range->n &&
           range->agrees(range->inputs, i, range->answers, mistake)) {
        i++;
    }
    return i == range->first + range->n;
}

static int is_constant(const Range *range)
{
    const char *answers = (const char *)range->answers + (size_t)range->first * range->answer_bytes;
    int i = 1;
    while (i < range->n &&
           memcmp(answers, answers + (size_t)i * range->answer_bytes, range->answer_bytes) == 0) {
        i++;
    }
    return i == range->n;
}

Wrong range_judge(const Range *range)
{
    Wrong wrong = {.why = ""};
    for (int i = range->first + range->n - 1; i >= range->first; i--) {
        if (!range->agrees(range->inputs, i, range->answers, 0)) {
            wrong.n++;
            wrong.first = i;
        }
    }
    if (wrong.n > 0 && !is_constant(range)) {
        for (int mistake = 1; mistake < range->n_mistakes; mistake++) {
            if (explains(range, mistake)) {
                wrong.why = range->mistakes[mistake];
                break;
            }
        }
    }
    return wrong;
}

// Judging a range of a function's answers (see function.h).
#include "function.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

int range_at(Range range, int i)
{
    return range.first + i * (range.step > 1 ? range.step : 1);
}

int edge_of(int i, int n, int n_edges)
{
    return i < n - n_edges ? -1 : i - (n - n_edges);
}

int facts_are_none(char *facts)
{
    const int is_right = facts == NULL;
    free(facts);
    return is_right;
}

const void *function_answers(const Function *function, const Sections *answers)
{
    return sections_find(answers, function->section, (size_t)function->n * function->answer_bytes);
}

static int is_same_text(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

// A known mistake of a function: a number in one of its lists.
typedef struct Place {
    int list, number;
} Place;

// What is known of it. The next one where that is behind the end of a list; name is NULL behind the
// last list. Which input it is asked about makes no difference to its cause.
static Known known_at(const Function *function, Place *place, const void *job, Range range,
                      const void *answers)
{
    Known known = {.name = NULL};
    while (known.name == NULL && place->list < MOST_KNOWN_LISTS &&
           function->known[place->list] != NULL) {
        known = function->known[place->list](job, range.first, answers, place->number, 0);
        if (known.name == NULL) {
            *place = (Place){place->list + 1, 0};
        }
    }
    return known;
}

// Does a way of a known mistake explain every answer of the range?
static int is_known_way(const Function *function, Place place, int way, const void *job,
                        Range range, const void *answers)
{
    int i = 0, fits = 1;
    for (; fits && i < range.n; i++) {
        const int at = range_at(range, i);
        const Known known = function->known[place.list](job, at, answers, place.number, way);
        fits = known.fits || (known.form == KNOWN_OF_WRONG && function->is_right(job, at, answers));
    }
    return fits;
}

// Does a known mistake?
static int is_known(const Function *function, Place place, int n_ways, const void *job, Range range,
                    const void *answers)
{
    int way = 0;
    while (way < n_ways && !is_known_way(function, place, way, job, range, answers)) {
        way++;
    }
    return way < n_ways;
}

// Are all answers the same, as where nothing was filled in?
static int is_constant(const Function *function, Range range, const char *answers)
{
    const size_t n_bytes = function->answer_bytes;
    const char *first = answers + (size_t)range.first * n_bytes;
    int i = 1;
    while (i < range.n &&
           memcmp(first, answers + (size_t)range_at(range, i) * n_bytes, n_bytes) == 0) {
        i++;
    }
    return i == range.n;
}

// Does a mistake that says what an answer is (ANSWERS, EACH, ONE_OF; of a family, ANY) explain
// every answer of a range? *cause becomes the one that does. Returns how many do, with different
// sentences: 0, 1 or 2.
static int count_answers(const Function *function, const void *job, Range range,
                         const void *answers, int is_family, Cause *cause)
{
    int n = 0;
    for (Place place = {0}; n < 2; place.number++) {
        const Known known = known_at(function, &place, job, range, answers);
        if (known.name == NULL) {
            break;
        }
        if (known.form == (is_family ? KNOWN_FAMILY : KNOWN_ANSWERS) &&
            is_known(function, place, known.n_ways, job, range, answers) &&
            (n == 0 || !is_same_text(cause->says, known.cause.says))) {
            *cause = known.cause;
            n++;
        }
    }
    return n;
}

// The known mistake that explains every answer: one that says what an answer is; else the first
// that says where answers are wrong (ONLY). Where a range is enough, and several explain it, the
// one that explains the answers of all ranges.
static Cause name_known(const Function *function, const void *job, Range range, const void *answers)
{
    const Range all = {.n = function->n};
    Cause cause = {0};
    for (int is_family = 0; is_family <= 1; is_family++) {
        const int n = count_answers(function, job, range, answers, is_family, &cause);
        if (n > 0) {
            const int is_one =
                n == 1 || count_answers(function, job, all, answers, is_family, &cause) == 1;
            return is_one ? cause : (Cause){0};
        }
    }
    for (Place place = {0};; place.number++) {
        const Known known = known_at(function, &place, job, range, answers);
        if (known.name == NULL ||
            (known.form == KNOWN_OF_WRONG && is_known(function, place, 1, job, range, answers))) {
            return known.cause;
        }
    }
}

// The cause. From answers that are all the same nothing is concluded, but where the list knows such
// a place.
static Cause explain(const Function *function, const void *job, Range range, const void *answers)
{
    if (!function->is_known_by_range) {
        range = (Range){.n = function->n};
    }
    return function->knows_constant || !is_constant(function, range, answers)
               ? name_known(function, job, range, answers)
               : (Cause){0};
}

// What is wrong with the answers: how many, the first one, and what explains them.
static Diagnosis judge_counting(const Function *function, const void *job, Range range,
                                const void *answers)
{
    int n_wrong = 0, first = 0;
    for (int i = range.n - 1; i >= 0; i--) {
        if (!function->is_right(job, range_at(range, i), answers)) {
            n_wrong++;
            first = range_at(range, i);
        }
    }
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    char *wrong = function->describe(job, first, answers);
    const char *counted = function->counted != NULL ? function->counted : "inputs";
    char *found = message_new("%s (%d of %d %s are wrong)", wrong, n_wrong, range.n, counted);
    free(wrong);
    return diagnosis_of(found, explain(function, job, range, answers));
}

Verdict function_judge(const Function *function, const void *job, Range range,
                       const Sections *answers)
{
    const void *found = function_answers(function, answers);
    if (found == NULL) {
        return verdict_missing;
    }
    job = (const char *)job + function->inputs;
    return verdict_of(judge_counting(function, job, range, found));
}

Cause function_cause(const Function *function, const void *job, Range range,
                     const Sections *answers)
{
    Verdict verdict = function_judge(function, job, range, answers);
    const int has_failed = verdict.kind == VERDICT_FAILED;
    diagnosis_free(&verdict.diagnosis);
    return has_failed ? explain(function, (const char *)job + function->inputs, range,
                                function_answers(function, answers))
                      : (Cause){0};
}

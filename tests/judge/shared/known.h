// How a judge knows a mistake: for each function of the student's, a list of known ones.
//
// A list is a function that is asked about a mistake by its number, and about one input and answer.
// In it each mistake is written once: its name, an expression, what is said of it, and its kind
// where it has one:
//
//   KNOWN_LIST(known)
//   {
//       GIVEN;
//
//       ANSWERS(far_side, !near_side(in), "that is the far side: near and far are swapped");
//       ...
//       return NO_MORE;
//   }
//
//   ANSWERS(far_side, !near_side(in), "that is the far side: near and far are swapped");
//       what an answer with the mistake is for the input `in`: every answer must be it;
//       EACH(name, expression, ...) is the same where it takes more to tell whether `found` is it;
//   ONLY(no_radius, !found && in.radius == 0, "a circle of radius 0 covers its centre");
//       could the wrong answer `found` be of the mistake? Every wrong one must.
//   ONE_OF(few_asked, 3, IS_FOUND(of_first(in, 4 << way)), "not all of them are asked");
//       EACH for three mistakes with one sentence: `way` is 0 to 2, and one of them is it;
//   ANY(copied, 6, IS_FOUND(other_axis(in, way)), "the numbers of another axis were taken");
//       the same for a large family: it may contain others' mistakes, and what is right; it is
//       named where no other is.
//
// "Every" is every answer of the function, in the ranges of all checks (but for is_known_by_range
// of function.h): a sentence that is true in one check and not in another is not the cause.
// ANSWERS, EACH and ONE_OF are asked first, then ANY; if two with different sentences explain the
// answers, nothing is said. Of ONLY the first of the list is named: the special one is before the
// general one. NULL for a sentence: then nothing is said. What is right is told without mistakes:
//
//   RIGHT(is_right, found == near_side(in))
//
// For each function, a file defines two macros: GIVEN declares `in` and `found`, number i of the
// `job` and of the `answers`; IS_FOUND(expected) says whether `found` is that.
#ifndef JUDGE_KNOWN_H
#define JUDGE_KNOWN_H

#include "diagnosis.h"

// What a list says of one mistake.
typedef struct Known {
    const char *name;  // NULL behind the last one
    Cause cause;
    int fits;    // could the answer be of it?
    int n_ways;  // how many mistakes it is
    enum { KNOWN_ANSWERS, KNOWN_FAMILY, KNOWN_OF_WRONG } form;
} Known;

typedef Known KnownList(const void *job, int i, const void *answers, int number, int way);
#define KNOWN_LIST(list)                                                                           \
    static Known list(const void *job, int i, const void *answers, int number, int way)
#define NO_MORE ((void)number, (void)way, (Known){.name = NULL})

#define RIGHT(name, expression)                                                                    \
    static int name(const void *job, int i, const void *answers)                                   \
    {                                                                                              \
        GIVEN;                                                                                     \
        (void)in, (void)found;                                                                     \
        return expression;                                                                         \
    }
#define ANSWERS(name, expression, ...) EACH(name, IS_FOUND(expression), __VA_ARGS__)
#define EACH(name, expression, ...) ONE_OF(name, 1, expression, __VA_ARGS__)
#define ONE_OF(name, n, expression, ...) KNOWN(name, n, expression, KNOWN_ANSWERS, __VA_ARGS__)
#define ANY(name, n, expression, ...) KNOWN(name, n, expression, KNOWN_FAMILY, __VA_ARGS__)
#define ONLY(name, expression, ...) KNOWN(name, 1, expression, KNOWN_OF_WRONG, __VA_ARGS__)
#define KNOWN(name, n, expression, form, ...)                                                      \
    do {                                                                                           \
        if (number-- == 0) {                                                                       \
            return (Known){#name, {.says = __VA_ARGS__}, expression, n, form};                     \
        }                                                                                          \
    } while (0)

#endif

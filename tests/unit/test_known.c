// judge/shared/known: which known mistake is named, of a function that doubles whole numbers.
#include "function.h"
#include "message.h"
#include "told.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

TestSuite(known);

enum { N_NUMBERS = 4 };
typedef struct Numbers {
    int numbers[N_NUMBERS];
} Numbers;

#define GIVEN                                                                                      \
    const int in = ((const Numbers *)job)->numbers[i];                                             \
    const int found = ((const int *)answers)[i]
#define IS_FOUND(expected) (found == (expected))

RIGHT(is_right, IS_FOUND(2 * in))

KNOWN_LIST(known)
{
    GIVEN;
    ANSWERS(squared, in * in, "it is squared");
    ANSWERS(doubled_twice, 4 * in, "it is doubled twice");
    ANSWERS(cubed, in * in * in, "it is cubed");
    ONLY(negative, in < 0, "only negative ones are wrong", MISTAKE_STRICT_BOUNDARY);
    return NO_MORE;
}

// A second list.
KNOWN_LIST(more_known)
{
    GIVEN;
    ONLY(odd, in % 2 != 0, "only odd ones are wrong");
    ANY(added, 5, IS_FOUND(2 * in + way), "a number is added to it");
    return NO_MORE;
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("%d: found %d", in, found);
}

static const Function doubles = {"doubles", N_NUMBERS, sizeof(int),
                                 KNOWING(is_right, describe, known, more_known)};

// What a function says of these answers for the numbers of a job, or for `range` of them.
static void expect_said_by(const Function *function, const void *job, Range range,
                           const int answers[N_NUMBERS], const char *expected)
{
    char *bytes = NULL;
    Sections sections;
    FILE *file = open_memstream(&bytes, &sections.n_bytes);
    section_write(file, "doubles", answers, N_NUMBERS * sizeof *answers);
    fclose(file);
    sections.bytes = (unsigned char *)bytes;
    char *said = told(function_judge(function, job, range, &sections).diagnosis);
    cr_expect(said != NULL && expected != NULL ? strcmp(said, expected) == 0 : said == expected,
              "found \"%s\", expected \"%s\"", said, expected);
    free(said);
    free(bytes);
}

static const Numbers numbers = {{0, 2, 3, -1}};

static void expect_said(Range range, const int answers[N_NUMBERS], const char *expected)
{
    expect_said_by(&doubles, &numbers, range, answers, expected);
}

static const Range all = {0, N_NUMBERS, 1};

Test(known, right_answers_have_no_mistake)
{
    expect_said(all, (const int[]){0, 4, 6, -2}, NULL);
}

Test(known, a_mistake_foretells_every_answer)
{
    expect_said(all, (const int[]){0, 8, 12, -4},
                "2: found 8 (3 of 4 inputs are wrong); it is doubled twice");
    expect_said(all, (const int[]){0, 8, 12, -2}, "2: found 8 (2 of 4 inputs are wrong)");
    expect_said(all, (const int[]){1, 8, 12, -4}, "0: found 1 (4 of 4 inputs are wrong)");
}

Test(known, of_a_family_one_way_explains_every_answer)
{
    expect_said(all, (const int[]){3, 7, 9, 1},
                "0: found 3 (4 of 4 inputs are wrong); a number is added to it");
    expect_said(all, (const int[]){3, 7, 9, 2}, "0: found 3 (4 of 4 inputs are wrong)");
}

Test(known, or_the_wrong_ones_have_it_in_common)
{
    expect_said(all, (const int[]){0, 4, 6, 7},
                "-1: found 7 (1 of 4 inputs are wrong); only negative ones are wrong");
    expect_said(all, (const int[]){0, 4, 7, 7},
                "3: found 7 (2 of 4 inputs are wrong); only odd ones are wrong");
    expect_said(all, (const int[]){0, 5, 7, 7}, "2: found 5 (3 of 4 inputs are wrong)");
}

Test(known, it_has_to_explain_the_answers_of_other_ranges_too)
{
    expect_said((Range){2, 2, 1}, (const int[]){9, 9, 9, 1},
                "3: found 9 (2 of 2 inputs are wrong)");
    expect_said((Range){2, 2, 1}, (const int[]){0, 4, 9, 1},
                "3: found 9 (2 of 2 inputs are wrong); it is squared");
    expect_said((Range){2, 1, 1}, (const int[]){0, 4, 7, 7},
                "3: found 7 (1 of 1 inputs are wrong); only odd ones are wrong");
    expect_said((Range){2, 1, 1}, (const int[]){0, 5, 7, -2},
                "3: found 7 (1 of 1 inputs are wrong)");
}

Test(known, of_two_that_explain_a_range_the_one_that_explains_all_is_named)
{
    expect_said((Range){0, 2, 1}, (const int[]){0, 8, 12, -4},
                "2: found 8 (1 of 2 inputs are wrong); it is doubled twice");
    expect_said((Range){0, 2, 1}, (const int[]){0, 8, 27, -1},
                "2: found 8 (1 of 2 inputs are wrong); it is cubed");
    expect_said((Range){0, 2, 1}, (const int[]){0, 8, 6, -2},
                "2: found 8 (1 of 2 inputs are wrong)");
}

Test(known, of_answers_that_are_all_the_same_nothing_is_concluded)
{
    expect_said((Range){2, 2, 1}, (const int[]){0, 0, 0, 0},
                "3: found 0 (2 of 2 inputs are wrong)");
}

Test(known, a_function_may_get_a_part_of_the_job)
{
    const struct {
        int other;
        Numbers numbers;
    } job = {7, numbers};
    Function of_part = doubles;
    of_part.inputs = (size_t)((const char *)&job.numbers - (const char *)&job);
    expect_said_by(&of_part, &job, all, (const int[]){0, 8, 12, -4},
                   "2: found 8 (3 of 4 inputs are wrong); it is doubled twice");
}

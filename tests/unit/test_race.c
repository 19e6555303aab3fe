// grader/run/race: what the times of a race are worth, and that nothing else becomes a figure.
#include "race.h"
#include "race_answers.h"
#include "surroundings.h"

#include <math.h>

TestSuite(race, .init = folder_enter, .fini = folder_leave);

// Answers as a race writes them, to be changed before they are judged.
typedef struct Written {
    RaceTimes times;
    unsigned char pictures[N_RACERS][RACE_PICTURE_BYTES];
} Written;

// Every round of the reference takes 60 ms, every one of the submission 5.
static Written *written_make(void)
{
    Written *written = calloc(1, sizeof *written);
    cr_assert_not_null(written);
    for (int i = 0; i < RACE_ROUNDS; i++) {
        written->times.ms[RACE_REFERENCE][i] = 60;
        written->times.ms[RACE_OWN][i] = 5;
    }
    for (size_t i = 0; i < RACE_PICTURE_BYTES; i++) {
        written->pictures[RACE_REFERENCE][i] = written->pictures[RACE_OWN][i] =
            (unsigned char)(i % 251);
    }
    return written;
}

static void section_append(const char *name, const void *bytes, size_t n_bytes)
{
    FILE *file = fopen("answers", "ab");
    cr_assert_not_null(file);
    cr_assert_eq(section_write(file, name, bytes, n_bytes), 0);
    fclose(file);
}

static double file_judge(void)
{
    Sections answers;
    sections_load("answers", 1 << 24, &answers);
    const double figure = race_judge(&answers);
    sections_free(&answers);
    unlink("answers");
    return figure;
}

static double written_judge(const Written *written)
{
    section_append("times", &written->times, sizeof written->times);
    section_append("picture.0", written->pictures[0], RACE_PICTURE_BYTES);
    section_append("picture.1", written->pictures[1], RACE_PICTURE_BYTES);
    return file_judge();
}

Test(race, the_figure_is_the_ratio_of_the_medians)
{
    Written *written = written_make();
    cr_expect_eq(written_judge(written), 12);
    // A round in which the machine did something else counts for nothing.
    written->times.ms[RACE_REFERENCE][0] = 900;
    written->times.ms[RACE_OWN][RACE_ROUNDS - 1] = 0.001;
    cr_expect_eq(written_judge(written), 12);
    for (int i = 0; i < RACE_ROUNDS; i++) {
        written->times.ms[RACE_OWN][i] = 70;
    }
    cr_expect_eq(written_judge(written), 0.9, "60 / 70 has one decimal");
    free(written);
}

Test(race, what_is_no_time_makes_no_figure)
{
    static const double no_times[] = {0, -5, -0.0, INFINITY, -INFINITY, NAN, -NAN};
    for (size_t i = 0; i < sizeof no_times / sizeof *no_times; i++) {
        for (Racer racer = 0; racer < N_RACERS; racer++) {
            Written *written = written_make();
            written->times.ms[racer][2] = no_times[i];
            cr_expect_eq(written_judge(written), 0, "%g was taken", no_times[i]);
            free(written);
        }
    }
}

Test(race, a_figure_outside_its_limits_is_none)
{
    static const struct {
        double reference, own, figure;
    } cases[] = {
        {1000, 1, 1000}, {1001, 1, 0},       {1e300, 1, 0},    {1e308, 1e-308, 0},  {1, 10, 0.1},
        {1, 30, 0},      {1e-308, 1e308, 0}, {1, INFINITY, 0}, {5e-324, 5e-324, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Written *written = written_make();
        for (int round = 0; round < RACE_ROUNDS; round++) {
            written->times.ms[RACE_REFERENCE][round] = cases[i].reference;
            written->times.ms[RACE_OWN][round] = cases[i].own;
        }
        const double found = written_judge(written);
        cr_expect_eq(found, cases[i].figure, "%g over %g: found %g, expected %g",
                     cases[i].reference, cases[i].own, found, cases[i].figure);
        cr_expect(found == 0 || race_is_figure(found));
        free(written);
    }
    cr_expect_not(race_is_figure(0));
    cr_expect_not(race_is_figure(NAN));
    cr_expect_not(race_is_figure(-INFINITY));
}

// Rounding may move a channel by a step of 255, and decide what a few rays hit.
Test(race, pictures_that_differ_make_no_figure)
{
    enum { MOST = RACE_SIDE * RACE_SIDE / 10000 };
    Written *written = written_make();
    unsigned char *own = written->pictures[RACE_OWN];
    for (size_t i = 0; i < RACE_PICTURE_BYTES; i++) {
        own[i]++;
    }
    cr_expect_eq(written_judge(written), 12, "a step more");
    // The last channel of as many pixels as may differ, and of one more.
    for (size_t i = 0; i < MOST; i++) {
        own[4000 * i + 3] += 100;
    }
    cr_expect_eq(written_judge(written), 12, "%d pixels", MOST);
    own[4000 * MOST + 3] += 100;
    cr_expect_eq(written_judge(written), 0, "one pixel more");
    free(written);
}

Test(race, what_is_missing_or_there_twice_makes_no_figure)
{
    Written *written = written_make();
    cr_expect_eq(file_judge(), 0, "no file");
    section_append("times", &written->times, sizeof written->times);
    section_append("picture.0", written->pictures[0], RACE_PICTURE_BYTES);
    cr_expect_eq(file_judge(), 0, "no picture of the submission's");
    section_append("times", &written->times, sizeof written->times);
    cr_expect_eq(written_judge(written), 0, "times twice");
    section_append("times", &written->times, sizeof written->times - sizeof(double));
    section_append("picture.0", written->pictures[0], RACE_PICTURE_BYTES);
    section_append("picture.1", written->pictures[1], RACE_PICTURE_BYTES);
    cr_expect_eq(file_judge(), 0, "a time too few");
    free(written);
}

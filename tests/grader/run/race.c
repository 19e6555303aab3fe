// From the times of a race to its figure (see race.h).
#include "race.h"

#include "race_answers.h"
#include "stats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// How many pixels of the two pictures may differ: where a ray grazes a sphere, or meets two at one
// distance, the last place decides what is hit. One pixel in 250 000 is the most that was seen of
// these kernels (tests/bench/same_pictures.h).
enum { N_PIXELS = RACE_SIDE * RACE_SIDE, MAX_AMBIGUOUS = N_PIXELS / 10000 };

// A colour that rounding has put on the other side of a whole step is equal.
enum { MAX_STEPS = 1 };

int race_is_figure(double figure)
{
    return isfinite(figure) && figure >= RACE_LEAST && figure <= RACE_MOST;
}

// 0 where a time is none.
static double median_of(const double ms[RACE_ROUNDS])
{
    double sorted[RACE_ROUNDS];
    for (int i = 0; i < RACE_ROUNDS; i++) {
        if (!isfinite(ms[i]) || ms[i] <= 0) {
            return 0;
        }
        sorted[i] = ms[i];
    }
    return stats_median(sorted, RACE_ROUNDS);
}

static int pictures_are_equal(const unsigned char *picture, const unsigned char *other)
{
    int n_different = 0;
    for (size_t i = 0; i < N_PIXELS; i++) {
        int is_different = 0;
        for (size_t at = 4 * i; at < 4 * i + 4; at++) {
            is_different |= abs(picture[at] - other[at]) > MAX_STEPS;
        }
        n_different += is_different;
    }
    return n_different <= MAX_AMBIGUOUS;
}

double race_judge(const Sections *answers)
{
    const RaceTimes *times = sections_find(answers, "times", sizeof *times);
    const void *reference = sections_find(answers, "picture.0", RACE_PICTURE_BYTES);
    const void *own = sections_find(answers, "picture.1", RACE_PICTURE_BYTES);
    if (times == NULL || reference == NULL || own == NULL || !pictures_are_equal(reference, own)) {
        return 0;
    }
    // 0 over 0 and what is not finite is no figure either.
    const double ratio = median_of(times->ms[RACE_REFERENCE]) / median_of(times->ms[RACE_OWN]);
    const double figure = round(10 * ratio) / 10;
    return race_is_figure(figure) ? figure : 0;
}

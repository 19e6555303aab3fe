// Holding a guess against the student's picture (see picture_looks.h).
#include "picture_looks.h"

#include <math.h>

// A mistake is named when its picture agrees with the student's in this share of the pixels. The
// rest may be rims: pixels that a shift brings in from outside, or rounding of a half pixel.
#define RECOGNISED_SHARE 0.995

// And it must explain at least this share of what is wrong: most of a sparse picture is background.
#define EXPLAINED_SHARE 0.9

// From fewer wrong pixels than these nothing is concluded: too many mistakes would explain them.
#define MIN_WRONG 6

void tally_add(Tally *tally, PixelPair pixel, const float *guess, float guess_tolerance)
{
    if (isinf(guess_tolerance) || isinf(pixel.tolerance)) {
        return;
    }
    const int agrees = is_same_color(pixel.own, guess, guess_tolerance);
    const int wrong = !is_same_color(pixel.own, pixel.wanted, pixel.tolerance);
    tally->misses_first |= wrong && tally->n_wrong == 0 && !agrees;
    tally->n_compared++;
    tally->n_agree += (size_t)agrees;
    tally->n_wrong += (size_t)wrong;
    tally->n_explained += (size_t)(wrong && agrees);
}

int tally_recognises(const Tally *tally)
{
    return tally->n_wrong >= MIN_WRONG && !tally->misses_first &&
           (double)tally->n_agree >= RECOGNISED_SHARE * (double)tally->n_compared &&
           (double)tally->n_explained >= EXPLAINED_SHARE * (double)tally->n_wrong;
}

// How a guess, the picture that a known mistake would draw, fares against the student's picture.
//
// Used by picture_looks.c and picture_distortion.c: both make guesses, and these are the rules by
// which one is believed.
#ifndef GRADER_PICTURE_TALLY_H
#define GRADER_PICTURE_TALLY_H

#include <stddef.h>

typedef struct Tally {
    size_t n_compared;   // pixels the guess says anything about
    size_t n_agree;      // of those, equal to the student's
    size_t n_wrong;      // of those, where the student differs from the reference
    size_t n_explained;  // of those, equal to the student's
} Tally;

// Add a pixel. One about which the reference or the guess says nothing, its tolerance INFINITY, is
// left out.
void tally_add(Tally *tally, const float *own, const float *guess, float guess_tolerance,
               const float *reference, float tolerance);

// Does the guess explain what is wrong, and agree with the rest?
int tally_recognises(const Tally *tally);

#endif

// Recognising common mistakes in a wrong picture.
//
// Recognising works by trying: each known mistake is made on purpose, to the reference (flips,
// swaps, shifts, gamma: picture_distortion.c) or by the scene's oracle (strict boundary, half a
// pixel), and the one whose picture equals the student's is named. Nothing is guessed from
// statistics. By which rules a guess is believed stands in picture_tally.c.
#ifndef JUDGE_PICTURE_LOOKS_H
#define JUDGE_PICTURE_LOOKS_H

#include "picture.h"
#include "words.h"

// What a wrong picture looks like that may have many causes, "of one colour everywhere", or NULL.
const char *picture_plain(ProbeImage own, const ExpectedPicture *expected);

// Is every pixel background, though not every pixel should be? Many a mistake leaves that.
int picture_is_empty(ProbeImage own, const ExpectedPicture *expected);

// What was found in a wrong picture, and the mistake that it looks like, "it looks shifted by one
// pixel up". Takes `found` over; the diagnosis is owned by the caller.
Diagnosis picture_looks(ProbeImage own, const ExpectedPicture *expected, char *found);

// The mistake alone: a sentence that is always the same, or nothing.
Cause picture_known(ProbeImage own, const ExpectedPicture *expected);

// The scene's own mistake that it looks like.
Cause picture_mistaken(ProbeImage own, const ExpectedPicture *expected);

// May a wrong picture be of this known mistake? It may where the scene knows none such.
int picture_may_look(ProbeImage own, const ExpectedPicture *expected, const char *rule);

// The same of mistakes that are made to a whole picture, "shifted by one pixel up".
Cause picture_distortion(ProbeImage own, const ExpectedPicture *expected);

// Where all is wrong that is, "right but for blue", "right but for the last column"; "" where that
// cannot be said in a word.
Words picture_place(ProbeImage own, const ExpectedPicture *expected);

// The same of pixels that nobody wrote: "cut off: the last column is missing".
Words picture_cut(ProbeImage own, const ExpectedPicture *expected);

// Do unwritten pixels begin at a column that is the height, or at a row that is the width? A
// work-item draws no pixel beyond them where x and y are swapped.
int picture_is_swapped(ProbeImage own, const ExpectedPicture *expected);

// How a guess, the picture that a known mistake would draw, fares against the student's picture.
typedef struct Tally {
    size_t n_compared;   // pixels the guess says anything about
    size_t n_agree;      // of those, equal to the student's
    size_t n_wrong;      // of those, where the student differs from the reference
    size_t n_explained;  // of those, equal to the student's
    int misses_first;    // the first of them, which the message shows, is none of those
} Tally;

// Add a pixel. One about which the reference or the guess says nothing, its tolerance INFINITY, is
// left out.
void tally_add(Tally *tally, PixelPair pixel, const float *guess, float guess_tolerance);

// Does the guess explain what is wrong, and agree with the rest?
int tally_recognises(const Tally *tally);

#endif

// Recognising common mistakes in a wrong picture.
//
// Recognising works by trying: each known mistake is made on purpose, to the reference (flips,
// swaps, shifts) or by the scene's oracle (strict boundary, half a pixel), and the one whose
// picture equals the student's is named. Nothing is guessed from statistics.
#ifndef GRADER_PICTURE_LOOKS_H
#define GRADER_PICTURE_LOOKS_H

#include "picture.h"

// What a wrong picture looks like that may have many causes, "of one colour everywhere", or NULL.
const char *picture_plain(ProbeImage own, const ExpectedPicture *expected);

// The mistake that a wrong picture looks like, "shifted by one pixel up", or NULL. Owned by the
// caller.
char *picture_looks(ProbeImage own, const ExpectedPicture *expected);

#endif

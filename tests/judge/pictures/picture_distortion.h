// Recognising mistakes that are made to a whole picture: flips, shifts, swapped channels, gamma.
//
// Flow: wrong picture -> DISTORTIONS, then the scene's own mistakes -> sentence. Each is tried on
// the reference. Read next: picture_looks.h.
#ifndef GRADER_PICTURE_DISTORTION_H
#define GRADER_PICTURE_DISTORTION_H

#include "picture.h"

// The distortion that a wrong picture looks like, "shifted by one pixel up", or NULL.
const char *picture_distortion(ProbeImage own, const ExpectedPicture *expected);

#endif

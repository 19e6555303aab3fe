// Pictures of an answer that is tried alone: drawn with stand-ins (tests/stand_ins/), so that what
// should come out is worked out here, pixel by pixel, and only whether it did is ever shown.
#ifndef JUDGE_ALONE_PICTURE_H
#define JUDGE_ALONE_PICTURE_H

#include "sections.h"

// The colour that pixel (x, y) should have.
typedef void ColorAt(const void *scene, int x, int y, float color[4]);

// Is the probe's answer "picture.K" there, with every pixel of width x height in its colour? Each
// channel may be off by `tolerance`.
int alone_picture_is_right(const Sections *answers, int k, int width, int height, float tolerance,
                           ColorAt *color_at, const void *scene);

// Is it there, with every pixel written and nothing outside of width x height?
int alone_picture_keeps_inside(const Sections *answers, int k, int width, int height);

#endif

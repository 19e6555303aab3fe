// Pictures of an answer that is tried alone: drawn with stubs (tests/stubs/), so that what
// should come out is worked out here, pixel by pixel. Whether it did is shown, and which known
// mistake it looks like, never a pixel.
#ifndef JUDGE_ALONE_PICTURE_H
#define JUDGE_ALONE_PICTURE_H

#include "picture.h"
#include "sections.h"

// The colour that pixel (x, y) should have.
typedef void ColorAt(const void *scene, int x, int y, float color[4]);

// Is the probe's answer "picture.K" there, with every pixel of width x height in its colour? Each
// channel may be off by `tolerance`.
int alone_picture_is_right(const Sections *answers, int k, int width, int height, float tolerance,
                           ColorAt *color_at, const void *scene);

// Fill in what picture number k should be, with the known mistakes. Returns 0, or -1 without
// memory; to be freed in either case.
typedef int ExpectAlone(const void *job, int k, ExpectedPicture *expected);

// What the wrong ones of n pictures from number `first` on look like: distorted, or drawn with a
// known mistake. Nothing where one of them looks like none, or two like different ones.
Cause alone_pictures_look(const void *job, int first, int n, ExpectAlone *expect,
                          const Sections *answers);

// The picture of these colours as a reference. Returns 0, or -1 without memory.
int alone_picture_expect(int width, int height, float tolerance, ColorAt *color_at,
                         const void *scene, ExpectedPicture *expected);

// Is it there, with every pixel written and nothing outside of width x height?
int alone_picture_keeps_inside(const Sections *answers, int k, int width, int height);

#endif

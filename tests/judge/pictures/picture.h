// Judging a picture: is it right, and where is it wrong? What a wrong one looks like is found out
// by picture_looks.h.
#ifndef JUDGE_PICTURE_H
#define JUDGE_PICTURE_H

#include "diagnosis.h"
#include "image.h"
#include "sections.h"

// Draw a scene with known mistake number `mistake`, from 0 on, so that a student's picture can be
// recognised.
//   scene        what ExpectedPicture.scene points at
//   guess        out: the picture; of the reference's size
//   tolerances   out: [height * width], as in ExpectedPicture; all 0 at the start
// Returns what such a picture looks like ("drawn as if ..."); nothing behind the last mistake.
typedef Cause DrawMistaken(const void *scene, int mistake, Image *guess, float *tolerances);

// The pictures of a scene's known mistakes. Each is drawn when a wrong picture is first compared
// with it, and kept: a judge sees many wrong pictures of one scene.
typedef struct MistakenPictures MistakenPictures;

// What a picture should be.
typedef struct ExpectedPicture {
    Image reference;    // owned
    float *tolerances;  // [height * width], how far a pixel's channels may be off; INFINITY where a
                        // pixel may have any colour; owned. NULL: `tolerance` everywhere
    float tolerance;    // 0 for bit-equal pictures
    float background[IMAGE_CHANNELS];  // the colour where nothing is drawn
    const void *scene;                 // what it shows, where mistakes are known
    MistakenPictures *mistaken;        // of it; owned; NULL when none are known
} ExpectedPicture;

// Let known mistakes be recognised in pictures of the scene, which must stay as it is. None are if
// `draw` is NULL, or without memory.
void expected_picture_recognise(ExpectedPicture *expected, DrawMistaken *draw, const void *scene);

void expected_picture_free(ExpectedPicture *expected);

// A probe's image: the picture in the upper left corner of [image_height][image_width][4] floats
// that were UNWRITTEN before.
typedef struct ProbeImage {
    const float *pixels;
    int image_width;
    int image_height;
} ProbeImage;

// The probe's answer "picture.K", of a picture of width x height; pixels NULL when it is missing.
ProbeImage probe_image_find(const Sections *answers, int k, int width, int height);

// Compare a picture with what it should be.
// Returns NOTHING_WRONG when it is right, else the first wrong pixel with both values, how many are
// wrong, and what the picture looks like. Owned by the caller, here and below.
Diagnosis picture_judge(ProbeImage own, const ExpectedPicture *expected);

// Is it right? The same without a diagnosis, and quicker when it is not.
int picture_is_right(ProbeImage own, const ExpectedPicture *expected);

// Was anything written outside the picture?
Diagnosis picture_judge_padding(ProbeImage own, const ExpectedPicture *expected);

// Is there any pixel nobody wrote?
Diagnosis picture_judge_written(ProbeImage own, const ExpectedPicture *expected);

// Copy the picture out of a probe's image. Returns 0, or -1 after one message.
int picture_copy(ProbeImage own, int width, int height, Image *picture);

// ---- Pixel by pixel ---------------------------------------------------------------------------

// The four channels of a pixel.
const float *probe_image_pixel(ProbeImage own, int x, int y);
const float *image_pixel(const Image *image, int x, int y);

// A pixel of a picture and what it should be.
typedef struct PixelPair {
    int x, y;
    const float *own, *wanted;
    float tolerance;  // how far its channels may be off
} PixelPair;

// Pixel number i of n, row by row.
PixelPair pixel_pair(ProbeImage own, const ExpectedPicture *expected, int i);
int expected_n_pixels(const ExpectedPicture *expected);

// Equal within the tolerance; a NaN equals nothing.
int is_same_color(const float *a, const float *b, float tolerance);

#endif

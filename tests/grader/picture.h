// Judging a picture: is it right, where is it wrong, and what does the wrong one look like?
#ifndef GRADER_PICTURE_H
#define GRADER_PICTURE_H

#include "circle.h"
#include "image.h"

// What a picture should be.
typedef struct ExpectedPicture {
    Image reference;           // owned
    unsigned char *ambiguous;  // [height * width], pixels that may differ; owned, or NULL
    float tolerance;           // of a channel, elsewhere; 0 for bit-equal pictures
    const Circle *circles;     // the scene, for recognising mistakes; NULL when there is none
    int n_circles;
} ExpectedPicture;

void expected_picture_free(ExpectedPicture *expected);

// A probe's image: the picture in the upper left corner of [image_height][image_width][4] floats
// that were UNWRITTEN before.
typedef struct ProbeImage {
    const float *pixels;
    int image_width;
    int image_height;
} ProbeImage;

// Compare a picture with what it should be.
// Returns NULL when it is right, else the message for the student: the first wrong pixel with both
// values, how many are wrong, and what the picture looks like. Owned by the caller.
char *picture_judge(ProbeImage own, const ExpectedPicture *expected);

// Was anything written outside the picture of width x height? Returns NULL or the message.
char *picture_judge_padding(ProbeImage own, int width, int height);

// Is there any pixel nobody wrote? Returns NULL or the message.
char *picture_judge_written(ProbeImage own, int width, int height);

// Copy the picture out of a probe's image for the report. Returns 0, or -1 after one message.
int picture_copy(ProbeImage own, int width, int height, Image *picture);

#endif

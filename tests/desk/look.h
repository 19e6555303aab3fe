// The lab's open scene, drawn with the student's program: is the picture the lecture's figure?
//
// A lab's manifest says how its program draws the scene (`look`) and which figure a right answer
// draws then. The pictures are in build/watch: picture.png, expected.png, difference.png. What is
// drawn now is drawn.png until it is whole: a save that draws nothing leaves the picture before it.
#ifndef DESK_LOOK_H
#define DESK_LOOK_H

#include "child.h"
#include "desk.h"
#include "image.h"

#include <limits.h>

// A picture takes up to two seconds of processor time, however busy the machine is; a student's
// loop may have no end, and one that waits uses none.
#define LOOK_MOST_SECONDS 6
#define LOOK_MOST_WAIT_SECONDS 60

typedef struct Look {
    const Desk *desk;
    char folder[PATH_MAX], drawn[PATH_MAX], picture[PATH_MAX];
    Image figure;                // no pixels where there is none to hold the picture against
    int has_picture, is_older;   // is there one, and is it of a save before?
    int is_compared;             // the picture, with the figure
    ImageDifference difference;  // of the two; 0 pixels where they differ by rounding only
} Look;

// Make the folder and load the figure. Release with look_close().
void look_open(const Desk *desk, Look *look);
void look_close(Look *look);

// The options that the picture is drawn with.
const char *look_options(const Look *look);

// Start building the program, and drawing with it. Each returns as child_start() does.
//   changed   files of the lab's folder that make shall take for newer than what was made of them,
//             whatever their times say, NULL-terminated; or NULL
int look_start_building(const Look *look, const char *const *changed, Child *child);
int look_start_drawing(const Look *look, Child *child);

// Why a drawing that still runs is to be ended, or NULL.
const char *look_is_late(const Child *child);

// The program has ended well: is there a picture? Then it takes the place of the one before. Hold
// it against the figure, and save what they differ in. With options of the student's own there is
// nothing to hold it against.
void look_compare(Look *look);

// Can a pixel of this lab be followed, by make pixel?
int look_can_be_followed(const Desk *desk);

// The command that follows the first wrong pixel, to copy; NULL where there is none, or the lab has
// nothing to follow. Owned by the caller.
char *look_command(const Look *look);

#endif

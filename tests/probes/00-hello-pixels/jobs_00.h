// The sections of lab 00's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_00_H
#define PROBES_JOBS_00_H

#include "jobs.h"

// A scene is a size, and "scene.K.pattern" the key, a u32, of what is in the image that
// read_back is given (pattern.h). Besides "picture.K" the answers are "arguments.K", an
// ArgumentsAnswer, "items.K", the number of work-items at each place of the image, [image
// height][image width], and N_ITEMS_REST numbers behind them, and "readback.K", [height][width][4]
// and N_READ_BACK_REST floats behind them: READ_BACK_GUARD, which must stay UNWRITTEN, and one that
// is not 0 where more arrived after read_back had returned.
enum { READ_BACK_GUARD = 4, READ_BACK_LATE = READ_BACK_GUARD, N_READ_BACK_REST };
typedef struct ArgumentsAnswer {
    i32 error;       // of launching a kernel with what set_arguments handed over: an OpenCL status
    f32 arrived[4];  // what that kernel wrote: width, height, 0, 1; UNWRITTEN where it did not
} ArgumentsAnswer;
LAYOUT_ASSERT(ArgumentsAnswer, 20);

enum {
    ITEMS_FAR,              // work-items that stand outside of the image
    ITEMS_IN_OTHER_GROUPS,  // those in work-groups that are not 16 x 16
    ITEMS_GROUP_WIDTH,      // the size of one of these
    ITEMS_GROUP_HEIGHT,
    N_ITEMS_REST,
};

#endif

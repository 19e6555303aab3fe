// What lab 00's judge asks of a submission: pictures of several sizes, each with a pattern for
// read_back. Rolled in judge_00.c, the host's functions judged in judge_00_host.c and
// judge_00_launch.c.
#ifndef JUDGE_JUDGE_00_H
#define JUDGE_JUDGE_00_H

#include "judge.h"
#include "layout.h"

// Multiples of the work-group and not, higher than wide, a single pixel; the last two from the
// seed.
enum { N_SIZES = 8 };

typedef struct Job00 {
    Job job;
    JobPicture gradients[N_SIZES];
    u32 keys[N_SIZES];                  // of the patterns (probes/pattern.h)
    ExpectedPicture patterns[N_SIZES];  // what is in the images that read_back is given
} Job00;

// How many work-items it takes for a side of the picture: whole groups, of GROUP_SIZE in render.h.
enum { GROUP_SIDE = 16 };
static inline int side_in_groups(int side)
{
    return (side + GROUP_SIDE - 1) / GROUP_SIDE * GROUP_SIDE;
}

// Judge of size K what set_arguments handed over, which work-items enqueue_pixels started, and what
// read_back brought home. As `scene` of judge.h has it.
Verdict judge_00_arguments(const void *job, int k, const Sections *answers);
Verdict judge_00_items(const void *job, int k, const Sections *answers);
Verdict judge_00_read_back(const void *job, int k, const Sections *answers);

#endif

// What lab 00's judge asks of a submission: pictures of several sizes, each with a pattern for
// read_back. Drawn and judged in judge_00.c, the host's functions in judge_00_host.c.
#ifndef GRADER_JUDGE_00_H
#define GRADER_JUDGE_00_H

#include "job_picture.h"
#include "judge.h"
#include "layout.h"

// Multiples of the work-group and not, higher than wide, a single pixel; the last two from the
// seed.
enum { N_SIZES = 7 };

typedef struct Job00 {
    JobPicture gradients[N_SIZES];
    JobPicture *pictures[N_SIZES];      // the gradients
    u32 keys[N_SIZES];                  // of the patterns (probes/pattern.h)
    ExpectedPicture patterns[N_SIZES];  // what is in the images that read_back is given
} Job00;

// Judge what set_arguments handed over, which work-items enqueue_pixels started, and what read_back
// brought home. Each needs no other task.
Verdict judge_00_arguments(const Job00 *job, const Sections *answers);
Verdict judge_00_items(const Job00 *job, const Sections *answers);
Verdict judge_00_read_back(const Job00 *job, const Sections *answers);

#endif

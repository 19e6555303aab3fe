// The work that kernels count: the answers "work.K", a Work for each pixel of a picture.
#ifndef JUDGE_JOB_WORK_H
#define JUDGE_JOB_WORK_H

#include "job_picture.h"
#include "words.h"
#include "work.h"

// The counted work of scene K, whose picture this is: [height * width] and room behind them, NULL
// when it is missing.
const Work *job_work_find(const JobPicture *picture, int k, const Sections *answers);

// Is none of the numbers larger?
int work_is_at_most(Work work, Work most);

// "3 nodes and 1 leaf visited, 17 spheres asked and 2 waiting at once".
Words work_words(Work work);

#endif

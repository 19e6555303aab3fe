// The work that kernels count: the answers "work.K", a Work for each pixel of a picture.
#ifndef JUDGE_JOB_WORK_H
#define JUDGE_JOB_WORK_H

#include "job_picture.h"
#include "work.h"

// The counted work of scene K, whose picture this is: passed where it is there; missing where the
// picture is, too; else the student's doing.
//   calls, where   what must be called where so that it can be counted, in words
//   found          out: [height * width] and room behind them, NULL when it is not there
Verdict job_work_find(const JobPicture *picture, int k, const char *calls, const char *where,
                      const Sections *answers, const Work **found);

#endif

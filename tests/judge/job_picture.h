// A picture of a job: what the probe draws as "picture.K", and what should come out.
//
// A job lists its pictures in the order of their numbers: pictures[k] is answered by "picture.K".
// What they show is another matter: job_scene.h for circles, job_scene3d.h for spheres, or nothing.
#ifndef GRADER_JOB_PICTURE_H
#define GRADER_JOB_PICTURE_H

#include "judge.h"
#include "picture.h"

typedef struct JobPicture {
    char title[96];  // "random scene"
    ExpectedPicture expected;
} JobPicture;

// The probe's answer "picture.K", pixels NULL when it is missing.
ProbeImage job_picture_answer(const JobPicture *picture, int k, const Sections *answers);

// Judge the probe's pictures first to first + n - 1: the first wrong one decides.
Verdict job_pictures_judge(JobPicture *const pictures[], int first, int n, const Sections *answers);

// Judge that nothing was written outside n pictures, and everything inside.
Verdict job_pictures_judge_padding(JobPicture *const pictures[], int n, const Sections *answers);

// Compare with the solution's pictures from now on.
void job_pictures_adopt(JobPicture *const pictures[], int n, const Sections *answers);

// Add some of n pictures to the report, the wrong ones first.
void job_pictures_report(JobPicture *const pictures[], int n, const Sections *answers,
                         Result *result);

#endif

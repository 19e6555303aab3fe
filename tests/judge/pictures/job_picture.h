// A picture of a job: what the probe draws as "picture.K", and what should come out.
//
// What it shows is another matter: job_scene.h for circles, job_scene3d.h for spheres, or nothing.
#ifndef JUDGE_JOB_PICTURE_H
#define JUDGE_JOB_PICTURE_H

#include "picture.h"
#include "result.h"
#include "sections.h"
#include "verdicts.h"

typedef struct JobPicture {
    char title[96];  // "random scene"
    ExpectedPicture expected;
} JobPicture;

// The probe's answer "picture.K", pixels NULL when it is missing.
ProbeImage job_picture_answer(const JobPicture *picture, int k, const Sections *answers);

// Is it right?
Verdict job_picture_judge(const JobPicture *picture, int k, const Sections *answers);

// Is nothing written outside of it, and everything inside?
Verdict job_picture_judge_padding(const JobPicture *picture, int k, const Sections *answers);

// Compare with the solution's picture from now on.
void job_picture_adopt(JobPicture *picture, int k, const Sections *answers);

// Add some of n pictures to the report, the wrong ones first.
//   first, step   each lies `step` bytes behind the one before
void job_pictures_report(const JobPicture *first, size_t step, int n, const Sections *answers,
                         Result *result);

#endif

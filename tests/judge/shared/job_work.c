// Finding counted work (see job_work.h).
#include "job_work.h"

#include "job_sections.h"
#include "jobs.h"

const Work *job_work_find(const JobPicture *picture, int k, const Sections *answers)
{
    const Image *reference = &picture->expected.reference;
    const size_t n_pixels =
        (size_t)PROBE_IMAGE_SIDE(reference->width) * (size_t)PROBE_IMAGE_SIDE(reference->height);
    return job_section_find(answers, "work", k, n_pixels * sizeof(Work));
}

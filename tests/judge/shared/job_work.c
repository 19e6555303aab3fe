// Finding counted work (see job_work.h).
#include "job_work.h"

#include "job_sections.h"
#include "jobs.h"
#include "message.h"

Verdict job_work_find(const JobPicture *picture, int k, const char *calls, const char *where,
                      const Sections *answers, const Work **found)
{
    const Image *reference = &picture->expected.reference;
    const size_t n_pixels =
        (size_t)PROBE_IMAGE_SIDE(reference->width) * (size_t)PROBE_IMAGE_SIDE(reference->height);
    *found = job_section_find(answers, "work", k, n_pixels * sizeof **found);
    if (*found != NULL) {
        return verdict_of(NULL);
    }
    return job_picture_answer(picture, k, answers).pixels == NULL
               ? verdict_missing
               : verdict_of(message_new("the work could not be counted; call %s in %s itself",
                                        calls, where));
}

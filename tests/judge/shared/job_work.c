// Counted work (see job_work.h).
#include "job_work.h"

#include "job_sections.h"
#include "jobs.h"
#include "message.h"

const Work *job_work_find(const JobPicture *picture, int k, const Sections *answers)
{
    const Image *reference = &picture->expected.reference;
    const size_t n_pixels =
        (size_t)PROBE_IMAGE_SIDE(reference->width) * (size_t)PROBE_IMAGE_SIDE(reference->height);
    return job_section_find(answers, "work", k, n_pixels * sizeof(Work));
}

int work_is_at_most(Work work, Work most)
{
    return work.n_tests <= most.n_tests && work.n_nodes_visited <= most.n_nodes_visited &&
           work.n_leaves_visited <= most.n_leaves_visited && work.stack_depth <= most.stack_depth;
}

Words work_words(Work work)
{
    return words("%u node%s and %u %s visited, %u sphere%s asked and %u waiting at once",
                 work.n_nodes_visited, plural(work.n_nodes_visited), work.n_leaves_visited,
                 work.n_leaves_visited == 1 ? "leaf" : "leaves", work.n_tests, plural(work.n_tests),
                 work.stack_depth);
}
